"""Misprints: an equation that fails, and that one small change of its print would make true.

A paper may state what it has not stated before. So an equation that does not follow from what is
printed elsewhere is accused only if it fails wherever the paper's constraints are met to hold
together, while a print that differs from it in one place, by a sign, sine for cosine, an exponent,
a factor, another letter or a bracket, holds there. Nobody is accused whose print would have to
become one that stands elsewhere, or the same on both sides.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, islice, pairwise

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
class Entry:
    """The sides of an equation, and which of them are printed so: only these have misprints."""

    sides: Sides
    are_printed: tuple[bool, bool] = (True, True)


@dataclass(frozen=True)
class Change:
    """Sides that a print would have with one part of it, or of what defines a letter, changed."""

    sides: Sides
    printed: sp.Basic
    meant: sp.Basic
    within: sp.Basic | None = None

    @property
    def reason(self) -> str:
        """Say what is wrong."""
        where = f" in what defines {self.within}" if self.within else ""
        return f"the two sides differ; with {self.meant} for {self.printed}{where} they would not"


@dataclass(frozen=True)
class Misprint:
    """Where an equation fails, and what mends it."""

    evidence: Evidence
    change: Change


def find_misprint(
    entry: Entry,
    given: Sequence[sp.Expr],
    domain: Domain,
    printed: Collection[sp.Basic] = (),
    *,
    may_repeat: bool = False,
) -> Misprint | None:
    """Return where an equation fails beside constraints, and what mends it; None if it may be true.

    `given` are the residuals of the constraints, `printed` the letters that are defined by a print.
    With `may_repeat` what it is mended to may stand elsewhere in the paper.
    """
    sides = entry.sides
    met = {s for side in sides for s in side.free_symbols}
    known = {s: v for s, v in domain.given.items() if s in met and isinstance(v, sp.Expr)}
    defined = {s: value for s, value in known.items() if s in printed}
    alike = _list_alike(met.union(*(value.free_symbols for value in defined.values())), domain)
    places = _find_failures(sides, given, domain, alike)
    values = [{s: balls.evaluate(domain.resolve(s), place) for s in alike} for place in places]
    repeated = [] if may_repeat else [*given, *_list_definitions(domain)]
    changes = _list_changes(entry, _list_alike(met, domain), defined)
    for change in islice(changes, _MOST if places else 0):
        if _holds_often(change.sides, values) and not _is_trivial(change.sides, repeated, known):
            evidence = _show(sides, given, domain, places)
            return Misprint(evidence, change) if evidence else None
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


def _is_trivial(
    sides: Sides, repeated: Sequence[sp.Expr], defined: Mapping[sp.Basic, sp.Expr]
) -> bool:
    """Return whether an equation says nothing, or what stands elsewhere up to a number.

    Of a letter that stands alone what defines it is put in, too.
    """
    shown = [sides, tuple(defined.get(side, side) for side in sides)]
    for rest in (sp.expand(one - other) for one, other in shown):
        alike = (one for one in repeated if one.free_symbols == rest.free_symbols)
        if rest == 0 or any(sp.cancel(rest / one).is_number for one in alike):
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


def _list_alike(letters: Collection[sp.Basic], domain: Domain) -> list[sp.Basic]:
    """Return letters, and those that differ from one by an index."""
    stems = {str(s).partition("_")[0] for s in letters}
    known = {s for s in (*domain.within, *domain.given) if s.is_Symbol}
    alike = {s for s in known if str(s).partition("_")[0] in stems}
    return sorted({*letters} | alike, key=str)


def _list_changes(
    entry: Entry, letters: Sequence[sp.Basic], defined: Mapping[sp.Basic, sp.Expr]
) -> Iterator[Change]:
    """Yield sides that differ in one place from those printed.

    Two letters may be exchanged. What defines a letter keeps its letters: with others much would
    be true.
    """
    one, other = entry.sides
    if entry.are_printed[0]:
        for changed, printed, meant in _change(one, letters, is_term=True):
            yield Change((changed, other), printed, meant)
    if entry.are_printed[1]:
        for changed, printed, meant in _change(other, letters, is_term=True):
            yield Change((one, changed), printed, meant)
    if not all(entry.are_printed):
        return
    for pair in combinations(sorted(one.free_symbols | other.free_symbols, key=str), 2):
        values = dict(zip(pair, reversed(pair), strict=True))
        exchanged = one.xreplace(values), other.xreplace(values)
        yield Change(exchanged, sp.Tuple(*pair), sp.Tuple(*reversed(pair)))
    for letter, value in defined.items():
        for changed, printed, meant in _change(value, (), is_term=True):
            put_in = {letter: changed}
            yield Change((one.xreplace(put_in), other.xreplace(put_in)), printed, meant, letter)


def _change(
    part: sp.Expr, letters: Sequence[sp.Basic], *, is_term: bool
) -> Iterator[tuple[sp.Expr, sp.Basic, sp.Basic]]:
    for meant in _exchange(part, letters, is_term=is_term):
        if meant != part:
            yield meant, part, meant
    is_sum = isinstance(part, sp.Add | sp.Function)
    inside = part.args[:1] if isinstance(part, sp.Pow) and part.exp.is_number else part.args
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
