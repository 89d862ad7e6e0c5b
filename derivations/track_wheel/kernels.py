"""What can be computed of paper 5: poses, the track and its points, sums of elementary errors."""

import sympy as sp

from mechproof.record import *

from .._sizes import POWER, is_moderate, is_zero_or_moderate
from .charts import BY_RADII, BY_REST, BY_TOTAL, IN_FIRST_PART, OFF_POLE
from .kernels_of_poses import POSES, SOURCE, turns
from .mechanics import *

# The track --------------------------------------------------------------------------------------

RADIUS = printed_radius(THETA)
# Seen from the pole the points of the circle lie between these, whatever the sign of A.
LARGEST, SMALLEST = radius + sp.Abs(amplitude), radius - sp.Abs(amplitude)
# Both are even in A.
EVEN = ((amplitude,),)
TRACK = sp.ImmutableDenseMatrix([RADIUS * sp.cos(phi), RADIUS * sp.sin(phi), thickness])
SHIFTED_INSIDE = Part("A has either sign", {amplitude: sp.S.Reals})
root, rho = sp.symbols("root rho", real=True)

# Accuracy, in eps: 1/2 for an arithmetic operation, 1 for sin, cos and hypot.
# radius: u 1.5, w 1.5, its root 1.25, q 3.25 relative, w/q 5.25; the rounding of z*phi 1/2, which
# the second term of the scale pays for.
RADIUS_ULP = 6
# track: the radius, a sine and a product.
TRACK_ULP = RADIUS_ULP + 1.5
RUNNING = Scale(
    "the radius and what eps*z*phi makes of it",
    sp.Abs(rho) * (1 + sp.Abs(THETA * amplitude * sp.sin(THETA) / root)),
    where=(
        (root, sp.sqrt(radius**2 - amplitude**2 * sp.sin(THETA) ** 2)),
        (rho, root + amplitude * sp.cos(THETA)),
    ),
)

PASSES_POLE = Singular(
    sp.Eq(sp.Abs(amplitude), radius),
    "the circle passes through the pole and the track has corners there",
)
SINGULAR = (
    Singular(sp.Eq(THETA, sp.pi * turns)),
    Singular(sp.Eq(THETA, sp.pi / 2 + sp.pi * turns)),
    Singular(sp.Eq(amplitude, 0)),
    PASSES_POLE,
)
CIRCLE = (
    Argument("phi", (phi,), "polar angle", "rad", usual=(0, 7, 1e5)),
    Argument("R", (radius,), "radius of the shifted circle", "mm", usual=(1, 100)),
    Argument("A", (amplitude,), "shift of the circle, amplitude of the track", "mm", usual=(0, 10)),
    Argument("z", (periods,), "number of periods, a natural number", usual=(1, 6, 20)),
)
HEIGHT = Argument("H", (thickness,), "thickness of the part", "mm", usual=(1, 100))
# Between these sizes (R - A)*(R + A) is a normal double, down to R - A = eps*R. The scale is of
# first order in eps*z*phi: up to here its square is no more than eps.
IN_RANGE = (radius >= sp.Rational(1, 10**140), radius <= 10**150, sp.Abs(THETA) <= 2**26)
LOADS = (("N angles, one wheel", ("phi",)),)
TRACK_SOURCE = f"{SOURCE}, equation (16)"

# Sums of errors ---------------------------------------------------------------------------------

PAIR = CROSS * correlations[i, j]
DOUBLE_SUM = sp.Sum(PAIR, (j, 1, n), (i, 1, n))
CORRELATED = sp.sqrt(DOUBLE_SUM) / scatter
SOLVED = sp.sqrt(SQUARES) / sp.sqrt(scatter**2 - (k_thermal * share) ** 2)

NONNEGATIVE = sp.Interval(0, sp.oo)
ANY_TOLERANCES = Part("no tolerance is negative", {tolerances: NONNEGATIVE})
CORRELATION_MATRIX = Part(
    "the matrix is symmetric, has ones on its diagonal and gives no negative square",
    {tolerances: NONNEGATIVE},
    (
        sp.Eq(correlations[i, i], 1),
        sp.Eq(correlations[i, j], correlations[j, i]),
        sp.Ge(DOUBLE_SUM, 0),
    ),
)
SOLVABLE = Part(
    "the temperature error is below the total",
    {tolerances: NONNEGATIVE, share: NONNEGATIVE},
    (k_thermal * share < scatter,),
)


def compare_squares(code: EmittedForm) -> Statement:
    """State that a form is the double sum, by their squares; neither root is negative."""
    return Equality(code.output() ** 2, CORRELATED**2)


# Accuracy, in eps, 1/2 for an operation. No square and no product of three squares leaves the
# doubles where the factors lie in MODERATE.
MODERATE = (
    is_zero_or_moderate(tolerances[i]),
    is_zero_or_moderate(influences[i]),
    is_moderate(scatters[i]),
)
BEYOND_SQUARES = (
    "squares of tolerances, sensitivities and scatters are added: of sizes beyond "
    f"1e-{POWER} to 1e{POWER} they may leave the range of doubles, and the result is infinite, NaN "
    "or too small"
)
# Sums of n <= 128 nonnegative terms: NumPy adds in 8 strands, at most 16 + 3 roundings, 9.5;
# a term 2 * 1 + 1/2; the root halves 12, then root and quotient 1 more.
SUM_ULP = 7
UP_TO_128 = "the accuracy is that of sums of at most 128 errors"
# correlated: 6 roundings of a term and, in whatever order, n - 1 of each of two sums of n <= 11,
# 13; the root halves it, root and quotient 1 more; the scale has the terms' sizes.
CORRELATED_ULP = 8
UP_TO_11 = "the accuracy is that of sums of at most 11 errors"
VALUE = sp.Symbol("value", nonnegative=True)
TERMS = Scale(
    "the value and what the sizes of the terms make of it",
    VALUE + sp.Sum(sp.Abs(PAIR), (j, 1, n), (i, 1, n)) / (scatter**2 * VALUE),
    where=((VALUE, CORRELATED),),
)
# thermal: as independent, and the root of the product of K - K_T*share and K + K_T*share, on
# the condition number of the difference.
THERMAL_ULP = 9
CONDITIONED = Scale(
    "the value times the condition of its denominator",
    VALUE + VALUE * k_thermal * share / (scatter - k_thermal * share),
    where=((VALUE, SOLVED),),
)

