"""Letters and mechanics of paper 2, and what follows: ratio, position and acceleration.

Conventions: angles are positive in the direction of the carrier's rotation; distances on the
line A-C are positive from A towards C; at phi1 = 0 a major axis of the sun 4 points to C and the
major axes of the satellite's wheels 5 and 6 stand at right angles, that of 6 along the line A-C.
"""

from functools import cache
from pathlib import Path

import sympy as sp

from mechproof.document.transcription import Transcription
from mechproof.record import ANGLE, LENGTH, Variable, list_given

from .._algebra import solve_linear
from .._eccentric import radius_from_focus
from .._metrology import POSITIVE, TYPE_A_VARIABLES
from .._readings import ENCODER_VARIABLES

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
phi1, phi3, phi, phi5, phi6 = PRINT.symbols("phi1 varphi3 varphi varphi5 varphi6")
e, e1, e2, a, rho, rho5, rho6 = PRINT.symbols("e e1 e2 a rho rho5 rho6")
omega1, omega3, VC, VD = PRINT.symbols("omega1 omega3 v_C v_D")
AC, EC, BC, BD, CD, DE = PRINT.symbols("AC EC BC BD CD DE")
(ratio_symbol,) = PRINT.symbols("varphi3'")

# Further symbols of the mechanics, the forms and the proofs.
mount, k, x, theta, tau, start = sp.symbols("mount k x theta tau c", real=True)
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
# A proper oval or ellipse, not a circle.
OVAL = sp.Interval.open(0, 1)


