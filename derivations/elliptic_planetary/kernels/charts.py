"""Coordinates in which the rounding errors of paper 1 are bounded."""

from sympy import Expr, Interval, Rational, Symbol, oo

from mechproof.record import Chart

from ..._eccentric import (
    ANGLE_X,
    OFF_PI,
    UP_TO_HALF,
    WITHIN_TURN,
    D,
    Ranges,
    W,
    Y,
    Z,
    below_pi,
    first_turn,
    first_turn_of_jerk,
    next_to_pi,
)
from ..mechanics import *

# Common to all: x, the inverse of k, and the radius that scales both.
INVERSE, RADIUS = Symbol("1/k", positive=True), Symbol("R", positive=True)
RADII = {R1: RADIUS, R2: INVERSE * RADIUS}
SIZES = {**RADII, phi1: INVERSE * ANGLE_X}
FREE = {INVERSE: Interval(0, 1), RADIUS: Interval(0, oo)}
# Up to here k*phi1 needs no low word.
MOST_PLAIN = Rational(12, 25)
PLAIN_CHART = Chart(
    "|x| <= 2**26",
    {**SIZES, e: e},
    {**FREE, ANGLE_X: Interval(0, 2**26), e: Interval(0, MOST_PLAIN)},
    ANGLE_X,
)


def chart(text: str, x: Expr, there: Expr, within: Ranges, rest: Expr | None = None) -> Chart:
    """Return the chart of x and e, or of x by its remainder after whole turns."""
    arguments = {**SIZES, phi1: INVERSE * x, e: there}
    return Chart(text, arguments, {**FREE, **within}, None if rest is None else ANGLE_X, rest)


OF_JERK = tuple(chart(WITHIN_TURN, *place) for place in first_turn_of_jerk(e))
*ECCENTRIC, ROUNDER = (chart(WITHIN_TURN, *place) for place in first_turn(e))
# Beyond half a turn the low word is not a share of the remainder of x: next to whole turns a range
# of e is left out.
UP_TO_LIMIT = "|x| <= 2**26 and (e <= 1 - 2**-10 or |x - 2*pi*n| >= 2**-7 for all n)"


def far(rest: Expr, there: Expr, within: Ranges) -> Chart:
    """Return a chart of x by its remainder after whole turns."""
    return chart(UP_TO_LIMIT, ANGLE_X, there, {ANGLE_X: Interval(3, 2**26), **within}, rest)


# The peaks of the ratio are as wide as d: there x is a multiple of d, elsewhere d is one of x.
FAR_FROM_PEAK = {Z: Interval(Rational(1, 2**7), Rational(22, 7)), W: Interval(0, Rational(1, 8))}
PEAKS = (
    far(D * Y, 1 - D, {D: Interval(Rational(1, 2**10), Rational(3, 8)), Y: Interval(-8, 8)}),
    far(Z, 1 - Z * W, FAR_FROM_PEAK),
    far(-Z, 1 - Z * W, FAR_FROM_PEAK),
)
ANY_REST = Interval(-Rational(22, 7), Rational(22, 7))
FAR = far(Z, e, {Z: ANY_REST, e: Interval(0, Rational(5, 8))})

# The acceleration vanishes with x, e, d and pi - x.
SMOOTH = tuple(chart(OFF_PI, *place) for place in (*below_pi(e), *next_to_pi(e)))

# The extremes, by e and by 1 - e.
BY_SIZES = tuple(
    Chart("", {**RADII, e: there}, {**FREE, part: UP_TO_HALF})
    for there, part in ((e, e), (1 - D, D))
)
# The same, on both sides of the threshold 5 - 2*sqrt(6) of the largest jerk, where another formula
# begins.
BEFORE, BEHIND = "101/1000", "102/1000"
BESIDE_THRESHOLD = tuple(
    Chart(f"e <= {BEFORE} or e >= {BEHIND}", {**RADII, e: there}, {**FREE, part: within})
    for there, part, within in (
        (e, e, Interval(0, Rational(BEFORE))),
        (e, e, Interval(Rational(BEHIND), UP_TO_HALF.end)),
        (1 - D, D, UP_TO_HALF),
    )
)
