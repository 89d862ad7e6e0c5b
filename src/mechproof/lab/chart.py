"""Charts of a record: time per point against worst error, with the Pareto front."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

from mechproof.lab.jumps import draw_jumps
from mechproof.lab.subject import Subject
from mechproof.measured import COPY, Kind, Record

# What is below this is drawn here: an exact result has no place on a logarithmic axis.
SMALLEST_ERROR = 0.1
# Lost results stand here, right of every finite error.
LOST = 1e19
# Where the number of a dot may stand, in pixels from it, nearest first.
PLACES = sorted(
    ((dx, dy) for dx in range(-90, 91, 15) for dy in range(-90, 91, 15) if (dx, dy) != (0, 0)),
    key=lambda p: (math.hypot(*p), -p[0], -p[1]),
)
MARKERS: Mapping[Kind, str] = {"kernel": "s", "form": "o", "peer": "^"}
SIGNS: Mapping[Kind, str] = {"kernel": "square", "form": "circle", "peer": "triangle"}
# The largest size drawn, where caches and pages both count.
LARGEST = 100_000
STYLE: Any = {"svg.hashsalt": "mechproof", "svg.fonttype": "none", "font.size": 9}


@dataclass(frozen=True)
class Dot:
    """A way on the chart: nanoseconds at `count`, errors on its best and worst point set.

    `error` is the one it is drawn at: of the worst set, or of one set.
    """

    way: str
    kind: Kind
    time: float
    best: float
    error: float
    count: int


def draw_charts(record: Record, subject: Subject | None, folder: Path) -> list[Path]:
    """Draw what there is to draw of one quantity, as PNG and SVG; return the files.

    Time against error is in the record; jumps between branches are computed from the subject, if
    it is there.
    """
    files: list[Path] = []
    with mpl.rc_context(STYLE):
        for workload, count in _largest_sizes(record):
            name = f"{record.quantity}.{_as_file_name(workload)}"
            files += save(draw_front(record, workload, count), folder / name)
        if subject is not None and (jumps := draw_jumps(subject)):
            files += save(jumps, folder / f"{record.quantity}.jumps")
    return files


def save(figure: Figure, stem: Path) -> list[Path]:
    """Write a figure as PNG and SVG; the same data give the same SVG."""
    files = [stem.with_name(f"{stem.name}.{kind}") for kind in ("png", "svg")]
    stem.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(files[0], dpi=130)
    figure.savefig(files[1], metadata={"Date": None})
    return files


def _as_file_name(text: str) -> str:
    return "".join(c if c.isalnum() else "_" for c in text)


def _largest_sizes(record: Record) -> list[tuple[str, int]]:
    """Return for each workload the largest size that is drawn."""
    sizes: dict[str, int] = {}
    for row in record.times:
        if row.count <= LARGEST:
            sizes[row.workload] = max(row.count, sizes.get(row.workload, 0))
    return list(sizes.items())


def collect_dots(
    record: Record, workload: str, count: int, only: str | None = None
) -> Iterator[Dot]:
    """Pair time and error of every way that has both, on all point sets or on one."""
    for way in record.ways:
        rows = [row for row in record.errors_of(way.name) if only in (None, row.set)]
        errors = [row.worst_scaled for row in rows if row.worst_scaled is not None]
        found = find_time(record, way.name, workload, count)
        if errors and found:
            kept = [min(max(e, SMALLEST_ERROR), LOST) for e in errors]
            yield Dot(way.name, way.kind, found[1], min(kept), max(kept), found[0])


def find_time(record: Record, way: str, workload: str, count: int) -> tuple[int, float] | None:
    """Return size and time at this size, or at the largest size below that was worth it."""
    rows = [r for r in record.times if (r.way, r.workload) == (way, workload) and r.count <= count]
    best = max(rows, key=lambda r: r.count, default=None)
    return (best.count, best.median) if best else None


def find_front(dots: list[Dot]) -> list[Dot]:
    """Return the dots that no other beats in both time and worst error, fastest first.

    A way that lost results is not on it.
    """
    front: list[Dot] = []
    kept = [dot for dot in dots if dot.error < LOST]
    for dot in sorted(kept, key=lambda d: (d.time, d.error)):
        if not front or dot.error < front[-1].error:
            front.append(dot)
    return front


def draw_front(record: Record, workload: str, count: int) -> Figure:
    """Draw time against worst error, both logarithmic, numbered, with the front and the copy.

    The errors on a typical point set are drawn in a panel of their own.
    """
    chosen = [record.typical, None] if record.typical else [None]
    panels = [_sorted_dots(record, workload, count, only) for only in chosen]
    figure = Figure(figsize=(5.2 + 4.8 * len(panels), 5.2), layout="constrained")
    *axes, listing = figure.subplots(1, len(panels) + 1, width_ratios=[*[4.8] * len(panels), 3.2])
    copy = find_time(record, COPY, workload, count)
    for panel, only, dots in zip(axes, chosen, panels, strict=True):
        _draw_panel(panel, dots, copy)
        panel.set_title(only or "worst of all point sets", fontsize=9)
        panel.sharey(axes[0])
    axes[0].set_ylabel("ns per point, median")
    label = "\n".join(textwrap.wrap(f"worst error, {record.error_unit}", 90))
    axes[0].set_xlabel(label, fontsize=8)
    title = f"{record.quantity}: {workload}, N = {count:.0e}"
    figure.suptitle(f"{title}; {record.machine.processor}, {record.taken[:10]}")
    _list_dots(listing, panels[-1], count)
    figure.draw_without_rendering()
    numbers = {dot.way: n for n, dot in enumerate(panels[-1], start=1)}
    for panel, dots in zip(axes, panels, strict=True):
        _number_dots(panel, dots, numbers)
    return figure


def _sorted_dots(record: Record, workload: str, count: int, only: str | None) -> list[Dot]:
    return sorted(collect_dots(record, workload, count, only), key=lambda d: d.time)


def _draw_panel(axes: Any, dots: list[Dot], copy: tuple[int, float] | None) -> None:
    front = find_front(dots)
    for dot in dots:
        _draw_dot(axes, dot, dot in front)
    axes.step([d.error for d in front], [d.time for d in front], "k-", where="pre", lw=1.2)
    _draw_copy(axes, copy)
    axes.set(xscale="log", yscale="log")
    axes.margins(x=0.08, y=0.08)
    axes.grid(which="major", color="0.9")


def _draw_copy(axes: Any, found: tuple[int, float] | None) -> None:
    if found:
        axes.axhline(found[1], color="0.4", ls=":", lw=1.2)
        place = (0.01, found[1])
        axes.annotate("memory copy", place, xycoords=("axes fraction", "data"), va="bottom")


def _draw_dot(axes: Any, dot: Dot, on_front: bool) -> None:
    """Draw a dot, and a thin line from its best point set."""
    face = "k" if on_front else "w"
    axes.plot([dot.best, dot.error], [dot.time, dot.time], "-", color="0.7", lw=0.8, zorder=1)
    marker = MARKERS[dot.kind]
    axes.plot(dot.error, dot.time, marker, color="k", markerfacecolor=face, ms=7, zorder=2)


def _number_dots(axes: Any, dots: list[Dot], numbers: Mapping[str, int]) -> None:
    """Put a number at each dot; it gives way to those before it and is then tied to its dot."""
    dpi = axes.figure.dpi
    spots = [axes.transData.transform((dot.error, dot.time)) for dot in dots]
    taken: list[tuple[float, float]] = [(float(x), float(y)) for x, y in spots]
    for dot, (x, y) in zip(dots, spots, strict=True):
        free = (p for p in PLACES if _is_free((x + p[0], y + p[1]), taken))
        place = next(free, PLACES[-1])
        taken.append((x + place[0], y + place[1]))
        tie = {"arrowstyle": "-", "color": "0.5", "lw": 0.5} if math.hypot(*place) > 20 else None
        offset = place[0] * 72 / dpi, place[1] * 72 / dpi
        axes.annotate(
            str(numbers[dot.way]), (dot.error, dot.time), offset,
            textcoords="offset points", ha="center", va="center", arrowprops=tie,
        )  # fmt: skip


def _is_free(spot: tuple[float, float], taken: list[tuple[float, float]]) -> bool:
    return all(abs(spot[0] - x) > 14 or abs(spot[1] - y) > 12 for x, y in taken)


def _list_dots(axes: Any, dots: list[Dot], count: int) -> None:
    axes.axis("off")
    front = find_front(dots)
    lines = [
        f"{n:2} {'*' if d in front else ' '} {d.way}"
        + (f" (N = {d.count})" if d.count != count else "")
        for n, d in enumerate(dots, start=1)
    ]
    key = ", ".join(f"{sign}: {kind}" for kind, sign in SIGNS.items())
    notes = ["", "filled: Pareto front (*: of all sets)", key, "thin line: from its best point set",
             f"at {LOST:.0e}: result lost (nan, inf)"]  # fmt: skip
    axes.text(0, 1, "\n".join(lines + notes), va="top", family="monospace", fontsize=8)
