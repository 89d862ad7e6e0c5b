"""Symbols of paper 1, what they are given by, parts of its domain and the sizes of its Table 1.

Angles are positive in the direction of the carrier's rotation; distances on the line A-C are
positive from A towards C and B; lengths in mm, angles in rad.
"""

from pathlib import Path

from sympy import Eq, Interval, Rational, S, Symbol, cos, oo, pi, sqrt, symbols

from mechproof.document.transcription import Transcription
from mechproof.latex import Reader
from mechproof.record import ANGLE, LENGTH, Part, Variable

from .._linear import solve_linear
from .._metrology import TYPE_A_VARIABLES
from .._readings import ENCODER_VARIABLES

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
phi1, phi3, phi5, R1, R2, e, a, rho, x = PRINT.symbols("phi1 phi3 phi5 R1 R2 e a rho x")
a1, b1, C, omega1, omega3 = PRINT.symbols("a1 b1 C omega1 omega3")
AC, BC, CD, BD, DE, VC, VD = PRINT.symbols("AC BC CD BD DE V_C V_D")
ratio_symbol, slope = PRINT.symbols("phi3' dphi3/dphi1")
k, nearest, U, tau, T, misfit, c = symbols("k nearest U tau T delta c", real=True)
at_b, at_c, at_d = symbols("s_B s_C s_D", real=True)
square, root_acceleration, peak_acceleration, root_jerk = symbols(
    "square root_acceleration peak_acceleration root_jerk", real=True
)
largest_wanted, smallest_wanted, quotient_wanted, non_uniformity_wanted = symbols(
    "largest smallest quotient non_uniformity", real=True
)
ABOVE_ONE = Interval.open(1, oo)
turns = Symbol("m_turns", integer=True)
nu, E = symbols("nu E", positive=True)

# Ellipse seen from a focus: the distances to both foci (2 a e apart) add up to 2 a.
r, theta = symbols("r theta", real=True)
second_focus_squared = r**2 - 4 * a * e * r * cos(theta) + 4 * a**2 * e**2
focal_radius = solve_linear(Eq((2 * a - r) ** 2, second_focus_squared), r)

VARIABLES = (
    Variable(k, "ratio of the cylindrical radii", given=R1 / R2),
    *PRINT.give(
        {
            a: (R1 - R2) / 2,
            phi5: -R1 / R2 * phi1,
            x: k * phi1,
            a1: 1 + e**2,
            b1: 2 * e,
            rho: focal_radius.subs(theta, phi5),
            AC: at_c,
            BC: at_b - at_c,
            CD: at_c - at_d,
            BD: at_b - at_d,
            DE: at_d,
            VC: omega1 * at_c,
            VD: omega3 * at_d,
            C: S.Zero,
        }
    ),
    *TYPE_A_VARIABLES,
    *ENCODER_VARIABLES,
    Variable(nearest, "least focal distance over a, a sum of its own", given=1 - e),
    Variable(square, "1 + e**2", given=1 + e**2, letter="p"),
    Variable(
        root_acceleration,
        "root of what the peak of the acceleration is found from",
        given=sqrt(square**2 + 32 * e**2),
        letter="w_2",
    ),
    Variable(
        peak_acceleration,
        "(1 - cos x)/(1 - e)**2 where the acceleration is extreme, but for a factor",
        given=1 + (1 + e) ** 2 / (root_acceleration + 6 * e),
        letter="v",
    ),
    Variable(
        root_jerk,
        "root of what the peak of the jerk is found from",
        given=sqrt(3 * square**2 + 24 * e**2),
        letter="w_3",
    ),
    Variable(
        largest_wanted,
        "largest ratio that a design is to have",
        within=ABOVE_ONE,
        letter=r"i_{\max}",
    ),
    Variable(
        smallest_wanted,
        "smallest ratio that a design is to have",
        within=ABOVE_ONE,
        letter=r"i_{\min}",
    ),
    Variable(
        quotient_wanted,
        "largest over smallest ratio of a design",
        within=Interval(1, oo),
        letter="q",
    ),
    Variable(
        non_uniformity_wanted,
        "(largest - smallest)/mean of the ratio of a design",
        within=Interval(0, oo),
        letter=r"\delta",
    ),
    Variable(at_b, "coordinate of B on the line A-C", LENGTH),
    Variable(at_c, "coordinate of C", LENGTH, Interval.open(0, oo)),
    Variable(at_d, "coordinate of D", LENGTH),
    Variable(U, "tg(x/2) as a variable of integration's limit"),
    Variable(c, "cos(x) as a variable of its own", within=Interval(-1, 1)),
    Variable(misfit, "turn of wheel 6 on its shaft, from its place", ANGLE),
    Variable(turns, "whole turns of x", within=S.Naturals0),
    Variable(nu, "number of terms of a series", within=Interval.open(0, oo)),
    Variable(E, "e**nu", within=Interval.open(0, oo)),
    Variable(T, "nu*x", ANGLE),
)
READER = Reader(VARIABLES, PRINT.notation)

BRANCH = Part("|x| < pi, the first branch of the half-angle", {x: Interval.open(-pi, pi)})
UP_TO_ONE = Part("e >= 0", {e: Interval(0, 1)})

# Table 1: R1, R2, e.
VARIANTS = {
    1: (66, 16, Rational("0.28")),
    2: (66, 16, Rational("0.475")),
    3: (80, 30, Rational("0.28")),
    4: (80, 30, Rational("0.475")),
}
