"""Arrays for compiled loops: plain ones are passed unchanged, others copied piece by piece.

For arrays that are not contiguous or are read-only, numba would compile a loop anew.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

# Number of points whose arguments are copied at once, so that the copies stay in a cache.
PIECE = 2**14
DOUBLE = np.dtype(np.float64)


def cut(shape: tuple[int, ...], size: int) -> Iterator[tuple[slice, ...]]:
    """Yield indices that cut the first axes into parts of at most `size` points."""
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
    """Return whether all arrays among the values are C-contiguous, aligned and writeable."""
    return all(a.flags.carray for a in values if isinstance(a, np.ndarray))


def make_plain(value: Any) -> Any:
    """Return an array, copied unless it is plain; anything else unchanged."""
    return np.require(value, None, ["C", "A", "W"]) if isinstance(value, np.ndarray) else value
