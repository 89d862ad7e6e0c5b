"""Charts: of a record, time per point against error; of kernels, jumps between branches.

The overview is a picture of all quantities with a small panel each, which shows the front and the
best of each family.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Collection, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import NullFormatter
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from mechproof.lab.chart_points import (
    ChartPoint,
    Family,
    collect_marks,
    find_best,
    find_copy,
    find_front,
    find_usual_set,
    list_workloads,
    write_headline,
)
from mechproof.lab.labels import LOOKS, draw_mark, draw_panel, name_marks, set_signs, set_ticks
from mechproof.lab.oracle import find_errors, find_truth
from mechproof.lab.record_tables import describe_proved, describe_where, find_searched
from mechproof.lab.sampling.named_sets import REPORT, PointSet, draw_points
from mechproof.lab.sampling.point_sets import list_sweeps
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Array, Way
from mechproof.measured import Record

# Dots per inch, and a width in inches that makes as many pixels as a README is wide.
DPI, WIDTH = 110, 9.2
COLOURS = 256
# Style of charts; with the salt, the same data give the same bytes.
STYLE: Any = {"svg.hashsalt": "mechproof", "svg.fonttype": "none", "font.size": 9}


def draw_charts(record: Record, subject: Subject | None, folder: Path) -> list[Path]:
    """Draw the charts of one quantity as PNG and SVG, and return the files.

    Time against error is in the record; jumps between branches are computed from the subject, if it
    is given.
    """
    files: list[Path] = []
    for workload, count in list_workloads(record):
        with mpl.rc_context(STYLE):
            figure = draw_chart(record, workload, count)
        words = "".join(c if c.isalnum() else "_" for c in workload)
        name = f"{record.quantity}.{words}"
        says = write_title(record, workload, count)
        files += save(figure, folder / name, says, [record])
    if subject is not None and (jumps := draw_jumps(subject)):
        files += save(jumps, folder / f"{record.quantity}.jumps", "whole periods lost", [record])
    return files


def save(figure: Figure, stem: Path, says: str, records: Sequence[Record]) -> list[Path]:
    """Write a figure as PNG and SVG, with its message and its records in the metadata.

    The same data give the same files.
    """
    files = [stem.with_name(f"{stem.name}.{kind}") for kind in ("png", "svg")]
    stem.parent.mkdir(parents=True, exist_ok=True)
    about = {"Title": says, "Description": describe_sources(records)}
    with mpl.rc_context(STYLE):
        write_small_png(figure, files[0], about)
        figure.savefig(files[1], metadata={**about, "Date": None})
    return files


def write_small_png(figure: Figure, file: Path, about: Mapping[str, str]) -> None:
    """Write a PNG of few colours: a quarter of the bytes, and no visible difference."""
    buffer, info = BytesIO(), PngInfo()
    figure.savefig(buffer, format="png", dpi=DPI)
    for key, text in about.items():
        info.add_text(key, text)
    # Not the median cut, which gives small marks the mean of their neighbours.
    few = Image.open(buffer).convert("RGB").quantize(COLOURS, Image.Quantize.FASTOCTREE)
    few.save(file, optimize=True, pnginfo=info)


def describe_sources(records: Sequence[Record]) -> str:
    """Return the sources of a picture: times of measurement and, for one quantity, its bounds."""
    told = describe_proved(*records) if len(records) == 1 else {}
    return "; ".join((date_records(records), *(f"{way}: {text}" for way, text in told.items())))


def date_records(records: Sequence[Record]) -> str:
    """Return when, and how thoroughly, the records drawn were taken."""
    return f"{describe_how(records)} {', '.join(sorted({record.taken for record in records}))}"


def describe_how(records: Sequence[Record]) -> str:
    """Return how records were taken: a quick one has few points and short times."""
    return "quickly measured" if any(record.quick for record in records) else "measured"


def write_title(record: Record, workload: str, count: int) -> str:
    """Return the chart's message as a sentence, including the worst error a search found."""
    marks = collect_marks(record, workload, count)
    return write_headline(marks, find_searched(record).get(marks[0].name, 0.0))


def draw_chart(record: Record, workload: str, count: int) -> Figure:
    """Draw a panel of the usual point set and one of the worst of all sets, with a headline."""
    usual = find_usual_set(record)
    worst = collect_marks(record, workload, count)
    points = sum(row.points for row in record.errors_of(record.ways[0].name))
    panels = {
        f"Usual calls{describe_usual(usual)}": collect_marks(record, workload, count, usual),
        f"The worst of {points:,} points, chosen to hurt": worst,
    }
    figure = Figure(figsize=(WIDTH, 8), dpi=DPI, layout="constrained")
    says = textwrap.wrap(write_title(record, workload, count), 92)
    figure.suptitle("\n".join(says), weight="bold", fontsize=11)
    rows = figure.subplots(2, 1, sharex=True)
    copy = find_copy(record, workload, count)
    rows[0].set_xlim(find_limits([mark for marks in panels.values() for mark in marks], copy))
    for axes, (title, marks) in zip(rows, panels.items(), strict=True):
        axes.set_title(title, loc="left", fontsize=9)
        draw_panel(axes, marks, copy)
        _name_copy(axes, copy)
        set_ticks(axes, marks)
        axes.set_ylabel("worst error, eps")
    rows[-1].set_xlabel(_describe(record, workload, count))
    draw_key(figure, {mark.family for marks in panels.values() for mark in marks})
    _write_names(figure, rows, list(panels.values()), count, copy, describe_proved(record))
    return figure


