"""Quantities of paper 4 stage by stage; every form of them."""

import sympy as sp
from sympy import Abs, And, Eq, Ge, Le, Max, Or, Piecewise, Rational, cos, pi, sin, sqrt

from mechproof.record import Accuracy, Argument, Form, Part, Quantity, Singular

from ..mechanics import *
from . import charts, inputs, proofs
from .chain import DIRECTION_IN_PRINT, LINKS, MEANT, PUSHED, ROLLER, guide_sum

RUN = Argument("x5", (x5,), "displacement of the rod", "mm", usual=(0, 60))
DRIVEN_RUN = Argument(
    "x5", (x5,), "displacement of the link 5' after the clearance", "mm", usual=(0, 60)
)
LEVER_TURN = Argument("phi3", (phi3,), MEANING[phi3], "rad", usual=(0, 7))
ROLLER_TURN = Argument("phi7", (phi7,), MEANING[phi7], "rad", usual=(0, 7))


FOLLOWED = Part("the guide follows the pusher", where=(guide_square >= 0,))
RAISED = Part("the roller lever follows the link 5'", where=(height_square >= 0,))
LOW_ROLLER = "|roller_offset| > l_KL"
GUIDE_SIZES, ARM_SIZES = inputs.moderate(x1, l_AB, l_BC, l_CD), inputs.moderate(x5, l_KL)
GUIDED = (*GUIDE_SIZES, inputs.CLOSING)
LIFTED = (*ARM_SIZES, inputs.beside(height_square, "height_condition"))
GUIDE_EDGE = f"{inputs.CONDITIONING}: {inputs.OF_GUIDE}"
HEIGHT_EDGE = (
    f"{inputs.CONDITIONING}: height_condition of height_square = l_KL**2 - roller_offset**2"
)


def singular_arm(turned: sp.Symbol, direction: sp.Symbol) -> tuple[Singular, ...]:
    """Return where an arm has not turned, and where its end is back or farthest from its start."""
    return (Singular(Eq(turned, 0)), Singular(Eq(direction + turned / 2, pi / 2 * inputs.turns)))


# Accuracy, in eps.
# guide_radicand: 2.5 for x1 times the sum, 1/2 for the square and 1/2 for the last sum. The scale
# contains every term of the sum at least once, besides the value.
RADICAND_ULP = 2.5
# roller_offset: cosine and product of the first term 1.5, the difference 1/2.
OFFSET_ULP = 1.5
# lever_angle: seven operations under and after the root, atan.
LEVER_ULP = 8
# rod_displacement, wedge_displacement: two sines, the sum of their angle, two products. Beyond half
# a turn a sine may be near zero at a sum that is not, whose rounding no argument accounts for.
PRODUCT_ULP = 4


def within_half_a_turn(angle: sp.Symbol, arm: sp.Symbol) -> tuple[sp.Basic, ...]:
    """Return the domain in which the bound of an arm times two sines is stated.

    Nothing in it is subnormal: a sum of two doubles, one of them above 1e-140, is 0 or above
    1e-156.
    """
    turned = Or(Eq(angle, 0), Ge(Abs(angle), Rational(1, 10**140)))
    arms = And(arm >= Rational(1, 10**10), arm <= 10**300)
    return Le(Abs(angle), pi), turned, arms


# roller_lever_angle: 3.5 for each factor under the root, an error of l_KL and, at most 1.3 times,
# of alpha_KL; root, sine, sum, quotient 4; atan.
ROLLER_ULP = 16

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

