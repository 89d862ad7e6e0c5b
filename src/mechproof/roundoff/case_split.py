"""Case split: boxes bounded together, those in which something else holds bounded on their own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from mechproof.arithmetic.intervals import Array
from mechproof.roundoff.interval_monomials import MixedBoxesError

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
