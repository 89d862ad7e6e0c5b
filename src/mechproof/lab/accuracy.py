"""Accuracy: every way on every point set and in every cell, and the search for the worst input.

The parts are measured separately, in this process or by the workers of an executor.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any

import numpy as np

from mechproof.executors import BALLS, run_in_order
from mechproof.lab.oracle import Truth, count_points, find_errors, find_truth, summarise
from mechproof.lab.sampling.named_sets import REPORT, PointSet, choose_evenly, draw_points, join
from mechproof.lab.sampling.point_sets import draw_in_cell, list_cells, list_sets
from mechproof.lab.sampling.usual_sizes import Sides
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Way
from mechproof.lab.worst_search import (
    bound_approximation,
    draw_sets,
    find_worst,
    mark_accuracy_domain,
    scaled_errors,
)
from mechproof.measured import (
    Cell,
    CellErrors,
    Point,
    Searched,
    SetErrors,
    Span,
    round_off,
    round_up,
)

# Simulations and solvers are measured on this many points of a set.
SLOW_SAMPLE = 30
# Share of every set that is drawn if only some of its points are wanted.
PART = 0.1

Report = Callable[[str], None]


@dataclass(frozen=True)
class Accuracies:
    """Errors on point sets and in cells, the sizes measured, and the worst inputs found."""

    sets: tuple[SetErrors, ...]
    cells: tuple[Cell, ...]
    cell_errors: tuple[CellErrors, ...]
    ranges: dict[str, Span]
    searched: tuple[Searched, ...]


def measure_accuracy(
    subject: Subject,
    points: int | None,
    rounds: int,
    report: Report,
    executor: Executor | None,
    known: Sequence[Point] = (),
) -> Accuracies:
    """Measure on at most `points` points of a set, and search for `rounds` rounds.

    `known` bad inputs count unless a worse one is found. The result does not depend on the
    executor; an executor of processes needs a subject found by `find_subjects`.
    """
    sets, cells, shipped = map(len, (list_sets(subject), list_cells(subject), subject.shipped))
    # The searches take longest, so they start first.
    tasks: list[Callable[[], Any]] = [
        partial(_search, subject, i, points, rounds) for i in range(shipped)
    ]
    tasks += [partial(_measure_set, subject, index, points) for index in range(sets)]
    tasks += [partial(_measure_cell, subject, place, points) for place in range(cells)]
    done: list[Any] = []
    report(f"accuracy, {len(tasks)} parts")
    for result in run_in_order(_call, tasks, executor, batch=1):
        done.append(result)
        report(f"accuracy, {len(done)} of {len(tasks)} parts")
    searched, on_sets = done[:shipped], done[shipped : shipped + sets]
    in_cells = done[shipped + sets :]
    return Accuracies(
        sets=tuple(errors for found in on_sets for errors in found),
        cells=tuple(cell for cell, _, _ in in_cells),
        cell_errors=tuple(errors for _, found, _ in in_cells for errors in found),
        ranges=_find_ranges(subject, [spans for _, _, spans in in_cells]),
        searched=keep_worst(subject, searched, known),
    )


def _call(task: Callable[[], Any]) -> Any:
    with BALLS:
        return task()


def _measure_set(subject: Subject, index: int, points: int | None) -> list[SetErrors]:
    """Measure every way on one set; ways for ordered points are measured on ordered sets only."""
    point_set = list_sets(subject)[index]
    arguments = draw_points(point_set, REPORT)
    if not point_set.ordered:
        arguments = _thin(subject, arguments, points)
    truth = find_truth(subject, arguments)
    held = mark_accuracy_domain(subject, arguments)
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
    found = summarise(errors, truth, subject.period, point_set.name, way.name)
    # The accuracy bound is stated for these points only.
    inside = errors.scaled[held & truth.decided]
    keeps_point = way is subject.ways[0] and truth.decided.any()
    worst = int(np.argmax(np.where(truth.decided, errors.scaled, -1.0)))
    return replace(
        found,
        worst_ulp=round_up(found.worst_ulp),
        mean_ulp=round_off(found.mean_ulp),
        mean_bits=round_off(found.mean_bits),
        worst_absolute=round_up(found.worst_absolute),
        worst_scaled=round_up(float(np.max(inside))) if inside.size else None,
        worst_at=_as_point(_take(subject, arguments, worst)) if keeps_point else None,
    )


def _measure_cell(
    subject: Subject, place: int, points: int | None
) -> tuple[Cell, list[CellErrors], list[Span]]:
    """Measure every single-point way in a cell of sizes: largest absolute error and bound.

    The points of the sets that lie in the cell are included: they are chosen to hurt.
    """
    sides = list_cells(subject)[place]
    drawn = draw_in_cell(subject, np.random.default_rng([REPORT, place]), sides)
    drawn = _thin(subject, drawn, points)
    spans = [_span(argument) for argument in drawn]
    sizes = [sides.get(a.name, s) for a, s in zip(subject.quantity.arguments, spans, strict=True)]
    sets = (_take_inside(sizes, part) for part in _draw_once(subject, _share(points)))
    inside = join(drawn, *sets)
    arguments = inside if points is None else _thin(subject, inside, 2 * points)
    truth = find_truth(subject, arguments)
    named = {name: (float(low), float(high)) for name, (low, high) in sides.items()}
    errors = [
        _measure_in_cell(subject, way, arguments, truth, (place, sides))
        for way in subject.ways
        if not way.ordered
    ]
    return Cell(named, len(truth.high), truth.undecided), errors, spans


# Cached, because all cells of a subject look for their points in the same sets.
@lru_cache(maxsize=1)
def _draw_once(subject: Subject, share: float) -> tuple[Arguments, ...]:
    return tuple(draw_sets(subject, REPORT, share))


def _take_inside(sizes: Sequence[Span], arguments: Arguments) -> Arguments:
    """Take the points whose sizes lie in spans; the size of a vector is its largest component."""
    found = [np.abs(values).reshape(len(values), -1).max(axis=1) for values in arguments]
    pairs = zip(found, sizes, strict=True)
    inside = np.all([(low <= size) & (size <= high) for size, (low, high) in pairs], axis=0)
    return tuple(values[inside] for values in arguments)


def _find_ranges(subject: Subject, spans: list[list[Span]]) -> dict[str, Span]:
    """Return the spans of sizes measured: the edges of the cells, or else those of the points."""
    if not spans:
        return {}
    lows, highs = np.min(spans, axis=0)[:, 0], np.max(spans, axis=0)[:, 1]
    names = [argument.name for argument in subject.quantity.arguments]
    found = {n: (float(lo), float(hi)) for n, lo, hi in zip(names, lows, highs, strict=True)}
    usual = {a.name: a.usual for a in subject.quantity.arguments if len(a.usual) > 1}
    edges = {name: (float(sizes[0]), float(sizes[-1])) for name, sizes in usual.items()}
    return {**found, **edges}


def _measure_in_cell(
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
    bound = bound_approximation(subject, way, sides)
    return CellErrors(
        cell=place,
        way=way.name,
        worst=round_up(found.worst_absolute),
        bound=None if bound is None else round_up(bound),
        lost=found.nan + found.infinite,
    )


def _share(points: int | None) -> float:
    return 1.0 if points is None else PART


def _search(subject: Subject, index: int, points: int | None, rounds: int) -> Searched:
    way = subject.shipped[index]
    found = find_worst(subject, way.compute, rounds, share=_share(points), most=points)
    return Searched(way.name, round_up(found.scaled), found.tried, _as_point(found.arguments))


def keep_worst(
    subject: Subject, searched: Sequence[Searched], known: Sequence[Point]
) -> tuple[Searched, ...]:
    """Return the worst input of each way: from its own search, from another's, or known before."""
    met = [*(found.at for found in searched), *known]
    return tuple(
        max((found, *_judge(subject, found, met)), key=lambda judged: judged.scaled)
        for found in searched
    )


