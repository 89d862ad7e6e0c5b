"""The normal law between limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array, check_order, check_scale
from mechproof.arguments.scalars import require
from mechproof.laws.normal import Normal
from mechproof.laws.parameters import BoundedLaw, Values, check_limits
from mechproof.laws.windows import Array, standardise

# Where the density changes by less than this part between the limits, the law is rectangular.
FLAT = 1e-9


@dataclass(frozen=True, eq=False)
class TruncatedNormal(BoundedLaw):
    """Normal law with parameters `mean` and `std` > 0, conditioned on lower < value < upper.

    `mean` and `std` are those of the law before truncation; a limit may be infinite. Raises
    ValueError for reversed limits, a `std` that is not positive, and limits so far out that the
    mass between them underflows.
    """

    mean: Values
    std: Values
    lower: Values
    upper: Values

    def __post_init__(self) -> None:
        low, high = check_order("(lower, upper)", self.lower, self.upper)
        fixed = np.any(check_scale("std", self.std) == 0)
        require(not fixed, "std", self.std, "must be positive")
        parent = Normal(self.mean, self.std)
        mass = parent.probability(low, high)
        require(not np.any(mass == 0), "(lower, upper)", (low, high), "no mass between them")
        self._keep(mean=parent.mean, std=parent.std, lower=low, upper=high)

    @property
    def _parent(self) -> Normal:
        return Normal.of_checked(mean=self.mean, std=self.std)

    @property
    def _mass(self) -> Array:
        mass: Array = self._parent.probability(self.lower, self.upper)
        return mass

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; at the limits that of the inside."""
        position = check_array("x", x)
        outside = (position < self.lower) | (position > self.upper)
        return np.where(outside, 0.0, self._parent.pdf(position) / self._mass)[()]

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        start, end = check_limits(lower, upper)
        ends = np.maximum(start, self.lower), np.minimum(end, self.upper)
        return self._parent.probability(*ends) / self._mass

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        self._check_draw(rng, size)
        mean, std, low, high = np.broadcast_arrays(self.mean, self.std, self.lower, self.upper)
        quantile = rng.random(low.shape if size is None else size)
        a, b = standardise(low - mean, std), standardise(high - mean, std)
        return np.clip(mean + std * _invert(quantile, a, b), low, high)

    def knots(self) -> Array:
        """Return steps of 18 nats of the untruncated law between the limits."""
        knots = self._parent.knots()
        ends = (np.asarray(e)[..., None] for e in (self.lower, self.upper))
        return np.clip(knots, *ends)


def _invert(quantile: Array, low: Array, high: Array) -> Array:
    """Return the standard normal value between the limits that a part `quantile` is below.

    Both halves of the law are inverted in their tails, where masses keep their digits.
    """
    from scipy.special import ndtr, ndtri

    left, right = ndtr(np.minimum([low, high], 0)), ndtr(-np.maximum([low, high], 0))
    below, above = left[1] - left[0], right[0] - right[1]
    mass = quantile * (below + above)
    lower_half = ndtri(np.minimum(left[0] + mass, 0.5))
    upper_half = -ndtri(np.minimum(right[1] + (below + above - mass), 0.5))
    with np.errstate(invalid="ignore", over="ignore"):
        flat = (high - low) * np.maximum(np.abs(low), np.abs(high)) < FLAT
        straight = low + quantile * (high - low)
    value: Array = np.where(flat, straight, np.where(mass < below, lower_half, upper_half))
    return value
