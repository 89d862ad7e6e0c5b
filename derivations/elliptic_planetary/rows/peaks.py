"""Peaks of the acceleration and of the jerk of paper 1: where they occur, and how large they are.

In terms of c = cos(x) the derivative of either changes its sign at most once: the place is named,
and the peak is the value there. Everything is written without differences of nearly equal numbers.
"""

import sympy as sp

from mechproof.record import *

from ..mechanics import *

# Acceleration: it grows and falls with sin(x)/(square - 2 e c)**2, and is extreme where 2 e c**2 +
# square*c - 4 e = 0.
BOTH = square + root_acceleration
SMALLEST_ACCELERATION = (
    2 * sp.atan2((1 - e) * sp.sqrt(peak_acceleration), sp.sqrt(BOTH + 8 * e)) / k
)
LARGEST_ACCELERATION = (
    2
    * e
    * k**2
    * (1 + e)
    * sp.sqrt(peak_acceleration * (BOTH + 8 * e))
    * BOTH
    / ((1 - e) ** 2 * (BOTH + 2 * e * peak_acceleration) ** 2)
)

# Jerk: largest at half a turn of x up to e = 5 - 2*sqrt(6), beyond it where
# (2 e c)**2 + 4 square (2 e c) + square**2 - 24 e**2 = 0; smallest at whole turns.
AT_HALF_TURN = square >= 10 * e
SMALLEST_JERK = -2 * e * k**3 * (1 + e) / (1 - e) ** 3
JERK_AT_HALF_TURN = 2 * e * k**3 * (1 - e) / (1 + e) ** 3
JERK_WITHIN = (
    k**3
    * (square**2 + 32 * e**2)
    * (3 * square + root_jerk) ** 2
    / (36 * ((1 - e) * (1 + e)) ** 3 * (2 * root_jerk + 3 * square))
)
ANGLE_WITHIN = 2 * sp.atan2(
    (1 - e) * sp.sqrt((square + 10 * e) * (root_jerk + 2 * square - 2 * e)),
    (1 + e) * sp.sqrt((10 * e - square) * (root_jerk + 2 * square + 2 * e)),
)
LARGEST_JERK = sp.Piecewise((JERK_AT_HALF_TURN, AT_HALF_TURN), (JERK_WITHIN, True))
ANGLE_OF_JERK = sp.Piecewise((sp.pi, AT_HALF_TURN), (ANGLE_WITHIN, True)) / k

FACTOR = 2 * e * k**2 * (1 - e**2)
PROPER = Part("0 < e < 1", {e: sp.Interval.open(0, 1)})
BEYOND = Part("5 - 2 sqrt(6) < e < 1", {e: sp.Interval.open(5 - 2 * sp.sqrt(6), 1)})
UP_TO_THRESHOLD = Part("1 + e^2 >= 10 e", {e: sp.Interval.open(0, 1)}, (1 + e**2 >= 10 * e,))

# In terms of c = cos(x): factors that have the sign of the derivatives.
turn_of_acceleration = 2 * e * c**2 + square * c - 4 * e
jerk_by_c = turn_of_acceleration / (square - 2 * e * c) ** 3
turn_of_jerk = (2 * e * c) ** 2 + 4 * square * (2 * e * c) + square**2 - 24 * e**2

T2_ACCELERATION = (1 - e) ** 2 * peak_acceleration / (BOTH + 8 * e)
T2_JERK = (
    (1 - e) ** 2
    * (square + 10 * e)
    * (root_jerk + 2 * square - 2 * e)
    / ((1 + e) ** 2 * (10 * e - square) * (root_jerk + 2 * square + 2 * e))
)
C_ACCELERATION = (root_acceleration - square) / (4 * e)
C_JERK = (root_jerk - 2 * square) / (2 * e)


def cosine_of(t_squared: sp.Expr) -> sp.Expr:
    """Return the cosine of an angle from the square of the tangent of its half."""
    return (1 - t_squared) / (1 + t_squared)