QUANTITIES = (
    Quantity(
        "guide_radicand",
        "Compute the radicand of Q, the square of BC: the guide follows where it is not negative.",
        inputs.arguments(x1, l_AB, l_BC, l_CD),
        radicand,
        (Form("product", radicand, charts=charts.RADICAND),),
        f"{BAZUEV} (1)",
        unit="mm**2",
        accuracy=inputs.conditioned(RADICAND_ULP, radicand, (x1, l_AB, l_BC, l_CD), GUIDE_SIZES),
        singular=(Singular(Eq(radicand, 0)), inputs.PIVOT),
    ),
    Quantity(
        "lever_angle",
        "Compute the rotation phi3 of the lever.",
        inputs.arguments(x1, l_AB, l_BC, l_CD),
        LEVER,
        (
            Form("half-angle atan", -2 * sp.atan(x1 / guide_sum), charts=charts.LEVER),
            Form(
                "printed (1)",
                print_1,
                key="printed",
                states=proofs.same_lever,
                on=MOVABLE,
                holds_on=BEFORE_PIVOT,
                source=f"{BAZUEV} (1)",
                note="beyond a right angle of the lever it is off by pi",
            ),
            Form(
                "(1) with atan2",
                sp.atan2(print_1_top, print_1_bottom),
                key="atan2",
                states=proofs.same_lever,
                on=MOVABLE,
            ),
        ),
        f"{BAZUEV} (1)",
        unit="rad",
        accuracy=inputs.conditioned(LEVER_ULP, LEVER, (x1, l_AB, l_BC, l_CD), GUIDED),
        on=FOLLOWED,
        singular=(inputs.AT_REST, inputs.PIVOT),
        period=pi,
        workloads=LEVER_LOADS,
        remarks=(inputs.SHORT_GUIDE, GUIDE_EDGE, inputs.BEYOND_SQUARES),
    ),
    Quantity(
        "rod_displacement",
        "Compute the displacement x5 of the rod.",
        (LEVER_TURN, *inputs.arguments(l_DE, alpha_DE)),
        print_3,
        (
            Form(
                "product", -2 * l_DE * sin(phi3 / 2) * sin(alpha_DE + phi3 / 2), charts=charts.ROD
            ),
            Form("printed (3)", print_3, key="printed", source=f"{BAZUEV} (3)"),
        ),
        f"{BAZUEV} (3)",
        unit="mm",
        accuracy=inputs.conditioned(
            PRODUCT_ULP, print_3, (phi3, alpha_DE), within_half_a_turn(phi3, l_DE)
        ),
        singular=singular_arm(phi3, alpha_DE),
    ),
    Quantity(
        "clearance",
        "Compute the displacement x5' of the pushed link after the clearance.",
        (RUN, *inputs.arguments(l_GH)),
        PUSHED,
        (
            Form("maximum", Max(0, x5 - l_GH), states=proofs.by_pushing, charts=charts.CLEARANCE),
            Form(
                "printed (4)",
                PUSHED_IN_PRINT,
                key="printed",
                states=proofs.by_pushing,
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
        (DRIVEN_RUN, *inputs.arguments(l_KL, alpha_KL)),
        PRINTED_R,
        (Form("difference", PRINTED_R, charts=charts.OFFSET),),
        f"{BAZUEV}s (7) and (8)",
        unit="mm",
        accuracy=inputs.conditioned(OFFSET_ULP, PRINTED_R, (x5, l_KL), ARM_SIZES),
        singular=(Singular(Eq(PRINTED_R, 0)),),
    ),
    Quantity(
        "roller_lever_angle",
        "Compute the rotation phi7 of the roller lever.",
        (DRIVEN_RUN, *inputs.arguments(l_KL, alpha_KL)),
        ROLLER,
        (
            Form(
                "half-angle atan",
                ROLLER_FORM,
                states=proofs.from_projection(proofs.upwards),
                on=proofs.UPWARD,
                charts=charts.ROLLER,
            ),
            Form(
                "printed (7), (8)",
                DIRECTION_IN_PRINT.subs(R, PRINTED_R),
                key="printed",
                states=proofs.from_projection(proofs.by_quadrants),
                on=proofs.NOT_UPRIGHT,
                source=f"{BAZUEV}s (7) and (8)",
                note="R = 0 is in neither case: NaN",
            ),
            Form(
                "(7) or else (8)",
                DIRECTION_OR_ELSE.subs(R, PRINTED_R),
                key="or_else",
                states=proofs.from_projection(proofs.by_quadrants),
                on=proofs.NOT_UPRIGHT,
                note="at R = 0 the quotient is infinite and (8) off by pi",
            ),
            Form("atan2", ROLLER, key="atan2"),
            Form(
                "arccosine",
                sp.acos(cos(alpha_KL) - x5 / l_KL) - alpha_KL,
                key="arccosine",
                states=proofs.from_projection(proofs.upwards),
                on=proofs.UPWARD,
            ),
        ),
        f"{BAZUEV}s (7) and (8)",
        unit="rad",
        accuracy=inputs.conditioned(ROLLER_ULP, ROLLER, (x5, l_KL, alpha_KL), LIFTED),
        on=RAISED,
        singular=(Singular(Eq(x5, 0)), Singular(Eq(PRINTED_R, 0))),
        period=pi,
        workloads=ROLLER_LOADS,
        remarks=(f"NaN where {LOW_ROLLER}", HEIGHT_EDGE, inputs.BEYOND_SQUARES),
    ),
    Quantity(
        "wedge_displacement",
        "Compute the displacement y9 of the wedge.",
        (ROLLER_TURN, *inputs.arguments(l_LM, alpha_LM)),
        print_10,
        (
            Form(
                "product", 2 * l_LM * sin(phi7 / 2) * cos(alpha_LM + phi7 / 2), charts=charts.WEDGE
            ),
            Form("printed (10)", print_10, key="printed", source=f"{BAZUEV} (10)"),
        ),
        f"{BAZUEV} (10)",
        unit="mm",
        accuracy=inputs.conditioned(
            PRODUCT_ULP, print_10, (phi7, alpha_LM), within_half_a_turn(phi7, l_LM)
        ),
        singular=singular_arm(phi7, alpha_LM),
    ),
)
