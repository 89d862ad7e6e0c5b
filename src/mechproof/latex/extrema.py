r"""Largest and smallest values, `\max_\theta f`: a bound that holds everywhere and is attained."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice, permutations
from typing import TYPE_CHECKING, Any

import sympy as sp
from sympy.core.relational import Relational

from mechproof.latex.measures import begins_member
from mechproof.latex.tree import Extremum, Letter, Node
from mechproof.latex.values import find_zero, refuse_unknown, settle_all
from mechproof.record import Conjunction, Equality, Holds, ValueWhere
from mechproof.record.parts import TURNING

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning
    from mechproof.latex.parser import Parser

_SIGNS = {"max": sp.Le, "min": sp.Ge}
# Arguments of trigonometric functions at which extrema are sought, and the difference from the
# printed value up to which a place counts as one.
_TURNS = (sp.S.Zero, sp.pi, sp.pi / 2, -sp.pi / 2, 3 * sp.pi / 2)
_CLOSE = 1e-12
# Work limit: number of orders of the letters by size that are tried.
_ORDERS = 24


def is_extremum(parser: Parser) -> bool:
    r"""Return whether \max or \min with a letter below it comes next, where units are read."""
    follows = [token.text for token in parser.rest[:2]]
    return follows in ([r"\max", "_"], [r"\min", "_"]) and parser.notation.name_unit is not None


def read_extremum(parser: Parser) -> Node:
    r"""Read \max_\theta and the product after it, which together must be a whole member."""
    start, place = parser.start, parser.place
    name = parser.take().text.strip("\\")
    parser.take("_")
    by = parser.read_inside("{", lambda: _read_letter(parser, name))
    term = parser.read_product()
    is_whole = begins_member(parser, place) and parser.text not in ("+", "-", ")", "]", "}")
    if not is_whole or (place and parser.tokens[place - 1].text in ("+", "-")):
        raise parser.refuse(
            f"\\{name} must be alone on its side of an equation",
            "Print brackets around its whole argument.",
            start,
        )
    return Extremum(term, by, name, start=start, end=parser.end)


def _read_letter(parser: Parser, name: str) -> Letter:
    by = parser.read_atom()
    if not isinstance(by, Letter) or by.indices or parser.text != "}":
        raise parser.refuse(
            f"only one letter may be below \\{name}",
            "Give its range in the block of letters, where it is declared: {0<x<1}",
            by.start,
        )
    return by


def give_term(meaning: Meaning, node: Extremum) -> Any:
    """Return the expression whose extremum is meant."""
    by = meaning.letter(node.by)
    if by in meaning.values:
        raise meaning.source.refuse(node.by.start, f"{node.by.text} is defined by other letters")
    term = meaning.of(node.term)
    refuse_unknown(meaning, node.start, (term, f"in the {node.name}imum"), by)
    return term


def state_extremum(
    node: Extremum, sides: tuple[Any, Any], values: Mapping[sp.Basic, sp.Basic], within: sp.Set
) -> Conjunction | None:
    """State that a term lies on one side of a bound, and that it attains it.

    A wave is compared by its amplitude. For other terms, stationary points and the ends of `within`
    are tried as the place. If the bound is attained at none of them, it is compared with the term's
    extreme value among them. Returns None if no such place is found, or if the order of the letters
    by size decides whether the bound is attained.
    """
    value, bound = sides
    term, by = settle_all(value, values), node.by.symbol
    if within == sp.S.Reals and (wave := _find_wave(term, by)):
        mean, amplitude = wave
        extreme = mean + amplitude if node.name == "max" else mean - amplitude
        return Conjunction((Equality(bound, extreme, "member"),))
    letters = sorted(term.free_symbols | bound.free_symbols, key=str)
    sign, known = _SIGNS[node.name], settle_all(bound, values)
    places = {place: within.contains(place) for place in _list_places(term, by, within)}
    reached: dict[sp.Expr, sp.Basic] = {}
    # Places that certainly lie in the range come first.
    for place in sorted(places, key=lambda place: places[place] != sp.true):
        reached.setdefault(term.xreplace({by: place}), places[place])
    # For letters of another order by size, the extremum may lie elsewhere.
    orders = [*islice(permutations(letters), _ORDERS)]
    agree = [any(_agree(there, known, one) for there in reached) for one in orders]
    if any(agree) and not all(agree):
        return None
    for there in reached:
        if _agree(there, known, letters):
            limit = sign(value, bound, evaluate=False)
            return Conjunction((Holds(limit), _attain(there, bound, reached[there])))
    pairs = [
        (number, there) for there in reached if (number := _evaluate(there, letters)) is not None
    ]
    if not pairs:
        return None
    choose = max if node.name == "max" else min
    extreme = choose(pairs, key=lambda pair: pair[0])[1]
    # A value that bounds the term everywhere is its extremum; no other value is.
    limit = sign(value, extreme, evaluate=False)
    attained = _attain(extreme, bound, reached[extreme])
    return Conjunction((Holds(limit), attained), needs_first=True)


def _attain(value: sp.Expr, bound: sp.Expr, inside: sp.Basic) -> Equality | Conjunction:
    """State that a bound is a value that is attained if a condition on the letters is met.

    It may be attained elsewhere, too, so that nothing follows where the condition is not met.
    """
    equal = Equality(value, bound, "member")
    if inside == sp.true:
        return equal
    return Conjunction((Holds(inside), equal), needs_first=True)


def _agree(one: sp.Expr, other: sp.Expr, letters: Sequence[sp.Basic]) -> bool:
    difference = _evaluate(one - other, letters)
    return difference is not None and bool(abs(difference) < _CLOSE)


def _evaluate(expression: sp.Expr, letters: Sequence[sp.Basic]) -> sp.Expr | None:
    """Return the value at test numbers for the letters, None if it is not a real number."""
    numbers = {s: sp.Rational(n + 2, 7 * n + 9) for n, s in enumerate(letters)}
    found = expression.xreplace(numbers).evalf()
    return found if found.is_number and found.is_real else None


def _find_wave(term: sp.Expr, by: sp.Basic) -> tuple[sp.Expr, sp.Expr] | None:
    r"""Return c and \sqrt{a^2+b^2} of a term c+a\cos kx+b\sin kx in x, or None for any other term.

    If the speed k may be zero, the amplitude requires it to be nonzero.
    """
    cosine, sine = sp.Dummy("cosine", real=True), sp.Dummy("sine", real=True)
    speeds: dict[sp.Expr, None] = {}

    def split(function: type[sp.Function], argument: sp.Expr) -> sp.Expr:
        argument = sp.expand(argument)
        speed = argument.coeff(by)
        phase = argument - speed * by
        if speed == 0:
            return function(argument, evaluate=False)
        sign = -1 if speed.could_extract_minus_sign() else 1
        speeds[sign * speed] = None
        if function is sp.cos:
            return cosine * sp.cos(phase) - sign * sine * sp.sin(phase)
        return sign * sine * sp.cos(phase) + cosine * sp.sin(phase)

    split_up = term.replace(sp.cos, lambda x: split(sp.cos, x))
    split_up = sp.expand(split_up.replace(sp.sin, lambda x: split(sp.sin, x)))
    a, b = split_up.coeff(cosine), split_up.coeff(sine)
    mean = sp.expand(split_up - a * cosine - b * sine)
    if len(speeds) != 1 or any(part.has(by, cosine, sine) for part in (a, b, mean)):
        return None
    (speed,) = speeds
    amplitude = sp.sqrt(a**2 + b**2)
    return mean, amplitude if speed.is_nonzero else ValueWhere(amplitude, 1 / speed)


def _list_places(term: sp.Expr, by: sp.Basic, within: sp.Set) -> list[sp.Expr]:
    ends = [end for end in (within.inf, within.sup) if end.is_finite]
    found = dict.fromkeys((*_list_stationary(term, by), *ends))
    inside = {place: within.contains(place) for place in found}
    # A law may have its seams at letters; that these lie in the range is then left to be shown.
    may_lie = isinstance(term, sp.Piecewise)
    return [p for p in found if inside[p] == sp.true or (may_lie and inside[p] != sp.false)]


def _list_stationary(term: sp.Expr, by: sp.Basic) -> list[sp.Expr]:
    """List places at which a term may be stationary; of pieces, their ends as well."""
    if isinstance(term, sp.Piecewise):
        edges = (part.lhs - part.rhs for part in term.atoms(Relational))
        inside = [place for piece, _ in term.args for place in _list_stationary(piece, by)]
        return [place for edge in edges if (place := find_zero(edge, by)) is not None] + inside
    arguments = (part.args[0] for part in term.atoms(*TURNING))
    turns = [find_zero(argument - turn, by) for argument in arguments for turn in _TURNS]
    slope = sp.Poly(term.diff(by), by) if term.is_polynomial(by) else None
    roots = sp.roots(slope) if slope is not None and slope.degree() in (1, 2) else {}
    return [*(place for place in turns if place is not None), *roots]
