"""What is wrong in paper 5, what it costs, and how to see it."""

import sympy as sp

from mechproof.record import Check, Cost, Finding, FollowingRow, Weight

from ..mechanics import *
from . import table
from .table import PRINTED_VALUES, THERMAL_SHARE

RIGHT_TOTAL = table.total_by_corrected_sum(sp.Integer(1)).subs(PRINTED_VALUES)
SYSTEMATIC_TOTAL = sp.sqrt(table.SUM_OF_PRINTED_SQUARES) / (1 - THERMAL_SHARE)
TURN, FARTHEST_APART = PRINTED_VALUES[beta], 2 * table.FARTHEST
LIKE_TABLE_1 = {symbol: PRINTED_VALUES[symbol] for symbol in (radius, amplitude, *ANGLES)}

# The names that (7) gives to the errors of (6).
RENAMED = {
    **{error: AT_TIME[error] for error in ERROR_FIELDS},
    mountings: mountings_t,
    elastics: elastics_t,
}


def along_y(matrix: sp.Matrix) -> sp.Expr:
    """Place along Y_0 of the track's farthest point (R + A, 0, 0) once the part is turned."""
    return (radius + amplitude) * matrix[0, 1]


def total_of_five(factor_of_mounting: sp.Expr) -> sp.Expr:
    """Root of the sum of the five squares, with a sensitivity of the mounting error."""
    more = (factor_of_mounting**2 - 1) * PRINTED_VALUES[mounting] ** 2
    return sp.sqrt(table.SUM_OF_PRINTED_SQUARES + more)


WITHOUT_ELASTIC = sp.sqrt(table.SUM_OF_PRINTED_SQUARES - PRINTED_VALUES[elastic] ** 2)
FIVE = total_of_five(sp.S.One)
ABC = product_of("ABC")


