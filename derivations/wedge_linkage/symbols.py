"""Letters and prints of paper 4, and the symbols that its proofs need besides.

Conventions: x to the right, y upwards; angles from Ox, positive counter-clockwise; x_i, y_i and
varphi_i are displacements and rotations from the position x1 = 0; lengths in mm, angles in rad.
"""

from pathlib import Path

import sympy as sp

from mechproof.document.transcription import Transcription

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
POSITIVE, NOT_NEGATIVE = sp.Interval.open(0, sp.oo), sp.Interval(0, sp.oo)
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
# From the link 5' on the chain is a function of one displacement, which the kernels call x5.
PRINTED_R = PRINTED_R.subs(x5_driven, x5)
_, print_1 = read("(1)")
print_1_top, print_1_bottom = sp.fraction(print_1.args[0])
(_, print_3), (_, print_4), (_, print_7), (_, print_8), (_, print_10) = map(
    read, ("(3)", "(4)", "(7)", "(8)", "(10)")
)
