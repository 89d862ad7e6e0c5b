"""Symbols of paper 2 and how they are printed.

Conventions: angles are positive in the direction of the carrier's rotation; distances on the
line A-C are positive from A towards C; at phi1 = 0 a major axis of the sun 4 points to C and the
major axes of the satellite's wheels 5 and 6 stand at right angles, that of 6 along the line A-C.
"""

from __future__ import annotations

import sympy as sp

from mechproof.latex import Reader
from mechproof.record import ANGLE, FREQUENCY, LENGTH, SPEED, Notation, Variable

from .._metrology import TYPE_A_VARIABLES
from .._readings import ENCODER_VARIABLES

phi1, mount = sp.symbols("phi1 mount", real=True)
R4, R5 = sp.symbols("R4 R5", positive=True)
R3, R6 = sp.symbols("R3 R6", positive=True)
e, e1, e2 = sp.symbols("e e1 e2", real=True)
a, rho, rho3, rho4, rho5, rho6, span = sp.symbols("a rho rho3 rho4 rho5 rho6 L", positive=True)
phi, phi5, phi6, start = sp.symbols("varphi varphi5 varphi6 c", real=True)
omega1, omega3 = sp.symbols("omega1 omega3", real=True)
VC, VD, AC, BC, BD, CD, DE, EC = sp.symbols("v_C v_D AC BC BD CD DE EC", real=True)
sB, sC, sD = sp.symbols("s_B s_C s_D", real=True)
phi3 = sp.Symbol("varphi3", real=True)
ratio_symbol, acceleration_symbol = sp.symbols("varphi3' varphi3''", real=True)
k, x = sp.symbols("k x", real=True)
alpha, beta, gamma, delta = sp.symbols("alpha beta gamma delta", real=True)
alpha_double, beta_double, gamma_double = sp.symbols(
    "alpha_double beta_double gamma_double", real=True
)
both, less, swing, lever, shift, rise, y, nearest = sp.symbols(
    "both less swing lever shift rise y nearest", real=True
)
phi6_closed, phi6_counted, mount_counted = sp.symbols("phi6 phi6_counted mount_counted", real=True)
lam, mu = sp.symbols("lambda mu", positive=True)
nu, xi, tangent = sp.symbols("nu xi U", real=True)
width, eta = sp.symbols("T eta", positive=True)
lowest, highest = sp.symbols("q_min q_max", real=True)
m, index = sp.symbols("m k", integer=True)
tau, theta, r = sp.symbols("tau theta r", real=True)
turns = sp.Symbol("m_turns", integer=True)

POSITIVE = sp.Interval.open(0, sp.oo)
ECCENTRICITY = sp.Interval.Ropen(0, 1)


