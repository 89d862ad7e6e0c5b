"""Quotients in a tangent and small arctangents without NumPy's tan and arctan.

Without AVX-512, NumPy calls the C library's tan and arctan for one number at a time; quotients of
polynomials, a block at a time and in place, take half as long. They are used for long arrays of
doubles where NumPy has no vector loop. Their coefficients are the generator's and come with the
call.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
# Coefficients over and under the line, lowest power first.
Fit = tuple[tuple[float, ...], tuple[float, ...]]
# From so many numbers on the calls of the polynomials cost less than what they save.
LONG = 4096
# Numbers per block: with the five temporaries they stay in a core's own cache.
BLOCK = 8192
# Where the multiple of pi next to y has at most 24 bits, its product with the 28 of PI is exact.
LARGEST = 2.0**25
PI = math.floor(math.pi * 2**26) / 2**26
# The sine of the double next to pi is what that double misses.
PI_LOW = (math.pi - PI) + math.sin(math.pi)


def _has_vector_loop(name: str) -> bool:
    """Say whether NumPy computes many doubles at once here; older ones cannot be asked."""
    if not hasattr(np.lib, "introspect"):
        return False
    found = np.lib.introspect.opt_func_info(func_name=f"^{name}$", signature="float64")
    loops = [loop["current"] for types in found.values() for loop in types.values()]
    return bool(loops) and not any(loop.startswith("baseline") for loop in loops)


IS_WORTH_IT = not _has_vector_loop("tan")


def tangent_quotient(y: Any, a: Any, b: Any, fit: Fit) -> Any:
    """Return t/(a + b*t**2) for t = tan(y), a and b positive; `fit` is tan(r/2)/r in r**2."""
    is_one = isinstance(a, float) and isinstance(b, float)
    if is_one and _is_long(y) and y.min() >= -LARGEST and y.max() <= LARGEST:
        return _in_blocks(_fill_tangent_quotient, y, fit, a, b)
    # A number of NumPy's would slow down what follows.
    t = float(np.tan(y)) if type(y) is float else np.tan(y)
    return t / (a + b * t**2)


def small_arctan(y: Any, fit: Fit) -> Any:
    """Return atan(y) for |y| <= 1/sqrt(3); `fit` is (atan(y)/y - 1)/y**2 in y**2."""
    if type(y) is float:
        return float(np.arctan(y))
    return _in_blocks(_fill_arctangent, y, fit) if _is_long(y) else np.arctan(y)


def _is_long(y: Any) -> bool:
    return IS_WORTH_IT and type(y) is np.ndarray and y.size >= LONG and y.dtype == np.float64


def _in_blocks(fill: Any, y: Array, fit: Fit, *parameters: Any) -> Array:
    given, values = y.reshape(-1), np.empty(y.size)
    spare = np.empty((5, min(y.size, BLOCK)))
    for start in range(0, y.size, BLOCK):
        block = given[start : start + BLOCK]
        found = values[start : start + BLOCK]
        fill(found, block, fit, *parameters, *spare[:, : block.size])
    return values.reshape(y.shape)


def _fill_tangent_quotient(
    q: Array, y: Array, fit: Fit, a: Any, b: Any, r: Array, z: Array, u: Array, v: Array, w: Array
) -> None:
    above, below = fit
    np.multiply(y, 1 / np.pi, out=w)
    np.rint(w, out=w)
    np.multiply(w, PI, out=z)
    np.subtract(y, z, out=r)
    w *= PI_LOW
    r -= w
    np.multiply(r, r, out=z)
    # tan(r/2) = u/v
    _fill_polynomial(u, z, above)
    u *= r
    _fill_polynomial(v, z, below)
    # tan(r) = 2*w/v
    np.multiply(u, v, out=w)
    u *= u
    v *= v
    v -= u
    np.multiply(v, w, out=q)
    v *= v
    v *= a / 2
    w *= w
    w *= 2 * b
    v += w
    q /= v


def _fill_arctangent(q: Array, y: Array, fit: Fit, z: Array, u: Array, v: Array, *_: Array) -> None:
    above, below = fit
    np.multiply(y, y, out=z)
    _fill_polynomial(u, z, above)
    _fill_polynomial(v, z, below)
    u /= v
    u *= z
    u *= y
    np.add(u, y, out=q)


def _fill_polynomial(value: Array, z: Array, coefficients: tuple[float, ...]) -> None:
    *others, last, first = coefficients
    np.multiply(z, first, out=value)
    value += last
    for number in reversed(others):
        value *= z
        value += number
