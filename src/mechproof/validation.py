"""Checks of the parameters of mechanisms: an error names parameter, value and what is allowed."""

from __future__ import annotations

import math
import operator
from collections.abc import Iterable
from numbers import Real
from typing import Any, SupportsIndex

__all__ = ["check_count", "check_real", "check_triple", "require"]


def require(condition: bool, name: str, value: object, allowed: str) -> None:
    """Raise ValueError "name = value: allowed" unless the condition holds."""
    if not condition:
        raise ValueError(f"{name} = {value!r}: {allowed}")


def check_real(name: str, value: Any) -> float:
    """Return a finite float; TypeError unless `value` is a real number (a bool is none)."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} = {value!r}: must be a real number, not {type(value).__name__}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    require(math.isfinite(number), name, value, "must be finite")
    return number


def check_count(name: str, value: SupportsIndex) -> int:
    """Return a natural number; TypeError unless `value` is an integer (a bool is none)."""
    try:
        count = operator.index(value)
    except TypeError:
        count = None
    if count is None or isinstance(value, bool):
        raise TypeError(f"{name} = {value!r}: must be an integer, not {type(value).__name__}")
    require(count >= 1, name, value, "must be at least 1")
    return count


def check_triple(name: str, value: Iterable[Any]) -> tuple[float, float, float]:
    """Return three finite floats; errors name the component."""
    try:
        components = tuple(value)
    except TypeError:
        raise TypeError(f"{name} = {value!r}: must be three real numbers") from None
    require(len(components) == 3, name, value, "must be three real numbers")
    x, y, z = (check_real(f"{name}[{i}]", component) for i, component in enumerate(components))
    return x, y, z
