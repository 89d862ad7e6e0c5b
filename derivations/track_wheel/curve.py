"""Part three: the track and the position errors of its points."""

from __future__ import annotations

import sympy as sp

from mechproof.record import ANGLE, Variable

from .notation import coordinates, lengths, positive, real

radius, ball_radius, thickness, millimetre = positive("R r_b H_s mm")
(amplitude,) = real("A")
(any_radius,), (any_shift,) = positive("R_any"), real("A_any")
periods = sp.Symbol("z", integer=True, positive=True)
(phi,) = real("phi")
radius_vector, planar_error, spatial_error = positive("rho Delta_Sigma^XY Delta_Sigma^XYZ")
POSITION_ERROR = error_x, error_y, error_z = real("Delta_x0 Delta_y0 Delta_z0")

CURVE_VARIABLES = (
    *lengths(
        {
            radius: (
                "radius of the circle in (16)",
                "R",
            ),
            amplitude: (
                "shift of the circle, amplitude of the multi-period curve",
                "A",
            ),
            ball_radius: ("radius of the ball",),
            thickness: (
                "thickness of the part",
                "H_s",
            ),
            millimetre: ("the unit of length",),
            any_radius: ("radius of any circle",),
            radius_vector: ("radius vector of a point of the curve",),
            planar_error: (
                "position error in the end plane",
                r"\Delta_\Sigma^{XY}",
            ),
            spatial_error: (
                "position error in space",
                r"\Delta_\Sigma^{XYZ}",
            ),
        }
    ),
    Variable(periods, "number of periods", within=sp.S.Naturals, latex=("z",)),
    Variable(phi, "polar angle", ANGLE, sign="counter-clockwise positive", latex=(r"\varphi",)),
    *coordinates({any_shift: ("shift of any circle",)}),
    *coordinates(
        {
            symbol: (f"position error along {axis.upper()}_0", rf"\Delta {axis}_0")
            for symbol, axis in zip(POSITION_ERROR, "xyz", strict=True)
        }
    ),
)


def radius_by_sine_rule(theta: sp.Expr) -> sp.Expr:
    """Distance from the pole to a circle whose centre is at the distance A.

    In the triangle pole, centre, point the sine rule gives the angle at the point; the two
    other sides are projected on the radius vector.
    """
    at_point = sp.asin(amplitude * sp.sin(theta) / radius)
    return amplitude * sp.cos(theta) + radius * sp.cos(at_point)


def on_track(distance: sp.Expr) -> sp.ImmutableMatrix:
    """Place a point at the polar angle and the given distance from the pole."""
    return sp.ImmutableMatrix([distance * sp.cos(phi), distance * sp.sin(phi), thickness])


THETA = periods * phi
