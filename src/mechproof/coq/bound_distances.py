"""Polynomials in their letters' distances from bounds, whose coefficients show a sign.

Between two bounds these are the coefficients of Bernstein (1912), except for binomial factors. As
certificates of positivity such sums of products are those of Handelman (1988), who allows any
degree; here it is the polynomial's own.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import sympy as sp

from mechproof.record.parts import find_free, find_parts

_BELOW, _ABOVE = (sp.Gt, sp.Ge), (sp.Lt, sp.Le)
# Work limit: terms of a rewritten polynomial.
_MOST = 60


@dataclass(frozen=True)
class LetterBounds:
    """The lower and the upper bound of a letter, each None if not known."""

    low: sp.Expr | None = None
    high: sp.Expr | None = None


Box = Mapping[sp.Basic, LetterBounds]
NO_BOX: Box = MappingProxyType({})


def find_box(relations: Iterable[sp.Basic]) -> Box:
    """Find the bounds of letters: numbers, or expressions in letters bounded independently."""
    found: dict[sp.Basic, LetterBounds] = {}
    for relation in relations:
        if relation.func not in (*_BELOW, *_ABOVE):
            continue
        small, large = relation.args if relation.func in _ABOVE else relation.args[::-1]
        if small.is_Rational and not large.is_number:
            known = found.get(large, LetterBounds())
            found[large] = LetterBounds(small if known.low is None else known.low, known.high)
        elif large.is_Rational and not small.is_number:
            known = found.get(small, LetterBounds())
            found[small] = LetterBounds(known.low, large if known.high is None else known.high)
        elif large.is_Symbol and _rests_free(small, large, found):
            found[large] = LetterBounds(small)
    return found


def _rests_free(small: sp.Basic, large: sp.Basic, found: Box) -> bool:
    """Return whether a letter can have an expression of others as its lower bound."""
    has_none = large not in found or (small in found and found[large].high is None)
    return has_none and large not in _list_below(small, found)


def _list_below(part: sp.Basic, found: Box) -> set[sp.Basic]:
    """List the letters of a part and those on which their lower bounds depend."""
    letters = set(find_free(part))
    lows = [found[s].low for s in letters if s in found]
    return letters.union(*(_list_below(low, found) for low in lows if low is not None))


def spread_out(expression: sp.Expr, box: Box) -> sp.Expr | None:
    """Write a polynomial as a sum of products of distances from bounds, without minus signs.

    Returns None if minus signs remain, or the expression is not a polynomial.
    """
    roots = list_roots(expression)
    hidden = {root: sp.Dummy() for root in roots}
    value: sp.Expr | None = expression.xreplace(hidden)
    back: dict[sp.Basic, sp.Expr] = {}
    # Letters on which no other bound rests come first.
    for letter in sorted(box, key=lambda s: (-len(_list_below(s, box)), str(s))):
        if value is None or not value.has(letter):
            continue
        low, high = box[letter].low, box[letter].high
        above, under = sp.Dummy(), sp.Dummy()
        if low is not None:
            back[above] = letter if low == 0 else sp.Add(letter, -low, evaluate=False)
        if high is not None:
            back[under] = sp.Add(high, -letter, evaluate=False)
        value = _spread(value, letter, box[letter], above, under)
    back |= {letter: root for root, letter in hidden.items()}
    if value is None or not back or not value.is_polynomial(*back):
        return None
    terms = sp.Poly(value, *back).terms()
    if len(terms) > _MOST or any(not c.is_Rational or c < 0 for _, c in terms):
        return None
    distances = [
        sp.Mul(c, *(back[s] ** k for s, k in zip(back, powers, strict=True) if k))
        for powers, c in terms
    ]
    return sp.Add(*distances, evaluate=False)


def list_roots(expression: sp.Expr) -> list[sp.Pow]:
    """List the square roots of an expression, or none if one lies under another."""
    found = {p for p in find_parts(expression, sp.Pow) if p.exp == sp.S.Half}
    is_flat = not any(find_parts(root.base, sp.Pow) & found for root in found)
    return sorted(found, key=sp.default_sort_key) if is_flat else []


def _spread(
    value: sp.Expr, letter: sp.Basic, bounds: LetterBounds, above: sp.Expr, under: sp.Expr
) -> sp.Expr | None:
    """Write one letter by its distances from its bounds, with all products of equal degree."""
    low, high = bounds.low, bounds.high
    if high is None:
        return sp.expand(value.subs(letter, low + above))
    if low is None:
        return sp.expand(value.subs(letter, high - under))
    if not value.is_polynomial(letter):
        return None
    degree = sp.degree(value, letter)
    coefficients = sp.Poly(value.subs(letter, low + letter), letter).all_coeffs()[::-1]
    whole = (above + under) / (high - low)
    return sp.expand(
        sp.Add(*(c * above**k * whole ** (degree - k) for k, c in enumerate(coefficients)))
    )
