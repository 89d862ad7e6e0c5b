"""The chain of paper 4 as the kernels compute it.

By the half-angle forms: x5 by x1 and the sum of both lengths of BC, x5' by Max, y9 by x5' and the
sum of both heights of K over L. No cancellation at x1 = 0, at the start of contact or at R = 0,
and no sine or cosine but those of the sizes. What the sizes alone decide is a step of its own,
computed once for all x1.
"""

import sympy as sp
from sympy import Max, Piecewise, cos, sin, sqrt

from mechproof.record import LENGTH, Variable

from .symbols import alpha_DE, alpha_KL, alpha_LM, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, x1

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
    # guide_sum**2 - x1**2 without the difference of near values far to the left.
    cos_lever: 2 * (l_BC * guide_sum + arm * x1) / lever_square,
    sin_arm: cos_lever * sin_DE - 2 * guide_sum * x1 * cos_DE / lever_square,
    cos_wedge: ((rise_sum - push) * (rise_sum + push) * cos_LM - 2 * rise_sum * push * sin_LM)
    / roller_square,
    # A product, so that NaN of an angle stays NaN before contact.
    gain: Piecewise((0, run < l_GH), (l_LM, True)) * cos_wedge / rise,
}
LENGTH_STEPS = {
    **dict.fromkeys((arm, guide_length, guide_sum, run, push, rise, rise_sum), 1),
    **dict.fromkeys((start_height, to_right, to_left), 1),
    **dict.fromkeys((lever_square, roller_square), 2),
}
VARIABLES = tuple(
    Variable(s, "step of the kernels", LENGTH ** LENGTH_STEPS.get(s, 0), given=value)
    for s, value in STEPS.items()
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
