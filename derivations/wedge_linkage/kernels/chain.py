"""The chain of paper 4: by its printed equations, with derivatives from the slopes of the stages.

The kernels compute it by the half-angle forms: x5 by x1 and the sum of both lengths of BC, x5' by
Max, y9 by x5' and the sum of both heights of K over L. Nothing cancels at x1 = 0, at the start of
contact or at R = 0, and there are no sines or cosines except those of the sizes. Whatever depends
on the sizes alone is a step of its own, computed once for all x1.
"""

from functools import cache
from typing import NamedTuple

import sympy as sp
from sympy import Max, Piecewise, cos, sin, sqrt

from mechproof.record import LENGTH, Variable
from mechproof.record.parts import differentiate

from ..mechanics import *

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
    """Return the symbols of a chain."""
    names = ("turn_3", "travel_5", "driven_5", "KL_x", "turn_7", "engaged")
    return Chain(*(sp.Symbol(name + ending, real=True) for name in names))


def link(
    chain: Chain, turned: sp.Expr, pushed: sp.Expr, direction: sp.Expr
) -> dict[sp.Symbol, sp.Expr]:
    """Return the steps of a chain: `pushed` is written in x5, `direction` in R."""
    return {
        chain.lever: turned,
        chain.travel: print_3.subs(phi3, chain.lever),
        chain.contact: pushed.subs(x5, chain.travel),
        chain.offset: PRINTED_R.subs(x5, chain.contact),
        chain.roller: direction.subs(R, chain.offset),
        chain.engaged: Piecewise((0, chain.travel < l_GH), (1, True)),
    }


# Equations (4), (7) and (8) as meant and as printed: R = 0 is in neither of the printed cases.
PUSHED = Max(0, x5 - l_GH)
DIRECTION = sp.atan2(sqrt(l_KL**2 - R**2), R) - alpha_KL
DIRECTION_IN_PRINT = Piecewise((print_7, R > 0), (print_8, R < 0), (sp.nan, True))
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
    """Return an expression of another chain, written with the steps of this one."""
    return expression.xreplace(dict(zip(other, chain, strict=True)))


@cache
def step_slopes(size: sp.Symbol) -> dict[sp.Symbol, sp.Expr]:
    """Return the derivatives of the chain's steps in contact: the proved slopes of the stages."""
    by_size = {phi3: MEANT.lever, phi7: MEANT.roller, reach: extended}
    turned = lever_slopes.get(size, sp.S.Zero).subs(by_size)
    moved = (differentiate(print_3, size) + differentiate(print_3, phi3) * turned).subs(by_size)
    pushed = moved - differentiate(l_GH, size)
    own = roller_slopes.get(size, sp.S.Zero)
    return {
        extended: differentiate(radicand, size) / (2 * extended),
        MEANT.lever: turned,
        MEANT.travel: moved,
        MEANT.roller: (own + roller_slopes[x5] * pushed).subs(by_size),
    }


def chain_slope(expression: sp.Expr, size: sp.Symbol) -> sp.Expr:
    """Return the derivative of an expression of the steps by a size or by x1."""
    through = (differentiate(expression, step) * slope for step, slope in step_slopes(size).items())
    return sp.Add(differentiate(expression, size), *through)


POSITION = print_10.subs(phi7, MEANT.roller)
DRIVEN = MEANT.engaged * POSITION  # before contact no size has an influence
VELOCITY = chain_slope(DRIVEN, x1)
SENSITIVITIES = sp.ImmutableDenseMatrix([chain_slope(DRIVEN, size) for size in SIZES])

# Steps of the kernels ---------------------------------------------------------------------------

