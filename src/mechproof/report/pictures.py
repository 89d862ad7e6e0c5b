"""Pictures: measurements and the figures of papers, as SVG for a page."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache, partial
from importlib.resources import files
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure as Canvas

from mechproof.lab.chart import (
    STYLE,
    describe_how,
    draw_chart,
    draw_panels,
    write_summary,
    write_title,
)
from mechproof.lab.chart_points import list_workloads
from mechproof.measured import KERNELS, Record
from mechproof.plot.figures import DrawingError, find_figures, render_svg, write_svg
from mechproof.tools.cache import HERE, Store, list_program, make_key
from mechproof.tools.json_rows import write_lines
from mechproof.tools.processes import WorkerError, run_tasks

# Time limit for a picture, in seconds: beyond it something hangs.
LIMIT = 300.0
SMALL = 7.5
# The largest width, in points, of a picture for one column, which has 241.
NARROW = 300.0
OVERVIEW = "overview"
KEPT = Store("pictures.json")
MOST_KEPT = 400
PACKAGES = ("matplotlib", "numpy")
# Packages that draw charts, and those that no figure shows.
CHART_SOURCES = ("lab", "plot", "measured.py")
UNSEEN = (
    *("cli", "report", "sources", "nomenclature", "document", "latex", "improvement"),
    "pipeline",
)


@dataclass(frozen=True)
class Picture:
    """A picture of a page: its title, its caption, and its drawing as a single element.

    One that could not be drawn has a `failure` instead of the element.
    """

    title: str
    caption: str
    svg: str
    name: str = ""
    number: str = ""
    after: str = ""
    failure: str = ""

    @property
    def is_narrow(self) -> bool:
        """Return whether it is made for one column of a page."""
        width = re.search(r'\bwidth="([\d.]+)pt"', self.svg)
        return width is not None and float(width[1]) < NARROW


@dataclass(frozen=True)
class PictureTask:
    """A picture to draw, and the `blank` one that replaces it if drawing hangs or crashes.

    `key` is the digest of what it shows and of the code that draws it.
    """

    draw: Callable[[], Picture]
    blank: Picture
    key: str


def draw_pictures(
    tasks: Mapping[str, PictureTask], report: Callable[[str], None] = lambda text: None
) -> dict[str, Picture]:
    """Return all pictures, drawing those not cached on all processors; failed ones say why."""
    kept = KEPT.read()
    drawn = {name: Picture(**kept[t.key]) for name, t in tasks.items() if t.key in kept}
    names = [name for name in tasks if name not in drawn]
    calls = [tasks[name].draw for name in names]
    for number, picture in run_tasks(_call, calls, limit=LIMIT):
        name = names[number]
        if isinstance(picture, WorkerError):
            picture = replace(tasks[name].blank, failure=str(picture))
        drawn[name] = picture
        report(f"{len(drawn)} of {len(tasks)} pictures: {name}")
    if names:
        new = {tasks[n].key: asdict(p) for n, p in drawn.items() if not p.failure}
        KEPT.write(dict(list({**kept, **new}.items())[-MOST_KEPT:]))
    return {name: drawn[name] for name in tasks}


def _call(draw: Callable[[], Picture]) -> Picture:
    return draw()


def list_charts(record: Record) -> dict[str, PictureTask]:
    """Return the charts of a quantity, one for each workload."""
    return {
        f"{record.quantity}, {workload}": PictureTask(
            partial(chart, record, workload, count),
            Picture(record.quantity, workload, ""),
            _key_chart(workload, *write_lines(record)),
        )
        for workload, count in list_workloads(record)
    }


def chart(record: Record, workload: str, count: int) -> Picture:
    """Draw time against error of all ways to compute a quantity."""
    with mpl.rc_context(STYLE):
        canvas = draw_chart(record, workload, count)
    says = write_title(record, workload, count)
    return Picture(says, f"{workload}; {_date([record])}", _render(canvas, says))


def list_overview(records: Sequence[Record]) -> dict[str, PictureTask]:
    """Return the picture of all quantities if there are several."""
    if len(records) < 2:
        return {}
    lines = [line for record in records for line in write_lines(record)]
    key = _key_chart(OVERVIEW, *lines)
    return {
        OVERVIEW: PictureTask(partial(overview, records), Picture("All quantities", "", ""), key)
    }


def overview(records: Sequence[Record]) -> Picture:
    """Draw a small panel for each quantity."""
    with mpl.rc_context({**STYLE, "font.size": SMALL}):
        canvas = draw_panels(records)
    says = write_summary(records)
    return Picture(says, _date(records), _render(canvas, says))


def list_figures(place: Path) -> dict[str, PictureTask]:
    """Return the figures that a paper's folder declares."""
    blanks = [
        Picture(figure.title, figure.caption, "", figure.name, figure.number or "", figure.after)
        for figure in find_figures(place)
    ]
    return {
        f"{place.stem}, {blank.name}": PictureTask(
            partial(draw_figure, place, blank), blank, _key_figure(place, blank)
        )
        for blank in blanks
    }


def _key_figure(place: Path, blank: Picture) -> str:
    """Return the digest of all that a figure is drawn from: its folder, kernels, the runtime."""
    folder = place if place.is_dir() else place.parent
    own = sorted(path for path in folder.rglob("*") if path.suffix in (".py", ".tex"))
    return make_key(own, PACKAGES, _digest_drawing(), *map(str, asdict(blank).values()))


@cache
def _digest_drawing() -> str:
    """Return the digest of the code that draws figures, computed once per process."""
    program = [path for path in list_program() if path.relative_to(HERE).parts[0] not in UNSEEN]
    return make_key([*program, *sorted(Path(str(files(KERNELS))).rglob("*.py"))], ())


@cache
def _digest_charting() -> str:
    """Return the digest of the code that draws charts, computed once per process."""
    return make_key(
        [p for p in list_program() if p.relative_to(HERE).parts[0] in CHART_SOURCES], ()
    )


def _key_chart(*parts: str) -> str:
    return make_key((), PACKAGES, _digest_charting(), *parts)


def draw_figure(place: Path, blank: Picture) -> Picture:
    """Draw one figure of a paper; if that fails, give the reason without the folder's path."""
    figure = next(f for f in find_figures(place) if f.name == blank.name)
    try:
        return replace(blank, svg=render_svg(figure))
    except DrawingError as error:
        says = str(error).removeprefix(f"{figure.name}: ")
        return replace(blank, failure=says.replace(f"{place.resolve()}{os.sep}", ""))


def _date(records: Sequence[Record]) -> str:
    days = sorted({record.taken[:10] for record in records})
    return f"{describe_how(records)} {' and '.join(days)}"


def _render(canvas: Canvas, says: str) -> str:
    with mpl.rc_context({**STYLE, "svg.hashsalt": says}):
        return write_svg(canvas, says)
