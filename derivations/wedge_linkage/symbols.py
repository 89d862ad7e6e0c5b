"""Symbols of paper 4; they keep the paper's letters.

Conventions: x to the right, y upwards; angles from Ox, positive counter-clockwise; x_i, y_i and
varphi_i are displacements and rotations from the position x1 = 0; lengths in mm, angles in rad.
"""

from __future__ import annotations

import sympy as sp
from sympy import pi

from mechproof.record import ANGLE, LENGTH, Notation, Variable

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
AB, BC, CD, AD, DE, EF, FG, DG, HI, IK, KL, HL, LM, MN, NP, LP = (
    sp.MatrixSymbol(name, 2, 1)
    for name in [
        "AB",
        "BC",
        "CD",
        "AD",
        "DE",
        "EF",
        "FG",
        "DG",
        "HI",
        "IK",
        "KL",
        "HL",
        "LM",
        "MN",
        "NP",
        "LP",
    ]
)
beyond = sp.Symbol("beyond", real=True)
elements, tolerances, combinations = sp.symbols(
    "elements tolerances combinations", integer=True, positive=True
)
crossing_place = sp.Symbol("x1_crossing", real=True)
apart = sp.Symbol("apart", positive=True)

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
radicand = l_BC**2 + x1 * (2 * (l_AB + l_CD) + x1)

# How they are printed. The lengths are printed as they are called here.
LATEX = {
    **{s: (f"l_{{{str(s)[2:]}}}",) for s in LENGTHS if str(s).startswith("l_")},
    **{s: (rf"\delta_{{{str(s)[6:]}}}",) for s in (dBC, dFG, dHI, dPN)},
    **{s: (rf"\alpha_{{{str(s)[6:]}}}",) for s in (alpha_DE, alpha_KL, alpha_LM)},
    l_GH: ("l_{G'H''}", "l_{G'H'}", "l_{GH'}"),
    x1: ("x_1",),
    x5: ("x_5", r"x_5(\varphi_3)", r"x_5(\varphi_2)"),
    x5_driven: ("x_{5'}", "x_{5'}(x_5)"),
    y9: ("y_9", r"y_9(\varphi_7)"),
    phi3: (r"\varphi_3", r"\varphi_3(x_1)"),
    phi7: (r"\varphi_7", r"\varphi_7(x_5)"),
    Q: ("Q",),
    R: ("R",),
}
PRINTED_VARIABLES = (
    *(Variable(s, text, LENGTH, POSITIVE, latex=LATEX.get(s, ())) for s, text in LENGTHS.items()),
    *(Variable(s, text, LENGTH, latex=LATEX[s]) for s, text in DISPLACEMENTS.items()),
    *(Variable(s, text, ANGLE, latex=LATEX.get(s, ())) for s, text in ROTATIONS.items()),
    Variable(
        alpha_KL,
        "direction of KL at x1 = 0",
        ANGLE,
        within=sp.Interval.open(0, pi),
        latex=LATEX[alpha_KL],
    ),
    Variable(R, "projection of KL on Ox", LENGTH, latex=LATEX[R]),
)
LENGTH_OF_Q = Variable(Q, "l_BC times the present length of BC", LENGTH**2, latex=LATEX[Q])
NOTATION = Notation(factors=tuple(name for s in LENGTHS for name in LATEX.get(s, ())))
