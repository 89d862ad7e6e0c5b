"""Pictures: what was measured and what papers have as figures, as SVG that a page can hold."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from io import StringIO
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure as Canvas

from mechproof.lab.chart import STYLE, date_records, draw_chart
from mechproof.lab.marks import collect_marks, list_workloads, write_headline
from mechproof.lab.overview import draw_panels, write_summary
from mechproof.measured import Record
from mechproof.plot.figures import find_figures, render_svg, strip_svg
from mechproof.processes import WorkerError, run_tasks

# Seconds for a picture; beyond, something hangs.
LIMIT = 300.0
SMALL = 7.5
# Points; a column has 241.
NARROW = 300.0


@dataclass(frozen=True)
class Picture:
    """A picture of a page: what it says and how it is drawn, in one element."""

    title: str
    caption: str
    svg: str
    name: str = ""
    number: str = ""
    after: str = ""

    @property
    def is_narrow(self) -> bool:
        """Return whether it is made for one column of a page."""
        width = re.search(r'\bwidth="([\d.]+)pt"', self.svg)
        return width is not None and float(width[1]) < NARROW


class PictureError(RuntimeError):
    """A picture could not be drawn."""


def draw_pictures(
    tasks: Mapping[str, Callable[[], Picture]],
    report: Callable[[str], None] = lambda text: None,
    processes: int | None = None,
) -> dict[str, Picture]:
    """Draw on all processors; `PictureError` names the first that fails."""
    names = list(tasks)
    drawn: dict[str, Picture] = {}
    results = run_tasks(_draw, list(tasks.values()), limit=LIMIT, processes=processes)
    for number, picture in results:
        if isinstance(picture, WorkerError):
            raise PictureError(f"{names[number]}: {picture}")
        drawn[names[number]] = picture
        report(f"{len(drawn)} of {len(names)} pictures: {names[number]}")
    return {name: drawn[name] for name in names}


def _draw(task: Callable[[], Picture]) -> Picture:
    return task()


def list_charts(record: Record) -> dict[str, Callable[[], Picture]]:
    """List the charts of a quantity, one for each workload."""
    return {
        f"{record.quantity}, {workload}": partial(chart, record, workload, count)
        for workload, count in list_workloads(record)
    }


def chart(record: Record, workload: str, count: int) -> Picture:
    """Draw time against error of all ways to compute a quantity."""
    with mpl.rc_context(STYLE):
        canvas = draw_chart(record, workload, count)
    says = write_headline(collect_marks(record, workload, count))
    return Picture(says, f"{workload}; {_date([record])}", _render(canvas, says))


def overview(records: Sequence[Record]) -> Picture:
    """Draw a small panel for each quantity."""
    with mpl.rc_context({**STYLE, "font.size": SMALL}):
        canvas = draw_panels(records)
    says = write_summary(records)
    return Picture(says, _date(records), _render(canvas, says))


def list_figures(place: Path) -> dict[str, Callable[[], Picture]]:
    """List what a paper's folder states of its figures."""
    names = [figure.name for figure in find_figures(place)]
    return {f"{place.stem}, {name}": partial(draw_figure, place, name) for name in names}


def draw_figure(place: Path, name: str) -> Picture:
    """Draw one figure of a paper."""
    figure = next(f for f in find_figures(place) if f.name == name)
    return Picture(
        figure.title,
        figure.caption,
        render_svg(figure),
        figure.name,
        figure.number or "",
        figure.after,
    )


def _date(records: Sequence[Record]) -> str:
    days = date_records(records).removeprefix("measured ").split(", ")
    return f"measured {', '.join(sorted({day[:10] for day in days}))}"


def _render(canvas: Canvas, says: str) -> str:
    text = StringIO()
    with mpl.rc_context({**STYLE, "svg.hashsalt": says}):
        canvas.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
    return strip_svg(text.getvalue(), says)
