"""Arguments of kernels as numbers and arrays of one float type."""

from __future__ import annotations

import reprlib
from math import nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.scalars import refuse_units

SCALARS = frozenset({float, np.float64, np.float32})
# Types whose values are doubles, or become doubles as in NumPy.
EXACT = frozenset({float, np.float64, np.int64})
# Types on which Python's arithmetic and NumPy's agree; all other types keep their own.
PLAIN = SCALARS | {np.ndarray}
BOOLS = frozenset({bool, np.bool})
WEAK = (bool, int, float)
# Subclasses of arrays without their own arithmetic, or with one that is not element by element.
AS_ARRAYS = (np.memmap, np.matrix)
DOUBLE, SINGLE, WHOLE = np.dtype(np.float64), np.dtype(np.float32), np.dtype(np.int64)


def as_floats(names: str, *values: Any, axes: tuple[int, ...] = ()) -> tuple[NDArray[Any], ...]:
    """Convert the arguments `names` to one float type: arrays, or numbers if there are no axes.

    Python numbers are weak; float32 if every array is float32, float64 otherwise. float64 scalars
    become Python numbers, whose arithmetic rounds alike in a third of the time. Subclasses of
    arrays (other than matrices) and other arrays that bring their own ufuncs (masked, lazy) stay
    what they are; with several arguments, a masked scalar becomes NaN. `axes` are the numbers of
    last axes that do not broadcast, one for each argument, by default 0.

    Raises
    ------
    TypeError
        If an argument is complex, longer than float64 or not numeric, or carries a unit; the
        message names it.
    ValueError
        If rows have different lengths, or arrays do not broadcast; the message names the argument.

    """
    shape: tuple[int, ...] = ()
    unlike = len(axes) > 1
    for value in values:
        if type(value) is not float:
            if not (type(value) is np.ndarray and value.dtype is DOUBLE and value.shape):
                doubles = _as_doubles(values)
                if doubles is not None:
                    return as_floats(names, *doubles, axes=axes)
                converted = _convert(names.split(), values)
                _check_shapes(names, converted, axes)
                return converted
            unlike = unlike or value.shape != (shape := shape or value.shape)
    if unlike:
        _check_shapes(names, values, axes)
    # The most usual arguments are recognised by type alone: nothing below could change them.
    return values


def _as_doubles(values: tuple[Any, ...]) -> tuple[Any, ...] | None:
    """Return doubles as arrays and Python numbers; None if there is anything else.

    Recognition by types alone takes a fifth of the time of a conversion.
    """
    found = []
    for value in values:
        kind = type(value)
        if kind is np.ndarray and (value.dtype is DOUBLE or value.dtype is WHOLE):
            found.append(value.astype(DOUBLE, copy=False) if value.shape else float(value.item()))
        # Larger whole numbers are left for NumPy to judge.
        elif kind in EXACT or (kind is int and -(2**63) <= value < 2**63):
            found.append(float(value))
        else:
            return None
    return tuple(found)


def _check_shapes(names: str, arrays: tuple[Any, ...], axes: tuple[int, ...]) -> None:
    """Raise ValueError, naming it, for an array whose shape before `axes` does not broadcast."""
    common: tuple[int, ...] = ()
    for i, array in enumerate(arrays):
        count = axes[i] if axes else 0
        if isinstance(array, np.ndarray) and array.ndim > count:
            shape = array.shape[: array.ndim - count]
            try:
                common = np.broadcast_shapes(common, shape) if common not in ((), shape) else shape
            except ValueError:
                what = f"axes before the {_name_last(count)} must" if count else "must"
                raise ValueError(
                    f"{names.split()[i]}: {what} broadcast with {common}, the shape of the "
                    f"arguments before it, got shape {array.shape}"
                ) from None


def _name_last(count: int) -> str:
    return "last axis" if count == 1 else f"last {count} axes"


def as_numpy(value: Any) -> Any:
    """Return a Python float as a NumPy scalar; anything else unchanged."""
    return np.float64(value) if type(value) is float else value


def as_numbers(values: tuple[Any, ...]) -> tuple[float, ...] | None:
    """Return Python numbers for doubles and for arrays of one; None if there is anything else.

    Computing with numbers takes a fifth of the time of arrays with one element.
    """
    for value in values:
        if type(value) is not float:
            break
    else:
        return values
    for value in values:
        kind = type(value)
        if kind is not float and not (
            kind is np.ndarray and value.size == 1 and value.dtype is DOUBLE
        ):
            return None
    return tuple([value if type(value) is float else value.item() for value in values])


