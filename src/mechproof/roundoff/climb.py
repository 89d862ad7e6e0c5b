"""Climb: from the worst of some points uphill to worse ones.

In each round every point of a population is moved (by some ulps, by a factor, or to another's
value), and the worst survive. If one argument moves alone, or several by one factor so that their
products or quotients hardly change, most roundings stay as bad as they are. The points are on the
first axis. This is an evolution strategy (Beyer and Schwefel 2002) with steps from double to
double.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.kernel_support.order import step_ulps

Column = NDArray[Any]
Points = tuple[Column, ...]
Measure = Callable[[Points], Column]
# Exponents of the sizes of moves: about 2**MOST_ULPS ulps at most, or a factor 1 + u * 10**k, with
# k from the finest to the widest.
MOST_ULPS, FINEST_MOVE, WIDEST_MOVE = 30.0, -16.0, -1.0
# Shares of the points that are moved in one argument alone, and in several by one factor.
ALONE, TOGETHER = 0.4, 0.4
# How many of the worst points that long doubles find are judged by balls.
JUDGED = 24


@dataclass(frozen=True)
class Schedule:
    """The number of points that survive a round, and the children of each."""

    survivors: int
    children: int


BY_BALLS = Schedule(24, 1)


@dataclass(frozen=True)
class Population:
    """Points with their errors, and how many points were tried; after a climb, worst first."""

    points: Points
    heights: Column
    tried: int

    @property
    def worst(self) -> tuple[Points, float]:
        """Return the worst point and its error; IndexError or ValueError if there is none."""
        place = int(np.argmax(self.heights))
        return tuple(column[place] for column in self.points), float(self.heights[place])


def climb(
    measure: Measure,
    start: Points,
    schedule: Schedule,
    rounds: int,
    rng: np.random.Generator,
    inside: Measure | None = None,
) -> Population:
    """Return the worst points after `rounds` rounds; a child that is not `inside` is dropped."""
    population = _select(_weigh(measure, start), schedule.survivors)
    for _ in range(rounds):
        parents = tuple(np.repeat(c, schedule.children, axis=0) for c in population.points)
        moved = _breed(parents, rng)
        if inside is not None:
            kept = inside(moved)
            moved = tuple(_choose(kept, *pair) for pair in zip(moved, parents, strict=True))
        population = gather(population, _weigh(measure, moved), schedule.survivors)
    return population


def climb_and_judge(
    judge: Measure,
    estimate: Measure | None,
    start: Points,
    schedule: Schedule,
    rounds: int,
    rng: np.random.Generator,
) -> Population:
    """Climb by estimates and judge the worst; without estimates, climb by `judge` alone."""
    if estimate is None:
        return climb(judge, start, BY_BALLS, rounds, rng)
    found = climb(estimate, start, schedule, rounds, rng)
    # In a small population some survivors may lie outside the domain, where the height is -1.
    known = np.flatnonzero(found.heights >= 0)[:JUDGED]
    return replace(_weigh(judge, tuple(c[known] for c in found.points)), tried=found.tried)


def _weigh(measure: Measure, points: Points) -> Population:
    """Return points as a population, with their measured errors."""
    return Population(points, measure(points), len(points[0]))


def gather(one: Population, other: Population, most: int) -> Population:
    """Join two populations and keep the worst points."""
    pairs = zip(one.points, other.points, strict=True)
    heights = np.concatenate([one.heights, other.heights])
    tried = one.tried + other.tried
    return _select(Population(tuple(map(np.concatenate, pairs)), heights, tried), most)


def _select(population: Population, most: int) -> Population:
    """Return the `most` worst points, without duplicates, worst first."""
    # Twice as many as are kept, because some coincide: a child may not have moved.
    order = np.argsort(-population.heights, kind="stable")[: 2 * most]
    rows = np.column_stack([np.reshape(c[order], (len(order), -1)) for c in population.points])
    _, first = np.unique(rows, axis=0, return_index=True)
    kept = order[np.sort(first)][:most]
    return Population(
        tuple(c[kept] for c in population.points), population.heights[kept], population.tried
    )


def _choose(kept: Column, one: Column, other: Column) -> Column:
    """Return the rows of one column where `kept` holds, and of the other elsewhere."""
    return np.where(_reshape(kept, one), one, other)


def _reshape(row: Column, column: Column) -> Column:
    """Return one number per point, reshaped to broadcast with a column."""
    return row.reshape(-1, *[1] * (column.ndim - 1))


def _breed(parents: Points, rng: np.random.Generator) -> Points:
    """Move every point: in all arguments, in one alone, or in several by one factor."""
    count = len(parents[0])
    share, place = rng.random(count), rng.integers(0, len(parents), count)
    factor = _draw_factors(count, rng)
    is_alone, is_together = share < ALONE, share >= 1 - TOGETHER
    return tuple(
        np.where(
            _reshape(is_together, column),
            column * _reshape(factor ** rng.integers(-1, 2, count), column),
            _choose(is_alone & (place != number), column, _move(column, rng)),
        )
        for number, column in enumerate(parents)
    )


def _draw_factors(size: Any, rng: np.random.Generator) -> Column:
    factors: Column = 1 + rng.normal(size=size) * 10 ** rng.uniform(FINEST_MOVE, WIDEST_MOVE, size)
    return factors


def _move(column: Column, rng: np.random.Generator) -> Column:
    """Move some of the numbers; of vectors or matrices, only about every other one moves."""
    # Errors jump from double to double: there is no slope to follow, so steps have all sizes.
    steps = np.rint(rng.normal(size=column.shape) * 2.0 ** rng.uniform(0, MOST_ULPS, column.shape))
    factor = _draw_factors(column.shape, rng)
    other = rng.permutation(column, axis=0)
    choice = rng.integers(0, 6, column.shape)
    moved = np.select(
        [choice <= 1, choice == 2, choice == 3],
        [step_ulps(column, steps.astype(np.int64)), column * factor, other],
        column,
    )
    return moved if column.ndim == 1 else _choose(rng.random(len(column)) < 0.5, moved, column)
