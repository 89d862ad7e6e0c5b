"""Coordinates in which the rounding errors of paper 2 are bounded."""

from collections.abc import Mapping
from typing import NamedTuple

from sympy import Expr, Integer, Interval, Rational, Symbol, oo

from mechproof.record import Chart

from ..._eccentric import (
    ANGLE_X,
    OFF_PI,
    UP_TO_HALF,
    WITHIN_TURN,
    Ranges,
    V,
    below_pi,
    first_turn,
    first_turn_of_jerk,
    next_to_pi,
)
from ..mechanics import R4, R5, e1, e2, mount, phi1

# The radius that scales both, the smaller one as a share of it, or the share that it lacks, and x.
RADIUS, SHARE, LACK = (Symbol(name, positive=True) for name in ("R", "share", "lack"))


class Wheels(NamedTuple):
    """The radii, the angle of the carrier as a multiple of x/2, and the range of a share."""

    radii: Mapping[Symbol, Expr]
    inverse: Expr
    within: Mapping[Symbol, Interval]

    def chart(self, text: str, x: Expr, e: Expr, within: Ranges, rest: Expr | None = None) -> Chart:
        """Return the chart of x and e2, or of x by its remainder after whole turns."""
        arguments = {**self.radii, phi1: x * self.inverse / 2, e2: e}
        ranges = {**self.within, RADIUS: Interval(0, oo), **within}
        return Chart(text, arguments, ranges, None if rest is None else ANGLE_X, rest)


def divide(inverse: Expr, smaller: Expr, share: Symbol, within: Interval) -> tuple[Wheels, Wheels]:
    """Return the wheels of which 4 is the larger, and those of which 5 is."""
    larger = Wheels({R4: RADIUS, R5: smaller * RADIUS}, inverse, {share: within})
    return larger, Wheels({R4: smaller * RADIUS, R5: RADIUS}, 1 / inverse, {share: within})


ALL = divide(SHARE, SHARE, SHARE, Interval(0, 1))
UNLIKE = divide(SHARE, SHARE, SHARE, UP_TO_HALF)
ALIKE = divide(1 - LACK, 1 - LACK, LACK, UP_TO_HALF)

SMOOTH = tuple(
    wheels.chart(OFF_PI, *place) for wheels in ALL for place in (*below_pi(e2), *next_to_pi(e2))
)
STEEP = tuple(wheels.chart(WITHIN_TURN, *place) for wheels in ALL for place in first_turn(e2))
OF_JERK = tuple(
    wheels.chart(WITHIN_TURN, *place) for wheels in ALL for place in first_turn_of_jerk(e2)
)

ROUND = "|x| <= 3 and e2 <= 1/2"
# The domain of the plain product: e2 is at most the share that the smaller radius lacks.
ANY_X = {ANGLE_X: Interval(0, 3)}
PLAIN = (
    *(wheels.chart(ROUND, ANGLE_X, e2, {**ANY_X, e2: UP_TO_HALF}) for wheels in UNLIKE),
    *(wheels.chart(ROUND, ANGLE_X, LACK * V, {**ANY_X, V: Interval(0, 1)}) for wheels in ALIKE),
)
NEGATED = ((phi1,),)

# Two pairs of ovals mounted as printed: by the larger eccentricity.
LARGER, BEFORE_POLE = Symbol("larger", positive=True), Rational(3, 2)


def mounted(flattest: Expr) -> tuple[Chart, ...]:
    """Return the charts of pairs whose eccentricities are at most `flattest`."""
    return tuple(
        Chart(
            f"mount = 0, |phi1| <= {BEFORE_POLE} and e1, e2 <= {flattest}",
            {phi1: ANGLE_X, one: LARGER, other: LARGER * SHARE, mount: Integer(0)},
            {
                ANGLE_X: Interval(0, BEFORE_POLE),
                LARGER: Interval(0, flattest),
                SHARE: Interval(0, 1),
            },
        )
        for one, other in ((e1, e2), (e2, e1))
    )


MOUNTED = mounted(UP_TO_HALF.end)
# The jerk is a sum of more terms, whose enclosures over boxes are wider.
MOUNTED_ROUNDER = mounted(Rational(1, 4))
MOUNTED_NEGATED = ((phi1, mount),)
