"""Grouping: many boxes bounded together, as far as the same things hold in them.

Those in which something else holds are bounded on their own.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from mechproof.arithmetic.cover import Boxes
from mechproof.arithmetic.intervals import Array, careful
from mechproof.roundoff.interval_monomials import MixedBoxesError

# Boxes that are bounded together.
TOGETHER = 8192
# Called with boxes and with the first decisions.
BoundAlike = Callable[[Boxes, tuple[int, ...]], Array]


Rows = NDArray[np.intp]


def split_cases(compute: Callable[[Rows, tuple[int, ...]], Array], count: int) -> Array:
    """Return the bounds of so many boxes, computed for rows of them and first decisions."""
    bounds = np.full(count, np.inf)
    waiting: list[tuple[Rows, tuple[int, ...]]] = [(np.arange(count), ())]
    while waiting:
        rows, forced = waiting.pop()
        try:
            bounds[rows] = compute(rows, forced)
        except MixedBoxesError as undecided:
            for number, mask in enumerate(undecided.masks):
                inside = rows[np.broadcast_to(mask, len(rows))]
                if len(inside):
                    waiting.append((inside, (*undecided.path, number)))
    return bounds


def bound_in_groups(compute: BoundAlike, boxes: Boxes) -> Array:
    """Return the bounds of boxes; infinite where there is none."""
    bounds = np.full(len(boxes), np.inf)
    if not len(boxes):
        return bounds
    # What is never negative is the same in all boxes that are bounded together.
    _, groups = np.unique(boxes[:, :, 0] >= 0, axis=0, return_inverse=True)
    for group in range(groups.max() + 1):
        rows = np.flatnonzero(groups == group)
        for start in range(0, len(rows), TOGETHER):
            part = rows[start : start + TOGETHER]
            bounds[part] = _bound_alike(compute, boxes[part], moves=False)
    return bounds


def _bound_alike(compute: BoundAlike, boxes: Boxes, *, moves: bool) -> Array:
    def try_rows(rows: Rows, forced: tuple[int, ...]) -> Array:
        try:
            with careful(moves=moves):
                return compute(boxes[rows], forced)
        except FloatingPointError:
            if moves:
                return np.full(len(rows), np.inf)
            return _bound_alike(compute, boxes[rows], moves=True)

    return split_cases(try_rows, len(boxes))
