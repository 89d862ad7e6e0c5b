"""Quantities of paper 5 for sums of elementary errors."""

import sympy as sp

from mechproof.record import *

from ..._algebra import POWER, is_moderate, is_zero_or_moderate
from ..mechanics import *
from .charts import BY_REST, BY_TOTAL
from .poses import SOURCE

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
    """State that a form is the root of the double sum, by the squares; neither root is negative."""
    return Equality(code.output() ** 2, CORRELATED**2)


# Accuracy, in eps, 1/2 for an operation. No square and no product of three squares leaves the range
# of doubles if the factors are within MODERATE.
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
# 13; the root halves it, root and quotient 1 more; the scale has the sizes of the terms.
CORRELATED_ULP = 8
UP_TO_11 = "the accuracy is that of sums of at most 11 errors"
VALUE = sp.Symbol("value", nonnegative=True)
TERMS = Scale(
    "the value and what the sizes of the terms make of it",
    VALUE + sp.Sum(sp.Abs(PAIR), (j, 1, n), (i, 1, n)) / (scatter**2 * VALUE),
    where=((VALUE, CORRELATED),),
)
# thermal: as independent, and the root of the product of K - K_T*share and K + K_T*share, times the
# condition number of the difference.
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