ROWS = (
    ours(
        "acceleration, where it turns",
        r"\frac{d\varphi_3''}{dx}=-2e\left(\tfrac{R_1}{R_2}\right)^2(1-e^2)"
        r"\frac{2e\cos^2x+(1+e^2)\cos x-4e}{(1+e^2-2e\cos x)^3},\ "
        r"\cos x=\frac{-(1+e^2)+\sqrt{(1+e^2)^2+32e^2}}{4e}",
        all_of(
            Equality(sp.diff(ACCELERATION, x), -FACTOR * jerk_by_c.subs(c, sp.cos(x))),
            less(turn_of_acceleration.subs(c, -1), 0 * e),
            less(0 * e, turn_of_acceleration.subs(c, 1)),
            Equality(sp.diff(turn_of_acceleration, c, 2), 4 * e),
            Equality(turn_of_acceleration.subs(c, C_ACCELERATION), 0 * e),
            Equality(C_ACCELERATION, 8 * e / BOTH),
            less(0 * e, 8 * e / BOTH),
        ),
        note="The numerator is convex in cos(x), below zero at -1 and above it at 1: it has one "
        "root in between. The acceleration is odd in x: smallest at this x, largest at -x.",
        on=PROPER,
        quantities=("largest_acceleration", "angle_of_smallest_acceleration"),
    ),
    ours(
        "acceleration, where it is extreme, without cancellation",
        r"\mathrm{tg}^2\frac x2=\frac{1-\cos x}{1+\cos x}",
        Equality(cosine_of(T2_ACCELERATION), C_ACCELERATION),
        on=PROPER,
        quantities=("largest_acceleration", "angle_of_smallest_acceleration"),
    ),
    ours(
        "acceleration, how large it is",
        r"(\varphi_3'')^2\text{ at this }\cos x",
        Equality(
            LARGEST_ACCELERATION**2,
            FACTOR**2 * (1 - C_ACCELERATION**2) / (square - 2 * e * C_ACCELERATION) ** 4,
        ),
        on=PROPER,
        quantities=("largest_acceleration",),
    ),
    ours(
        "jerk, where it turns",
        r"\varphi_3'''=-2e\left(\tfrac{R_1}{R_2}\right)^3(1-e^2)\frac{2ec^2+(1+e^2)c-4e}"
        r"{(1+e^2-2ec)^3},\ c=\cos x;\ \frac{d}{dc}\text{ of the quotient}=\frac{4e^2c^2"
        r"+8e(1+e^2)c+(1+e^2)^2-24e^2}{(1+e^2-2ec)^4}",
        all_of(
            Equality(JERK, -k * FACTOR * jerk_by_c.subs(c, sp.cos(x))),
            Equality(sp.diff(jerk_by_c, c), turn_of_jerk / (square - 2 * e * c) ** 4),
            Equality(turn_of_jerk.subs(c, C_JERK), 0 * e),
            less(0 * e, turn_of_jerk.subs(c, 1)),
            less(0 * e, sp.diff(turn_of_jerk, c)),
            Equality(SMALLEST_JERK, -k * FACTOR * jerk_by_c.subs(c, 1)),
        ),
        note="The numerator rises from c = -1 to c = 1, where it is above zero: the jerk is "
        "smallest there, at whole turns of x.",
        on=PROPER,
        quantities=("jerk", "smallest_jerk", "largest_jerk", "angle_of_largest_jerk"),
    ),
    ours(
        "jerk, largest at half a turn",
        r"e\le5-2\sqrt6:\ \max\varphi_3'''=2e\left(\tfrac{R_1}{R_2}\right)^3"
        r"\frac{1-e}{(1+e)^3},\ x=\pi",
        all_of(
            Equality(turn_of_jerk.subs(c, -1), (square - 10 * e) * (1 + e) ** 2),
            Equality(JERK_AT_HALF_TURN, -k * FACTOR * jerk_by_c.subs(c, -1)),
        ),
        note="There the numerator is nowhere below zero; it is zero at 1 + e^2 = 10 e, c = -1.",
        on=UP_TO_THRESHOLD,
        quantities=("largest_jerk", "angle_of_largest_jerk"),
    ),
    ours(
        "jerk, largest before half a turn",
        r"\cos x=\frac{-2(1+e^2)+\sqrt{3(1+e^2)^2+24e^2}}{2e},\ "
        r"\mathrm{tg}^2\frac x2=\frac{1-\cos x}{1+\cos x},\text{ and the jerk there}",
        all_of(
            less(turn_of_jerk.subs(c, -1), 0 * e),
            Equality(cosine_of(T2_JERK), C_JERK),
            Equality(JERK_WITHIN, -k * FACTOR * jerk_by_c.subs(c, C_JERK)),
        ),
        on=BEYOND,
        quantities=("largest_jerk", "angle_of_largest_jerk"),
    ),
)
