"""What can be computed of paper 4, stage by stage; every form of it."""

from __future__ import annotations

import sympy as sp
from sympy import Eq, Max, Piecewise, cos, pi, sin, sqrt

from mechproof.record import Accuracy, Form, Quantity, Singular

from .chain import DIRECTION_IN_PRINT, LINKS, MEANT, PUSHED, PUSHED_IN_PRINT, ROLLER
from .conditioning import (
    ARM_SIZES,
    AT_REST,
    BEYOND_SQUARES,
    DRIVEN_RUN,
    FOLLOWED,
    GUIDE_EDGE,
    GUIDE_SIZES,
    GUIDED,
    HEIGHT_EDGE,
    LEVER_TURN,
    LEVER_ULP,
    LIFTED,
    LOW_ROLLER,
    OFFSET_ULP,
    PIVOT,
    PRODUCT_ULP,
    RADICAND_ULP,
    RAISED,
    ROLLER_TURN,
    ROLLER_ULP,
    RUN,
    SHORT_GUIDE,
    arguments,
    conditioned,
    singular_arm,
    within_half_a_turn,
)
from .half_angles import BEFORE_PIVOT, MOVABLE
from .prints import PRINTED_R, print_1, print_1_bottom, print_1_top, print_3, print_10
from .proofs import (
    NOT_UPRIGHT,
    UPWARD,
    by_pushing,
    by_quadrants,
    from_projection,
    same_lever,
    upwards,
)
from .steps import guide_sum
from .symbols import (
    R,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_GH,
    l_KL,
    l_LM,
    phi3,
    phi7,
    radicand,
    x1,
    x5,
)

LEVER = LINKS[MEANT.lever]
ROLLER_FORM = 2 * sp.atan(
    x5
    / (
        l_KL * sin(alpha_KL)
        + sqrt((2 * l_KL * sin(alpha_KL / 2) ** 2 + x5) * (2 * l_KL * cos(alpha_KL / 2) ** 2 - x5))
    )
)
DIRECTION_OR_ELSE = Piecewise(DIRECTION_IN_PRINT.args[0], (DIRECTION_IN_PRINT.args[1].expr, True))
BAZUEV = "Bazuev et al. 2021, equation"
CHAIN_SOURCE = f"{BAZUEV}s (1), (3), (4), (7), (8), (10)"
LEVER_LOADS, ROLLER_LOADS = ((("N inputs, one lever", (name,)),) for name in ("x1", "x5"))

