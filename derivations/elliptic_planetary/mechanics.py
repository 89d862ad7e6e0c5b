"""The mechanics of paper 1: velocity plan, inversion, ellipse, position."""

import sympy as sp

from .._linear import solve_linear
from .symbols import *

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

    It has turned by angle + 2 delta, tan(delta) = y/x below; its polar angle is measured from
    the side away from its own centre of rotation.
    """
    y, x_ = e * sp.sin(angle), 1 - e * sp.cos(angle)
    cos_2delta = (x_**2 - y**2) / (x_**2 + y**2)
    sin_2delta = 2 * x_ * y / (x_**2 + y**2)
    cos_turned = sp.cos(angle) * cos_2delta - sp.sin(angle) * sin_2delta
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
