"""Arrays with labels, of pandas and xarray: numbers are computed, labels are put back."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np


def find_labelled(arrays: tuple[Any, ...]) -> int | None:
    """Return which argument has labels, if all others are numbers; None if none or several have.

    Two of them would have to be aligned. Lazy arrays, such as arrays in chunks, have none.
    """
    places = [i for i, array in enumerate(arrays) if np.ndim(array)]
    if len(places) != 1:
        return None
    array = arrays[places[0]]
    has_labels = hasattr(array, "to_numpy") and getattr(array, "chunks", None) is None
    return places[0] if has_labels else None


def label(values: Any, labelled: Any) -> Any:
    """Return values with the labels of an array of their shape."""
    return _keep_first()(values, labelled)


@cache
def _keep_first() -> Any:
    """Return a ufunc, which arrays with labels know how to be called with."""
    from numba import vectorize

    return vectorize(["f4(f4, f4)", "f8(f8, f8)"])(_take_first)


def _take_first(value: float, other: float) -> float:
    return value