def _convert(names: list[str], values: tuple[Any, ...]) -> tuple[Any, ...]:
    arrays = [_as_array(name, value) for name, value in zip(names, values, strict=True)]
    if len(arrays) > 1:
        arrays = [_unmask(array) for array in arrays]
    for name, array in zip(names, arrays, strict=True):
        if not hasattr(array, "dtype"):
            raise TypeError(f"{name}: expected numbers with a dtype, got {type(array).__name__}")
    dtypes = [array.dtype for array in arrays]
    if dtypes.count(DOUBLE) == len(dtypes):
        return _weaken(arrays)
    for name, value, dtype in zip(names, values, dtypes, strict=True):
        if dtype.kind not in "biuf" or dtype.itemsize > 8:
            got = f"{_show(value)} of dtype {dtype}"
            raise TypeError(f"{name}: expected real numbers up to float64, got {got}")
    given = zip(values, dtypes, strict=True)
    strong = {dtype for value, dtype in given if type(value) not in WEAK}
    if strong == {SINGLE}:
        return tuple(cast(array, SINGLE) for array in arrays)
    return _weaken([cast(array, DOUBLE) for array in arrays])


def _show(value: Any) -> str:
    """Return an abridged text of a value; a zero-dimensional array is shown as its number."""
    is_single = type(value) is np.ndarray and not value.shape
    return " ".join(reprlib.repr(value.item() if is_single else value).split())


def _weaken(arrays: list[Any]) -> tuple[Any, ...]:
    """Turn float64 scalars into Python floats among plain arrays; foreign ones may differ."""
    if not PLAIN.issuperset(map(type, arrays)):
        return tuple(arrays)
    return tuple(float(a) if type(a) is np.float64 else a for a in arrays)


def _as_array(name: str, value: Any) -> Any:
    """Return an array, a NumPy scalar if it has no axes, or an object with its own ufuncs."""
    if type(value) is float:
        return np.float64(value)
    if type(value) in PLAIN:
        # Taken out of its array, an object would lose the dtype.
        return value if value.shape or value.dtype.hasobject else value[()]
    refuse_units(name, value)
    if not hasattr(value, "__array_ufunc__") or isinstance(value, AS_ARRAYS):
        try:
            return np.asarray(value)
        except ValueError:
            raise ValueError(
                f"{name}: expected a number or rows of one length, got {_show(value)}"
            ) from None
    # A foreign scalar gets a dtype but keeps its kind.
    return value if hasattr(value, "dtype") else np.multiply(value, np.float64(1.0))


def _unmask(value: Any) -> Any:
    """Return a masked scalar as NaN, as comparing it would give neither true nor false."""
    if isinstance(value, np.ma.MaskedArray) and not value.shape:
        return np.float64(nan) if value.mask else value.data[()]
    return value


def cast(array: Any, dtype: np.dtype[Any]) -> Any:
    """Return an array of a dtype, or a NumPy scalar if there are no axes."""
    found = array if array.dtype == dtype else array.astype(dtype)
    return found[()] if type(found) is np.ndarray else found


def check_components(name: str, array: Any, count: int) -> None:
    """Check the length of the last axis, and that components can be taken from it.

    Raises
    ------
    TypeError
        If the array cannot be indexed by axes, like a pandas series; the message names the
        argument.
    ValueError
        If the last axis does not have `count` components; the message names the argument.

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


def split_components(name: str, array: Any, count: int) -> tuple[NDArray[Any], ...]:
    """Return the components on the last axis; raises as `check_components`."""
    check_components(name, array, count)
    if type(array) is np.ndarray and array.ndim < 3:
        return tuple(array.tolist() if array.ndim == 1 and array.dtype is DOUBLE else array.T)
    return tuple([array[..., i][()] for i in range(count)])


def sum_axes(**arguments: tuple[Any, int]) -> tuple[NDArray[Any], ...]:
    """Check that all axes to sum over have the same length; a scalar stands for equal elements.

    Raises
    ------
    ValueError
        If an axis has another length or is missing; the message names the argument.

    """
    given = tuple(arguments.values())
    first = given[0][0]
    common = first.shape[-1:] if type(first) is np.ndarray else ()
    for array, axes in given:
        if type(array) is not np.ndarray or array.shape[-axes:] != common * axes:
            return _spread_axes(arguments)
    return tuple([array for array, _ in given])


def _spread_axes(arguments: dict[str, tuple[Any, int]]) -> tuple[NDArray[Any], ...]:
    """Return scalars as arrays; ValueError for an axis that differs in length from the others."""
    arguments = {name: (as_numpy(array), axes) for name, (array, axes) in arguments.items()}
    lengths = [n for array, axes in arguments.values() for n in array.shape[-axes:]]
    length = next((n for n in lengths if n != 1), 1)
    for name, (array, axes) in arguments.items():
        expected = (length,) * axes
        fits = array.shape[-axes:] == expected
        if not fits and not (axes == 1 and array.shape[-1:] in ((), (1,))):
            what = f"{_name_last(axes)} must have shape {expected}"
            raise ValueError(f"{name}: {what}, got shape {array.shape}")
    return tuple(
        _spread_mask(array, axes) if array.shape else np.atleast_1d(array)
        for array, axes in arguments.values()
    )


def _spread_mask(array: NDArray[Any], axes: int) -> NDArray[Any]:
    """Mask all terms of a sum if one is masked: NumPy would skip that one, as if it were 0."""
    if not isinstance(array, np.ma.MaskedArray):
        return array
    mask = np.ma.getmaskarray(array).any(axis=tuple(range(-axes, 0)), keepdims=True)
    return np.ma.masked_array(array, np.broadcast_to(mask, array.shape))
