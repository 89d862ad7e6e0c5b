"""What can be computed of paper 4: each stage, the chain, its derivatives; every form of them."""

from collections.abc import Iterable

import sympy as sp
from sympy import Abs, Eq, Max, Piecewise, Rational, cos, pi, sin, sqrt

from mechproof.record import (
    LENGTH,
    Accuracy,
    Argument,
    Form,
    Part,
    Quantity,
    Scale,
    Singular,
    Variable,
)

from .chain import (
    BY_ATAN2,
    DIRECTION_IN_PRINT,
    IN_PRINT,
    LINKS,
    MEANT,
    POSITION,
    PUSHED,
    PUSHED_IN_PRINT,
    ROLLER,
    SENSITIVITIES,
    SIZES,
    VELOCITY,
    chain_slope,
    in_chain,
)
from .mechanics import (
    BEFORE_PIVOT,
    DISPLACEMENTS,
    LENGTHS,
    MOVABLE,
    PRINTED_R,
    ROTATIONS,
    R,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    guide_square,
    height_square,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_GH,
    l_KL,
    l_LM,
    phi3,
    phi7,
    print_1,
    print_1_bottom,
    print_1_top,
    print_3,
    print_10,
    radicand,
    x1,
    x5,
)
from .proofs import (
    NOT_UPRIGHT,
    REACHED,
    UPWARD,
    as_meant,
    by_pushing,
    by_quadrants,
    by_stages,
    from_projection,
    position_in_contact,
    same_lever,
    slopes_in_contact,
    upwards,
)
from .steps import (
    POSITION_FORM,
    SENSITIVITY_FORMS,
    VELOCITY_FORM,
    guide_sum,
)

# Arguments -------------------------------------------------------------------------------------

turns = sp.Symbol("m_turns", integer=True)
ANGLES = {
    alpha_DE: ROTATIONS[alpha_DE],
    alpha_KL: "direction of KL at x1 = 0, in (0, pi)",
    alpha_LM: ROTATIONS[alpha_LM],
}
ARGUMENT = {
    x1: Argument("x1", (x1,), DISPLACEMENTS[x1], "mm", usual=(0, 1, 10, 20, 40)),
    **{
        size: Argument(str(size), (size,), LENGTHS[size], "mm")
        for size in SIZES
        if size not in ANGLES
    },
    **{angle: Argument(str(angle), (angle,), meaning, "rad") for angle, meaning in ANGLES.items()},
}
RUN = Argument("x5", (x5,), "displacement of the rod", "mm", usual=(0, 60))
DRIVEN_RUN = Argument(
    "x5", (x5,), "displacement of the link 5' after the clearance", "mm", usual=(0, 60)
)
LEVER_TURN = Argument("phi3", (phi3,), ROTATIONS[phi3], "rad", usual=(0, 7))
ROLLER_TURN = Argument("phi7", (phi7,), ROTATIONS[phi7], "rad", usual=(0, 7))


def arguments(*symbols: sp.Symbol) -> tuple[Argument, ...]:
    """List the arguments of a kernel, the running variable first."""
    return tuple(ARGUMENT[symbol] for symbol in symbols)


# Domains and singular sets ---------------------------------------------------------------------

FOLLOWED = Part("the guide follows the pusher", where=(guide_square >= 0,))
RAISED = Part("the roller lever follows the link 5'", where=(height_square >= 0,))
CLOSED = Part(
    "the linkage closes",
    where=(guide_square >= 0, l_KL - MEANT.offset >= 0, l_KL + MEANT.offset >= 0),
)
MOVING = Part(
    "the linkage closes and is at no dead centre",
    where=(guide_square > 0, l_KL - MEANT.offset > 0, l_KL + MEANT.offset > 0),
)
OPEN = Part(f"{MOVABLE.text}; {UPWARD.text}", UPWARD.within, MOVABLE.where)
IN_CASES = Part(f"{BEFORE_PIVOT.text}; {NOT_UPRIGHT.text}", NOT_UPRIGHT.within, BEFORE_PIVOT.where)
SHORT_GUIDE = "NaN where guide_radicand is negative"
LOW_ROLLER = "|roller_offset| > l_KL"
RANGE = f"{SHORT_GUIDE} or {LOW_ROLLER}"

AT_REST = Singular(Eq(x1, 0))
PIVOT = Singular(Eq(x1, -(l_AB + l_CD)))
ALONG_CHAIN = (
    AT_REST,
    Singular(
        Eq(MEANT.travel, l_GH),
        "the start of contact: derivatives jump, here they are those in contact",
    ),
    Singular(Eq(MEANT.offset, 0)),
    PIVOT,
)
POSITION_ALONG_CHAIN = (AT_REST, Singular(Eq(MEANT.travel, l_GH)), *ALONG_CHAIN[2:])


