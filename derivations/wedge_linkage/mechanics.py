"""Letters, prints and mechanics of paper 4: its groups, each with its assembly branch.

They are rebuilt from their vector equations; slopes and half-angle forms of their solutions.
Conventions: x to the right, y upwards; angles from Ox, positive counter-clockwise; x_i, y_i and
varphi_i are displacements and rotations from the position x1 = 0; lengths in mm, angles in rad.
"""

from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path

import sympy as sp
from sympy import cos, pi, sin, sqrt

from mechproof.document.transcription import Transcription
from mechproof.record import ANGLE, LENGTH, Part, Variable

from .._algebra import solve_linear
from .._metrology import POSITIVE

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
x1, x5, x5_driven, y9, phi3, phi7 = PRINT.symbols("x1 x5 x5' y9 varphi3 varphi7")
l_AB, l_BC, l_CD, l_DE, l_EF = PRINT.symbols("l_AB l_BC l_CD l_DE l_EF")
l_GH, l_IK, l_KL, l_LM, l_MN = PRINT.symbols("l_GH l_IK l_KL l_LM l_MN")
alpha_DE, alpha_KL, alpha_LM = PRINT.symbols("alpha_DE alpha_KL alpha_LM")
dBC, dFG, dHI, dPN, Q, R = PRINT.symbols("delta_BC delta_FG delta_HI delta_PN Q R")
AB, BC, CD, AD, DE, EF, FG, DG = PRINT.symbols("AB BC CD AD DE EF FG DG")
HI, IK, KL, HL, LM, MN, NP, LP = PRINT.symbols("HI IK KL HL LM MN NP LP")

l_FG, l_HI, l_NP = sp.symbols("l_FG l_HI l_NP", positive=True)
overlap, guide_square, height_square = sp.symbols("x5-l_GH guide_square height_square", real=True)
alpha_1, alpha_2, crossing_place = sp.symbols("alpha_1 alpha_2 x1_crossing", real=True)
tau, sigma, kappa, own_error = sp.symbols("tau sigma kappa delta", nonnegative=True)
reach, height, apart = sp.symbols("reach height apart", positive=True)
error, stage_ratio, millimetre = sp.symbols("Delta k mm", positive=True)
elements, tolerances, combinations = sp.symbols(
    "elements tolerances combinations", integer=True, positive=True
)
NOT_NEGATIVE = sp.Interval(0, sp.oo)
radicand = l_BC**2 + x1 * (2 * (l_AB + l_CD) + x1)

# How rows of our own write the symbols.
NAMES = {
    **{variable.symbol: variable.latex[-1] for variable in PRINT.variables},
    reach: r"l_{BC}+\delta_{BC}",
    phi3: r"\varphi_3",
    phi7: r"\varphi_7",
    x1: "x_1",
    x5: "x_{5'}",
}
MEANING = {variable.symbol: variable.meaning for variable in PRINT.variables}
read = PRINT.reader()
(_, PRINTED_Q), (_, PRINTED_R) = read("(1), Q"), read("(7) and (8), R")
# From the link 5' onwards the chain is a function of one displacement, which the kernels call x5.
PRINTED_R = PRINTED_R.subs(x5_driven, x5)
_, print_1 = read("(1)")
print_1_top, print_1_bottom = sp.fraction(print_1.args[0])
(_, print_3), (_, print_4), (_, print_7), (_, print_8), (_, print_10) = map(
    read, ("(3)", "(4)", "(7)", "(8)", "(10)")
)


def turn(angle: sp.Expr) -> sp.Matrix:
    """Return the matrix that turns a vector counter-clockwise."""
    return sp.Matrix([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])


def towards(angle: sp.Expr) -> sp.Matrix:
    """Return the unit vector of a direction."""
    return sp.Matrix([cos(angle), sin(angle)])


RIGHT, UP = towards(0), towards(pi / 2)

# The mechanics --------------------------------------------------------------------------------

# Group 1. Lever 3 carries BC as a guide; A moves with the pusher, D is fixed. AB and CD point to
# the left at x1 = 0 and BC downwards; the guide gets longer by delta_BC.
guide = l_BC + dBC
lever_at_start = (l_AB + l_CD) * -RIGHT
from_a_to_d = lever_at_start + l_BC * -UP - x1 * RIGHT
group_1 = turn(phi3) * (lever_at_start + guide * -UP) - from_a_to_d

