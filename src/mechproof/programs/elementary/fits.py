"""Rational approximations: in, a function and an interval; out, coefficients and an error bound.

Coefficients are interpolated in balls, and are the same numbers on every machine. The error is
enclosed over the whole interval by Taylor polynomials in balls. Sollya (Chevillard, Harrison,
Joldes and Lauter 2011) certifies the supremum norm of an error in the same way, with intervals for
coefficients.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache, partial
from itertools import pairwise

from flint import arb, arb_mat, arb_series

from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import Series, list_terms, working
from mechproof.programs.elementary.formats import DOUBLE, Format, take_middle

# Share by which intervals are extended, to cover the rounding of reduced arguments.
MARGIN = 2.0**-20
PIECES, ORDER, BITS = 64, 24, 256
# Precision, in bits, of linear equations in powers, up to a hundred, of numbers close to each
# other, which lose far fewer bits.
FIT_BITS = 600
# A piece is halved while the remainder of its Taylor polynomial exceeds this share of the value.
REST = 2.0**-70
# Centre of the variable (x - TAIL)/(x + TAIL): near this value, polynomials in the variable need
# the fewest terms.
TAIL = 6.0
# Beyond this argument the tail of the normal law is less than the smallest double.
TAIL_END = 39.0
Sides = Callable[[arb_series], tuple[arb_series, arb_series]]


@dataclass(frozen=True)
class Rational:
    """Coefficients of a quotient of polynomials, lowest power first."""

    above: tuple[float, ...]
    below: tuple[float, ...]


@dataclass(frozen=True)
class Target:
    """A function to approximate in the square of its argument, from 0 to `last`.

    `sides` computes the whole function by a quotient, and the true one, both times a factor that
    makes the one a polynomial and the other entire or analytic. With a `first`, the function is
    approximated in the argument itself, from there on.
    """

    meaning: str
    last: Callable[[], Ball]
    sides: Callable[[Rational, arb_series], tuple[arb_series, arb_series]]
    first: float | None = None

    def value(self, place: Ball) -> Ball:
        """Return the value that the quotient must have at a place to make both sides equal."""
        argument = arb_series([place if self.first is not None else place.sqrt()])
        zero, true = self.sides(Rational((0.0,), (1.0,)), argument)
        one, _ = self.sides(Rational((1.0,), (1.0,)), argument)
        return list_terms((true - zero) / (one - zero))[0]


def _beyond(end: Ball) -> Ball:
    return ((1 + MARGIN) * end) ** 2


def _put(coefficients: tuple[float, ...], z: arb_series) -> arb_series:
    value = arb_series([0])
    for number in reversed(coefficients):
        value = value * z + arb(number)
    return value


def _cosine_sides(fit: Rational, r: arb_series) -> tuple[arb_series, arb_series]:
    z = r * r
    return 1 - z / 2 + z * z * _put(fit.above, z), r.cos()


def _arctangent_sides(fit: Rational, y: arb_series) -> tuple[arb_series, arb_series]:
    z = y * y
    below = _put(fit.below, z)
    return y * below + y * z * _put(fit.above, z), below * y.atan()


def _tail_sides(fit: Rational, t: arb_series) -> tuple[arb_series, arb_series]:
    x = TAIL * (1 + t) / (1 - t)
    return _put(fit.above, t), (1 + x) * (x * x / 2).exp() * (x / arb(2).sqrt()).erfc() / 2


TANGENT = Target(
    "tan(r)/r in powers of r**2, |r| <= pi/4",
    lambda: _beyond(arb.pi() / 4),
    lambda fit, r: (r * _put(fit.above, r * r) * r.cos(), _put(fit.below, r * r) * r.sin()),
)
SINE = Target(
    "(sin(r)/r - 1)/r**2 in powers of r**2, |r| <= pi/4",
    lambda: _beyond(arb.pi() / 4),
    lambda fit, r: (r + r * r * r * _put(fit.above, r * r), r.sin()),
)
COSINE = Target(
    "(cos(r) - 1 + r**2/2)/r**4 in powers of r**2, |r| <= pi/4",
    lambda: _beyond(arb.pi() / 4),
    _cosine_sides,
)
ARCTANGENT = Target(
    "(atan(y)/y - 1)/y**2 in powers of y**2, |y| <= 1",
    lambda: _beyond(arb(1)),
    _arctangent_sides,
)
SMALL_ARCTANGENT = Target(
    "(atan(y)/y - 1)/y**2 in powers of y**2",
    lambda: arb(1) / 3 * (1 + MARGIN),
    _arctangent_sides,
)
ODD_EXPONENTIAL = Target(
    "(sinh(r)/r - 1)/r**2 in powers of r**2, |r| <= log(2)/2",
    lambda: _beyond(arb(2).log() / 2),
    lambda fit, r: (r + r * r * r * _put(fit.above, r * r), (r.exp() - (-r).exp()) / 2),
)
EVEN_EXPONENTIAL = Target(
    "(cosh(r) - 1)/r**2 in powers of r**2, |r| <= log(2)/2",
    lambda: _beyond(arb(2).log() / 2),
    lambda fit, r: (1 + r * r * _put(fit.above, r * r), (r.exp() + (-r).exp()) / 2),
)
NORMAL_TAIL = Target(
    f"(1 + x)*exp(x**2/2)*tail by (x - {TAIL:g})/(x + {TAIL:g}), x <= {TAIL_END:g}",
    lambda: arb(TAIL_END - TAIL) / (TAIL_END + TAIL),
    _tail_sides,
    first=-1.0,
)


def interpolate(
    function: Callable[[Ball], Ball],
    centre: Ball,
    reach: Ball,
    powers: range,
    below: range = range(0),
) -> list[Ball]:
    """Return the coefficients of `powers`, then of those `below`, in a denominator 1 + ....

    The nodes are the interval's Chebyshev nodes; for odd powers, the positive ones. The largest
    error is then within a small factor of that of the best quotient (Trefethen 2013, chapter 15),
    which the exchange algorithm of Remez (1934) would find. The caller sets the working precision
    to `FIT_BITS`.
    """
    count = len(powers) + len(below)
    angles = (arb.pi() * (2 * i + 1) / (2 * count * powers.step) for i in range(count))
    nodes = [centre + reach * angle.cos() for angle in angles]
    values = [function(node) for node in nodes]
    rows = [
        [z**power for power in powers] + [-value * z**power for power in below]
        for z, value in zip(nodes, values, strict=True)
    ]
    solution = arb_mat(rows).solve(arb_mat([[value] for value in values]))
    return [solution[i, 0] for i in range(count)]


def expand_about(middle: Ball, reach: Ball) -> tuple[Series, Series]:
    """Return the variable as series in shares of `reach`: at the middle, and over the interval."""
    return arb_series([middle, reach]), arb_series([arb(middle, reach.upper()), reach])


def bound_terms(near: Series, far: Series) -> list[Ball]:
    """Bound the terms of a result, given both series; the last bound is over the interval."""
    return [*map(abs, list_terms(near)[:-1]), abs(list_terms(far)[-1])]


@cache
def fit(target: Target, above: int, below: int = 0, form: Format = DOUBLE) -> Rational:
    """Interpolate a target by a quotient of polynomials of degrees `above` and `below`.

    The coefficients are rounded to the format; the constant below is 1.
    """
    with working(1, FIT_BITS):
        first = arb(target.first or 0)
        half = (target.last() - first) / 2
        degrees = range(above + 1), range(1, below + 1)
        found = [*map(take_middle, interpolate(target.value, first + half, half, *degrees))]
    rounded = tuple(map(form.round, found))
    return Rational(rounded[: above + 1], (1.0, *rounded[above + 1 :]))


@cache
def enclose(target: Target, fitted: Rational) -> float:
    """Bound the relative error of the fitted function over the target's interval."""
    with working(ORDER + 1, BITS):
        last = target.last().sqrt() if target.first is None else target.last()
        first = arb(target.first or 0)
        step = (last - first) / PIECES
        ends = [first + step * i for i in range(PIECES + 1)]
    return max(enclose_pieces(partial(target.sides, fitted), pairwise(ends)))


