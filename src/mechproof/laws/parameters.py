"""What the laws share: parameters that are equal by value, checked limits and sizes to draw."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array, check_generator, check_shape
from mechproof.arguments.scalars import require
from mechproof.laws.windows import Array

Values = float | Array


class ByValue:
    """Laws are equal if they are of one kind and their parameters are, in shape and value."""

    def _keep(self, **parameters: ArrayLike) -> None:
        for name, value in parameters.items():
            own = np.array(value, np.float64)
            own.flags.writeable = False
            object.__setattr__(self, name, own)

    @classmethod
    def of_checked(cls, **parameters: ArrayLike) -> Self:
        """Return a law of parameters that were checked: what is derived may lie beyond limits."""
        law = object.__new__(cls)
        law._keep(**parameters)
        return law

    def _check_draw(self, rng: Any, size: Any) -> None:
        """Raise an error for what is no generator, and a size in which values would recur."""
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
        # Zero has one sign then, and NaN one pattern.
        plain = [np.where(np.isnan(p), np.nan, p + 0.0) for p in vars(self).values()]
        return hash((type(self), *((p.shape, p.tobytes()) for p in plain)))


class BoundedLaw(ByValue, ABC):
    """A law between limits, of which the mass of a window says everything."""

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
        # Of reversed limits, every value is beyond one or both.
        return np.minimum(beyond, 1.0)


def check_limits(lower: ArrayLike, upper: ArrayLike) -> tuple[Array, Array]:
    """Both limits as float64, in any order."""
    return check_array("lower", lower), check_array("upper", upper)
