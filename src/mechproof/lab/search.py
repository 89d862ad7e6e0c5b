"""The search: from the worst of some points uphill to worse ones.

A population of inputs; in each round every one is moved (some ulps, a factor, or across to
another's value), and the worst survive. What it finds belongs into the regression table.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from mechproof.lab.error import find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.points import TUNE, choose_evenly, draw_points, join, step_ulps
from mechproof.lab.sets import list_sets
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.lab.within import mark_within

SURVIVORS = 24
# Moves: up to 2**k ulps, or by a factor 1 + u * 10**-k.
FINEST_MOVE, WIDEST_MOVE = -16.0, -1.0


@dataclass(frozen=True)
class Found:
    """The worst input of a search, its error in units of the bound, and how many were tried."""

    arguments: tuple[Array, ...]
    scaled: float
    tried: int


def find_worst(
    subject: Subject,
    compute: Compute,
    rounds: int,
    seed: int = TUNE,
    share: float = 1.0,
    most: int | None = None,
) -> Found:
    """Climb for some rounds from a share of each set, at most so many; the domain is not left."""
    rng = np.random.default_rng(seed)
    crowd: Arguments = ()
    heights, tried = np.empty(0), 0
    for point_set in list_sets(subject, share):
        if point_set.ordered:
            continue
        drawn = _with_leading_axis(draw_points(point_set, seed))
        start = tuple(column[choose_evenly(len(column), most)] for column in drawn)
        crowd, heights, tried = _survive(subject, compute, crowd, heights, start, tried)
    for _ in range(rounds):
        moved = _move(subject, crowd, rng)
        crowd, heights, tried = _survive(subject, compute, crowd, heights, moved, tried)
    worst = tuple(column[0] for column in crowd)
    return Found(worst, float(heights[0]), tried)


def scaled_errors(subject: Subject, compute: Compute, arguments: Arguments) -> Array:
    """Return the errors in units of the accuracy bound; -1 where undecided or out of it."""
    truth = find_truth(subject, arguments)
    with np.errstate(all="ignore"):
        errors = find_errors(compute(*arguments), truth).scaled
    held = mark_within(subject, arguments) & truth.decided
    return np.where(held, np.nan_to_num(errors, nan=-1.0, posinf=np.inf), -1.0)


def _survive(
    subject: Subject,
    compute: Compute,
    crowd: Arguments,
    heights: Array,
    others: Arguments,
    tried: int,
) -> tuple[Arguments, Array, int]:
    """Join others to the crowd and keep the worst, each place once."""
    found = scaled_errors(subject, compute, others)
    columns = join(crowd, others) if crowd else others
    total = np.concatenate([heights, found])
    order = np.argsort(-total, kind="stable")
    rows = np.column_stack([np.reshape(c, (len(total), -1)) for c in columns])[order]
    _, first = np.unique(rows, axis=0, return_index=True)
    kept = order[np.sort(first)][:SURVIVORS]
    return tuple(c[kept] for c in columns), total[kept], tried + len(found)


def _with_leading_axis(arguments: Arguments) -> Arguments:
    count = max(len(a) for a in arguments if np.ndim(a))
    return tuple(
        a if np.ndim(a) and len(a) == count else np.broadcast_to(a, (count, *np.shape(a))).copy()
        for a in arguments
    )


def _move(subject: Subject, crowd: Arguments, rng: np.random.Generator) -> Arguments:
    """Move some numbers of every point, others stay; what leaves the domain stays as it was."""
    moved = tuple(_move_column(column, rng) for column in crowd)
    inside = subject.kernel(*moved)
    lost = np.isnan(np.reshape(inside, (len(moved[0]), -1))).any(axis=1)
    return tuple(
        np.where(lost.reshape(-1, *[1] * (new.ndim - 1)), old, new)
        for new, old in zip(moved, crowd, strict=True)
    )


def _move_column(column: Array, rng: np.random.Generator) -> Array:
    steps = np.rint(rng.normal(size=column.shape) * 2.0 ** rng.uniform(0, 12, column.shape))
    factor = 1 + rng.normal(size=column.shape) * 10 ** rng.uniform(
        FINEST_MOVE, WIDEST_MOVE, column.shape
    )
    other = rng.permutation(column, axis=0)
    choice = rng.integers(0, 6, column.shape)
    return np.select(
        [choice <= 1, choice == 2, choice == 3],
        [step_ulps(column, steps.astype(np.int64)), column * factor, other],
        column,
    )
