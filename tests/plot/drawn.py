"""The figures of the papers, each drawn once, and the texts in them."""

from __future__ import annotations

import json
from functools import cache
from importlib import import_module
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from mechproof.plot.canvas import use_style
from mechproof.plot.figures import Figure, draw

# In pixels: boxes of texts may share an edge, and a box has room above and below its letters.
EDGE, ROOM = 0.5, 2.0
# The figures of each system, listed because loading the modules that state them takes seconds.
NAMES = {
    "elliptic_planetary": ("fig-3", "fig-3-rates", "table-3"),
    "oval_planetary": ("fig-2",),
    "tooth_thickness": ("fig-4", "fig-5"),
    "track_wheel": ("scheme", "fig-3", "fig-4", "fig-5", "table-1"),
    "wedge_linkage": ("scheme", "fig-4", "fig-4-set-2"),
}


def pictures(system: str) -> Any:
    """Return the module that states a system's figures."""
    return import_module(f"mechproof.derivations.{system}.pictures")


def load_wedge() -> Any:
    """Return paper 4, whose ranges are certified."""
    return import_module("mechproof.derivations.wedge_linkage").PAPER


@cache
def figures(system: str) -> dict[str, Figure]:
    """Return the figures of a system by their names."""
    return {figure.name: figure for figure in pictures(system).FIGURES}


@cache
def drawn(system: str, name: str) -> Any:
    """Return a figure's canvas."""
    return draw(figures(system)[name])


def lines(panel: Any, label: str) -> Any:
    """Return, in order, the data of the lines of an axes whose labels begin with `label`."""
    return [line.get_xydata() for line in panel.lines if line.get_label().startswith(label)]


def span_of(patch: Any) -> tuple[float, float]:
    """Return the ends of a shaded band in data coordinates."""
    across = patch.get_patch_transform().transform(patch.get_path().vertices)[:, 0]
    return float(across.min()), float(across.max())


def write_texts(canvas: Any) -> dict[Text, Any]:
    """Draw a canvas and return the texts drawn, with their boxes in pixels."""
    boxes: dict[Text, Any] = {}
    kept = Text.draw

    def record(text: Text, renderer: Any) -> None:
        kept(text, renderer)
        if text.get_visible() and text.get_text().strip():
            boxes[text] = text.get_window_extent(renderer)

    with pytest.MonkeyPatch.context() as patch, use_style():
        patch.setattr(Text, "draw", record)
        FigureCanvasAgg(canvas).draw()
    return boxes


def overlaps(boxes: dict[Text, Any]) -> list[tuple[str, str]]:
    """Return pairs of texts whose boxes share more than an edge."""
    found = []
    for (one, a), (two, b) in combinations(boxes.items(), 2):
        wide = min(a.x1, b.x1) - max(a.x0, b.x0)
        high = min(a.y1, b.y1) - max(a.y0, b.y0)
        if wide > EDGE and high > EDGE:
            found.append((one.get_text(), two.get_text()))
    return found


def cut_off(canvas: Any, boxes: dict[Text, Any]) -> list[str]:
    """Return texts that leave the canvas."""
    page = canvas.bbox.padded(EDGE)
    return [
        text.get_text()
        for text, box in boxes.items()
        if box.x0 < page.x0 or box.y0 < page.y0 or box.x1 > page.x1 or box.y1 > page.y1
    ]


def struck(panel: Any, boxes: dict[Text, Any]) -> list[str]:
    """Return texts through which a line of an axes runs."""
    found = []
    for line in panel.lines:
        ends = line.get_transform().transform(np.asarray(line.get_xydata(), float))
        if line.get_linestyle() == "None" or len(ends) < 2:
            continue
        part = np.linspace(0, 1, 20)[:, np.newaxis, np.newaxis]
        points = (ends[:-1] + part * np.diff(ends, axis=0)).reshape(-1, 2)
        for text, box in boxes.items():
            inner = box.padded(-ROOM)
            inside = (points > (inner.x0, inner.y0)) & (points < (inner.x1, inner.y1))
            on_panel = (points >= panel.bbox.p0) & (points <= panel.bbox.p1)
            if np.any(inside.all(axis=1) & on_panel.all(axis=1)):
                found.append(text.get_text())
    return found


@cache
def boxes(system: str, name: str) -> dict[Text, Any]:
    """Return the texts of a figure, with their boxes in pixels."""
    return write_texts(drawn(system, name))


@cache
def words(system: str, name: str) -> str:
    """Return all text of a figure, with ASCII hyphens for minus signs."""
    return "\n".join(text.get_text() for text in boxes(system, name)).replace("\N{MINUS SIGN}", "-")


@cache
def ledger() -> dict[str, dict[str, Any]]:
    """Return the rows of the ledger by system and number."""
    file = Path(__file__).parents[2] / "generated" / "ledger.json"
    rows = json.loads(file.read_text(encoding="utf-8"))["rows"]
    return {f"{row['system']} {row['number']}": row for row in rows}
