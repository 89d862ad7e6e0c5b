"""Error-free transformations of doubles, point by point: the rests that roundings leave.

Products are split by Veltkamp's method (1968) and recovered by Dekker's (1971), without a fused
multiply-add. See Muller et al., Handbook of Floating-Point Arithmetic (2018, chapter 4).
"""

from __future__ import annotations

from typing import Any

import numpy as np

DOUBLE = np.dtype(np.float64)
# Constants as zero-dimensional arrays, which NumPy need not convert in every operation.
DOWN, FACTOR, UP = np.asarray(2.0**-28), np.asarray(2.0**27 + 1), np.asarray(2.0**28)
LOWEST, HIGHEST = np.asarray(-1.0), np.asarray(1.0)


def sum_rest(a: Any, b: Any, s: Any) -> Any:
    """Return a + b - s, s being the rounded a + b: exact where |b| <= |a| (Dekker 1971)."""
    return b - (s - a)


def product_rest(a: Any, b: Any, p: Any) -> Any:
    """Return a*b - p, p being the rounded a*b: exact above 2**-969 (Dekker 1971)."""
    a_high, a_low = _split(a)
    b_high, b_low = _split(b)
    if type(p) is not np.ndarray or p.dtype is not DOUBLE:
        return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low
    # The same in place: combined with an array, zero-dimensional arrays cost half of what numbers
    # do.
    a_high, a_low, b_high, b_low = map(np.asarray, (a_high, a_low, b_high, b_low))
    rest = a_high * b_high
    rest -= p
    part = a_high * b_low
    rest += part
    rest += np.multiply(a_low, b_high, out=part)
    rest += np.multiply(a_low, b_low, out=part)
    return rest


def quotient_rest(a: Any, b: Any, q: Any) -> Any:
    """Return a/b - q, q being the rounded a/b, to half an ulp of itself."""
    p = q * b
    return ((a - p) - product_rest(q, b, p)) / b


def small_tangent(y: Any) -> Any:
    """Return tan(y), y being half of a low word: that is y, limited to [-1, 1]."""
    if type(y) is float:
        return -1.0 if y < -1.0 else 1.0 if y > 1.0 else y
    if type(y) is not np.ndarray or y.dtype is not DOUBLE:
        return np.minimum(np.maximum(y, -1.0), 1.0)
    return np.minimum(np.maximum(y, LOWEST), HIGHEST)


def _split(a: Any) -> tuple[Any, Any]:
    """Split a double into two of at most 26 bits (Veltkamp 1968)."""
    # Scaled down, so that the largest double does not overflow; below 2**-994 the high half has
    # fewer bits, which does no harm.
    if type(a) is not np.ndarray or a.dtype is not DOUBLE or not a.ndim:
        small = a * 2.0**-28
        scaled = small * (2.0**27 + 1)
        high = (scaled - (scaled - small)) * 2.0**28
        return high, a - high
    small = a * DOWN
    high = small * FACTOR
    np.subtract(high, small, out=small)
    high -= small
    high *= UP
    return high, np.subtract(a, high, out=small)


def single(value: Any) -> Any:
    """Return the value in float32; ArithmeticError for Python numbers, to try NumPy's."""
    if type(value) is float:
        # Combined with float32, Python numbers would not count as doubles.
        raise ArithmeticError("a Python number has no single precision")
    return value.astype(np.float32)


def whole_turns_off(x: Any) -> Any:
    """Return x less the nearest multiple of the double 2*pi."""
    return x - 2 * np.pi * np.rint(x / (2 * np.pi))
