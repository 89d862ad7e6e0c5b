"""Points at which only some sides of a statement have values, among those that are tried."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.counts import choose_counts
from mechproof.proof.refutation import (
    COUNTED,
    FEW,
    POINTS,
    list_elements,
    list_letters,
    name_point,
    points_for,
    put_exactly,
)
from mechproof.record.exactness import RecordError
from mechproof.record.parts import has_parts
from mechproof.statement_domains.domain import Domain, Point

# Tells from which sides have values whether a point is looked for.
IsWanted = Callable[[list[bool]], bool]


def are_unlike(have_values: list[bool]) -> bool:
    """Return whether only some sides have values."""
    return len(set(have_values)) > 1


def lacks_any(have_values: list[bool]) -> bool:
    """Return whether a side has no value."""
    return not all(have_values)


def find_undefined(sides: Sequence[sp.Basic], domain: Domain, count: int = POINTS) -> str:
    """Return an interior point at which a side has no value, or "" if none is met."""
    return _find_point(sides, domain, count, lacks_any)


def find_unlike(sides: Sequence[sp.Basic], domain: Domain) -> str:
    """Return an interior point at which exactly one side has a value, or "" if none is met.

    Few points are tried for integrals, and for sums, which are written out for every number of
    terms.
    """
    is_slow = any(has_parts(side, sp.Sum, sp.Product, sp.Integral) for side in sides)
    count = FEW if is_slow else POINTS
    return _find_point(sides, domain, count, are_unlike)


def find_wanted_at(
    sides: Sequence[sp.Basic], known: Point, domain: Domain, is_wanted: IsWanted
) -> str:
    """Return a point with known values at which the sides have values as wanted, or ""."""
    for point in complete(sides, known, domain):
        if is_wanted([has_value(side, point) for side in sides]):
            return name_point(point, domain)
    return ""


def complete(sides: Sequence[sp.Basic], known: Point, domain: Domain) -> Iterator[Point]:
    """Yield a point of the domain with known values for each choice of the counts."""
    plain, counts = list_letters(sides, domain)
    others = [count for count in counts if count not in known]
    with suppress(RecordError):
        for chosen in choose_counts(others, domain, 1):
            sizes = {**chosen, **known}
            letters = [*(s for s in plain if s not in known), *list_elements((*sides,), sizes)]
            yield domain.points(letters, 1, sizes)[0]


def _find_point(sides: Sequence[sp.Basic], domain: Domain, count: int, is_wanted: IsWanted) -> str:
    for point in points_for(tuple(sides), domain, count, thorough=count == POINTS):
        have_values = [has_value(side, point) for side in sides]
        if is_wanted(have_values) and domain.is_interior(point):
            return name_point(point, domain)
    return ""


def has_value(side: sp.Basic, point: Point) -> bool:
    """Return whether a side has a value; exact numbers are put in only if plain balls show none."""
    if not has_parts(side, *COUNTED) and balls.evaluate(side, point).is_finite():
        return True
    return bool(balls.evaluate(put_exactly(side, point), point).is_finite())