# The turn keeps the length of AD, which fixes the guide; branch: BC does not turn over, its length
# stays positive. Then both projections are linear in cos and sin.
guide_now = sp.Symbol("BC", positive=True)
turned_length = (l_AB + l_CD) ** 2 + guide_now**2
guide_squared = solve_linear(sp.Eq(turned_length, from_a_to_d.dot(from_a_to_d)), guide_now**2)
cosine, sine = sp.symbols("cosine sine", real=True)
linear = group_1.subs({cos(phi3): cosine, sin(phi3): sine, dBC: guide_now - l_BC})
solved = sp.solve(list(linear), [cosine, sine], dict=True)[0]
lever_cosine, lever_sine = (
    solved[part].subs(guide_now, sqrt(guide_squared)) for part in (cosine, sine)
)
lever_angle = sp.atan2(lever_sine, lever_cosine)
lever_by_reach = sp.atan2(solved[sine], solved[cosine]).subs(guide_now, reach)

# Group 2. EF stays level on the rod, FG vertical; the rod moves by x5 along Ox.
from_d_to_g = l_DE * towards(alpha_DE) + l_EF * RIGHT + l_FG * UP + x5 * RIGHT
group_2 = l_DE * towards(alpha_DE + phi3) + l_EF * RIGHT + (l_FG + dFG) * UP - from_d_to_g
rod = solve_linear(group_2[0], x5)

# Clearance. Link 5' is only pushed, and not before the rod has run through the clearance.
driven = (overlap + sp.Abs(overlap)) / 2
# The rod's run is l_GH + excess or l_GH - lack, which covers every run.
excess, lack = sp.Symbol("excess", nonnegative=True), sp.Symbol("lack", positive=True)
PUSHED_IN_PRINT = sp.Piecewise(print_4.args[0], (print_4.args[1].expr, True))

# Group 3. H moves with the link 5' by x5', HI stays vertical and IK level; L is fixed.
from_h_to_l = l_HI * UP + l_IK * RIGHT + l_KL * towards(alpha_KL) - x5_driven * RIGHT
group_3 = (l_HI + dHI) * UP + l_IK * RIGHT + l_KL * towards(alpha_KL + phi7) - from_h_to_l

# Branch: KL points upwards as at x1 = 0, so that its direction is 2*atan(tau), tau >= 0 (or pi -
# 2*atan(sigma), sigma >= 0). Ox of (6) then gives the corresponding displacement.
direction_tau, direction_sigma = 2 * sp.atan(tau), pi - 2 * sp.atan(sigma)
cosine_of_tau, cosine_of_sigma = (1 - tau**2) / (1 + tau**2), (sigma**2 - 1) / (sigma**2 + 1)
sine_of_tau = 2 * tau / (1 + tau**2)
displacement = solve_linear(group_3[0], x5_driven)
displacement = {
    parameter: displacement.subs(cos(alpha_KL + phi7), value)
    for parameter, value in ((tau, cosine_of_tau), (sigma, cosine_of_sigma))
}

# Group 4. MN stays vertical on the wedge, NP level; the wedge moves by y9 along Oy.
from_l_to_p = l_LM * towards(alpha_LM) + l_MN * -UP + l_NP * RIGHT + y9 * UP
group_4 = l_LM * towards(alpha_LM + phi7) + l_MN * -UP + (l_NP + dPN) * RIGHT - from_l_to_p
wedge = solve_linear(group_4[1], y9)

# The sides of the polygons, displaced.
POLYGON_SIDES = {
    side: sp.ImmutableDenseMatrix(value)
    for side, value in {
        AB: turn(phi3) * (l_AB * -RIGHT),
        BC: turn(phi3) * (guide * -UP),
        CD: turn(phi3) * (l_CD * -RIGHT),
        DE: l_DE * towards(alpha_DE + phi3),
        EF: l_EF * RIGHT,
        FG: (l_FG + dFG) * UP,
        HI: (l_HI + dHI) * UP,
        IK: l_IK * RIGHT,
        KL: l_KL * towards(alpha_KL + phi7),
        LM: l_LM * towards(alpha_LM + phi7),
        MN: l_MN * -UP,
        NP: (l_NP + dPN) * RIGHT,
    }.items()
}


# Half-angle forms, which the kernels compute, and parts of the domain ---------------------------

half_3 = -x1 / (l_BC + sqrt(radicand))
half_7 = x5 / (l_KL * sin(alpha_KL) + height)
root_7 = sqrt(l_KL**2 - PRINTED_R**2)


