"""Arrays of every shape as loops over flat ones: rows of equal parameters, blocks, threads."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.compiled_support.foreign import find_labelled, label
from mechproof.compiled_support.machine import typeof
from mechproof.compiled_support.pieces import DOUBLE, PIECE, are_plain, cut, make_plain
from mechproof.kernel_support.arrays import PLAIN, as_floats, as_numpy, check_components
from mechproof.kernel_support.blocks import WRITTEN, check_out
from mechproof.tools.processes import count_processors

# Numbers of points in a row from which a separate call, and a second thread, is worthwhile.
LONG_ROW = 32
THREADED = 2**17
IN_A_ROW = (DOUBLE.itemsize,)
NUMBERS = (float, np.float64)


@dataclass(slots=True)
class Loops:
    """A compiled kernel: its arguments, the shape of a result, and two ways to call it.

    `widths` are the lengths of last axes, 0 if there is none. `at` computes one point; `rows` takes
    flat targets, one for each of several `results`, a flat array of points, and for each parameter
    a flat array or a value common to all points. `point` and `fill` are direct entries to `at` and
    `rows`, for Python numbers and for rows accepted by `take_row`.
    """

    names: tuple[str, ...]
    at: Callable[..., Any]
    rows: Callable[..., None]
    widths: tuple[int, ...] = ()
    shape: tuple[int, ...] = ()
    results: int = 1
    point: Callable[..., Any] = field(init=False)
    fill: Callable[..., None] = field(init=False)

    def __post_init__(self) -> None:
        self.widths = self.widths or (0,) * len(self.names)
        self.point, self.fill = self._compute_first, self._fill_first

    def _compute_first(self, *numbers: float) -> Any:
        self.point = find_entry(self.at, *numbers)
        return self.point(*numbers)

    def _fill_first(self, row: NDArray[Any], points: NDArray[Any], *parameters: float) -> None:
        # Compiled for writeable rows, which also works for read-only ones.
        self.fill = find_entry(self.rows, row, row, *parameters)
        self.fill(row, points, *parameters)


def find_entry(function: Any, *arguments: Any) -> Callable[..., Any]:
    """Return the entry that numba compiles for arguments of these types, without type dispatch.

    Dispatch takes a third of the time of a call with few points.
    """
    entry: Callable[..., Any] = function.compile(tuple(map(typeof, arguments)))
    return entry


def take_row(first: NDArray[Any], out: NDArray[Any] | None) -> NDArray[Any] | None:
    """Return the array into which a short row of doubles can be computed directly, else None.

    As the first test of a call, it must cost less than the loop over ten points.
    """
    if first.dtype is not DOUBLE or first.strides != IN_A_ROW:
        return None
    if first.base is not None and not first.flags.aligned:
        return None
    size = len(first)
    if size >= THREADED:
        return None
    if out is None:
        return np.empty(size)
    if type(out) is not np.ndarray or out.dtype is not DOUBLE or out.strides != IN_A_ROW:
        return None
    is_ready = len(out) == size and out.flags.carray and _are_apart(first, out)
    return out if is_ready else None


def _are_apart(first: NDArray[Any], out: NDArray[Any]) -> bool:
    """Return whether two arrays share no memory; quick if neither is a view."""
    if first.base is None and out.base is None:
        return first is not out
    return not np.may_share_memory(out, first)


def run(loops: Loops, arguments: tuple[Any, ...], out: NDArray[Any] | None) -> Any:
    """Return a kernel's values, stored in `out` if given.

    Raises
    ------
    TypeError, ValueError
        As NumPy kernels do; TypeError also for arrays that bring their own ufuncs, except a single
        labelled array among numbers.

    """
    if (row := _take_numbers(loops, arguments, out)) is not None:
        return row
    axes = tuple(min(width, 1) for width in loops.widths) if any(loops.widths) else ()
    arrays = as_floats(" ".join(loops.names), *arguments, axes=axes)
    if (
        not any(loops.widths)
        and all(isinstance(a, (float, np.generic)) for a in arrays)
        and out is None
    ):
        value = loops.point(*map(float, arrays))
        dtype = as_numpy(arrays[0]).dtype
        if loops.results > 1:
            return np.array(value, dtype)
        return np.array(value, dtype).reshape(loops.shape) if loops.shape else dtype.type(value)
    arrays = tuple(map(as_numpy, arrays))
    if out is None and loops.results == 1 and not (any(loops.widths) or loops.shape):
        place = find_labelled(arrays)
        if place is not None:
            labelled: Any = arrays[place]
            plain = (*arrays[:place], labelled.to_numpy(), *arrays[place + 1 :])
            return label(_run(loops, plain, None), labelled)
    return _run(loops, arrays, out)


def _take_numbers(
    loops: Loops, arguments: tuple[Any, ...], out: NDArray[Any] | None
) -> NDArray[Any] | None:
    """Compute a short row of doubles with parameters that are any numbers; None for all else."""
    first, *parameters = arguments
    if type(first) is not np.ndarray or any(loops.widths) or loops.shape or loops.results > 1:
        return None
    if not all(map(_is_double, parameters)):
        return None
    row = take_row(first, out)
    if row is not None:
        loops.fill(row, first, *map(float, parameters))
    return row


def _is_double(value: Any) -> bool:
    """Return whether a value is a single number that leaves arrays of doubles doubles."""
    kind = type(value)
    if kind is int:
        # NumPy has no larger integers.
        return bool(-(2**63) <= value < 2**63)
    return kind in NUMBERS or bool(kind is np.ndarray and value.dtype is DOUBLE and not value.ndim)


def _run(loops: Loops, arrays: tuple[Any, ...], out: NDArray[Any] | None) -> Any:
    check_arrays(loops.names, arrays, loops.widths)
    ranks = [bool(width) for width in loops.widths]
    outer = [a.shape[: a.ndim - r] for a, r in zip(arrays, ranks, strict=True)]
    points = np.broadcast_shapes(*outer)

    def fill(target: NDArray[Any]) -> None:
        several = loops.results > 1
        targets = [target[i, ...] for i in range(loops.results)] if several else [target]
        _fill(loops, targets, points, arrays, outer)

    first = (loops.results,) if loops.results > 1 else ()
    return fill_target(fill, first + points + loops.shape, arrays, out)


def check_arrays(names: tuple[str, ...], arrays: tuple[Any, ...], widths: tuple[int, ...]) -> None:
    """Raise TypeError for an array that is not plain, ValueError for wrong components."""
    for name, array, width in zip(names, arrays, widths, strict=True):
        if type(array) not in PLAIN:
            kind = type(array).__name__
            raise TypeError(f"{name}: compiled kernels take numbers and NumPy arrays, got {kind}")
        if width:
            check_components(name, array, width)


def fill_target(
    fill: Callable[[NDArray[Any]], None],
    whole: tuple[int, ...],
    arrays: tuple[Any, ...],
    out: NDArray[Any] | None,
) -> Any:
    """Return the array of the shape `whole` that `fill` writes, stored in `out` if given."""
    dtype = arrays[0].dtype
    if out is not None:
        check_out(out, whole, dtype)
    direct = (
        out is not None
        and type(out) in WRITTEN
        and out.flags.carray
        and not any(np.may_share_memory(out, a) for a in arrays)
    )
    target = out if direct and out is not None else np.empty(whole, dtype)
    if target.size:
        fill(target)
    if out is None:
        return target if whole else target[()]
    if target is not out:
        out[...] = target
    return out


def _fill(
    loops: Loops,
    targets: list[NDArray[Any]],
    points: tuple[int, ...],
    arrays: tuple[Any, ...],
    outer: list[tuple[int, ...]],
) -> None:
    """Fill targets whose last axes are a result's, by rows of equal parameters if rows are long."""
    depth = len(points) - _count_common_axes(outer[1:], len(points))
    if not depth and outer[0] == points:
        first, *parameters = (array.reshape(-1) for array in arrays)
        known = [*map(_take_parameter, parameters, loops.widths[1:])]
        _fill_uniformly(loops, [t.reshape(-1) for t in targets], first, known)
        return
    wide = [
        _spread(a, (*points, width) if width else points)
        for a, width in zip(arrays, loops.widths, strict=True)
    ]
    if depth and math.prod(points[depth:]) < LONG_ROW:
        for index in cut(points, PIECE):
            flat = [np.ascontiguousarray(a[index]).reshape(-1) for a in wide]
            _fill_pieces(loops, [t[index].reshape(-1) for t in targets], flat)
        return
    rows = [target.reshape((*points[:depth], -1)) for target in targets]
    for index, *numbers in _list_parameters(wide[1:], loops.widths[1:], points, depth):
        row = np.ascontiguousarray(wide[0][index]).reshape(-1)
        _fill_uniformly(loops, [r[index] for r in rows], row, numbers)


