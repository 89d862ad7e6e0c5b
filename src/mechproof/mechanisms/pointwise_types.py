"""Types of methods that compute point by point: a number from a number, an array from an array.

Arguments with units or labels, lists and keyword arguments give `Any`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Concatenate, ParamSpec, Protocol, cast, overload

import numpy as np
from numpy.typing import NDArray

P = ParamSpec("P")
Floats = NDArray[np.float64]


class Pointwise(Protocol[P]):
    """A method that computes point by point."""

    @overload
    def __call__(self, value: float, /) -> np.float64: ...
    @overload
    def __call__(self, value: Floats, /) -> Floats: ...
    @overload
    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> Any: ...


class PointwiseInAngles(Protocol[P]):
    """A method that computes point by point and takes or returns angles."""

    @overload
    def __call__(self, value: float, /, *, degrees: bool = False) -> np.float64: ...
    @overload
    def __call__(self, value: Floats, /, *, degrees: bool = False) -> Floats: ...
    @overload
    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> Any: ...


def pointwise(method: Callable[Concatenate[Any, P], Any]) -> Pointwise[P]:
    """Declare that a method computes point by point."""
    return cast("Pointwise[P]", method)


def pointwise_in_angles(method: Callable[Concatenate[Any, P], Any]) -> PointwiseInAngles[P]:
    """Declare that a method with `degrees` computes point by point."""
    return cast("PointwiseInAngles[P]", method)
