"""Rows on the transfer function of paper 4: stages by half-angle, slopes, velocities."""

from __future__ import annotations

import sympy as sp
from sympy import cos, sin, sqrt

from mechproof.record import Claim, Conjunction, Equality, Part

from .half_angles import MOVABLE, by_half_angle, half_3, half_7, root_7
from .mechanics import lever_cosine, rod, wedge
from .slopes import lever_slope, lever_slopes, roller_slope, roller_slopes
from .symbols import (
    POSITIVE,
    PRINTED_R,
    alpha_DE,
    alpha_LM,
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
            f"sensitivity of varphi3 to {size}",
            rf"\partial\varphi_3/\partial {size}={sp.latex(slope)}",
            Equality(slope, lever_slope(size)),
            note="From both differentiated projections; reach is l_BC + delta_BC.",
            on=Part("the guide has a length", {reach: POSITIVE}),
            marks=("ours",),
        )
        for size, slope in lever_slopes.items()
    ),
    *(
        Claim(
            f"sensitivity of varphi7 to {size}",
            rf"\partial\varphi_7/\partial {size}={sp.latex(slope)}",
            Equality(slope, roller_slope(size)),
            note="From the differentiated projection on Ox.",
            marks=("ours",),
        )
        for size, slope in roller_slopes.items()
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