def _spread(array: Any, shape: tuple[int, ...]) -> NDArray[Any]:
    """Return an array broadcast to a shape; it is copied later, before a loop takes it."""
    return array if array.shape == shape else np.broadcast_to(array, shape)


def _take_parameter(values: NDArray[Any], width: int) -> Any:
    """Return a parameter common to all points as a Python number, or as a tuple of several."""
    return tuple(values.tolist()) if width else values.item()


def _list_parameters(
    wide: list[NDArray[Any]], widths: tuple[int, ...], points: tuple[int, ...], depth: int
) -> Iterator[tuple[Any, ...]]:
    """Yield the index of each row with its parameters, which are equal along the row."""
    first = (slice(None),) * depth + (0,) * (len(points) - depth)
    columns = [
        map(tuple, column.reshape(-1, width).tolist()) if width else column.reshape(-1).tolist()
        for column, width in zip((a[first] for a in wide), widths, strict=True)
    ]
    return zip(np.ndindex(points[:depth]), *columns, strict=True)


def _count_common_axes(shapes: list[tuple[int, ...]], rank: int) -> int:
    """Return the number of last axes along which no array of the given shapes varies."""
    for axis in range(1, rank + 1):
        if any(len(shape) >= axis and shape[-axis] != 1 for shape in shapes):
            return axis - 1
    return rank


