"""Symbols of paper 1, parts of its domain and the sizes of its table 1.

Angles are positive in the direction of the carrier's rotation; distances on the line A-C are
positive from A towards C and B; lengths in mm, angles in rad.
"""

from pathlib import Path

from sympy import Eq, Interval, Rational, Symbol, cos, pi, symbols

from mechproof.document.transcription import Transcription
from mechproof.record import Part

from .._linear import solve_linear

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
phi1, phi3, phi5, R1, R2, e, a, rho, x = PRINT.symbols("phi1 phi3 phi5 R1 R2 e a rho x")
a1, b1, C, omega1, omega3 = PRINT.symbols("a1 b1 C omega1 omega3")
AC, BC, CD, BD, DE, VC, VD = PRINT.symbols("AC BC CD BD DE V_C V_D")
ratio_symbol, slope = PRINT.symbols("phi3' dphi3/dphi1")
k, nearest, U, tau, T = symbols("k nearest U tau T", real=True)
at_b, at_c, at_d = symbols("s_B s_C s_D", real=True)
turns = Symbol("m_turns", integer=True)
nu, E = symbols("nu E", positive=True)

# Ellipse seen from a focus: the distances to both foci (2 a e apart) add up to 2 a.
r, theta = symbols("r theta", real=True)
second_focus_squared = r**2 - 4 * a * e * r * cos(theta) + 4 * a**2 * e**2
focal_radius = solve_linear(Eq((2 * a - r) ** 2, second_focus_squared), r)

BRANCH = Part("|x| < pi, the first branch of the half-angle", {x: Interval.open(-pi, pi)})
UP_TO_ONE = Part("0 <= e <= 1", {e: Interval(0, 1)})
BELOW_ONE = Part("0 <= e < 1", {e: Interval.Ropen(0, 1)})

# Table 1: R1, R2, e.
VARIANTS = {
    1: (66, 16, Rational("0.28")),
    2: (66, 16, Rational("0.475")),
    3: (80, 30, Rational("0.28")),
    4: (80, 30, Rational("0.475")),
}
