"""The rectangular law."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array, check_finite, check_order, check_scale
from mechproof.laws.parameters import BoundedLaw, Values, check_limits
from mechproof.laws.windows import Array


@dataclass(frozen=True, eq=False)
class Uniform(BoundedLaw):
    """Rectangular law between two finite limits, lower < upper (else ValueError)."""

    lower: Values
    upper: Values

    def __post_init__(self) -> None:
        low, high = check_order("(lower, upper)", self.lower, self.upper)
        self._keep(lower=check_finite("lower", low), upper=check_finite("upper", high))

    @classmethod
    def from_width(cls, mean: ArrayLike, width: ArrayLike) -> Self:
        """Law of full `width` centred on `mean`."""
        centre, half = check_finite("mean", mean), check_scale("width", width) / 2
        return cls(centre - half, centre + half)

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; at the limits that of the inside."""
        low, high = np.asarray(self.lower), np.asarray(self.upper)
        position = check_array("x", x)
        inside = (position >= low) & (position <= high)
        density = np.where(inside, 1 / (high - low), 0.0)
        return np.where(np.isnan(position), np.nan, density)[()]

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        low, high = np.asarray(self.lower), np.asarray(self.upper)
        start, end = check_limits(lower, upper)
        overlap = np.minimum(end, high) - np.maximum(start, low)
        return (np.maximum(overlap, 0.0) / (high - low))[()]

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        self._check_draw(rng, size)
        low, high = np.broadcast_arrays(self.lower, self.upper)
        return low + (high - low) * rng.random(low.shape if size is None else size)

    def knots(self) -> Array:
        """Return the two limits."""
        return np.stack(np.broadcast_arrays(self.lower, self.upper), axis=-1)
