"""Coordinates over which the rounding errors of paper 1 are bounded."""

from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr, Interval, Rational, Symbol, oo, pi

from mechproof.record import Chart

from .symbols import R1, R2, e, phi1

# In all of them: x, the inverse of k, and the radius that scales both.
INVERSE, RADIUS, ANGLE_X = Symbol("1/k", positive=True), Symbol("R", positive=True), Symbol("x")
SIZES = {R1: RADIUS, R2: INVERSE * RADIUS, phi1: INVERSE * ANGLE_X}
UP_TO_HALF, UP_TO_LARGE = Interval(0, Rational(1, 2)), Interval(0, Rational(5, 8))
FREE = {INVERSE: Interval(0, 1), RADIUS: Interval(0, oo)}
PLAIN_CHART = Chart(
    "|x| <= 2**26",
    {**SIZES, e: e},
    {**FREE, ANGLE_X: Interval(0, 2**26), e: UP_TO_HALF},
    ANGLE_X,
)
# With e = 1 - d near 1, x and d are small together: which of x, d and x**2 is the smallest?
D, V, W, Y, Z = (Symbol(name) for name in ("d", "d/x**2", "x**2/d", "x/d", "d/x"))


def near_one(x: Expr, d: Expr, within: Mapping[Symbol, Interval]) -> Chart:
    """Make the chart of x and d by coordinates that may vanish."""
    return Chart("|x| <= 22/7", {**SIZES, phi1: INVERSE * x, e: 1 - d}, {**FREE, **within})


ECCENTRIC = (
    near_one(D * Y, D, {D: UP_TO_HALF, Y: Interval(0, 8)}),
    near_one(Z * W, Z**2 * W, {Z: Interval(0, Rational(1, 8)), W: Interval(0, 1)}),
    near_one(ANGLE_X, ANGLE_X**2 * V, {ANGLE_X: Interval(0, Rational(3, 4)), V: Interval(0, 1)}),
    near_one(ANGLE_X, D, {ANGLE_X: Interval(Rational(2, 3), Rational(22, 7)), D: UP_TO_HALF}),
)
ROUNDER = Chart(
    "|x| <= 22/7",
    {**SIZES, e: e},
    {**FREE, ANGLE_X: Interval(0, Rational(22, 7)), e: UP_TO_HALF},
)
# Beyond half a turn the low word is no share of what is left of x: next to whole turns so much is
# left out of e.
UP_TO_LIMIT = "|x| <= 2**26 and (e <= 1 - 2**-10 or |x - 2*pi*n| >= 2**-7 for all n)"


def far(rest: Expr, e_there: Expr, within: Mapping[Symbol, Interval]) -> Chart:
    """Make a chart of x by what is left of it after whole turns."""
    ranges = {**FREE, ANGLE_X: Interval(3, 2**26), **within}
    return Chart(UP_TO_LIMIT, {**SIZES, e: e_there}, ranges, ANGLE_X, rest)


# The peaks of the ratio are as wide as d: there x is a multiple of d, elsewhere d one of x.
FAR_FROM_PEAK = {Z: Interval(Rational(1, 2**7), Rational(22, 7)), W: Interval(0, Rational(1, 8))}
PEAKS = (
    far(
        D * Y,
        1 - D,
        {D: Interval(Rational(1, 2**10), Rational(3, 8)), Y: Interval(-8, 8)},
    ),
    far(Z, 1 - Z * W, FAR_FROM_PEAK),
    far(-Z, 1 - Z * W, FAR_FROM_PEAK),
)
ANY_REST = Interval(-Rational(22, 7), Rational(22, 7))
FAR, FAR_ECCENTRIC = (
    far(Z, e, {Z: ANY_REST, e: Interval(start, Rational(5, 8))}) for start in (0, Rational(1, 2))
)

# The acceleration vanishes with x, e, d and pi - x. Next to pi the low word is as large as what is
# left of x, and no bound sees that they belong together: so little is left out.
S = Symbol("pi - x")
OFF_PI = "|x| <= 22/7 and |pi - |x|| >= 2**-40"


def off_pi(rest: Expr, e_there: Expr, within: Mapping[Symbol, Interval]) -> Chart:
    """Make a chart of x next to half a turn."""
    off = {S: Interval(Rational(1, 2**40), Rational(1, 7))}
    ranges = {**FREE, ANGLE_X: Interval(0, Rational(22, 7)), **off, **within}
    return Chart(OFF_PI, {**SIZES, e: e_there}, ranges, ANGLE_X, pi + rest)


TO_PI = (
    near_one(D * Y, D, {D: Interval(0, Rational(3, 8)), Y: Interval(0, 8)}),
    *ECCENTRIC[1:3],
    near_one(ANGLE_X, D, {ANGLE_X: Interval(Rational(2, 3), 3), D: UP_TO_HALF}),
    Chart(OFF_PI, {**SIZES, e: e}, {**FREE, ANGLE_X: Interval(0, 3), e: UP_TO_LARGE}),
)
SMOOTH = (
    *(replace(chart, text=OFF_PI) for chart in TO_PI),
    *(off_pi(side, 1 - D, {D: UP_TO_HALF}) for side in (S, -S)),
    *(off_pi(side, e, {e: UP_TO_HALF}) for side in (S, -S)),
)
