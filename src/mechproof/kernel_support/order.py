"""The order of doubles: whole numbers that differ by one for neighbours, with 0 for zero."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

LOWEST, LARGEST = np.iinfo(np.int64).min, np.iinfo(np.int64).max


def to_order(values: ArrayLike) -> NDArray[np.int64]:
    """Return the place of each double in their order."""
    bits: Any = np.asarray(values, np.float64).view(np.int64)
    places: NDArray[np.int64] = np.where(bits < 0, -(bits & LARGEST), bits)
    return places


def from_order(places: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return the doubles at places in their order."""
    bits: Any = np.where(places < 0, LOWEST | -places, places)
    return np.asarray(bits, np.int64).view(np.float64)


def step_ulps(values: ArrayLike, steps: ArrayLike) -> NDArray[np.float64]:
    """Move doubles by whole numbers of ulps, across zero and powers of two as well."""
    return from_order(to_order(values) + np.asarray(steps, np.int64))
