"""Cover: branch and bound over the boxes of a region, the worst first."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mechproof.roundoff.regions import Box, put_side

Bound = Callable[[Box], float]
# No side is cut to less than this share of the whole while another is longer.
FINEST = 2.0**-9
# So many of the boxes with the largest bounds are kept.
WORST = 32


@dataclass(frozen=True)
class Cover:
    """The largest bound over all boxes, where it is, and how many boxes there are.

    `worst` are the numbers of the starts, and boxes in them.
    """

    bound: float
    worst: tuple[tuple[int, Box], ...]
    count: int


def lower_bound(starts: Sequence[tuple[Bound, Box]], most: int) -> Cover:
    """Halve the box with the largest bound, whichever start it is of, until there are enough."""
    heap = [(-bound(box), number, number, box) for number, (bound, box) in enumerate(starts)]
    heapq.heapify(heap)
    made = len(heap)
    while len(heap) < most:
        height, _, number, worst = heapq.heappop(heap)
        bound, whole = starts[number]
        for half in halve(worst, choose_side(bound, worst, -height, whole)):
            heapq.heappush(heap, (-bound(half), made, number, half))
            made += 1
    places = tuple(entry[2:] for entry in heapq.nsmallest(WORST, heap))
    return Cover(-heap[0][0], places, len(heap))


def cover_below(bound: Bound, box: Box, aim: float, most: int) -> tuple[int, Box | None]:
    """Divide a box until every part is below an aim; the number of parts, and one that is not.

    A part whose middle alone is above the aim cannot be divided into parts below it.
    """
    waiting, count = [box], 0
    while waiting:
        part = waiting.pop()
        height = bound(part)
        if height <= aim:
            count += 1
            continue
        if count + len(waiting) >= most or bound(_middle(part)) > aim:
            return count, part
        waiting.extend(halve(part, choose_side(bound, part, height, box)))
    return count, None


def choose_side(bound: Bound, box: Box, height: float, whole: Box) -> int:
    """Choose the side without whose length the bound is lowest, or the longest of the box."""
    spans = {i: end - start for i, (start, end) in enumerate(whole) if start < end < math.inf}
    shares = {i: (box[i][1] - box[i][0]) / span for i, span in spans.items()}
    long = [i for i in shares if shares[i] > FINEST]
    if len(long) > 1:
        thin = {i: bound(put_side(box, i, (middle := _halfway(*box[i]), middle))) for i in long}
        if min(thin.values()) < height:
            return min(long, key=lambda i: thin[i])
    return max(shares, key=lambda i: shares[i])


def halve(box: Box, index: int) -> tuple[Box, Box]:
    """Cut a side of a box in two."""
    low, high = box[index]
    middle = _halfway(low, high)
    return put_side(box, index, (low, middle)), put_side(box, index, (middle, high))


def _middle(box: Box) -> Box:
    return tuple(
        (low, high) if math.isinf(high) else (_halfway(low, high),) * 2 for low, high in box
    )


def _halfway(low: float, high: float) -> float:
    return low + (high - low) / 2
