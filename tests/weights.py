"""Which cases of a test always run, and which only with the thorough tests."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def first_of(cases: Iterable[Any], count: int = 1) -> list[Any]:
    """Return the cases of a test, all but the first `count` marked as thorough."""
    return [case if n < count else make_thorough(case) for n, case in enumerate(cases)]


def make_thorough(case: Any) -> Any:
    """Return a case of a test, marked as thorough."""
    if hasattr(case, "marks"):
        return pytest.param(*case.values, marks=[*case.marks, pytest.mark.thorough], id=case.id)
    return pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=pytest.mark.thorough)
