"""A panel of a chart: marks by family, the Pareto front and the lanes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mechproof.lab.chart_points import LOST_LANE, TURNS_LANE, ChartPoint, Family, find_front

# Digits of a double, and how high a lane is.
DIGITS, LANE = 15.65, 2.4
LOWEST = -2.6
UNREACHED = "0.9"
LANES = ("no digit right,\nNaN, infinity", "wrong by\nwhole turns")
SHORT_LANES = ("no digit", "turns")


@dataclass(frozen=True)
class MarkerStyle:
    """How a family is drawn: told apart by shape, and by lightness where it is printed in grey."""

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
    """Draw the front, the lanes and the time of a copy, between the ends of time that are set."""
    axes.set(xscale="log", ylim=(LOWEST, find_top(marks)))
    axes.grid(which="major", color="0.93", lw=0.6)
    for lane in (LOST_LANE, TURNS_LANE):
        axes.axhline(lane - LANE / 2, color="0.4", lw=0.6)
    if copy is not None:
        axes.axvline(copy, color="0.35", ls=":", lw=width)
    _draw_front(axes, find_front(marks), width)


def find_top(marks: Sequence[ChartPoint]) -> float:
    """Return the upper end of the axis; the lane of whole turns is there if it is needed."""
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
    """Return the corners of the front from its fastest to the end of the axis."""
    end = axes.get_xlim()[1]
    return [*(m.time for m in front), end], [*(m.height for m in front), front[-1].height]


def _draw_front(axes: Any, front: Sequence[ChartPoint], width: float) -> None:
    """Draw the front as a step; what is faster and more accurate was not reached, and is shaded."""
    if not front:
        return
    times, heights = trace_front(axes, front)
    top = LOST_LANE - LANE / 2
    start = [axes.get_xlim()[0], times[0]]
    axes.fill_between(start, LOWEST, top, color=UNREACHED, lw=0, zorder=0)
    axes.fill_between(times, LOWEST, heights, step="post", color=UNREACHED, lw=0, zorder=0)
    axes.step([times[0], *times], [top, *heights], "k-", where="post", lw=width, zorder=2)


def set_ticks(axes: Any, marks: Sequence[ChartPoint], right: bool = True) -> None:
    """Label errors in eps and the lanes at the left, and the digits that are right at the right.

    Without the right the panel is a small one: labels are fewer, and of a line each.
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
