"""The search: from the worst of some points uphill to worse ones.

A population of inputs; in each round every one is moved (some ulps, a factor, or across to
another's value), and the worst survive. Balls tell which, of hundreds of points; then long doubles
of millions, and balls judge what these have found. It belongs into the regression table.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import sympy as sp

from mechproof.lab.error import find_errors
from mechproof.lab.extended import extend
from mechproof.lab.oracle import Truth, find_truth
from mechproof.lab.points import TUNE, choose_evenly, draw_points, join, step_ulps
from mechproof.lab.sets import list_sets
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.lab.within import mark_within

# Moves: up to 2**k ulps, or by a factor 1 + u * 10**-k.
MOST_ULPS, FINEST_MOVE, WIDEST_MOVE = 30.0, -16.0, -1.0
# So many of those that long doubles find are judged by balls.
JUDGED = 24

Measure = Callable[[Arguments], Array]


@dataclass(frozen=True)
class Pace:
    """How many survive a round, and the children of each."""

    survivors: int
    children: int


BY_BALLS, BY_LONG_DOUBLES = Pace(24, 1), Pace(3000, 6)
# So many rounds by long doubles for one by balls; after so many a crowd has met, and begins again.
ROUNDS, CLIMB = 20, 100


@dataclass(frozen=True)
class Found:
    """The worst input of a search, its error in units of the bound, and how many were tried."""

    arguments: tuple[Array, ...]
    scaled: float
    tried: int


@dataclass(frozen=True)
class Crowd:
    """Points with their errors, the worst first, and how many were tried for them."""

    points: Arguments
    heights: Array
    tried: int


def find_worst(
    subject: Subject,
    compute: Compute,
    rounds: int,
    seed: int = TUNE,
    share: float = 1.0,
    most: int | None = None,
) -> Found:
    """Climb for some rounds from a share of each set, by balls from at most so many points of it.

    The domain is not left. Without long doubles, or code of the quantity, balls are all there is.
    """
    rng = np.random.default_rng(seed)
    sets = [*_draw_sets(subject, seed, share)]
    judge = partial(scaled_errors, subject, compute)
    few = (tuple(c[choose_evenly(len(c), most)] for c in drawn) for drawn in sets)
    inside = partial(_mark_inside, subject)
    crowd = _climb(judge, join(*few), BY_BALLS, rounds, rng, inside)
    extended = extend(subject)
    if extended is not None:

        def estimate(points: Arguments) -> Array:
            return _measure(compute, points, extended.find_truth(points))

        start = join(crowd.points, *sets)
        for length in _divide(ROUNDS * rounds):
            many = _climb(estimate, start, BY_LONG_DOUBLES, length, rng)
            crowd = _select(_gather(crowd, _judge_best(judge, many)), JUDGED)
    worst = tuple(column[0] for column in crowd.points)
    return Found(worst, float(crowd.heights[0]), crowd.tried)


def _divide(rounds: int) -> Iterator[int]:
    """Divide rounds into climbs; none at all are one that looks around."""
    return (min(CLIMB, rounds - done) for done in range(0, max(rounds, 1), CLIMB))


def _judge_best(judge: Measure, crowd: Crowd) -> Crowd:
    # What is left of a crowd of few may lie beyond the domain.
    known = np.flatnonzero(crowd.heights >= 0)[:JUDGED]
    return replace(_weigh(judge, tuple(c[known] for c in crowd.points)), tried=crowd.tried)


def scaled_errors(subject: Subject, compute: Compute, arguments: Arguments) -> Array:
    """Return the errors in units of the accuracy bound; -1 where undecided or out of it."""
    truth = find_truth(subject, arguments)
    return np.where(mark_within(subject, arguments), _measure(compute, arguments, truth), -1.0)


def _measure(compute: Compute, arguments: Arguments, truth: Truth) -> Array:
    with np.errstate(all="ignore"):
        errors = find_errors(compute(*arguments), truth).scaled
    return np.where(truth.decided, np.nan_to_num(errors, nan=-1.0, posinf=np.inf), -1.0)


def _draw_sets(subject: Subject, seed: int, share: float) -> Iterator[Arguments]:
    for point_set in list_sets(subject, share):
        if not point_set.ordered:
            yield _with_leading_axis(draw_points(point_set, seed))


def _with_leading_axis(arguments: Arguments) -> Arguments:
    count = max(len(a) for a in arguments if np.ndim(a))
    return tuple(
        a if np.ndim(a) and len(a) == count else np.broadcast_to(a, (count, *np.shape(a))).copy()
        for a in arguments
    )


def _climb(
    measure: Measure,
    start: Arguments,
    pace: Pace,
    rounds: int,
    rng: np.random.Generator,
    inside: Callable[[Arguments], Array] | None = None,
) -> Crowd:
    crowd = _select(_weigh(measure, start), pace.survivors)
    for _ in range(rounds):
        parents = tuple(np.repeat(c, pace.children, axis=0) for c in crowd.points)
        moved = tuple(_move(column, rng) for column in parents)
        if inside is not None:
            kept = inside(moved)
            moved = tuple(_choose(kept, *pair) for pair in zip(moved, parents, strict=True))
        crowd = _select(_gather(crowd, _weigh(measure, moved)), pace.survivors)
    return crowd


def _mark_inside(subject: Subject, points: Arguments) -> Array:
    """Mark the points of the domain; of sums a kernel alone knows it, which is NaN elsewhere."""
    if any(isinstance(s, sp.IndexedBase) for s in subject.facts.symbols):
        known: Array = ~np.isnan(subject.kernel(*points))
        return known
    columns = [part for a in points for part in (a.T if a.ndim > 1 else [a])]
    return subject.facts.region.mark_inside(dict(zip(subject.facts.symbols, columns, strict=True)))


def _weigh(measure: Measure, points: Arguments) -> Crowd:
    return Crowd(points, measure(points), len(points[0]))


def _gather(one: Crowd, other: Crowd) -> Crowd:
    heights = np.concatenate([one.heights, other.heights])
    return Crowd(join(one.points, other.points), heights, one.tried + other.tried)


def _select(crowd: Crowd, most: int) -> Crowd:
    """Keep the worst, each place once."""
    order = np.argsort(-crowd.heights, kind="stable")[: 2 * most]
    rows = np.column_stack([np.reshape(c[order], (len(order), -1)) for c in crowd.points])
    _, first = np.unique(rows, axis=0, return_index=True)
    kept = order[np.sort(first)][:most]
    return Crowd(tuple(c[kept] for c in crowd.points), crowd.heights[kept], crowd.tried)


def _choose(kept: Array, one: Array, other: Array) -> Array:
    """Take rows of one where they are kept, and else of the other."""
    return np.where(kept.reshape(-1, *[1] * (one.ndim - 1)), one, other)


def _move(column: Array, rng: np.random.Generator) -> Array:
    """Move some numbers, others stay; of every other vector or matrix all."""
    steps = np.rint(rng.normal(size=column.shape) * 2.0 ** rng.uniform(0, MOST_ULPS, column.shape))
    factor = 1 + rng.normal(size=column.shape) * 10 ** rng.uniform(
        FINEST_MOVE, WIDEST_MOVE, column.shape
    )
    other = rng.permutation(column, axis=0)
    choice = rng.integers(0, 6, column.shape)
    moved = np.select(
        [choice <= 1, choice == 2, choice == 3],
        [step_ulps(column, steps.astype(np.int64)), column * factor, other],
        column,
    )
    return moved if column.ndim == 1 else _choose(rng.random(len(column)) < 0.5, moved, column)
