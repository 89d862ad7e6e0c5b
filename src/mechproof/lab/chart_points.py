"""Points of a chart: time and error from a record, the Pareto front, and a headline.

Herbie has shown its rewrites as accuracy against cost with the front since Saiki et al. (2021);
here both are measured, the cost on a named machine.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from mechproof.measured import COPY, MeasuredWay, Record, Timing

Family = Literal["shipped", "written", "installed", "approximate"]
FAMILIES: tuple[Family, ...] = ("shipped", "written", "installed", "approximate")
# Zero has no place on a logarithmic axis: errors below this, in eps, are drawn here.
SMALLEST_ERROR = 0.1
# With an error of a tenth of the scale no digit is right, however large the error.
NO_DIGIT = 0.1 / 2.0**-52
# Heights, in digits lost, of the two lanes for results without an error in eps.
LOST_LANE, TURNS_LANE = 16.2, 18.6
# The largest number of points per call that is drawn: both caches and pages matter there.
LARGEST = 100_000
# Errors below this are given in eps, larger ones in digits lost.
FEW_EPS = 1000


@dataclass(frozen=True)
class ChartPoint:
    """A way on the chart: nanoseconds per point in calls of `count`, and its worst error.

    `error` is scaled (`Record.error_unit`), infinite if a result with a bound is lost; `turns` says
    that some result is wrong by whole turns.
    """

    name: str
    family: Family
    time: float
    error: float
    turns: bool
    count: int

    @property
    def has_digits(self) -> bool:
        """Return whether every result has a correct digit."""
        return not self.turns and self.error < NO_DIGIT

    @property
    def height(self) -> float:
        """Return the digits lost, or the lane of results without a correct digit."""
        if self.turns:
            return TURNS_LANE
        return math.log10(max(self.error, SMALLEST_ERROR)) if self.has_digits else LOST_LANE

    def describe_error(self) -> str:
        """Return a verb phrase with the worst loss that was measured."""
        if self.turns:
            return "is somewhere wrong by whole turns"
        if not self.has_digits:
            return "somewhere has no digit right"
        if self.error < FEW_EPS:
            told = f"{self.error:.0f}" if self.error >= 10 else f"{self.error:.2g}"
            return f"is off by {told} eps at worst on these points"
        return f"loses {int(math.log10(self.error))} digits"


def list_workloads(record: Record) -> list[tuple[str, int]]:
    """Return the workloads, each with the largest size that is drawn."""
    sizes: dict[str, int] = {}
    for row in record.times:
        if row.count <= LARGEST:
            sizes[row.workload] = max(row.count, sizes.get(row.workload, 0))
    return list(sizes.items())


def find_usual_set(record: Record) -> str:
    """Return the set on which most ways were measured, the typical one if it is among them."""
    names = [errors.set for errors in record.sets]
    return max(dict.fromkeys(names), key=lambda name: (names.count(name), name == record.typical))


def collect_marks(record: Record, workload: str, count: int, only: str = "") -> list[ChartPoint]:
    """Pair time and error on one point set, or on all; the shipped way comes first.

    For all sets, ways not measured on every set of the shipped way are left out.
    """
    wanted = {only} if only else {row.set for row in record.errors_of(record.ways[0].name)}
    marks = (_make_mark(record, way, workload, count, wanted) for way in record.ways)
    return [mark for mark in marks if mark is not None]


def _make_mark(
    record: Record, way: MeasuredWay, workload: str, count: int, wanted: set[str]
) -> ChartPoint | None:
    rows = [row for row in record.errors_of(way.name) if row.set in wanted]
    errors = [row.worst_scaled for row in rows if row.worst_scaled is not None]
    found = find_time(record, way.name, workload, count)
    if found is None or not errors or {row.set for row in rows} != wanted:
        return None
    turns = any(row.wrong_branch > _count_small_turns(record, row.set) for row in rows)
    family, worst = _find_family(record, way), max(errors)
    return ChartPoint(way.name, family, found.median, worst, turns, found.count)


def _count_small_turns(record: Record, name: str) -> int:
    """Return the most wrong branches of an accurate way: there a turn is just a few eps."""
    accurate = (
        row.wrong_branch
        for row in record.sets
        if row.set == name and row.worst_scaled is not None and row.worst_scaled < FEW_EPS
    )
    return max(accurate, default=0)


def _find_family(record: Record, way: MeasuredWay) -> Family:
    if way.kind == "kernel" or way.name.partition(",")[0] == record.ways[0].name:
        return "shipped"
    if way.kind == "peer":
        return "installed"
    return "approximate" if way.bound else "written"


def find_time(record: Record, way: str, workload: str, count: int) -> Timing | None:
    """Return the time at this size, or at the largest smaller size that was timed."""
    rows = (r for r in record.times if (r.way, r.workload) == (way, workload) and r.count <= count)
    return max(rows, key=lambda row: row.count, default=None)


def find_copy(record: Record, workload: str, count: int) -> float | None:
    """Return the time for copying the result, in nanoseconds per point."""
    found = find_time(record, COPY, workload, count)
    return found.median if found else None


def find_front(marks: Sequence[ChartPoint]) -> list[ChartPoint]:
    """Return the marks that no other beats in both time and error, fastest first.

    A mark without a correct digit is not among them.
    """
    front: list[ChartPoint] = []
    for mark in sorted(marks, key=lambda m: (m.time, m.error)):
        if mark.has_digits and (not front or mark.error < front[-1].error):
            front.append(mark)
    return front


def find_best(marks: Sequence[ChartPoint], most: int = 1) -> list[ChartPoint]:
    """Return the most accurate marks of each family, the faster of equals; the shipped one first.

    The first mark alone represents its family.
    """
    best = [marks[0]]
    for family in FAMILIES[1:]:
        best += sorted((mark for mark in marks if mark.family == family), key=rank)[:most]
    return best


def rank(mark: ChartPoint) -> tuple[float, float]:
    """Return a sort key: first what is lost, then time."""
    return (mark.height, mark.time)


def write_eps(error: float) -> str:
    """Write an error in eps to three significant digits, or as an integer from 1000 to 10^6."""
    return f"{error:.0f}" if 1000 <= error < 1e6 else f"{error:.3g}"


def write_headline(marks: Sequence[ChartPoint], searched: float = 0.0) -> str:
    """Return a sentence that compares the first mark, the shipped way, with the others.

    `searched` is the worst error in eps that a search found for it, mentioned if it is larger.
    """
    shipped, others = marks[0], [mark for mark in marks if mark.family != "shipped"]
    subject = "The shipped kernel" if shipped.name == "kernel" else shipped.name
    seen = shipped.describe_error()
    if shipped.has_digits and searched > shipped.error:
        seen += f" ({write_eps(searched)} eps by search)"
    if not others:
        return f"{subject} {seen}"
    best = min(others, key=rank)
    if best.error < shipped.error and best.has_digits:
        accuracy = f"{seen}, {best.name} by {best.error:.2g}"
    elif (best.height, best.error) == (shipped.height, shipped.error):
        equal = (
            "the only other way" if len(others) == 1 else f"the best of {len(others)} other ways"
        )
        accuracy = f"{seen}, as {_name_auxiliary(seen)} {equal}"
    else:
        accuracy = f"{seen}, the least of {1 + len(others)} ways"
    return f"{subject} {accuracy}; {_compare_times(shipped, others)}"


def _name_auxiliary(said: str) -> str:
    """Return the auxiliary verb that stands in for a phrase's verb: is off, as is another."""
    verb = next(word for word in said.split() if word in ("is", "has", "loses"))
    return "does" if verb == "loses" else verb


def _compare_times(shipped: ChartPoint, others: Sequence[ChartPoint]) -> str:
    faster = [mark for mark in others if mark.time < shipped.time]
    if not faster:
        return "none is faster"
    best = min(faster, key=rank)
    if len(faster) == 1:
        return f"the only faster other {best.describe_error()}"
    if not best.has_digits:
        kinds = {True: "whole turns", False: "every digit"}
        found = {mark.turns for mark in faster}
        lost = " or ".join(text for turns, text in kinds.items() if turns in found)
        return f"each of the {len(faster)} faster others somewhere loses {lost}"
    return f"the best of the {len(faster)} faster others {best.describe_error()}"
