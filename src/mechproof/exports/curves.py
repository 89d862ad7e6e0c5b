"""Pitch curves in mm: in, a mechanism at an angle of its carrier; out, wheels as CAD takes them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.scalars import check_real, refuse, require
from mechproof.mechanisms import OvalPair, OvalPlanetary
from mechproof.plot.motion_plot import Planetary
from mechproof.plot.pitch_curve_plot import Wheel, place_wheels

Array = NDArray[np.float64]
# Points of an outline at first; they are doubled until chords are near enough.
FIRST, MOST = 64, 2**20


def place_in_mm(mechanism: Planetary, phi1: float, a: Any) -> tuple[Wheel, ...]:
    """Return the wheels 4, 5, 6, 3; `a` is the major semi-axis where a mechanism has no size.

    Raises ValueError for an `a` that is not needed, or is and is none.
    """
    wheels = place_wheels(mechanism, phi1)
    if not (isinstance(mechanism, OvalPlanetary) and isinstance(mechanism.pair, OvalPair)):
        require(a is None, "a", a, "the mechanism has sizes; leave it out")
        return wheels
    if a is None:
        refuse("a", a, "must be stated, the major semi-axis (mm): an OvalPair has no size")
    size = check_real("a", a)
    require(size > 0, "a", a, "must be positive")
    return tuple(w._replace(axis=w.axis * size, a=w.a * size) for w in wheels)


def measure_centres(wheels: tuple[Wheel, ...]) -> float:
    """Return the distance of the centres A and C (mm)."""
    return float(np.hypot(*(wheels[1].axis - wheels[0].axis)))


def find_ellipse(wheel: Wheel) -> tuple[Array, Array, float]:
    """Return centre, major semi-axis as a vector and minor to major: one lobe is an ellipse.

    Its axis is the focus away from the longest radius.
    """
    along = np.array([np.cos(wheel.turned), np.sin(wheel.turned)])
    return wheel.axis + wheel.a * wheel.e * along, wheel.a * along, float(np.sqrt(1 - wheel.e**2))


def trace_outline(wheel: Wheel, tolerance: float) -> Array:
    """Return points of a closed curve, the first one not repeated, shape (n, 2).

    The curve is off the chords by no more than the tolerance (mm), judged at their middle angles.
    Raises ValueError where that takes too many points.
    """
    count = FIRST
    while count <= MOST:
        angles = wheel.turned + np.linspace(0.0, 2 * np.pi, 2 * count, endpoint=False)
        points = wheel.point(angles)
        ends, between = points[::2], points[1::2]
        chords = np.roll(ends, -1, axis=0) - ends
        gaps = between - ends
        away = np.abs(chords[:, 0] * gaps[:, 1] - chords[:, 1] * gaps[:, 0])
        if np.max(away / np.hypot(*chords.T)) <= tolerance / 2:
            return ends
        count *= 2
    raise ValueError(f"tolerance = {tolerance!r}: takes more than {MOST} points")
