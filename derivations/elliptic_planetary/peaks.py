"""Peaks of the acceleration and of the jerk of paper 1: where they occur, and how large they are.

By c = cos(x) the derivative of either changes its sign once at most: the place is named, and the
peak is the value there. Everything is written without differences of like numbers.
"""

from sympy import Abs, Eq, Expr, Ge, Max, Or, Piecewise, Rational, atan2, cos, diff, pi, sin, sqrt

from mechproof.record import SLOPES, Accuracy, Form, Periodicity, Quantity, Scale, Singular

from .kernels import (
    ACCELERATION,
    ARGUMENTS,
    ENDS_OF_E,
    EPS,
    EPS_X,
    LEAST,
    LOW_WORD,
    SINGULAR,
    SOURCE,
)
from .symbols import R1, R2, e, k, peak_acceleration, root_acceleration, root_jerk, square, x

JERK = diff(ACCELERATION, x) * k
SPREAD = 1 + e**2 - 2 * e * cos(x)

# Acceleration: it grows and falls with sin(x)/(square - 2 e c)**2, extreme where
# 2 e c**2 + square*c - 4 e = 0.
BOTH = square + root_acceleration
SMALLEST_ACCELERATION = (
    2
    * atan2(
        (1 - e) * sqrt(peak_acceleration),
        sqrt(BOTH + 8 * e),
    )
    / k
)
LARGEST_ACCELERATION = (
    2
    * e
    * k**2
    * (1 + e)
    * sqrt(peak_acceleration * (BOTH + 8 * e))
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
ANGLE_WITHIN = 2 * atan2(
    (1 - e) * sqrt((square + 10 * e) * (root_jerk + 2 * square - 2 * e)),
    (1 + e) * sqrt((10 * e - square) * (root_jerk + 2 * square + 2 * e)),
)
LARGEST_JERK = Piecewise((JERK_AT_HALF_TURN, AT_HALF_TURN), (JERK_WITHIN, True))
ANGLE_OF_JERK = Piecewise((pi, AT_HALF_TURN), (ANGLE_WITHIN, True)) / k

# Accuracy, in eps, every rounding 1/2 and all in one direction; atan2 within an ulp. square 0.75,
# root_acceleration 1.75, BOTH 2.25, peak_acceleration 2.7: the angle 6.7; the acceleration 19.5,
# of which the square in its denominator has 7.3. root_jerk 2: the largest jerk 21, the smallest 7.
# The jerk itself is a difference, of whose terms it has the accuracy;
# cos(x) is one itself, of the squares of the half angle's parts.
SIZES = (R1 >= LEAST, R2 >= LEAST, R1 <= 10**90 * R2)
# Beside half turns of x the jerk divides by a power of the tangent before it multiplies.
NO_UNDERFLOW = (Or(Eq(e, 0), Ge(e, Rational(1, 10**100))),)
EITHER_TERM = Scale(
    "the larger of the two terms, with 1 for cos(x), and what eps*x makes of them",
    2
    * e
    * k**3
    * (1 - e**2)
    * (
        Max(SPREAD, 4 * e * sin(x) ** 2) / SPREAD**3
        + EPS_X
        * Abs(sin(x))
        * (SPREAD**2 + 12 * e * Abs(cos(x)) * SPREAD + 24 * e**2 * sin(x) ** 2)
        / SPREAD**4
    ),
)
# Next to the threshold half a turn is left with the root of 10 e - square.
NEAR_THRESHOLD = Scale(
    "the value and what the rounding of 10*e - square makes of it",
    ANGLE_OF_JERK + 1 / (k * sqrt(Max(Abs(10 * e - square), EPS))),
)
OF_SIZES = f"extremes of the derivatives of {SOURCE}, equation (8)"


def of_sizes(
    name: str, summary: str, value: Expr, accuracy: Accuracy, singular: tuple[Singular, ...] = ()
) -> Quantity:
    """Make a quantity of the sizes alone."""
    return Quantity(
        name,
        summary,
        ARGUMENTS[1:],
        value,
        (Form("quotient", value),),
        OF_SIZES,
        unit="rad" if name.startswith("angle") else "1",
        accuracy=accuracy,
        singular=(*ENDS_OF_E, *singular),
        # At a threshold what is differentiated has a kink.
        slopes=None if singular else SLOPES,
    )


AT_THRESHOLD = (Singular(Eq(10 * e, square)),)
PEAK_QUANTITIES = (
    Quantity(
        "jerk",
        "Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.",
        ARGUMENTS,
        JERK,
        (
            Form(
                "half-angle quotient with low word",
                -2 * e * k**3 * (1 - e**2) * (cos(x) * SPREAD - 4 * e * sin(x) ** 2) / SPREAD**3,
                ("low_word", "half_angle_tangent"),
            ),
            Form("1 + e**2 - 2 e cos x", JERK, key="direct"),
        ),
        f"second derivative of {SOURCE}, equation (8)",
        accuracy=Accuracy(24, EITHER_TERM, (*LOW_WORD, *SIZES, *NO_UNDERFLOW)),
        singular=SINGULAR,
        periodicity=Periodicity(2 * pi / k),
    ),
    of_sizes(
        "largest_acceleration",
        "Compute the largest acceleration; the smallest is as far below zero.",
        LARGEST_ACCELERATION,
        Accuracy(20, within=SIZES),
    ),
    of_sizes(
        "angle_of_smallest_acceleration",
        "Compute phi1 where the acceleration is smallest; it is largest as far before 0.",
        SMALLEST_ACCELERATION,
        Accuracy(7, within=SIZES),
    ),
    of_sizes(
        "largest_jerk",
        "Compute the largest jerk, met at angle_of_largest_jerk to both sides of 0.",
        LARGEST_JERK,
        Accuracy(21, within=SIZES),
        AT_THRESHOLD,
    ),
    of_sizes(
        "smallest_jerk",
        "Compute the smallest jerk, met where the ratio is largest.",
        SMALLEST_JERK,
        Accuracy(7, within=SIZES),
    ),
    of_sizes(
        "angle_of_largest_jerk",
        "Compute the first phi1 from 0 on where the jerk is largest.",
        ANGLE_OF_JERK,
        Accuracy(8, NEAR_THRESHOLD, SIZES),
        AT_THRESHOLD,
    ),
)
