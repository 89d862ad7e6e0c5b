"""Mechanics of paper 2: velocity plan, inversion, ovals, two pairs in series."""

from __future__ import annotations

from functools import cache

import sympy as sp

from .._linear import solve_linear
from .symbols import a, e, e1, e2, mount, omega1, phi1, r, rho5, rho6, sB, sC, sD, tau, theta

# Velocity plan on the line A-C at one instant, the sun 4 at rest: the satellite turns about B.
s, omega_satellite, omega_out = sp.symbols("s omega_5 omega_3", real=True)
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

# Ellipse seen from a focus: the distances to both foci (2 a e apart) add up to 2 a. The oval has
# at half the polar angle the radius of the ellipse.
second_focus_squared = r**2 - 4 * a * e * r * sp.cos(theta) + 4 * a**2 * e**2
focal_radius = solve_linear(sp.Eq((2 * a - r) ** 2, second_focus_squared), r)


def oval_radius(eccentricity: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Radius of the oval, by the cosine of twice the polar angle."""
    return focal_radius.subs({e: eccentricity, sp.cos(theta): cosine})


@cache
def pair_ratio(eccentricity: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Speed of the driven wheel by that of the driver, both external: the quotient of the radii."""
    radius = oval_radius(eccentricity, cosine)
    return sp.cancel(radius / (2 * a - radius))


def roll(eccentricity: sp.Expr, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Cosine and sine of twice the angle of the driven wheel, by the angle of the driver.

    It is ahead of the driver by lead = atan(y/x): see `driven_angle`.
    """
    cosine, sine = sp.cos(2 * angle), sp.sin(2 * angle)
    y, x_ = eccentricity * sine, 1 - eccentricity * cosine
    cos_2lead = (x_**2 - y**2) / (x_**2 + y**2)
    sin_2lead = 2 * x_ * y / (x_**2 + y**2)
    return cosine * cos_2lead - sine * sin_2lead, sine * cos_2lead + cosine * sin_2lead


def roll_reduced(eccentricity: sp.Expr, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Give the same as `roll` in the fewest terms."""
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
