"""Fused products: a*b + c with one rounding, for arrays of doubles on every machine.

An fma is emulated by sums rounded to odd (Boldo and Melquiond 2008).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mechproof.kernel_support.error_free import product_rest


def fma(a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c rounded once, where no part leaves the normal range.

    By a sum that is rounded to odd (Boldo and Melquiond 2008).
    """
    product = a * b
    low, lowest = add_exactly(c, product_rest(a, b, product))
    high, middle = add_exactly(product, low)
    fused = high + add_to_odd(middle, lowest)
    # The rests of infinities are NaN, where the plain sum is right.
    return np.where(np.isfinite(fused), fused, product + c)


def add_exactly(a: Any, b: Any) -> tuple[Any, Any]:
    """Return the rounded sum and what rounding took from it."""
    # Knuth's sum (1969), which does not ask which of both is larger.
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def add_to_odd(a: Any, b: Any) -> Any:
    """Return the sum, of its two neighbours that with an odd last bit if it is no double."""
    total, rest = add_exactly(a, b)
    bits = np.asarray(total).view(np.int64)
    outward = np.where((rest > 0) == (total > 0), 1, -1)
    moved = (rest != 0) & (bits & 1 == 0)
    return np.where(moved, (bits + outward).view(np.float64), total)
