"""What paper 3 prints of its wheel, in numbers (mm, unless said otherwise), and ISO tolerances."""

from __future__ import annotations

from sympy import Expr, Interval, Rational, S, pi, sqrt

from mechproof.record import Equation, Part, list_given

from .geometry import across
from .symbols import (
    READER,
    VARIABLES,
    E_cs,
    K,
    T_c,
    alpha,
    clearance,
    dh,
    interval,
    m,
    millimetre,
    tilt,
    z,
)

PROFILE_ANGLE = pi / 9
MODULE, TEETH = 3, 50
WHEEL = {m: S(MODULE), z: S(TEETH), alpha: PROFILE_ANGLE}
EQUATION_1 = Equation("(1), influence 0.7284", r"\Delta S_c=0.7284\,\Delta h")
PRINTED_INFLUENCE = READER.members(EQUATION_1)[1].coeff(dh)
DECREASE_UM, TOLERANCE_UM, GAUGE_UM, K_PRINTED = 12, 45, 50, 6
RECOMMENDED_UM = 2
PRINTED_SIZES = {
    **WHEEL,
    E_cs: Rational(DECREASE_UM, 1000),
    T_c: Rational(TOLERANCE_UM, 1000),
    interval: Rational(GAUGE_UM, 1000),
    K: S(K_PRINTED),
    clearance: S.Zero,
    millimetre: S.One,
}

# Tilts (rad) that turn the tangent over 1 mm and over 0.1 mm of height.
WIDE, NARROW = Rational(1, 20), Rational(1, 260)
HEIGHTS_TO_1_MM = Part("heights off by up to 1 mm, tilts of both signs", {tilt: Interval(0, WIDE)})
HEIGHTS_TO_0_1_MM = Part("heights off by up to 0.1 mm", {tilt: Interval(0, NARROW)})

# ISO 286-1: i = 0.45 D^(1/3) + 0.001 D (um; D in mm, the geometric mean of the range 120 to 180).
RANGE = (120, 180)
TIP_DIAMETER = MODULE * (TEETH + 2)
RANGE_MEAN = sqrt(RANGE[0] * RANGE[1])
TOLERANCE_UNIT = Rational("0.45") * RANGE_MEAN ** Rational(1, 3) + Rational("0.001") * RANGE_MEAN
GRADES = {6: (10, 25), 7: (16, 40), 8: (25, 63)}


def of_wheel(expression: Expr) -> Expr:
    """Put the printed wheel into an expression."""
    return expression.subs(list_given(VARIABLES)).subs(WHEEL)


def at_angle(expression: Expr, degrees: int | str) -> Expr:
    """Put the printed module and a profile angle in degrees into an expression."""
    return expression.subs({m: MODULE, alpha: Rational(degrees) * pi / 180})


excess_of_wheel = of_wheel(m * z * across)
