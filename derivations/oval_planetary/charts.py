"""Coordinates over which the rounding errors of paper 2 are bounded."""

from collections.abc import Mapping
from typing import NamedTuple

from sympy import Expr, Interval, Rational, Symbol, oo, pi

from mechproof.record import Chart

from .symbols import R4, R5, e2, phi1

# The radius that scales both, the smaller one as a share of it, or what it lacks, and x.
RADIUS, SHARE, LACK = (Symbol(name, positive=True) for name in ("R", "share", "lack"))
ANGLE_X = Symbol("x")
# With e = 1 - d near 1, x and d are small together: which of x, d and x**2 is the smallest?
D, V, W, Y, Z = (Symbol(name) for name in ("d", "d/x**2", "x**2/d", "x/d", "d/x"))
UP_TO_HALF, UP_TO_LARGE = Interval(0, Rational(1, 2)), Interval(0, Rational(5, 8))


class Wheels(NamedTuple):
    """The radii, how many times x/2 the angle of the carrier is, and the range of a share."""

    radii: Mapping[Symbol, Expr]
    inverse: Expr
    within: Mapping[Symbol, Interval]

    def chart(
        self,
        text: str,
        x: Expr,
        e: Expr,
        within: Mapping[Symbol, Interval],
        rest: Expr | None = None,
    ) -> Chart:
        """Make the chart of x and e2, or of x by what is left of it after whole turns."""
        arguments = {**self.radii, phi1: x * self.inverse / 2, e2: e}
        ranges = {**self.within, RADIUS: Interval(0, oo), **within}
        return Chart(text, arguments, ranges, None if rest is None else ANGLE_X, rest)


def divide(inverse: Expr, smaller: Expr, share: Symbol, within: Interval) -> tuple[Wheels, Wheels]:
    """Make the wheels of which 4 is the larger, and those of which 5 is."""
    larger = Wheels({R4: RADIUS, R5: smaller * RADIUS}, inverse, {share: within})
    return larger, Wheels({R4: smaller * RADIUS, R5: RADIUS}, 1 / inverse, {share: within})


ALL = divide(SHARE, SHARE, SHARE, Interval(0, 1))
UNLIKE = divide(SHARE, SHARE, SHARE, UP_TO_HALF)
ALIKE = divide(1 - LACK, 1 - LACK, LACK, UP_TO_HALF)

# Next to x = pi the low word is as large as what is left of x, and no bound sees that they belong
# together: so little is left out. Beyond half a turn x is known by it alone.
S = Symbol("pi - x")
OFF_PI = "|x| <= 22/7 and |pi - |x|| >= 2**-40"
BELOW_PI = (
    (D * Y, 1 - D, {D: Interval(0, Rational(3, 8)), Y: Interval(0, 8)}),
    (Z * W, 1 - Z**2 * W, {Z: Interval(0, Rational(1, 8)), W: Interval(0, 1)}),
    (ANGLE_X, 1 - ANGLE_X**2 * V, {ANGLE_X: Interval(0, Rational(3, 4)), V: Interval(0, 1)}),
    (ANGLE_X, 1 - D, {ANGLE_X: Interval(Rational(2, 3), 3), D: UP_TO_HALF}),
    (ANGLE_X, e2, {ANGLE_X: Interval(0, 3), e2: UP_TO_LARGE}),
)
NEAR_PI = {ANGLE_X: Interval(0, Rational(22, 7)), S: Interval(Rational(1, 2**40), Rational(1, 7))}
SMOOTH = tuple(
    chart
    for wheels in ALL
    for chart in (
        *(wheels.chart(OFF_PI, *place) for place in BELOW_PI),
        *(
            wheels.chart(OFF_PI, ANGLE_X, e, {**NEAR_PI, symbol: UP_TO_HALF}, pi + side)
            for e, symbol in ((1 - D, D), (e2, e2))
            for side in (S, -S)
        ),
    )
)

WITHIN_TURN = "|x| <= 22/7"
UP_TO_TURN = Interval(0, Rational(22, 7))
FIRST_TURN = (
    (D * Y, 1 - D, {D: UP_TO_HALF, Y: Interval(0, 8)}),
    *BELOW_PI[1:3],
    (ANGLE_X, 1 - D, {ANGLE_X: Interval(Rational(2, 3), Rational(22, 7)), D: UP_TO_HALF}),
    (ANGLE_X, e2, {ANGLE_X: UP_TO_TURN, e2: UP_TO_HALF}),
)
STEEP = tuple(wheels.chart(WITHIN_TURN, *place) for wheels in ALL for place in FIRST_TURN)

ROUND = "|x| <= 3 and e2 <= 1/2"
# What the plain product is for: e2 is no more than what the smaller radius lacks.
ANY_X = {ANGLE_X: Interval(0, 3)}
PLAIN = (
    *(wheels.chart(ROUND, ANGLE_X, e2, {**ANY_X, e2: UP_TO_HALF}) for wheels in UNLIKE),
    *(wheels.chart(ROUND, ANGLE_X, LACK * V, {**ANY_X, V: Interval(0, 1)}) for wheels in ALIKE),
)
NEGATED = ((phi1,),)
