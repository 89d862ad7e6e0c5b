"""Rows of paper 4 on its structure, the groups, (1) to (10), and the transfer function."""

from collections.abc import Callable, Mapping

import sympy as sp
from sympy import cos, pi, sin, sqrt

from mechproof.record import *

from ..._algebra import solve_linear
from ..._metrology import POSITIVE
from ..mechanics import *
from .boundaries import upright_at, upright_wedge
from .sizes import SETS

GROUPS, LINKS_OF_GROUP, PAIRS_OF_GROUP = 4, 2, 3


def mobility(links: int, pairs: int) -> sp.Integer:
    """Return the degrees of freedom of a plane linkage with lower pairs only (Chebyshev)."""
    return sp.Integer(3 * links - 2 * pairs)


def push_by(pushed: sp.Basic) -> tuple[Equality, Equality]:
    """State that the rod, displaced by x5, pushes only by the part beyond the clearance."""
    return (
        Equality(pushed.subs(x5, l_GH + excess), excess),
        Equality(pushed.subs(x5, l_GH - lack), sp.S.Zero),
    )


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
        "closing side. Its projections are judged.",
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
        "farther, until the lever has turned by a right angle, which it does for no sizes within "
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


SUBSTITUTED = "(1), (3), (4), (7), (8), (10), substituted"
SUBSTITUTION_ROWS = (
    ours(
        "(7) and (8), at R = 0",
        r"\varphi_7=\tfrac\pi2-\alpha_{KL}\text{ for }R=0",
        Equality(pi / 2 - alpha_KL, direction_tau.subs(tau, 1) - alpha_KL),
        note="KL is upright: tau = 1. Both (7) and (8) tend to this value.",
    ),
    ours(
        "(7) and (8), where R = 0",
        r"R=0\text{ at }x_1=-15.7\ (-14.8;\ -14.9)~\mathrm{mm},\quad y_9=-45.1~\mathrm{mm}",
        all_of(
            *rounded(("-15.7", "-14.8", "-14.9"), map(upright_at, SETS)),
            *(PrintedNumber("-45.1", upright_wedge(table)) for table in SETS),
        ),
        note="First set of reconstructed sizes (second; third): where KL is upright, in the "
        "middle of Fig. 4. The position of the wedge there depends only on l_KL, l_LM and their "
        "angles.",
        marks=("consequence", "calibrated"),
    ),
    PRINT.claim(
        SUBSTITUTED,
        all_of(
            Equality(print_1, lever_angle),
            Equality(print_3, rod),
            *push_by(PUSHED_IN_PRINT),
            Equality(print_7.subs(R, l_KL * cosine_of_tau), direction_tau - alpha_KL),
            Equality(print_8.subs(R, l_KL * cosine_of_sigma), direction_sigma - alpha_KL),
            Equality(print_10, wedge),
            less(sp.S.Zero, cosine_of_tau),
        ),
        corrected=Correction(
            ONE_FORM, Equality(upright(2 * sp.atan(half_7)), 2 * sp.atan(tau) - 2 * sp.atan(kappa))
        ),
        note="What is stated: each stage, compared with its group, and that R is not 0, since the "
        "arctangents of (7) and (8) divide by it. The corrected form replaces both.",
        on=Part(
            f"{BEFORE_PIVOT.text}; KL points upwards",
            {kappa: POSITIVE, tau: sp.Interval(0, 1), **SECOND_QUADRANT.within},
            BEFORE_PIVOT.where,
        ),
        holds_on=Part("R > 0 for (7), R < 0 for (8)", FIRST_QUADRANT.within),
        marks=("rebuilt", "uncertain"),
    ),
)


# Slopes and velocities ----------------------------------------------------------------------------


def displacement_by(direction: sp.Symbol) -> sp.Expr:
    """Return the displacement of the link 5' that turns KL by varphi7 from a direction."""
    return solve_linear(group_3[0], x5_driven).subs(alpha_KL, direction)


def write(slope: sp.Expr) -> str:
    """Write a slope in the letters of the paper."""
    return str(sp.latex(slope, symbol_names=NAMES, fold_func_brackets=False))


def slopes_row(
    number: str,
    output: str,
    slopes: Mapping[sp.Symbol, sp.Expr],
    differentiate: Callable[[sp.Symbol], sp.Expr],
    on: Part | None,
) -> Claim:
    """State the derivatives of an angle by its group's displacement and sizes."""
    return ours(
        number,
        r",\quad ".join(
            rf"\frac{{\partial{output}}}{{\partial {NAMES[size]}}}={write(slope)}"
            for size, slope in slopes.items()
        ),
        all_of(*(Equality(slope, differentiate(size)) for size, slope in slopes.items())),
        note="By the differentiated projections; the kernels of velocity and sensitivities are "
        "built from them.",
        on=on,
        quantities=("velocity", "sensitivities"),
    )


TRANSFER_ROWS = (
    slopes_row(
        "slopes of varphi3",
        r"\varphi_3",
        lever_slopes,
        lever_slope,
        Part("the guide has a length", {reach: POSITIVE}),
    ),
    slopes_row("slopes of varphi7", r"\varphi_7", roller_slopes, roller_slope, None),
    ours(
        "two directions of KL",
        r"[\cos\alpha_1-\cos(\alpha_1+\varphi_7)]-[\cos\alpha_2-\cos(\alpha_2+\varphi_7)]="
        r"4\sin\tfrac{\varphi_7}2\sin\tfrac{\alpha_1-\alpha_2}2\cos\tfrac{\alpha_1+\alpha_2+"
        r"\varphi_7}2",
        Equality(
            4 * sin(phi7 / 2) * sin((alpha_1 - alpha_2) / 2) * cos((alpha_1 + alpha_2 + phi7) / 2),
            (displacement_by(alpha_1) - displacement_by(alpha_2)) / l_KL,
        ),
        note="Displacements of the link 5' over l_KL, by group 3, for the same turn: with the "
        "smaller alpha_KL the lever turns farther for the same displacement as long as varphi7 < "
        "pi - alpha_1 - alpha_2, from there on with the larger one. The two meet at x5' = l_KL "
        "(cos alpha_1 + cos alpha_2).",
    ),
    ours(
        "chain, velocity",
        r"\frac{dx_5}{dx_1}=\frac{l_{DE}\sin(\alpha_{DE}+\varphi_3)\cos\varphi_3}"
        r"{l_{BC}+\delta_{BC}},\quad\frac{dy_9}{dx_{5'}}=\frac{l_{LM}\cos(\alpha_{LM}+\varphi_7)}"
        r"{(l_{KL}^2-R^2)^{1/2}}",
        all_of(
            Equality(-l_DE * sin(alpha_DE + phi3), sp.diff(rod, phi3)),
            Equality(-lever_cosine / sqrt(radicand), sp.diff(2 * sp.atan(half_3), x1)),
            Equality(l_LM * cos(alpha_LM + phi7), sp.diff(wedge, phi7)),
            Equality(1 / root_7, sp.diff(2 * sp.atan(half_7.subs(height, root_7)), x5)),
        ),
        note="Each is the product of two stages; in contact dy9/dx1 is the product of both, and "
        "an error that enters on the way is multiplied by the stages that follow.",
        on=Part(
            "the radicand of Q is positive and |R| < l_KL",
            where=(*MOVABLE.where, l_KL**2 - PRINTED_R**2 > 0),
        ),
        quantities=("velocity",),
    ),
)

ROWS = (*GROUP_ROWS, *SUBSTITUTION_ROWS, *TRANSFER_ROWS)
