"""How far the blank may be tilted and offset: the largest errors of the track, and their inverses.

The track looks the same from all its crests, so that a tilt about any horizontal axis may be one
about X_0. Then y_13 is the distance of a point from the vertical plane of the axis, on the rising
side; the worst offset e is the other way, and the largest y_13 is the radius rho of a crest.
"""

import sympy as sp

from mechproof.record import *

from ..mechanics import *

a, b, c = SHIFT
_, y, z = SURFACE_POINT
ZERO = sp.S.Zero
SINE, VERSINE = (
    2 * tilt_tangent / (1 + tilt_tangent**2),
    2 * tilt_tangent**2 / (1 + tilt_tangent**2),
)
TILTED = sp.ImmutableMatrix(PRINTED_15.subs({beta: 0, gamma: 0, a: 0, b: -eccentricity, c: 0}))


def inwards(distance: sp.Expr) -> sp.Expr:
    """Error in the plane, towards the axis."""
    return eccentricity + distance * VERSINE + thickness * SINE


def squared(distance: sp.Expr) -> sp.Expr:
    """Error in space, squared."""
    return inwards(distance) ** 2 + (distance * SINE - thickness * VERSINE) ** 2


# At the distances d and f from the planes of the crests on both sides: y_13 = rho - d = f - rho.
CREST, ANY = (nearer + farther) / 2, (farther - nearer) / 2
OVER_PLANE = planar_error - eccentricity
OVER_SPACE = (spatial_error - eccentricity) * (spatial_error + eccentricity)
REACH = radius_vector**2 + thickness**2 + eccentricity * radius_vector
SPATIAL_HALF = 2 * eccentricity * thickness
# For the equation q t**2 + 2 b t = g in t = tan(alpha/2), sqrt(b**2 + q g).
PLANAR_SQUARE = thickness**2 + 2 * radius_vector * OVER_PLANE - OVER_PLANE**2
SPATIAL_SQUARE = SPATIAL_HALF**2 + OVER_SPACE * (4 * REACH - OVER_SPACE)
PLANAR_ROOT = OVER_PLANE / (thickness + sp.sqrt(PLANAR_SQUARE))
SPATIAL_ROOT = OVER_SPACE / (SPATIAL_HALF + sp.sqrt(SPATIAL_SQUARE))
IN_PLANE = Part(
    "e <= Delta^XY <= e + rho + H_s",
    where=(OVER_PLANE >= 0, radius_vector + thickness >= OVER_PLANE),
)
IN_SPACE = Part(
    "e <= Delta^XYZ, the tilt up to a right angle",
    where=(spatial_error >= eccentricity, 2 * REACH + 2 * eccentricity * thickness >= OVER_SPACE),
)

ROWS = (
    ours(
        "design, tilt and offset",
        r"\Delta y_0=-(e+y_{13}(1-\cos\alpha)+z_{13}\sin\alpha),\ "
        r"\Delta z_0=y_{13}\sin\alpha-z_{13}(1-\cos\alpha)",
        Equality(
            TILTED,
            sp.ImmutableMatrix(
                [
                    0,
                    -(eccentricity + y * (1 - sp.cos(alpha)) + z * sp.sin(alpha)),
                    y * sp.sin(alpha) - z * (1 - sp.cos(alpha)),
                ]
            ),
        ),
        note="By (15), for a tilt about X_0 and an offset against the side that rises; beta and "
        "gamma are 0.",
        quantities=("planar_error", "spatial_error"),
    ),
    ours(
        "design, worst point",
        r"|\Delta y_0|\text{ and }\Delta y_0^2+\Delta z_0^2\text{ are largest at }y_{13}=\rho,\ "
        r"\alpha\le\tfrac\pi2",
        all_of(
            not_above(inwards(ANY), inwards(CREST)),
            not_above(-inwards(ANY), inwards(CREST)),
            not_above(squared(ANY), squared(CREST)),
        ),
        note="With t = tan(alpha/2) from 0 to 1, y_13 = rho - d = f - rho, d and f not negative. "
        "An offset in another direction adds no more than e in the plane, and nothing across it.",
        quantities=("planar_error", "spatial_error"),
    ),
    ours(
        "design, one tilt at most",
        r"\frac{\partial}{\partial t}|\Delta y_0|>0,\ "
        r"\frac{\partial}{\partial t}(\Delta y_0^2+\Delta z_0^2)>0\text{ at }y_{13}=\rho",
        all_of(
            less(ZERO * tilt_tangent, sp.diff(inwards(radius_vector), tilt_tangent)),
            less(ZERO * tilt_tangent, sp.diff(squared(radius_vector), tilt_tangent)),
        ),
        note="t = tan(alpha/2), above 0 and up to 1; without a tilt both errors are e.",
        quantities=("planar_error", "spatial_error"),
    ),
    ours(
        "design, tilt for an error in the plane",
        r"\tan\tfrac\alpha2=\frac g{H_s+\sqrt{H_s^2+g(2\rho-g)}},\ g=\Delta_\Sigma^{XY}-e",
        Equality(inwards(radius_vector).subs(tilt_tangent, PLANAR_ROOT), planar_error),
        on=IN_PLANE,
        quantities=("tilt_of_planar_error",),
    ),
    ours(
        "design, tilt for an error in space",
        r"\tan\tfrac\alpha2=\frac g{2eH_s+\sqrt{4e^2H_s^2+g(4(\rho^2+H_s^2+e\rho)-g)}},\ "
        r"g=(\Delta_\Sigma^{XYZ})^2-e^2",
        Equality(squared(radius_vector).subs(tilt_tangent, SPATIAL_ROOT), spatial_error**2),
        on=IN_SPACE,
        quantities=("tilt_of_spatial_error",),
    ),
)
