"""Tests of compiled kernels: those of one system in one process, which compiles them once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def grouped(names: Iterable[str]) -> list[Any]:
    """Return the parameters of a test that calls the compiled kernels named system.quantity."""
    systems = {name: name.removeprefix("compiled.").partition(".")[0] for name in names}
    return [
        pytest.param(name, marks=pytest.mark.xdist_group(f"compiled {system}"))
        for name, system in systems.items()
    ]
