"""Arguments of kernels as numbers and arrays of one float type, and conditions on them."""

from __future__ import annotations

import reprlib
from collections.abc import Callable
from fractions import Fraction
from math import inf, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

SCALARS = frozenset({float, np.float64, np.float32})
NUMBERS = frozenset({float, np.float64})
# Numbers that are doubles or become one as NumPy's do.
EXACT = frozenset({float, np.float64, np.int64})
# Types whose finiteness is told by a comparison.
COMPARED = SCALARS | {Fraction}
# Types that Python's arithmetic and NumPy's agree on; all others keep their own.
PLAIN = SCALARS | {np.ndarray}
BOOLS = frozenset({bool, np.bool})
WEAK = (bool, int, float)
# Subclasses without arithmetic of their own, or with one that is not element by element.
AS_ARRAYS = (np.memmap, np.matrix)
DOUBLE, SINGLE, WHOLE = np.dtype(np.float64), np.dtype(np.float32), np.dtype(np.int64)


def as_floats(names: str, *values: Any, axes: tuple[int, ...] = ()) -> tuple[NDArray[Any], ...]:
    """Convert the arguments `names` to one float type: arrays, numbers where there are no axes.

    Python numbers are weak; float32 if every array is float32, float64 otherwise. Numbers of the
    type float64 become Python's, whose arithmetic rounds alike in a third of the time. Subclasses
    of arrays and other arrays that bring their own ufuncs (masked, lazy, with units) stay what
    they are, matrices apart; of several arguments a masked number is NaN. `axes` are how many last
    axes of each do not broadcast, none if left out.

    Raises
    ------
    TypeError
        If an argument is complex, longer than float64 or not numeric; the message names it.
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
    # What most calls give is told by its type alone: nothing below could change it.
    return values


def _as_doubles(values: tuple[Any, ...]) -> tuple[Any, ...] | None:
    """Return doubles as arrays and Python's numbers, None if there is anything else.

    What is told here by types alone takes a fifth of the time that any conversion takes.
    """
    found = []
    for value in values:
        kind = type(value)
        if kind is np.ndarray and (value.dtype is DOUBLE or value.dtype is WHOLE):
            found.append(value.astype(DOUBLE, copy=False) if value.shape else float(value.item()))
        # Larger whole numbers are for NumPy to judge.
        elif kind in EXACT or (kind is int and -(2**63) <= value < 2**63):
            found.append(float(value))
        else:
            return None
    return tuple(found)


def _check_shapes(names: str, arrays: tuple[Any, ...], axes: tuple[int, ...]) -> None:
    """Raise ValueError that names an array whose shape, last axes apart, does not broadcast."""
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
    """Return a Python number as NumPy's, and all else as it is."""
    return np.float64(value) if type(value) is float else value


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
    """Write a value in a few words, a single one without the array around it."""
    is_single = type(value) is np.ndarray and not value.shape
    return " ".join(reprlib.repr(value.item() if is_single else value).split())


def _weaken(arrays: list[Any]) -> tuple[Any, ...]:
    """Turn doubles into Python's beside plain arrays; foreign ones may tell them apart."""
    if not PLAIN.issuperset(map(type, arrays)):
        return tuple(arrays)
    return tuple(float(a) if type(a) is np.float64 else a for a in arrays)


def _as_array(name: str, value: Any) -> Any:
    """Return an array, a NumPy scalar if it has no axes, or what brings ufuncs of its own."""
    if type(value) is float:
        return np.float64(value)
    if type(value) in PLAIN:
        # Taken out of its array, an object has no dtype.
        return value if value.shape or value.dtype.hasobject else value[()]
    if not hasattr(value, "__array_ufunc__") or isinstance(value, AS_ARRAYS):
        try:
            return np.asarray(value)
        except ValueError:
            raise ValueError(
                f"{name}: expected a number or rows of one length, got {_show(value)}"
            ) from None
    # A foreign scalar, a number with a unit, gets a dtype and stays what it is.
    return value if hasattr(value, "dtype") else np.multiply(value, np.float64(1.0))


def _unmask(value: Any) -> Any:
    """Return a masked number as NaN: compared it would be neither true nor false."""
    if isinstance(value, np.ma.MaskedArray) and not value.shape:
        return np.float64(nan) if value.mask else value.data[()]
    return value


def cast(array: Any, dtype: np.dtype[Any]) -> Any:
    """Return an array of a type, a NumPy scalar where there are no axes."""
    found = array if array.dtype == dtype else array.astype(dtype)
    return found[()] if type(found) is np.ndarray else found


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


def split_components(name: str, array: Any, count: int) -> tuple[NDArray[Any], ...]:
    """Return the components on the last axis; raises as `check_components`."""
    check_components(name, array, count)
    if type(array) is np.ndarray and array.ndim < 3:
        return tuple(array.tolist() if array.ndim == 1 and array.dtype is DOUBLE else array.T)
    return tuple([array[..., i][()] for i in range(count)])


