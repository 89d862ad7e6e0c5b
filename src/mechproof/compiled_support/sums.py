"""Sums over axes of any length: arrays of every shape, and what compiled functions hand over."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.compiled_support.loops import check_arrays, fill_target
from mechproof.compiled_support.pieces import DOUBLE, PIECE, are_plain, cut, make_plain
from mechproof.kernel_support.arrays import as_floats, as_numpy, sum_axes

# With fewer sets than this, and sums of at least this length, sets are computed one after the
# other.
FEW, LONG = 4, 1024


@dataclass(frozen=True)
class Sums:
    """A compiled kernel that sums over axes: its arguments, and the loop over points.

    `axes` are the numbers of axes that are summed over, `widths` the lengths of other last axes.
    `rows` takes a flat target, the number of terms, and of every argument a table: a row for each
    point or one for all, a column for each element or one for all; `at` takes one point.
    """

    names: tuple[str, ...]
    axes: tuple[int, ...]
    at: Callable[..., Any]
    rows: Callable[..., None]
    widths: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "widths", self.widths or (0,) * len(self.names))

    @cached_property
    def ranks(self) -> tuple[int, ...]:
        """Return how many axes of each argument are none of points."""
        return tuple(n or bool(width) for n, width in zip(self.axes, self.widths, strict=True))


def run_sums(sums: Sums, arguments: tuple[Any, ...], out: NDArray[Any] | None) -> Any:
    """Return a kernel's values, in `out` if there is one.

    Raises
    ------
    TypeError, ValueError
        As the kernels of NumPy; TypeError for arrays with ufuncs of their own, too.

    """
    # The most usual arguments are recognised by type alone; all else costs as much as many points.
    is_double = all(map(_is_double, arguments))
    given = arguments if is_double else as_floats(" ".join(sums.names), *arguments, axes=sums.ranks)
    arrays = tuple(map(as_numpy, given))
    if not is_double or any(sums.widths):
        check_arrays(sums.names, arrays, sums.widths)
    named = zip(sums.names, arrays, sums.axes, strict=True)
    summed = sum_axes(**{name: (array, n) for name, array, n in named if n})
    rest = iter(summed)
    arrays = tuple([next(rest) if n else a for a, n in zip(arrays, sums.axes, strict=True)])
    terms = next((a.shape[-1] for a in summed if a.shape[-1] != 1), 1)
    outer = [a.shape[: a.ndim - rank] for a, rank in zip(arrays, sums.ranks, strict=True)]
    # Most shapes are equal, or are those of a single point.
    several = {shape for shape in outer if shape}
    if len(several) > 1 and is_double:
        # Raises where they do not broadcast, with a name.
        as_floats(" ".join(sums.names), *arguments, axes=sums.ranks)
    points = np.broadcast_shapes(*several) if len(several) > 1 else next(iter(several), ())

    def fill(target: NDArray[Any]) -> None:
        _fill(sums, target, terms, arrays, outer)

    return fill_target(fill, points, arrays, out)


def _is_double(value: Any) -> bool:
    kind = type(value)
    return kind is float or (kind is np.ndarray and value.dtype is DOUBLE and value.ndim > 0)


def _fill(
    sums: Sums,
    target: NDArray[Any],
    terms: int,
    arrays: tuple[Any, ...],
    outer: list[tuple[int, ...]],
) -> None:
    """Fill a target: what all points have in common is one row, copies stay in a cache."""
    points, given = target.shape, list(zip(arrays, outer, strict=True))
    are_alike = all(shape == points or math.prod(shape) == 1 for shape in outer)
    if are_alike and are_plain(arrays):
        _fill_part(sums, target.reshape(-1), terms, [_table(*pair) for pair in given])
        return
    largest = max(math.prod(array.shape[len(shape) :]) for array, shape in given)
    wide = [
        (make_plain(a), s) if math.prod(s) == 1 else (_spread(a, s, points), points)
        for a, s in given
    ]
    for index in cut(points, max(PIECE // max(largest, 1), 1)):
        tables = [make_plain(_table(a[index] if s == points else a, s)) for a, s in wide]
        _fill_part(sums, target.reshape(*points, 1)[index].reshape(-1), terms, tables)


def _spread(array: NDArray[Any], old: tuple[int, ...], new: tuple[int, ...]) -> NDArray[Any]:
    """Broadcast the axes of points."""
    return np.broadcast_to(array, new + array.shape[len(old) :])


def _table(array: NDArray[Any], outer: tuple[int, ...]) -> NDArray[Any]:
    """Return a row for each of the points, which the first axes are of."""
    depth, rows = len(outer), np.ascontiguousarray(array)
    if depth == 1 and rows.ndim == 2:
        return rows
    # There is a point, so that the number of rows determines that of columns.
    return rows.reshape(math.prod(array.shape[:depth]), -1)


def _fill_part(sums: Sums, part: NDArray[Any], terms: int, tables: list[NDArray[Any]]) -> None:
    """Fill a flat part; few long sums gain nothing from lying beside each other."""
    if len(part) >= FEW or max([table.shape[1] for table in tables]) < LONG:
        sums.rows(part, terms, *tables)
        return
    for i in range(len(part)):
        rows = zip((table[min(i, len(table) - 1)] for table in tables), sums.axes, strict=True)
        part[i] = sums.at(*[value for row, axes in rows for value in _unpack(row, axes, terms)])


def _unpack(row: NDArray[Any], axes: int, terms: int) -> Any:
    """Return what one point takes of a row: its numbers, or an array of terms."""
    if not axes:
        return row.tolist()
    if axes == 2:
        return [row.reshape(terms, terms)]
    return [row if len(row) == terms else np.full(terms, row[0])]
