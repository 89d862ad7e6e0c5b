"""Misprints: an equation that fails, and that one small change of its print would make true.

A paper may state what it has not stated before. So an equation that does not follow from what is
printed elsewhere is accused only if it fails wherever the paper's constraints are met to hold
together, while a print that differs from it in one place, by a sign, sine for cosine, an exponent,
a factor, another letter or a bracket, holds there. Nobody is accused whose print would have to
become one that stands elsewhere, or the same on both sides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.scales import agrees
from mechproof.document.witnesses import Point, enclose, find_points
from mechproof.proof.domain import Domain
from mechproof.proof.verdict import Evidence
from mechproof.proof.witness_text import show_plainly
from mechproof.record import PrintedNumber

RUNG = "separating balls"
# Points that are tried; points with values that are enough, and at how many a mended print holds.
_COUNT = 16
_ENOUGH = 8
_FEW = 4
# Changes of one print that are tried.
_MOST = 6000
_NEAR = sp.Rational(1, 10**4)
_CLOSE = balls.to_ball(10) ** -15
_FEWEST_DIGITS = 3
_TURNING = (sp.sin, sp.cos, sp.tan)
_EXPONENTS = {
    **{sp.Integer(2): (1, 3), sp.Integer(3): (2,), sp.Integer(4): (2, 3)},
    **{sp.Integer(-1): (1, -2), sp.Integer(-2): (-1,), sp.Rational(1, 2): (1,)},
    **{sp.Rational(3, 2): (1, sp.Rational(1, 2)), sp.Rational(-1, 2): (-1,)},
}
_DIGITS = tuple(map(sp.Integer, range(1, 10)))

Sides = tuple[sp.Expr, sp.Expr]
Values = Mapping[sp.Basic, sp.Expr | balls.Ball]


@dataclass(frozen=True)
class Misprint:
    """Where an equation fails, and with what in place of what it holds."""

    evidence: Evidence
    printed: sp.Basic
    meant: sp.Basic

    @property
    def reason(self) -> str:
        """Say what is wrong."""
        return f"the two sides differ; with {self.meant} for {self.printed} they would not"


def find_misprint(
    sides: Sides, given: Sequence[sp.Expr], domain: Domain, *, may_repeat: bool
) -> Misprint | None:
    """Return where an equation fails beside constraints, and what mends it; None if it may be true.

    `given` are the residuals of the constraints. With `may_repeat` what it is mended to may stand
    elsewhere in the paper.
    """
    alike = _list_alike(sides, domain)
    places = _find_failures(sides, given, domain, alike)
    values = [{s: balls.evaluate(domain.resolve(s), place) for s in alike} for place in places]
    repeated = [] if may_repeat else [*given, *_list_definitions(domain)]
    for mended, printed, meant in islice(_list_changes(sides, alike), _MOST if places else 0):
        if _holds_often(mended, values) and not _is_trivial(mended, repeated, domain):
            evidence = _show(sides, given, domain, places)
            return Misprint(evidence, printed, meant) if evidence else None
    return None


def find_failure(sides: Sides, given: Sequence[sp.Expr], domain: Domain) -> Evidence | None:
    """Return where an equation fails, if it fails wherever all constraints are met to hold."""
    return _show(sides, given, domain, _find_failures(sides, given, domain))


def _find_failures(
    sides: Sides, given: Sequence[sp.Expr], domain: Domain, others: Sequence[sp.Basic] = ()
) -> list[Point]:
    """Return points at which the constraints hold and an equation fails; none if it holds at one.

    They have values for all letters that the equation and `others` are given by.
    """
    resolved = domain.resolve(sides[0]), domain.resolve(sides[1])
    parts = [*resolved, *map(domain.resolve, others), *given]
    points = []
    for point in find_points(given, {s for one in parts for s in one.free_symbols}, domain, _COUNT):
        # Where lengths shrink to nothing, or one has no end, much is true.
        if all(_NEAR < abs(value) < 1 / _NEAR for value in point.values()):
            agrees = _agree(resolved, point)
            if agrees:
                return []
            points += [point] if agrees is False else []
    return points if len(points) >= _ENOUGH else []


def _agree(sides: Sides, values: Values) -> bool | None:
    """Return whether sides have the same value, None where they have none."""
    try:
        one, other = (balls.evaluate(side, values) for side in sides)
    except (NotImplementedError, KeyError):
        return None
    if not (one.is_finite() and other.is_finite()):
        return None
    return bool(abs(one - other) < _CLOSE * (abs(one) + abs(other) + 1))


def _holds_often(sides: Sides, places: Sequence[Values]) -> bool:
    """Return whether sides agree at some of the places: at the first few at least at one."""
    if not any(_agree(sides, values) for values in places[:_FEW]):
        return False
    return sum(_agree(sides, values) is True for values in places) >= _FEW


def _list_definitions(domain: Domain) -> list[sp.Expr]:
    return [symbol - value for symbol, value in domain.given.items() if isinstance(value, sp.Expr)]


def _is_trivial(sides: Sides, repeated: Sequence[sp.Expr], domain: Domain) -> bool:
    """Return whether an equation says nothing, or what stands elsewhere up to a number."""
    rest = sp.expand(sides[0] - sides[1])
    if rest == 0:
        return True
    for one in repeated:
        for shown in (rest, sp.expand(domain.resolve(rest))):
            ratio = sp.cancel(shown / one) if shown.free_symbols == one.free_symbols else None
            if ratio is not None and ratio.is_number:
                return True
    return False


def _show(
    sides: Sides, given: Sequence[sp.Expr], domain: Domain, points: Sequence[Point]
) -> Evidence | None:
    """Return the evidence of two values where all that is given holds, None if none is shown."""
    resolved = domain.resolve(sides[0]), domain.resolve(sides[1])
    met = {s for part in (*resolved, *given) for s in part.free_symbols}
    for point in points:
        if found := enclose(given, point):
            one, other = (balls.evaluate(side, found) for side in resolved)
            if one.is_finite() and other.is_finite() and not one.overlaps(other):
                at = {str(s): show_plainly(found[s])[0] for s in sorted(met, key=str)}
                return Evidence("the two sides", at, *balls.show_apart(one, other))
    return None


def find_slip(says: PrintedNumber, value: sp.Expr) -> str:
    """Return the number that rounds a value and differs from the print in one digit, or none.

    Two neighbours may be exchanged. Of numbers with less than three digits that says nothing.
    """
    text = says.printed
    places = [n for n, sign in enumerate(text) if sign.isdigit()]
    if len(text.strip("-0.").replace(".", "")) < _FEWEST_DIGITS:
        return ""
    slips = {text[:n] + digit + text[n + 1 :] for n in places for digit in "0123456789"}
    slips |= {
        text[:n] + text[m] + text[n + 1 : m] + text[n] + text[m + 1 :] for n, m in pairwise(places)
    }
    return next((slip for slip in sorted(slips) if agrees(PrintedNumber(slip, value))), "")


# Changes ----------------------------------------------------------------------------------------


def _list_alike(sides: Sides, domain: Domain) -> list[sp.Basic]:
    """Return the letters of an equation, and those that differ from one by an index."""
    met = {s for side in sides for s in side.free_symbols}
    stems = {str(s).partition("_")[0] for s in met}
    known = {s for s in (*domain.within, *domain.given) if s.is_Symbol}
    alike = {s for s in known if str(s).partition("_")[0] in stems}
    return sorted(met | alike, key=str)


def _list_changes(
    sides: Sides, letters: Sequence[sp.Basic]
) -> Iterator[tuple[Sides, sp.Basic, sp.Basic]]:
    """Yield sides that differ in one place from those printed, what is there and what was."""
    one, other = sides
    for changed, printed, meant in _change(one, letters, is_term=True):
        yield (changed, other), printed, meant
    for changed, printed, meant in _change(other, letters, is_term=True):
        yield (one, changed), printed, meant


def _change(
    part: sp.Expr, letters: Sequence[sp.Basic], *, is_term: bool
) -> Iterator[tuple[sp.Expr, sp.Basic, sp.Basic]]:
    for meant in _exchange(part, letters, is_term=is_term):
        if meant != part:
            yield meant, part, meant
    is_sum = isinstance(part, sp.Add | sp.Function)
    inside = part.args[:1] if isinstance(part, sp.Pow) else part.args
    for place, argument in enumerate(inside):
        if isinstance(argument, sp.Expr):
            for changed, printed, meant in _change(argument, letters, is_term=is_sum):
                arguments = [*part.args[:place], changed, *part.args[place + 1 :]]
                yield part.func(*arguments), printed, meant


def _exchange(part: sp.Expr, letters: Sequence[sp.Basic], *, is_term: bool) -> Iterator[sp.Expr]:
    """Yield what may have been meant in place of a part that is printed."""
    yield -part
    yield 2 * part
    yield part / 2
    if part.is_Symbol:
        yield part**2
        yield from letters
        yield from (part + letter for letter in letters)
    elif isinstance(part, _TURNING):
        yield part**2
        yield from (other(*part.args) for other in _TURNING)
    elif isinstance(part, sp.Pow):
        yield from (part.base**exponent for exponent in _EXPONENTS.get(part.exp, ()))
        yield from (part / part.base * letter for letter in letters)
    elif part.is_Integer:
        yield from _DIGITS
    elif isinstance(part, sp.Mul):
        yield from (part / factor for factor in part.args)
        yield from _move_bracket(part)
    elif isinstance(part, sp.Add):
        yield part**2
        yield from _enter_bracket(part)
    if is_term:
        yield from (part * letter for letter in letters)
        yield from (part / letter for letter in letters)


def _move_bracket(part: sp.Mul) -> Iterator[sp.Expr]:
    """Yield a b + c for a (b + c)."""
    for factor in part.args:
        for term in factor.args if isinstance(factor, sp.Add) else ():
            yield part / factor * term + factor - term


def _enter_bracket(part: sp.Add) -> Iterator[sp.Expr]:
    """Yield a (b + c) for a b + c."""
    for term in part.args:
        for factor in term.args if isinstance(term, sp.Mul) else ():
            yield factor * (part - term + term / factor)
