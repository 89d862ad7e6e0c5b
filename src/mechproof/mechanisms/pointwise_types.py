"""Types of methods that compute point by point: of a number a number, of an array an array.

What has a unit or labels, and a list, gives `Any`; so does an argument by its name.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Concatenate, ParamSpec, Protocol, cast, overload

import numpy as np
from numpy.typing import NDArray

P = ParamSpec("P")
Floats = NDArray[np.float64]


class Pointwise(Protocol[P]):
    """A method of points."""

    @overload
    def __call__(self, value: float, /) -> np.float64: ...
    @overload
    def __call__(self, value: Floats, /) -> Floats: ...
    @overload
    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> Any: ...


class PointwiseInAngles(Protocol[P]):
    """A method of points that takes or gives angles."""

    @overload
    def __call__(self, value: float, /, *, degrees: bool = False) -> np.float64: ...
    @overload
    def __call__(self, value: Floats, /, *, degrees: bool = False) -> Floats: ...
    @overload
    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> Any: ...


def pointwise(method: Callable[Concatenate[Any, P], Any]) -> Pointwise[P]:
    """Say that a method computes point by point."""
    return cast("Pointwise[P]", method)


def pointwise_in_angles(method: Callable[Concatenate[Any, P], Any]) -> PointwiseInAngles[P]:
    """Say that a method with `degrees` computes point by point."""
    return cast("PointwiseInAngles[P]", method)