SUMMANDS = (
    Argument("tolerances", (tolerances,), "tolerances of the elementary errors", "mm"),
    Argument("sensitivities", (influences,), "sensitivity of the total to each error"),
    Argument("scatters", (scatters,), "relative-scatter coefficient of each error"),
)
CORRELATION = Argument(
    "correlation",
    (correlations,),
    "correlation matrix: symmetric, positive semi-definite, ones on its diagonal",
)
TOTAL = Argument("total_scatter", (scatter,), "relative-scatter coefficient of the total")
SHARE = Argument("thermal_share", (share,), "temperature error over total error")
THERMAL_SCATTER = Argument(
    "thermal_scatter", (k_thermal,), "relative-scatter coefficient of the temperature error"
)

QUANTITIES = (
    *POSES,
    Quantity(
        "radius",
        "Compute the radius vector of the track, a shifted circle repeated z times.",
        CIRCLE,
        RADIUS,
        (
            Form("conjugate root", RADIUS, ("conjugate_root",), charts=OFF_POLE),
            Form("printed (16)", RADIUS, key="printed", source=TRACK_SOURCE),
        ),
        TRACK_SOURCE,
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(RADIUS_ULP, RUNNING, IN_RANGE),
        singular=SINGULAR,
        workloads=LOADS,
    ),
    Quantity(
        "track",
        "Compute points of the track.",
        (*CIRCLE, HEIGHT),
        TRACK,
        (
            Form(
                "conjugate root",
                TRACK,
                ("conjugate_root",),
                charts=IN_FIRST_PART,
                mirrors=((phi,),),
            ),
            Form(
                "printed (16)",
                sp.ImmutableDenseMatrix(PRINTED_16),
                key="printed",
                source=TRACK_SOURCE,
            ),
        ),
        TRACK_SOURCE,
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(TRACK_ULP, RUNNING, IN_RANGE),
        singular=SINGULAR,
        workloads=LOADS,
    ),
    Quantity(
        "largest_radius",
        "Compute the largest radius vector of the track.",
        CIRCLE[1:3],
        LARGEST,
        (Form("sum", LARGEST, charts=BY_RADII, mirrors=EVEN),),
        f"extremes of {TRACK_SOURCE}",
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(0.5),
    ),
    Quantity(
        "smallest_radius",
        "Compute the smallest radius vector of the track.",
        CIRCLE[1:3],
        SMALLEST,
        (Form("difference", SMALLEST, charts=BY_RADII, mirrors=EVEN),),
        f"extremes of {TRACK_SOURCE}",
        unit="mm",
        on=SHIFTED_INSIDE,
        accuracy=Accuracy(0.5),
        singular=(PASSES_POLE,),
    ),
    Quantity(
        "error_sum_correlated",
        "Compute the total error of correlated elementary errors.",
        (*SUMMANDS, CORRELATION, TOTAL),
        CORRELATED,
        (Form("double sum", CORRELATED, states=compare_squares),),
        f"{SOURCE}, equation (3) with its indices corrected",
        unit="mm",
        on=CORRELATION_MATRIX,
        accuracy=Accuracy(CORRELATED_ULP, TERMS, MODERATE),
        singular=(
            Singular(
                sp.Eq(DOUBLE_SUM, 0),
                "a sum that is negative by no more than its own rounding counts as 0",
            ),
        ),
        remarks=(BEYOND_SQUARES, UP_TO_11),
    ),
    Quantity(
        "error_sum",
        "Compute the total error of independent elementary errors.",
        (*SUMMANDS, TOTAL),
        CORRECTED_5,
        (Form("sum of squares", CORRECTED_5, charts=BY_TOTAL),),
        f"{SOURCE}, equation (5) with sensitivities",
        unit="mm",
        on=ANY_TOLERANCES,
        accuracy=Accuracy(SUM_ULP, within=MODERATE),
        remarks=(BEYOND_SQUARES, UP_TO_128),
    ),
    Quantity(
        "error_sum_thermal",
        "Compute the total error with a temperature error in fixed proportion to the total itself.",
        (*SUMMANDS, TOTAL, SHARE, THERMAL_SCATTER),
        SOLVED,
        (
            Form("solved for the total", SOLVED, ("difference_of_squares",), charts=BY_REST),
            Form("difference of squares", SOLVED, key="direct"),
        ),
        f"{SOURCE}, equation (6) made homogeneous, Table 1 for the share",
        unit="mm",
        on=SOLVABLE,
        accuracy=Accuracy(THERMAL_ULP, CONDITIONED, MODERATE),
        singular=(Singular(sp.Eq(k_thermal * share, scatter)),),
        remarks=(BEYOND_SQUARES, UP_TO_128),
    ),
)
