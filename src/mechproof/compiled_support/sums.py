"""Sums over axes of any length: arrays of every shape, and what compiled functions hand over."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numba import types
from numba.core.errors import TypingError
from numba.extending import overload
from numpy.typing import NDArray

from mechproof.compiled_support.loops import PIECE, check_arrays, cut, fill_target
from mechproof.kernel_support.arrays import as_floats, as_numpy, sum_axes


class Sums(NamedTuple):
    """A compiled kernel that sums over axes: its arguments, and the loop over points.

    `axes` are the numbers of axes that are summed over, `widths` the lengths of other last axes.
    `each` takes a flat target, arrays of points with their axes, and flat arrays of all others.
    """

    names: tuple[str, ...]
    widths: tuple[int, ...]
    axes: tuple[int, ...]
    each: Callable[..., None]


def run_sums(sums: Sums, arguments: tuple[Any, ...], out: NDArray[Any] | None) -> Any:
    """Return a kernel's values, in `out` if there is one.

    Raises
    ------
    TypeError, ValueError
        As the kernels of NumPy; TypeError for arrays with ufuncs of their own, too.

    """
    axes = tuple(n or min(width, 1) for n, width in zip(sums.axes, sums.widths, strict=True))
    arrays = tuple(map(as_numpy, as_floats(" ".join(sums.names), *arguments, axes=axes)))
    check_arrays(sums.names, arrays, sums.widths)
    known = dict(zip(sums.names, arrays, strict=True))
    counts = {name: n for name, n in zip(sums.names, sums.axes, strict=True) if n}
    summed = sum_axes(**{name: (known[name], n) for name, n in counts.items()})
    known |= zip(counts, summed, strict=True)
    terms = next((a.shape[-1] for a in summed if a.shape[-1] != 1), 1)
    tails = [
        (terms,) * n if n else (width,) if width else ()
        for n, width in zip(sums.axes, sums.widths, strict=True)
    ]
    arrays = tuple(known.values())
    outer = [a.shape[: a.ndim - len(tail)] for a, tail in zip(arrays, tails, strict=True)]
    points = np.broadcast_shapes(*outer)

    def fill(target: NDArray[Any]) -> None:
        _fill(sums, target.reshape(points or (1,)), arrays, tails)

    return fill_target(fill, points, arrays, out)


def _fill(
    sums: Sums, target: NDArray[Any], arrays: tuple[Any, ...], tails: list[tuple[int, ...]]
) -> None:
    """Fill a target: copies of what is spread stay in a cache."""
    wide = [_spread(a, target.shape + tail) for a, tail in zip(arrays, tails, strict=True)]
    kept = [tail if n else () for tail, n in zip(tails, sums.axes, strict=True)]
    largest = max(map(math.prod, tails))
    for index in cut(target.shape, max(PIECE // max(largest, 1), 1)):
        part = target[index].reshape(-1)
        each = [
            np.ascontiguousarray(a[index]).reshape((part.size if tail else -1, *tail))
            for a, tail in zip(wide, kept, strict=True)
        ]
        sums.each(part, *each)


def _spread(array: Any, shape: tuple[int, ...]) -> NDArray[Any]:
    """Broadcast an array; one of as many numbers is reshaped, which costs less."""
    same = array.size == math.prod(shape)
    return array.reshape(shape) if same else np.broadcast_to(array, shape)


def count_terms(known: int, values: Any) -> int:
    """Return the number of terms: the known one unless it is 1, else that of the values."""
    raise NotImplementedError("called in compiled functions only")


@overload(count_terms, strict=False)
def _count(known: Any, values: Any) -> Any:
    if isinstance(values, types.Array):
        return lambda known, values: len(values) if known == 1 else known
    return lambda known, values: known


def take_terms(name: str, values: Any, terms: int) -> NDArray[Any]:
    """Return one value for each term; a number or an array of one stands for equal ones.

    Raises ValueError that names an array of another length.
    """
    raise NotImplementedError("called in compiled functions only")


@overload(take_terms, strict=False)
def _take_row(name: Any, values: Any, terms: Any) -> Any:
    if not isinstance(values, types.Array):
        return lambda name, values, terms: np.broadcast_to(float(values), (terms,))
    _check_axes(values, 1)

    def take(name: Any, values: Any, terms: Any) -> Any:
        if values.size != terms and values.size != 1:
            raise ValueError(
                f"{name}: last axis must have shape ({terms},), got shape ({values.size},)"
            )
        return np.broadcast_to(values, (terms,))

    return take


def take_square(name: str, values: Any, terms: int) -> NDArray[Any]:
    """Return one value for each pair of terms; ValueError that names an array of another shape."""
    raise NotImplementedError("called in compiled functions only")


@overload(take_square, strict=False)
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
    """Refuse what has other axes: compiled functions compute one point."""
    if not isinstance(values, types.Array) or values.ndim != axes:
        raise TypingError(f"a compiled function takes an array of {axes} axes here, got {values}")