STAGES = (
    Quantity(
        "guide_radicand",
        "Compute the radicand of Q, the square of BC: the guide follows where it is not negative.",
        arguments(x1, l_AB, l_BC, l_CD),
        radicand,
        (Form("product", radicand),),
        f"{BAZUEV} (1)",
        unit="mm**2",
        accuracy=conditioned(RADICAND_ULP, radicand, (x1, l_AB, l_BC, l_CD), GUIDE_SIZES),
        singular=(Singular(Eq(radicand, 0)), PIVOT),
    ),
    Quantity(
        "lever_angle",
        "Compute the rotation phi3 of the lever.",
        arguments(x1, l_AB, l_BC, l_CD),
        LEVER,
        (
            Form("half-angle atan", -2 * sp.atan(x1 / guide_sum)),
            Form(
                "printed (1)",
                print_1,
                key="printed",
                states=same_lever,
                on=MOVABLE,
                holds_on=BEFORE_PIVOT,
                source=f"{BAZUEV} (1)",
                note="beyond a right angle of the lever it is off by pi",
            ),
            Form(
                "(1) with atan2",
                sp.atan2(print_1_top, print_1_bottom),
                key="atan2",
                states=same_lever,
                on=MOVABLE,
            ),
        ),
        f"{BAZUEV} (1)",
        unit="rad",
        accuracy=conditioned(LEVER_ULP, LEVER, (x1, l_AB, l_BC, l_CD), GUIDED),
        on=FOLLOWED,
        singular=(AT_REST, PIVOT),
        period=pi,
        workloads=LEVER_LOADS,
        remarks=(SHORT_GUIDE, GUIDE_EDGE, BEYOND_SQUARES),
    ),
    Quantity(
        "rod_displacement",
        "Compute the displacement x5 of the rod.",
        (LEVER_TURN, *arguments(l_DE, alpha_DE)),
        print_3,
        (
            Form("product", -2 * l_DE * sin(phi3 / 2) * sin(alpha_DE + phi3 / 2)),
            Form("printed (3)", print_3, key="printed", source=f"{BAZUEV} (3)"),
        ),
        f"{BAZUEV} (3)",
        unit="mm",
        accuracy=conditioned(
            PRODUCT_ULP, print_3, (phi3, alpha_DE), within_half_a_turn(phi3, l_DE)
        ),
        singular=singular_arm(phi3, alpha_DE),
    ),
    Quantity(
        "clearance",
        "Compute the displacement x5' of the pushed link after the clearance.",
        (RUN, *arguments(l_GH)),
        PUSHED,
        (
            Form("maximum", Max(0, x5 - l_GH), states=by_pushing),
            Form(
                "printed (4)",
                PUSHED_IN_PRINT,
                key="printed",
                states=by_pushing,
                source=f"{BAZUEV} (4)",
            ),
        ),
        f"{BAZUEV} (4)",
        unit="mm",
        accuracy=Accuracy(0.5),
        singular=(Singular(Eq(x5, l_GH)),),
    ),
    Quantity(
        "roller_offset",
        "Compute R, the projection of KL on Ox: the roller lever follows where |R| <= l_KL.",
        (DRIVEN_RUN, *arguments(l_KL, alpha_KL)),
        PRINTED_R,
        (Form("difference", PRINTED_R),),
        f"{BAZUEV}s (7) and (8)",
        unit="mm",
        accuracy=conditioned(OFFSET_ULP, PRINTED_R, (x5, l_KL), ARM_SIZES),
        singular=(Singular(Eq(PRINTED_R, 0)),),
    ),
    Quantity(
        "roller_lever_angle",
        "Compute the rotation phi7 of the roller lever.",
        (DRIVEN_RUN, *arguments(l_KL, alpha_KL)),
        ROLLER,
        (
            Form("half-angle atan", ROLLER_FORM, states=from_projection(upwards), on=UPWARD),
            Form(
                "printed (7), (8)",
                DIRECTION_IN_PRINT.subs(R, PRINTED_R),
                key="printed",
                states=from_projection(by_quadrants),
                on=NOT_UPRIGHT,
                source=f"{BAZUEV}s (7) and (8)",
                note="R = 0 is in neither case: NaN",
            ),
            Form(
                "(7) or else (8)",
                DIRECTION_OR_ELSE.subs(R, PRINTED_R),
                key="or_else",
                states=from_projection(by_quadrants),
                on=NOT_UPRIGHT,
                note="at R = 0 the quotient is infinite and (8) off by pi",
            ),
            Form("atan2", ROLLER, key="atan2"),
            Form(
                "arccosine",
                sp.acos(cos(alpha_KL) - x5 / l_KL) - alpha_KL,
                key="arccosine",
                states=from_projection(upwards),
                on=UPWARD,
            ),
        ),
        f"{BAZUEV}s (7) and (8)",
        unit="rad",
        accuracy=conditioned(ROLLER_ULP, ROLLER, (x5, l_KL, alpha_KL), LIFTED),
        on=RAISED,
        singular=(Singular(Eq(x5, 0)), Singular(Eq(PRINTED_R, 0))),
        period=pi,
        workloads=ROLLER_LOADS,
        remarks=(f"NaN where {LOW_ROLLER}", HEIGHT_EDGE, BEYOND_SQUARES),
    ),
    Quantity(
        "wedge_displacement",
        "Compute the displacement y9 of the wedge.",
        (ROLLER_TURN, *arguments(l_LM, alpha_LM)),
        print_10,
        (
            Form("product", 2 * l_LM * sin(phi7 / 2) * cos(alpha_LM + phi7 / 2)),
            Form("printed (10)", print_10, key="printed", source=f"{BAZUEV} (10)"),
        ),
        f"{BAZUEV} (10)",
        unit="mm",
        accuracy=conditioned(
            PRODUCT_ULP, print_10, (phi7, alpha_LM), within_half_a_turn(phi7, l_LM)
        ),
        singular=singular_arm(phi7, alpha_LM),
    ),
)
