"""Rows on the transfer function of paper 4: slopes and velocities."""

from collections.abc import Callable, Mapping

import sympy as sp
from sympy import cos, sin, sqrt

from mechproof.record import Claim, Equality, Part, all_of, ours

from .._linear import solve_linear
from .mechanics import (
    MOVABLE,
    group_3,
    half_3,
    half_7,
    lever_cosine,
    lever_slope,
    lever_slopes,
    rod,
    roller_slope,
    roller_slopes,
    root_7,
    wedge,
)
from .symbols import *


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