FINDINGS = (
    Finding(
        "conclusions, total error",
        "By Table 1 and the corrected (6), with one law for all errors and the others unchanged, "
        "the total falls by less than a fifth even if the elastic error vanishes. The mounting "
        "error, on which depth and feed have no influence, makes up about half of the squared "
        "total. How far the total fell is lost with Fig. 5.",
        costs=(
            Cost(
                "total of Table 1, all K = 1, Δ_T random",
                "mm",
                3,
                RIGHT_TOTAL,
                RIGHT_TOTAL * WITHOUT_ELASTIC / FIVE,
                ("as in Table 1", "without the elastic error"),
            ),
            Cost(
                "without any elastic error the total falls by",
                "%",
                1,
                table.gain(elastic) / 100,
                table.gain(elastic, own=table.UNIFORM) / 100,
                ("if all errors are of one law", "if the elastic error alone is uniform"),
            ),
            Cost(
                "halving one error lowers the total by",
                "%",
                1,
                table.gain(elastic, left=table.HALF) / 100,
                table.gain(mounting, left=table.HALF) / 100,
                ("for the elastic error", "for the mounting error"),
            ),
        ),
        weight=Weight.CONCLUSION,
        mend="Fig. 5, largest possible gain",
        check=Check(
            "√(16² + 50² + 42² + 10² + 21²) = {0}; without the 42²: {1}.",
            (FIVE, WITHOUT_ELASTIC),
            1,
            "µm",
        ),
        figure="fig-5",
    ),
    Finding(
        "(6)",
        "Δ_T, a length, is added to squares of lengths, so the total depends on the unit. Outside "
        "the sums the index i of K_i has no meaning. A random Δ_T belongs under the root squared, "
        "a systematic one outside it.",
        costs=tuple(
            Cost(
                f"total of Table 1, all K = 1, Δ_T {kind}, computed in {unit}",
                "mm",
                4,
                table.total_by_printed_sum(length),
                right,
            )
            for kind, right in (("random", RIGHT_TOTAL), ("systematic", SYSTEMATIC_TOTAL))
            for unit, length in (("mm", sp.Integer(1)), ("µm", sp.Rational(1, 1000)))
        ),
        follows=(FollowingRow("(7)", renamed=RENAMED),),
        weight=Weight.NUMBER,
        check=Check(
            "All K = 1, in mm: Δ² = 0.005061 + 0.15Δ gives {0}; in µm: Δ² = 5061 + 0.15Δ gives "
            "{1}; with the temperature error squared, (1 - 0.15²)Δ² = 0.005061 gives {2}.",
            (
                table.total_by_printed_sum(sp.Integer(1)),
                table.total_by_printed_sum(sp.Rational(1, 1000)),
                RIGHT_TOTAL,
            ),
            4,
            "mm",
        ),
        figure="fig-4",
    ),
    Finding(
        "Fig. 3, form and location",
        "(15) moves the whole track as a rigid body and keeps the distance between any two of its "
        "points. So (15), (17) and (18) contain only deviations of location, none of form. What "
        "varies along the profile, such as the elastic error of an uneven allowance, is a "
        "deviation of form and enters none of them.",
        costs=(
            Cost(
                "turns of Table 1, points at R + A and z_13 = 0",
                "mm",
                4,
                table.LARGEST_HEIGHT_ERROR,
                sp.S.Zero,
                ("largest error of position along Z_0", "deviation of form"),
            ),
        ),
        weight=Weight.WORDING,
        check=Check(
            "Two points of the part, 2(R + A) apart along X_0, turned by 0.00103 about Y_0, are "
            "{0} apart along X_0 and {1} along Z_0; the root of the sum of squares is {2}, as "
            "before.",
            (FARTHEST_APART * sp.cos(TURN), FARTHEST_APART * sp.sin(TURN), FARTHEST_APART),
            6,
            "mm",
        ),
        figure="fig-3",
    ),
    Finding(
        "Table 1, missing data",
        "The transcription gives no values of the coefficients K and K_i, so the total of Table 1 "
        "cannot be recomputed. It also lacks z, H_s, a, b, c, S_i and n, which Figs. 3 to 5 need.",
        costs=(
            Cost(
                "total of Table 1",
                "mm",
                3,
                RIGHT_TOTAL,
                table.total_by_corrected_sum(sp.sqrt(3)).subs(PRINTED_VALUES),
                ("all K_i = 1 (normal laws)", "all K_i = √3 (uniform laws)"),
            ),
        ),
        weight=Weight.NUMBER,
        check=Check(
            "√(5061/(1 - 0.15²)) = {0}; √(3·5061/(1 - 3·0.15²)) = {1}.",
            (RIGHT_TOTAL, table.total_by_corrected_sum(sp.sqrt(3)).subs(PRINTED_VALUES)),
            1,
            "µm",
        ),
        figure="table-1",
    ),
    Finding(
        "(3)",
        "The inner sum runs over k, but its terms contain j, over which nothing is summed; (4) "
        "and the list of symbols have j.",
        weight=Weight.FORMULA,
        check=Check(
            "n = 2, K = 1, all K_i S_i T_i = 1, R_12 = 0.5: with j in place of k the total is √(1 "
            "+ 1 + 0.5 + 0.5) = {0}; as printed, the terms contain a j without a value.",
            (sp.sqrt(3),),
        ),
    ),
    Finding(
        "after (4), S_i = 1",
        "Independence removes the terms with R_ij from (3), but says nothing about the "
        "sensitivities: S_i = 1 is a second assumption. Without it (5) keeps its S_i.",
        costs=(
            Cost(
                "Table 1, all K = 1, without Δ_T",
                "mm",
                4,
                FIVE,
                total_of_five(sp.Rational(11, 10)),
                ("by (5)", "with a sensitivity of 1.1 to the mounting error"),
            ),
        ),
        weight=Weight.WORDING,
        check=Check(
            "Two independent errors of 3 µm and 4 µm, K = 1: (5) gives {0}, (3) with S_1 = 2 and "
            "S_2 = 1 gives {1}.",
            (sp.Rational(5, 1000), sp.sqrt(52) / 1000),
            1,
            "µm",
        ),
    ),
    Finding(
        "before (14), product",
        "Multiplied in the order ABC, the matrices do not give the printed K; only CBA does. ABC "
        "stands for turns about fixed axes, CBA for turns about axes that turn with the part.",
        costs=(
            Cost(
                "farthest point of the track, along Y_0, turns of Table 1",
                "µm",
                3,
                along_y(ABC),
                along_y(PRINTED_K),
                at=LIKE_TABLE_1,
            ),
        ),
        weight=Weight.WORDING,
        check=Check(
            "For gamma = 0 the second element of the first row is sin alpha sin beta in (14) and 0 "
            "in ABC; 0.00103² times R + A = 45.25 mm is {0}.",
            (along_y(PRINTED_K).subs(LIKE_TABLE_1),),
            3,
            "µm",
        ),
    ),
)
