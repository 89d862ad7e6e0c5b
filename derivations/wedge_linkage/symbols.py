"""Symbols of paper 4; they keep the paper's letters.

Conventions: x to the right, y upwards; angles from Ox, positive counter-clockwise; x_i, y_i and
varphi_i are displacements and rotations from the position x1 = 0; lengths in mm, angles in rad.
"""

from __future__ import annotations

import sympy as sp
from sympy import cos, pi, sqrt

from mechproof.record import LENGTH, Variable

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

error, stage_ratio = sp.symbols("Delta k", positive=True)
own_error = sp.Symbol("delta", nonnegative=True)
alpha_1, alpha_2 = sp.symbols("alpha_1 alpha_2", real=True)
AD, DG, HL, LP = (sp.symbols(f"{v}_x {v}_y", real=True) for v in ("AD", "DG", "HL", "LP"))
beyond = sp.Symbol("beyond", real=True)

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
radicand = l_BC**2 + x1 * (2 * (l_AB + l_CD) + x1)

VARIABLES = (
    *(Variable(s, meaning, LENGTH, POSITIVE) for s, meaning in LENGTHS.items()),
    *(Variable(s, meaning, LENGTH) for s, meaning in DISPLACEMENTS.items()),
    *(Variable(s, meaning) for s, meaning in ROTATIONS.items()),
    Variable(alpha_KL, "direction of KL at x1 = 0", within=sp.Interval.open(0, pi)),
    Variable(tau, "tangent of half the direction of KL", within=sp.Interval(0, sp.oo)),
    Variable(sigma, "cotangent of half the direction of KL", within=sp.Interval(0, sp.oo)),
    Variable(kappa, "tangent of half of alpha_KL", within=sp.Interval(0, sp.oo)),
    Variable(Q, "l_BC times the present length of BC", LENGTH**2, given=PRINTED_Q),
    Variable(overlap, "x5 less the clearance", LENGTH, given=x5 - l_GH),
    Variable(reach, "present length of BC", LENGTH, POSITIVE),
    Variable(h3, "sum of both lengths of BC", LENGTH, POSITIVE),
    Variable(h7, "sum of both heights of K over L", LENGTH, POSITIVE),
    Variable(height, "height of K over L", LENGTH, POSITIVE),
    Variable(guide_square, "square of the present length of BC", LENGTH**2, given=radicand),
    Variable(height_square, "square of the height", LENGTH**2, given=l_KL**2 - PRINTED_R**2),
    Variable(R, "projection of KL on Ox", LENGTH),
    Variable(error, "error that a stage takes in, in amount", LENGTH, POSITIVE),
    Variable(stage_ratio, "ratio of a stage, in amount", within=POSITIVE),
    Variable(own_error, "error that a stage adds, in amount", LENGTH, sp.Interval(0, sp.oo)),
    *(Variable(a, "a direction of KL at x1 = 0") for a in (alpha_1, alpha_2)),
    *(Variable(v, "projection of a vector", LENGTH) for v in (*AD, *DG, *HL, *LP)),
    Variable(beyond, "half of what varphi7 exceeds pi - 2 alpha_KL by"),
)
