"""What the facts of a kernel module make of parameters: the domain and the published sizes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, SupportsIndex

from mechproof.arguments.scalars import check_count, require
from mechproof.kernel_support.facts import Condition, Sizes


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
