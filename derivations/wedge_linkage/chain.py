"""The chain of paper 4 by its printed equations, and its derivatives from the stages' slopes."""

from functools import cache
from typing import NamedTuple

import sympy as sp
from sympy import sqrt

from mechproof.record import LENGTH, Variable

from .half_angles import half_3
from .prints import (
    PRINTED_R,
    print_1,
    print_1_bottom,
    print_1_top,
    print_3,
    print_4,
    print_7,
    print_8,
    print_10,
)
from .slopes import lever_slopes, roller_slopes
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
    reach,
    x1,
    x5,
)

SIZES = (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM)


class Chain(NamedTuple):
    """The steps of a chain: turn of the lever, rod, link 5', projection of KL, roller lever.

    `engaged` is 1 in contact and 0 before.
    """

    lever: sp.Symbol
    travel: sp.Symbol
    contact: sp.Symbol
    offset: sp.Symbol
    roller: sp.Symbol
    engaged: sp.Symbol


def name_chain(ending: str = "") -> Chain:
    """Make the symbols of a chain."""
    names = ("turn_3", "travel_5", "driven_5", "KL_x", "turn_7", "engaged")
    return Chain(*(sp.Symbol(name + ending, real=True) for name in names))


def link(
    chain: Chain, turned: sp.Expr, pushed: sp.Expr, direction: sp.Expr
) -> dict[sp.Symbol, sp.Expr]:
    """Define the steps of a chain: `pushed` is written in x5, `direction` in R."""
    return {
        chain.lever: turned,
        chain.travel: print_3.subs(phi3, chain.lever),
        chain.contact: pushed.subs(x5, chain.travel),
        chain.offset: PRINTED_R.subs(x5, chain.contact),
        chain.roller: direction.subs(R, chain.offset),
        chain.engaged: sp.Piecewise((0, chain.travel < l_GH), (1, True)),
    }


# Equations (4), (7) and (8) as they are meant and as they are printed: R = 0 is in neither case.
PUSHED = sp.Max(0, x5 - l_GH)
PUSHED_IN_PRINT = sp.Piecewise(print_4.args[0], (print_4.args[1].expr, True))
DIRECTION = sp.atan2(sqrt(l_KL**2 - R**2), R) - alpha_KL
DIRECTION_IN_PRINT = sp.Piecewise((print_7, R > 0), (print_8, R < 0), (sp.nan, True))
ROLLER = DIRECTION.subs(R, PRINTED_R)

MEANT, BY_ATAN2, IN_PRINT = name_chain(), name_chain("_atan2"), name_chain("_printed")
extended = sp.Symbol("BC_length", real=True)
LINKS = {
    extended: sqrt(radicand),
    **link(MEANT, 2 * sp.atan(half_3), PUSHED, DIRECTION),
    **link(BY_ATAN2, sp.atan2(print_1_top, print_1_bottom), PUSHED, DIRECTION),
    **link(IN_PRINT, print_1, PUSHED_IN_PRINT, DIRECTION_IN_PRINT),
}


def in_chain(expression: sp.Basic, chain: Chain, other: Chain = MEANT) -> sp.Basic:
    """Write an expression of another chain with the steps of this one."""
    return expression.xreplace(dict(zip(other, chain, strict=True)))


@cache
def step_slopes(size: sp.Symbol) -> dict[sp.Symbol, sp.Expr]:
    """Return the derivatives of the steps of the chain in contact: the proved stage slopes."""
    by_size = {phi3: MEANT.lever, phi7: MEANT.roller, reach: extended}
    turned = lever_slopes.get(size, sp.S.Zero).subs(by_size)
    moved = (sp.diff(print_3, size) + sp.diff(print_3, phi3) * turned).subs(by_size)
    pushed = moved - sp.diff(l_GH, size)
    own = roller_slopes.get(size, sp.S.Zero)
    return {
        extended: sp.diff(radicand, size) / (2 * extended),
        MEANT.lever: turned,
        MEANT.travel: moved,
        MEANT.roller: (own + roller_slopes[x5] * pushed).subs(by_size),
    }


def chain_slope(expression: sp.Expr, size: sp.Symbol) -> sp.Expr:
    """Return the derivative of an expression of the steps by a size or by x1."""
    through = (sp.diff(expression, step) * slope for step, slope in step_slopes(size).items())
    return sp.Add(sp.diff(expression, size), *through)


POSITION = print_10.subs(phi7, MEANT.roller)
DRIVEN = MEANT.engaged * POSITION  # before contact no size has an influence
VELOCITY = chain_slope(DRIVEN, x1)
SENSITIVITIES = sp.ImmutableDenseMatrix([chain_slope(DRIVEN, size) for size in SIZES])

LENGTH_STEPS = {extended, *(s for c in (MEANT, BY_ATAN2, IN_PRINT) for s in c[1:4])}
VARIABLES = tuple(
    Variable(s, "step of the chain", LENGTH ** (s in LENGTH_STEPS), given=value)
    for s, value in LINKS.items()
)
