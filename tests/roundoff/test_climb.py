"""Climbing moves from point to point along a constant product, or in one argument alone."""

from __future__ import annotations

import numpy as np
import pytest

from mechproof.roundoff import climb
from mechproof.roundoff.climb import Column, Points, Schedule

NARROW = 2.0**-49


def on_a_ridge(points: Points) -> Column:
    """Return the first factor where the product of both is nearly 1, and -1 elsewhere."""
    one, other = points
    return np.where(np.abs(one * other - 1) <= NARROW, one, -1.0)


def on_a_step(points: Points) -> Column:
    """Return the first argument where all others are still 1, and -1 elsewhere."""
    first, *others = points
    is_same = np.logical_and.reduce([other == 1.0 for other in others])
    return np.where(is_same, first, -1.0)


@pytest.mark.parametrize(
    ("height", "arguments", "share"),
    [(on_a_ridge, 2, "TOGETHER"), (on_a_step, 8, "ALONE")],
)
def test_some_arguments_move_and_leave_what_others_make(
    height: climb.Measure, arguments: int, share: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    heights = []
    for moved in (getattr(climb, share), 0.0):
        monkeypatch.setattr(climb, "ALONE", 0.0)
        monkeypatch.setattr(climb, "TOGETHER", 0.0)
        monkeypatch.setattr(climb, share, moved)
        start = tuple(np.ones(4) for _ in range(arguments))
        found = climb.climb(height, start, Schedule(20, 6), 60, np.random.default_rng(1))
        heights.append(found.worst[1])
    assert heights[0] - 1 > 2 * (heights[1] - 1)


def test_vectors_and_matrices_move_by_one_factor() -> None:
    """All entries of a point's vector or matrix are multiplied by the same factor."""
    start = (np.ones(50), np.ones((50, 3)), np.ones((50, 3, 3)))
    moved = climb._breed(start, np.random.default_rng(1))
    assert [column.shape for column in moved] == [column.shape for column in start]
    whole = [np.ptp(column.reshape(50, -1), axis=1) == 0 for column in moved[1:]]
    assert all(np.mean(w) >= climb.TOGETHER / 2 for w in whole)
