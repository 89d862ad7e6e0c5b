"""Kinds of laws (normal, truncated normal, rectangular) and operations on any of them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, fields
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import (
    check_array,
    check_finite,
    check_generator,
    check_order,
    check_scale,
    check_shape,
)
from mechproof.arguments.scalars import require
from mechproof.laws.windows import Array, normal_density, normal_interval, standardise

Values = float | Array


class ByValue:
    """Laws are equal if they are of the same kind, with parameters of equal shape and value."""

    def _keep(self, **parameters: ArrayLike) -> None:
        for name, value in parameters.items():
            own = np.array(value, np.float64)
            own.flags.writeable = False
            object.__setattr__(self, name, own)

    @classmethod
    def of_checked(cls, **parameters: ArrayLike) -> Self:
        """Return a law of checked parameters; derived values may lie beyond the limits."""
        law = object.__new__(cls)
        law._keep(**parameters)
        return law

    def _check_draw(self, rng: Any, size: Any) -> None:
        """Raise an error unless `rng` is a generator and no value would recur in `size`."""
        check_generator("rng", rng)
        if size is not None:
            shape = check_shape("size", size)
            own = np.broadcast_shapes(*(p.shape for p in vars(self).values()))
            fits = len(own) <= len(shape) and all(
                n in (1, length) for n, length in zip(own[::-1], shape[::-1], strict=False)
            )
            require(fits, "size", size, f"must end with the shape of the parameters, {own}")

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        pairs = zip(vars(self).values(), vars(other).values(), strict=True)
        return all(np.array_equal(a, b, equal_nan=True) for a, b in pairs)

    def __hash__(self) -> int:
        # Give zero one sign and NaN one bit pattern.
        plain = [np.where(np.isnan(p), np.nan, p + 0.0) for p in vars(self).values()]
        return hash((type(self), *((p.shape, p.tobytes()) for p in plain)))


class BoundedLaw(ByValue, ABC):
    """A law between limits, fully described by the mass of any window."""

    @abstractmethod
    def probability(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value strictly between the limits; 0 where they are reversed."""

    def cdf(self, x: ArrayLike) -> Any:
        """Probability of a value below `x`."""
        return self.probability(-np.inf, check_array("x", x))

    def outside(self, lower: ArrayLike, upper: ArrayLike) -> Any:
        """Probability of a value at or beyond either limit; 1 where they are reversed."""
        low, high = check_limits(lower, upper)
        beyond = self.probability(-np.inf, low) + self.probability(high, np.inf)
        # Every value lies beyond one or both of reversed limits.
        return np.minimum(beyond, 1.0)


def check_limits(lower: ArrayLike, upper: ArrayLike) -> tuple[Array, Array]:
    """Both limits as float64, in any order."""
    return check_array("lower", lower), check_array("upper", upper)


# Standard scores at which exp(-z**2 / 2) falls by another 18 nats, out to underflow.
_Z = 6.0 * np.sqrt(np.arange(40))
NORMAL_KNOTS: Array = np.concatenate([-_Z[:0:-1], _Z])


@dataclass(frozen=True, eq=False)
class Normal(ByValue):
    """Normal law; with `std` 0, a fixed value. `mean` and `std` have the unit of the quantity.

    Raises ValueError for a negative or infinite `std`, an infinite `mean` and numbers beyond 1e150,
    TypeError for anything but real numbers.
    """

    mean: Values
    std: Values

    def __post_init__(self) -> None:
        self._keep(mean=check_finite("mean", self.mean), std=check_scale("std", self.std))

    @classmethod
    def from_width(cls, mean: ArrayLike, width: ArrayLike, multiple: ArrayLike) -> Self:
        """Law for which the full `width` of an interval is `multiple` standard deviations.

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
        # Every value lies beyond one or both of reversed limits.
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
        """Probability density; at the limits, that of the interior."""
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


# Relative change of the density between the limits below which the law counts as rectangular.
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
        """Probability density; at the limits, that of the interior."""
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
    """Return the quantile of the standard normal law between the limits.

    Each half of the law is inverted in its tail, where masses keep their digits.
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


Law = Normal | Uniform | TruncatedNormal
LAWS = (Normal, Uniform, TruncatedNormal)


def check_law(name: str, law: Any, *kinds: type) -> None:
    """Raise TypeError unless the law is of one of the kinds (of any kind by default)."""
    allowed = " or ".join(kind.__name__ for kind in kinds or LAWS)
    require(isinstance(law, kinds or LAWS), name, law, f"must be a law, {allowed}", TypeError)


def list_parameters(law: Law) -> list[Array]:
    """Return the parameters of the law in the order of its constructor."""
    return [np.asarray(getattr(law, field.name), dtype=float) for field in fields(law)]


def select(law: Law, shape: tuple[int, ...], index: Any) -> Law:
    """Broadcast every parameter of the law to `shape`, flatten it and index it."""
    return type(law).of_checked(
        **{n: np.broadcast_to(p, shape).reshape(-1)[index] for n, p in vars(law).items()}
    )


def find_centre(law: Law) -> Array:
    """Return a point where the law has its mass, or within a width of it."""
    if isinstance(law, Uniform):
        return np.asarray(law.lower) / 2 + np.asarray(law.upper) / 2
    if isinstance(law, Normal):
        return np.asarray(law.mean)
    centre: Array = np.clip(law.mean, law.lower, law.upper)
    return centre


def move(law: Law, distance: ArrayLike) -> Law:
    """Return the law of the value plus `distance`, which shifts every parameter but the width."""
    moved = {n: p if n == "std" else np.add(p, distance) for n, p in vars(law).items()}
    return type(law).of_checked(**moved)
