"""The groups of paper 4, rebuilt from their vector equations, each with its assembly branch."""

from __future__ import annotations

import sympy as sp
from sympy import cos, pi, sin, sqrt

from .._linear import solve_linear
from .symbols import (
    AB,
    BC,
    CD,
    DE,
    EF,
    FG,
    HI,
    IK,
    KL,
    LM,
    MN,
    NP,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    dBC,
    dFG,
    dHI,
    dPN,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_EF,
    l_FG,
    l_HI,
    l_IK,
    l_KL,
    l_LM,
    l_MN,
    l_NP,
    overlap,
    phi3,
    phi7,
    reach,
    sigma,
    tau,
    x1,
    x5,
    x5_driven,
    y9,
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

# The turn keeps the length of AD, which fixes the guide; branch: BC does not turn over, its
# length stays positive. Then both projections are linear in cos and sin.
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
