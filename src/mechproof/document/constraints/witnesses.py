"""Points at which constraints hold together: if there is none, everything follows from them.

Newton's method, with the least step if there are more letters than constraints, starts where
unrestricted letters are positive and small, as lengths and angles are, or where angles are
negative, and then at other points of the domain. A point is found if the steps become small and
the domain allows it. Krawczyk's test (1969) proves that there is one nearby: it encloses as many
letters as there are constraints, with the other letters fixed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import zip_longest

import mpmath
import numpy as np
import sympy as sp
from flint import arb, arb_mat

from mechproof.arithmetic import balls
from mechproof.record import RecordError
from mechproof.record.parts import TURNING
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import take_values

_STARTS = 16
_STEPS = 60
_DIGITS = 30
# Ratio to the largest singular value below which equations are taken to be dependent.
_DEPENDENT = 1e-11
_NEAR = 1e-9
_SMALL = mpmath.mpf(10) ** -20
_BITS = 192
# Radius around a point within which a zero is sought.
_RADIUS = arb(2) ** -40
_TINY = arb(2) ** -64
_POSITIVE = sp.Interval.open(0, sp.Rational(3, 2))
_NEGATIVE = sp.Interval.open(-sp.Rational(3, 2), 0)
# Errors where something is divided by zero, has no real value, or is unknown to mpmath; such a
# place is no witness.
_NONE = (
    np.linalg.LinAlgError,
    ArithmeticError,
    ValueError,
    TypeError,
    NameError,
    NotImplementedError,
    RecordError,
)

Vector = list[mpmath.mpf]
# Returns the residuals at a place, and their slopes.
System = Callable[..., tuple[Vector, list[Vector]]]
Point = dict[sp.Basic, sp.Expr]


def hold_together(
    residuals: Sequence[sp.Expr], domain: Domain, divisors: Sequence[sp.Expr] = ()
) -> bool:
    """Return whether a point is found at which all residuals are zero and no divisor is."""
    letters = {s for one in (*residuals, *divisors) for s in one.free_symbols}
    return any(
        all(abs(one.xreplace(point).evalf()) > _NEAR for one in divisors)
        for point in find_points(residuals, letters, domain, _STARTS)
    )


def find_points(
    residuals: Sequence[sp.Expr], letters: set[sp.Basic], domain: Domain, count: int
) -> Iterator[Point]:
    """Yield points of `letters` at which all residuals are zero, to many digits.

    `count` starts with small letters and `count` others are tried. No point is found if slopes
    cannot be computed: those of a floor, of a limit, or of a sum by its bound.
    """
    own = sorted({s for one in residuals for s in one.free_symbols}, key=str)
    symbols = sorted(letters.union(own), key=str)
    if not own and any(residuals):
        return
    try:
        systems = _compile(tuple(residuals), tuple(own))
    except (NotImplementedError, ValueError):
        return
    with mpmath.workdps(_DIGITS):
        for start in _list_starts(residuals, symbols, domain, count):
            end = _find_zero(systems, [start[s] for s in own]) if own else []
            if end is None:
                continue
            point = start | dict(zip(own, map(_to_fraction, end), strict=True))
            if domain.allows(point):
                yield point


# The rows of a paper are judged by the same constraints, which take long to compile.
@lru_cache(maxsize=256)
def _compile(residuals: tuple[sp.Expr, ...], symbols: tuple[sp.Basic, ...]) -> tuple[System, ...]:
    """Return the residuals and their slopes as functions of doubles and of many digits."""
    slopes = _differentiate(residuals, symbols).tolist() if symbols else []
    both = [[*map(take_values, residuals)], slopes]
    return tuple(sp.lambdify(symbols, both, name, cse=True) for name in ("math", "mpmath"))


def _differentiate(residuals: Sequence[sp.Expr], symbols: Sequence[sp.Basic]) -> sp.Matrix:
    """Return the slopes of residuals; zero for integer letters, so that they keep their values."""
    values = [take_values(one) for one in residuals]
    return sp.Matrix([[0 if s.is_integer else one.diff(s) for s in symbols] for one in values])


def _list_starts(
    residuals: Sequence[sp.Expr], symbols: list[sp.Basic], domain: Domain, count: int
) -> Iterator[Point]:
    """Yield points with small letters, every other one with negative angles, then any points."""
    within = {s: _POSITIVE if v == sp.S.Reals else v for s, v in domain.within.items()}
    turning = {s for one in residuals for f in one.atoms(*TURNING) for s in f.free_symbols}
    turned = {s: _NEGATIVE if s in turning and v == _POSITIVE else v for s, v in within.items()}
    small = [_draw(replace(domain, within=one), symbols, count // 2) for one in (within, turned)]
    for pair in zip_longest(*small):
        yield from (start for start in pair if start)
    yield from _draw(domain, symbols, count)


def _draw(domain: Domain, symbols: list[sp.Basic], count: int) -> list[Point]:
    try:
        return domain.points(symbols, count)[:count]
    except RecordError:
        return []


def enclose(residuals: Sequence[sp.Expr], point: Point) -> dict[sp.Basic, balls.Ball] | None:
    """Return balls around a point that contain a point at which all residuals are zero.

    None if this is not shown. Dependent residuals are only checked to have zero in their balls.
    """
    with balls.working_precision(_BITS):
        values = {s: balls.to_ball(value) for s, value in point.items()}
        if not residuals:
            return values
        slopes = _differentiate(residuals, [*values])
        rows, columns = _choose(slopes, values)
        own, unknown = [residuals[row] for row in rows], [[*values][n] for n in columns]
        found = _test(own, slopes.extract(rows, columns), unknown, values)
        is_zero = found and all(_enclose(one, found).contains(0) for one in residuals)
    return found if is_zero else None


def _choose(
    slopes: sp.Matrix, values: Mapping[sp.Basic, balls.Ball]
) -> tuple[list[int], list[int]]:
    """Return independent rows, and the columns of their largest pivots."""
    left = [[_enclose(slope, values).mid() for slope in row] for row in slopes.tolist()]
    rows, columns = [], []
    for number, row in enumerate(left):
        sizes = [abs(slope) for slope in row]
        column = max(range(len(row)), key=sizes.__getitem__)
        if not sizes[column] > _TINY:
            continue
        rows.append(number)
        columns.append(column)
        for other in left[number + 1 :]:
            ratio = other[column] / row[column]
            other[:] = [(x - y * ratio).mid() for x, y in zip(other, row, strict=True)]
    return rows, columns


def _test(
    residuals: Sequence[sp.Expr],
    slopes: sp.Matrix,
    unknown: Sequence[sp.Basic],
    values: Mapping[sp.Basic, balls.Ball],
) -> dict[sp.Basic, balls.Ball] | None:
    """Return balls of the unknowns and values of the other letters if Krawczyk's test passes."""
    if not unknown:
        return {**values}
    around = {**values, **{s: values[s] + arb(0, _RADIUS) for s in unknown}}
    middle, whole = (
        arb_mat([[_enclose(x, place) for x in row] for row in slopes.tolist()])
        for place in (values, around)
    )
    zero = arb_mat([[_enclose(one, values)] for one in residuals])
    try:
        inverse = middle.mid().inv().mid()
    except ZeroDivisionError:
        return None
    size = len(unknown)
    unit = arb_mat([[arb(int(row == column)) for column in range(size)] for row in range(size)])
    off = arb_mat([[arb(0, _RADIUS)] for _ in unknown])
    moved = ((unit - inverse * whole) * off - inverse * zero).entries()
    if not all(one.is_finite() and one.abs_upper() < _RADIUS for one in moved):
        return None
    return {**values, **{s: values[s] + one for s, one in zip(unknown, moved, strict=True)}}


