"""Checks of numbers, counts and tuples of them."""

from __future__ import annotations

import math
import operator
from collections.abc import Iterable
from numbers import Real
from typing import Any, NoReturn


def refuse(name: str, value: object, allowed: str, error: type[Exception] = ValueError) -> NoReturn:
    """Raise an error "name = value: allowed", on one line."""
    raise error(f"{name} = {' '.join(repr(value).split())}: {allowed}")


def require(
    holds: object, name: str, value: object, allowed: str, error: type[Exception] = ValueError
) -> None:
    """Raise an error "name = value: allowed" unless the condition holds."""
    if not holds:
        refuse(name, value, allowed, error)


def check_number(name: str, value: Any) -> float:
    """Return a float, NaN and infinite too; TypeError for what is no real number, as a bool."""
    is_real = isinstance(value, Real) and not isinstance(value, bool)
    if not is_real:
        refuse(name, value, f"must be a real number, not {type(value).__name__}", TypeError)
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def check_real(name: str, value: Any) -> float:
    """Return a finite float, as `check_number`."""
    number = check_number(name, value)
    require(math.isfinite(number), name, value, "must be finite")
    return number


def check_not_negative(name: str, value: Any) -> float:
    """Return a finite float that is not negative, or NaN."""
    number = check_number(name, value)
    allowed = not (number < 0 or math.isinf(number))
    require(allowed, name, value, "must be finite and not negative, or NaN")
    return number


def check_probability(name: str, value: Any) -> float:
    """Return a float between 0 and 1, neither of them."""
    number = check_number(name, value)
    require(0 < number < 1, name, value, "must lie between 0 and 1")
    return number


def check_count(name: str, value: Any, least: int = 1) -> int:
    """Return an integer from `least` on; TypeError unless `value` is one (a bool is none)."""
    try:
        count = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        count = None
    if count is None:
        refuse(name, value, f"must be an integer, not {type(value).__name__}", TypeError)
    require(count >= least, name, value, f"must be at least {least}")
    return count


def check_items(name: str, value: Any, count: int, allowed: str) -> tuple[Any, ...]:
    """Return the `count` items of a tuple or the like; TypeError for any other number of them."""
    items = tuple(value) if isinstance(value, Iterable) else ()
    require(len(items) == count, name, value, allowed, TypeError)
    return items


def check_triple(name: str, value: Any) -> tuple[float, float, float]:
    """Return three finite floats; errors name the component."""
    items = check_items(name, value, 3, "must be three real numbers")
    x, y, z = (check_real(f"{name}[{i}]", item) for i, item in enumerate(items))
    return x, y, z