def _fill_uniformly(
    loops: Loops, targets: list[NDArray[Any]], row: NDArray[Any], parameters: Any
) -> None:
    """Fill flat targets with parameters common to all points, on several threads if long."""
    points = row.size // max(loops.widths[0], 1)
    workers = count_processors() if points >= THREADED else 1
    given = [row, *parameters]
    if workers == 1:
        _fill_pieces(loops, targets, given)
        return
    ends = [points * i // workers for i in range(workers + 1)]
    tasks = [
        _pool().submit(_fill_pieces, loops, *_take_points(loops, targets, given, slice(a, b)))
        for a, b in pairwise(ends)
    ]
    for task in tasks:
        task.result()


def _take_points(
    loops: Loops, targets: list[NDArray[Any]], given: list[Any], part: slice
) -> tuple[list[NDArray[Any]], list[Any]]:
    """Return the parts of flat targets and arguments for a range of points."""

    def take(value: Any, width: int) -> Any:
        count = max(width, 1)
        is_array = isinstance(value, np.ndarray)
        return value[part.start * count : part.stop * count] if is_array else value

    found = [take(target, math.prod(loops.shape)) for target in targets]
    return found, [take(v, width) for v, width in zip(given, loops.widths, strict=True)]


def _fill_pieces(loops: Loops, targets: list[NDArray[Any]], given: list[Any]) -> None:
    """Fill flat targets; piece by piece with copies if numba would have to compile anew."""
    if are_plain(given):
        loops.rows(*targets, *given)
        return
    points = targets[0].size // math.prod(loops.shape)
    for start in range(0, points, PIECE):
        part = slice(start, min(start + PIECE, points))
        goals, values = _take_points(loops, targets, given, part)
        loops.rows(*goals, *map(make_plain, values))


def run_parts(act: Callable[[Any], object], parts: Iterable[Any]) -> None:
    """Call a compiled function for each part, using all processors."""
    if count_processors() == 1:
        for part in parts:
            act(part)
        return
    for _ in _pool().map(act, parts):
        pass


@cache
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(count_processors(), "mechproof")


# A forked process does not have its parent's threads.
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_pool.cache_clear)