def sum_axes(**arguments: tuple[Any, int]) -> tuple[NDArray[Any], ...]:
    """Check that the axes to be summed over have one length; a scalar stands for equal elements.

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
    """Make arrays of scalars; ValueError for an axis of another length than the others."""
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
    """Mask all terms of a sum of which one is masked: NumPy would leave out that one, as if 0."""
    if not isinstance(array, np.ma.MaskedArray):
        return array
    mask = np.ma.getmaskarray(array).any(axis=tuple(range(-axes, 0)), keepdims=True)
    return np.ma.masked_array(array, np.broadcast_to(mask, array.shape))


def is_finite(value: Any) -> Any:
    """Return np.isfinite(value), which costs for a scalar as a short loop, or of a fraction."""
    return abs(value) < inf if type(value) in COMPARED else np.isfinite(value)


def is_positive(value: Any) -> Any:
    """Return whether 0 < value < oo, of a plain array True if it holds of all its numbers."""
    if type(value) is float:
        return 0.0 < value < inf
    smallest, largest = _find_extremes(value)
    return (smallest > 0.0 and largest < inf) or (value > 0.0) & is_finite(value)


def is_nonnegative(value: Any) -> Any:
    """Return whether 0 <= value < oo, of a plain array True if it holds of all its numbers."""
    if type(value) is float:
        return 0.0 <= value < inf
    smallest, largest = _find_extremes(value)
    return (smallest >= 0.0 and largest < inf) or (value >= 0.0) & is_finite(value)


def _find_extremes(array: Any) -> tuple[float, float]:
    """Return the smallest and the largest number; NaN if one is, and of what is no plain array.

    Found by their places they take a third of what min and max take, and half of comparisons.
    """
    if type(array) is not np.ndarray or not array.size:
        return nan, nan
    return array.item(array.argmin()), array.item(array.argmax())


def nan_outside(
    check: Callable[..., tuple[Any, ...]], *values: Any, terms: tuple[Any, ...] = ()
) -> tuple[NDArray[Any], ...]:
    """Return the values where all conditions of check(*values, *terms) hold, NaN elsewhere.

    Where all hold they come back as they are. Arrays of one number are asked as that number.
    """
    numbers = as_numbers(values)
    if numbers is not None and not terms:
        return values if all(check(*numbers)) else tuple([value * nan for value in values])
    inside: Any = True
    for condition in check(*values, *terms):
        # What holds everywhere is left out, so that few arrays are put together, most often none.
        if condition is not True and not holds(condition):
            inside = condition if inside is True else inside & condition
    if inside is True:
        return values
    if type(inside) in BOOLS:
        return tuple([value * nan for value in values])
    if type(inside) is np.ndarray and PLAIN.issuperset(map(type, values)):
        # Unmasked they keep their own shapes, and so does what is computed of them.
        return tuple([np.where(inside, value, nan) for value in values])
    # A product keeps the mask, the laziness or the unit, which np.where would drop.
    factor = np.where(inside, 1.0, np.nan)
    return tuple([value * factor for value in values])


def as_numbers(values: tuple[Any, ...]) -> tuple[float, ...] | None:
    """Return Python's numbers for doubles and for arrays of one; None if there is anything else.

    What is computed of numbers takes a fifth of what arrays of one element take.
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


def every(condition: Any, axis: Any) -> Any:
    """Return np.all(condition, axis), True without a reduction where it is true everywhere.

    What is masked counts as true: where it is, so is the result.
    """
    if condition is True or holds(condition):
        return True
    plain = condition.filled(True) if isinstance(condition, np.ma.MaskedArray) else condition
    return np.all(plain, axis=axis)


def add_up(terms: Any, axis: Any) -> Any:
    """Return np.sum(terms, axis), of a plain array without NumPy's search for other ways."""
    if type(terms) is np.ndarray:
        return np.add.reduce(terms, axis)
    return np.sum(terms, axis=axis)


def quadratic_form(vector: Any, matrix: Any) -> Any:
    """Return the sum of x[i]*x[j]*M[i, j], x on the last axis and M on the last two."""
    plain = type(vector) is type(matrix) is np.ndarray
    if not plain or vector.shape[-1] != matrix.shape[-1]:
        pairs = vector[..., :, np.newaxis] * vector[..., np.newaxis, :]
        return np.sum(pairs * matrix, axis=(-2, -1))
    if vector.ndim == 1 and matrix.ndim == 2:
        return vector.dot(matrix).dot(vector)
    if matrix.ndim == 2:
        return np.add.reduce(np.matmul(vector, matrix) * vector, -1)
    rows = np.matmul(vector[..., np.newaxis, :], matrix)[..., 0, :]
    return np.add.reduce(rows * vector, -1)


def nonnegative_form(vector: Any, matrix: Any) -> Any:
    """Return the quadratic form of a matrix that makes none negative, 0 where rounding made one so.

    Farther below 0 than n terms of two sums and their factors can be rounded it stays negative.
    """
    found = quadratic_form(vector, matrix)
    if type(found) in PLAIN and (_find_extremes(found)[0] >= 0.0 or not np.any(found < 0.0)):
        return found
    eps = np.finfo(found.dtype).eps
    rounding = (matrix.shape[-1] + 4) * eps * quadratic_form(abs(vector), abs(matrix))
    # A product keeps the mask or the unit; that of two negative numbers is no negative zero.
    factor = np.where(found < 0.0, np.where(found >= -rounding, -0.0, 1.0), 1.0)
    return found * factor.astype(found.dtype, copy=False)


def square(a: Any) -> Any:
    """Return a*a: of numbers a**2 calls pow, which may round another way."""
    return a * a


def floor(a: Any) -> Any:
    """Return np.floor(a), of Python's numbers one of them."""
    if type(a) is not float:
        return np.floor(a)
    return a // 1.0 if -inf < a < inf else a


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
    if type(condition) is type(value) is type(otherwise) is np.ndarray:
        return np.where(condition, value, otherwise)
    masked = any(isinstance(a, np.ma.MaskedArray) for a in (condition, value, otherwise))
    return (np.ma.where if masked else np.where)(condition, value, otherwise)


def holds(condition: Any) -> bool:
    """Say whether a condition is true of every element; those of a lazy array stay unread."""
    if type(condition) is np.ndarray:
        # Of a short array this costs a fifth of condition.all().
        return bool(np.count_nonzero(condition) == condition.size)
    return type(condition) in BOOLS and bool(condition)
