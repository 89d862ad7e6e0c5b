"""Tests of compiled kernels: those of one system in one process, which compiles them once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest
from weights import make_thorough

# Of the systems with the longest kernels one is compiled with every test, the rest with the
# thorough ones.
LONG = ("oval_planetary", "tooth_thickness", "wedge_linkage")
SHOWN = (".position", ".thickness_error")
# Angles, and the sizes of an elliptic planetary mechanism.
PHI = np.linspace(-40, 40, 4000)
SIZES = (66.0, 16.0, 0.475)
# What is computed in one pass.
TOGETHER = {
    "elliptic_planetary.motion": ("position", "ratio", "acceleration"),
    "oval_planetary.motion": ("position", "ratio", "acceleration"),
    "oval_planetary.motion_cylindrical": tuple(
        f"{name}_cylindrical" for name in ("position", "ratio", "acceleration")
    ),
}


def grouped(names: Iterable[str]) -> list[Any]:
    """Return the parameters of a test that calls the compiled kernels named system.quantity."""
    return [_group(name) if _is_shown(name) else make_thorough(_group(name)) for name in names]


def _group(name: str) -> Any:
    system = name.removeprefix("compiled.").partition(".")[0]
    return pytest.param(name, marks=[pytest.mark.xdist_group(f"compiled {system}")])


def _is_shown(name: str) -> bool:
    return name.endswith(SHOWN) or not name.removeprefix("compiled.").startswith(LONG)
