"""Sums over axes of any length: kernels called with arrays of every shape."""

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

# Fewer sets than this, with sums of at least this length, are computed one after the other.
FEW, LONG = 4, 1024


@dataclass(frozen=True)
class Sums:
    """A compiled kernel that sums over axes: its arguments, and the loop over points.

    `axes` are the numbers of axes that are summed over, `widths` the lengths of other last axes.
    `rows` takes a flat target, the number of terms, and for every argument a table: a row for each
    point or one for all, a column for each element or one for all; `at` computes one point.
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
        """Return the number of last axes of each argument that are not axes of points."""
        return tuple(n or bool(width) for n, width in zip(self.axes, self.widths, strict=True))


def run_sums(sums: Sums, arguments: tuple[Any, ...], out: NDArray[Any] | None) -> Any:
    """Return a kernel's values, stored in `out` if given.

    Raises
    ------
    TypeError, ValueError
        As NumPy kernels do; TypeError also for arrays that bring their own ufuncs.

    """
    # The most usual arguments are recognised by type alone: all else costs as much as many points.
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
    # Most shapes are equal, or empty for a single point.
    several = {shape for shape in outer if shape}
    if len(several) > 1 and is_double:
        # Raises an error that names the argument if they do not broadcast.
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
    """Fill a target in parts whose copies fit a cache; values common to all points are one row."""
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
    """Return an array with its axes of points broadcast from one shape to another."""
    return np.broadcast_to(array, new + array.shape[len(old) :])


def _table(array: NDArray[Any], outer: tuple[int, ...]) -> NDArray[Any]:
    """Return an array as a table: a row for each point, whose axes are the first ones."""
    depth, rows = len(outer), np.ascontiguousarray(array)
    if depth == 1 and rows.ndim == 2:
        return rows
    # There is at least one point, so the number of rows determines that of columns.
    return rows.reshape(math.prod(array.shape[:depth]), -1)


def _fill_part(sums: Sums, part: NDArray[Any], terms: int, tables: list[NDArray[Any]]) -> None:
    """Fill a flat part; a few long sums are computed singly, as they gain nothing side by side."""
    if len(part) >= FEW or max([table.shape[1] for table in tables]) < LONG:
        sums.rows(part, terms, *tables)
        return
    for i in range(len(part)):
        rows = zip((table[min(i, len(table) - 1)] for table in tables), sums.axes, strict=True)
        part[i] = sums.at(*[value for row, axes in rows for value in _unpack(row, axes, terms)])


def _unpack(row: NDArray[Any], axes: int, terms: int) -> Any:
    """Return the arguments of one point from a row of a table: numbers, or an array of terms."""
    if not axes:
        return row.tolist()
    if axes == 2:
        return [row.reshape(terms, terms)]
    return [row if len(row) == terms else np.full(terms, row[0])]
