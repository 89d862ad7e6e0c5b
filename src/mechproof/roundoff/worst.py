"""Worst: in, boxes of regions; out, the input with the largest error found, as judged by balls.

Long doubles, a thousand times as fast, lead the search. Only inputs within a chart count.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.cover import Box
from mechproof.arithmetic.intervals import Array
from mechproof.programs.kernel import input_names
from mechproof.roundoff.climb import Measure, Schedule, climb_and_judge
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.matrix_climbs import list_starts
from mechproof.roundoff.regions import ChartRegion
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, IN_EXTENDED, IS_LONGER, LONG_DOUBLE

Points = Mapping[str, Array]
BITS = 200
DRAWN = 1000
# A population soon crowds into one place, so few points take many rounds, and then climb afresh.
BY_LONG_DOUBLES, ROUNDS, CLIMBS = Schedule(1000, 6), 300, 2
# Points that are drawn for one matrix are close together from the start.
FOR_ONE_MATRIX, FEWER_ROUNDS = Schedule(500, 6), 100
# Number of octaves that coordinates without an end are drawn from.
OCTAVES = 16.0


@dataclass(frozen=True)
class WorstRounding:
    """An input and its error in eps of the scale."""

    eps: float
    at: Mapping[str, float]


def find_worst(
    subject: ComputedStage, boxes: Sequence[tuple[ChartRegion, Box]], seed: int
) -> WorstRounding:
    """Draw points from boxes of regions and climb from the worst, repeatedly if that is cheap.

    For a map of points, climbs also start from badly rounded matrices.
    """
    rng = np.random.default_rng(seed)
    # Balls alone take a thousand times as long, so one climb must do.
    starts = [_draw_all(subject, boxes, rng) for _ in range(CLIMBS if IS_LONGER else 1)]
    climbs = [_climb(subject, start, rng, BY_LONG_DOUBLES, ROUNDS) for start in starts]
    if subject.map and IS_LONGER:
        drawn = list_starts(subject, starts[0], rng)
        climbs += [_climb(subject, at, rng, FOR_ONE_MATRIX, FEWER_ROUNDS) for at in drawn]
    return max(climbs, key=lambda found: found.eps)


def _draw_all(
    subject: ComputedStage, boxes: Sequence[tuple[ChartRegion, Box]], rng: np.random.Generator
) -> dict[str, Array]:
    drawn = [draw(subject, region, box, DRAWN, rng) for region, box in boxes]
    return {name: np.concatenate([points[name] for points in drawn]) for name in drawn[0]}


def _climb(
    subject: ComputedStage,
    start: Mapping[str, Array],
    rng: np.random.Generator,
    schedule: Schedule,
    rounds: int,
) -> WorstRounding:
    names = tuple(start)

    def take(measure: Callable[[ComputedStage, Points], Array]) -> Measure:
        return lambda columns: measure(subject, dict(zip(names, columns, strict=True)))

    leading = take(estimate) if IS_LONGER else None
    columns = tuple(start.values())
    found = climb_and_judge(take(judge), leading, columns, schedule, rounds, rng)
    point, eps = found.worst
    return WorstRounding(eps, dict(zip(names, map(float, point), strict=True)))


def judge(subject: ComputedStage, points: Points) -> Array:
    """Return the errors at points where the bound certainly applies, in eps; -1 elsewhere."""
    with working_precision(BITS):
        held = [subject.inside.holds(given, IN_BALLS) for given in _list_balls(subject, points)]
    return np.where(held, measure(subject, points), -1.0)


def measure(subject: ComputedStage, points: Points) -> Array:
    """Return the errors of the outputs in doubles, in eps of the scale; -1 outside the domain."""
    outputs, held = _compute(subject, points)
    errors = np.full(len(held), -1.0)
    with working_precision(BITS):
        for i, given in enumerate(_list_balls(subject, points)):
            if held[i]:
                errors[i] = _find_largest(subject.weigh(outputs[:, i].tolist(), given, IN_BALLS))
    return errors


def _list_balls(subject: ComputedStage, points: Points) -> Iterator[Mapping[str, Any]]:
    for values in zip(*points.values(), strict=True):
        balls = (arb(float(value)) for value in values)
        yield subject.complete(dict(zip(points, balls, strict=True)), IN_BALLS)


def estimate(subject: ComputedStage, points: Points) -> Array:
    """Estimate the errors in long doubles; -1 where doubles say that the stage is not taken."""
    outputs, held = _compute(subject, points)
    extended = {name: LONG_DOUBLE(column) for name, column in points.items()}
    with np.errstate(all="ignore"):
        given = subject.complete(extended, IN_EXTENDED)
        held &= subject.inside.holds(subject.complete(points, IN_DOUBLES), IN_DOUBLES)
        errors = _find_largest(subject.weigh([*outputs], given, IN_EXTENDED))
    return np.where(held, errors, -1.0)


def _compute(subject: ComputedStage, points: Points) -> tuple[Array, Any]:
    """Return the outputs in doubles, and a mask of where they are finite and the stage is taken."""
    with np.errstate(all="ignore"):
        outputs = subject.compute(points)
        return outputs, np.isfinite(outputs).all(axis=0) & subject.holds(points)


def _find_largest(errors: Sequence[Any]) -> Any:
    """Return the largest error at each point; NaN and infinity count as zero."""
    return np.nan_to_num(np.array(errors, float), posinf=0.0).max(axis=0)


def draw(
    subject: ComputedStage, region: ChartRegion, box: Box, count: int, rng: np.random.Generator
) -> Points:
    """Draw `count` arguments, by input name, with coordinates in a box of a region."""
    sides = [_draw_side(side, count, rng) for side in box]
    coordinates = dict(zip(region.names, sides, strict=False))
    if region.is_turned:
        rest = region.angle if region.chart.rest is None else region.chart.rest
        left = sp.lambdify(list(coordinates), rest, "numpy")(*coordinates.values())
        coordinates[region.angle] = _wind(region, left, sides[-1])
    names = input_names(subject.kernel.quantity)
    expressions = list(region.chart.arguments.values())
    compute = sp.lambdify(list(coordinates), expressions, "numpy")
    with np.errstate(all="ignore"):
        values = compute(*coordinates.values())
    points = {
        names[symbol]: np.rint(drawn) if symbol.is_integer else drawn
        for symbol, value in zip(region.chart.arguments, values, strict=True)
        for drawn in [np.broadcast_to(value, count).astype(float)]
    }
    return subject.total.draw(points, rng) if subject.total else points


def _draw_side(side: tuple[float, float], count: int, rng: np.random.Generator) -> Array:
    low, high = side
    if not math.isinf(high):
        return rng.uniform(low, high, count)
    signs = rng.choice((-1.0, 1.0), count) if math.isinf(low) else 1.0
    sizes: Array = signs * 2 ** rng.uniform(0, OCTAVES, count)
    return sizes


def _wind(region: ChartRegion, rest: Array, inverse: Array) -> Array:
    turns = np.rint((1 / inverse - rest) / (2 * np.pi)) if region.turns is None else region.turns
    whole: Array = 2 * np.pi * turns + rest
    return whole
