"""Parameters for tests of compiled kernels: one process per system, so each compiles once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest
from weights import make_thorough

# Of kernels with similar loops, one is compiled in every run, the others in thorough runs only.
SHOWN = (
    # Angles reduced by whole turns, no running variable, the pieces of a linkage.
    *("elliptic_planetary.position", "elliptic_planetary.largest_ratio", "wedge_linkage.position"),
    # Results with axes, arguments with components, both.
    *("track_wheel.rotation", "track_wheel.planar_error", "track_wheel.displacement"),
    # Sums over sets of terms, once and over pairs.
    *("track_wheel.error_sum", "track_wheel.error_sum_correlated"),
    # Several quantities in one pass.
    "elliptic_planetary.motion",
)
# Angles, and sizes of an elliptic planetary mechanism.
PHI = np.linspace(-40, 40, 4000)
SIZES = (66.0, 16.0, 0.475)
# The quantities that a kernel computes in one pass.
TOGETHER = {
    "elliptic_planetary.motion": ("position", "ratio", "acceleration"),
    "oval_planetary.motion": ("position", "ratio", "acceleration"),
    "oval_planetary.motion_cylindrical": tuple(
        f"{name}_cylindrical" for name in ("position", "ratio", "acceleration")
    ),
}


def grouped(names: Iterable[str], most: int | None = None) -> list[Any]:
    """Return test parameters for the compiled kernels `names`, each given as system.quantity.

    The first `most` kernels in `SHOWN` (by default all) run with every test, the others are
    thorough.
    """
    every = list(names)
    shown = set([name for name in every if is_shown(name)][:most])
    return [_group(name) if name in shown else make_thorough(_group(name)) for name in every]


def is_shown(name: str) -> bool:
    """Return whether a kernel is compiled in every run."""
    return name.removeprefix("compiled.") in SHOWN


def _group(name: str) -> Any:
    system = name.removeprefix("compiled.").partition(".")[0]
    return pytest.param(name, marks=[pytest.mark.xdist_group(f"compiled {system}")])
