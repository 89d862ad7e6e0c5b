"""Arguments, evaluation in blocks and results of all kernels."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import inf, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Numbers per block, arguments and results together: with the temporaries of one expression they
# stay in a core's own cache, and the temporaries in pages that the process already has.
BLOCK = 16384
# Loops along the last axis that cost more than their start.
LONG_LOOP = 64
SCALARS = frozenset({float, np.float64, np.float32})
NUMBERS = frozenset({float, np.float64})
# Types whose finiteness is told by a comparison.
COMPARED = SCALARS | {Fraction}
# Types that Python's arithmetic and NumPy's agree on; all others keep their own.
PLAIN = SCALARS | {np.ndarray}
BOOLS = frozenset({bool, np.bool})
WEAK = (bool, int, float)
# Subclasses without arithmetic of their own, or with one that is not element by element.
AS_ARRAYS = (np.memmap, np.matrix)
# A function of arrays that returns an array or a tuple of them.
Function = Any
DOUBLE, SINGLE = np.dtype(np.float64), np.dtype(np.float32)


def as_floats(names: str, *values: Any) -> tuple[Any, ...]:
    """Convert the arguments `names` to one float type: arrays, numbers where there are no axes.

    Python numbers are weak; float32 if every array is float32, float64 otherwise. Numbers of the
    type float64 become Python's, whose arithmetic rounds alike in a third of the time. Subclasses
    of arrays and other arrays that bring their own ufuncs (masked, lazy, with units) stay what
    they are, matrices apart.

    Raises
    ------
    TypeError
        If an argument is complex, longer than float64 or not numeric; the message names it.

    """
    for value in values:
        kind = type(value)
        if kind is not float and not (kind is np.ndarray and value.dtype is DOUBLE and value.shape):
            return _convert(names.split(), values)
    # What most calls give is told by its type alone: nothing below could change it.
    return values


def as_numpy(value: Any) -> Any:
    """Return a Python number as NumPy's, and all else as it is."""
    return np.float64(value) if type(value) is float else value


def _convert(names: list[str], values: tuple[Any, ...]) -> tuple[Any, ...]:
    if all(map(_is_double, values)):
        return tuple([v if type(v) is np.ndarray else float(v) for v in values])
    arrays = [_as_array(value) for value in values]
    for name, array in zip(names, arrays, strict=True):
        if not hasattr(array, "dtype"):
            raise TypeError(f"{name}: expected numbers with a dtype, got {type(array).__name__}")
    dtypes = [array.dtype for array in arrays]
    if dtypes.count(DOUBLE) == len(dtypes):
        return _weaken(arrays)
    for name, dtype in zip(names, dtypes, strict=True):
        if dtype.kind not in "biuf" or dtype.itemsize > 8:
            raise TypeError(f"{name}: expected real numbers up to float64, got {dtype}")
    given = zip(values, dtypes, strict=True)
    strong = {dtype for value, dtype in given if type(value) not in WEAK}
    if strong == {SINGLE}:
        return tuple(_cast(array, SINGLE) for array in arrays)
    return _weaken([_cast(array, DOUBLE) for array in arrays])


def _weaken(arrays: list[Any]) -> tuple[Any, ...]:
    """Turn doubles into Python's beside plain arrays; foreign ones may tell them apart."""
    if not PLAIN.issuperset(map(type, arrays)):
        return tuple(arrays)
    return tuple(float(a) if type(a) is np.float64 else a for a in arrays)


def _is_double(value: Any) -> bool:
    kind = type(value)
    if kind is np.ndarray:
        return value.dtype is DOUBLE and bool(value.shape)
    # Larger whole numbers are none of NumPy's.
    return kind in NUMBERS or (kind is int and -(2**63) <= value < 2**63)


def _as_array(value: Any) -> Any:
    """Return an array, a NumPy scalar if it has no axes, or what brings ufuncs of its own."""
    if type(value) is float:
        return np.float64(value)
    if type(value) in PLAIN:
        return value if value.shape else value[()]
    if not hasattr(value, "__array_ufunc__") or isinstance(value, AS_ARRAYS):
        return np.asarray(value)
    # A foreign scalar, a number with a unit, gets a dtype and stays what it is.
    return value if hasattr(value, "dtype") else np.multiply(value, np.float64(1.0))


def _cast(array: Any, dtype: np.dtype[Any]) -> Any:
    cast = array if array.dtype == dtype else array.astype(dtype)
    return cast[()] if type(cast) is np.ndarray else cast


def check_components(name: str, array: Any, count: int) -> None:
    """Check the length of the last axis, and that components can be taken from it.

    Raises
    ------
    TypeError
        If the array cannot be indexed by axes, as a series of pandas; the message names the
        argument.
    ValueError
        If the last axis has not `count` components; the message names the argument.

    """
    if type(array) is float or array.shape[-1:] != (count,):
        shape = np.shape(array)
        raise ValueError(f"{name}: last axis must have length {count}, got shape {shape}")
    if type(array) is not np.ndarray:
        try:
            array[..., :0]
        except (LookupError, TypeError, ValueError):
            kind = type(array).__name__
            raise TypeError(
                f"{name}: expected an array with components on its last axis, got {kind}; "
                "convert it by np.asarray"
            ) from None


