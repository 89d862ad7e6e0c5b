"""Calls of kernels with one point and with many."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from mechproof.kernels import elliptic_planetary, track_wheel

RADII = (66.0, 16.0)
SHARED_SHIFT = np.array([0.01, 0.02, 0.03])


def spread(*shape: int) -> np.ndarray:
    """Return numbers from -3 to 3, no two equal, in an array of this shape."""
    return np.linspace(-3, 3, int(np.prod(shape))).reshape(shape)


# Calls with one point and with many: scalars and arrays, one pose and many, parameters of any size.
CALLS: dict[str, tuple[Callable[..., Any], tuple[Any, ...]]] = {
    "position": (elliptic_planetary.position, (spread(7), *RADII, 0.475)),
    "position with low word": (elliptic_planetary.position, (spread(7), *RADII, 0.9)),
    "one angle": (elliptic_planetary.position, (0.3, *RADII, np.linspace(0, 0.9, 7))),
    "as many parameters": (elliptic_planetary.ratio, (spread(7), *RADII, np.linspace(0, 0.9, 7))),
    "grid": (
        elliptic_planetary.ratio, (spread(1, 7), *RADII, np.linspace(0, 0.9, 3)[:, np.newaxis]),
    ),
    "strided": (elliptic_planetary.acceleration, (spread(7, 2)[:, 1], *RADII, 0.5)),
    "column-major": (elliptic_planetary.acceleration, (spread(3, 5).T, *RADII, 0.5)),
    "rotation": (track_wheel.rotation, (spread(7), 0.2, spread(7) ** 2)),
    "one pose": (track_wheel.displacement, (spread(7, 3), [0.1, 0.2, 3.0], SHARED_SHIFT)),
    "one point": (track_wheel.displacement, ([1.0, 2.0, 3.0], spread(7, 3), SHARED_SHIFT)),
    "poses and points": (
        track_wheel.displacement, (spread(7, 1, 3), spread(3, 3), SHARED_SHIFT),
    ),
    "track": (track_wheel.track, (spread(7), 41.5, 3.75, 6, 20.0)),
    "planar error": (track_wheel.planar_error, (spread(7, 3),)),
    "sum": (track_wheel.error_sum, (np.abs(spread(7, 3)), 1.0, 1.0, 1.2)),
}  # fmt: skip
