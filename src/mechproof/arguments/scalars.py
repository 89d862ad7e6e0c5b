"""Checks of numbers, counts and tuples of them."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Mapping, Set
from numbers import Real
from typing import Any, NoReturn

PLAIN = frozenset({int, float})
# Longest text of a value that is shown whole.
LONGEST = 200


def refuse(name: str, value: object, allowed: str, error: type[Exception] = ValueError) -> NoReturn:
    """Raise an error "name = value: allowed" on one line, with only the ends of a long value."""
    text = " ".join(repr(value).split())
    if len(text) > LONGEST:
        text = f"{text[: LONGEST // 2]} ... {text[-LONGEST // 2 :]}"
    raise error(f"{name} = {text}: {allowed}")


def require(
    holds: object, name: str, value: object, allowed: str, error: type[Exception] = ValueError
) -> None:
    """Raise an error "name = value: allowed" unless the condition holds."""
    if not holds:
        refuse(name, value, allowed, error)


def refuse_units(name: str, value: Any) -> None:
    """Raise TypeError if a value, or an item in its rows, has a unit, which would be lost."""
    if _carries_unit(value):
        refuse(name, value, "carries a unit; give plain numbers in one unit", TypeError)


def _carries_unit(value: Any) -> bool:
    """Return whether a value or an item of it has an attribute that libraries use for units."""
    if isinstance(value, list | tuple):
        return not PLAIN.issuperset(map(type, value)) and any(map(_carries_unit, value))
    return any(getattr(value, word, None) is not None for word in ("unit", "units"))


def check_number(name: str, value: Any) -> float:
    """Return a float, possibly NaN or infinite; TypeError unless it is real (a bool is not)."""
    is_real = isinstance(value, Real) and not isinstance(value, bool)
    if not is_real:
        refuse_units(name, value)
        refuse(name, value, f"must be a real number, not {type(value).__name__}", TypeError)
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def check_real(name: str, value: Any) -> float:
    """Return a finite float; otherwise as `check_number`."""
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
    """Return a float strictly between 0 and 1."""
    number = check_number(name, value)
    require(0 < number < 1, name, value, "must lie between 0 and 1")
    return number


def check_count(name: str, value: Any, least: int = 1) -> int:
    """Return an integer of at least `least`; TypeError if it is not one (a bool is not)."""
    refuse_units(name, value)
    try:
        count = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        count = None
    if count is None:
        refuse(name, value, f"must be an integer, not {type(value).__name__}", TypeError)
    require(count >= least, name, value, f"must be at least {least}")
    return count


def check_items(name: str, value: Any, count: int | None, allowed: str) -> tuple[Any, ...]:
    """Return the items of a tuple or the like; TypeError unless there are `count` (None: any)."""
    # Sets have no order, and arrays without axes have no items.
    ordered = isinstance(value, Iterable) and not isinstance(value, Set | Mapping)
    items = tuple(value) if ordered and getattr(value, "ndim", None) != 0 else None
    if items is None or count not in (None, len(items)):
        refuse_units(name, value)
        refuse(name, value, allowed, TypeError)
    return items


def check_triple(name: str, value: Any) -> tuple[float, float, float]:
    """Return three finite floats; errors name the component."""
    items = check_items(name, value, 3, "must be three real numbers")
    x, y, z = (check_real(f"{name}[{i}]", item) for i, item in enumerate(items))
    return x, y, z


def choose_one(wanted: Mapping[str, Any], otherwise: str = "") -> tuple[str, Any]:
    """Return the name and value of the only parameter given; TypeError for none or several.

    `otherwise` says what may be given instead of one.
    """
    given = [name for name, value in wanted.items() if value is not None]
    if len(given) != 1:
        allowed = f"give exactly one of {', '.join(wanted)}{otherwise}"
        raise TypeError(f"{', '.join(given) or 'nothing'} given: {allowed}")
    return given[0], wanted[given[0]]


def check_text(name: str, value: Any) -> str:
    """Return a string; TypeError for anything else."""
    require(isinstance(value, str), name, value, "must be a string", TypeError)
    return str(value)


def check_texts(name: str, value: Any) -> tuple[str, ...]:
    """Return the strings of a list or a tuple; TypeError for anything else."""
    are_texts = isinstance(value, list | tuple) and all(isinstance(one, str) for one in value)
    require(are_texts, name, value, "must be a list of strings", TypeError)
    return tuple(value)


def check_mapping(name: str, value: Any, allowed: str) -> Mapping[Any, Any]:
    """Return a mapping; TypeError for anything else."""
    if not isinstance(value, Mapping):
        refuse(name, value, allowed, TypeError)
    return value


def check_function(name: str, value: Any) -> Callable[..., Any]:
    """Return a callable; TypeError for anything else."""
    if not callable(value):
        refuse(name, value, "must be a function", TypeError)
    return value  # type: ignore[no-any-return]


def check_progress(progress: Any) -> None:
    """Raise TypeError unless `progress` is None or a function."""
    if progress is not None:
        check_function("progress", progress)