arm, guide_length, guide_sum = sp.symbols("arm guide_length guide_sum", real=True)
run, push, rise, rise_sum = sp.symbols("run push rise rise_sum", real=True)
lever_square, roller_square = sp.symbols("lever_square roller_square", real=True)
cos_lever, sin_arm, cos_wedge, gain = sp.symbols("cos_lever sin_arm cos_wedge gain", real=True)
sin_DE, cos_DE, sin_LM, cos_LM = sp.symbols("sin_DE cos_DE sin_LM cos_LM", real=True)
start_height, to_right, to_left = sp.symbols("start_height to_right to_left", real=True)

STEPS = {
    arm: l_AB + l_CD,
    sin_DE: sin(alpha_DE),
    cos_DE: cos(alpha_DE),
    sin_LM: sin(alpha_LM),
    cos_LM: cos(alpha_LM),
    start_height: l_KL * sin(alpha_KL),
    to_right: 2 * l_KL * sin(alpha_KL / 2) ** 2,
    to_left: 2 * l_KL * cos(alpha_KL / 2) ** 2,
    guide_length: sqrt(l_BC**2 + x1 * (2 * arm + x1)),
    guide_sum: l_BC + guide_length,
    lever_square: guide_sum**2 + x1**2,
    run: 2 * l_DE * x1 * (guide_sum * sin_DE - x1 * cos_DE) / lever_square,
    push: Max(0, run - l_GH),
    rise: sqrt((to_right + push) * (to_left - push)),
    rise_sum: start_height + rise,
    roller_square: rise_sum**2 + push**2,
    # guide_sum**2 - x1**2 without the difference of nearly equal values far to the left.
    cos_lever: 2 * (l_BC * guide_sum + arm * x1) / lever_square,
    sin_arm: cos_lever * sin_DE - 2 * guide_sum * x1 * cos_DE / lever_square,
    cos_wedge: ((rise_sum - push) * (rise_sum + push) * cos_LM - 2 * rise_sum * push * sin_LM)
    / roller_square,
    # A product, so that NaN of an angle stays NaN before contact.
    gain: Piecewise((0, run < l_GH), (l_LM, True)) * cos_wedge / rise,
}
LENGTHS = {
    *(extended, *(s for c in (MEANT, BY_ATAN2, IN_PRINT) for s in c[1:4])),
    *(arm, guide_length, guide_sum, run, push, rise, rise_sum, start_height, to_right, to_left),
}
SQUARES = {lever_square, roller_square}
# The letters of the paper for those steps that it has.
LETTERS = {
    extended: r"\overline{BC}",
    **dict(zip(MEANT, (r"\varphi_3", "x_5", "x_{5'}", "R", r"\varphi_7"), strict=False)),
}
VARIABLES = tuple(
    Variable(
        s,
        text,
        LENGTH ** ((s in LENGTHS) + 2 * (s in SQUARES)),
        given=value,
        letter=LETTERS.get(s, ""),
    )
    for text, steps in (("step of the kernels", STEPS), ("step of the chain", LINKS))
    for s, value in steps.items()
)

POSITION_FORM = 2 * l_LM * push * (rise_sum * cos_LM - push * sin_LM) / roller_square
VELOCITY_FORM = gain * l_DE * sin_arm * cos_lever / guide_length
BY_ARM = -2 * gain * l_DE * sin_arm * x1**2 / (lever_square * guide_length)
SENSITIVITY_FORMS = {
    l_AB: BY_ARM,
    l_BC: -2 * gain * l_DE * sin_arm * guide_sum * x1 / (lever_square * guide_length),
    l_CD: BY_ARM,
    l_DE: gain * run / l_DE,
    l_GH: -gain,
    l_KL: -gain * push / l_KL,
    l_LM: POSITION_FORM / l_LM,
    alpha_DE: 2 * gain * l_DE * x1 * (guide_sum * cos_DE + x1 * sin_DE) / lever_square,
    alpha_KL: gain * push * (push - to_left + to_right) / rise_sum,
    alpha_LM: -2 * l_LM * push * (rise_sum * sin_LM + push * cos_LM) / roller_square,
}