def describe_usual(name: str) -> str:
    """Return the name of the usual set in brackets, or "" if it is just "usual"."""
    return "" if name == "usual" else f" ({name})"


def _describe(record: Record, workload: str, count: int) -> str:
    what = (
        f"{record.quantity}, {workload}, N = {count:,}, one call; {record.machine.processor}, "
        f"{record.taken[:10]}. Errors in {record.error_unit}."
    )
    what = " ".join(filter(None, (what, record.lacking, describe_where(record))))
    return "\n".join(
        [
            "time per point, ns (in brackets: over that of the shipped kernel)",
            *textwrap.wrap(set_signs(what), 120),
        ]
    )


def find_limits(marks: Sequence[ChartPoint], copy: float | None) -> tuple[float, float]:
    """Return the ends of the time axis: they leave room on both sides of all marks and the copy."""
    times = [mark.time for mark in marks] + ([copy] if copy else [])
    low, high = min(times), max(times)
    room = (2 * high / low) ** 0.05
    return low / room, high * room


def draw_key(figure: Figure, families: Collection[Family], title: str = "") -> None:
    """Explain shapes and lines below the panels."""
    handles = [
        Line2D([], [], ls="", marker=look.marker, c="k", mfc=look.face, mew=0.7, label=look.says)
        for family, look in LOOKS.items()
        if family in families
    ]
    handles.append(Line2D([], [], color="k", label="Pareto front; nothing reaches the grey"))
    figure.legend(handles=handles, loc="outside lower center", ncols=3, frameon=False, title=title)


def _name_copy(axes: Any, copy: float | None) -> None:
    if copy is not None:
        place = (copy, 0.3)
        kept = {"xycoords": ("data", "axes fraction"), "fontsize": 8, "rotation": 90}
        axes.annotate(
            "memory limit:\ntime of a copy", place, (4, 0), textcoords="offset points", **kept
        )


def _write_names(
    figure: Figure,
    rows: Sequence[Any],
    panels: Sequence[Sequence[ChartPoint]],
    count: int,
    copy: float | None,
    proved: Mapping[str, str],
) -> None:
    """Name marks after the layout, which determines the room, and count those without a name.

    Proved bounds are named in the lower panel only, which shows the worst of all points.
    """
    layout = figure.get_layout_engine()
    assert layout is not None
    layout.execute(figure)
    figure.set_layout_engine("none")
    for axes, marks in zip(rows, panels, strict=True):
        told = proved if axes is rows[-1] else {}
        rest = len(marks) - len(name_marks(axes, marks, count, copy, told))
        title = f"{len(marks)} ways" + (f", {rest} of them without a name here" if rest else "")
        axes.set_title(title, loc="right", fontsize=8)


def draw_jumps(subject: Subject) -> Figure | None:
    """Draw the errors in periods on the ordered sets, of ways other than peers, or return None."""
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


COLUMNS, HEIGHT = 6, 1.3
# The height, in inches, that the label of the errors needs.
LOWEST_HEIGHT = 2.2
NAME = "overview"
# Sizes of marks and lines in small panels, as shares of the usual ones.
SIZE, LINE = 0.6, 0.9
# The number of characters of a name that a panel has room for.
ROOM = 21


def draw_overview(records: Sequence[Record], folder: Path) -> list[Path]:
    """Draw one panel for the first workload of each quantity as PNG and SVG; return the files."""
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
    """Return for how many quantities the shipped kernel is most accurate, and is on the front."""
    found = [collect_first(record) for record in records]
    best = sum(m[0].has_digits and m[0].height == min(x.height for x in m) for m in found)
    front = sum(any(_is_as_shipped(m, marks[0]) for m in find_front(marks)) for marks in found)
    return (
        f"For {best} of {len(found)} quantities nothing is more accurate than what is shipped "
        f"here; for {front} it is on the Pareto front"
    )


def _is_as_shipped(mark: ChartPoint, shipped: ChartPoint) -> bool:
    """Return whether a mark is the shipped way or a variant with the same error, as with `out=`."""
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
        # On an axis of few decades, minor ticks would be labelled, too, too close to one another.
        axes.xaxis.set_minor_formatter(NullFormatter())
    set_ticks(panels[0], shown, right=False)
    figure.supylabel("worst error of all points, eps of the scale", fontsize=8)
    draw_key(figure, {mark.family for mark in shown}, "time per point, ns; dotted: of a copy")
    return figure


def _draw_small(axes: Any, record: Record, marks: Sequence[ChartPoint], copy: float | None) -> None:
    draw_panel(axes, marks, copy, LINE)
    system, _, quantity = record.quantity.partition(".")
    # Longer names would run into those next to them.
    axes.set_title(f"{system}\n{quantity}", fontsize=min(7.0, 7.0 * ROOM / len(quantity)))
    for mark in reversed(marks):
        draw_mark(axes, mark, SIZE)
