"""Rows of paper 4 on the range of its transfer function and on its conclusions."""

from __future__ import annotations

import sympy as sp
from sympy import Rational

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Datum,
    Definition,
    Equality,
    Part,
    Reading,
)

from .._relations import less
from .boundaries import (
    BOUNDARY_II,
    BOUNDARY_III,
    BOUNDARY_IV,
    angles_in_range,
    crossing,
    deviations_round,
    differ,
    extreme,
    in_both,
    influence,
    largest_at_the_end,
    ten_percent,
)
from .mechanics import displacement, lever_cosine, lever_sine, rod, wedge
from .sizes import FIRST_SET, SECOND_SET
from .symbols import (
    combinations,
    crossing_place,
    error,
    l_CD,
    l_EF,
    l_GH,
    l_IK,
    l_KL,
    l_LM,
    l_MN,
    left_of_2,
    millimetre,
    own_error,
    print_1,
    print_3,
    print_7,
    print_8,
    print_10,
    right_of_2,
    stage_ratio,
    tau,
    tolerances,
)


def no_influence(size: sp.Symbol) -> Conjunction:
    """State that no solution of a group, all lengths kept in, changes with the size."""
    outputs = (rod, displacement[tau], wedge, lever_cosine, lever_sine)
    return Conjunction(tuple(Equality(sp.diff(output, size), sp.S.Zero) for output in outputs))


HOW = (
    "By 'boundaries, directions of the arms'; shown besides are the signs, against combinations "
    "that differ in one size at some positions, and the order of both alpha_KL"
)

