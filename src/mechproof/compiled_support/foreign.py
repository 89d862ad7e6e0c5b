"""Arrays with labels, from pandas and xarray: compute with their numbers, put labels back."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np


def find_labelled(arrays: tuple[Any, ...]) -> int | None:
    """Return the place of the only array if it has labels and all other arguments are numbers.

    None otherwise: two labelled arrays would have to be aligned. Arrays in chunks, which are lazy,
    count as having no labels.
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
    """Return a ufunc for its first argument, as arrays with labels support ufuncs."""
    from numba import vectorize

    return vectorize(["f4(f4, f4)", "f8(f8, f8)"])(_take_first)


def _take_first(value: float, other: float) -> float:
    return value
