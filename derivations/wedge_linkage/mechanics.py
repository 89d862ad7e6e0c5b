"""Groups of paper 4, rebuilt from their vector equations, and what the paper prints of them.

Order of the file: symbols; the groups, each with its assembly branch; the printed equations; the
half-angle forms; the slopes of the stages.

Conventions: x to the right, y upwards; angles from Ox, positive counter-clockwise; x_i, y_i and
varphi_i are displacements and rotations from the position x1 = 0; lengths in mm, angles in rad.
"""

# The symbols keep the paper's letters.

from collections.abc import Iterable, Sequence

import sympy as sp
from sympy import cos, pi, sin, sqrt

from mechproof.record import Part

# Symbols --------------------------------------------------------------------------------------

x1, x5, y9 = sp.symbols("x1 x5 y9", real=True)
x5_driven = sp.Symbol("x5'", real=True)
phi2, phi3, phi7 = sp.symbols("varphi2 varphi3 varphi7", real=True)
l_AB, l_BC, l_CD, l_DE, l_EF = sp.symbols("l_AB l_BC l_CD l_DE l_EF", positive=True)
l_GH, l_IK, l_KL, l_LM, l_MN = sp.symbols("l_GH l_IK l_KL l_LM l_MN", positive=True)
l_FG, l_HI, l_NP = sp.symbols("l_FG l_HI l_NP", positive=True)
alpha_DE, alpha_KL, alpha_LM = sp.symbols("alpha_DE alpha_KL alpha_LM", real=True)
dBC, dFG, dHI, dPN = sp.symbols("delta_BC delta_FG delta_HI delta_PN", real=True)
Q, R = sp.symbols("Q R", real=True)
overlap = sp.Symbol("x5-l_GH", real=True)
millimetre = sp.Symbol("mm", positive=True)
tau, sigma, kappa = sp.symbols("tau sigma kappa", nonnegative=True)
guide_square, height_square = sp.symbols("guide_square height_square", real=True)

reach, h3, height, h7 = sp.symbols("reach h3 height h7", positive=True)

POSITIVE = sp.Interval.open(0, sp.oo)
LENGTHS = {
    l_AB: "length of AB, pusher to foot of the guide",
    l_BC: "length of BC at x1 = 0",
    l_CD: "length of CD",
    l_DE: "length of DE, arm of the lever",
    l_EF: "length of EF on the rod",
    l_GH: "clearance between the rod 5 and the link 5'",
    l_IK: "length of IK on the link 5'",
    l_KL: "length of KL, driven arm of the roller lever",
    l_LM: "length of LM, driving arm of the roller lever",
    l_MN: "length of MN on the wedge",
    l_FG: "length of FG at x1 = 0",
    l_HI: "length of HI at x1 = 0",
    l_NP: "length of NP at x1 = 0",
    millimetre: "the unit of length",
}
DISPLACEMENTS = {
    x1: "displacement of the pusher",
    x5: "displacement of the rod; in (6)-(8) of the link 5'",
    x5_driven: "displacement of the link 5' after the clearance",
    y9: "displacement of the wedge",
    dBC: "change of the length BC",
    dFG: "change of the length FG",
    dHI: "change of the length HI",
    dPN: "change of the length NP",
}
ROTATIONS = {
    phi2: "rotation of link 2",
    phi3: "rotation of the lever",
    phi7: "rotation of the roller lever",
    alpha_DE: "direction of DE at x1 = 0",
    alpha_LM: "direction of LM at x1 = 0",
}
PRINTED_Q = sqrt(l_BC**4 + x1 * l_BC**2 * (2 * l_CD + 2 * l_AB + x1))
PRINTED_R = l_KL * cos(alpha_KL) - x5


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

# The turn keeps the length of AD, which fixes the guide; branch: BC does not turn over, its
# length stays positive. Then both projections are linear in cos and sin.
guide_now = sp.Symbol("BC", positive=True)
turned_length = (l_AB + l_CD) ** 2 + guide_now**2
guide_squared = sp.solve(sp.Eq(turned_length, from_a_to_d.dot(from_a_to_d)), guide_now**2)[0]
cosine, sine = sp.symbols("cosine sine", real=True)
linear = group_1.subs({cos(phi3): cosine, sin(phi3): sine, dBC: guide_now - l_BC})
solved = sp.solve(list(linear), [cosine, sine], dict=True)[0]
lever_cosine, lever_sine = (
    solved[part].subs(guide_now, sqrt(sp.expand(guide_squared))) for part in (cosine, sine)
)
lever_angle = sp.atan2(lever_sine, lever_cosine)
lever_by_reach = sp.atan2(solved[sine], solved[cosine]).subs(guide_now, reach)

# Group 2. EF stays level on the rod, FG vertical; the rod moves by x5 along Ox.
from_d_to_g = l_DE * towards(alpha_DE) + l_EF * RIGHT + l_FG * UP + x5 * RIGHT
group_2 = l_DE * towards(alpha_DE + phi3) + l_EF * RIGHT + (l_FG + dFG) * UP - from_d_to_g
rod = sp.solve(group_2[0], x5)[0]

# Clearance. Link 5' is pushed only, and not before the rod has run through the clearance.
driven = (overlap + sp.Abs(overlap)) / 2

# Group 3. H moves with the link 5' by x5', HI stays vertical and IK level; L is fixed.
from_h_to_l = l_HI * UP + l_IK * RIGHT + l_KL * towards(alpha_KL) - x5_driven * RIGHT
group_3 = (l_HI + dHI) * UP + l_IK * RIGHT + l_KL * towards(alpha_KL + phi7) - from_h_to_l

