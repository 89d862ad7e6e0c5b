"""Tables as CSV: the outlines of wheels, and the motion; numbers are read back exactly."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from io import StringIO

import numpy as np

from mechproof.exports.curves import trace_outline
from mechproof.plot.motion_plot import Planetary
from mechproof.plot.pitch_curve_plot import Wheel

# Degrees of the carrier from line to line of a table of the motion.
STEP = 1.0


def write_outlines(wheels: tuple[Wheel, ...], tolerance: float) -> str:
    """Return a line for each point of the closed outlines; the last one is the first again."""
    rows = []
    for wheel in wheels:
        points = trace_outline(wheel, tolerance).tolist()
        rows += [(wheel.number, *point) for point in (*points, points[0])]
    return _write(("wheel", "x_mm", "y_mm"), rows)


def write_motion(mechanism: Planetary, degrees: bool) -> str:
    """Return a line for each degree of a turn of the carrier: position, ratio, acceleration."""
    whole = np.arange(0.0, 360.0 + STEP / 2, STEP)
    angles = whole if degrees else np.radians(whole)
    columns = (
        angles,
        mechanism.position(angles, degrees=degrees),
        mechanism.ratio(angles, degrees=degrees),
        mechanism.acceleration(angles, degrees=degrees),
    )
    unit = "deg" if degrees else "rad"
    names = f"phi1_{unit}", f"phi3_{unit}", "ratio", f"acceleration_per_{unit}"
    return _write(names, zip(*(c.tolist() for c in columns), strict=True))


def _write(names: Sequence[str], rows: Iterable[Sequence[float]]) -> str:
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names)
    writer.writerows(rows)
    return text.getvalue()