def split_components(name: str, array: Any, count: int) -> tuple[Any, ...]:
    """Return the components on the last axis; raises as `check_components`."""
    check_components(name, array, count)
    if array.ndim == 1 and type(array) is np.ndarray:
        return tuple(array.tolist() if array.dtype is DOUBLE else array)
    return tuple([array[..., i][()] for i in range(count)])


def sum_axes(**arguments: tuple[Any, int]) -> tuple[NDArray[Any], ...]:
    """Check that the axes to be summed over have one length; a scalar stands for equal elements.

    Raises
    ------
    ValueError
        If an axis has another length or is missing; the message names the argument.

    """
    arguments = {name: (as_numpy(array), axes) for name, (array, axes) in arguments.items()}
    lengths = [n for array, axes in arguments.values() for n in array.shape[-axes:]]
    length = next((n for n in lengths if n != 1), 1)
    for name, (array, axes) in arguments.items():
        expected = (length,) * axes
        fits = array.shape[-axes:] == expected
        if not fits and not (axes == 1 and array.shape[-1:] in ((), (1,))):
            what = "last axis" if axes == 1 else f"last {axes} axes"
            raise ValueError(f"{name}: {what} must have shape {expected}, got shape {array.shape}")
    return tuple(array if array.shape else np.atleast_1d(array) for array, _ in arguments.values())


def is_finite(value: Any) -> Any:
    """Return np.isfinite(value), which costs for a scalar as a short loop, or of a fraction."""
    return abs(value) < inf if type(value) in COMPARED else np.isfinite(value)


def nan_outside(inside: Any, *values: Any) -> tuple[NDArray[Any], ...]:
    """Return the values where `inside` is true, NaN elsewhere."""
    if type(inside) in BOOLS:
        return values if inside else tuple([value * nan for value in values])
    if type(inside) is np.ndarray and PLAIN.issuperset(map(type, values)):
        # Unmasked they keep their own shapes, and so does what is computed of them.
        return values if holds(inside) else tuple([np.where(inside, v, nan) for v in values])
    # A product keeps the mask, the laziness or the unit, which np.where would drop.
    factor = np.where(inside, 1.0, np.nan)
    return tuple([value * factor for value in values])


def every(condition: Any, axis: Any) -> Any:
    """Return np.all(condition, axis), over all axes of an array without a reduction."""
    count = 1 if axis == -1 else len(axis)
    if type(condition) is np.ndarray and condition.ndim == count:
        return holds(condition)
    return np.all(condition, axis=axis)


def floor(a: Any) -> Any:
    """Return np.floor(a), of Python's numbers one of them."""
    return float(np.floor(a)) if type(a) is float else np.floor(a)


def maximum(a: Any, b: Any) -> Any:
    """Return np.maximum(a, b), of two numbers without a call of it."""
    if type(a) in NUMBERS and type(b) in NUMBERS:
        if a > b:
            return a
        if a < b:
            return b
    return np.maximum(a, b)


def choose_where(condition: Any, value: Any, otherwise: Any) -> Any:
    """Return np.where(condition, value, otherwise), masked if one of them is."""
    if type(condition) in BOOLS and SCALARS.issuperset((type(value), type(otherwise))):
        return value if condition else otherwise
    masked = any(isinstance(a, np.ma.MaskedArray) for a in (condition, value, otherwise))
    return (np.ma.where if masked else np.where)(condition, value, otherwise)


def holds(condition: Any) -> bool:
    """Say whether a condition is true of every element; those of a lazy array stay unread."""
    if type(condition) is np.ndarray:
        # Of a short array this costs a fifth of condition.all().
        return bool(np.count_nonzero(condition) == condition.size)
    return type(condition) in BOOLS and bool(condition)


def store(value: Any, out: NDArray[Any] | None) -> Any:
    """Return `value`, in `out` if there is one; TypeError, ValueError if it does not fit."""
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
    if out.dtype != dtype:
        raise TypeError(f"out: expected {dtype}, the type of the result, got {out.dtype}")
    if out.shape != shape:
        raise ValueError(f"out: expected shape {shape}, that of the result, got {out.shape}")
    if not out.flags.writeable:
        raise ValueError("out: expected an array that can be written, got one that is read-only")


def _find_target(
    out: Any, shape: tuple[int, ...], dtype: np.dtype[Any], arrays: tuple[Any, ...]
) -> NDArray[Any] | None:
    """Return `out` if results may be written while arguments are still read, None otherwise."""
    if out is None:
        return None
    check_out(out, shape, dtype)
    shared = (type(a) is np.ndarray and np.may_share_memory(out, a) for a in arrays)
    return None if any(shared) else out


