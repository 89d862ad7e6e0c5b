"""Moved matrices: no roundings stretch a point by more than the bound, which is nearly reached."""

from __future__ import annotations

import numpy as np
import pytest

from mechproof.arithmetic.intervals import Array, Interval
from mechproof.arithmetic.linear_forms import LinearForm
from mechproof.roundoff import moved_matrices
from mechproof.roundoff.moved_matrices import (
    MovedMatrix,
    bound_stretch,
    list_corners,
    sort_moves,
)

BOXES, ROUNDINGS, DRAWN = 12, 20, 4000


def draw_directions(seed: int, count: int = DRAWN) -> Array:
    drawn = np.random.default_rng(seed).normal(size=(count, 3))
    return drawn / np.linalg.norm(drawn, axis=1, keepdims=True)


def draw_moved(seed: int, sides: int) -> MovedMatrix:
    rng = np.random.default_rng(seed)
    moves = rng.normal(size=(ROUNDINGS, 1 + sides, 3, 3, BOXES))
    moves[:, 1:] *= 0.05
    return MovedMatrix(moves, rng.uniform(0, 0.3, (3, 3, BOXES)))


def climb(moves: Array, rest: Array) -> float:
    """Return the largest norm found by optimising signs and both directions in turn."""
    highest = 0.0
    for p, q in zip(draw_directions(1, 20), draw_directions(2, 20), strict=True):
        for _ in range(30):
            signs = np.sign(np.einsum("i,kij,j->k", q, moves, p))
            whole = np.einsum("k,kij->ij", signs, moves)
            whole += rest * np.sign(q)[:, np.newaxis] * np.sign(p)
            left, sizes, right = np.linalg.svd(whole)
            q, p = left[:, 0], right[0]
        highest = max(highest, float(sizes[0]))
    return highest


def test_the_corners_are_around_the_sphere() -> None:
    corners, directions = list_corners(), draw_directions(5, 20000)
    reached = np.abs(directions @ corners.T).max(axis=1)
    assert reached.min() >= 1
    assert np.all(np.linalg.norm(corners, axis=1) < 1.03)


def test_corners_on_the_sphere_are_caught() -> None:
    corners = list_corners() / np.linalg.norm(list_corners(), axis=1, keepdims=True)
    assert np.abs(draw_directions(5, 20000) @ corners.T).max(axis=1).min() < 1


@pytest.mark.parametrize("closely", [1, 64])
@pytest.mark.parametrize("sides", [0, 1, 3])
def test_nothing_is_stretched_by_more(
    sides: int, closely: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(moved_matrices, "CLOSELY", closely)
    moved = draw_moved(sides, sides)
    bounds = bound_stretch(moved)
    rng = np.random.default_rng(7)
    for ways in (*rng.uniform(-1, 1, (4, sides)), *rng.choice((-1.0, 1.0), (4, sides))):
        there = moved.moves[:, 0] + np.einsum("s,ks...->k...", ways, moved.moves[:, 1:])
        for box in range(BOXES):
            assert climb(there[..., box], moved.rest[..., box]) <= bounds[box]


def test_the_bound_is_not_far_off() -> None:
    moved = draw_moved(4, 0)
    bounds = bound_stretch(moved)
    met = [climb(moved.moves[:, 0, ..., i], moved.rest[..., i]) for i in range(BOXES)]
    assert np.all(bounds <= 1.06 * np.array(met))
    plain = np.abs(moved.moves[:, 0]).sum(axis=0) + moved.rest
    norms = [np.linalg.norm(plain[..., i], 2) for i in range(BOXES)]
    assert np.all(bounds < 0.9 * np.array(norms))


def test_changes_that_are_left_out_are_caught() -> None:
    moved = draw_moved(3, 3)
    still = bound_stretch(MovedMatrix(moved.moves[:, :1], moved.rest))
    assert np.all(still < bound_stretch(moved))


def test_what_is_not_known_is_not_bounded() -> None:
    moved = draw_moved(3, 3)
    moved.moves[0, 0, 1, 2, 5] = np.nan
    moved.rest[0, 0, 6] = np.inf
    with np.errstate(all="ignore"):
        bounds = bound_stretch(moved)
    assert np.isfinite(bounds).tolist() == [box not in (5, 6) for box in range(BOXES)]


def test_moves_are_sorted_by_how_many_entries_they_move() -> None:
    """Moves of one entry go to the rest; of others only the part that the form does not hold."""
    low, high = np.array([1.0]), np.array([2.0])
    form = LinearForm(np.array([1.5]), np.array([[0.0], [0.25]]), np.array([0.25]))
    shared, alone = Interval(low, high, form=form), Interval(-high, low)
    loose = Interval(low, high, form=LinearForm(low, np.array([[0.0], [1.0]]), high))
    moved = sort_moves([[{"a": shared, "b": alone}, {"a": loose}], [{"a": -shared}, {}]])
    assert moved.moves[0, :, :, :, 0].tolist() == [
        [[1.5, 1.5], [-1.5, 0.0]],
        [[0.0, 0.0], [0.0, 0.0]],
        [[0.25, 0.0], [-0.25, 0.0]],
    ]
    np.testing.assert_allclose(moved.rest[..., 0], [[2.25, 0.5], [0.25, 0.0]])
