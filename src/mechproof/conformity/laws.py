"""Probability laws of a part's deviation and of a measurement error.

A law is chosen, never assumed: the papers print no law, only a ratio of a tolerance field or of
an interval of uncertainty to the standard deviation (`Normal.from_width`). Parameters are
array-likes that broadcast against each other and against the argument of every method.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.arrays import check_array, check_finite, check_order, check_scale
from mechproof.arguments.scalars import require
from mechproof.conformity.windows import (
    Array,
    normal_density,
    normal_interval,
    standardise,
)

Values = float | Array

# Steps of at most 18 nats of exp(-z**2 / 2), out to where a double underflows.
_Z = 6.0 * np.sqrt(np.arange(40))
NORMAL_KNOTS: Array = np.concatenate([-_Z[:0:-1], _Z])


class _ByValue:
    """Laws are equal if they are of one kind and their parameters are, in shape and value."""

    def _set(self, **parameters: ArrayLike) -> None:
        for name, value in parameters.items():
            own = np.array(value, np.float64)
            own.flags.writeable = False
            object.__setattr__(self, name, own)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        pairs = zip(vars(self).values(), vars(other).values(), strict=True)
        return all(np.array_equal(a, b, equal_nan=True) for a, b in pairs)

    def __hash__(self) -> int:
        # Zero has one sign then, and NaN one pattern.
        plain = [np.where(np.isnan(p), np.nan, p + 0.0) for p in vars(self).values()]
        return hash((type(self), *((p.shape, p.tobytes()) for p in plain)))


@dataclass(frozen=True, eq=False)
class Normal(_ByValue):
    """Normal law; `std` 0 is a fixed value. Unit of `mean` and `std`: that of the quantity.

    Raises ValueError for a negative or infinite `std`, an infinite `mean` and numbers beyond 1e150,
    TypeError for what is no real number.
    """

    mean: Values
    std: Values

    def __post_init__(self) -> None:
        self._set(mean=check_finite("mean", self.mean), std=check_scale("std", self.std))

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
        with np.errstate(divide="ignore", invalid="ignore"):
            density = normal_density(z) / self.std
        return np.where((np.asarray(self.std) == 0) & np.isinf(z), 0.0, density)[()]

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        from scipy.special import ndtr

        return ndtr(standardise(check_array("x", x) - self.mean, self.std, -np.inf))

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        low, high = _limits(lower, upper)
        ends = (
            standardise(low - self.mean, self.std, np.inf),
            standardise(high - self.mean, self.std, -np.inf),
        )
        with np.errstate(invalid="ignore"):
            width = standardise(high - low, self.std)
        return normal_interval(*ends, width)[()]

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit, lower < upper."""
        from scipy.special import ndtr

        low, high = _limits(lower, upper)
        below = standardise(low - self.mean, self.std, np.inf)
        above = standardise(high - self.mean, self.std, -np.inf)
        return ndtr(below) + ndtr(-above)

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        return rng.normal(self.mean, self.std, size)

    def knots(self) -> Array:
        """Return steps of 18 nats on both sides of the mean."""
        mean, std = np.broadcast_arrays(self.mean, self.std)
        knots: Array = mean[..., None] + std[..., None] * NORMAL_KNOTS
        return knots


@dataclass(frozen=True, eq=False)
class Uniform(_ByValue):
    """Rectangular law between two finite limits, lower < upper (else ValueError)."""

    lower: Values
    upper: Values

    def __post_init__(self) -> None:
        low, high = check_order("(lower, upper)", self.lower, self.upper)
        self._set(lower=check_finite("lower", low), upper=check_finite("upper", high))

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

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        return self.probability(-np.inf, x)

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        low, high = np.asarray(self.lower), np.asarray(self.upper)
        start, end = _limits(lower, upper)
        overlap = np.minimum(end, high) - np.maximum(start, low)
        return (np.maximum(overlap, 0.0) / (high - low))[()]

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit, lower < upper."""
        low, high = _limits(lower, upper)
        return self.probability(-np.inf, low) + self.probability(high, np.inf)

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        low, high = np.broadcast_arrays(self.lower, self.upper)
        return low + (high - low) * rng.random(low.shape if size is None else size)

    def knots(self) -> Array:
        """Return the two limits."""
        return np.stack(np.broadcast_arrays(self.lower, self.upper), axis=-1)


@dataclass(frozen=True, eq=False)
class TruncatedNormal(_ByValue):
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
        self._set(mean=parent.mean, std=parent.std, lower=low, upper=high)

    @property
    def _parent(self) -> Normal:
        return Normal(self.mean, self.std)

    @property
    def _mass(self) -> Array:
        mass: Array = self._parent.probability(self.lower, self.upper)
        return mass

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; at the limits that of the inside."""
        position = check_array("x", x)
        outside = (position < self.lower) | (position > self.upper)
        return np.where(outside, 0.0, self._parent.pdf(position) / self._mass)[()]

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        return self.probability(-np.inf, x)

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        start, end = _limits(lower, upper)
        ends = np.maximum(start, self.lower), np.minimum(end, self.upper)
        return self._parent.probability(*ends) / self._mass

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit, lower < upper."""
        low, high = _limits(lower, upper)
        return self.probability(-np.inf, low) + self.probability(high, np.inf)

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        from scipy.stats import truncnorm

        shape = np.broadcast_shapes(
            *(np.shape(p) for p in (self.mean, self.std, self.lower, self.upper))
        )
        ends = ((np.asarray(e) - self.mean) / self.std for e in (self.lower, self.upper))
        quantile = rng.random(shape if size is None else size)
        return self.mean + self.std * truncnorm.ppf(quantile, *ends)

    def knots(self) -> Array:
        """Return steps of 18 nats of the untruncated law between the limits."""
        knots = self._parent.knots()
        ends = (np.asarray(e)[..., None] for e in (self.lower, self.upper))
        return np.clip(knots, *ends)


def _limits(lower: ArrayLike, upper: ArrayLike) -> tuple[Array, Array]:
    return check_array("lower", lower), check_array("upper", upper)


Law = Normal | Uniform | TruncatedNormal
LAWS = (Normal, Uniform, TruncatedNormal)


def check_law(name: str, law: Any, *kinds: type) -> None:
    """Raise a TypeError unless the law is of one of the kinds, any if none is given."""
    allowed = " or ".join(kind.__name__ for kind in kinds or LAWS)
    require(isinstance(law, kinds or LAWS), name, law, f"must be a law, {allowed}", TypeError)


def parameters(law: Law) -> list[Array]:
    """List the parameters of the law in the order of its constructor."""
    return [np.asarray(getattr(law, field.name), dtype=float) for field in fields(law)]


def select(law: Law, shape: tuple[int, ...], index: Any) -> Law:
    """Broadcast every parameter of the law to `shape`, flatten it and index it."""
    return type(law)(*(np.broadcast_to(p, shape).reshape(-1)[index] for p in parameters(law)))
