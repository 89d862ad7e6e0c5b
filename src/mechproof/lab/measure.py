"""Measure: accuracy, proofs and time of every way of computing a quantity, into one record.

Records report the points of the seed REPORT; the search climbs from those of the seed TUNE.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from typing import Any

import numpy as np

from mechproof.lab.bounds import bound_over
from mechproof.lab.error import find_errors, summarise
from mechproof.lab.machine import describe_machine, find_load
from mechproof.lab.oracle import Truth, count_points, find_truth
from mechproof.lab.points import REPORT, TUNE, PointSet, choose_evenly, draw_points
from mechproof.lab.search import find_worst
from mechproof.lab.sets import draw_in_cell, list_cells, list_sets
from mechproof.lab.sizes import Sides
from mechproof.lab.subject import Subject
from mechproof.lab.timing import FULL, QUICK, Effort, time_subject, time_ufuncs
from mechproof.lab.ways import Arguments, Array, Way
from mechproof.lab.within import mark_within
from mechproof.measured import (
    Cell,
    CellErrors,
    MeasuredWay,
    Point,
    Record,
    Searched,
    SetErrors,
    Span,
    round_off,
    round_up,
)
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Accuracy

# Simulations and solvers are measured on this many points of a set.
SLOW_SAMPLE = 30


@dataclass(frozen=True)
class Depth:
    """How much is measured: at most so many points of a set, rounds of the search, times."""

    points: int | None
    rounds: int
    effort: Effort


DEPTHS = {False: Depth(None, 20, FULL), True: Depth(24, 2, QUICK)}

Report = Callable[[str], None]


def measure(subject: Subject, *, quick: bool = False, report: Report = lambda text: None) -> Record:
    """Return the record of one quantity: its ways, errors on sets and in cells, search, times."""
    depth, accuracy = DEPTHS[quick], subject.quantity.accuracy
    report("proofs")
    ways = describe_ways(subject)
    errors: list[SetErrors] = []
    for point_set in list_sets(subject):
        report(f"accuracy, {point_set.name}")
        errors += _measure_set(subject, point_set, depth)
    report("cells")
    cells, cell_errors, ranges = _measure_cells(subject, depth)
    report("search")
    searched = _search(subject, depth)
    report("time")
    return Record(
        quantity=subject.name,
        unit=subject.quantity.unit,
        taken=datetime.now(UTC).isoformat(timespec="seconds"),
        quick=quick,
        machine=describe_machine(),
        load=find_load(),
        seeds={"tune": TUNE, "report": REPORT},
        scale=_name_scale(accuracy),
        bound=float(accuracy.ulp) if accuracy else None,
        typical=list_sets(subject)[0].name,
        ranges=ranges,
        searched=searched,
        ufuncs=time_ufuncs(),
        ways=ways,
        sets=tuple(errors),
        cells=tuple(cells),
        cell_errors=tuple(cell_errors),
        times=tuple(time_subject(subject, depth.effort)),
    )


def _name_scale(accuracy: Accuracy | None) -> str:
    if accuracy is None:
        return ""
    return accuracy.scale.name if accuracy.scale else "the value"


def describe_ways(subject: Subject) -> tuple[MeasuredWay, ...]:
    """Describe every way; what the ledger's rows say of its source is decided here."""
    return tuple(_describe(subject, way) for way in subject.ways)


def _describe(subject: Subject, way: Way) -> MeasuredWay:
    bound = "" if way.bound is None else str(way.bound)
    about = MeasuredWay(
        way.name,
        way.kind,
        bound=bound,
        ordered=way.ordered,
        key=way.key,
        note=way.note,
    )
    if not way.rows:
        return about
    judged = [judge(row, subject.paper) for row in way.rows]
    worst = next((j for j in judged if j.verdict is not Verdict.PROVED), judged[-1])
    parts = {row.on.text for row in way.rows if row.on} if way.kind == "form" else set()
    return replace(
        about, verdict=worst.verdict.value, rung=worst.rung, proved_on="; ".join(sorted(parts))
    )


def _measure_set(subject: Subject, point_set: PointSet, depth: Depth) -> list[SetErrors]:
    """Measure every way on one set; an ordered one is measured on ordered sets only."""
    arguments = draw_points(point_set, REPORT)
    if not point_set.ordered:
        arguments = _thin(subject, arguments, depth.points)
    truth = find_truth(subject, arguments)
    held = mark_within(subject, arguments)
    return [
        _measure_way(subject, way, point_set, arguments, truth, held)
        for way in subject.ways
        if way.ordered <= point_set.ordered
    ]


