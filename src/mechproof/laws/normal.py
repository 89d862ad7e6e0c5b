"""The normal law."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array, check_finite, check_scale
from mechproof.arguments.scalars import require
from mechproof.laws.parameters import ByValue, Values, check_limits
from mechproof.laws.windows import Array, normal_density, normal_interval, standardise

# Steps of at most 18 nats of exp(-z**2 / 2), out to where a double underflows.
_Z = 6.0 * np.sqrt(np.arange(40))
NORMAL_KNOTS: Array = np.concatenate([-_Z[:0:-1], _Z])


@dataclass(frozen=True, eq=False)
class Normal(ByValue):
    """Normal law; `std` 0 is a fixed value. Unit of `mean` and `std`: that of the quantity.

    Raises ValueError for a negative or infinite `std`, an infinite `mean` and numbers beyond 1e150,
    TypeError for what is no real number.
    """

    mean: Values
    std: Values

    def __post_init__(self) -> None:
        self._keep(mean=check_finite("mean", self.mean), std=check_scale("std", self.std))

    @classmethod
    def from_width(cls, mean: ArrayLike, width: ArrayLike, multiple: ArrayLike) -> Self:
        """Law whose interval of full `width` is `multiple` standard deviations wide.

        A tolerance field T with K = T/sigma = 6 (paper on tooth thickness, step 1) is
        `from_width(mean, T, 6)`; an expanded uncertainty U = k u (GUM) is
        `from_width(bias, 2 * U, 2 * k)`.
        """
        ratio = check_finite("multiple", multiple)
        require(not np.any(ratio <= 0), "multiple", multiple, "must be positive")
        return cls(check_finite("mean", mean), check_scale("width", width) / ratio)

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; infinite at the mean of a fixed value."""
        z = standardise(check_array("x", x) - self.mean, self.std, 0.0)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            density = normal_density(z) / self.std
        return np.where((np.asarray(self.std) == 0) & np.isinf(z), 0.0, density)[()]

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        from scipy.special import ndtr

        return ndtr(standardise(check_array("x", x) - self.mean, self.std, -np.inf))

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        low, high = check_limits(lower, upper)
        ends = (
            standardise(low - self.mean, self.std, np.inf),
            standardise(high - self.mean, self.std, -np.inf),
        )
        with np.errstate(invalid="ignore", over="ignore"):
            width = standardise(high - low, self.std)
            return normal_interval(*np.broadcast_arrays(*ends, width))[()]

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit; 1 where they are reversed."""
        from scipy.special import ndtr

        low, high = check_limits(lower, upper)
        below = standardise(low - self.mean, self.std, np.inf)
        above = standardise(high - self.mean, self.std, -np.inf)
        # Of reversed limits, every value is beyond one or both.
        return np.minimum(ndtr(below) + ndtr(-above), 1.0)

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        self._check_draw(rng, size)
        return rng.normal(self.mean, self.std, size)

    def knots(self) -> Array:
        """Return steps of 18 nats on both sides of the mean."""
        mean, std = np.broadcast_arrays(self.mean, self.std)
        knots: Array = mean[..., None] + std[..., None] * NORMAL_KNOTS
        return knots
