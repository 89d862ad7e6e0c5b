"""Quantities of peaks of paper 1: the jerk, extremes of acceleration and jerk, and their places."""

import sympy as sp

from mechproof.record import *

from ..._algebra import EPS
from ..._eccentric import by_half_angle, directly, jerk_quotient, jerk_scale
from ..mechanics import *
from ..rows import peaks
from . import motion
from .charts import BESIDE_THRESHOLD, BY_SIZES, OF_JERK

# Accuracy, in eps, every rounding 1/2 and all in one direction; atan2 within an ulp. square 0.75,
# root_acceleration 1.75, BOTH 2.25, peak_acceleration 2.7: the angle 6.7; the acceleration 19.5, of
# which the square in its denominator makes 7.3. root_jerk 2: the largest jerk 21, the smallest 7.
# The jerk itself is a difference, with an accuracy relative to its terms; cos(x) is itself one, of
# the squares of the half angle's parts.
# The cube of R1/R2 over the fifth power of 1 - e occurs on the way, and is a double.
SIZES = (R1 >= motion.LEAST, R2 >= motion.LEAST, R1 <= 10**75 * R2)
# Next to half turns of x the jerk divides by a power of the tangent before it multiplies.
NO_UNDERFLOW = (sp.Or(sp.Eq(e, 0), sp.Ge(e, sp.Rational(1, 10**100))),)
EITHER_TERM = jerk_scale(2 * e * k**3 * (1 - e**2), e, x, motion.EPS_X)
# Next to the threshold, the remainder to half a turn goes with the root of 10 e - square.
NEAR_THRESHOLD = Scale(
    "the value and the effect of rounding 10*e - square",
    peaks.ANGLE_OF_JERK + 1 / (k * sp.sqrt(sp.Max(sp.Abs(10 * e - square), EPS))),
)
OF_SIZES = f"extremes of the derivatives of {motion.SOURCE}, equation (8)"


def of_sizes(
    name: str,
    summary: str,
    value: sp.Expr,
    accuracy: Accuracy,
    singular: tuple[Singular, ...] = (),
    charts: tuple[Chart, ...] = (),
) -> Quantity:
    """Return a quantity of the sizes alone."""
    return Quantity(
        name,
        summary,
        motion.ARGUMENTS[1:],
        value,
        (Form("quotient", value, charts=charts),),
        OF_SIZES,
        unit="rad" if name.startswith("angle") else "1",
        accuracy=accuracy,
        singular=(*motion.ENDS_OF_E, *singular),
        # At a threshold the differentiated function has a kink.
        slopes=None if singular else SLOPES,
    )


AT_THRESHOLD = (Singular(sp.Eq(10 * e, square)),)
QUANTITIES = (
    Quantity(
        "jerk",
        "Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.",
        motion.ARGUMENTS,
        JERK,
        (
            by_half_angle(jerk_quotient(-2 * e * k**3 * (1 - e**2), e, x), OF_JERK, ((phi1,),)),
            directly(JERK),
        ),
        f"second derivative of {motion.SOURCE}, equation (8)",
        accuracy=Accuracy(24, EITHER_TERM, (*motion.LOW_WORD, *SIZES, *NO_UNDERFLOW)),
        singular=motion.SINGULAR,
        periodicity=Periodicity(2 * sp.pi / k),
    ),
    of_sizes(
        "largest_acceleration",
        "Compute the largest acceleration; the smallest is its negative.",
        peaks.LARGEST_ACCELERATION,
        Accuracy(20, within=SIZES),
        charts=BY_SIZES,
    ),
    of_sizes(
        "angle_of_smallest_acceleration",
        "Compute the first phi1 >= 0 where the acceleration is smallest; at -phi1 it is largest.",
        peaks.SMALLEST_ACCELERATION,
        Accuracy(7, within=SIZES),
        charts=BY_SIZES,
    ),
    of_sizes(
        "largest_jerk",
        "Compute the largest jerk, which it has at phi1 = angle_of_largest_jerk and -phi1.",
        peaks.LARGEST_JERK,
        Accuracy(21, within=SIZES),
        AT_THRESHOLD,
        BESIDE_THRESHOLD,
    ),
    of_sizes(
        "smallest_jerk",
        "Compute the smallest jerk, met where the ratio is largest.",
        peaks.SMALLEST_JERK,
        Accuracy(7, within=SIZES),
        charts=BY_SIZES,
    ),
    of_sizes(
        "angle_of_largest_jerk",
        "Compute the first phi1 >= 0 where the jerk is largest.",
        peaks.ANGLE_OF_JERK,
        Accuracy(8, NEAR_THRESHOLD, SIZES),
        AT_THRESHOLD,
        BESIDE_THRESHOLD,
    ),
)
