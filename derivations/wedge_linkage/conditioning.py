"""Arguments of the kernels of paper 4, where they are defined, and how accurate they are."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp
from sympy import Abs, And, Eq, Ge, Le, Or, Rational, cos, pi, sqrt

from mechproof.record import LENGTH, Accuracy, Argument, Part, Scale, Singular, Variable

from .._sizes import LARGEST, POWER, is_moderate, is_zero_or_moderate
from .chain import MEANT, SIZES, chain_slope
from .half_angles import BEFORE_PIVOT, MOVABLE
from .prints import PRINTED_R
from .proofs import NOT_UPRIGHT, UPWARD
from .symbols import (
    DISPLACEMENTS,
    LENGTHS,
    ROTATIONS,
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
    phi3,
    phi7,
    radicand,
    x1,
    x5,
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


def condition(value: sp.Expr, inputs: Iterable[sp.Symbol], *, tidy: bool = True) -> sp.Expr:
    """Return the value's size and what the rounding of every input makes of it, in contact."""
    parts = (value, *(s * chain_slope(value, s) for s in inputs))
    return sp.Add(*(Abs(part, evaluate=tidy) for part in parts))


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
    in_contact = sp.Matrix([value]).subs(MEANT.engaged, 1)
    # No one reads these long sums, and SymPy would take a second to tidy them.
    parts = [condition(part, (x1, *SIZES), tidy=False) for part in in_contact]
    size = parts[0] if len(parts) == 1 else sqrt(sp.Add(*(part**2 for part in parts)))
    norm = "" if len(parts) == 1 else "norm over the entries (each keeps its own) of "
    scale = Scale(f"{norm}{CONDITION}, in contact", size)
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
# rod_displacement, wedge_displacement: two sines, the sum of their angle, two products. Beyond half
# a turn a sine may be near zero at a sum that is not, whose rounding no argument answers for.
PRODUCT_ULP = 4


def within_half_a_turn(angle: sp.Symbol, arm: sp.Symbol) -> tuple[sp.Basic, ...]:
    """Return where the bound of an arm times two sines is stated: none of it is subnormal there.

    A sum of two doubles of which one is above 1e-140 is 0 or above 1e-156.
    """
    turned = Or(Eq(angle, 0), Ge(Abs(angle), Rational(1, 10**140)))
    arms = And(arm >= Rational(1, 10**10), arm <= 10**300)
    return Le(Abs(angle), pi), turned, arms


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


BEYOND_SQUARES = (
    f"lengths and displacements are squared: of sizes beyond 1e-{POWER} to 1e{POWER} squares may "
    "leave the range of doubles, and the result is NaN, 0 where it should not be, or another wrong "
    "number"
)


def moderate(displacement: sp.Symbol, *lengths: sp.Symbol) -> tuple[sp.Basic, ...]:
    """State that lengths, and a displacement that is not zero, are neither vast nor tiny."""
    return is_zero_or_moderate(displacement), *map(is_moderate, lengths)


CLOSING = beside(guide_square, "guide_condition")
GUIDE_SIZES, ARM_SIZES = moderate(x1, l_AB, l_BC, l_CD), moderate(x5, l_KL)
GUIDED = (*GUIDE_SIZES, CLOSING)
LIFTED = (*ARM_SIZES, beside(height_square, "height_condition"))
# A clearance is squared nowhere.
LINKED = (
    *moderate(x1, *(size for size in SIZES if size not in (*ANGLES, l_GH))),
    Le(l_GH, LARGEST),
    CLOSING,
    beside(l_KL + MEANT.offset, "roller_condition"),
)
PUSHING = (beside(Abs(MEANT.travel - l_GH), "run_condition"), *LINKED)
CONDITIONING = "the conditioning |value| + sum of |p * d value/d p|"
OF_GUIDE = "guide_condition of guide_square = guide_radicand"
OF_ROLLER = f"{OF_GUIDE}, roller_condition of KL_x + l_KL in contact"
GUIDE_EDGE = f"{CONDITIONING}: {OF_GUIDE}"
HEIGHT_EDGE = f"{CONDITIONING}: height_condition of height_square = l_KL**2 - roller_offset**2"
LINK_EDGES = f"{CONDITIONING}: {OF_ROLLER}"
ALL_EDGES = f"{CONDITIONING}: run_condition of travel_5, {OF_ROLLER}"
