"""Checks of the parameters of mechanisms: an error names parameter, value and what is allowed."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Iterable, Mapping, Sequence
from numbers import Real
from typing import Any, SupportsIndex

from mechproof.kernel_support.facts import Condition, Sizes

__all__ = [
    "check_count",
    "check_domain",
    "check_real",
    "check_triple",
    "choose_published",
    "require",
]


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


def check_domain(
    domain: Iterable[Condition],
    values: Mapping[str, Any],
    as_given: Mapping[str, tuple[str, Any]] | None = None,
) -> None:
    """Raise ValueError for the first condition that the values do not satisfy.

    Conditions with other names than those of `values` are left out. `as_given` has the name and
    the value under which a parameter was given where they differ.
    """
    given = {name: (name, value) for name, value in values.items()} | dict(as_given or {})
    for condition in domain:
        if values.keys() >= {*condition.names}:
            holds = condition.holds(*(values[n] for n in condition.names))
            require(bool(holds), *given[condition.parameter], _write_allowed(condition, given))


def _write_allowed(condition: Condition, given: Mapping[str, tuple[str, Any]]) -> str:
    """Write what is allowed in the names of the caller, and the other parameters' values."""
    called = {name: other for name, (other, _) in given.items()}
    text = re.sub(r"\w+", lambda word: called.get(word[0], word[0]), condition.text)
    others = (given[name] for name in condition.names if name != condition.parameter)
    return f"must satisfy {text}" + "".join(f", {name} = {value!r}" for name, value in others)


def choose_published(
    published: Sequence[Sizes], name: str, number: SupportsIndex
) -> Mapping[str, Any]:
    """Return the sizes of one of the published sets, which are counted from 1.

    Raises TypeError or ValueError naming the number, called `name`.
    """
    count = check_count(name, number)
    require(count <= len(published), name, number, f"must be 1 to {len(published)}")
    return published[count - 1].sizes
