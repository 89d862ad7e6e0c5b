"""Letters and mechanics of paper 1: velocity plan, inversion, ellipse, position; its Table 1.

Angles are positive in the direction of the carrier's rotation; distances on the line A-C are
positive from A towards C and B; lengths in mm, angles in rad.
"""

from pathlib import Path

import sympy as sp

from mechproof.document.transcription import Transcription
from mechproof.latex import Reader
from mechproof.record import ANGLE, LENGTH, Part, Variable

from .._algebra import solve_linear
from .._eccentric import radius_from_focus, roll
from .._metrology import TYPE_A_VARIABLES
from .._readings import ENCODER_VARIABLES

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
phi1, phi3, phi5, R1, R2, e, a, rho, x = PRINT.symbols("phi1 phi3 phi5 R1 R2 e a rho x")
a1, b1, C, omega1, omega3 = PRINT.symbols("a1 b1 C omega1 omega3")
AC, BC, CD, BD, DE, VC, VD = PRINT.symbols("AC BC CD BD DE V_C V_D")
ratio_symbol, slope = PRINT.symbols("phi3' dphi3/dphi1")
k, nearest, U, tau, T, misfit, c = sp.symbols("k nearest U tau T delta c", real=True)
at_b, at_c, at_d = sp.symbols("s_B s_C s_D", real=True)
square, root_acceleration, peak_acceleration, root_jerk = sp.symbols(
    "square root_acceleration peak_acceleration root_jerk", real=True
)
largest_wanted, smallest_wanted, quotient_wanted, non_uniformity_wanted = sp.symbols(
    "largest smallest quotient non_uniformity", real=True
)
ABOVE_ONE = sp.Interval.open(1, sp.oo)
turns = sp.Symbol("m_turns", integer=True)
nu, E = sp.symbols("nu E", positive=True)

theta = sp.Symbol("theta", real=True)
focal_radius = radius_from_focus(a, e, theta)

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
            C: sp.S.Zero,
        }
    ),
    *TYPE_A_VARIABLES,
    *ENCODER_VARIABLES,
    Variable(nearest, "least focal distance over a, a sum of its own", given=1 - e),
    Variable(square, "1 + e**2", given=1 + e**2, letter="p"),
    Variable(
        root_acceleration,
        "root of what the peak of the acceleration is found from",
        given=sp.sqrt(square**2 + 32 * e**2),
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
        given=sp.sqrt(3 * square**2 + 24 * e**2),
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
        within=sp.Interval(1, sp.oo),
        letter="q",
    ),
    Variable(
        non_uniformity_wanted,
        "(largest - smallest)/mean of the ratio of a design",
        within=sp.Interval(0, sp.oo),
        letter=r"\delta",
    ),
    Variable(at_b, "coordinate of B on the line A-C", LENGTH),
    Variable(at_c, "coordinate of C", LENGTH, sp.Interval.open(0, sp.oo)),
    Variable(at_d, "coordinate of D", LENGTH),
    Variable(U, "tg(x/2) as a variable of integration's limit"),
    Variable(c, "cos(x) as a variable of its own", within=sp.Interval(-1, 1)),
    Variable(misfit, "turn of wheel 6 on its shaft, from its place", ANGLE),
    Variable(turns, "whole turns of x", within=sp.S.Naturals0),
    Variable(nu, "number of terms of a series", within=sp.Interval.open(0, sp.oo)),
    Variable(E, "e**nu", within=sp.Interval.open(0, sp.oo)),
    Variable(T, "nu*x", ANGLE),
)
READER = Reader(VARIABLES, PRINT.notation)

BRANCH = Part("|x| < pi, the first branch of the half-angle", {x: sp.Interval.open(-sp.pi, sp.pi)})
UP_TO_ONE = Part("e >= 0", {e: sp.Interval(0, 1)})

# Table 1: R1, R2, e.
VARIANTS = {
    1: (66, 16, sp.Rational("0.28")),
    2: (66, 16, sp.Rational("0.475")),
    3: (80, 30, sp.Rational("0.28")),
    4: (80, 30, sp.Rational("0.475")),
}

# Velocity plan on the line A-C at one instant. The carrier turns about A = E = 0, the satellite
# rolls inside the fixed epicycle, so the point B at the coordinate R1 is at rest.
s, omega_satellite, omega_out = sp.symbols("s omega_5 omega_3", real=True)
centre_c = solve_linear(sp.Eq(at_c + R2, R1), at_c)
satellite_velocity = omega1 * centre_c + omega_satellite * (s - centre_c)
rolling = solve_linear(satellite_velocity.subs(s, R1), omega_satellite)
point_d = centre_c - rho
PLACES = {at_b: R1, at_c: centre_c, at_d: point_d}
driven = sp.Eq(omega_out * point_d, satellite_velocity.subs({s: point_d, omega_satellite: rolling}))
ratio_by_plan = solve_linear(driven, omega_out) / omega1

# Inversion (Willis), in units of omega1: seen from the carrier the epicycle turns with -1, an
# internal mesh keeps the sense of rotation, an external one reverses it.
satellite_against_carrier = -k
wheel_3_against_carrier = -satellite_against_carrier * rho / (2 * a - rho)
ratio_by_inversion = 1 + wheel_3_against_carrier


def radius_of_mate(angle: sp.Expr) -> sp.Expr:
    """Radius of the congruent ellipse at the angle it has reached by rolling from its far end.

    Its polar angle is measured from the side away from its own centre of rotation.
    """
    cos_turned, _ = roll(e, angle)
    return a * (1 - e**2) / (1 + e * cos_turned)


# Position: the ratio integrated from phi10 = 0, phi30 = 0, over any number of turns.
on_ellipse = wheel_3_against_carrier.subs(rho, focal_radius.subs(theta, k * tau))
above, below = sp.fraction(sp.cancel(on_ellipse))
position = sp.Integral(1 + sp.factor_terms(above) / below, (tau, 0, phi1))
lead = sp.atan2(e * sp.sin(x), 1 - e * sp.cos(x))
position_closed = (1 + k) * phi1 + 2 * lead
position_principal = phi1 + 2 * sp.atan((1 + e) / (1 - e) * sp.tan(x / 2))

# Planar vectors for the sentences of the velocity plan.
along_carrier = sp.Matrix([sp.cos(phi1), sp.sin(phi1)])
axis_c, axis_b = along_carrier * centre_c, along_carrier * R1
quarter_turn = sp.Matrix([[0, -1], [1, 0]])


def velocity_at(distance: sp.Expr) -> sp.Matrix:
    """Velocity of the carrier's point at a distance from the fixed axis, in units of omega1."""
    return sp.diff(along_carrier * distance, phi1)


velocity_c = velocity_at(centre_c)
velocity_b = velocity_c + (rolling / omega1) * quarter_turn * (axis_b - axis_c)

# Non-uniformity of the ratio, (largest - smallest)/mean.
largest = 1 + k * (1 + e) / (1 - e)
smallest = 1 + k * (1 - e) / (1 + e)
non_uniformity = (largest - smallest) / (1 + k)

RATIO = 1 + k * (1 - e**2) / (1 + e**2 - 2 * e * sp.cos(x))
ACCELERATION = sp.diff(RATIO, x) * k
JERK = sp.diff(ACCELERATION, x) * k
