"""One picture of all quantities: a small panel each, with the front and the best of each family."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from mechproof.lab.chart import DPI, STYLE, WIDTH, draw_key, find_limits, save
from mechproof.lab.chart_points import (
    ChartPoint,
    collect_marks,
    find_best,
    find_copy,
    find_front,
    list_workloads,
)
from mechproof.lab.panel import draw_mark, draw_panel, set_ticks
from mechproof.measured import Record

COLUMNS, HEIGHT = 6, 1.3
# Inches that the label of the errors needs.
LOWEST_HEIGHT = 2.2
NAME = "overview"
# Marks and lines in small panels, of their usual size.
SIZE, LINE = 0.6, 0.9
# Characters of a name that a panel has room for.
ROOM = 21


def draw_overview(records: Sequence[Record], folder: Path) -> list[Path]:
    """Draw one panel for the first workload of each quantity, as PNG and SVG; return the files."""
    with mpl.rc_context({**STYLE, "font.size": 7.5}):
        figure = draw_panels(records)
    return save(figure, folder / NAME, write_summary(records), records)


def collect_first(record: Record) -> list[ChartPoint]:
    """Return the marks of the first workload, at the worst of all sets."""
    return collect_marks(record, *list_workloads(record)[0])


def pick_marks(marks: Sequence[ChartPoint]) -> list[ChartPoint]:
    """Return the shipped way, the best of each family and the front."""
    return list(dict.fromkeys([*find_best(marks), *find_front(marks)]))


def write_summary(records: Sequence[Record]) -> str:
    """Say of how many quantities the shipped kernel is on the front, and the most accurate."""
    found = [collect_first(record) for record in records]
    best = sum(m[0].has_digits and m[0].height == min(x.height for x in m) for m in found)
    front = sum(any(_is_as_shipped(m, marks[0]) for m in find_front(marks)) for marks in found)
    return (
        f"For {best} of {len(found)} quantities nothing is more accurate than what is shipped "
        f"here; for {front} it is on the Pareto front"
    )


def _is_as_shipped(mark: ChartPoint, shipped: ChartPoint) -> bool:
    """Say whether it is the shipped way or a variant with the same results, as with `out=`."""
    return mark.family == "shipped" and mark.error == shipped.error


def draw_panels(records: Sequence[Record]) -> Figure:
    """Draw the small panels on common axes."""
    columns = min(COLUMNS, len(records))
    rows = math.ceil(len(records) / columns)
    height = max(HEIGHT * rows, LOWEST_HEIGHT) + 1
    figure = Figure(figsize=(WIDTH, height), dpi=DPI, layout="constrained")
    figure.suptitle(write_summary(records), weight="bold", fontsize=10)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False).flat
    drawn = [pick_marks(collect_first(record)) for record in records]
    copies = [find_copy(record, *list_workloads(record)[0]) for record in records]
    shown = [mark for marks in drawn for mark in marks]
    panels[0].set_xlim(find_limits(shown, None))
    for axes, record, marks, copy in zip(panels, records, drawn, copies, strict=False):
        _draw_small(axes, record, marks, copy)
    for axes in panels[len(records) :]:
        axes.set_visible(False)
    for axes in panels:
        axes.tick_params(labelsize=6.5, pad=1)
        # Within few decades numbers between the powers of ten would be labelled, side by side.
        axes.xaxis.set_minor_formatter(NullFormatter())
    set_ticks(panels[0], shown, right=False)
    figure.supylabel("worst error of all points, eps of the scale", fontsize=8)
    draw_key(figure, {mark.family for mark in shown}, "time per point, ns; dotted: of a copy")
    return figure


def _draw_small(axes: Any, record: Record, marks: Sequence[ChartPoint], copy: float | None) -> None:
    draw_panel(axes, marks, copy, LINE)
    system, _, quantity = record.quantity.partition(".")
    # Longer names would run into those beside them.
    axes.set_title(f"{system}\n{quantity}", fontsize=min(7.0, 7.0 * ROOM / len(quantity)))
    for mark in reversed(marks):
        draw_mark(axes, mark, SIZE)
