"""Terms of a compiled kernel at one point: their number, and arrays with a value for each."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types
from numba.core.errors import TypingError
from numba.extending import overload
from numpy.typing import NDArray

from mechproof.compiled_support.sum_sets import TAKEN


def count_terms(*values: Any) -> int:
    """Return the number of terms: the length of the first array whose length is not 1."""
    raise NotImplementedError("called in compiled functions only")


@overload(count_terms, **TAKEN)
def _count_terms(*values: Any) -> Any:
    if not values:
        return lambda *values: 1
    if not isinstance(values[0], types.Array):
        return lambda *values: count_terms(*values[1:])
    return lambda *values: len(values[0]) if len(values[0]) != 1 else count_terms(*values[1:])


def take_terms(name: str, values: Any, terms: int) -> NDArray[Any]:
    """Return an array with one value per term; a number or an array of one is repeated.

    Raises ValueError, naming the argument, for an array of another length.
    """
    raise NotImplementedError("called in compiled functions only")


@overload(take_terms, jit_options={"no_cfunc_wrapper": True}, strict=False)
def _take_row(name: Any, values: Any, terms: Any) -> Any:
    if not isinstance(values, types.Array):
        return lambda name, values, terms: np.broadcast_to(float(values), (terms,))
    _check_axes(values, 1)

    def take(name: Any, values: Any, terms: Any) -> Any:
        if values.size == terms:
            return values
        if values.size == 1:
            # Contiguous like an array of terms, so that loops need no strides.
            return np.full(terms, values[0])
        raise ValueError(
            f"{name}: last axis must have shape ({terms},), got shape ({values.size},)"
        )

    return take


def take_square(name: str, values: Any, terms: int) -> NDArray[Any]:
    """Return an array with a value per pair of terms; ValueError, naming it, for another shape."""
    raise NotImplementedError("called in compiled functions only")


@overload(take_square, jit_options={"no_cfunc_wrapper": True}, strict=False)
def _take_square(name: Any, values: Any, terms: Any) -> Any:
    _check_axes(values, 2)

    def take(name: Any, values: Any, terms: Any) -> Any:
        rows, columns = values.shape
        if rows != terms or columns != terms:
            raise ValueError(
                f"{name}: last 2 axes must have shape ({terms}, {terms}), "
                f"got shape ({rows}, {columns})"
            )
        return values

    return take


def _check_axes(values: Any, axes: int) -> None:
    """Raise TypingError unless the value is an array of `axes` axes, which belong to one point."""
    if not isinstance(values, types.Array) or values.ndim != axes:
        raise TypingError(f"a compiled function takes an array of {axes} axes here, got {values}")