def enclose_pieces(sides: Sides, pieces: Iterable[tuple[arb, arb]]) -> list[float]:
    """Bound the relative difference of two sides on each interval; infinite if it has no bound.

    Both may vanish with their argument at 0, if an interval begins there.
    """
    bounds = []
    with working(ORDER + 1, BITS):
        for low, high in pieces:
            half = (high - low) / 2
            # A piece that begins at 0 is expanded there, where both sides may vanish.
            place = (low, high) if low == 0 else (low + half, half)
            bounds.append(_enclose_piece(sides, *place))
    return bounds


def _enclose_piece(sides: Sides, middle: arb, reach: arb) -> float:
    near, far = map(sides, expand_about(middle, reach))
    vanishes = [bool(side[0] == 0) for side in near]
    if vanishes[1] and not vanishes[0]:
        return math.inf
    # If both sides vanish at 0, only the terms from the second on count.
    first = 1 if vanishes[1] else 0
    off = bound_terms(near[0] - near[1], far[0] - far[1])[first:]
    leading, *others = bound_terms(near[1], far[1])[first:]
    least = leading - sum(others, arb(0))
    if not off[-1] < least * REST:
        halves = (middle - reach / 2, middle + reach / 2)
        return max(_enclose_piece(sides, side, reach / 2) for side in halves)
    return float((sum(off, arb(0)) / least).upper())
