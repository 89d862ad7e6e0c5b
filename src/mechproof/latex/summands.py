"""Sums in brackets after letters: factors as opposed to arguments of functions."""

from __future__ import annotations

from collections.abc import Collection, Iterable

import sympy as sp

from mechproof.latex import tree
from mechproof.record import NUMBER, Dimension, Notation
from mechproof.record.parts import ANGLES

TIME = Dimension(time=1)
_VALUES = (tree.Constant, tree.Degrees, tree.Measure, tree.Letter)


def is_no_argument(bracket: tree.Add, notation: Notation, *, moves: bool) -> bool:
    """Return whether a sum multiplies the letter before it, as nobody prints such an argument.

    Either a term has a function, or a root that shifts no angle and no time; or all terms are
    lengths and the like, or numbers with a literal one among them. A sum that shifts a letter that
    counts may be an argument, as may one that shifts a time if the letter before the bracket
    `moves`.
    """
    terms = [[*tree.walk(term, tree.Call)] for _, term in bracket.terms]
    bare = [term for term in terms if not _has_function(term)]
    letters = set().union(*map(_list_letters, bare))
    known = notation.dimensions
    running = {by for by, _ in notation.moving.values()}
    if len(terms) < 2 or any(symbol.is_integer for symbol in letters):
        return False
    if len(bare) < len(terms):
        return not (moves and any(known.get(symbol) == TIME for symbol in letters))
    if not letters or running & letters:
        return False
    if roots := [n for term in terms for n in term if isinstance(n, tree.Radical)]:
        is_fixed = not any(_list_letters(tree.walk(root, tree.Call)) for root in roots)
        return not any(_may_shift(known.get(s), angles=is_fixed) for s in letters)
    has_number = any(_is_literal(term) for term in terms)
    return all(_is_literal(t) or _is_amount(t, notation, beside=has_number) for t in terms)


def _may_shift(dimension: Dimension | None, *, angles: bool = True) -> bool:
    """Return whether a dimension is that of a time, or of an angle if `angles` is set."""
    return dimension is not None and ((angles and dimension.is_angle) or dimension == TIME)


def _is_literal(term: Collection[tree.Node]) -> bool:
    return not any(isinstance(n, _VALUES) for n in term)


def _is_amount(term: Collection[tree.Node], notation: Notation, *, beside: bool) -> bool:
    """Return whether the unit of a term rules out an argument.

    A pure number does so only `beside` a literal number.
    """
    units = [notation.dimensions.get(symbol) for symbol in _list_letters(term)]
    if any(unit not in (None, NUMBER, TIME) for unit in units):
        return True
    return beside and bool(units) and all(u == NUMBER and not _may_shift(u) for u in units)


def _list_letters(term: Iterable[tree.Node]) -> set[sp.Basic]:
    return {n.symbol for n in term if isinstance(n, tree.Letter)}


def _has_function(term: Collection[tree.Node]) -> bool:
    """Return whether a term has a function whose value is not an angle, or an exponential."""
    return any(
        n.function.make not in ANGLES
        if isinstance(n, tree.Call)
        else isinstance(n, tree.Power) and bool(_list_letters(tree.walk(n.exponent, tree.Call)))
        for n in term
    )
