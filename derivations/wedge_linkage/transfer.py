"""Rows on the transfer function of paper 4: stages by half-angle, slopes, velocities."""

from __future__ import annotations

import sympy as sp
from sympy import cos, pi, sin, sqrt

from mechproof.record import Claim, Conjunction, Equality, Part

from .._linear import solve_linear
from .mechanics import (
    MOVABLE,
    by_half_angle,
    group_3,
    half_3,
    half_7,
    lever_cosine,
    lever_slope,
    lever_slopes,
    rod,
    rod_slopes,
    roller_slope,
    roller_slopes,
    root_7,
    wedge,
    wedge_slopes,
)
from .symbols import (
    POSITIVE,
    PRINTED_R,
    alpha_1,
    alpha_2,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    beyond,
    h3,
    h7,
    height,
    l_DE,
    l_KL,
    l_LM,
    phi3,
    phi7,
    radicand,
    reach,
    x1,
    x5,
    x5_driven,
)


def displacement_by(direction: sp.Symbol) -> sp.Expr:
    """Return the displacement of the link 5' that turns KL by varphi7 from a direction."""
    return solve_linear(group_3[0], x5_driven).subs(alpha_KL, direction)


# How it is called and printed, its slopes, what they are proved from.
SLOPES = (
    (
        ("varphi3", r"\varphi_3"),
        lever_slopes,
        lever_slope,
        Part("the guide has a length", {reach: POSITIVE}),
        "From both differentiated projections; reach is l_BC + delta_BC.",
    ),
    (
        ("varphi7", r"\varphi_7"),
        roller_slopes,
        roller_slope,
        None,
        "From the differentiated projection on Ox.",
    ),
    (
        ("x5", " x_5"),
        rod_slopes,
        rod.diff,
        None,
        "From the projection of group 2 on Ox; l_GH is taken off, see (4).",
    ),
    (("y9", " y_9"), wedge_slopes, wedge.diff, None, "From the projection of group 4 on Oy."),
)

TRANSFER_ROWS = (
    Claim(
        "chain, rod by half-angle",
        r"x_5=\frac{2l_{DE}x_1(h\sin\alpha_{DE}-x_1\cos\alpha_{DE})}{h^2+x_1^2}",
        Equality(
            2 * l_DE * x1 * (h3 * sin(alpha_DE) - x1 * cos(alpha_DE)) / (h3**2 + x1**2),
            by_half_angle(rod, phi3, -x1 / h3),
        ),
        note="(1) put into (3), h = l_BC + l_BC + delta_BC.",
        marks=("ours",),
    ),
    Claim(
        "chain, wedge by half-angle",
        r"y_9=\frac{2l_{LM}x_5(h\cos\alpha_{LM}-x_5\sin\alpha_{LM})}{h^2+x_5^2}",
        Equality(
            2 * l_LM * x5 * (h7 * cos(alpha_LM) - x5 * sin(alpha_LM)) / (h7**2 + x5**2),
            by_half_angle(wedge, phi7, x5 / h7),
        ),
        note="(7) or (8) put into (10), h = l_KL sin(alpha_KL) + (l_KL^2 - R^2)^(1/2).",
        marks=("ours",),
    ),
    *(
        Claim(
            f"sensitivity of {name} to {size}",
            rf"\partial{output}/\partial {sp.latex(size)}={sp.latex(slope)}",
            Equality(slope, differentiate(size)),
            note=note,
            on=on,
            marks=("ours",),
        )
        for (name, output), slopes, differentiate, on, note in SLOPES
        for size, slope in slopes.items()
    ),
    Claim(
        "sensitivity of varphi7 to alpha_KL, sign",
        r"\frac{\partial\varphi_7}{\partial\alpha_{KL}}=-\frac{2\cos(\alpha_{KL}+\varphi_7/2)"
        r"\sin(\varphi_7/2)}{\sin(\alpha_{KL}+\varphi_7)}\text{ changes sign at }"
        r"\varphi_7=\pi-2\alpha_{KL}",
        Conjunction(
            (
                Equality(
                    -2 * cos(alpha_KL + phi7 / 2) * sin(phi7 / 2) / sin(alpha_KL + phi7),
                    roller_slope(alpha_KL),
                ),
                Equality(
                    cos(alpha_KL + phi7 / 2).subs(phi7, pi - 2 * alpha_KL + 2 * beyond),
                    -sin(beyond),
                ),
            )
        ),
        note="At 50 deg for alpha_KL = 65 deg; negative before. Beyond it, by twice `beyond`, the "
        "cosine is negative.",
        marks=("ours",),
    ),
    Claim(
        "two directions of KL",
        r"[\cos\alpha_1-\cos(\alpha_1+\varphi_7)]-[\cos\alpha_2-\cos(\alpha_2+\varphi_7)]="
        r"4\sin\tfrac{\varphi_7}2\sin\tfrac{\alpha_1-\alpha_2}2\cos\tfrac{\alpha_1+\alpha_2+"
        r"\varphi_7}2",
        Equality(
            4 * sin(phi7 / 2) * sin((alpha_1 - alpha_2) / 2) * cos((alpha_1 + alpha_2 + phi7) / 2),
            (displacement_by(alpha_1) - displacement_by(alpha_2)) / l_KL,
        ),
        note="Displacements of the link 5' over l_KL, from group 3, for one turn: the smaller "
        "alpha_KL turns farther for the same displacement as long as varphi7 < pi - alpha_1 - "
        "alpha_2, then the larger one. They meet at x5' = l_KL (cos alpha_1 + cos alpha_2).",
        marks=("ours",),
    ),
    Claim(
        "chain, velocity of the rod",
        r"dx_5/dx_1=l_{DE}\sin(\alpha_{DE}+\varphi_3)\cos\varphi_3/(l_{BC}+\delta_{BC})",
        Conjunction(
            (
                Equality(-l_DE * sin(alpha_DE + phi3), sp.diff(rod, phi3)),
                Equality(-lever_cosine / sqrt(radicand), sp.diff(2 * sp.atan(half_3), x1)),
            )
        ),
        note="The product of both stages.",
        on=MOVABLE,
        marks=("ours",),
    ),
    Claim(
        "chain, velocity of the wedge",
        r"dy_9/dx_5=l_{LM}\cos(\alpha_{LM}+\varphi_7)/(l_{KL}^2-R^2)^{1/2}",
        Conjunction(
            (
                Equality(l_LM * cos(alpha_LM + phi7), sp.diff(wedge, phi7)),
                Equality(1 / root_7, sp.diff(2 * sp.atan(half_7.subs(height, root_7)), x5)),
            )
        ),
        note="The product of both stages; with the rod's, errors multiply along the chain.",
        on=Part("|R| < l_KL", where=(l_KL**2 - PRINTED_R**2 > 0,)),
        marks=("ours",),
    ),
)
