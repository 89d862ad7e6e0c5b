"""Peaks of the acceleration and of the jerk of paper 1: where they occur, and how large they are.

By c = cos(x) the derivative of either changes its sign once at most: the place is named, and the
peak is the value there. Everything is written without differences of like numbers.
"""

import sympy as sp

from mechproof.record import *

from .._eccentric import jerk_terms
from . import kernels
from .charts import BESIDE_THRESHOLD, BY_SIZES, OF_JERK
from .mechanics import *

JERK = sp.diff(kernels.ACCELERATION, x) * k
SPREAD = 1 + e**2 - 2 * e * sp.cos(x)

# Acceleration: it grows and falls with sin(x)/(square - 2 e c)**2, extreme where
# 2 e c**2 + square*c - 4 e = 0.
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

# Accuracy, in eps, every rounding 1/2 and all in one direction; atan2 within an ulp. square 0.75,
# root_acceleration 1.75, BOTH 2.25, peak_acceleration 2.7: the angle 6.7; the acceleration 19.5,
# of which the square in its denominator has 7.3. root_jerk 2: the largest jerk 21, the smallest 7.
# The jerk itself is a difference, of whose terms it has the accuracy;
# cos(x) is one itself, of the squares of the half angle's parts.
# The cube of R1/R2 over the fifth power of 1 - e is met on the way, and is a double.
SIZES = (R1 >= kernels.LEAST, R2 >= kernels.LEAST, R1 <= 10**75 * R2)
# Beside half turns of x the jerk divides by a power of the tangent before it multiplies.
NO_UNDERFLOW = (sp.Or(sp.Eq(e, 0), sp.Ge(e, sp.Rational(1, 10**100))),)
EITHER_TERM = Scale(
    "the larger of the two terms, with 1 for cos(x), and what eps*x makes of them",
    jerk_terms(2 * e * k**3 * (1 - e**2), e, x, kernels.EPS_X),
)
# Next to the threshold half a turn is left with the root of 10 e - square.
NEAR_THRESHOLD = Scale(
    "the value and what the rounding of 10*e - square makes of it",
    ANGLE_OF_JERK + 1 / (k * sp.sqrt(sp.Max(sp.Abs(10 * e - square), kernels.EPS))),
)
OF_SIZES = f"extremes of the derivatives of {kernels.SOURCE}, equation (8)"


def of_sizes(
    name: str,
    summary: str,
    value: sp.Expr,
    accuracy: Accuracy,
    singular: tuple[Singular, ...] = (),
    charts: tuple[Chart, ...] = (),
) -> Quantity:
    """Make a quantity of the sizes alone."""
    return Quantity(
        name,
        summary,
        kernels.ARGUMENTS[1:],
        value,
        (Form("quotient", value, charts=charts),),
        OF_SIZES,
        unit="rad" if name.startswith("angle") else "1",
        accuracy=accuracy,
        singular=(*kernels.ENDS_OF_E, *singular),
        # At a threshold what is differentiated has a kink.
        slopes=None if singular else SLOPES,
    )


AT_THRESHOLD = (Singular(sp.Eq(10 * e, square)),)
PEAK_QUANTITIES = (
    Quantity(
        "jerk",
        "Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.",
        kernels.ARGUMENTS,
        JERK,
        (
            Form(
                "half-angle quotient with low word",
                -2
                * e
                * k**3
                * (1 - e**2)
                * (sp.cos(x) * SPREAD - 4 * e * sp.sin(x) ** 2)
                / SPREAD**3,
                ("low_word", "half_angle_tangent"),
                charts=OF_JERK,
                mirrors=((phi1,),),
            ),
            Form("1 + e**2 - 2 e cos x", JERK, key="direct"),
        ),
        f"second derivative of {kernels.SOURCE}, equation (8)",
        accuracy=Accuracy(24, EITHER_TERM, (*kernels.LOW_WORD, *SIZES, *NO_UNDERFLOW)),
        singular=kernels.SINGULAR,
        periodicity=Periodicity(2 * sp.pi / k),
    ),
    of_sizes(
        "largest_acceleration",
        "Compute the largest acceleration; the smallest is its negative.",
        LARGEST_ACCELERATION,
        Accuracy(20, within=SIZES),
        charts=BY_SIZES,
    ),
    of_sizes(
        "angle_of_smallest_acceleration",
        "Compute the first phi1 >= 0 where the acceleration is smallest; at -phi1 it is largest.",
        SMALLEST_ACCELERATION,
        Accuracy(7, within=SIZES),
        charts=BY_SIZES,
    ),
    of_sizes(
        "largest_jerk",
        "Compute the largest jerk, which it has at phi1 = angle_of_largest_jerk and -phi1.",
        LARGEST_JERK,
        Accuracy(21, within=SIZES),
        AT_THRESHOLD,
        BESIDE_THRESHOLD,
    ),
    of_sizes(
        "smallest_jerk",
        "Compute the smallest jerk, met where the ratio is largest.",
        SMALLEST_JERK,
        Accuracy(7, within=SIZES),
        charts=BY_SIZES,
    ),
    of_sizes(
        "angle_of_largest_jerk",
        "Compute the first phi1 >= 0 where the jerk is largest.",
        ANGLE_OF_JERK,
        Accuracy(8, NEAR_THRESHOLD, SIZES),
        AT_THRESHOLD,
        BESIDE_THRESHOLD,
    ),
)


# Why they are there -------------------------------------------------------------------------------

FACTOR = 2 * e * k**2 * (1 - e**2)
PROPER = Part("0 < e < 1", {e: sp.Interval.open(0, 1)})
BEYOND = Part("5 - 2 sqrt(6) < e < 1", {e: sp.Interval.open(5 - 2 * sp.sqrt(6), 1)})
UP_TO_THRESHOLD = Part("1 + e^2 >= 10 e", {e: sp.Interval.open(0, 1)}, (1 + e**2 >= 10 * e,))

# By c = cos(x): what the derivatives have the sign of.
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
    """Cosine of an angle by the square of the tangent of its half."""
    return (1 - t_squared) / (1 + t_squared)


PEAK_ROWS = (
    ours(
        "acceleration, where it turns",
        r"\frac{d\varphi_3''}{dx}=-2e\left(\tfrac{R_1}{R_2}\right)^2(1-e^2)"
        r"\frac{2e\cos^2x+(1+e^2)\cos x-4e}{(1+e^2-2e\cos x)^3},\ "
        r"\cos x=\frac{-(1+e^2)+\sqrt{(1+e^2)^2+32e^2}}{4e}",
        all_of(
            Equality(sp.diff(kernels.ACCELERATION, x), -FACTOR * jerk_by_c.subs(c, sp.cos(x))),
            less(turn_of_acceleration.subs(c, -1), 0 * e),
            less(0 * e, turn_of_acceleration.subs(c, 1)),
            Equality(sp.diff(turn_of_acceleration, c, 2), 4 * e),
            Equality(turn_of_acceleration.subs(c, C_ACCELERATION), 0 * e),
            Equality(C_ACCELERATION, 8 * e / BOTH),
            less(0 * e, 8 * e / BOTH),
        ),
        note="The numerator is convex in cos(x), below zero at -1 and above it at 1: it has one "
        "root between. The acceleration is odd in x, so it is smallest there and largest as far "
        "before x = 0.",
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
