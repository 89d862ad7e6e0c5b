"""The plane of two correlated normal variables: its standardised limits, and where they cross.

Y ~ Normal(mu, sigma) is the true deviation, M = Y + E the measured one. Standardised, they are a
bivariate normal pair with correlation cos(beta), sin(beta) = s / rho, rho = hypot(sigma, s). The
tolerance limits h and the acceptance limits k cut the plane into nine regions and cross in four
corners (h, k).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from mechproof.laws.pointwise import choose, exp, hypot
from mechproof.laws.windows import find_tails, scale_distance, subtract_tails

Pair = tuple[Any, Any]  # of the lower and the upper limit


class Plane(NamedTuple):
    """Standardised limits."""

    h: Pair
    k: Pair
    gap: tuple[Pair, Pair]  # k - h without cancellation, by h, then k
    tangent: Any  # tan(beta / 2)
    sine: Any  # of beta
    cosine: Any
    cotangent: Any  # 0 for beta = 0, where the slope it multiplies is never needed
    tolerance: Any  # width in sigma
    acceptance: Any  # width in rho
    acceptance_in_s: Any


class Corner(NamedTuple):
    """The components of the quadrants of a corner (h, k), and its arc at x = beta.

    `near` belongs to h - k, `far` to h + k: the terms of the exponent at u = 1 of the arc that
    are multiplied by u**-2 and u**2, or the other way round.
    """

    total: Any  # I(0, pi)
    along: Any  # the mass between h and k, negative where it must be integrated
    across: Any  # the mass between h and -k, likewise
    near: Any
    far: Any
    exponent: Any
    decay: Any  # exp(-exponent)


Corners = tuple[tuple[Corner, Corner], tuple[Corner, Corner]]  # by h, then k


def subtract_twice(a: Any, b: Any, c: Any) -> Any:
    """Subtract b and c from a; the rounding error of a - b is carried along (TwoSum)."""
    high = a - b
    back = high - a
    low = (a - (high - back)) - (b + back)
    return choose(np.isfinite(high), (high - c) + low, high - c)


def find_gap(h: Any, k: Any, offset: Any, versine: Any) -> Any:
    """Return k - h; `offset` is the distance of the limits in rho."""
    apart = choose(h == k, 0.0, k - h)
    return choose(np.isfinite(h) & np.isfinite(k), offset - h * versine, apart)


def place_plane(mu: Any, sigma: Any, bias: Any, s: Any, tolerance: Pair, acceptance: Pair) -> Plane:
    """Standardise the limits. A fixed value on a limit is outside it."""
    rho = hypot(sigma, s)
    tangent = choose(rho == 0, 0.0, s / (rho + sigma))
    square = tangent * tangent
    sine, cosine = 2 * tangent / (1 + square), (1 - tangent) * (1 + tangent) / (1 + square)
    low, high = tolerance
    least, most = acceptance
    h = scale_distance(low - mu, sigma, np.inf), scale_distance(high - mu, sigma, -np.inf)
    k = (
        scale_distance(subtract_twice(least, mu, bias), rho, np.inf),
        scale_distance(subtract_twice(most, mu, bias), rho, -np.inf),
    )
    versine = 2 * square / (1 + square)
    gap = (
        (
            find_gap(h[0], k[0], subtract_twice(least, low, bias) / rho, versine),
            find_gap(h[0], k[1], subtract_twice(most, low, bias) / rho, versine),
        ),
        (
            find_gap(h[1], k[0], subtract_twice(least, high, bias) / rho, versine),
            find_gap(h[1], k[1], subtract_twice(most, high, bias) / rho, versine),
        ),
    )
    cotangent = choose(tangent == 0, 0.0, cosine / sine)
    widths = (high - low) / sigma, (most - least) / rho, (most - least) / s
    return Plane(h, k, gap, tangent, sine, cosine, cotangent, *widths)


def place_corner(plane: Plane, i: int, j: int, h_tails: Pair, k_tails: Pair) -> Corner:
    """Find the components of the quadrants at limit i of Y and limit j of M."""
    (below_h, above_h), (below_k, above_k) = h_tails, k_tails
    near, far = (plane.gap[i][j] / plane.tangent) ** 2 / 8, (plane.h[i] + plane.k[j]) ** 2 / 8
    square = plane.tangent * plane.tangent
    exponent = (near + far) * (1 + square)
    return Corner(
        total=np.minimum(np.minimum(below_h, above_h), np.minimum(below_k, above_k)),
        along=subtract_ordered((below_h, below_k), (above_h, above_k)),
        across=subtract_ordered((below_h, above_k), (above_h, below_k)),
        near=near,
        far=far * square,
        exponent=exponent,
        decay=exp(-exponent),
    )


def subtract_ordered(below: Pair, above: Pair) -> Any:
    """Return the mass between two points in either order, from their tails."""
    return subtract_tails(
        (np.minimum(below[0], below[1]), np.maximum(below[0], below[1])),
        (np.maximum(above[0], above[1]), np.minimum(above[0], above[1])),
    )


def place(
    mu: Any, sigma: Any, bias: Any, s: Any, tolerance: Pair, acceptance: Pair
) -> tuple[Plane, Corners]:
    """Standardise the limits and find the components that need no integral."""
    plane = place_plane(mu, sigma, bias, s, tolerance, acceptance)
    low, high = find_tails(plane.h[0]), find_tails(plane.h[1])
    least, most = find_tails(plane.k[0]), find_tails(plane.k[1])
    return plane, (
        (place_corner(plane, 0, 0, low, least), place_corner(plane, 0, 1, low, most)),
        (place_corner(plane, 1, 0, high, least), place_corner(plane, 1, 1, high, most)),
    )
