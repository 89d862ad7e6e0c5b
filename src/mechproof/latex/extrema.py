r"""Largest and smallest values, `\max_\theta f`: a bound everywhere that is reached somewhere."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex.measures import begins_member
from mechproof.latex.pieces import find_zero
from mechproof.latex.tree import Extremum, Letter, Node
from mechproof.latex.values import settle_all
from mechproof.record import Conjunction, Equality, Holds, ValueWhere

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning
    from mechproof.latex.parser import Parser

_SIGNS = {"max": sp.Le, "min": sp.Ge}
_TURNING = (sp.sin, sp.cos, sp.tan)
# Where functions of angles are steady, and how close a value must be there to be looked at.
_TURNS = (sp.S.Zero, sp.pi, sp.pi / 2, -sp.pi / 2, 3 * sp.pi / 2)
_CLOSE = 1e-12


def is_extremum(parser: Parser) -> bool:
    r"""Return whether \max or \min stands here with a letter below it, in a paper."""
    follows = [token.text for token in parser.rest[:2]]
    return follows in ([r"\max", "_"], [r"\min", "_"]) and parser.notation.name_unit is not None


def read_extremum(parser: Parser) -> Node:
    r"""Read \max_\theta and the product behind it, which together are a member."""
    start, place = parser.start, parser.place
    name = parser.take().text.strip("\\")
    parser.take("_")
    by = parser.read_inside("{", lambda: _read_letter(parser, name), "}")
    term = parser.read_product()
    is_whole = begins_member(parser, place) and parser.text not in ("+", "-", ")", "]", "}")
    if not is_whole or (place and parser.tokens[place - 1].text in ("+", "-")):
        raise parser.refuse(
            f"\\{name} is read alone on its side of an equation",
            "Print brackets around all that it is taken of.",
            start,
        )
    return Extremum(term, by, name, start=start, end=parser.end)


def _read_letter(parser: Parser, name: str) -> Letter:
    by = parser.read_atom()
    if not isinstance(by, Letter) or by.indices or parser.text != "}":
        raise parser.refuse(
            f"only one letter is read below \\{name}",
            "Say its range in the block of letters, where it is declared: {0<x<1}",
            by.start,
        )
    return by


def give_term(meaning: Meaning, node: Extremum) -> Any:
    """Return of what it is the extremum."""
    if meaning.letter(node.by) in meaning.values:
        raise meaning.source.refuse(node.by.start, f"{node.by.text} is given by others")
    return meaning.of(node.term)


def state_extremum(
    node: Extremum,
    sides: tuple[Any, Any],
    values: Mapping[sp.Basic, sp.Basic],
    within: sp.Set,
) -> Conjunction | None:
    """State that a term lies on one side of a bound, and that it reaches it.

    Of a wave that is what its amplitude makes of it. Of others stationary points and ends are tried
    for where; None if it reaches it at none of them.
    """
    value, bound = sides
    term, by = settle_all(value, values), node.by.symbol
    if within == sp.S.Reals and (wave := _find_wave(term, by)):
        mean, amplitude = wave
        extreme = mean + amplitude if node.name == "max" else mean - amplitude
        return Conjunction((Equality(bound, extreme, "member"),))
    letters = sorted(term.free_symbols | bound.free_symbols, key=str)
    numbers = {s: sp.Rational(n + 2, 7 * n + 9) for n, s in enumerate(letters)}
    for place in _list_places(term, by, within):
        there = term.xreplace({by: place})
        difference = (there - settle_all(bound, values)).xreplace(numbers).evalf()
        if difference.is_number and abs(difference) < _CLOSE:
            limit = _SIGNS[node.name](value, bound, evaluate=False)
            return Conjunction((Holds(limit), Equality(there, bound, "member")))
    return None


def _find_wave(term: sp.Expr, by: sp.Basic) -> tuple[sp.Expr, sp.Expr] | None:
    r"""Return c and \sqrt{a^2+b^2} of what is c+a\cos kx+b\sin kx for all x, None for another.

    A speed k that may be zero is needed to be none.
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
    arguments = (part.args[0] for part in term.atoms(*_TURNING))
    turns = [find_zero(argument - turn, by) for argument in arguments for turn in _TURNS]
    slope = sp.Poly(term.diff(by), by) if term.is_polynomial(by) else None
    roots = sp.roots(slope) if slope is not None and slope.degree() in (1, 2) else {}
    ends = [end for end in (within.inf, within.sup) if end.is_finite]
    found = dict.fromkeys(place for place in (*turns, *roots, *ends) if place is not None)
    return [p for p in found if within == sp.S.Reals or within.contains(p) == sp.true]
