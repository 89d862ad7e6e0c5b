"""Checks of parameters: an error names the parameter, its value and what is allowed."""

from __future__ import annotations

from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.conformity.windows import Array

# Beyond it squares and the widths of tails leave the range of a double.
LARGEST = 1e150


def require(condition: ArrayLike, name: str, value: object, allowed: str) -> None:
    """Raise a ValueError that names the parameter, its value and what is allowed."""
    if not np.all(condition):
        raise ValueError(f"{name} = {value!r}: {allowed}")


def require_reals(name: str, value: Any) -> Array:
    """`value` as float64; TypeError for what is no real number, has a mask or a unit."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array: give NaN for what is unknown")
    if hasattr(value, "units"):
        raise TypeError(f"{name} = {value!r} carries a unit: give plain numbers in one unit")
    exact = isinstance(value, Real) and not isinstance(value, np.generic)
    array = np.asarray(float(value) if exact else value)
    if isinstance(value, bool) or array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        raise TypeError(f"{name} = {value!r}: must be a real number or an array of them")
    return array.astype(np.float64, copy=False)


def require_finite(name: str, value: ArrayLike) -> Array:
    """`value` as float64 if it is within +-1e150; NaN passes, an infinity does not."""
    array = require_reals(name, value)
    require(~np.isinf(array), name, value, "must be finite")
    return require_range(name, array)


def require_range(name: str, array: Array) -> Array:
    """Return finite numbers within +-1e150, infinities and NaN as they are."""
    inside = ~(np.abs(array) > LARGEST) | np.isinf(array)
    require(inside, name, array, f"must be between -{LARGEST:g} and {LARGEST:g}")
    return array


def require_scale(name: str, value: ArrayLike) -> Array:
    """`value` as float64 if it is finite and not negative (NaN passes)."""
    array = require_finite(name, value)
    require(~(array < 0), name, value, "must not be negative")
    return array


def require_order(
    what: str, lower: ArrayLike, upper: ArrayLike, names: tuple[str, str] = ("lower", "upper")
) -> tuple[Array, Array]:
    """Both limits as float64 if lower < upper everywhere (NaN passes)."""
    low, high = (require_reals(n, v) for n, v in zip(names, (lower, upper), strict=True))
    require(~(low >= high), what, (lower, upper), "the lower limit must be below the upper limit")
    return require_range(names[0], low), require_range(names[1], high)


def require_pair(name: str, value: Any) -> tuple[Array, Array]:
    """Both limits of a pair (lower, upper) as float64, as `require_order`."""
    try:
        lower, upper = value
    except (TypeError, ValueError):
        raise TypeError(f"{name} = {value!r}: must be a pair (lower, upper)") from None
    names = f"{name}[0]", f"{name}[1]"
    return require_order(f"{name} (lower, upper)", lower, upper, names)


def require_law(name: str, law: Any, *kinds: type) -> None:
    """Raise a TypeError unless the law is of one of the kinds."""
    if not isinstance(law, kinds):
        allowed = " or ".join(kind.__name__ for kind in kinds)
        raise TypeError(f"{name} = {law!r}: must be a law, {allowed}")
