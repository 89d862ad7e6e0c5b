"""A panel of a chart: marks by family, the Pareto front and the lanes.

Labels are placed next to the points where there is room.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from matplotlib.transforms import Bbox

from mechproof.lab.chart_points import (
    LOST_LANE,
    TURNS_LANE,
    ChartPoint,
    Family,
    find_best,
    find_front,
)

# The digits of a double, and the height of a lane in digits.
DIGITS, LANE = 15.65, 2.4
LOWEST = -2.6
UNREACHED = "0.9"
LANES = ("no digit right,\nNaN, infinity", "wrong by\nwhole turns")
SHORT_LANES = ("no digit", "turns")


@dataclass(frozen=True)
class MarkerStyle:
    """How a family is drawn: distinguished by shape, and by lightness when printed in grey."""

    says: str
    marker: str
    face: str
    size: float = 8


LOOKS: Mapping[Family, MarkerStyle] = {
    "shipped": MarkerStyle("shipped here", "s", "#08306b", 9),
    "written": MarkerStyle("what people write", "o", "#e6550d"),
    "installed": MarkerStyle("what they install", "^", "#74c4e8"),
    "approximate": MarkerStyle("approximations with a proved bound", "D", "#fff7bc", 7),
}


def draw_panel(
    axes: Any, marks: Sequence[ChartPoint], copy: float | None, width: float = 1.3
) -> None:
    """Draw the front, the lanes and the time of a copy, within the time limits already set."""
    axes.set(xscale="log", ylim=(LOWEST, find_top(marks)))
    axes.grid(which="major", color="0.93", lw=0.6)
    for lane in (LOST_LANE, TURNS_LANE):
        axes.axhline(lane - LANE / 2, color="0.4", lw=0.6)
    if copy is not None:
        axes.axvline(copy, color="0.35", ls=":", lw=width)
    _draw_front(axes, find_front(marks), width)


def find_top(marks: Sequence[ChartPoint]) -> float:
    """Return the upper end of the axis, which includes the lane of whole turns only if needed."""
    highest = TURNS_LANE if any(mark.turns for mark in marks) else LOST_LANE
    return highest + LANE / 2


def draw_mark(axes: Any, mark: ChartPoint, size: float) -> None:
    """Draw one mark in the look of its family."""
    look = LOOKS[mark.family]
    axes.plot(
        mark.time, mark.height, look.marker, color="k", markerfacecolor=look.face,
        ms=look.size * size, mew=0.7 * size, zorder=2 + size,
    )  # fmt: skip


def trace_front(axes: Any, front: Sequence[ChartPoint]) -> tuple[list[float], list[float]]:
    """Return the corners of the front, from its fastest mark to the end of the axis."""
    end = axes.get_xlim()[1]
    return [*(m.time for m in front), end], [*(m.height for m in front), front[-1].height]


def _draw_front(axes: Any, front: Sequence[ChartPoint], width: float) -> None:
    """Draw the front as a step, and shade what no way reaches: faster and more accurate."""
    if not front:
        return
    times, heights = trace_front(axes, front)
    top = LOST_LANE - LANE / 2
    start = [axes.get_xlim()[0], times[0]]
    axes.fill_between(start, LOWEST, top, color=UNREACHED, lw=0, zorder=0)
    axes.fill_between(times, LOWEST, heights, step="post", color=UNREACHED, lw=0, zorder=0)
    axes.step([times[0], *times], [top, *heights], "k-", where="post", lw=width, zorder=2)


def set_ticks(axes: Any, marks: Sequence[ChartPoint], right: bool = True) -> None:
    """Label errors in eps and the lanes on the left, and correct digits on the right.

    Without the labels on the right the panel is a small one: labels are fewer, and one line each.
    """
    powers = {float(n): f"$10^{{{n}}}$" if n else "1" for n in range(0, 15, 3 if right else 6)}
    names = LANES if right else SHORT_LANES
    lanes = dict(zip((LOST_LANE, TURNS_LANE), names, strict=True))
    ticks = powers | {lane: text for lane, text in lanes.items() if lane < find_top(marks)}
    axes.set_ylim(LOWEST, find_top(marks))
    axes.set_yticks(list(ticks), list(ticks.values()))
    if right:
        digits = range(16, 0, -3)
        other = axes.secondary_yaxis("right")
        other.set_yticks([DIGITS - digit for digit in digits], [str(digit) for digit in digits])
        other.set_ylabel("digits right")


Spot = tuple[float, float]
TIMES = "\N{MULTIPLICATION SIGN}"
SIGNS = {
    "<=": "≤",
    ">=": "≥",
    " * ": "·",
    " - ": "\N{NO-BREAK SPACE}\N{MINUS SIGN}\N{NO-BREAK SPACE}",
}
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
# More names than this crowd a panel.
NAMES = 12
# Relative size of marks without names, and the least distance in pixels between two marks that
# both get names.
SMALL, APART = 0.6, 16
# Where a name may be placed: the shift of its box from its mark in points, and the part of its
# width and height that it is shifted by, nearest first.
PLACES = [
    (reach * dx, reach * dy, fx, fy)
    for reach in (8, 13, 18, 24, 32)
    for dx, dy, fx, fy in (
        (1, 0, 0, -0.5), (-1, 0, -1, -0.5), (0.7, 0.8, 0, 0), (0.7, -0.8, 0, -1),
        (-0.7, 0.8, -1, 0), (-0.7, -0.8, -1, -1), (0, 1, -0.5, 0), (0, -1, -0.5, -1),
    )
]  # fmt: skip


def choose_names(marks: Sequence[ChartPoint], spots: Mapping[ChartPoint, Spot]) -> list[ChartPoint]:
    """Order the marks to be named: the shipped way, the front, two of each family, then far ones.

    `spots` are places in pixels; marks too close to an earlier one are left out.
    """
    chosen = list(dict.fromkeys([marks[0], *find_front(marks), *find_best(marks, 2)]))
    rest = [mark for mark in marks if mark not in chosen]
    while rest:
        gaps = [min(math.dist(spots[mark], spots[other]) for other in chosen) for mark in rest]
        if max(gaps) < APART:
            break
        chosen.append(rest.pop(gaps.index(max(gaps))))
    return chosen


def set_signs(text: str) -> str:
    """Typeset relations, products and powers, with no line break around a minus sign."""
    for typed, written in SIGNS.items():
        text = text.replace(typed, written)
    raised = re.sub(r"\*\*(-?\d+)", lambda power: power[1].translate(RAISED), text)
    return re.sub(r"(?<=[\w)|])\*(?=[\w(|])", "·", re.sub(r"pi", "π", raised))


def name_marks(
    axes: Any,
    marks: Sequence[ChartPoint],
    count: int,
    copy: float | None,
    proved: Mapping[str, str],
) -> list[ChartPoint]:
    """Draw marks after the layout, with names where there is room; return the named marks.

    The others are drawn small. `proved` has texts about proved bounds, by the names of ways.
    """
    spots = {mark: _as_spot(axes.transData.transform((mark.time, mark.height))) for mark in marks}
    room = Room(axes, [_box_around(spot, spot, 7) for spot in spots.values()])
    room.taken += _list_lines(axes, find_front(marks), copy)
    room.taken += [text.get_window_extent().padded(2) for text in axes.texts]
    named: list[ChartPoint] = []
    for mark in choose_names(marks, spots):
        label = write_name(mark, marks[0], count)
        if mark.name in proved:
            label += f", {proved[mark.name]}"
        is_first = mark is marks[0]
        if len(named) < NAMES and room.write(spots[mark], _find_band(axes, mark), label, is_first):
            named.append(mark)
    for mark in marks:
        draw_mark(axes, mark, 1 if mark in named else SMALL)
    return named


def write_name(mark: ChartPoint, shipped: ChartPoint, count: int) -> str:
    """Return the name of a way and its time relative to the shipped way.

    The size that it was timed at is added if it differs from `count`.
    """
    size = "" if mark.count == count else f", N = {mark.count:,}"
    if mark is shipped:
        return set_signs(mark.name) + size
    ratio = mark.time / shipped.time
    told = f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.2g}"
    return f"{set_signs(mark.name)} ({told}{TIMES}{size})"


@dataclass
class Room:
    """The occupied boxes of a panel, in pixels: of marks and lines, and of names and their ties."""

    axes: Any
    taken: list[Bbox]
    names: list[Bbox] = field(default_factory=list)

    def write(self, spot: Spot, band: Spot, label: str, is_bold: bool) -> bool:
        """Write a text at the nearest free place in a band of heights, tied to its spot."""
        text = self.axes.annotate(
            label, self._find_place(*spot), xycoords="axes fraction",
            xytext=self._find_place(*spot), textcoords="axes fraction",
            fontsize=8, weight="bold" if is_bold else "normal", zorder=4,
            arrowprops={"arrowstyle": "-", "color": "0.4", "lw": 0.6, "shrinkA": 0, "shrinkB": 3},
        )  # fmt: skip
        extent = text.get_window_extent()
        for box in _find_places(spot, extent, self.axes.figure.dpi / 72):
            tie = _trace_tie(spot, box)
            if self._is_free(box, band, tie):
                text.set_position(self._find_place(box.x0, box.y0))
                self.names += [box, *tie]
                return True
        text.remove()
        return False

    def _find_place(self, x: float, y: float) -> Spot:
        """Return a place in fractions of the panel, which do not depend on the resolution."""
        return _as_spot(self.axes.transAxes.inverted().transform((x, y)))

    def _is_free(self, box: Bbox, band: Spot, tie: Sequence[Bbox]) -> bool:
        inside = self.axes.bbox.x0 < box.x0 and box.x1 < self.axes.bbox.x1
        inside = inside and band[0] < box.y0 and box.y1 < band[1]
        clear = not any(box.overlaps(other) for other in [*self.taken, *self.names])
        return inside and clear and not any(t.overlaps(b) for t in tie for b in self.names)


def _find_band(axes: Any, mark: ChartPoint) -> Spot:
    """Return the heights between which a name may be placed: not in a lane of other marks."""
    lost, turns = LOST_LANE - LANE / 2, TURNS_LANE - LANE / 2
    band = (turns, find_top([mark])) if mark.turns else (LOWEST, lost if mark.has_digits else turns)
    low, high = (axes.transData.transform((mark.time, height))[1] for height in band)
    return float(low), float(high)


def _trace_tie(spot: Spot, box: Bbox) -> list[Bbox]:
    """Return small boxes along the line from a spot to the middle of a text, up to its edge."""
    x, y = (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2
    parts = [n / 20 for n in range(1, 20)]
    line = [(spot[0] + part * (x - spot[0]), spot[1] + part * (y - spot[1])) for part in parts]
    return [_box_around(point, point, 2) for point in line if not box.contains(*point)]


def _find_places(spot: Spot, extent: Bbox, pixels: float) -> Iterator[Bbox]:
    """Yield the boxes that a text may fill, nearest first."""
    for dx, dy, fx, fy in PLACES:
        left = spot[0] + dx * pixels + fx * extent.width
        low = spot[1] + dy * pixels + fy * extent.height
        yield Bbox.from_bounds(left, low, extent.width, extent.height)


def _list_lines(axes: Any, front: Sequence[ChartPoint], copy: float | None) -> list[Bbox]:
    """Return boxes around the front, the borders of the lanes and the time of a copy."""
    lost, turns = LOST_LANE - LANE / 2, TURNS_LANE - LANE / 2
    lines = [[(end, lane) for end in axes.get_xlim()] for lane in (lost, turns)]
    if copy is not None:
        lines.append([(copy, end) for end in axes.get_ylim()])
    if front:
        times, heights = trace_front(axes, front)
        corners = [(times[0], lost), (times[0], heights[0])]
        for time, height in zip(times[1:], heights[1:], strict=True):
            corners += [(time, corners[-1][1]), (time, height)]
        lines += [[one, two] for one, two in pairwise(corners)]
    ends = [[_as_spot(axes.transData.transform(point)) for point in line] for line in lines]
    return [_box_around(one, two, 1) for one, two in ends]


def _as_spot(point: Sequence[float]) -> Spot:
    return float(point[0]), float(point[1])


def _box_around(one: Spot, two: Spot, reach: float) -> Bbox:
    (left, right), (low, high) = (sorted(ends) for ends in zip(one, two, strict=True))
    return Bbox.from_extents(left - reach, low - reach, right + reach, high + reach)
