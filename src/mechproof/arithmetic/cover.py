"""Cover: a box and an aim -> parts of the box with bounds below the aim, many at once.

This is branch and bound (Hansen and Walster 2004) without a value to beat, as a proof needs every
part. Without an aim, a number is found that the bound exceeds nowhere, the highest parts first.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mechproof.arithmetic.intervals import Array, Mask

Side = tuple[float, float]
Box = tuple[Side, ...]
# Many boxes: the two ends of each side of each box.
Boxes = NDArray[np.float64]
Bound = Callable[[Boxes], Array]
# For each part in turn, the side across which it is cut, or `WHOLE` if it is not.
Cuts = NDArray[np.int8]
WHOLE = -1
# No side is cut to less than this fraction of the whole while another one is longer.
FINEST = 2.0**-13
# How many of the parts with the largest bounds are kept.
WORST = 32
# Up to this many boxes are bounded in hardly more time than a single one.
FEW = 64
# How often the first sides are halved before any box is bounded.
CUTS = 2
# A side no longer than this fraction of its larger end is narrow: a size and its tolerance.
NARROW = 0.125
# How many boxes are divided at once.
TOGETHER = 512
# Parts with no side longer than this fraction of the whole are not divided.
THIN = 2.0**-24
# How many parts with a high bound are reported.
KEPT = 32


@dataclass(frozen=True)
class Cover:
    """The number of parts below an aim, the highest bounds, a part not below, and the cuts."""

    count: int
    worst: tuple[tuple[float, Box], ...]
    open: Box | None
    cuts: Cuts


def cover_below(bound: Bound, box: Box, aim: float, most: int, first: int) -> Cover:
    """Divide a box until every part is below an aim or one is not; the first sides are cut at once.

    A part whose bound is above the aim at its middle alone cannot be divided into parts below it.
    """
    whole, count = as_boxes(box), 0
    worst: list[tuple[float, Box]] = []
    cuts: list[Cuts] = []
    waiting = divide(whole, first)
    heights = bound(waiting)
    while len(waiting):
        high = ~are_below(heights, aim)
        cuts.append(np.full(len(waiting), WHOLE, np.int8))
        count += int(np.sum(~high))
        worst = _keep_worst(worst, heights[~high], waiting[~high])
        waiting, heights = waiting[high], heights[high]
        if not len(waiting):
            break
        halves = halve(bound, waiting, heights, whole) if count + 2 * len(waiting) <= most else None
        if halves is None or halves.middle > aim:
            left = as_box(waiting[np.argmax(heights)])
            highest = ((float(heights.max()), left), *worst)
            return Cover(count, highest, left, np.concatenate(cuts))
        cuts[-1][high] = halves.sides
        waiting, heights = halves.boxes, halves.heights
    return Cover(count, tuple(worst), None, np.concatenate(cuts))


def are_below(heights: Array, aim: float) -> NDArray[np.bool_]:
    """Return which parts have bounds below an aim; parts without a bound do not."""
    return np.isfinite(heights) & (heights <= aim)


def cut_again(box: Box, first: int, cuts: Cuts) -> tuple[Boxes, Cuts]:
    """Return the parts into which `cover_below` divided a box by `cuts`, and the cuts left over.

    They cover the box whatever the cuts are. Raises ValueError if the cuts end too soon or name a
    side that does not exist.
    """
    waiting = divide(as_boxes(box), first)
    parts = [waiting[:0]]
    while len(waiting):
        sides, cuts = cuts[: len(waiting)], cuts[len(waiting) :]
        if len(sides) < len(waiting) or not np.all((sides >= WHOLE) & (sides < len(box))):
            raise ValueError(f"{len(waiting)} parts do not match the cuts {sides.tolist()}")
        parts.append(waiting[sides == WHOLE])
        rows = np.flatnonzero(sides != WHOLE)
        # The order is that of `cover_below`: first halves before second ones.
        waiting = np.concatenate(_cut(waiting, rows, sides[rows].astype(np.intp)))
    return np.concatenate(parts), cuts


def _keep_worst(
    known: list[tuple[float, Box]], heights: Array, boxes: Boxes
) -> list[tuple[float, Box]]:
    # A stable sort, so that every machine keeps the same ones of equal bounds.
    highest = np.argsort(-heights, kind="stable")[:WORST]
    more = [(float(heights[i]), as_box(boxes[i])) for i in highest]
    return sorted([*known, *more], key=lambda entry: -entry[0])[:WORST]


def divide(whole: Boxes, sides: int) -> Boxes:
    """Cut those of the first sides that are finite and not narrow, so that there are many boxes."""
    cut = np.flatnonzero(np.isfinite(_measure(whole)[0, :sides]) & ~_are_narrow(whole)[0, :sides])
    for _ in range(CUTS):
        for side in cut:
            first, second = whole.copy(), whole.copy()
            first[:, side, 1] = second[:, side, 0] = _find_middles(whole)[:, side]
            whole = np.concatenate([first, second])
    return whole


def _measure(boxes: Boxes) -> Array:
    """Return the lengths of sides; infinite for sides of zero or infinite length."""
    lengths = boxes[:, :, 1] - boxes[:, :, 0]
    return np.where(lengths > 0, lengths, np.inf)


def _are_narrow(boxes: Boxes) -> NDArray[np.bool_]:
    narrow: NDArray[np.bool_] = _measure(boxes) <= NARROW * np.abs(boxes).max(axis=2)
    return narrow


@dataclass(frozen=True)
class Halves:
    """Both halves of boxes, all first halves before all second ones, with their bounds.

    `sides` are those across which they were cut; `middle` is the bound at the middle of the box
    with the highest bound.
    """

    boxes: Boxes
    heights: Array
    sides: NDArray[np.intp]
    middle: float


def halve(bound: Bound, boxes: Boxes, heights: Array, whole: Boxes) -> Halves:
    """Cut each box across the side whose reduction to its middle lowers the bound most.

    If none lowers it, the longest side is cut. Bounding few boxes takes as long as bounding many:
    for few, the halves across every side are bounded together with what is needed for the choice.
    """
    # Cutting a narrow side changes little, so its length counts as a fraction of its larger end.
    spans = np.where(_are_narrow(whole), np.abs(whole).max(axis=2), _measure(whole))
    with np.errstate(invalid="ignore"):
        lengths = np.where(np.isfinite(spans), boxes[:, :, 1] - boxes[:, :, 0], 0.0)
    shares = lengths / spans
    longest = np.argmax(shares, axis=1)
    tried = (shares > FINEST) & np.isfinite(heights)[:, np.newaxis]
    # The bound with a side reduced to its middle shows, before any cut, what it owes to that side.
    thin = _flatten(boxes, *np.nonzero(tried))
    middle = take_middles(boxes[[np.argmax(heights)]])
    every = np.arange(len(boxes))
    cut = np.zeros_like(tried)
    if len(boxes) <= FEW:
        cut = tried.copy()
        cut[every, longest] = True
    halves = _cut(boxes, *np.nonzero(cut))
    found = bound(np.concatenate([middle, thin, *halves]))
    lowest = np.full(shares.shape, np.inf)
    lowest[tried] = found[1 : 1 + len(thin)]
    best = np.argmin(lowest, axis=1)
    sides = np.where(lowest.min(axis=1) < heights, best, longest)
    chosen = np.concatenate(_cut(boxes, every, sides))
    if not cut.any():
        return Halves(chosen, bound(chosen), sides, float(found[0]))
    known = np.full((2, *cut.shape), np.nan)
    known[:, cut] = found[1 + len(thin) :].reshape(2, -1)
    return Halves(chosen, known[:, every, sides].ravel(), sides, float(found[0]))


def _flatten(boxes: Boxes, rows: NDArray[np.intp], sides: NDArray[np.intp]) -> Boxes:
    """Return boxes, each with one side reduced to its middle."""
    flat = boxes[rows]
    flat[np.arange(len(rows)), sides] = _find_middles(boxes)[rows, sides, np.newaxis]
    return flat


def _cut(boxes: Boxes, rows: NDArray[np.intp], sides: NDArray[np.intp]) -> tuple[Boxes, Boxes]:
    """Return the first and the second halves of boxes, each cut across one of its sides."""
    first, second, each = boxes[rows], boxes[rows], np.arange(len(rows))
    first[each, sides, 1] = second[each, sides, 0] = _find_middles(boxes)[rows, sides]
    return first, second


def _find_middles(boxes: Boxes) -> Array:
    with np.errstate(invalid="ignore"):
        middles: Array = boxes[:, :, 0] + (boxes[:, :, 1] - boxes[:, :, 0]) / 2
    return middles


def take_middles(boxes: Boxes) -> Boxes:
    """Return the middles of boxes; infinite sides stay as they are."""
    middles = _find_middles(boxes)[:, :, np.newaxis]
    return np.where(np.isinf(boxes[:, :, 1:]), boxes, middles)


def as_boxes(box: Box) -> Boxes:
    """Return an array of one box."""
    return np.array([box], float)


def as_box(box: Boxes) -> Box:
    """Return the sides of a box."""
    return tuple((float(low), float(high)) for low, high in box)


@dataclass(frozen=True)
class Largest:
    """A bound that holds over a whole box, the value reached, and the parts where it is high.

    `open` is a part where the bound is not finite, and cannot be made so by dividing it.
    """

    bound: float
    reached: float
    count: int
    highest: tuple[Box, ...]
    open: Box | None


def bound_largest(bound: Bound, box: Box, tolerance: float, most: int) -> Largest:
    """Divide a box until the bound is known to a relative tolerance, or there are `most` parts."""
    whole = as_boxes(box)
    boxes = divide(whole, len(box))
    heights, reached, count = _raise(bound(boxes)), 0.0, len(boxes)
    finished = 0.0
    highest: tuple[Boxes, Array] = boxes[:0], heights[:0]
    while len(boxes):
        # The highest bounds come first, and among parts without a bound the thinnest.
        sizes = (boxes[:, :, 1] - boxes[:, :, 0]).max(axis=1)
        order = np.lexsort((sizes, -heights))
        boxes, heights = boxes[order], heights[order]
        # The bound is reached at points, so that no division gets below its values there.
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
    """Return which parts are too thin to be divided."""
    lengths = whole[:, :, 1] - whole[:, :, 0]
    return np.all(boxes[:, :, 1] - boxes[:, :, 0] <= THIN * lengths, axis=1)


def _find_highest(heights: Array) -> float:
    return float(np.max(heights, where=np.isfinite(heights), initial=0.0))


def _raise(heights: Array) -> Array:
    """Replace NaN by infinity."""
    return np.where(np.isnan(heights), np.inf, heights)


def _keep(known: tuple[Boxes, Array], boxes: Boxes, heights: Array) -> tuple[Boxes, Array]:
    together = np.concatenate([known[0], boxes]), np.concatenate([known[1], heights])
    order: NDArray[np.intp] = np.argsort(-together[1], kind="stable")[:KEPT]
    return together[0][order], together[1][order]
