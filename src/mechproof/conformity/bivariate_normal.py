"""The four masses of a rectangle in the plane of two correlated normal variables.

Each corner (h, k) of the plane (`conformity.plane` defines h, k and beta) has four quadrants.
With I(a, b) = 1/(2 pi) times the integral from a to b of
exp(-(h**2 + k**2 - 2 h k cos x) / (2 sin(x)**2)) dx (Plackett's derivative of the bivariate mass
with respect to the correlation, x its arc cosine):

    P(Y > h, M < k) = max(0, Phi(k) - Phi(h)) + I(0, beta)
    P(Y < h, M > k) = max(0, Phi(h) - Phi(k)) + I(0, beta)
    P(Y > h, M > k) = max(0, Phi(-k) - Phi(h)) + I(beta, pi)
    P(Y < h, M < k) = max(0, Phi(h) - Phi(-k)) + I(beta, pi)
    I(0, pi) = Phi(-max(|h|, |k|))

Every term is positive, so the smallest quadrant is as accurate as the largest. The exponent is
(h-k)**2 / (8 sin(x/2)**2) + (h+k)**2 / (8 cos(x/2)**2), and in log(tan(x/2)) the integrand is
log-concave: one Gauss panel from the end at beta to where it has died out suffices
(`conformity.arc`). Drezner and Wesolowsky (1990) and Genz (2004) integrate the same derivative
(Plackett 1954), for small correlations from 0, and add the product of two tails, in which small
quadrants cancel.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from mechproof.conformity.arc import integrate_arc
from mechproof.conformity.plane import Corner, Corners, Pair, Plane, place
from mechproof.laws.pointwise import choose, compute_where
from mechproof.laws.windows import (
    UNIT_NODES,
    UNIT_WEIGHTS,
    Array,
    complete,
    find_tails,
    integrate_density,
    normal_density,
    normal_interval,
    subtract_tails,
)

UNDERFLOW = 745.0  # exp(-745) is the smallest double
LOST = 2.0**-60  # a term this small relative to another does not change their sum


class Quadrants(NamedTuple):
    """Masses at a corner (h, k); the first word is Y's side of h, the second M's side of k."""

    above_above: Any
    above_below: Any
    below_above: Any
    below_below: Any


def integrate_sides(plane: Plane, corner: Corner, needed: Any) -> Pair:
    """Return I(0, beta), I(beta, pi): the smaller integrated if needed, the other from the sum."""
    # NaN: s = 0, I(0, beta) is 0.
    falling = np.logical_not(2 * (corner.near - corner.far) + plane.cosine <= 0)
    square = plane.tangent * plane.tangent
    arguments = (
        choose(falling, corner.near, corner.far),
        choose(falling, corner.far, corner.near),
        choose(falling, 1.0, square),
        choose(falling, square, 1.0),
    )
    # An infinite limit and s = 0 have an infinite exponent, or NaN.
    present = needed & (corner.exponent < UNDERFLOW)
    arc = compute_where(present, integrate_arc, arguments, 0.0)
    smaller = choose(present, plane.sine * corner.decay * arc, 0.0)
    # Among the smallest numbers the integral may come out above the whole; no mass is below 0.
    larger = np.maximum(corner.total - smaller, 0.0)
    return choose(falling, smaller, larger), choose(falling, larger, smaller)


def is_needed(corner: Corner, toward: Any, terms: Any) -> Any:
    """Mark where I(0, beta) of (lower, upper) or (upper, lower) is not lost in sums.

    Where the integrand falls, I(0, beta) <= exp(-exponent)/2. `terms` is the smallest of the terms
    it is added to: quadrants that contain I(0, beta) of both, or I(beta, pi) of one, of the corners
    (lower, lower) and (upper, upper), besides the mass between h and k and I(0, pi). `toward` is
    positive where h and k are ordered as at this corner of overlapping windows.
    """
    lost = corner.decay / 2 <= LOST * np.minimum(np.minimum(corner.total, corner.along), terms)
    return np.logical_not(lost & (corner.near >= corner.far) & (toward > 0))


def complete_corner(plane: Plane, corner: Corner, i: int, j: int) -> Corner:
    """Integrate the masses between close limits."""
    h, k = plane.h[i], plane.k[j]
    return Corner(
        corner.total,
        complete(corner.along, integrate_density, (np.minimum(h, k), np.abs(plane.gap[i][j]))),
        complete(corner.across, integrate_density, (np.minimum(h, -k), np.abs(h + k))),
        corner.near,
        corner.far,
        corner.exponent,
        corner.decay,
    )


def add_quadrants(plane: Plane, corner: Corner, i: int, j: int, outer_and_inner: Pair) -> Quadrants:
    """Add the masses between the limits and the integrals."""
    (outer, inner), gap, span = outer_and_inner, plane.gap[i][j], plane.h[i] + plane.k[j]
    return Quadrants(
        above_above=choose(span < 0, corner.across, 0.0) + inner,
        above_below=choose(gap > 0, corner.along, 0.0) + outer,
        below_above=choose(gap < 0, corner.along, 0.0) + outer,
        below_below=choose(span > 0, corner.across, 0.0) + inner,
    )


def find_quadrants(
    plane: Plane, corners: Corners
) -> tuple[tuple[Quadrants, Quadrants], tuple[Quadrants, Quadrants]]:
    """Find the quadrants of all corners, by h, then k."""
    lower, left = (
        complete_corner(plane, corners[0][0], 0, 0),
        complete_corner(plane, corners[0][1], 0, 1),
    )
    right, upper = (
        complete_corner(plane, corners[1][0], 1, 0),
        complete_corner(plane, corners[1][1], 1, 1),
    )
    low = integrate_sides(plane, lower, lower.total >= 0)
    high = integrate_sides(plane, upper, upper.total >= 0)
    terms = np.minimum(np.minimum(low[0], high[0]), np.maximum(low[1], high[1]))
    first = integrate_sides(plane, left, is_needed(left, plane.gap[0][1], terms))
    last = integrate_sides(plane, right, is_needed(right, -plane.gap[1][0], terms))
    return (
        (add_quadrants(plane, lower, 0, 0, low), add_quadrants(plane, left, 0, 1, first)),
        (add_quadrants(plane, right, 1, 0, last), add_quadrants(plane, upper, 1, 1, high)),
    )


def integrate_strip(start: Array, width: Array, argument: Array, slope: Array) -> Array:
    """Return the mass of start < z < start + width on one side of a line.

    It is the integral of phi(z) Phi(argument + slope (z - start)) over the strip.
    """
    step = width[:, None] * UNIT_NODES
    beyond, _ = find_tails(argument[:, None] + slope[:, None] * step)
    mass: Array = (normal_density(start[:, None] + step) * beyond) @ UNIT_WEIGHTS * width
    return mass


def find_accepted(plane: Plane, i: int, below: Pair, above: Pair, side: float) -> Any:
    """Return the mass of accepted parts above (side 1) or below (-1) tolerance limit `i`."""
    argument = plane.gap[i][0] / plane.sine - plane.k[0] * plane.tangent
    strip = plane.k[0], plane.acceptance, side * argument, side * plane.cotangent
    return complete(subtract_tails(below, above), integrate_strip, strip)


def find_conforming(plane: Plane, j: int, below: Pair, above: Pair, side: float) -> Any:
    """Return the mass of conforming parts above (side 1) or below (-1) acceptance limit `j`."""
    argument = -plane.gap[0][j] / plane.sine - plane.h[0] * plane.tangent
    strip = plane.h[0], plane.tolerance, side * argument, side * plane.cotangent
    return complete(subtract_tails(below, above), integrate_strip, strip)


def integrate_rectangle(
    start: Array, width: Array, low: Array, high: Array, slope: Array, span: Array
) -> Array:
    """Return the mass inside both windows where the tolerance is narrow."""
    step = width[:, None] * UNIT_NODES
    shift = slope[:, None] * step
    ends = low[:, None] - shift, high[:, None] - shift
    inner = normal_interval(*ends, np.broadcast_to(span[:, None], shift.shape))
    mass: Array = (normal_density(start[:, None] + step) * inner) @ UNIT_WEIGHTS * width
    return mass


def normal_masses(
    mu: Any, sigma: Any, bias: Any, s: Any, tolerance: Pair, acceptance: Pair
) -> tuple[Any, Any, Any, Any]:
    """Return rightly and wrongly accepted, rightly and wrongly rejected masses, flat arrays."""
    return add_masses(*place(mu, sigma, bias, s, tolerance, acceptance))


def add_masses(plane: Plane, corners: Corners) -> tuple[Any, Any, Any, Any]:
    """Add the masses of a plane and its corners."""
    (lower, left), (right, upper) = find_quadrants(plane, corners)
    below = (
        find_accepted(
            plane,
            0,
            (lower.below_below, left.below_below),
            (lower.below_above, left.below_above),
            -1.0,
        ),
        find_accepted(
            plane,
            1,
            (right.below_below, upper.below_below),
            (right.below_above, upper.below_above),
            -1.0,
        ),
    )
    above = (
        find_accepted(
            plane,
            0,
            (lower.above_below, left.above_below),
            (lower.above_above, left.above_above),
            1.0,
        ),
        find_accepted(
            plane,
            1,
            (right.above_below, upper.above_below),
            (right.above_above, upper.above_above),
            1.0,
        ),
    )
    start = plane.h[0] * plane.tangent
    window = (
        plane.h[0],
        plane.tolerance,
        plane.gap[0][0] / plane.sine + start,
        plane.gap[0][1] / plane.sine + start,
        plane.cotangent,
        plane.acceptance_in_s,
    )
    return (
        complete(subtract_tails(below, above), integrate_rectangle, window),
        below[0] + above[1],
        lower.below_below + upper.above_above + left.below_above + right.above_below,
        find_conforming(
            plane,
            0,
            (lower.below_below, right.below_below),
            (lower.above_below, right.above_below),
            -1.0,
        )
        + find_conforming(
            plane,
            1,
            (left.below_above, upper.below_above),
            (left.above_above, upper.above_above),
            1.0,
        ),
    )