def _measure_way(
    subject: Subject,
    way: Way,
    point_set: PointSet,
    arguments: Arguments,
    truth: Truth,
    held: Array,
) -> SetErrors:
    if way.slow and not point_set.ordered:
        chosen = choose_evenly(len(truth.high), SLOW_SAMPLE)
        arguments, truth, held = _take(subject, arguments, chosen), truth[chosen], held[chosen]
    with np.errstate(all="ignore"):
        errors = find_errors(way.compute(*arguments), truth)
    found = summarise(errors, truth, subject.period)
    # The accuracy bound speaks of these points only.
    inside = errors.scaled[held & truth.decided]
    keeps_point = way is subject.ways[0] and truth.decided.any()
    return SetErrors(
        set=point_set.name,
        way=way.name,
        points=found.points,
        undecided=found.undecided,
        nan=found.nan,
        infinite=found.infinite,
        wrong_branch=found.wrong_branch,
        worst_ulp=round_up(found.worst_ulp),
        mean_ulp=round_off(found.mean_ulp),
        mean_bits=round_off(found.mean_bits),
        worst_absolute=round_up(found.worst_absolute),
        worst_scaled=round_up(float(np.max(inside))) if inside.size else None,
        worst_at=_point(subject, arguments, found.worst_point) if keeps_point else None,
    )


def _measure_cells(
    subject: Subject, depth: Depth
) -> tuple[list[Cell], list[CellErrors], dict[str, Span]]:
    """Measure every single-point way in cells of sizes: largest absolute error and bound."""
    cells: list[Cell] = []
    errors: list[CellErrors] = []
    spans: list[list[Span]] = []
    for place, sides in enumerate(list_cells(subject)):
        arguments = draw_in_cell(subject, np.random.default_rng([REPORT, place]), sides)
        arguments = _thin(subject, arguments, depth.points)
        truth = find_truth(subject, arguments)
        spans.append([_span(a) for a in arguments])
        named = {name: (float(low), float(high)) for name, (low, high) in sides.items()}
        cells.append(Cell(named, len(truth.high), truth.undecided))
        errors += (
            _measure_cell(subject, way, arguments, truth, (place, sides))
            for way in subject.ways
            if not way.ordered
        )
    return cells, errors, _find_ranges(subject, spans)


def _find_ranges(subject: Subject, spans: list[list[Span]]) -> dict[str, Span]:
    """Return the sizes measured: the edges of the cells, and what else the points spanned."""
    if not spans:
        return {}
    lows, highs = np.min(spans, axis=0)[:, 0], np.max(spans, axis=0)[:, 1]
    names = [argument.name for argument in subject.quantity.arguments]
    found = {n: (float(lo), float(hi)) for n, lo, hi in zip(names, lows, highs, strict=True)}
    usual = {a.name: a.usual for a in subject.quantity.arguments if len(a.usual) > 1}
    edges = {name: (float(sizes[0]), float(sizes[-1])) for name, sizes in usual.items()}
    return {**found, **edges}


def _measure_cell(
    subject: Subject,
    way: Way,
    arguments: Arguments,
    truth: Truth,
    cell: tuple[int, Sides],
) -> CellErrors:
    place, sides = cell
    if way.slow:
        chosen = choose_evenly(len(truth.high), SLOW_SAMPLE)
        arguments, truth = _take(subject, arguments, chosen), truth[chosen]
    with np.errstate(all="ignore"):
        found = summarise(find_errors(way.compute(*arguments), truth), truth)
    bound = bound_over(subject, way, sides)
    return CellErrors(
        cell=place,
        way=way.name,
        worst=round_up(found.worst_absolute),
        bound=None if bound is None else round_up(bound),
        lost=found.nan + found.infinite,
    )


def _search(subject: Subject, depth: Depth) -> Searched:
    found = find_worst(subject, subject.kernel, depth.rounds)
    return Searched(round_up(found.scaled), found.tried, _as_point(found.arguments))


def _span(argument: Array) -> Span:
    """Return the least and the largest size; numbers of both signs enclose zero."""
    size = np.abs(argument)
    least = 0.0 if np.min(argument) < 0 < np.max(argument) else float(np.min(size))
    return least, float(np.max(size))


def _thin(subject: Subject, arguments: Arguments, wanted: int | None) -> Arguments:
    return _take(subject, arguments, choose_evenly(count_points(subject, arguments), wanted))


def _take(subject: Subject, arguments: Arguments, chosen: Any) -> Arguments:
    """Take some of the points, or one; what all points share stays as it is."""
    count = count_points(subject, arguments)
    return tuple(a[chosen] if np.shape(a)[:1] == (count,) else a for a in arguments)


def _point(subject: Subject, arguments: Arguments, index: int) -> Point:
    return _as_point(_take(subject, arguments, index))


def _as_point(arguments: Arguments) -> Point:
    """Return one point as numbers that read back to the same doubles."""
    return tuple(_as_numbers(np.asarray(a, float).tolist()) for a in arguments)


def _as_numbers(value: Any) -> Any:
    return tuple(map(_as_numbers, value)) if isinstance(value, list) else value
