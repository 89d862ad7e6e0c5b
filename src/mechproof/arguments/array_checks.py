"""Checks of array-likes."""

from __future__ import annotations

from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.scalars import (
    check_count,
    check_items,
    check_number,
    refuse,
    refuse_units,
    require,
)

Array = NDArray[np.float64]

# Beyond this, squares and the widths of tails leave the range of a double.
LARGEST = 1e150


def check_array(name: str, value: Any) -> Array:
    """Return `value` as float64; TypeError if it is not real, or has a mask or a unit."""
    refuse_units(name, value)
    if isinstance(value, np.ma.MaskedArray):
        allowed = "is a masked array; give NaN for unknown values, or compressed()"
        refuse(name, value, allowed, TypeError)
    exact = isinstance(value, Real) and not isinstance(value, np.generic)
    number = check_number(name, value) if exact else value
    try:
        array = np.asarray(number)
    except ValueError:
        refuse(name, value, "must be a real number or rows of one length")
    if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        refuse(name, value, f"must be a real number or an array, not {array.dtype}", TypeError)
    return array.astype(np.float64, copy=False)


def check_finite(name: str, value: ArrayLike) -> Array:
    """Return `value` as float64 if it is within +-1e150; NaN passes, an infinity does not."""
    array = check_array(name, value)
    require(not np.isinf(array).any(), name, value, "must be finite")
    return check_range(name, array)


def check_range(name: str, array: Array) -> Array:
    """Return the array if its finite numbers are within +-1e150; infinities and NaN pass."""
    beyond = (np.abs(array) > LARGEST) & ~np.isinf(array)
    require(not beyond.any(), name, array, f"must be between -{LARGEST:g} and {LARGEST:g}")
    return array


def check_scale(name: str, value: ArrayLike) -> Array:
    """Return `value` as float64 if it is finite and not negative (NaN passes)."""
    array = check_finite(name, value)
    require(not (array < 0).any(), name, value, "must not be negative")
    return array


def check_order(
    what: str, lower: ArrayLike, upper: ArrayLike, names: tuple[str, str] = ("lower", "upper")
) -> tuple[Array, Array]:
    """Return both limits as float64 if lower < upper everywhere (NaN passes)."""
    low, high = (check_array(n, v) for n, v in zip(names, (lower, upper), strict=True))
    apart = not np.any(low >= high)
    require(apart, what, (lower, upper), "the lower limit must be below the upper limit")
    return check_range(names[0], low), check_range(names[1], high)


def check_pair(name: str, value: Any) -> tuple[Array, Array]:
    """Return both limits of a pair (lower, upper) as float64, checked by `check_order`."""
    lower, upper = check_items(name, value, 2, "must be a pair (lower, upper)")
    names = f"{name}[0]", f"{name}[1]"
    return check_order(f"{name} (lower, upper)", lower, upper, names)


def check_flag(name: str, value: Any) -> bool:
    """Return a bool; TypeError for anything else, although a condition would accept it."""
    is_flag = isinstance(value, bool | np.bool)
    require(is_flag, name, value, f"must be True or False, not {type(value).__name__}", TypeError)
    return bool(value)


def check_generator(name: str, value: Any) -> np.random.Generator:
    """Return a random generator; TypeError for anything else."""
    if not isinstance(value, np.random.Generator):
        refuse(name, value, "must be a numpy.random.Generator", TypeError)
    return value


def check_shape(name: str, value: Any) -> tuple[int, ...]:
    """Return a shape, given as one length or several; TypeError or ValueError otherwise."""
    lengths = value if isinstance(value, tuple | list) else (value,)
    return tuple(check_count(name, length, least=0) for length in lengths)