def lead(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """By how much the driven wheel of an oval pair is ahead of its driver."""
    return sp.atan2(eccentricity * sp.sin(2 * driver), 1 - eccentricity * sp.cos(2 * driver))


def driven_angle(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle of the driven wheel of an oval pair, 0 where that of the driver is 0."""
    return driver + lead(eccentricity, driver)


def count_branches(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle of the driven wheel by one arctangent, its branches counted by floor."""
    branch = sp.atan((1 + eccentricity) / (1 - eccentricity) * sp.tan(driver))
    return branch + sp.pi * sp.floor(driver / sp.pi + sp.S.Half)


# What (1), (7) and (10) say together of the symbols of the output.
AS_PRINTED = "positive against the carrier's direction of rotation"

VARIABLES = (
    Variable(
        phi1,
        "angle of the carrier 1",
        ANGLE,
        sign="positive in its direction of rotation",
        latex=(r"\varphi_1",),
    ),
    Variable(
        phi3,
        "angle of wheel 3",
        ANGLE,
        sign=AS_PRINTED,
        latex=(r"\varphi_3(\varphi_1)", r"\varphi_3"),
    ),
    Variable(
        mount, "turn of wheel 6 on its shaft, from its place in the paper", ANGLE, sign="as phi1"
    ),
    Variable(R4, "radius of a cylindrical sun 4", LENGTH, POSITIVE),
    Variable(R5, "radius of a cylindrical wheel 5", LENGTH, POSITIVE),
    Variable(R3, "radius of a cylindrical wheel 3", LENGTH, POSITIVE),
    Variable(R6, "radius of a cylindrical wheel 6", LENGTH, POSITIVE),
    Variable(
        e, "eccentricity of the ellipse that generates an oval", within=ECCENTRICITY, latex=("e",)
    ),
    Variable(e1, "eccentricity of the oval pair 4-5", within=ECCENTRICITY, latex=("e_1",)),
    Variable(e2, "eccentricity of the oval pair 6-3", within=ECCENTRICITY, latex=("e_2",)),
    Variable(k, "ratio of the cylindrical wheels 4 and 5", given=R4 / R5),
    Variable(x, "twice the turn of the satellite against the carrier", ANGLE, given=2 * k * phi1),
    Variable(
        alpha,
        "coefficient of tan(chi) = alpha*t/(beta + gamma*t), t = tan(phi1)",
        given=(1 + e1) * (1 + e2) * (1 - e2),
    ),
    Variable(
        beta,
        "coefficient of tan(chi)",
        given=(1 - e1) * ((1 - e2) ** 2 * sp.cos(mount) ** 2 + (1 + e2) ** 2 * sp.sin(mount) ** 2),
    ),
    Variable(
        gamma,
        "coefficient of tan(chi)",
        given=4 * (1 + e1) * e2 * sp.sin(mount) * sp.cos(mount),
    ),
    Variable(
        delta,
        "alpha - beta",
        given=2
        * ((e1 + e2) * (1 - e2) * sp.cos(mount) ** 2 + (e1 - e2) * (1 + e2) * sp.sin(mount) ** 2),
    ),
    Variable(alpha_double, "alpha, multiplied out", given=(1 + e1) * (1 - e2**2)),
    Variable(
        beta_double,
        "beta by the double mount",
        given=(1 - e1) * (1 + e2**2 - 2 * e2 * sp.cos(2 * mount)),
    ),
    Variable(gamma_double, "gamma by it", given=2 * (1 + e1) * e2 * sp.sin(2 * mount)),
    Variable(both, "alpha/(1 - e2)", given=(1 + e1) * (1 + e2)),
    Variable(less, "what beta/(1 - e2) has without a turn of wheel 6", given=(1 - e1) * (1 - e2)),
    Variable(lever, "part of shift and rise", given=4 * e2 * sp.sin(mount) / (1 - e2)),
    Variable(shift, "the rest of beta/(1 - e2)", given=lever * (1 - e1) * sp.sin(mount)),
    Variable(rise, "gamma/(1 - e2)", given=lever * (1 + e1) * sp.cos(mount)),
    Variable(swing, "both - less", given=2 * (e1 + e2)),
    Variable(y, "what the turn of wheel 6 adds", given=shift + rise * sp.tan(phi1)),
    Variable(nearest, "least focal distance over a, a sum of its own", given=1 - e2),
    Variable(lam, "alpha, any positive number", within=POSITIVE),
    Variable(mu, "beta, any positive number", within=POSITIVE),
    Variable(nu, "gamma, any real number"),
    Variable(xi, "part of beta, any real number"),
    Variable(tangent, "tg(phi1) as a variable of its own"),
    Variable(a, "major semi-axis of the generating ellipse", LENGTH, POSITIVE, latex=("a",)),
    Variable(phi, "polar angle of an oval from its major axis", ANGLE, latex=(r"\varphi",)),
    Variable(
        rho,
        "radius of an oval at the polar angle",
        LENGTH,
        POSITIVE,
        latex=(r"\rho(\varphi)", r"\rho"),
    ),
    Variable(phi6, "angle of wheel 6 against the carrier", ANGLE, latex=(r"\varphi_6",)),
    Variable(phi5, "angle of wheel 5 against the carrier", ANGLE, latex=(r"\varphi_5",)),
    Variable(phi6_closed, "the integral (5)", ANGLE, given=driven_angle(e1, phi1)),
    Variable(phi6_counted, "the same, branches counted", ANGLE, given=count_branches(e1, phi1)),
    Variable(
        mount_counted,
        "turn of wheel 3 by the mount, branches counted",
        ANGLE,
        given=count_branches(e2, mount),
    ),
    Variable(turns, "half turns", within=sp.S.Naturals0),
    Variable(start, "constant of the integral (5)", ANGLE),
    Variable(rho3, "radius of wheel 3 at D", LENGTH, POSITIVE),
    Variable(rho4, "radius of wheel 4 at B", LENGTH, POSITIVE),
    Variable(rho5, "radius of wheel 5 at B", LENGTH, POSITIVE, latex=(r"\rho_5",)),
    Variable(rho6, "radius of wheel 6 at D", LENGTH, POSITIVE, latex=(r"\rho_6",)),
    Variable(span, "distance of two fixed axes", LENGTH, POSITIVE),
    Variable(omega1, "angular velocity of the carrier", FREQUENCY, POSITIVE, latex=(r"\omega_1",)),
    Variable(
        omega3, "angular velocity of wheel 3", FREQUENCY, sign=AS_PRINTED, latex=(r"\omega_3",)
    ),
    Variable(sB, "coordinate of B on the line A-C", LENGTH),
    Variable(sC, "coordinate of C", LENGTH, POSITIVE),
    Variable(sD, "coordinate of D", LENGTH),
    Variable(AC, "from A to C", LENGTH, given=sC, latex=("AC",)),
    Variable(BC, "from B to C", LENGTH, given=sC - sB, latex=("BC",)),
    Variable(BD, "from D to B", LENGTH, given=sB - sD, latex=("BD",)),
    Variable(CD, "from D to C", LENGTH, given=sC - sD, latex=("CD",)),
    Variable(EC, "from E to C, on the axis of A", LENGTH, given=sC, latex=("EC",)),
    Variable(DE, "from E to D", LENGTH, given=sD, latex=("DE",)),
    Variable(
        VC, "velocity of C, positive with the carrier", SPEED, given=omega1 * sC, latex=("v_C",)
    ),
    Variable(VD, "velocity of D", SPEED, given=omega3 * sD, sign=AS_PRINTED, latex=("v_D",)),
    Variable(
        ratio_symbol, "analogue of the angular velocity", sign=AS_PRINTED, latex=(r"\varphi_3'",)
    ),
    Variable(acceleration_symbol, "analogue of the angular acceleration", sign=AS_PRINTED),
    Variable(theta, "x as a variable of its own", ANGLE),
    Variable(width, "tangent of half the angle x from the double zero", within=POSITIVE),
    Variable(eta, "ratio up to which the output counts as at rest", within=POSITIVE),
    *TYPE_A_VARIABLES,
    Variable(lowest, "smallest possible measurement error"),
    Variable(highest, "largest possible measurement error"),
    *ENCODER_VARIABLES,
)

# Integrals without limits start at 0, where phi3 = phi6 = 0.
NOTATION = Notation(factors=("a", r"\rho_5"), lower_limit=sp.S.Zero)
READER = Reader(VARIABLES, NOTATION)

# A proper oval or ellipse, not a circle.
OVAL = sp.Interval.open(0, 1)
