"""Evaluation of kernels in blocks of points, and the storing of results."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.scalars import refuse_units
from mechproof.kernel_support.arrays import (
    DOUBLE,
    PLAIN,
    SCALARS,
    SINGLE,
    as_numbers,
    as_numpy,
    cast,
)

# Numbers per block, of arguments and results together: with the temporaries of one expression they
# fit a core's own cache, and the temporaries fit pages that the process already has.
BLOCK = 16384
# Length from which a loop along the last axis costs more than starting it.
LONG_LOOP = 64
# Arrays whose views behave like arrays: a matrix never becomes flat, and a mask would persist.
WRITTEN = frozenset({np.ndarray, np.memmap})
# A function of arrays that returns an array or a tuple of them.
Function = Any


def store(value: Any, out: NDArray[Any] | None) -> Any:
    """Return `value`, stored in `out` if given; TypeError or ValueError if it does not fit."""
    if out is None or out is value:
        return value
    check_out(out, np.shape(value), value.dtype)
    if isinstance(value, np.ma.MaskedArray) and not isinstance(out, np.ma.MaskedArray):
        raise TypeError("out: expected a masked array, as the result has a mask, got an array")
    out[...] = value
    return out


def check_out(out: Any, shape: tuple[int, ...], dtype: np.dtype[Any]) -> None:
    """Raise TypeError or ValueError, naming `out`, unless it is an array of the type and shape."""
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out: expected an array, got {type(out).__name__}")
    if type(out) not in WRITTEN:
        refuse_units("out", out)
    if out.dtype != dtype:
        raise TypeError(f"out: expected {dtype}, the type of the result, got {out.dtype}")
    if out.shape != shape:
        raise ValueError(f"out: expected shape {shape}, that of the result, got {out.shape}")
    if not out.flags.writeable:
        raise ValueError("out: expected an array that can be written, got one that is read-only")


def _find_target(
    out: Any, shape: tuple[int, ...], dtype: np.dtype[Any], arrays: tuple[Any, ...]
) -> NDArray[Any] | None:
    """Return `out` if results may be written to it while arguments are still read, else None."""
    if out is None:
        return None
    check_out(out, shape, dtype)
    if type(out) not in WRITTEN:
        return None
    shared = (type(a) is np.ndarray and np.may_share_memory(out, a) for a in arrays)
    return None if any(shared) else out


def _components(target: NDArray[Any], shape: tuple[int, ...]) -> list[NDArray[Any]]:
    """Return views of the components on the last axes."""
    return [target[index] for index in _list_indices(shape)]


@cache
def _list_indices(shape: tuple[int, ...]) -> tuple[tuple[Any, ...], ...]:
    return tuple((..., *index) for index in np.ndindex(shape))


def _stack(components: tuple[Any, ...], shape: tuple[int, ...]) -> Any:
    """Stack components on last axes of the given shape, keeping masked or lazy arrays so."""
    common = np.broadcast_shapes(*map(np.shape, components))
    kind = next((c for c in components if type(c) not in PLAIN), None)
    if isinstance(kind, np.ndarray):
        stacked = np.empty_like(kind, shape=(*common, len(components)))
        for i, component in enumerate(components):
            stacked[..., i] = component
    else:
        zeros = np.zeros(common)
        stacked = np.stack([component + zeros for component in components], axis=-1)
    return stacked.reshape(*common, *shape)


def quietly() -> np.errstate:
    """Return a context for points that may leave the domain, which gives NaN without a warning."""
    return np.errstate(invalid="ignore", divide="ignore")


def in_blocks(
    evaluate: Function,
    running: tuple[Any, ...],
    prepare: Function = lambda *parameters: parameters,
    parameters: tuple[Any, ...] = (),
    *,
    out: NDArray[Any] | None = None,
    shape: tuple[int, ...] = (),
    quiet: bool = False,
) -> Any:
    """Return evaluate(*running, *prepare(*parameters)), broadcast, a block of points at a time.

    With a `shape`, `evaluate` returns the components on last axes of that shape. float32 is
    computed in float64. Arrays with their own ufuncs are evaluated in one piece. `quiet`: the
    points may leave the domain, where NaN is the documented result and no warning is due.

    Raises
    ------
    TypeError, ValueError
        If `out` is not an array of the result's type and shape, or shapes do not broadcast.

    """
    if quiet:
        return _in_quiet_blocks(evaluate, running, prepare, parameters, out=out, shape=shape)
    try:
        if not shape:
            few = _find_few((*running, *parameters))
            if few is not None:
                return _evaluate_few(evaluate, running, prepare, parameters, few, out)
        return _evaluate(evaluate, running, prepare, parameters, out, shape)
    except ArithmeticError:
        # Python raises where NumPy returns infinity or NaN; single precision is left to NumPy.
        numbers = tuple(map(as_numpy, running)), tuple(map(as_numpy, parameters))
        return _evaluate(evaluate, numbers[0], prepare, numbers[1], out, shape)


# As a decorator, the context costs half as much as in a `with` statement.
_in_quiet_blocks = quietly()(in_blocks)


def _find_few(arrays: tuple[Any, ...]) -> tuple[int, ...] | None:
    """Return the shape of few points if all are doubles, as numbers or arrays of it; else None."""
    shape: tuple[int, ...] = ()
    for array in arrays:
        if type(array) is not float:
            if type(array) is not np.ndarray or array.dtype is not DOUBLE:
                return None
            if array.shape != shape and (shape or 2 * array.size > BLOCK):
                return None
            shape = array.shape
    return shape


def _evaluate_few(
    evaluate: Function,
    running: tuple[Any, ...],
    prepare: Function,
    parameters: tuple[Any, ...],
    shape: tuple[int, ...],
    out: NDArray[Any] | None,
) -> Any:
    """Evaluate few points; a single one in numbers, as arrays take five times as long."""
    if not shape:
        return store(np.float64(evaluate(*running, *prepare(*parameters))), out)
    numbers = as_numbers((*running, *parameters))
    if numbers is None:
        return store(evaluate(*running, *prepare(*parameters)), out)
    if out is None:
        found = np.empty(shape)
    else:
        check_out(out, shape, DOUBLE)
        found = out
    count = len(running)
    found[...] = evaluate(*numbers[:count], *prepare(*numbers[count:]))
    return found


def _evaluate(
    evaluate: Function,
    running: tuple[Any, ...],
    prepare: Function,
    parameters: tuple[Any, ...],
    out: NDArray[Any] | None,
    shape: tuple[int, ...],
) -> Any:
    arrays = (*running, *parameters)
    if not PLAIN.issuperset(map(type, arrays)):
        values = evaluate(*running, *prepare(*parameters))
        return store(_stack(values, shape) if shape else as_numpy(values), out)
    large = [array for array in arrays if type(array) is np.ndarray]
    together = large[0] if len(large) == 1 else np.broadcast(*large)
    dtype = large[0].dtype if large else as_numpy(arrays[0]).dtype
    if large and type(running[0]) is float:
        # Combined with single precision, a Python number would not count as a double.
        running, parameters = tuple(map(as_numpy, running)), tuple(map(as_numpy, parameters))
    is_small = 2 * together.size <= BLOCK
    if is_small:
        if dtype == SINGLE:
            running = tuple(cast(array, DOUBLE) for array in running)
            parameters = tuple(cast(array, DOUBLE) for array in parameters)
        values = evaluate(*running, *prepare(*parameters))
        if not shape:
            return store(cast(as_numpy(values), dtype), out)
    whole = (*together.shape, *shape)
    target = _find_target(out, whole, dtype, arrays)
    target = np.empty(whole, dtype) if target is None else target
    if is_small:
        for part, value in zip(_components(target, shape), values, strict=True):
            part[...] = value
    else:
        _fill(target, evaluate, running, prepare, tuple(map(as_numpy, parameters)), shape)
    return store(target, out)


def _fill(
    target: NDArray[Any],
    evaluate: Function,
    running: tuple[Any, ...],
    prepare: Function,
    parameters: tuple[Any, ...],
    shape: tuple[int, ...],
) -> None:
    """Fill `target` block by block."""
    count = len(running)
    parts = _components(target, shape)
    if all(np.size(p) < parts[0].size for p in parameters):
        # With fewer parameters than points, results of parameters alone are computed only once.
        arrays = (*running, *prepare(*(cast(p, DOUBLE) for p in parameters)))
        compute = evaluate
    else:
        arrays = (*running, *parameters)

        def compute(*values: Any) -> Any:
            return evaluate(*values[:count], *prepare(*values[count:]))

    values = [cast(np.reshape(a, ())[()], DOUBLE) if np.size(a) == 1 else None for a in arrays]
    large = [i for i, value in enumerate(values) if value is None]
    if _is_outer(parts[0], [arrays[i] for i in large]):
        for index in _cut(parts[0].shape, BLOCK // 2):
            for i in large:
                values[i] = cast(_slice(arrays[i], index), DOUBLE)
            results = compute(*values)
            for part, result in zip(parts, results if shape else (results,), strict=True):
                part[index] = result
        return
    operands = [*(arrays[i] for i in large), *parts]
    roles: Any = [["readonly"]] * len(large) + [["writeonly", "no_broadcast"]] * len(parts)
    blocks = np.nditer(
        operands,
        flags=["external_loop", "buffered"],
        op_flags=roles,
        op_dtypes=[DOUBLE] * len(operands),
        casting="same_kind",
        buffersize=BLOCK // len(operands),
    )
    with blocks:
        for block in blocks:
            for i, array in zip(large, block, strict=False):
                values[i] = array
            results = compute(*values)
            for part, result in zip(
                block[len(large) :], results if shape else (results,), strict=True
            ):
                part[...] = result


def _is_outer(target: NDArray[Any], arrays: list[Any]) -> bool:
    """Return whether to cut slices: arrays of different shapes would be repeated in buffers.

    Not for a short last axis, which would make the loops over slices short.
    """
    together = any(array.size < target.size for array in arrays)
    return together and target.shape[-1] >= LONG_LOOP


def _cut(shape: tuple[int, ...], size: int) -> list[tuple[slice, ...]]:
    """Return indices that cut the first axes into parts of at most `size` numbers."""
    first, *rest = shape
    row = int(np.prod(rest))
    if row > size:
        inner = _cut(tuple(rest), size)
        return [(slice(i, i + 1), *index) for i in range(first) for index in inner]
    step = size // row
    whole = [slice(None)] * len(rest)
    return [(slice(start, start + step), *whole) for start in range(0, first, step)]


def _slice(array: NDArray[Any], index: tuple[slice, ...]) -> NDArray[Any]:
    """Return the part of an array that belongs to an index of the shape it broadcasts to."""
    whole = (1,) * (len(index) - array.ndim) + array.shape
    parts = (part if n > 1 else slice(None) for n, part in zip(whole, index, strict=True))
    return array.reshape(whole)[tuple(parts)]


def transform(
    points: Any,
    coefficients: Function,
    parameters: tuple[Any, ...],
    *,
    out: NDArray[Any] | None = None,
    quiet: bool = False,
) -> Any:
    """Return M @ p + v for each p of `points`; `coefficients` returns M row by row, then v.

    Raises as `in_blocks`.
    """
    count = points.shape[-1]
    one_map = SCALARS.issuperset(map(type, parameters))
    if type(points) is not np.ndarray or not one_map:

        def evaluate(*values: Any) -> tuple[Any, ...]:
            point, rows = values[:count], values[count:]
            linear = [rows[i * count : (i + 1) * count] for i in range(count)]
            return tuple(
                sum((m * p for m, p in zip(row, point, strict=True)), start=rows[i - count])
                for i, row in enumerate(linear)
            )

        components = tuple(points[..., i][()] for i in range(count))
        return in_blocks(evaluate, components, coefficients, parameters, out=out, shape=(count,))
    target = _find_target(out, points.shape, points.dtype, (points,))
    if target is None or not target.flags.c_contiguous:
        target = np.empty(points.shape, points.dtype)
    values = np.array(coefficients(*[cast(as_numpy(p), DOUBLE) for p in parameters]))
    matrix, shift = values[:-count].reshape(count, count).T, values[-count:]
    source, rows = points.reshape(-1, count), target.reshape(-1, count)
    size = max(min(len(rows), BLOCK // (2 * count)), 1)
    # NumPy is slow to broadcast rows of three, so the shift is repeated along a block instead.
    shifts = np.empty((size, count))
    for i in range(count):
        shifts[:, i] = shift[i]
    for start in range(0, len(rows), size):
        block = source[start : start + size].astype(DOUBLE, copy=False)
        found = rows[start : start + size]
        moved = np.matmul(block, matrix, out=found if found.dtype == DOUBLE else None)
        moved += shifts[: len(moved)]
        if moved is not found:
            found[...] = moved
    return store(target, out)
