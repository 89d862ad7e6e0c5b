"""Jumps of kernels and forms between branches, drawn along the ordered sets."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from mechproof.lab.error import find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.sampling.point_sets import list_sweeps
from mechproof.lab.sampling.points import REPORT, PointSet, draw_points
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Array, Way


def draw_jumps(subject: Subject) -> Figure | None:
    """Draw the error in periods of all but peers with wrong branches on the ordered sets."""
    period = subject.period
    if period is None:
        return None
    rows = [
        (point_set, way, branch)
        for point_set in list_sweeps(subject)
        for way, branch in _wrong_branches(subject, point_set, period)
    ]
    if not rows:
        return None
    figure = Figure(figsize=(9, 1.25 * len(rows) + 0.8), layout="constrained")
    panels = np.atleast_1d(figure.subplots(len(rows), 1))
    for axes, (point_set, way, branch) in zip(panels, rows, strict=True):
        angle = draw_points(point_set, REPORT)[0]
        axes.plot(angle / np.pi, branch, "k.", ms=2, rasterized=True)
        count = int(np.sum(np.round(branch) != 0))
        axes.set_title(f"{way.name}: {count} wrong of {len(angle)}; {point_set.name}", loc="left")
        axes.set_ylabel("error/period")
        axes.grid(color="0.9")
    panels[-1].set_xlabel(f"{subject.quantity.arguments[0].name}/pi")
    figure.suptitle(f"{subject.name}: whole periods lost")
    return figure


def _wrong_branches(
    subject: Subject, point_set: PointSet, period: float
) -> list[tuple[Way, Array]]:
    """Return the ways with wrong branches on a set, with their signed errors in periods."""
    arguments = draw_points(point_set, REPORT)
    truth = find_truth(subject, arguments)
    found = []
    for way in subject.ways:
        if way.kind == "peer":
            continue
        with np.errstate(all="ignore"):
            result = find_errors(way.compute(*arguments), truth).result
        branch = (result.astype(np.float64) - truth.high) / period
        if np.any(np.abs(branch) > 0.5):
            found.append((way, branch))
    return found
