"""Rows of paper 4 on lever and rod: groups 1 and 2, equations (1) to (3)."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy import sqrt

from mechproof.record import (
    Claim,
    Equality,
)

from .half_angles import (
    BEFORE_PIVOT,
    half_3,
)
from .mechanics import (
    group_1,
    group_2,
    guide_squared,
    lever_angle,
    lever_cosine,
    lever_sine,
    rod,
)
from .prints import (
    EQUATION_1,
    EQUATION_2_OX,
    EQUATION_2_OY,
    EQUATION_3,
    EQUATION_Q,
    GROUP_1,
    GROUP_1_OX,
    GROUP_1_OY,
    GROUP_2,
    PRINTED_Q,
)
from .symbols import (
    AD,
    DG,
    Q,
    l_AB,
    l_BC,
    l_CD,
    phi3,
    x1,
    x5,
)

LEVER_ROWS = (
    replace(
        GROUP_1,
        defines=(AD,),
        note="A polygon of any four points closes; AD, from A on the pusher to the fixed D, is "
        "what closes it. Judged are its projections.",
    ),
    replace(
        GROUP_1_OX,
        residual=group_1[0],
        note="Left minus right against the turned vectors minus AD.",
    ),
    replace(
        GROUP_1_OY,
        residual=group_1[1],
        note="The last pi of the left side is lost in print.",
        marks=("rebuilt",),
    ),
    replace(
        EQUATION_Q,
        derived={Q: l_BC * sqrt(guide_squared)},
        note="Q is l_BC (l_BC + delta_BC); the exponents are rebuilt.",
        marks=("rebuilt",),
    ),
    replace(
        EQUATION_1,
        derived={phi3: lever_angle},
        note="Against the two-argument arctangent of the solved projections. It holds "
        "farther, up to a right angle of the lever, which no size within its limits reaches; see "
        "the next row.",
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
        "positive and is off by pi beyond. On Fig. 4 it is positive for all sizes within their "
        "limits, see 'boundaries, directions of the arms'.",
        marks=("rebuilt", "ours"),
    ),
    Claim(
        "(1), half-angle form",
        r"\varphi_3=-2\arctan\frac{x_1}{l_{BC}+\sqrt{l_{BC}^2+x_1(2l_{AB}+2l_{CD}+x_1)}}",
        Equality(
            sp.Matrix([2 * half_3 / (1 + half_3**2), (1 - half_3**2) / (1 + half_3**2)]),
            sp.Matrix([lever_sine, lever_cosine]),
        ),
        note="Sine and cosine of the form are those of the solution; twice an arctangent keeps "
        "inside (-pi, pi), so no turn is lost, wherever the radicand is not negative.",
        marks=("ours",),
    ),
    replace(
        GROUP_2,
        defines=(DG,),
        note="See group 1; DG, from the fixed D to the guide of the rod.",
    ),
    replace(
        EQUATION_2_OX,
        residual=group_2[0],
    ),
    replace(
        EQUATION_2_OY,
        residual=group_2[1],
    ),
    replace(
        EQUATION_3,
        derived={x5: rod},
        marks=("rebuilt",),
    ),
)
