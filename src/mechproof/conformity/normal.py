"""The four masses of a rectangle in the plane of two correlated normal variables.

Y ~ Normal(mu, sigma) is the true deviation, M = Y + E the measured one. Standardised, they are a
bivariate normal pair with correlation cos(beta), sin(beta) = s / rho, rho = hypot(sigma, s). The
tolerance limits h and the acceptance limits k cut the plane into nine regions.

Each corner (h, k) has four quadrants. With I(a, b) = 1/(2 pi) times the integral from a to b of
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
(`conformity.arc`).
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from mechproof.conformity.arc import integrate_arc
from mechproof.laws import Normal
from mechproof.laws.kinds import list_parameters
from mechproof.laws.windows import (
    UNIT_NODES,
    UNIT_WEIGHTS,
    Array,
    Mask,
    integrate_density,
    normal_density,
    normal_interval,
    standardise,
    subtract_tails,
)

UNDERFLOW = 745.0  # exp(-745) is the smallest double
LOST = 2.0**-60  # what is this small beside another term does not change their sum
# Corners (lower, lower) and (upper, upper); (lower, upper) and (upper, lower): of h, then of k.
ALIKE, CROSSED = ([0, 1], [0, 1]), ([0, 1], [1, 0])
# The sign of k - h at the crossed corners of windows that overlap.
OUTWARD = np.array([[1], [-1]])


@dataclass(frozen=True)
class Plane:
    """Standardised limits; axis 0 of `h` and `k` is (lower, upper), of `gap` that of h, then k."""

    h: Array
    k: Array
    gap: Array  # k - h without cancellation
    tangent: Array  # tan(beta / 2)
    widths: tuple[Array, Array]  # of the tolerance in sigma, of the acceptance in rho
    acceptance_in_s: Array

    @property
    def sine(self) -> Array:
        """Sine of beta."""
        sine: Array = 2 * self.tangent / (1 + self.tangent**2)
        return sine

    @property
    def cosine(self) -> Array:
        """Cosine of beta."""
        cosine: Array = (1 - self.tangent) * (1 + self.tangent) / (1 + self.tangent**2)
        return cosine

    @property
    def cotangent(self) -> Array:
        """Cotangent of beta; 0 for beta = 0, where the slope it multiplies is never needed."""
        return np.where(self.tangent == 0, 0.0, _divide(self.cosine, self.sine))


def _divide(a: Array, b: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        quotient: Array = a / b
    return quotient


def _subtract_twice(a: Array, b: Array, c: Array) -> Array:
    """Subtract b and c from a; the rounding error of a - b is carried along (TwoSum)."""
    with np.errstate(invalid="ignore"):
        high = a - b
        back = high - a
        low = (a - (high - back)) - (b + back)
        return np.where(np.isfinite(high), (high - c) + low, high - c)


def _standard_plane(true: Normal, error: Normal, tolerance: Array, acceptance: Array) -> Plane:
    (mu, sigma), (bias, s) = list_parameters(true), list_parameters(error)
    rho = np.hypot(sigma, s)
    tangent = np.where(rho == 0, 0.0, _divide(s, rho + sigma))
    edge = np.array([np.inf, -np.inf])[:, None]  # a fixed value on a limit is outside it
    h = standardise(tolerance - mu, sigma, edge)
    k = standardise(_subtract_twice(acceptance, mu, bias), rho, edge)
    offset = _subtract_twice(acceptance[None], tolerance[:, None], bias)
    versine = 2 * tangent**2 / (1 + tangent**2)
    with np.errstate(invalid="ignore"):
        gap = _divide(offset, rho) - h[:, None] * versine
        finite = np.isfinite(h[:, None]) & np.isfinite(k[None])
        both = h[:, None] == k[None]
        gap = np.where(finite, gap, np.where(both, 0.0, k[None] - h[:, None]))
    return Plane(
        h,
        k,
        gap,
        tangent,
        (
            _divide(np.diff(tolerance, axis=0)[0], sigma),
            _divide(np.diff(acceptance, axis=0)[0], rho),
        ),
        _divide(np.diff(acceptance, axis=0)[0], s),
    )


@dataclass(frozen=True)
class Arcs:
    """The integrands of some corners at x = beta: the terms of the exponent, and which end decays.

    `near` belongs to h - k, `far` to h + k, each as what multiplies u**-2 and u**2 of the arc.
    """

    near: Array
    far: Array
    exponent: Array
    falling: Mask  # from beta towards 0: I(0, beta) is the smaller integral
    square: Array  # tan(beta/2)**2
    sine: Array

    def take(self, chosen: Any) -> Arcs:
        """Return some of the corners."""
        return Arcs(*(getattr(self, field.name)[chosen] for field in fields(self)))


def _place_arcs(plane: Plane) -> Arcs:
    square = plane.tangent**2
    with np.errstate(invalid="ignore", over="ignore"):
        near = _divide(plane.gap, plane.tangent) ** 2 / 8
        far = (plane.h[:, None] + plane.k) ** 2 / 8
        exponent = (near + far) * (1 + square)
        far *= square
        # NaN: s = 0, I(0, beta) is 0.
        falling = ~(2 * (near - far) + plane.cosine <= 0)
    alike = (np.broadcast_to(v, near.shape) for v in (square, plane.sine))
    return Arcs(near, far, exponent, falling, *alike)


def _integrate_smaller(arcs: Arcs) -> Array:
    """Return the smaller of I(0, beta) and I(beta, pi) of every corner."""
    # An infinite limit and s = 0 have an infinite exponent, or NaN.
    present = arcs.exponent < UNDERFLOW
    if not present.all():
        smaller = np.zeros_like(arcs.near)
        smaller[present] = _integrate_smaller(arcs.take(present)) if present.any() else 0.0
        return smaller
    first = np.where(arcs.falling, arcs.near, arcs.far)
    second = np.where(arcs.falling, arcs.far, arcs.near)
    one, square = np.where(arcs.falling, 1.0, arcs.square), np.where(arcs.falling, arcs.square, 1.0)
    parts = (part.ravel() for part in (first, second, one, square))
    arc = integrate_arc(*parts).reshape(first.shape)
    return arcs.sine * np.exp(-arcs.exponent) * arc


@dataclass(frozen=True)
class Quadrants:
    """Masses at every corner (h, k); the first word is Y's side of h, the second M's side of k."""

    above_above: Array
    above_below: Array
    below_above: Array
    below_below: Array


def _quadrants(plane: Plane) -> Quadrants:
    h, k = plane.h[:, None], plane.k[None]
    (below_h, above_h), (below_k, above_k) = _find_tails(h), _find_tails(k)
    total = np.minimum(np.minimum(below_h, above_h), np.minimum(below_k, above_k))
    along = _normal_between(h, k, plane.gap, (below_h, below_k), (above_h, above_k))
    outer, inner = _outer_and_inner(plane, total, along)
    with np.errstate(invalid="ignore"):
        span = np.where(h == -k, 0.0, h + k)
    across = _normal_between(h, -k, span, (below_h, above_k), (above_h, below_k))
    return Quadrants(
        above_above=np.where(span < 0, across, 0.0) + inner,
        above_below=np.where(plane.gap > 0, along, 0.0) + outer,
        below_above=np.where(plane.gap < 0, along, 0.0) + outer,
        below_below=np.where(span > 0, across, 0.0) + inner,
    )


def _outer_and_inner(plane: Plane, total: Array, along: Array) -> tuple[Array, Array]:
    """I(0, beta) and I(beta, pi) of every corner, the smaller integrated, the other by `total`."""
    arcs = _place_arcs(plane)
    smaller = np.zeros_like(total)
    smaller[ALIKE] = _integrate_smaller(arcs.take(ALIKE))
    crossed = arcs.take(CROSSED)
    beside = np.min(np.where(arcs.falling, smaller, total - smaller)[ALIKE], axis=0)
    opposite = np.max(np.where(arcs.falling, total - smaller, smaller)[ALIKE], axis=0)
    terms = np.minimum(total, along)[CROSSED]
    needed = ~_is_lost(crossed, plane.gap[CROSSED], np.minimum(terms, np.minimum(beside, opposite)))
    if needed.any():
        part = np.zeros_like(terms)
        part[needed] = _integrate_smaller(crossed.take(needed))
        smaller[CROSSED] = part
    larger = total - smaller
    return np.where(arcs.falling, smaller, larger), np.where(arcs.falling, larger, smaller)


def _is_lost(crossed: Arcs, gap: Array, terms: Array) -> Mask:
    """Mark the corners (lower, upper) and (upper, lower) whose I(0, beta) is lost in sums.

    Where the integrand falls, I(0, beta) <= exp(-exponent)/2. `terms` is the smallest of what it
    is added to: the mass between h and k, I(0, pi), and quadrants that hold I(0, beta) of both, or
    I(beta, pi) of one, of the corners (lower, lower) and (upper, upper).
    """
    with np.errstate(invalid="ignore"):
        lost: Mask = np.exp(-crossed.exponent) / 2 <= LOST * terms
        lost &= (crossed.near >= crossed.far) & (gap * OUTWARD > 0)
    return lost


def _find_tails(z: Array) -> tuple[Array, Array]:
    """Masses of the standard normal law below and above, the larger by what the smaller leaves."""
    from scipy.special import ndtr

    smaller = ndtr(-np.abs(z))
    return np.where(z < 0, smaller, 1 - smaller), np.where(z < 0, 1 - smaller, smaller)


def _normal_between(
    a: Array, b: Array, distance: Array, below: tuple[Array, Array], above: tuple[Array, Array]
) -> Array:
    """Mass of the standard normal law between `a` and `b`, in either order, from their tails."""
    start = np.minimum(a, b)
    return subtract_tails(
        (np.minimum(*below), np.maximum(*below)),
        (np.maximum(*above), np.minimum(*above)),
        lambda mask: integrate_density(start[mask], np.abs(distance[mask])),
    )


def _integrate_strip(start: Array, width: Array, argument: Array, slope: Array, side: int) -> Array:
    """Mass of start < z < start + width on one side of a line: phi(z) Phi(argument + slope z)."""
    from scipy.special import ndtr

    step = width[:, None] * UNIT_NODES
    beyond = ndtr(side * (argument[:, None] + slope[:, None] * step))
    mass: Array = (normal_density(start[:, None] + step) * beyond) @ UNIT_WEIGHTS * width
    return mass


def _accepted(plane: Plane, corner: Quadrants, i: int, above: bool) -> Array:
    """Mass inside the acceptance window, above or below tolerance limit `i`."""
    below_k, above_k = (
        (corner.above_below[i], corner.above_above[i])
        if above
        else (corner.below_below[i], corner.below_above[i])
    )
    strip = plane.k[0], plane.widths[1], plane.gap[i, 0]
    return _strip_mass(plane, below_k, above_k, strip, above)


def _conforming(plane: Plane, corner: Quadrants, j: int, above: bool) -> Array:
    """Mass inside the tolerance, above or below acceptance limit `j`."""
    below_h, above_h = (
        (corner.below_above[:, j], corner.above_above[:, j])
        if above
        else (corner.below_below[:, j], corner.above_below[:, j])
    )
    strip = plane.h[0], plane.widths[0], -plane.gap[0, j]
    return _strip_mass(plane, below_h, above_h, strip, above)


def _strip_mass(
    plane: Plane, below: Array, above: Array, strip: tuple[Array, Array, Array], beyond: bool
) -> Array:
    """Mass of a strip (start, width, start - line) on one side of the line that crosses it."""

    def integrate(mask: Mask) -> Array:
        start, width, distance = strip
        argument = _divide(distance, plane.sine) - start * plane.tangent
        window = start[mask], width[mask]
        line = argument[mask], plane.cotangent[mask]
        return _integrate_strip(*window, *line, 1 if beyond else -1)

    return subtract_tails((below[0], below[1]), (above[0], above[1]), integrate)


def _integrate_rectangle(plane: Plane, mask: Mask) -> Array:
    """Mass inside both windows where the tolerance is narrow."""
    width = plane.widths[0][mask]
    step = width[:, None] * UNIT_NODES
    shift = (plane.h[0] * plane.tangent)[mask][:, None] - plane.cotangent[mask][:, None] * step
    low, high = (_divide(plane.gap[0, j], plane.sine)[mask][:, None] + shift for j in (0, 1))
    inner = normal_interval(low, high, plane.acceptance_in_s[mask][:, None])
    density = normal_density(plane.h[0][mask][:, None] + step)
    return (density * inner) @ UNIT_WEIGHTS * width


def normal_masses(
    true: Normal, error: Normal, tolerance: Array, acceptance: Array
) -> tuple[Array, Array, Array, Array]:
    """Rightly and wrongly accepted, rightly and wrongly rejected masses.

    The parameters of the laws have shape (n,), the limits shape (2, n); the results (n,).
    """
    plane = _standard_plane(true, error, tolerance, acceptance)
    corner = _quadrants(plane)
    below = tuple(_accepted(plane, corner, i, above=False) for i in (0, 1))
    above = tuple(_accepted(plane, corner, i, above=True) for i in (0, 1))
    right = subtract_tails(
        (below[0], below[1]), (above[0], above[1]), lambda mask: _integrate_rectangle(plane, mask)
    )
    return (
        right,
        below[0] + above[1],
        corner.below_below[0, 0]
        + corner.above_above[1, 1]
        + corner.below_above[0, 1]
        + corner.above_below[1, 0],
        _conforming(plane, corner, 0, above=False) + _conforming(plane, corner, 1, above=True),
    )