def _enclose(expression: sp.Expr, values: Mapping[sp.Basic, balls.Ball]) -> balls.Ball:
    return balls.evaluate(expression, values, _BITS)


def _find_zero(systems: Sequence[System], start: Sequence[sp.Expr]) -> Vector | None:
    """Return the zero that Newton's steps lead to, or None if they lead to none.

    Doubles come near to a zero first, so that few steps with many digits remain; starts that
    doubles cannot hold begin with many digits.
    """
    doubles, digits = systems
    place = [mpmath.mpf(sp.N(value, _DIGITS)) for value in start]
    try:
        near = _descend(doubles, [*map(float, place)], _NEAR)
    except _NONE:
        near = place
    try:
        return _descend(digits, [*map(mpmath.mpf, near)], _SMALL) if near else None
    except _NONE:
        return None


def _descend(system: System, place: Vector, small: float) -> Vector | None:
    """Return where Newton's steps and the residuals become small, or None if they do not."""
    for _ in range(_STEPS):
        values, slopes = system(*place)
        step = _solve(slopes, values)
        place = [x - dx for x, dx in zip(place, step, strict=True)]
        if all(abs(dx) < small * (1 + abs(x)) for x, dx in zip(place, step, strict=True)):
            return place if max(map(abs, system(*place)[0])) < small else None
    return None


def _solve(slopes: Sequence[Vector], values: Vector) -> list[float]:
    """Return the least solution of linear equations, or least-squares solution, to 16 digits."""
    left, right = (np.array(side, dtype=float) for side in (slopes, values))
    if not (np.isfinite(left).all() and np.isfinite(right).all()):
        raise ArithmeticError("no finite slopes")
    # Python floats are returned, as a division by zero must raise an error.
    found: list[float] = np.linalg.lstsq(left, right, rcond=_DEPENDENT)[0].tolist()
    return found


def _to_fraction(value: mpmath.mpf) -> sp.Expr:
    return sp.Rational(*mpmath.libmp.to_rational(value._mpf_))
