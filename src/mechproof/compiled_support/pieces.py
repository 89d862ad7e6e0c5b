"""Arrays as compiled loops take them, piece by piece: plain ones are taken as they are.

Numba would compile a loop anew where numbers lie apart, and where they may only be read.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

# Number of points for which arguments are copied at once: the copies stay in a cache.
PIECE = 2**14
DOUBLE = np.dtype(np.float64)


def cut(shape: tuple[int, ...], size: int) -> Iterator[tuple[slice, ...]]:
    """Cut the first axes so that no part has more than `size` points."""
    if not shape:
        yield ()
        return
    first, *rest = shape
    row = math.prod(rest)
    if row > size:
        for i in range(first):
            for index in cut(tuple(rest), size):
                yield (slice(i, i + 1), *index)
        return
    step = max(size // max(row, 1), 1)
    for start in range(0, first, step):
        yield (slice(start, start + step),)


def are_plain(values: Iterable[Any]) -> bool:
    """Say whether all arrays have their numbers beside each other, where they may be written."""
    return all(a.flags.carray for a in values if isinstance(a, np.ndarray))


def make_plain(value: Any) -> Any:
    """Return an array, or a copy, with its numbers beside each other; anything else as it is."""
    return np.require(value, None, ["C", "A", "W"]) if isinstance(value, np.ndarray) else value
