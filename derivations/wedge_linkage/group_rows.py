"""Rows of paper 4 on its structure and on the groups: equations (1) to (10)."""

import sympy as sp
from sympy import sqrt

from mechproof.record import Claim, Definition, Equality, Part, all_of, ours

from .._metrology import POSITIVE
from .mechanics import *

GROUPS, LINKS_OF_GROUP, PAIRS_OF_GROUP = 4, 2, 3


def mobility(links: int, pairs: int) -> sp.Integer:
    """Degrees of freedom of a plane linkage with lower pairs only (Chebyshev)."""
    return sp.Integer(3 * links - 2 * pairs)


DRIVEN = {x5_driven: driven.subs(overlap, x5 - l_GH)}
PRIME = "The prime of x5' is lost in the text layer and set by the sense, as in (4)."
ONE_FORM = r"\varphi_7=2\arctan\frac{x_{5'}}{l_{KL}\sin\alpha_{KL}+\sqrt{l_{KL}^2-R^2}}"
half = half_3

GROUP_ROWS = (
    PRINT.datum("five elements", Definition(elements, sp.Integer(5)), note="As in Fig. 1."),
    PRINT.claim(
        "links 1 to 9",
        Equality(sp.Integer(9), sp.Integer(1 + GROUPS * LINKS_OF_GROUP)),
        note="As in Fig. 2, each group having two links and three lower pairs. The link 5', "
        "behind the clearance, is counted with the rod 5; before contact it is a tenth link, in a "
        "guide of its own.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "Assur groups, zero mobility",
        all_of(
            Equality(sp.S.Zero, mobility(LINKS_OF_GROUP, PAIRS_OF_GROUP)),
            Equality(sp.S.One, mobility(1 + GROUPS * LINKS_OF_GROUP, 1 + GROUPS * PAIRS_OF_GROUP)),
        ),
        note="Two links with three lower pairs: W = 3*2 - 2*3 = 0; with the pusher in its guide, "
        "four such groups have one input.",
        marks=("inferred",),
    ),
    PRINT.equation(
        "group 1",
        defines=(AD,),
        note="Any polygon of four points closes; AD, from A on the pusher to the fixed D, is the "
        "closing side. What is judged are its projections.",
    ),
    PRINT.equation(
        "group 1, Ox",
        residual=group_1[0],
        note="Left minus right, compared with the turned vectors minus AD.",
    ),
    PRINT.equation(
        "group 1, Oy",
        residual=group_1[1],
        note="The last pi of the left side is lost in the text layer.",
        marks=("rebuilt",),
    ),
    PRINT.equation(
        "(1), Q",
        derived={Q: l_BC * sqrt(guide_squared)},
        note="Q is l_BC (l_BC + delta_BC); its exponents were rebuilt.",
        marks=("rebuilt",),
    ),
    PRINT.equation(
        "(1)",
        derived={phi3: lever_angle},
        note="Compared with the two-argument arctangent of the solved projections. It holds even "
        "farther, until the lever has turned by a right angle, which it does with no sizes within "
        "their limits; see the next row.",
        on=BEFORE_PIVOT,
        marks=("rebuilt",),
    ),
    Claim(
        "(1), where the arctangent is right",
        r"(l_{AB}+l_{CD})(l_{AB}+l_{CD}+x_1)+Q=\left[(l_{AB}+l_{CD}+x_1)^2+l_{BC}^2\right]"
        r"\cos\varphi_3",
        Equality(
            (l_AB + l_CD) * (l_AB + l_CD + x1) + PRINTED_Q,
            ((l_AB + l_CD + x1) ** 2 + l_BC**2) * lever_cosine,
        ),
        note="The denominator of (1) has the sign of the cosine: (1) holds exactly where it is "
        "positive, and is off by pi beyond. Over the range of Fig. 4 it is positive for all sizes "
        "within their limits, see 'boundaries, directions of the arms'.",
        marks=("rebuilt", "ours"),
    ),
    ours(
        "(1), half-angle form",
        r"\varphi_3=-2\arctan\frac{x_1}{l_{BC}+\sqrt{l_{BC}^2+x_1(2l_{AB}+2l_{CD}+x_1)}}",
        Equality(
            sp.Matrix([2 * half / (1 + half**2), (1 - half**2) / (1 + half**2)]),
            sp.Matrix([lever_sine, lever_cosine]),
        ),
        note="Sine and cosine of the form are those of the solution; twice an arctangent stays "
        "within (-pi, pi), so that no turn is lost, wherever the radicand is not negative.",
        quantities=("lever_angle",),
    ),
    PRINT.equation(
        "group 2", defines=(DG,), note="See group 1; DG, from the fixed D to the guide of the rod."
    ),
    PRINT.equation("(2), Ox", residual=group_2[0]),
    PRINT.equation("(2), Oy", residual=group_2[1]),
    PRINT.equation("(3)", derived={x5: rod}, marks=("rebuilt",)),
    PRINT.equation(
        "(4), before contact",
        derived=DRIVEN,
        substituted={x5: l_GH - apart},
        note="The link is only pushed; here x5 falls short of the clearance by some length. The "
        "argument of x5 is varphi2 in the text layer, where everything else has varphi3.",
        marks=("rebuilt", "uncertain"),
    ),
    PRINT.equation(
        "(4), in contact",
        derived=DRIVEN,
        substituted={x5: l_GH + apart},
        note="Here x5 exceeds the clearance. At the start of contact, which belongs to "
        "neither case, both give 0, so that < and <= would say the same.",
        marks=("rebuilt", "uncertain"),
    ),
    PRINT.equation(
        "(5)",
        defines=(HL,),
        note="See group 1; HL, from H on the link 5' to the fixed L. Its projections are (6).",
    ),
    PRINT.equation(
        "(6), Ox",
        residual=group_3[0],
        note=f"{PRIME} In contact the link 5' lags behind the rod by the clearance.",
        marks=("rebuilt", "uncertain"),
    ),
    PRINT.equation("(6), Oy", residual=group_3[1]),
    PRINT.equation(
        "(7)",
        derived={phi7: direction_tau - alpha_KL},
        substituted={R: l_KL * cosine_of_tau},
        on=FIRST_QUADRANT,
        note=f"R is the projection of KL, whose direction is 2 arctan(tau). {PRIME}",
        marks=("rebuilt", "uncertain"),
    ),
    PRINT.equation(
        "(8)",
        derived={phi7: direction_sigma - alpha_KL},
        substituted={R: l_KL * cosine_of_sigma},
        on=SECOND_QUADRANT,
        note=f"R is the projection of KL, whose direction is pi - 2 arctan(sigma). {PRIME}",
        marks=("rebuilt", "uncertain"),
    ),
    PRINT.equation(
        "(7) and (8), R",
        derived={R: l_KL * cosine_of_tau},
        substituted={x5_driven: displacement[tau]},
        note=f"R is the projection of KL on Ox, so |R| <= l_KL; R = 0 lies in neither formula. "
        f"{PRIME}",
        marks=("rebuilt", "uncertain"),
    ),
    ours(
        "(7) and (8), one form",
        ONE_FORM,
        Equality(
            upright(2 * sp.atan(half_7)),
            direction_tau - 2 * sp.atan(kappa),
        ),
        note="Without the gap at R = 0, for 0 < alpha_KL < pi and KL pointing upwards; compared "
        "with the same angle as (7) and (8).",
        on=Part(
            "alpha_KL = 2 arctan(kappa) in [0, pi), KL upwards",
            {kappa: sp.Interval(0, sp.oo), tau: POSITIVE},
        ),
        quantities=("roller_lever_angle",),
    ),
    PRINT.equation(
        "group 4",
        defines=(LP,),
        note="See group 1; LP, from the fixed L to the guide of the wedge.",
    ),
    PRINT.equation("(9), Ox", residual=group_4[0]),
    PRINT.equation("(9), Oy", residual=group_4[1]),
    PRINT.equation("(10)", derived={y9: wedge}, marks=("rebuilt",)),
)
