"""Rational approximations: in, a function and an interval; out, coefficients and their bound.

Interpolation at Chebyshev nodes in 60 digits: within a small factor of the best approximation of
its degrees, and the same numbers on every machine. What they are off by is enclosed over the whole
interval by Taylor polynomials in balls.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import mpmath as mp
from flint import arb, arb_series, ctx

from mechproof.codegen.elementary.formats import DIGITS, DOUBLE, Format

# Beyond the ends, for the rounding of what is reduced to an interval.
MARGIN = 2.0**-20
PIECES, ORDER, BITS = 64, 24, 400
Sides = Callable[["Rational", arb_series], tuple[arb_series, arb_series]]


@dataclass(frozen=True)
class Rational:
    """Coefficients of a quotient of polynomials, lowest power first."""

    above: tuple[float, ...]
    below: tuple[float, ...]


@dataclass(frozen=True)
class Target:
    """A function to be approximated in the square of its argument, from 0 to `last`.

    `value` is what the quotient approximates, `above` the polynomial over the line of the whole
    function; `sides` are the whole function by the quotient and the true one, both multiplied by
    what makes them polynomials and entire or analytic.
    """

    meaning: str
    value: Callable[[mp.mpf], mp.mpf]
    last: Callable[[], mp.mpf]
    sides: Sides
    above: Callable[[Rational, arb], arb]


def _beyond(end: mp.mpf) -> mp.mpf:
    return ((1 + MARGIN) * end) ** 2


def _put(coefficients: tuple[float, ...], z: arb_series) -> arb_series:
    value = z * 0
    for number in reversed(coefficients):
        value = value * z + arb(number)
    return value


def _tangent_above(fit: Rational, r: arb) -> arb:
    return r * _put(fit.above, r * r)


def _sine_above(fit: Rational, r: arb) -> arb:
    return r + r * r * r * _put(fit.above, r * r)


def _cosine_above(fit: Rational, r: arb) -> arb:
    z = r * r
    return 1 - z / 2 + z * z * _put(fit.above, z)


def _arctangent_above(fit: Rational, y: arb) -> arb:
    z = y * y
    return y * _put(fit.below, z) + y * z * _put(fit.above, z)


def _tangent_sides(fit: Rational, r: arb_series) -> tuple[arb_series, arb_series]:
    return _tangent_above(fit, r) * r.cos(), _put(fit.below, r * r) * r.sin()


def _half_tangent_sides(fit: Rational, r: arb_series) -> tuple[arb_series, arb_series]:
    half = r / 2
    return _tangent_above(fit, r) * half.cos(), _put(fit.below, r * r) * half.sin()


def _sine_sides(fit: Rational, r: arb_series) -> tuple[arb_series, arb_series]:
    return _sine_above(fit, r), r.sin()


def _cosine_sides(fit: Rational, r: arb_series) -> tuple[arb_series, arb_series]:
    return _cosine_above(fit, r), r.cos()


def _arctangent_sides(fit: Rational, y: arb_series) -> tuple[arb_series, arb_series]:
    return _arctangent_above(fit, y), _put(fit.below, y * y) * y.atan()


def _of_root(function: Callable[[mp.mpf], mp.mpf]) -> Callable[[mp.mpf], mp.mpf]:
    return lambda z: function(mp.sqrt(z))


TANGENT = Target(
    "tan(r)/r in powers of r**2, |r| <= pi/4",
    _of_root(lambda r: mp.tan(r) / r),
    lambda: _beyond(mp.pi / 4),
    _tangent_sides,
    _tangent_above,
)
HALF_TANGENT = Target(
    "tan(r/2)/r in powers of r**2",
    _of_root(lambda r: mp.tan(r / 2) / r),
    lambda: _beyond(mp.pi / 2),
    _half_tangent_sides,
    _tangent_above,
)
SINE = Target(
    "(sin(r)/r - 1)/r**2 in powers of r**2, |r| <= pi/4",
    _of_root(lambda r: (mp.sin(r) / r - 1) / r**2),
    lambda: _beyond(mp.pi / 4),
    _sine_sides,
    _sine_above,
)
COSINE = Target(
    "(cos(r) - 1 + r**2/2)/r**4 in powers of r**2, |r| <= pi/4",
    _of_root(lambda r: (mp.cos(r) - 1 + r**2 / 2) / r**4),
    lambda: _beyond(mp.pi / 4),
    _cosine_sides,
    _cosine_above,
)
ARCTANGENT = Target(
    "(atan(y)/y - 1)/y**2 in powers of y**2, |y| <= 1",
    _of_root(lambda y: (mp.atan(y) / y - 1) / y**2),
    lambda: _beyond(mp.mpf(1)),
    _arctangent_sides,
    _arctangent_above,
)
SMALL_ARCTANGENT = Target(
    "(atan(y)/y - 1)/y**2 in powers of y**2",
    ARCTANGENT.value,
    lambda: mp.mpf(1) / 3 * (1 + MARGIN),
    _arctangent_sides,
    _arctangent_above,
)


@cache
def fit(target: Target, above: int, below: int = 0, form: Format = DOUBLE) -> Rational:
    """Interpolate by a quotient of polynomials of degrees `above` and `below`."""
    with mp.workdps(DIGITS):
        last = target.last()
        count = above + below + 1
        nodes = [last / 2 * (1 + mp.cos(mp.pi * (2 * i + 1) / (2 * count))) for i in range(count)]
        values = [target.value(z) for z in nodes]
        rows = [
            [z**j for j in range(above + 1)] + [-v * z**j for j in range(1, below + 1)]
            for z, v in zip(nodes, values, strict=True)
        ]
        found = [form.round(c) for c in mp.lu_solve(mp.matrix(rows), mp.matrix(values))]
    return Rational(tuple(found[: above + 1]), (1.0, *found[above + 1 :]))


@cache
def enclose(target: Target, fitted: Rational) -> float:
    """Bound the relative error of the function, from 0 to the end of its interval."""
    precision, length = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = BITS, ORDER + 2
    try:
        return _enclose(target, fitted)
    finally:
        ctx.prec, ctx.cap = precision, length


def _enclose(target: Target, fitted: Rational) -> float:
    with mp.workdps(DIGITS):
        half = arb(str(mp.sqrt(target.last()))) / (2 * PIECES)
    worst = 0.0
    for i in range(PIECES):
        # The first piece is expanded at 0, where both sides vanish with their argument.
        middle, reach = (half * (2 * i + 1), half) if i else (arb(0), 2 * half)
        ball = arb(middle.mid(), reach)
        _, true = target.sides(fitted, arb_series([middle, 1]))
        lowest = 1 if i == 0 and true.coeffs()[0] == 0 else 0
        near = _differ(target, fitted, middle)
        terms = [abs(c) * reach ** (k - lowest) for k, c in enumerate(near[:ORDER]) if k >= lowest]
        rest = abs(_differ(target, fitted, ball)[ORDER]) * reach ** (ORDER - lowest)
        _, size = target.sides(fitted, arb_series([ball, 1]))
        worst = max(worst, float((sum(terms, rest) / size.coeffs()[lowest].abs_lower()).upper()))
    return worst


def _differ(target: Target, fitted: Rational, place: arb) -> list[arb]:
    found, true = target.sides(fitted, arb_series([place, 1]))
    coefficients: list[arb] = (found - true).coeffs()
    return coefficients + [arb(0)] * (ORDER + 1 - len(coefficients))
