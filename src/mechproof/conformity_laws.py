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

from mechproof.conformity_windows import (
    Array,
    normal_density,
    normal_interval,
    standardise,
)

Values = float | Array

# Steps of at most 18 nats of exp(-z**2 / 2), out to where a double underflows.
_Z = 6.0 * np.sqrt(np.arange(40))
NORMAL_KNOTS: Array = np.concatenate([-_Z[:0:-1], _Z])


def require(condition: ArrayLike, name: str, value: object, allowed: str) -> None:
    """Raise a ValueError that names the parameter, its value and what is allowed."""
    if not np.all(condition):
        raise ValueError(f"{name} = {value!r}: {allowed}")


def require_finite(name: str, value: ArrayLike) -> Array:
    """`value` as float64; NaN passes, an infinity does not."""
    array = np.asarray(value, dtype=float)
    require(~np.isinf(array), name, value, "must be finite")
    return array


def require_scale(name: str, value: ArrayLike) -> Array:
    """`value` as float64 if it is finite and not negative (NaN passes)."""
    array = require_finite(name, value)
    require(~(array < 0), name, value, "must not be negative")
    return array


def require_order(what: str, lower: ArrayLike, upper: ArrayLike) -> tuple[Array, Array]:
    """Both limits as float64 if lower < upper everywhere (NaN passes)."""
    low, high = np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)
    require(~(low >= high), what, (lower, upper), "the lower limit must be below the upper limit")
    return low, high


@dataclass(frozen=True, eq=False)
class Normal:
    """Normal law; `std` 0 is a fixed value. Unit of `mean` and `std`: that of the quantity.

    Raises ValueError for a negative or infinite `std` and an infinite `mean`.
    """

    mean: Values
    std: Values

    def __post_init__(self) -> None:
        object.__setattr__(self, "mean", require_finite("mean", self.mean))
        object.__setattr__(self, "std", require_scale("std", self.std))

    @classmethod
    def from_width(cls, mean: ArrayLike, width: ArrayLike, multiple: ArrayLike) -> Self:
        """Law whose interval of full `width` is `multiple` standard deviations wide.

        A tolerance field T with K = T/sigma = 6 (paper on tooth thickness, step 1) is
        `from_width(mean, T, 6)`; an expanded uncertainty U = k u (GUM) is
        `from_width(bias, 2 * U, 2 * k)`.
        """
        ratio = require_finite("multiple", multiple)
        require(~(ratio <= 0), "multiple", multiple, "must be positive")
        return cls(require_finite("mean", mean), require_scale("width", width) / ratio)

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; infinite at the mean of a fixed value."""
        z = standardise(np.asarray(x, float) - self.mean, self.std, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            density = normal_density(z) / self.std
        return np.where((np.asarray(self.std) == 0) & np.isinf(z), 0.0, density)[()]

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        from scipy.special import ndtr

        return ndtr(standardise(np.asarray(x, float) - self.mean, self.std, -np.inf))

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        low, high = np.asarray(lower, float), np.asarray(upper, float)
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

        low = standardise(np.asarray(lower, float) - self.mean, self.std, np.inf)
        high = standardise(np.asarray(upper, float) - self.mean, self.std, -np.inf)
        return ndtr(low) + ndtr(-high)

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        return rng.normal(self.mean, self.std, size)

    def knots(self) -> Array:
        """Return steps of 18 nats on both sides of the mean."""
        mean, std = np.broadcast_arrays(self.mean, self.std)
        knots: Array = mean[..., None] + std[..., None] * NORMAL_KNOTS
        return knots


@dataclass(frozen=True, eq=False)
class Uniform:
    """Rectangular law between two finite limits, lower < upper (else ValueError)."""

    lower: Values
    upper: Values

    def __post_init__(self) -> None:
        low, high = require_order("(lower, upper)", self.lower, self.upper)
        object.__setattr__(self, "lower", require_finite("lower", low))
        object.__setattr__(self, "upper", require_finite("upper", high))

    @classmethod
    def from_width(cls, mean: ArrayLike, width: ArrayLike) -> Self:
        """Law of full `width` centred on `mean`."""
        centre, half = np.asarray(mean, float), require_scale("width", width) / 2
        return cls(centre - half, centre + half)

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; at the limits that of the inside."""
        low, high = np.asarray(self.lower), np.asarray(self.upper)
        position = np.asarray(x, float)
        inside = (position >= low) & (position <= high)
        density = np.where(inside, 1 / (high - low), 0.0)
        return np.where(np.isnan(position), np.nan, density)[()]

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        return self.probability(-np.inf, x)

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        low, high = np.asarray(self.lower), np.asarray(self.upper)
        overlap = np.minimum(upper, high) - np.maximum(lower, low)
        return (np.maximum(overlap, 0.0) / (high - low))[()]

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit, lower < upper."""
        return self.probability(-np.inf, lower) + self.probability(upper, np.inf)

    def sample(self, rng: np.random.Generator, size: int | tuple[int, ...] | None = None) -> Any:
        """Independent values of the given shape; `None`: one per parameter set."""
        low, high = np.broadcast_arrays(self.lower, self.upper)
        return low + (high - low) * rng.random(low.shape if size is None else size)

    def knots(self) -> Array:
        """Return the two limits."""
        return np.stack(np.broadcast_arrays(self.lower, self.upper), axis=-1)


@dataclass(frozen=True, eq=False)
class TruncatedNormal:
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
        low, high = require_order("(lower, upper)", self.lower, self.upper)
        require(~(require_scale("std", self.std) == 0), "std", self.std, "must be positive")
        parent = Normal(self.mean, self.std)
        mass = parent.probability(low, high)
        require(~(np.asarray(mass) == 0), "(lower, upper)", (low, high), "no mass between them")
        for name, value in (
            ("mean", parent.mean),
            ("std", parent.std),
            ("lower", low),
            ("upper", high),
        ):
            object.__setattr__(self, name, value)

    @property
    def _parent(self) -> Normal:
        return Normal(self.mean, self.std)

    @property
    def _mass(self) -> Array:
        mass: Array = self._parent.probability(self.lower, self.upper)
        return mass

    def pdf(self, x: ArrayLike) -> Any:
        """Probability density; at the limits that of the inside."""
        position = np.asarray(x, float)
        outside = (position < self.lower) | (position > self.upper)
        return np.where(outside, 0.0, self._parent.pdf(position) / self._mass)[()]

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        return self.probability(-np.inf, x)

    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""
        ends = np.maximum(lower, self.lower), np.minimum(upper, self.upper)
        return self._parent.probability(*ends) / self._mass

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit, lower < upper."""
        return self.probability(-np.inf, lower) + self.probability(upper, np.inf)

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


Law = Normal | Uniform | TruncatedNormal


def parameters(law: Law) -> list[Array]:
    """List the parameters of the law in the order of its constructor."""
    return [np.asarray(getattr(law, field.name), dtype=float) for field in fields(law)]


def select(law: Law, shape: tuple[int, ...], index: Any) -> Law:
    """Broadcast every parameter of the law to `shape`, flatten it and index it."""
    return type(law)(*(np.broadcast_to(p, shape).reshape(-1)[index] for p in parameters(law)))
