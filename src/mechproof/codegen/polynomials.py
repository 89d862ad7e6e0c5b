"""Rational approximations: in, a function and an interval; out, coefficients as doubles.

Interpolation at Chebyshev nodes in 60 digits: within a small factor of the best approximation of
its degrees, and the same doubles on every machine. The tests enclose what each is off by.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import mpmath as mp

DIGITS = 60
# Beyond the ends, for the rounding of what is reduced to an interval.
MARGIN = 2.0**-20
# The largest argument of SmallArctan, 1/sqrt(3), squared.
LARGEST_SQUARE = 1 / 3


@dataclass(frozen=True)
class Rational:
    """Coefficients of a quotient of polynomials, lowest power first."""

    above: tuple[float, ...]
    below: tuple[float, ...]


@cache
def fit_tangent() -> Rational:
    """Fit tan(r/2)/r in r**2, where |r| <= pi/2."""
    with mp.workdps(DIGITS):
        return _fit(_tangent_over_angle, ((1 + MARGIN) * mp.pi / 2) ** 2, 3)


@cache
def fit_arctangent() -> Rational:
    """Fit (atan(y)/y - 1)/y**2 in y**2, where |y| <= 1/sqrt(3)."""
    with mp.workdps(DIGITS):
        return _fit(_rest_of_arctangent, LARGEST_SQUARE * (1 + MARGIN), 4)


def _tangent_over_angle(z: mp.mpf) -> mp.mpf:
    r = mp.sqrt(z)
    return mp.tan(r / 2) / r


def _rest_of_arctangent(z: mp.mpf) -> mp.mpf:
    y = mp.sqrt(z)
    return (mp.atan(y) / y - 1) / z


def _fit(function: Callable[[mp.mpf], mp.mpf], end: mp.mpf, degree: int) -> Rational:
    """Interpolate on (0, end] by a quotient of two polynomials of one degree."""
    count = 2 * degree + 1
    nodes = [end / 2 * (1 + mp.cos(mp.pi * (2 * i + 1) / (2 * count))) for i in range(count)]
    values = [function(z) for z in nodes]
    rows = [
        [z**j for j in range(degree + 1)] + [-v * z**j for j in range(1, degree + 1)]
        for z, v in zip(nodes, values, strict=True)
    ]
    found = [float(c) for c in mp.lu_solve(mp.matrix(rows), mp.matrix(values))]
    return Rational(tuple(found[: degree + 1]), (1.0, *found[degree + 1 :]))
