"""Misprints: equations that fail, and that one small change of their print would make true.

A paper may state something new. So an equation that does not follow from others is called a
misprint only if it fails wherever the paper's constraints are found to hold together, while a
print that differs from it in one place (a sign, sine for cosine, an exponent, a factor, another
letter or a bracket) holds there. It is not called one if the changed print would repeat another
equation or have two equal sides.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.constraints.witnesses import Point, enclose, find_points
from mechproof.document.slips import ChangedSides, PrintedSides, Sides, list_alike, list_changes
from mechproof.proof.verdict import Evidence
from mechproof.proof.witness_text import show_plainly
from mechproof.statement_domains.dimension_inference import is_angle
from mechproof.statement_domains.domain import Domain

RUNG = "separating balls"
# Numbers of points: tried at first, and if too few of them fit; fitting points that suffice;
# points at which a mended print has to hold.
_COUNTS = (16, 32)
_ENOUGH = 8
FEW = 4
# Functions with steps: a change inside them may change no value at many points.
_STEPS = (sp.floor, sp.ceiling)
# Changes of one print that are tried.
MOST = 6000
_NEAR = sp.Rational(1, 10**4)
_CLOSE = balls.to_ball(10) ** -15

Values = Mapping[sp.Basic, sp.Expr | balls.Ball]


@dataclass(frozen=True)
class Misprint:
    """Evidence that an equation fails, and a change that mends it."""

    evidence: Evidence
    change: ChangedSides


def find_misprint(
    entry: PrintedSides,
    given: Sequence[sp.Expr],
    domain: Domain,
    printed: Collection[sp.Basic] = (),
    repeated: Sequence[sp.Expr] | None = None,
    *,
    state: Callable[[Sides], Sides] = lambda sides: sides,
) -> Misprint | None:
    """Return where an equation fails given constraints, and what mends it; None if it may be true.

    `given` are the residuals of the constraints, `printed` the letters that are defined by a print.
    If `repeated` is given, the mended equation must not repeat one of these residuals or a
    definition. `state` turns sides, as printed or as mended, into the sides that are compared.
    """
    sides = state(entry.sides)
    if any(domain.resolve(side).has(*_STEPS) for side in sides):
        return None
    met = {s for side in sides for s in side.free_symbols}
    are_angles = is_angle(sides, domain.dimensions)
    given_by = {s: v for s, v in domain.given.items() if isinstance(v, sp.Expr)}
    known = {s: v for s, v in given_by.items() if s in met}
    zeros = {s: v for s, v in given_by.items() if v == 0}
    defined = {s: value for s, value in known.items() if s in printed}
    alike = list_alike(met.union(*(value.free_symbols for value in defined.values())), domain)
    places = _find_failures(sides, given, domain, alike)
    values = [{s: balls.evaluate(domain.resolve(s), place) for s in alike} for place in places]
    repeated = [] if repeated is None else [*repeated, *(s - v for s, v in given_by.items())]
    changes = list_changes(entry, list_alike(met, domain), defined)
    for change in islice(changes, MOST if places else 0):
        mended = state(change.sides)
        holds = _holds_often(mended, values, are_angles=are_angles)
        # Nobody would print an equation both of whose sides are zero.
        holds = holds and (0 in mended or not all(_vanish(side, values) for side in mended))
        if holds and not _is_trivial(mended, repeated, known | zeros, are_angles=are_angles):
            evidence = _show(sides, given, domain, places)
            return Misprint(evidence, change) if evidence else None
    return None


def find_failure(sides: Sides, given: Sequence[sp.Expr], domain: Domain) -> Evidence | None:
    """Return where an equation fails, if it fails wherever all constraints are found to hold."""
    return _show(sides, given, domain, _find_failures(sides, given, domain))


def holds_at_rest(
    sides: Sides, given: Sequence[sp.Expr], domain: Domain, second: Iterable[sp.Basic]
) -> bool:
    """Return whether an equation may hold with one of the accelerations zero.

    The text may say, in words that are not understood, that something moves at constant speed; not,
    however, of the letter that the equation gives a value.
    """
    met = {s for one in (*sides, *given) for s in one.free_symbols}
    if 0 not in sides:
        met.difference_update(sides)
    for letter in met.intersection(second):
        rest = {letter: sp.S.Zero}
        one, other = (side.xreplace(rest) for side in sides)
        if not find_failure((one, other), [part.xreplace(rest) for part in given], domain):
            return True
    return False


def _find_failures(
    sides: Sides, given: Sequence[sp.Expr], domain: Domain, others: Sequence[sp.Basic] = ()
) -> list[Point]:
    """Return points at which constraints hold and an equation fails; none if it holds at one.

    The points have values for all letters on which the equation and `others` depend.
    """
    resolved = domain.resolve(sides[0]), domain.resolve(sides[1])
    parts = [*resolved, *map(domain.resolve, others), *given]
    are_angles = is_angle(sides, domain.dimensions)
    letters = {s for one in parts for s in one.free_symbols}
    for count in _COUNTS:
        points = []
        for point in find_points(given, letters, domain, count):
            # Lengths near zero, or very large ones, make much true that is not true in general.
            if all(_NEAR < abs(value) < 1 / _NEAR for value in point.values()):
                agrees = agree(resolved, point, are_angles=are_angles)
                if agrees:
                    return []
                points += [point] if agrees is False else []
        if len(points) >= _ENOUGH:
            return points
    return []


def agree(sides: Sides, values: Values, *, are_angles: bool = False) -> bool | None:
    """Return whether sides have the same value, angles the same direction; None without values."""
    try:
        one, other = (balls.evaluate(side, values) for side in sides)
    except (NotImplementedError, KeyError):
        return None
    if not (one.is_finite() and other.is_finite()):
        return None
    rest = 2 * ((one - other) / 2).sin() if are_angles else one - other
    return bool(abs(rest) < _CLOSE * (abs(one) + abs(other) + 1))


def _holds_often(sides: Sides, places: Sequence[Values], *, are_angles: bool) -> bool:
    """Return whether sides agree at `FEW` places or more, one of them among the first `FEW`."""
    if not any(agree(sides, values, are_angles=are_angles) for values in places[:FEW]):
        return False
    return sum(agree(sides, values, are_angles=are_angles) is True for values in places) >= FEW


def _vanish(side: sp.Expr, places: Sequence[Values]) -> bool:
    """Return whether a side is zero wherever it has a value."""
    return all(agree((side, sp.S.Zero), values) is not False for values in places)


def _is_trivial(
    sides: Sides,
    repeated: Sequence[sp.Expr],
    defined: Mapping[sp.Basic, sp.Expr],
    *,
    are_angles: bool,
) -> bool:
    """Return whether an equation says nothing, or repeats another one up to a factor.

    A letter given as a function of itself says nothing about others. The equation is also tested
    with the definition of a letter that is alone on a side, and with zero for letters defined as
    zero. Angles may differ by whole turns.
    """
    if any(one.is_Symbol and other.free_symbols == {one} for one, other in (sides, sides[::-1])):
        return True
    zeros = {letter: value for letter, value in defined.items() if value == 0}
    shown = [sides, tuple(defined.get(side, side) for side in sides)]
    shown.append(tuple(side.subs(zeros) for side in sides))
    for rest in (sp.expand(one - other) for one, other in shown):
        rest = _take_turns_out(rest) if are_angles else rest
        alike = (one for one in repeated if one.free_symbols == rest.free_symbols)
        if rest == 0 or any(sp.cancel(rest / one).is_number for one in alike):
            return True
    return False


def _take_turns_out(angle: sp.Expr) -> sp.Expr:
    number, rest = angle.as_independent(*angle.free_symbols, as_Add=True)
    return rest if (number / (2 * sp.pi)).is_integer else angle


def _show(
    sides: Sides, given: Sequence[sp.Expr], domain: Domain, points: Sequence[Point]
) -> Evidence | None:
    """Return two separate enclosures of the sides where all constraints hold, or None."""
    resolved = domain.resolve(sides[0]), domain.resolve(sides[1])
    met = {s for part in (*resolved, *given) for s in part.free_symbols}
    for point in points:
        if found := enclose(given, point):
            one, other = (balls.evaluate(side, found) for side in resolved)
            if one.is_finite() and other.is_finite() and not one.overlaps(other):
                at = {str(s): show_plainly(found[s])[0] for s in sorted(met, key=str)}
                return Evidence("the two sides", at, *balls.show_apart(one, other))
    return None
