"""Parameters, exact if given exactly, and their checks by the facts of a kernel module."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, SupportsIndex

import numpy as np

from mechproof.arguments.scalars import check_count, check_items, check_real, refuse, require
from mechproof.kernel_support.facts import Condition, Sizes

Number = float | Fraction
# Decimal strings are exact too; every parameter is kept as a Fraction or a float.
Given = float | Fraction | Decimal | str


def check_teeth(teeth: tuple[int, int]) -> tuple[int, int]:
    """Return the least and the largest number of teeth."""
    first, last = (check_count("teeth", z) for z in check_items("teeth", teeth, 2, "must be two"))
    require(first <= last, "teeth", teeth, "must be the least and the largest number")
    return first, last


def check_number(name: str, value: Any) -> Number:
    """Return an exact number as a fraction, and a float as a float."""
    if isinstance(value, np.integer):
        value = int(value)
    if isinstance(value, str | Decimal | int | Fraction) and not isinstance(value, bool):
        try:
            return Fraction(value)
        except (ValueError, OverflowError):
            refuse(name, value, "must be a finite number")
    return check_real(name, value)


def check_domain(
    domain: Iterable[Condition],
    values: Mapping[str, Any],
    as_given: Mapping[str, tuple[str, Any]] | None = None,
) -> None:
    """Raise ValueError for the first condition that the values do not satisfy.

    Conditions on names not in `values` are skipped. `as_given` has the name and the value under
    which a parameter was given, if they differ.
    """
    given = {name: (name, value) for name, value in values.items()} | dict(as_given or {})
    for condition in domain:
        if values.keys() >= {*condition.names}:
            holds = condition.holds(*(values[n] for n in condition.names))
            require(bool(holds), *given[condition.parameter], _write_allowed(condition, given))


def _write_allowed(condition: Condition, given: Mapping[str, tuple[str, Any]]) -> str:
    """Return the condition's text in the caller's names, with the other parameters' values."""
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
