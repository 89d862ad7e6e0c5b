"""Rows on the transfer function of paper 4: the chain by substitution, slopes and velocities."""

from collections.abc import Callable, Mapping

import sympy as sp
from sympy import cos, pi, sin, sqrt

from mechproof.record import *

from .._linear import solve_linear
from .._metrology import POSITIVE
from .boundaries import upright_at, upright_wedge
from .chain import PUSHED_IN_PRINT
from .group_rows import ONE_FORM
from .mechanics import *
from .proofs import push_by
from .sizes import SETS

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
