"""Masses of windows without cancellation, for the standard normal law and in general."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.laws.pointwise import choose, compute_where, exp, normal_tail

Array = NDArray[np.float64]

# A difference of tails that keeps less than this part of the smaller tail is integrated instead.
NARROW = 0.25
NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)
UNIT_NODES, UNIT_WEIGHTS = (1 + NODES) / 2, WEIGHTS / 2
# Where the density alone is integrated, it changes by less than a third: (1/12)**16/16! < eps.
FEW_NODES, FEW_WEIGHTS = np.polynomial.legendre.leggauss(8)


def subtract_tails(below: tuple[Any, Any], above: tuple[Any, Any]) -> Any:
    """Mass of a window from the masses below and above its two ends, negative where it cancels.

    `below` and `above` hold the masses under and over the (lower, upper) end. The smaller tail is
    differenced. Where the difference keeps less than `NARROW` of it, the mass must be integrated.
    For a log-concave density the window is then so narrow that the logarithm of the density
    changes by less than 1 across it, so that one Gauss panel is exact to rounding.
    """
    left = below[1] <= above[0]
    tail = choose(left, below[1], above[0])
    mass = tail - choose(left, below[0], above[1])
    return choose(mass < NARROW * tail, -1.0, mass)


def complete(mass: Any, integral: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    """Integrate where a difference of tails cancels.

    Infinite windows, not integrated here, cancel only among the smallest numbers.
    """
    found = compute_where(mass < 0, integral, arguments, mass)
    return choose((mass < 0) & np.isnan(found), 0.0, found)


def find_tails(z: Any) -> tuple[Any, Any]:
    """Masses of the standard normal law below and above, the larger as the complement."""
    smaller = normal_tail(z)
    return choose(z < 0, smaller, 1 - smaller), choose(z < 0, 1 - smaller, smaller)


def normal_interval(low: Any, high: Any, width: Any) -> Any:
    """Mass of the standard normal law between the limits, zero where they are reversed.

    `width` is high - low, which the caller may know more accurately.
    """
    high = np.maximum(low, high)
    (below_low, above_low), (below_high, above_high) = find_tails(low), find_tails(high)
    mass = subtract_tails((below_low, below_high), (above_low, above_high))
    return complete(mass, integrate_density, (low, np.maximum(width, 0.0)))


def integrate_density(start: Array, width: Array) -> Array:
    """Mass of the standard normal law on narrow windows, one Gauss panel each."""
    half = 0.5 * width
    z = (start + half)[:, None] + half[:, None] * FEW_NODES
    mass: Array = np.exp(-0.5 * z * z) @ FEW_WEIGHTS * (half / np.sqrt(2 * np.pi))
    return mass


def normal_density(z: Any) -> Any:
    """Density of the standard normal law."""
    return exp(-0.5 * z * z) / np.sqrt(2 * np.pi)


def scale_distance(distance: Any, scale: Any, at_zero: Any) -> Any:
    """Divide; at scale 0, return infinity with the sign of `distance`, or `at_zero` for 0/0."""
    return choose((distance == 0) & (scale == 0), at_zero, distance / scale)


def standardise(distance: ArrayLike, scale: ArrayLike, at_zero: ArrayLike = np.nan) -> Array:
    """Scale array-like distances."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        scaled: Array = scale_distance(
            np.asarray(distance, float), np.asarray(scale, float), at_zero
        )
    return scaled
