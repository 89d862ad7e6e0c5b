"""Grouping: many boxes bounded together, as far as the same things hold in them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from mechproof.arithmetic.cover import Boxes
from mechproof.arithmetic.intervals import Array, careful
from mechproof.roundoff.case_split import Rows, split_cases

# Boxes that are bounded together.
TOGETHER = 1024
# Called with boxes and with the first decisions.
BoundAlike = Callable[[Boxes, tuple[int, ...]], Array]


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
