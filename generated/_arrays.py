"""Conversion of arguments and assembly of results, shared by all kernels.

Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray


def as_floats(**arguments: ArrayLike) -> tuple[NDArray[Any], ...]:
    """Convert to arrays of one float type.

    Python numbers are weak; float32 if every array is float32, float64 otherwise.

    Raises
    ------
    TypeError
        If an argument is complex, longer than float64 or not numeric; the message names it.

    """
    arrays = {name: np.asarray(value) for name, value in arguments.items()}
    for name, array in arrays.items():
        if array.dtype.kind not in "biuf" or array.dtype.itemsize > 8:
            raise TypeError(f"{name}: expected real numbers up to float64, got {array.dtype}")
    strong = [a.dtype for n, a in arrays.items() if type(arguments[n]) not in (bool, int, float)]
    single = bool(strong) and all(dtype == np.float32 for dtype in strong)
    dtype = np.float32 if single else np.float64
    return tuple(array.astype(dtype, copy=False) for array in arrays.values())


def split_components(name: str, array: NDArray[Any], count: int) -> NDArray[Any]:
    """Move the last axis to the front, so that it unpacks into components.

    Raises
    ------
    ValueError
        If the last axis has not `count` components; the message names the argument.

    """
    if array.shape[-1:] != (count,):
        raise ValueError(f"{name}: last axis must have length {count}, got shape {array.shape}")
    return np.moveaxis(array, -1, 0)


def sum_axes(**arguments: tuple[NDArray[Any], int]) -> tuple[NDArray[Any], ...]:
    """Check that the axes to be summed over have one length; a scalar stands for equal elements.

    Raises
    ------
    ValueError
        If an axis has another length or is missing; the message names the argument.

    """
    lengths = [n for array, axes in arguments.values() for n in array.shape[-axes:]]
    length = next((n for n in lengths if n != 1), 1)
    for name, (array, axes) in arguments.items():
        expected = (length,) * axes
        fits = array.shape[-axes:] == expected
        if not fits and not (axes == 1 and array.shape[-1:] in ((), (1,))):
            what = "last axis" if axes == 1 else f"last {axes} axes"
            raise ValueError(f"{name}: {what} must have shape {expected}, got shape {array.shape}")
    return tuple(np.atleast_1d(array) for array, _ in arguments.values())


def assemble(*components: ArrayLike, shape: tuple[int, ...]) -> NDArray[Any]:
    """Broadcast components and put them on new last axes of the given shape."""
    common = np.broadcast_shapes(*(np.shape(component) for component in components))
    result = np.empty((*common, len(components)), dtype=np.result_type(*components))
    for i, component in enumerate(components):
        result[..., i] = component
    return result.reshape(*common, *shape)