def singular_arm(turned: sp.Symbol, direction: sp.Symbol) -> tuple[Singular, ...]:
    """List where an arm has not turned, and where its end is back or farthest from its start."""
    return (
        Singular(Eq(turned, 0)),
        Singular(Eq(direction + turned / 2, pi / 2 * turns)),
    )


# Accuracy --------------------------------------------------------------------------------------

EPS = Rational(1, 2**52)
CONDITION = "|value| + sum of |p * d value/d p| over the arguments p"


def condition(value: sp.Expr, inputs: Iterable[sp.Symbol]) -> sp.Expr:
    """Return the value's size and what the rounding of every input makes of it, in contact."""
    return Abs(value) + sp.Add(*(Abs(s * chain_slope(value, s)) for s in inputs))


def conditioned(
    ulp: float,
    value: sp.Expr,
    inputs: Iterable[sp.Symbol],
    within: tuple[sp.Basic, ...] = (),
) -> Accuracy:
    """Bound the error by the conditioning of a value."""
    return Accuracy(ulp, Scale(CONDITION, condition(value, inputs)), within)


def conditioned_in_contact(
    ulp: float, value: sp.Basic, within: tuple[sp.Basic, ...] = ()
) -> Accuracy:
    """Bound the error by the conditioning in contact of a value of the chain, or a norm."""
    parts = [condition(part, (x1, *SIZES)) for part in sp.Matrix([value])]
    size = parts[0] if len(parts) == 1 else sqrt(sp.Add(*(part**2 for part in parts)))
    norm = "" if len(parts) == 1 else "norm over the entries (each keeps its own) of "
    scale = Scale(f"{norm}{CONDITION}, in contact", size.subs(MEANT.engaged, 1))
    return Accuracy(ulp, scale, within)


# In eps, 1/2 for an operation, 1 for a sine or cosine, 4 for atan (what NumPy's vector loops are
# allowed). An error of a term of a sum is one of the inputs in that term, which the scale has; a
# common factor of the lengths takes what a sum itself rounds.
# guide_radicand: 2.5 for x1 times the sum, 1/2 for the square and 1/2 for the last sum. The scale
# has every term of the sum at least once besides the value.
RADICAND_ULP = 2.5
# roller_offset: cosine and product of the first term 1.5, the difference 1/2.
OFFSET_ULP = 1.5
# lever_angle: seven operations under and after the root, atan.
LEVER_ULP = 8
# rod_displacement, wedge_displacement: two sines, the sum of their angle, two products.
PRODUCT_ULP = 4
# roller_lever_angle: 3.5 for each factor under the root, an error of l_KL and, at most 1.3 times,
# of alpha_KL; root, sine, sum, quotient 4; atan.
ROLLER_ULP = 16
# position: guide 3.5; run 5; push 1/2; rise and its sum 6.5, the share of alpha_KL 0.8 more; the
# last quotient 5: 22 if every step counted in full. Each has only its own share of the scale, and
# searches find less than 1 here; 8 leaves room for a sine that is 4 off. The same for derivatives.
CHAIN_ULP = 8
# At the clearance's edge a derivative jumps; where the guide or the roller lever can just follow
# it has a pole, and beyond there is NaN. On which side the inputs are is known from EDGE_ULP eps
# on: the run of the rod, both squares and l_KL + KL_x are computed with less than a third of that,
# of which a pole like 1/sqrt makes no more than 1.4 times the first order.
EDGE_ULP = 16
OF_RUN = (x1, l_AB, l_BC, l_CD, l_DE, alpha_DE)
EDGES = {
    "run_condition": (MEANT.travel, OF_RUN, LENGTH),
    "guide_condition": (radicand, (x1, l_AB, l_BC, l_CD), LENGTH**2),
    "height_condition": (l_KL**2 - PRINTED_R**2, (x5, l_KL, alpha_KL), LENGTH**2),
    "roller_condition": (
        l_KL * (1 + cos(alpha_KL)) - (MEANT.travel - l_GH),
        (*OF_RUN, l_GH, l_KL, alpha_KL),
        LENGTH,
    ),
}
SIDES = {name: sp.Symbol(name, real=True) for name in EDGES}
VARIABLES = tuple(
    Variable(SIDES[name], "conditioning of an edge", dimension, given=condition(value, inputs))
    for name, (value, inputs, dimension) in EDGES.items()
)


def beside(gap: sp.Expr, name: str) -> sp.Basic:
    """State that a gap from an edge is wider than what the kernels make of the inputs."""
    return gap > EDGE_ULP * EPS * SIDES[name]


