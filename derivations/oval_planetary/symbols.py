"""Letters of paper 2, and the symbols that its mechanics, forms and proofs need besides.

Conventions: angles are positive in the direction of the carrier's rotation; distances on the
line A-C are positive from A towards C; at phi1 = 0 a major axis of the sun 4 points to C and the
major axes of the satellite's wheels 5 and 6 stand at right angles, that of 6 along the line A-C.
"""

from pathlib import Path

import sympy as sp

from mechproof.document.transcription import Transcription

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
phi1, phi3, phi, phi5, phi6 = PRINT.symbols("phi1 varphi3 varphi varphi5 varphi6")
e, e1, e2, a, rho, rho5, rho6 = PRINT.symbols("e e1 e2 a rho rho5 rho6")
omega1, omega3, VC, VD = PRINT.symbols("omega1 omega3 v_C v_D")
AC, EC, BC, BD, CD, DE = PRINT.symbols("AC EC BC BD CD DE")
(ratio_symbol,) = PRINT.symbols("varphi3'")

# What the mechanics, the forms and the proofs need besides.
mount, k, x, theta, r, tau, start = sp.symbols("mount k x theta r tau c", real=True)
R4, R5, rho3, span = sp.symbols("R4 R5 rho3 L", positive=True)
s, sB, sC, sD, omega_satellite, omega_out = sp.symbols("s s_B s_C s_D omega_5 omega_3", real=True)
alpha, beta, gamma, delta = sp.symbols("alpha beta gamma delta", real=True)
alpha_double, beta_double, gamma_double = sp.symbols(
    "alpha_double beta_double gamma_double", real=True
)
both, lesser, swing, lever, shift, rise, y, nearest = sp.symbols(
    "both less swing lever shift rise y nearest", real=True
)
phi6_closed, phi6_counted, mount_counted = sp.symbols("phi6 phi6_counted mount_counted", real=True)
lam, mu, width, eta = sp.symbols("lambda mu T eta", positive=True)
quotient, t_place = sp.symbols("q_place t_place", positive=True)
nu, xi, tangent = sp.symbols("nu xi U", real=True)
m, turns = sp.symbols("m m_turns", integer=True)
POSITIVE = sp.Interval.open(0, sp.oo)
# A proper oval or ellipse, not a circle.
OVAL = sp.Interval.open(0, 1)
