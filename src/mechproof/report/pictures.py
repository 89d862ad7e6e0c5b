"""Pictures: what was measured and what papers have as figures, as SVG that a page can hold."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure as Canvas

from mechproof.lab.chart import STYLE, date_records, draw_chart, write_title
from mechproof.lab.chart_points import list_workloads
from mechproof.lab.overview import draw_panels, write_summary
from mechproof.measured import Record
from mechproof.plot.figures import DrawingError, find_figures, render_svg, write_svg
from mechproof.processes import WorkerError, run_tasks

# Seconds for a picture; beyond, something hangs.
LIMIT = 300.0
SMALL = 7.5
# Points; a column has 241.
NARROW = 300.0
OVERVIEW = "overview"


@dataclass(frozen=True)
class Picture:
    """A picture of a page: what it says and how it is drawn, in one element.

    One that could not be drawn has the `failure` instead of the element.
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
    """A picture that is to be drawn, and what stands in its place if it hangs or crashes."""

    draw: Callable[[], Picture]
    blank: Picture


def draw_pictures(
    tasks: Mapping[str, PictureTask],
    report: Callable[[str], None] = lambda text: None,
) -> dict[str, Picture]:
    """Draw on all processors; what fails is a picture with its failure."""
    names = list(tasks)
    drawn: dict[str, Picture] = {}
    calls = [task.draw for task in tasks.values()]
    for number, picture in run_tasks(_call, calls, limit=LIMIT):
        name = names[number]
        if isinstance(picture, WorkerError):
            picture = replace(tasks[name].blank, failure=str(picture))
        drawn[name] = picture
        report(f"{len(drawn)} of {len(names)} pictures: {name}")
    return {name: drawn[name] for name in names}


def _call(draw: Callable[[], Picture]) -> Picture:
    return draw()


def list_charts(record: Record) -> dict[str, PictureTask]:
    """List the charts of a quantity, one for each workload."""
    return {
        f"{record.quantity}, {workload}": PictureTask(
            partial(chart, record, workload, count), Picture(record.quantity, workload, "")
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
    """List the picture of all quantities where there are several."""
    if len(records) < 2:
        return {}
    return {OVERVIEW: PictureTask(partial(overview, records), Picture("All quantities", "", ""))}


def overview(records: Sequence[Record]) -> Picture:
    """Draw a small panel for each quantity."""
    with mpl.rc_context({**STYLE, "font.size": SMALL}):
        canvas = draw_panels(records)
    says = write_summary(records)
    return Picture(says, _date(records), _render(canvas, says))


def list_figures(place: Path) -> dict[str, PictureTask]:
    """List what a paper's folder states of its figures."""
    blanks = [
        Picture(figure.title, figure.caption, "", figure.name, figure.number or "", figure.after)
        for figure in find_figures(place)
    ]
    return {
        f"{place.stem}, {blank.name}": PictureTask(partial(draw_figure, place, blank), blank)
        for blank in blanks
    }


def draw_figure(place: Path, blank: Picture) -> Picture:
    """Draw one figure of a paper; where that fails, say it without the place of the folder."""
    figure = next(f for f in find_figures(place) if f.name == blank.name)
    try:
        return replace(blank, svg=render_svg(figure))
    except DrawingError as error:
        says = str(error).removeprefix(f"{figure.name}: ")
        return replace(blank, failure=says.replace(f"{place.resolve()}{os.sep}", ""))


def _date(records: Sequence[Record]) -> str:
    days = date_records(records).removeprefix("measured ").split(", ")
    return f"measured {', '.join(sorted({day[:10] for day in days}))}"


def _render(canvas: Canvas, says: str) -> str:
    with mpl.rc_context({**STYLE, "svg.hashsalt": says}):
        return write_svg(canvas, says)