def _components(target: NDArray[Any], shape: tuple[int, ...]) -> list[NDArray[Any]]:
    """Return views of the components on the last axes."""
    return [target[index] for index in _list_indices(shape)]


@cache
def _list_indices(shape: tuple[int, ...]) -> tuple[tuple[Any, ...], ...]:
    return tuple((..., *index) for index in np.ndindex(shape))


def _stack(components: tuple[Any, ...], shape: tuple[int, ...]) -> Any:
    """Put components on last axes of the given shape; what is masked or lazy stays so."""
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
    """Return the context of points that may leave the domain: NaN is the answer, not a warning."""
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

    With a `shape`, `evaluate` returns the components of that shape's last axes. float32 is
    computed in float64. Arrays with ufuncs of their own are evaluated in one piece. `quiet`: the
    points may leave the domain, where NaN is the documented answer and no warning is due.

    Raises
    ------
    TypeError, ValueError
        If `out` is no array of the result's type and shape, or shapes do not broadcast.

    """
    if quiet:
        with quietly():
            return in_blocks(evaluate, running, prepare, parameters, out=out, shape=shape)
    try:
        if out is None and not shape and _are_few((*running, *parameters)):
            value = evaluate(*running, *prepare(*parameters))
            return value if type(value) is np.ndarray and value.shape else np.float64(value)
        return _evaluate(evaluate, running, prepare, parameters, out, shape)
    except ArithmeticError:
        # Python refuses what NumPy answers with infinity or NaN; and single precision is NumPy's.
        numbers = tuple(map(as_numpy, running)), tuple(map(as_numpy, parameters))
        return _evaluate(evaluate, numbers[0], prepare, numbers[1], out, shape)


def _are_few(arrays: tuple[Any, ...]) -> bool:
    """Say whether there are doubles alone: numbers, beside a first array others of its shape."""
    shape: tuple[int, ...] = ()
    for array in arrays:
        if type(array) is not float:
            if type(array) is not np.ndarray or array.dtype is not DOUBLE:
                return False
            if array.shape != shape and (shape or 2 * array.size > BLOCK):
                return False
            shape = array.shape
    return not shape or type(arrays[0]) is not float


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
        # Beside single precision a number of Python's would not count as a double.
        running, parameters = tuple(map(as_numpy, running)), tuple(map(as_numpy, parameters))
    is_small = 2 * together.size <= BLOCK
    if is_small:
        if dtype == SINGLE:
            running = tuple(_cast(array, DOUBLE) for array in running)
            parameters = tuple(_cast(array, DOUBLE) for array in parameters)
        values = evaluate(*running, *prepare(*parameters))
        if not shape:
            return store(_cast(as_numpy(values), dtype), out)
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
        # Fewer parameters than points: what depends on them alone is computed once.
        arrays = (*running, *prepare(*(_cast(p, DOUBLE) for p in parameters)))
        compute = evaluate
    else:
        arrays = (*running, *parameters)

        def compute(*values: Any) -> Any:
            return evaluate(*values[:count], *prepare(*values[count:]))

    values = [_cast(np.reshape(a, ())[()], DOUBLE) if np.size(a) == 1 else None for a in arrays]
    large = [i for i, value in enumerate(values) if value is None]
    if _is_outer(parts[0], [arrays[i] for i in large]):
        for index in _cut(parts[0].shape, BLOCK // 2):
            for i in large:
                values[i] = _cast(_slice(arrays[i], index), DOUBLE)
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
    """Say whether arrays of different shapes meet: buffers would repeat what slices keep short.

    A short last axis would make short loops of slices.
    """
    together = any(array.size < target.size for array in arrays)
    return together and target.shape[-1] >= LONG_LOOP


def _cut(shape: tuple[int, ...], size: int) -> list[tuple[slice, ...]]:
    """Cut the first axes so that no part has more than `size` numbers."""
    first, *rest = shape
    row = int(np.prod(rest))
    if row > size:
        inner = _cut(tuple(rest), size)
        return [(slice(i, i + 1), *index) for i in range(first) for index in inner]
    step = size // row
    whole = [slice(None)] * len(rest)
    return [(slice(start, start + step), *whole) for start in range(0, first, step)]


def _slice(array: NDArray[Any], index: tuple[slice, ...]) -> NDArray[Any]:
    """Return a part of an array that broadcasts to the shape that `index` cuts."""
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
    """Return M @ p + v for each p of `points`, `coefficients` giving M row by row, then v.

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
    values = np.array(coefficients(*[_cast(as_numpy(p), DOUBLE) for p in parameters]))
    matrix, shift = values[:-count].reshape(count, count).T, values[-count:]
    source, rows = points.reshape(-1, count), target.reshape(-1, count)
    size = max(min(len(rows), BLOCK // (2 * count)), 1)
    # NumPy broadcasts rows of three slowly; the shift is repeated along a block instead.
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
