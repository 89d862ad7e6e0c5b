"""Rows of paper 4 on the range of its transfer function and on its conclusions."""

from __future__ import annotations

import sympy as sp
from sympy import Rational

from mechproof.record import Claim, Completion, Completions, Conjunction, Equality, Holds

from .mechanics import displacement, lever_cosine, lever_sine, rod, wedge
from .prints import print_1, print_3, print_7, print_8, print_10
from .sizes import (
    BOUNDARY_II,
    BOUNDARY_III,
    TOLERANCED,
    above,
    crossing,
    differ,
    in_both,
    influence,
    largest_at_the_end,
    signs_of_iv,
    ten_percent,
)
from .symbols import alpha_KL, l_CD, l_EF, l_GH, l_IK, l_KL, l_LM, l_MN, tau


def no_influence(size: sp.Symbol) -> Conjunction:
    """State that no solution of a group, all lengths kept in, changes with the size."""
    outputs = (rod, displacement[tau], wedge, lever_cosine, lever_sine)
    return Conjunction(tuple(Equality(sp.diff(output, size), sp.S.Zero) for output in outputs))


RANGE_ROWS = (
    Claim(
        "11 sizes with tolerances",
        r"11\text{ sizes with tolerances}",
        Equality(sp.Integer(11), sp.Integer(len(TOLERANCED))),
        note="Counted in the table of sizes.",
    ),
    Claim(
        "combinations",
        r"2^{11}\text{ combinations}",
        Equality(sp.Integer(2) ** 11, 2 ** sp.Integer(len(TOLERANCED))),
        note='Two limits for each size; the exponent is lost in the text that survives, "211".',
        marks=("rebuilt", "uncertain"),
    ),
    Claim(
        "combinations that matter",
        r"2^8\text{ of the }2^{11}\text{ combinations are distinct}",
        Conjunction(
            (
                *(no_influence(size) for size in (l_EF, l_IK, l_MN)),
                *(influence(size) for size in BOUNDARY_II),
            )
        ),
        note="Three of the 11 sizes have no influence, each of the other eight has.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "boundary II",
        r"\text{upper boundary: }+l_{BC},-l_{CD},-l_{DE},+l_{GH'},+l_{KL},-l_{LM},"
        r"+\alpha_{DE},+\alpha_{KL}",
        differ(lambda table: above(table, BOUNDARY_II, {**BOUNDARY_II, alpha_KL: -1}, -40)),
        note="At x1 = -40 mm, against the same combination with -alpha_KL.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "boundary II, from -37 mm on",
        r"\text{II lies above every combination that differs in one size},"
        r"\ x_1=-37,-30,-20,-10,-5",
        in_both(
            lambda table: Conjunction(
                tuple(
                    above(table, BOUNDARY_II, {**BOUNDARY_II, size: -sign}, displacement)
                    for size, sign in BOUNDARY_II.items()
                    for displacement in (-37, -30, -20, -10, -5)
                )
            )
        ),
        note="Neighbours only, at five positions; all 2^11 combinations are searched in the tests.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "boundary III",
        r"\text{lower boundary on }[-29.4,0]\text{: }-l_{BC},+l_{CD},+l_{DE},-l_{GH'},-l_{KL},"
        r"+l_{LM},-\alpha_{DE},-\alpha_{KL}",
        in_both(
            lambda table: Conjunction(
                tuple(
                    above(table, {**BOUNDARY_III, size: -sign}, BOUNDARY_III, displacement)
                    for size, sign in BOUNDARY_III.items()
                    for displacement in (-29, -20, -10, -5)
                )
            )
        ),
        note="Below every combination that differs in one size, at four positions.",
        marks=("calibrated",),
    ),
    Claim(
        "boundary IV",
        r"\text{lower boundary on }[-40,-29.4]\text{: }-l_{BC},+l_{CD},+l_{DE},-l_{GH'},-l_{KL},"
        r"+l_{LM},\ \alpha_{DE},\alpha_{KL}\text{ lost}",
        in_both(signs_of_iv),
        note="The lost signs can only be -alpha_DE, +alpha_KL; IV then differs from III in "
        "alpha_KL alone.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "crossing",
        r"x_1=-29.4\text{ is the crossing of curves III and IV}",
        in_both(crossing),
        note="The sets were fitted to it: no confirmation.",
        marks=("calibrated", "fitted"),
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
                Equality(sp.diff(printed, size), sp.S.Zero)
                for printed in (print_1, print_3, print_7, print_8, print_10)
                for size in (l_EF, l_IK, l_MN)
            )
        ),
        note="Of (1), (3), (7), (8), (10); l_EF is printed on both sides of (2) and cancels.",
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
        "all links contribute",
        r"\text{deviations of all intermediate links contribute to the error of the output}",
        Conjunction(tuple(influence(size) for size in (l_CD, l_GH, l_KL))),
        note="Of links: lever 3, rod 5 with its clearance and roller lever 7 each have a size that "
        "contributes; l_EF, l_IK and l_MN do not.",
        marks=("calibrated",),
    ),
    Claim(
        "more links, larger effect",
        r"\text{the accumulating effect is the larger, the more links the chain has}",
        Completions(
            Completion(
                "each further stage has the ratio k = 2",
                Holds(sp.Gt(sp.Integer(2) ** 5, sp.Integer(2) ** 4, evaluate=False)),
            ),
            Completion(
                "each further stage has the ratio k = 1/2",
                Holds(sp.Gt(Rational(1, 2) ** 5, Rational(1, 2) ** 4, evaluate=False)),
            ),
        ),
        note="Errors are multiplied by the ratio of every later stage, which may be below one.",
    ),
)