RANGE_ROWS = (
    Datum(
        "11 sizes with tolerances",
        r"11\text{ sizes with tolerances}",
        Definition(tolerances, sp.Integer(11)),
        note="As many have a tolerance in the table of sizes.",
    ),
    Datum(
        "combinations",
        r"2^{11}\text{ combinations}",
        Definition(combinations, 2**tolerances),
        note='Two limits for each size; the exponent is lost in the text that survives, "211".',
        marks=("rebuilt", "uncertain"),
    ),
    Claim(
        "sizes that matter",
        r"\text{eight of the eleven sizes with tolerances influence }y_9",
        Conjunction(
            (
                *(no_influence(size) for size in (l_EF, l_IK, l_MN)),
                *(influence(size) for size in BOUNDARY_II),
            )
        ),
        note="Three have no influence, each of the other eight has, at x1 = -40 mm. So at most "
        "2^8 of the 2^11 curves differ.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "boundaries, directions of the arms",
        r"\varphi_3<90^\circ,\ 270^\circ<\alpha_{DE}<\alpha_{DE}+\varphi_3<360^\circ,\ "
        r"\alpha_{KL}+\varphi_7<180^\circ,\ 90^\circ<\alpha_{LM}<\alpha_{LM}+\varphi_7<270^\circ",
        in_both(angles_in_range),
        note="All sizes within their limits, x1 from -40 to 0 mm. Hence, by the sensitivities, y9 "
        "goes one way with each size but alpha_KL, and x5 one way with x1: an outermost curve has "
        "the seven others at the signs of II, or of III. Which alpha_KL is outermost, 'two "
        "directions of KL' decides by varphi7, so that it changes at one x1.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "boundary II",
        r"\text{upper boundary: }+l_{BC},-l_{CD},-l_{DE},+l_{GH'},+l_{KL},-l_{LM},"
        r"+\alpha_{DE},+\alpha_{KL}",
        differ(lambda table: extreme(table, BOUNDARY_II, -40, (-40, -20))),
        note=f"{HOW} at x1 = -40 mm, from there to 0.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "boundary II, from -37 mm on",
        r"\text{II lies above every other combination on }[-37,0]",
        in_both(lambda table: extreme(table, BOUNDARY_II, -37, (-37, -20, -5))),
        note=f"{HOW} at x1 = -37 mm, from there to 0.",
        marks=("calibrated", "uncertain", "ours"),
    ),
    Claim(
        "boundary III",
        r"\text{lower boundary on }[-29.4,0]\text{: }-l_{BC},+l_{CD},+l_{DE},-l_{GH'},-l_{KL},"
        r"+l_{LM},-\alpha_{DE},-\alpha_{KL}",
        in_both(lambda table: extreme(table, BOUNDARY_III, "-29.35", (-29, -5))),
        note=f"{HOW} at x1 = -29.35 mm, where -29.4 ends, from there to 0.",
        marks=("calibrated",),
    ),
    Claim(
        "boundary IV",
        r"\text{lower boundary on }[-40,-29.4]\text{: }-l_{BC},+l_{CD},+l_{DE},-[l_{GH'}],-l_{KL},"
        r"+l_{LM}\text{ for one choice of what is lost}",
        in_both(lambda table: extreme(table, BOUNDARY_IV, "-29.45", (-40, -35))),
        note=f"{HOW} at x1 = -29.45 mm, where -29.4 begins, from there to -40, with -alpha_DE, "
        "+alpha_KL for the sign and the term that are lost: by the sensitivities no other choice "
        "is lowest. IV then differs from III in alpha_KL alone.",
        marks=("rebuilt", "calibrated", "uncertain"),
    ),
    Datum(
        "crossing",
        r"x_1=-29.4\text{ is the crossing of curves III and IV}",
        Definition(crossing_place, Rational("-29.4") * millimetre),
        note="A datum: the sets were fitted to it and cannot confirm it.",
        marks=("fitted",),
    ),
    Claim(
        "crossing, reconstructed sizes",
        r"\text{III and IV change order between }x_1=-29.45\text{ and }-29.35",
        in_both(crossing),
        note="The fit of both sets.",
        marks=("ours", "calibrated", "fitted"),
    ),
    Claim(
        "sizes without influence",
        r"\text{changing }l_{EF},\ l_{IK}\text{ does not influence }y_9(x_1)",
        Conjunction((no_influence(l_EF), no_influence(l_IK))),
        note="Both stay in the vector equations and cancel there.",
    ),
    Claim(
        "third size without influence",
        r"l_{MN}\text{ (or }l_{LM}\text{) does not influence }y_9(x_1)",
        Completions(
            "the damaged letter",
            Completion("the damaged letter is l_MN", no_influence(l_MN)),
            Completion("the damaged letter is l_LM", no_influence(l_LM)),
        ),
        marks=("uncertain",),
    ),
    Claim(
        "reason for no influence",
        r"\text{confirmed by the absence of these quantities in the corresponding equations}",
        Conjunction(
            tuple(
                Equality(side, side.subs(size, 2 * size))
                for side in (left_of_2, right_of_2, print_3)
                for size in (l_EF, l_IK, l_MN)
            )
        ),
        readings=(
            Reading(
                "absent in the equations that are solved for the displacements: (1), (3), (7), "
                "(8), (10)",
                Conjunction(
                    tuple(
                        Equality(printed, printed.subs(size, 2 * size))
                        for printed in (print_1, print_3, print_7, print_8, print_10)
                        for size in (l_EF, l_IK, l_MN)
                    )
                ),
            ),
        ),
        note="The sides of (2) have the slope 1 in l_EF, on which the literal reading fails; it "
        "cancels there.",
        marks=("uncertain",),
    ),
    Claim(
        "largest spread",
        r"\text{the spread is largest at }x_1=-40",
        differ(largest_at_the_end),
        note="Between the boundaries as printed, compared every 5 mm.",
        marks=("calibrated",),
    ),
    Claim(
        "deviation at -40",
        r"\text{the spread reaches }\pm10\,\%\text{ of the nominal position}",
        differ(ten_percent),
        note="At x1 = -40 mm, rounded to whole percent.",
        marks=("calibrated", "fitted"),
    ),
    Claim(
        "deviation nearer the start",
        r"\text{II and III deviate from the nominal position by 14, 12 (15, 14) \% at }-10"
        r"\text{, by 23, 19 \% at }-5~\mathrm{mm}\text{, by 10.9, 9.6 (10.6, 10.7) \% at }-37"
        r"\text{, by 11.3, 10.0 (12.7, 13.3) \% at }-25~\mathrm{mm}",
        Conjunction(
            (
                deviations_round(FIRST_SET, -37, BOUNDARY_III, ("10.9", "9.6")),
                deviations_round(SECOND_SET, -37, BOUNDARY_III, ("10.6", "10.7")),
                deviations_round(FIRST_SET, -25, BOUNDARY_III, ("11.3", "10.0")),
                deviations_round(SECOND_SET, -25, BOUNDARY_III, ("12.7", "13.3")),
                deviations_round(FIRST_SET, -10, BOUNDARY_III, ("14", "12")),
                deviations_round(SECOND_SET, -10, BOUNDARY_III, ("15", "14")),
                deviations_round(FIRST_SET, -5, BOUNDARY_III, ("23", "19")),
                deviations_round(SECOND_SET, -5, BOUNDARY_III, ("23", "19")),
            )
        ),
        note="In brackets the second set. 10 % is no bound of the deviation: II is off by more at "
        "-37 mm already, and it grows towards the start of contact, where the nominal position "
        "vanishes.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "all links contribute",
        r"\text{deviations of all intermediate links contribute to the error of the output}",
        Conjunction(tuple(influence(size) for size in (l_CD, l_GH, l_KL))),
        note="Of links: lever 3, rod 5 with its clearance and roller lever 7 each have a size "
        "whose deviation changes y9. Of every size it would not hold, see 'sizes without "
        "influence', which the paper says itself.",
        marks=("calibrated",),
    ),
    Claim(
        "more links, larger effect",
        r"\text{the accumulating, multiplicative effect is the larger, "
        r"the more links the chain has}",
        less(error, stage_ratio * error + own_error),
        holds_on=Part(
            "a further stage with a ratio above 1", {stage_ratio: sp.Interval.open(1, sp.oo)}
        ),
        note="A further stage of ratio k makes k Delta + delta of an error Delta, its own being "
        "delta >= 0, in amounts. A stage that reduces may leave less than it took.",
    ),
)