def _judge(subject: Subject, found: Searched, met: Iterable[Point]) -> Iterator[Searched]:
    (compute,) = (way.compute for way in subject.shipped if way.name == found.way)
    for at in met:
        (error,) = scaled_errors(subject, compute, tuple(np.array([value]) for value in at))
        yield replace(found, scaled=round_up(float(error)), at=at)


def _span(argument: Array) -> Span:
    """Return the least and the largest size; the least is 0 if the numbers have both signs."""
    size = np.abs(argument)
    least = 0.0 if np.min(argument) < 0 < np.max(argument) else float(np.min(size))
    return least, float(np.max(size))


def _thin(subject: Subject, arguments: Arguments, wanted: int | None) -> Arguments:
    return _take(subject, arguments, choose_evenly(count_points(subject, arguments), wanted))


def _take(subject: Subject, arguments: Arguments, chosen: Any) -> Arguments:
    """Take some of the points, or one; arguments that all points share are left unchanged."""
    count = count_points(subject, arguments)
    return tuple(a[chosen] if np.shape(a)[:1] == (count,) else a for a in arguments)


def _as_point(arguments: Arguments) -> Point:
    """Return one point as numbers that read back to the same doubles."""
    return tuple(_as_numbers(np.asarray(a, float).tolist()) for a in arguments)


def _as_numbers(value: Any) -> Any:
    return tuple(map(_as_numbers, value)) if isinstance(value, list) else value