def lead(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle by which the driven wheel of an oval pair is ahead of its driver."""
    return sp.atan2(eccentricity * sp.sin(2 * driver), 1 - eccentricity * sp.cos(2 * driver))


def driven_angle(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle of the driven wheel of an oval pair, 0 where that of the driver is 0."""
    return driver + lead(eccentricity, driver)


def count_branches(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle of the driven wheel by one arctangent, its branches counted by floor."""
    branch = sp.atan((1 + eccentricity) / (1 - eccentricity) * sp.tan(driver))
    return branch + sp.pi * sp.floor(driver / sp.pi + sp.S.Half)


# Velocity plan on the line A-C at one instant, the sun 4 at rest: the satellite turns about B.
point_c = 2 * a
point_b = point_c - rho5
point_d = point_c - rho6
satellite_velocity = omega1 * point_c + omega_satellite * (s - point_c)
rolling = solve_linear(satellite_velocity.subs(s, point_b), omega_satellite)
driven = sp.Eq(omega_out * point_d, satellite_velocity.subs({s: point_d, omega_satellite: rolling}))
ratio_by_plan = solve_linear(driven, omega_out) / omega1

PLACES = {sB: point_b, sC: point_c, sD: point_d}

# Inversion (Willis), in units of omega1: seen from the carrier the sun turns with -1, and each
# external mesh reverses the sense of rotation.
sun_against_carrier = sp.Integer(-1)
satellite_against_carrier = -sun_against_carrier * (2 * a - rho5) / rho5
wheel_3_against_carrier = -satellite_against_carrier * rho6 / (2 * a - rho6)
ratio_by_inversion = 1 + wheel_3_against_carrier

# At half the polar angle, the oval has the radius of the ellipse seen from a focus.
focal_radius = radius_from_focus(a, e, theta)


def oval_radius(eccentricity: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Radius of the oval, by the cosine of twice the polar angle."""
    return focal_radius.subs({e: eccentricity, sp.cos(theta): cosine})


@cache
def pair_ratio(eccentricity: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Speed of the driven wheel over its driver's, both external: the quotient of the radii."""
    radius = oval_radius(eccentricity, cosine)
    return sp.cancel(radius / (2 * a - radius))


def roll_reduced(eccentricity: sp.Expr, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Cosine and sine of twice the angle of the driven wheel, by `roll` in the fewest terms."""
    cosine, sine = sp.cos(2 * angle), sp.sin(2 * angle)
    square = 1 + eccentricity**2 - 2 * eccentricity * cosine
    return (
        ((1 + eccentricity**2) * cosine - 2 * eccentricity) / square,
        (1 - eccentricity**2) * sine / square,
    )


# The two oval pairs in series: sun 4 turned by phi1 against the carrier, wheel 6 by phi6 + mount.
COS_4 = sp.cos(2 * phi1)
sun_radius = oval_radius(e1, COS_4)
cos_6, sin_6 = roll_reduced(e1, phi1)
cos_mounted = cos_6 * sp.cos(2 * mount) - sin_6 * sp.sin(2 * mount)
wheel_3_rate = pair_ratio(e1, COS_4) * pair_ratio(e2, cos_mounted)


def integrate(ratio: sp.Expr) -> sp.Integral:
    """Integral of a ratio from phi1 = 0, where phi3 = 0."""
    return sp.Integral(ratio.subs(phi1, tau), (tau, 0, phi1))


# Definitions of letters, on the line A-C and by the mechanics; the kernels state the domain in this
# order.
VARIABLES = (
    Variable(R4, "radius of a cylindrical sun 4", LENGTH, POSITIVE),
    Variable(R5, "radius of a cylindrical wheel 5", LENGTH, POSITIVE),
    *PRINT.give(
        {
            AC: sC,
            BC: sC - sB,
            BD: sB - sD,
            CD: sC - sD,
            EC: sC,
            DE: sD,
            VC: omega1 * sC,
            VD: omega3 * sD,
        }
    ),
    Variable(
        mount,
        "turn of wheel 6 on its shaft, from its place in the paper",
        ANGLE,
        sign="as phi1",
        letter="m",
    ),
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
        gamma, "coefficient of tan(chi)", given=4 * (1 + e1) * e2 * sp.sin(mount) * sp.cos(mount)
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
    Variable(lesser, "what beta/(1 - e2) has without a turn of wheel 6", given=(1 - e1) * (1 - e2)),
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
    Variable(span, "distance of two fixed axes", LENGTH, POSITIVE),
    Variable(sB, "coordinate of B on the line A-C", LENGTH),
    Variable(sC, "coordinate of C", LENGTH, POSITIVE),
    Variable(sD, "coordinate of D", LENGTH),
    Variable(theta, "x as a variable of its own", ANGLE),
    Variable(width, "tangent of half the angle x from the double zero", within=POSITIVE),
    Variable(quotient, "quotient of an oval pair's speeds at a place", within=POSITIVE),
    Variable(t_place, "tangent of half of x counted from there", within=POSITIVE),
    Variable(eta, "ratio up to which the output counts as at rest", within=POSITIVE),
    *TYPE_A_VARIABLES,
    *ENCODER_VARIABLES,
)
read = PRINT.reader(VARIABLES)


# Both pairs are Moebius maps of tangents, and so is their composition:
# tan(chi) = lambda*t/(mu + nu*t), t = tan(phi1), chi the turn of wheel 3 against the carrier,
# reversed. mu*cos(phi1) + nu*sin(phi1) + i*lambda*sin(phi1) has the argument chi.
def ratio_of_map(p: sp.Expr, q_: sp.Expr, g: sp.Expr) -> sp.Expr:
    """1 - d chi/d phi1 for the coefficients lambda, mu, nu = p, q_, g."""
    square = q_**2 * (1 + COS_4) + 2 * q_ * g * sp.sin(2 * phi1) + (p**2 + g**2) * (1 - COS_4)
    return 1 - 2 * p * q_ / square


def position_of_map(p: sp.Expr, q_: sp.Expr, g: sp.Expr, difference: sp.Expr) -> sp.Expr:
    """phi1 - chi as one argument; `difference` is p - q_."""
    return sp.atan2(
        g * (1 - COS_4) - difference * sp.sin(2 * phi1),
        p + q_ + (q_ - p) * COS_4 + g * sp.sin(2 * phi1),
    )


# The same as the argument of a constant vector and one that turns about 1, as for one pair.
square_sum = (lam + mu) ** 2 + nu**2
along, across = lam**2 - mu**2 + nu**2, -2 * mu * nu
position_by_one_pair = -sp.atan2(-nu, lam + mu) - sp.atan2(
    along * sp.sin(2 * phi1) - across * COS_4,
    square_sum - along * COS_4 - across * sp.sin(2 * phi1),
)
GIVEN = list_given(VARIABLES)
COEFFICIENTS = tuple(GIVEN[s] for s in (alpha_double, beta_double, gamma_double))

t = sp.tan(phi1)
POSITION = position_of_map(alpha, beta, gamma, delta)
RATIO = ratio_of_map(alpha, beta, gamma)
ACCELERATION = sp.diff(RATIO, phi1)

# Mounted as in the paper the two eccentricities act as one.
E_SERIES = (e1 + e2) / (1 + e1 * e2)


def position_of_one(eccentricity: sp.Expr) -> sp.Expr:
    """Position function of two pairs that act like one."""
    return phi1 - driven_angle(eccentricity, phi1)


def ratio_of_one(eccentricity: sp.Expr) -> sp.Expr:
    """Transmission ratio of two pairs that act like one."""
    return 1 - pair_ratio(eccentricity, COS_4)


# Pair 4-5 cylindrical: the satellite turns by (R4/R5) phi1 against the carrier.
RATIO_CYLINDRICAL = 1 - k * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x))
POSITION_CYLINDRICAL = (R5 - R4) / R5 * phi1 - sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
ACCELERATION_CYLINDRICAL = sp.diff(RATIO_CYLINDRICAL, x) * 2 * k
AXES_45 = {a: (R4 + R5) / 2, rho5: R5}
ratio_with_cylinders_45 = ratio_by_plan.subs(AXES_45).subs(
    rho6, oval_radius(e2, sp.cos(2 * R4 / R5 * phi1)).subs(AXES_45)
)
explicit = {x: 2 * R4 / R5 * phi1, k: R4 / R5}
ratio_45, position_45 = (f.subs(explicit) for f in (RATIO_CYLINDRICAL, POSITION_CYLINDRICAL))
