"""Sizes with limits, and the checked call of a function of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.scalars import check_mapping, check_progress, check_real, require
from mechproof.laws import Normal, TruncatedNormal, Uniform

Floats = NDArray[np.float64]
Function = Callable[..., Any]
Progress = Callable[[int, int], object]

# Values per call of the function: small enough for its temporaries to stay in the cache.
CHUNK = 2**16


@dataclass(frozen=True)
class Size:
    """A nominal size with its upper and lower limit deviations, both signed.

    `Size(38, 0, -2.06)` lies between 35.94 and 38. Both deviations may have the same sign (a
    fit). Without deviations, the size is fixed. Raises TypeError for anything but real numbers, and
    ValueError if they are not finite or the limits are equal as doubles (except for a fixed size).
    """

    nominal: float
    upper: float = 0.0
    lower: float = 0.0

    def __post_init__(self) -> None:
        """Check the limits."""
        for name in ("nominal", "upper", "lower"):
            check_real(name, getattr(self, name))
        lowest, highest = self.limits
        if lowest >= highest and (self.upper, self.lower) != (0, 0):
            raise ValueError(
                f"upper = {self.upper}, lower = {self.lower}: the upper limit must be above "
                f"the lower at nominal = {self.nominal}, or both deviations zero (a fixed size)"
            )

    @property
    def limits(self) -> tuple[float, float]:
        """The lower and the upper limit."""
        return self.nominal + self.lower, self.nominal + self.upper

    @property
    def tolerance(self) -> float:
        """The width between the limits."""
        return self.upper - self.lower

    @property
    def middle_deviation(self) -> float:
        """The deviation of the middle between the limits from the nominal size."""
        return (self.upper + self.lower) / 2

    def uniform(self) -> Uniform:
        """Return the uniform law between the limits of the size."""
        return Uniform(*self.limits)

    def normal(self, multiple: float) -> Normal:
        """Return the normal law about the middle of the limits; it extends beyond them.

        The tolerance is `multiple` standard deviations wide, `multiple` > 0.
        """
        middle = self.nominal + self.middle_deviation
        return Normal.from_width(middle, self.tolerance, multiple)

    def truncated_normal(self, multiple: float) -> TruncatedNormal:
        """Return the law `normal` truncated to the limits: sizes beyond them are sorted out."""
        law = self.normal(multiple)
        return TruncatedNormal(law.mean, law.std, *self.limits)


def check_sizes(sizes: Mapping[str, Size]) -> dict[str, Size]:
    """Return the toleranced sizes; a TypeError names anything that is not a Size."""
    check_mapping("sizes", sizes, "must map names to Sizes")
    for name, size in sizes.items():
        is_named = isinstance(name, str) and isinstance(size, Size)
        require(is_named, f"sizes[{name!r}]", size, "must be a Size with a name", TypeError)
    return {name: size for name, size in sizes.items() if size.tolerance}


def check_names(name: str, given: Mapping[str, object], varying: Mapping[str, Size]) -> None:
    """Raise an error unless `given` has exactly the sizes with a tolerance."""
    allowed = f"must be given for the sizes with a tolerance, {sorted(varying)}"
    check_mapping(name, given, allowed)
    require(set(given) == set(varying), name, sorted(map(str, given)), allowed)


def evaluate(
    function: Function, inputs: Floats, sizes: Mapping[str, float | Floats], shape: tuple[int, ...]
) -> Floats:
    """Return function(inputs, **sizes) as float64 of the given shape.

    Raises TypeError if the function returns no real numbers, ValueError if its shape does not fit.
    """
    values = np.asarray(function(inputs, **sizes))
    if values.dtype.kind not in "fiub":
        raise TypeError(f"function returned dtype {values.dtype}: must return real numbers")
    try:
        return np.broadcast_to(values, shape).astype(np.float64, copy=False)
    except ValueError:
        raise ValueError(
            f"function returned shape {values.shape} but inputs and sizes broadcast to {shape}: "
            "it must work point by point"
        ) from None


def evaluate_nominal(function: Function, inputs: Floats, sizes: Mapping[str, Size]) -> Floats:
    """Return the function at the nominal sizes."""
    nominal = {name: size.nominal for name, size in sizes.items()}
    return evaluate(function, inputs, nominal, inputs.shape).copy()


class Report:
    """Counts the function values computed and reports them to the caller's callback."""

    def __init__(self, total: int, progress: Progress | None) -> None:
        check_progress(progress)
        self.done, self.total, self.progress = 0, total, progress

    def add(self, values: int) -> None:
        """Add newly computed values and report."""
        self.done += values
        if self.progress is not None:
            self.progress(self.done, self.total)