# Branch: KL points upwards as at x1 = 0, so that its direction is 2*atan(tau), tau >= 0 (or
# pi - 2*atan(sigma), sigma >= 0). Ox of (6) then gives the displacement that belongs to it.
direction_tau, direction_sigma = 2 * sp.atan(tau), pi - 2 * sp.atan(sigma)
cosine_of_tau, cosine_of_sigma = (1 - tau**2) / (1 + tau**2), (sigma**2 - 1) / (sigma**2 + 1)
sine_of_tau = 2 * tau / (1 + tau**2)
displacement = sp.solve(group_3[0], x5_driven)[0]
displacement = {
    parameter: displacement.subs(cos(alpha_KL + phi7), value)
    for parameter, value in ((tau, cosine_of_tau), (sigma, cosine_of_sigma))
}

# Group 4. MN stays vertical on the wedge, NP level; the wedge moves by y9 along Oy.
from_l_to_p = l_LM * towards(alpha_LM) + l_MN * -UP + l_NP * RIGHT + y9 * UP
group_4 = l_LM * towards(alpha_LM + phi7) + l_MN * -UP + (l_NP + dPN) * RIGHT - from_l_to_p
wedge = sp.solve(group_4[1], y9)[0]

# What the paper prints ------------------------------------------------------------------------

print_ox1 = (
    l_AB * cos(pi + phi3) + (l_BC + dBC) * cos(phi3 + 3 * pi / 2) + l_CD * cos(pi + phi3)
) + (l_CD + l_AB + x1)
print_oy1 = (
    l_AB * sin(pi + phi3) + (l_BC + dBC) * sin(phi3 + 3 * pi / 2) + l_CD * sin(pi + phi3)
) + l_BC
print_1_top = -(x1 + l_AB) * Q + l_CD * (l_BC**2 - Q) + l_BC**2 * l_AB
print_1_bottom = l_BC * ((l_AB + l_CD) * (l_AB + l_CD + x1) + Q)
print_1 = sp.atan(print_1_top / print_1_bottom)
print_2_ox = l_DE * cos(alpha_DE + phi3) + l_EF - (l_DE * cos(alpha_DE) + l_EF + x5)
print_2_oy = l_DE * sin(alpha_DE + phi3) + dFG - l_DE * sin(alpha_DE)
print_3 = l_DE * (cos(alpha_DE + phi3) - cos(alpha_DE))
print_6_ox = l_KL * cos(alpha_KL + phi7) - (l_KL * cos(alpha_KL) - x5)
print_6_oy = dHI + l_KL * sin(alpha_KL + phi7) - l_KL * sin(alpha_KL)
print_7 = -alpha_KL + sp.atan(sqrt(l_KL**2 - R**2) / R)
print_8 = pi - alpha_KL + sp.atan(sqrt(l_KL**2 - R**2) / R)
print_9_ox = l_LM * cos(alpha_LM + phi7) + dPN - l_LM * cos(alpha_LM)
print_9_oy = l_LM * sin(alpha_LM + phi7) - (l_LM * sin(alpha_LM) + y9)
print_10 = l_LM * (sin(phi7 + alpha_LM) - sin(alpha_LM))

# The half-angle forms: what the kernels compute.
radicand = l_BC**2 + x1 * (2 * (l_AB + l_CD) + x1)
half_3 = -x1 / (l_BC + sqrt(radicand))
half_7 = x5 / (l_KL * sin(alpha_KL) + height)
root_7 = sqrt(l_KL**2 - PRINTED_R**2)


def by_half_angle(expression: sp.Expr, angle: sp.Symbol, tangent: sp.Expr) -> sp.Expr:
    """Put the tangent of half an angle into sines and cosines of sums with it."""
    expanded = sp.expand_trig(expression)
    cosine, sine = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
    return expanded.subs({cos(angle): cosine, sin(angle): sine})


def upright(expression: sp.Expr) -> sp.Expr:
    """Give alpha_KL by the tangent kappa of its half, as the direction of KL by tau."""
    placed = expression.subs({x5: displacement[tau], height: l_KL * sine_of_tau})
    by_tangent = by_half_angle(placed, alpha_KL, kappa)
    return by_tangent.subs(alpha_KL, 2 * sp.atan(kappa))


MOVABLE = Part("the radicand of Q is positive", where=(radicand > 0,))
BEFORE_PIVOT = Part(
    "x1 > -(l_AB + l_CD), A has not passed D", where=(x1 > -l_AB - l_CD, radicand > 0)
)
FIRST_QUADRANT = Part("R > 0", {tau: sp.Interval.Ropen(0, 1)})
SECOND_QUADRANT = Part("R < 0", {sigma: sp.Interval.Ropen(0, 1)})

# Sensitivities, stage by stage ----------------------------------------------------------------

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
    rates = {unknown: sp.Dummy(str(unknown)) for unknown in unknowns}
    differentiated = [
        sp.diff(p, size) + sum(sp.diff(p, u) * rate for u, rate in rates.items())
        for p in projections
    ]
    return sp.solve(differentiated, list(rates.values()), dict=True)[0][rates[unknowns[0]]]


def lever_slope(size: sp.Symbol) -> sp.Expr:
    """Return the derivative of varphi3 from both projections of group 1."""
    return slope_by_projections(group_1.subs(dBC, reach - l_BC), (phi3, reach), size)


def roller_slope(size: sp.Symbol) -> sp.Expr:
    """Return the derivative of varphi7 from the projection of group 3 on Ox."""
    return slope_by_projections([group_3[0].subs(x5_driven, x5)], (phi7,), size)
