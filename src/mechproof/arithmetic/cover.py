"""Cover: in, a box and an aim; out, its parts with bounds below the aim, many at once.

Branch and bound (Hansen and Walster 2004) without a value to beat: a proof needs every part.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechproof.arithmetic.intervals import Array

Side = tuple[float, float]
Box = tuple[Side, ...]
# Many boxes: their sides, and of each the ends.
Boxes = NDArray[np.float64]
Bound = Callable[[Boxes], Array]
# No side is cut to less than this share of the whole while another is longer.
FINEST = 2.0**-13
# So many of the parts with the largest bounds are kept.
WORST = 32
# So often the first sides are halved before any box is bounded.
CUTS = 2


@dataclass(frozen=True)
class Cover:
    """How many parts are below an aim, the worst of all, and one that is not below."""

    count: int
    worst: tuple[tuple[float, Box], ...]
    open: Box | None


def cover_below(bound: Bound, box: Box, aim: float, most: int, first: int) -> Cover:
    """Divide a box, its first sides before all, until every part is below an aim or one is not.

    A part whose middle alone is above the aim cannot be divided into parts below it.
    """
    whole, count = as_boxes(box), 0
    worst: list[tuple[float, Box]] = []
    waiting = divide(whole, first)
    while len(waiting):
        heights = bound(waiting)
        high = ~(np.isfinite(heights) & (heights <= aim))
        count += int(np.sum(~high))
        worst = _keep_worst(worst, heights[~high], waiting[~high])
        waiting, heights = waiting[high], heights[high]
        if not len(waiting):
            break
        is_too_much = count + 2 * len(waiting) > most
        if not is_too_much:
            sides, middle = choose_sides(bound, waiting, heights, whole)
        if is_too_much or middle > aim:
            left = as_box(waiting[np.argmax(heights)])
            return Cover(count, ((float(heights.max()), left), *worst), left)
        waiting = halve(waiting, sides)
    return Cover(count, tuple(worst), None)


def _keep_worst(
    known: list[tuple[float, Box]], heights: Array, boxes: Boxes
) -> list[tuple[float, Box]]:
    highest = np.argsort(-heights, kind="stable")[:WORST]
    more = [(float(heights[i]), as_box(boxes[i])) for i in highest]
    return sorted([*known, *more], key=lambda entry: -entry[0])[:WORST]


def divide(whole: Boxes, sides: int) -> Boxes:
    """Cut the first sides as far as they have a length, so that there are many boxes."""
    for _ in range(CUTS):
        for side in range(sides):
            low, high = whole[0, side]
            if low < high < np.inf:
                first, second = whole.copy(), whole.copy()
                first[:, side, 1] = second[:, side, 0] = _find_middles(whole)[:, side]
                whole = np.concatenate([first, second])
    return whole


def halve(boxes: Boxes, sides: NDArray[np.intp]) -> Boxes:
    """Cut a side of every box in two."""
    rows = np.arange(len(boxes))
    first, second = boxes.copy(), boxes.copy()
    middles = _find_middles(boxes)[rows, sides]
    first[rows, sides, 1] = middles
    second[rows, sides, 0] = middles
    return np.concatenate([first, second])


def choose_sides(
    bound: Bound, boxes: Boxes, heights: Array, whole: Boxes
) -> tuple[NDArray[np.intp], float]:
    """Choose the side without whose length the bound is lowest, or the longest of the box.

    The bound at the middle of the highest box comes with them: of few boxes it takes as long as of
    many.
    """
    spans = whole[:, :, 1] - whole[:, :, 0]
    spans = np.where(np.isfinite(spans) & (spans > 0), spans, np.inf)
    with np.errstate(invalid="ignore"):
        lengths = np.where(np.isfinite(spans), boxes[:, :, 1] - boxes[:, :, 0], 0.0)
    shares = lengths / spans
    longest = np.argmax(shares, axis=1)
    middles = _find_middles(boxes)
    rows, sides = np.nonzero((shares > FINEST) & np.isfinite(heights)[:, np.newaxis])
    thin = boxes[rows]
    thin[np.arange(len(rows)), sides] = middles[rows, sides, np.newaxis]
    lowest = np.full(shares.shape, np.inf)
    highest = take_middles(boxes[[np.argmax(heights)]])
    found = bound(np.concatenate([highest, thin]))
    lowest[rows, sides] = found[1:]
    best = np.argmin(lowest, axis=1)
    chosen: NDArray[np.intp] = np.where(lowest.min(axis=1) < heights, best, longest)
    return chosen, float(found[0])


def _find_middles(boxes: Boxes) -> Array:
    with np.errstate(invalid="ignore"):
        middles: Array = boxes[:, :, 0] + (boxes[:, :, 1] - boxes[:, :, 0]) / 2
    return middles


def take_middles(boxes: Boxes) -> Boxes:
    """Return the middles of boxes, of endless sides the whole."""
    middles = _find_middles(boxes)[:, :, np.newaxis]
    return np.where(np.isinf(boxes[:, :, 1:]), boxes, middles)


def as_boxes(box: Box) -> Boxes:
    """Return one box as many."""
    return np.array([box], float)


def as_box(box: Boxes) -> Box:
    """Return the sides of a box."""
    return tuple((float(low), float(high)) for low, high in box)
