"""Which cases of a test run each time, and which only with the thorough ones."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def first_of(cases: Iterable[Any], count: int = 1) -> list[Any]:
    """Return the cases of a test, all but the first ones thorough."""
    listed = list(cases)
    return [*listed[:count], *map(_weigh, listed[count:])]


def _weigh(case: Any) -> Any:
    given = case if hasattr(case, "marks") else None
    if given is None:
        values = case if isinstance(case, tuple) else (case,)
        return pytest.param(*values, marks=pytest.mark.thorough)
    return pytest.param(*given.values, marks=[*given.marks, pytest.mark.thorough], id=given.id)
