"""Functions in formulas: NumPy's, with the same values for Python numbers, and sums of arrays."""

from __future__ import annotations

from math import inf
from typing import Any

import numpy as np

from mechproof.kernel_support.arrays import BOOLS, PLAIN, SCALARS
from mechproof.kernel_support.domains import find_extremes

SMALLEST = float(np.finfo(float).smallest_subnormal)
NUMBERS = frozenset({float, np.float64})


def add_up(terms: Any, axis: Any) -> Any:
    """Return np.sum(terms, axis), for a plain array without NumPy's dispatch."""
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
    """Return the form of a positive semidefinite matrix, 0 where only rounding made it negative.

    A value stays negative if it is farther below 0 than the roundings of two sums of n terms and of
    their factors explain.
    """
    found = quadratic_form(vector, matrix)
    if type(found) in PLAIN and (find_extremes(found)[0] >= 0.0 or not np.any(found < 0.0)):
        return found
    eps = np.finfo(found.dtype).eps
    rounding = (matrix.shape[-1] + 4) * eps * quadratic_form(abs(vector), abs(matrix))
    # A product keeps the mask or the unit; -0.0 times a negative number is a positive zero.
    factor = np.where(found < 0.0, np.where(found >= -rounding, -0.0, 1.0), 1.0)
    return found * factor.astype(found.dtype, copy=False)


def square(a: Any) -> Any:
    """Return a*a: for numbers a**2 calls pow, which may round differently."""
    return a * a


def floor(a: Any) -> Any:
    """Return np.floor(a), a Python number for a Python number."""
    if type(a) is not float:
        return np.floor(a)
    return a // 1.0 if -inf < a < inf else a


def sinc(a: Any) -> Any:
    """Return np.sin(a)/a, and 1 at 0: the sine of the smallest double is that double."""
    moved = choose_where(a == 0, SMALLEST, a)
    return np.sin(moved) / moved


def tangent_quotient(y: Any, c: Any, a: Any, r: Any, b: Any) -> Any:
    """Return c*t/(a + r + b*t**2) for t = np.tan(y), r being the rest of a; a float for floats."""
    t = float(np.tan(y)) if type(y) is float else np.tan(y)
    return c * t / (a + (r + b * (t * t)))


def small_arctan(y: Any) -> Any:
    """Return np.arctan(y) for |y| <= 1/sqrt(3); a float for a float."""
    return float(np.arctan(y)) if type(y) is float else np.arctan(y)


def arctan_quotient(a: Any, b: Any) -> Any:
    """Return np.arctan2(a, b), which is arctan(a/b) for b positive; a float for floats."""
    return float(np.arctan2(a, b)) if type(a) is type(b) is float else np.arctan2(a, b)


def hypot(a: Any, b: Any) -> Any:
    """Return np.hypot(a, b), but NaN where one is NaN and the other infinite."""
    found = np.hypot(a, b)
    if type(found) is np.float64:
        return found if found < inf else abs(a) + abs(b)
    # Neither side exceeds the root, so the maximum changes it only where a side is NaN.
    if type(found) is np.ndarray:
        np.maximum(found, a, out=found)
        return np.maximum(found, b, out=found)
    return np.maximum(np.maximum(found, a), b)


def maximum(a: Any, b: Any) -> Any:
    """Return np.maximum(a, b), for two unequal numbers without calling it."""
    if type(a) in NUMBERS and type(b) in NUMBERS:
        if a > b:
            return a
        if a < b:
            return b
    return np.maximum(a, b)


def choose_where(condition: Any, value: Any, otherwise: Any) -> Any:
    """Return np.where(condition, value, otherwise), masked if any of the three is."""
    if type(condition) in BOOLS and SCALARS.issuperset((type(value), type(otherwise))):
        return value if condition else otherwise
    if type(condition) is type(value) is type(otherwise) is np.ndarray:
        return np.where(condition, value, otherwise)
    masked = any(isinstance(a, np.ma.MaskedArray) for a in (condition, value, otherwise))
    return (np.ma.where if masked else np.where)(condition, value, otherwise)
