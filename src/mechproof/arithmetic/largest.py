"""Largest: in, a bound over boxes and a box; out, a number that the bound exceeds nowhere.

Branch and bound (Hansen and Walster 2004), many boxes at once, the highest first. The bound at the
middle of a box, or of a part that is hardly more than a point, is reached; what is hardly above
that is not divided.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechproof.arithmetic.cover import (
    Bound,
    Box,
    Boxes,
    as_box,
    as_boxes,
    divide,
    halve,
    take_middles,
)
from mechproof.arithmetic.intervals import Array, Mask

# So many boxes are divided at once.
TOGETHER = 512
# Parts whose sides are such shares of the whole are not divided.
THIN = 2.0**-24
# So many parts where the bound is high are told.
KEPT = 32


@dataclass(frozen=True)
class Largest:
    """What a bound is at most over a box, what it reaches somewhere, and parts where it is high.

    `open` is a part where the bound is not finite, and cannot be made so by dividing it.
    """

    bound: float
    reached: float
    count: int
    highest: tuple[Box, ...]
    open: Box | None


def bound_largest(bound: Bound, box: Box, tolerance: float, most: int) -> Largest:
    """Divide a box until the bound is known to a tolerance, or into so many parts at most."""
    whole = as_boxes(box)
    boxes = divide(whole, len(box))
    heights, reached, count = _raise(bound(boxes)), 0.0, len(boxes)
    finished = 0.0
    highest: tuple[Boxes, Array] = boxes[:0], heights[:0]
    while len(boxes):
        # The highest first, of those without a bound the thinnest.
        sizes = (boxes[:, :, 1] - boxes[:, :, 0]).max(axis=1)
        order = np.lexsort((sizes, -heights))
        boxes, heights = boxes[order], heights[order]
        # What the bound is at a point it reaches: no division gets below that.
        middles = _raise(bound(take_middles(boxes[:TOGETHER])))
        thin = _are_thin(boxes, whole)
        if np.isinf(heights[0]) and (np.isinf(middles[0]) or count >= most or thin[0]):
            return Largest(np.inf, np.inf, count, (), as_box(boxes[0]))
        reached = max(reached, _find_highest(middles), _find_highest(heights[thin]))
        low = heights <= reached * (1 + tolerance)
        if low.any():
            highest = _keep(highest, boxes[low], heights[low])
            finished = max(finished, float(heights[low].max()))
            boxes, heights = boxes[~low], heights[~low]
        if not len(boxes) or count >= most:
            break
        halves = halve(bound, boxes[:TOGETHER], heights[:TOGETHER], whole)
        count += len(halves.boxes) // 2
        boxes = np.concatenate([boxes[TOGETHER:], halves.boxes])
        heights = np.concatenate([heights[TOGETHER:], _raise(halves.heights)])
    highest = _keep(highest, boxes, heights)
    found = max(finished, float(heights.max(initial=0.0)))
    return Largest(found, reached, count, tuple(map(as_box, highest[0])), None)


def _are_thin(boxes: Boxes, whole: Boxes) -> Mask:
    """Say which parts are too thin to be divided."""
    lengths = whole[:, :, 1] - whole[:, :, 0]
    return np.all(boxes[:, :, 1] - boxes[:, :, 0] <= THIN * lengths, axis=1)


def _find_highest(heights: Array) -> float:
    return float(np.max(heights, where=np.isfinite(heights), initial=0.0))


def _raise(heights: Array) -> Array:
    """Return infinity for what is not a number."""
    return np.where(np.isnan(heights), np.inf, heights)


def _keep(known: tuple[Boxes, Array], boxes: Boxes, heights: Array) -> tuple[Boxes, Array]:
    together = np.concatenate([known[0], boxes]), np.concatenate([known[1], heights])
    order: NDArray[np.intp] = np.argsort(-together[1], kind="stable")[:KEPT]
    return together[0][order], together[1][order]
