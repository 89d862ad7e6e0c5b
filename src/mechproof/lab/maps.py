"""Maps of lost bits over two inputs, their worst along one of them, and the jumps by a period."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from mechproof.lab.error import Errors, find_errors
from mechproof.lab.oracle import Truth, find_truth
from mechproof.lab.points import REPORT, draw_points, list_sets
from mechproof.lab.specimen import Arguments, Array, Specimen
from mechproof.lab.subject import Map, PointSet, Subject

SIZE = 56
BITS = np.arange(0, 57, 8)
LINES = ("-", "--", ":", "-.")


def draw_map(subject: Subject, item: Map) -> Figure:
    """Draw the lost bits of each form over the two axes, and the worst along one of them beside."""
    arguments, across, upward = item.make(SIZE)
    truth = find_truth(subject, arguments)
    forms = [_named(subject, name) for name in item.forms]
    grids = [_lost_bits(form, arguments, truth) for form in forms]
    figure = Figure(figsize=(4 * len(forms) + 3.6, 4.2), layout="constrained")
    *panels, beside = figure.subplots(1, len(forms) + 1)
    for axes, form, grid in zip(panels, forms, grids, strict=True):
        mesh = axes.pcolormesh(
            across, upward, grid, cmap="Greys", vmin=0, vmax=BITS[-1], rasterized=True
        )
        lines = axes.contour(across, upward, np.nan_to_num(grid), BITS[1:-1], colors="k")
        axes.clabel(lines, fmt="%d", fontsize=7)
        axes.set(xscale="log", yscale="log", xlabel=item.across, title=form.name)
    panels[0].set_ylabel(item.upward)
    figure.colorbar(mesh, ax=panels, label="bits lost, of 53", shrink=0.9)
    at = across if item.against == "across" else upward
    _draw_worst(beside, forms, grids, item, at)
    figure.suptitle(f"{subject.name}: bits lost against the exact value, {item.name}")
    return figure


def _draw_worst(axes: Any, forms: list[Specimen], grids: list[Array], item: Map, at: Array) -> None:
    """Draw the worst along the other axis; ours is a broad line, so that equals show."""
    other, label = (0, item.across) if item.against == "across" else (1, item.upward)
    for form, grid, line in zip(forms, grids, LINES, strict=False):
        ours = form.source == "ours"
        style = {"color": "0.7", "lw": 5, "zorder": 1} if ours else {"color": "k", "ls": line}
        axes.plot(at, np.nanmax(grid, axis=other), label=form.name, **style)
    axes.set(xscale="log", xlabel=label, title="the worst of them", ylabel="bits lost")
    axes.legend(fontsize=8)
    axes.grid(color="0.9")


def _named(subject: Subject, name: str) -> Specimen:
    return next(s for s in subject.specimens if s.name == name)


def _lost_bits(form: Specimen, arguments: Arguments, truth: Truth) -> Array:
    grid: Array = _errors(form, arguments, truth).bits.reshape(SIZE, SIZE)
    return grid


def _errors(form: Specimen, arguments: Arguments, truth: Truth) -> Errors:
    with np.errstate(all="ignore"):
        return find_errors(form.compute(*arguments), truth)


def draw_jumps(subject: Subject) -> Figure | None:
    """Draw the error in periods of every form but peers with wrong branches on the ordered sets."""
    period = subject.study.period
    if period is None:
        return None
    rows = [
        (point_set, form, branch)
        for point_set in list_sets(subject)
        if point_set.ordered
        for form, branch in _wrong_branches(subject, point_set, period)
    ]
    if not rows:
        return None
    figure = Figure(figsize=(9, 1.25 * len(rows) + 0.8), layout="constrained")
    panels = np.atleast_1d(figure.subplots(len(rows), 1))
    for axes, (point_set, form, branch) in zip(panels, rows, strict=True):
        angle = draw_points(point_set, REPORT)[0]
        axes.plot(angle / np.pi, branch, "k.", ms=2, rasterized=True)
        count = int(np.sum(np.round(branch) != 0))
        axes.set_title(f"{form.name}: {count} wrong of {len(angle)}; {point_set.name}", loc="left")
        axes.set_ylabel("error/period")
        axes.grid(color="0.9")
    panels[-1].set_xlabel(f"{subject.quantity.arguments[0].name}/pi")
    figure.suptitle(f"{subject.name}: whole periods lost")
    return figure


def _wrong_branches(
    subject: Subject, point_set: PointSet, period: float
) -> list[tuple[Specimen, Array]]:
    """Return the forms with wrong branches on a set, with their signed errors in periods."""
    arguments = draw_points(point_set, REPORT)
    truth = find_truth(subject, arguments)
    found = []
    for form in subject.specimens:
        if form.source == "peer":
            continue
        result = _errors(form, arguments, truth).result
        branch = (result.astype(np.float64) - truth.high) / period
        if np.any(np.abs(branch) > 0.5):
            found.append((form, branch))
    return found
