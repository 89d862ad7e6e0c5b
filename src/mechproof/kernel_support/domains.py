"""Domains of kernels: conditions on numbers and arrays, and NaN where one fails."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import inf, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.kernel_support.arrays import BOOLS, PLAIN, SCALARS, as_numbers

# Types whose finiteness is found fastest by a comparison.
COMPARED = SCALARS | {Fraction}


def is_finite(value: Any) -> Any:
    """Return np.isfinite(value), also for a fraction; fast for scalars, for which NumPy is slow."""
    return abs(value) < inf if type(value) in COMPARED else np.isfinite(value)


def is_positive(value: Any) -> Any:
    """Return whether 0 < value < oo; a single True for a plain array if it holds everywhere."""
    if type(value) is float:
        return 0.0 < value < inf
    smallest, largest = find_extremes(value)
    return (smallest > 0.0 and largest < inf) or (value > 0.0) & is_finite(value)


def is_nonnegative(value: Any) -> Any:
    """Return whether 0 <= value < oo; a single True for a plain array if it holds everywhere."""
    if type(value) is float:
        return 0.0 <= value < inf
    smallest, largest = find_extremes(value)
    return (smallest >= 0.0 and largest < inf) or (value >= 0.0) & is_finite(value)


def find_extremes(array: Any) -> tuple[float, float]:
    """Return the smallest and the largest number; NaN if any is NaN, or if not a plain array.

    To find them by argmin and argmax takes a third of the time of min and max, and half of that of
    comparisons.
    """
    if type(array) is not np.ndarray or not array.size:
        return nan, nan
    return array.item(array.argmin()), array.item(array.argmax())


def nan_outside(
    check: Callable[..., tuple[Any, ...]], *values: Any, terms: tuple[Any, ...] = ()
) -> tuple[NDArray[Any], ...]:
    """Return the values where all conditions of check(*values, *terms) hold, NaN elsewhere.

    If all hold everywhere, the values are returned unchanged. Arrays of one number are tested as
    numbers.
    """
    numbers = as_numbers(values)
    if numbers is not None and not terms:
        return values if all(check(*numbers)) else tuple([value * nan for value in values])
    inside: Any = True
    for condition in check(*values, *terms):
        # Conditions that hold everywhere are skipped, so that few arrays, mostly none, have to be
        # combined.
        if condition is not True and not holds(condition):
            inside = condition if inside is True else inside & condition
    if inside is True:
        return values
    if type(inside) in BOOLS:
        return tuple([value * nan for value in values])
    if type(inside) is np.ndarray and PLAIN.issuperset(map(type, values)):
        # Unlike a product with a mask, this keeps the shape of each value.
        return tuple([np.where(inside, value, nan) for value in values])
    # A product keeps the mask, the laziness or the unit, which np.where would drop.
    factor = np.where(inside, 1.0, np.nan)
    return tuple([value * factor for value in values])


def every(condition: Any, axis: Any) -> Any:
    """Return np.all(condition, axis), or a single True, without a reduction, if all are true.

    Masked elements count as true: the result is masked there anyway.
    """
    if condition is True or holds(condition):
        return True
    plain = condition.filled(True) if isinstance(condition, np.ma.MaskedArray) else condition
    return np.all(plain, axis=axis)


def holds(condition: Any) -> bool:
    """Return whether a condition is known to be true everywhere; lazy arrays are not evaluated."""
    if type(condition) is np.ndarray:
        # For a short array this costs a fifth of condition.all().
        return bool(np.count_nonzero(condition) == condition.size)
    return type(condition) in BOOLS and bool(condition)