GUIDED = (beside(guide_square, "guide_condition"),)
LIFTED = (beside(height_square, "height_condition"),)
LINKED = (*GUIDED, beside(l_KL + MEANT.offset, "roller_condition"))
PUSHING = (beside(Abs(MEANT.travel - l_GH), "run_condition"), *LINKED)
CONDITIONING = "the conditioning |value| + sum of |p * d value/d p|"
OF_GUIDE = "guide_condition of guide_square = guide_radicand"
OF_ROLLER = f"{OF_GUIDE}, roller_condition of KL_x + l_KL in contact"
GUIDE_EDGE = f"{CONDITIONING}: {OF_GUIDE}"
HEIGHT_EDGE = f"{CONDITIONING}: height_condition of height_square = l_KL**2 - roller_offset**2"
LINK_EDGES = f"{CONDITIONING}: {OF_ROLLER}"
ALL_EDGES = f"{CONDITIONING}: run_condition of travel_5, {OF_ROLLER}"

# The quantities --------------------------------------------------------------------------------

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
CHAIN_LOADS = (
    ("N inputs, one linkage", ("x1",)),
    ("one input, N linkages", tuple(map(str, SIZES))),
)

QUANTITIES = (
    Quantity(
        "guide_radicand",
        "Compute the radicand of Q, the square of BC: the guide follows where it is not negative.",
        arguments(x1, l_AB, l_BC, l_CD),
        radicand,
        (Form("product", radicand),),
        f"{BAZUEV} (1)",
        unit="mm**2",
        accuracy=conditioned(RADICAND_ULP, radicand, (x1, l_AB, l_BC, l_CD)),
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
        remarks=(SHORT_GUIDE, GUIDE_EDGE),
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
        accuracy=conditioned(PRODUCT_ULP, print_3, (phi3, alpha_DE)),
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
        accuracy=conditioned(OFFSET_ULP, PRINTED_R, (x5, l_KL)),
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
        remarks=(f"NaN where {LOW_ROLLER}", HEIGHT_EDGE),
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
        accuracy=conditioned(PRODUCT_ULP, print_10, (phi7, alpha_LM)),
        singular=singular_arm(phi7, alpha_LM),
    ),
    Quantity(
        "position",
        "Compute the displacement y9 of the wedge, the whole chain.",
        arguments(x1, *SIZES),
        POSITION,
        (
            Form("half-angle chain", POSITION_FORM, states=position_in_contact, on=REACHED),
            Form(
                "printed chain",
                in_chain(POSITION, IN_PRINT),
                key="printed",
                states=by_stages(IN_PRINT, by_quadrants, POSITION),
                on=IN_CASES,
                source=CHAIN_SOURCE,
                note="stage by stage; R = 0 is in neither case: NaN",
            ),
            Form(
                "chain with atan2",
                in_chain(POSITION, BY_ATAN2),
                key="atan2",
                states=by_stages(BY_ATAN2, as_meant, POSITION),
                on=OPEN,
                note="stage by stage",
            ),
        ),
        CHAIN_SOURCE,
        unit="mm",
        accuracy=conditioned_in_contact(CHAIN_ULP, POSITION, LINKED),
        on=CLOSED,
        singular=POSITION_ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, LINK_EDGES),
    ),
    Quantity(
        "velocity",
        "Compute dy9/dx1, the velocity of the wedge at unit speed of the pusher.",
        arguments(x1, *SIZES),
        VELOCITY,
        (
            Form("half-angle chain", VELOCITY_FORM, states=slopes_in_contact(VELOCITY), on=REACHED),
            Form(
                "product of slopes",
                in_chain(VELOCITY, BY_ATAN2),
                key="slopes",
                states=by_stages(BY_ATAN2, as_meant, VELOCITY),
                on=OPEN,
                note="stage by stage, at the angles of the chain with atan2",
            ),
        ),
        CHAIN_SOURCE,
        accuracy=conditioned_in_contact(CHAIN_ULP, VELOCITY, PUSHING),
        on=MOVING,
        singular=ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, ALL_EDGES),
    ),
    Quantity(
        "sensitivities",
        "Compute the derivatives of y9 by the sizes, in the order of the arguments.",
        arguments(x1, *SIZES),
        SENSITIVITIES,
        (
            Form(
                "half-angle chain",
                sp.ImmutableDenseMatrix([SENSITIVITY_FORMS[size] for size in SIZES]),
                states=slopes_in_contact(SENSITIVITIES),
                on=REACHED,
            ),
            Form(
                "product of slopes",
                in_chain(SENSITIVITIES, BY_ATAN2),
                key="slopes",
                states=by_stages(BY_ATAN2, as_meant, SENSITIVITIES),
                on=OPEN,
                note="stage by stage, at the angles of the chain with atan2",
            ),
        ),
        CHAIN_SOURCE,
        unit="mm per mm or mm per rad",
        accuracy=conditioned_in_contact(CHAIN_ULP, SENSITIVITIES, PUSHING),
        on=MOVING,
        singular=ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, ALL_EDGES),
    ),
)