def by_half_angle(expression: sp.Expr, angle: sp.Symbol, tangent: sp.Expr) -> sp.Expr:
    """Return an expression with sines and cosines of sums in the tangent of half an angle."""
    expanded = sp.expand_trig(expression)
    cosine, sine = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
    return expanded.subs({cos(angle): cosine, sin(angle): sine})


def upright(expression: sp.Expr) -> sp.Expr:
    """Return an expression with alpha_KL as 2*atan(kappa), as the direction of KL is by tau."""
    placed = expression.subs({x5: displacement[tau], height: l_KL * sine_of_tau})
    by_tangent = by_half_angle(placed, alpha_KL, kappa)
    return by_tangent.subs(alpha_KL, 2 * sp.atan(kappa))


MOVABLE = Part("the radicand of Q is positive", where=(radicand > 0,))
BEFORE_PIVOT = Part(
    "the radicand of Q is positive and x1 > -(l_AB + l_CD), A has not passed D",
    where=(x1 > -l_AB - l_CD, radicand > 0),
)
FIRST_QUADRANT = Part("R > 0", {tau: sp.Interval.Ropen(0, 1)})
SECOND_QUADRANT = Part("R < 0", {sigma: sp.Interval.Ropen(0, 1)})


# Slopes of the stages, closed and from the differentiated projections --------------------------

lever_slopes = {
    x1: -cos(phi3) / reach,
    l_AB: (1 - cos(phi3)) / reach,
    l_CD: (1 - cos(phi3)) / reach,
    l_BC: -sin(phi3) / reach,
}
roller_slopes = {
    x5: 1 / (l_KL * sin(alpha_KL + phi7)),
    l_KL: (cos(alpha_KL + phi7) - cos(alpha_KL)) / (l_KL * sin(alpha_KL + phi7)),
    alpha_KL: sin(alpha_KL) / sin(alpha_KL + phi7) - 1,
}


def slope_by_projections(
    projections: Iterable[sp.Expr], unknowns: Sequence[sp.Symbol], size: sp.Symbol
) -> sp.Expr:
    """Return the derivative of the first unknown, from the differentiated equations."""
    equations = sp.Matrix(list(projections))
    rates = equations.jacobian(list(unknowns)).cramer_solve(-equations.diff(size))
    return sp.expand(sp.cancel(rates[0]))


# Of varphi3 from both projections of group 1, of varphi7 from that of group 3 on Ox.
lever_slope = partial(slope_by_projections, group_1.subs(dBC, reach - l_BC), (phi3, reach))
roller_slope = partial(slope_by_projections, [group_3[0].subs(x5_driven, x5)], (phi7,))

VARIABLES = (
    *PRINT.give({Q: PRINTED_Q, **POLYGON_SIDES}),
    *(
        Variable(side, f"length of {str(side)[2:]} at x1 = 0", LENGTH, POSITIVE)
        for side in (l_FG, l_HI, l_NP)
    ),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE),
    Variable(tau, "tangent of half the direction of KL", within=NOT_NEGATIVE),
    Variable(sigma, "cotangent of half the direction of KL", within=NOT_NEGATIVE),
    Variable(kappa, "tangent of half of alpha_KL", within=NOT_NEGATIVE),
    Variable(overlap, "x5 less the clearance", LENGTH, given=x5 - l_GH),
    Variable(reach, "present length of BC", LENGTH, POSITIVE),
    Variable(height, "height of K over L", LENGTH, POSITIVE),
    Variable(guide_square, "square of the present length of BC", LENGTH**2, given=radicand),
    Variable(height_square, "square of the height", LENGTH**2, given=l_KL**2 - PRINTED_R**2),
    Variable(error, "error that a stage takes in, in amount", LENGTH, POSITIVE),
    Variable(stage_ratio, "ratio of a stage, in amount", within=POSITIVE),
    Variable(own_error, "error that a stage adds, in amount", LENGTH, NOT_NEGATIVE),
    *(Variable(a, "a direction of KL at x1 = 0", ANGLE) for a in (alpha_1, alpha_2)),
    Variable(apart, "distance of x5 from the start of contact, in amount", LENGTH, POSITIVE),
    Variable(elements, "number of elements", within=sp.S.Naturals),
    Variable(tolerances, "number of sizes with tolerances", within=sp.S.Naturals),
    Variable(combinations, "number of combinations of limits", within=sp.S.Naturals),
    Variable(excess, "run of the rod beyond the clearance", LENGTH, NOT_NEGATIVE),
    Variable(lack, "run of the rod that is missing to contact", LENGTH, POSITIVE),
    Variable(crossing_place, "displacement at which the curves III and IV cross", LENGTH),
)
