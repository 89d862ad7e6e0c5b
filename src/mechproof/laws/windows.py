"""Masses of windows without cancellation, of the standard normal law and in general."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# A difference of tails that keeps less than this part of the smaller tail is integrated instead.
NARROW = 0.25
NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)
UNIT_NODES, UNIT_WEIGHTS = (1 + NODES) / 2, WEIGHTS / 2
# Where the density alone is integrated, it changes by less than a third: (1/12)**16/16! < eps.
FEW_NODES, FEW_WEIGHTS = np.polynomial.legendre.leggauss(8)


def subtract_tails(
    below: tuple[Array, Array], above: tuple[Array, Array], integral: Callable[[Mask], Array]
) -> Array:
    """Mass of a window from the masses below and above its two ends, without cancellation.

    `below` and `above` hold the masses under and over the (lower, upper) end. The smaller tail is
    differenced. Where the difference keeps less than `NARROW` of it, `integral(mask)` supplies
    the masses. For a log-concave density the window is then so narrow that the logarithm of the
    density changes by less than 1 across it, so that one Gauss panel is exact to rounding.
    """
    left = below[1] <= above[0]
    tail = np.where(left, below[1], above[0])
    mass = np.asarray(tail - np.where(left, below[0], above[1]))
    narrow = mass < NARROW * tail
    if narrow.any():
        mass[narrow] = integral(narrow)
    return mass


def normal_interval(lower: ArrayLike, upper: ArrayLike, width: ArrayLike) -> Array:
    """Mass of the standard normal law between the limits, zero where they are reversed.

    `width` is upper - lower, given by the caller because it may know it better.
    """
    from scipy.special import ndtr

    low, high, span = np.broadcast_arrays(*(np.asarray(v, float) for v in (lower, upper, width)))
    high = np.where(high < low, low, high)

    tails: tuple[Array, ...] = tuple(ndtr(z) for z in (low, high, -low, -high))
    return subtract_tails(
        (tails[0], tails[1]),
        (tails[2], tails[3]),
        lambda mask: integrate_density(low[mask], np.maximum(span[mask], 0)),
    )


def integrate_density(start: Array, width: Array) -> Array:
    """Mass of the standard normal law on narrow windows, one Gauss panel each."""
    half = 0.5 * width
    z = (start + half)[:, None] + half[:, None] * FEW_NODES
    mass: Array = np.exp(-0.5 * z * z) @ FEW_WEIGHTS * (half / np.sqrt(2 * np.pi))
    return mass


def normal_density(z: Array) -> Array:
    """Density of the standard normal law."""
    with np.errstate(over="ignore"):
        density: Array = np.exp(-0.5 * z * z) / np.sqrt(2 * np.pi)
    return density


def standardise(distance: ArrayLike, scale: ArrayLike, at_zero: ArrayLike = np.nan) -> Array:
    """Divide; for scale 0 the infinity of the sign of `distance`, `at_zero` for 0/0."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ratio = np.asarray(distance, float) / np.asarray(scale, float)
    both_zero = (np.asarray(distance) == 0) & (np.asarray(scale) == 0)
    return np.where(both_zero, at_zero, ratio)
