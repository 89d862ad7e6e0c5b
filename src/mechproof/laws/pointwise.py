"""Array versions of the operations that compiled code applies to numbers.

A formula written with these and NumPy's elementwise functions accepts arrays. Compiled code runs
the same formula with numbers, and has its own functions in place of these.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np


def choose(condition: Any, value: Any, otherwise: Any) -> Any:
    """Return `value` where the condition holds, and `otherwise` elsewhere."""
    return np.where(condition, value, otherwise)


def exp(x: Any) -> Any:
    """Return the exponential."""
    return np.exp(x)


def hypot(a: Any, b: Any) -> Any:
    """Return sqrt(a**2 + b**2)."""
    return np.hypot(a, b)


def normal_tail(z: Any) -> Any:
    """Return the mass of the standard normal law beyond |z|."""
    from scipy.special import ndtr

    return ndtr(-np.abs(z))


def compute_where(
    condition: Any, function: Callable[..., Any], arguments: tuple[Any, ...], otherwise: Any
) -> Any:
    """Return a function of flat arguments where the condition holds, and `otherwise` elsewhere."""
    if not np.any(condition):
        return otherwise
    values = np.array(np.broadcast_to(otherwise, np.shape(condition)))
    values[condition] = function(*(a[condition] for a in arguments))
    return values
