"""Rows of paper 4 on the range of its transfer function and on its conclusions."""

import sympy as sp
from sympy import Rational

from mechproof.record import *

from ..mechanics import *
from .boundaries import (
    BOUNDARY_II,
    BOUNDARY_III,
    BOUNDARY_IV,
    angles_in_range,
    deviations_round,
    extreme,
    in_all,
    influence,
)
from .sizes import FIRST_SET, SECOND_SET, SETS


def no_influence(size: sp.Symbol) -> Conjunction:
    """State that no solution of a group, with all lengths kept, changes with the size."""
    outputs = (rod, displacement[tau], wedge, lever_cosine, lever_sine)
    return all_of(*(Equality(sp.diff(output, size), sp.S.Zero) for output in outputs))


LOST = "digits of l_BC, l_CD and l_DE, and the upper deviations of the first two, are lost"
HOW = (
    "By 'boundaries, directions of the arms'. The signs are shown by comparison, at some "
    "positions, with combinations that differ in one size; the order of the two alpha_KL is shown"
)

ROWS = (
    PRINT.datum(
        "11 sizes with tolerances",
        Definition(tolerances, sp.Integer(11)),
        note="The table of sizes has as many with a tolerance.",
    ),
    PRINT.datum(
        "combinations",
        Definition(combinations, 2**tolerances),
        note='Two limits for each size; the text layer has lost the exponent, "211".',
        marks=("rebuilt", "uncertain"),
    ),
    ours(
        "sizes that matter",
        r"\text{eight of the eleven sizes with tolerances influence }y_9",
        all_of(
            *(no_influence(size) for size in (l_EF, l_IK, l_MN)),
            *(influence(size) for size in BOUNDARY_II),
        ),
        note="Three have no influence; each of the other eight has, at x1 = -40 mm. So at most "
        "2^8 of the 2^11 curves differ.",
        marks=("consequence", "calibrated"),
    ),
    ours(
        "boundaries, directions of the arms",
        r"\varphi_3<90^\circ,\quad270^\circ<\alpha_{DE}<\alpha_{DE}+\varphi_3<360^\circ,\quad "
        r"\alpha_{KL}+\varphi_7<180^\circ,\quad90^\circ<\alpha_{LM}<\alpha_{LM}+\varphi_7<270^\circ",
        in_all(angles_in_range),
        note="For all sizes within their limits and x1 from -40 to 0 mm. Hence, by the "
        "sensitivities, y9 is monotonic in each size but alpha_KL, and x5 in x1: an outermost "
        "curve has the seven other sizes at the signs of II, or of III. Which alpha_KL gives the "
        "outermost curve depends on varphi7 by 'two directions of KL', so that it changes at one "
        "x1.",
        marks=("calibrated",),
    ),
    PRINT.claim(
        "boundary II",
        NotCheckable(f"{LOST}; on [-40, -37] they decide the sign of alpha_KL"),
        note="For the other seven signs, and for all eight from -37 mm on, see the next row.",
        marks=("uncertain",),
    ),
    Claim(
        "boundary II, from -37 mm on",
        r"\text{II lies above every other combination on }[-37,0]",
        in_all(lambda table: extreme(table, BOUNDARY_II, -37, (-37, -20, -5))),
        note=f"{HOW} at x1 = -37 mm and holds from there to 0. With the first and the third set of "
        "reconstructed sizes the curve with -alpha_KL is higher at -40 mm, by less than 0.03 mm.",
        marks=("calibrated", "uncertain", "ours"),
    ),
    PRINT.claim(
        "boundary III",
        in_all(lambda table: extreme(table, BOUNDARY_III, "-29.35", (-29, -5))),
        note=f"{HOW} at x1 = -29.35 mm, up to where -29.4 may be rounded, and holds from there to "
        "0.",
        marks=("calibrated",),
    ),
    PRINT.claim(
        "boundary IV",
        in_all(lambda table: extreme(table, BOUNDARY_IV, "-29.45", (-40, -35))),
        note=f"{HOW} at x1 = -29.45 mm, from where -29.4 may be rounded, and holds from there to "
        "-40. The lost sign and term are taken as -alpha_DE and +alpha_KL: by the sensitivities "
        "no other choice gives the lowest curve. IV then differs from III in alpha_KL alone.",
        marks=("rebuilt", "calibrated", "uncertain"),
    ),
    PRINT.datum(
        "crossing",
        Definition(crossing_place, Rational("-29.4") * millimetre),
        note="A datum: the sets of sizes were fitted to it and cannot confirm it.",
        marks=("fitted",),
    ),
    PRINT.claim(
        "sizes without influence",
        all_of(*map(no_influence, (l_EF, l_IK, l_MN))),
        note="They are kept in the vector equations and cancel there. The glyph of the third "
        "would fit l_LM, too.",
        marks=("uncertain",),
    ),
    PRINT.claim(
        "reason for no influence",
        all_of(
            *(
                Equality(printed, printed.subs(size, 2 * size))
                for printed in (print_1, print_3, print_4, print_7, print_8, print_10)
                for size in (l_EF, l_IK, l_MN)
            )
        ),
        note="The transfer functions (1), (3), (4), (7), (8), (10). In (2) l_EF stands on both "
        "sides and cancels.",
        marks=("uncertain",),
    ),
    PRINT.claim(
        "largest spread",
        NotCheckable(f"the curves of Fig. 4, and {LOST}"),
        note="Between the boundaries as printed, the spread is largest there with the first and "
        "the third set of reconstructed sizes, and at -32 mm with the second.",
    ),
    PRINT.claim(
        "deviation at -40",
        NotCheckable(LOST),
        note="For what the reconstructed sizes give see 'deviation at -40, reconstructed sizes'.",
    ),
    ours(
        "deviation at -40, reconstructed sizes",
        r"\text{II and IV deviate by }10.6\text{ and }9.5\ (9.9\text{ and }9.7;\ 9.8\text{ and }"
        r"8.8)~\%",
        all_of(
            *(
                deviations_round(table, -40, BOUNDARY_IV, numbers)
                for table, numbers in zip(
                    SETS, (("10.6", "9.5"), ("9.9", "9.7"), ("9.8", "8.8")), strict=True
                )
            )
        ),
        note="With the first set of reconstructed sizes (second; third).",
        marks=("consequence", "calibrated"),
    ),
    ours(
        "deviation nearer the start",
        r"\text{upper and lower boundary deviate from the nominal position by 10.9 and 9.7 \% "
        r"(10.6 and 10.7 \%) at }-37~\mathrm{mm}\text{, by 11.3 and 10.0 \% (12.7 and 13.3 \%) "
        r"at }-25~\mathrm{mm}\text{, by 14 and 12 \% (15 and 14 \%) at }-10~\mathrm{mm}\text{, "
        r"by 23 and 19 \% (both sets) at }-5~\mathrm{mm}",
        all_of(
            deviations_round(FIRST_SET, -37, BOUNDARY_IV, ("10.9", "9.7")),
            deviations_round(SECOND_SET, -37, BOUNDARY_IV, ("10.6", "10.7")),
            deviations_round(FIRST_SET, -25, BOUNDARY_III, ("11.3", "10.0")),
            deviations_round(SECOND_SET, -25, BOUNDARY_III, ("12.7", "13.3")),
            deviations_round(FIRST_SET, -10, BOUNDARY_III, ("14", "12")),
            deviations_round(SECOND_SET, -10, BOUNDARY_III, ("15", "14")),
            deviations_round(FIRST_SET, -5, BOUNDARY_III, ("23", "19")),
            deviations_round(SECOND_SET, -5, BOUNDARY_III, ("23", "19")),
        ),
        note="With the first set of reconstructed sizes (second). Relative to the nominal "
        "position the deviation is not largest at -40 mm: it grows towards the start of contact, "
        'where the nominal position vanishes. So "reaches 10 %" can refer to -40 mm alone.',
        marks=("consequence", "calibrated"),
    ),
    PRINT.claim(
        "all links contribute",
        all_of(*map(influence, BOUNDARY_II)),
        note="The accelerating lever contributes through BC, CD, DE and alpha_DE, the rod and the "
        "link 5' through the clearance between them, the lever with rollers through KL, LM and "
        "alpha_KL: all sizes with a tolerance except those that the paper itself excludes, see "
        "'sizes without influence'.",
        marks=("calibrated",),
    ),
    PRINT.claim(
        "more links, larger effect",
        less(error, stage_ratio * error + own_error),
        holds_on=Part(
            "a further stage with a ratio above 1", {stage_ratio: sp.Interval.open(1, sp.oo)}
        ),
        note="A further stage of ratio k turns an error Delta into k Delta + delta, in amounts, "
        "where delta >= 0 is its own error. A reducing stage may pass on less than it takes in, "
        "as lever and rod of this mechanism do at -40 mm, see 'ratios of the stages at -40'.",
    ),
)
