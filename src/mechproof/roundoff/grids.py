"""Grids: of which power of two the doubles of a step are multiples, so that some sums are exact.

A double that is not below 2**e is a multiple of 2**(e - 52); sums and products of multiples are
multiples again, and a rounded multiple is one. What is a multiple of 2**g and below 2**(g + 53) is
a double. Gappa (Daumas and Melquiond 2010) proves the like by its predicate FIX; Sterbenz's lemma
is a case of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from mechproof.arithmetic.intervals import Ends, Interval, Mask

# Exponents of two, minus infinity where none is known.
Grid = Ends
BITS = 53
NONE = np.float64(-np.inf)
_RULES: Mapping[str, Callable[..., Grid]] = MappingProxyType(
    {
        "add": np.minimum,
        "subtract": np.minimum,
        "multiply": np.add,
        "square": lambda a: 2 * a,
        "fma": lambda a, b, c: np.minimum(a + b, c),
        "negate": lambda a: a,
        "absolute": lambda a: a,
    }
)


def find_grid(kind: str, given: Sequence[Grid]) -> Grid:
    """Return the grid of an operation's exact result."""
    return _RULES[kind](*given) if kind in _RULES else NONE


def find_own_grid(doubles: Interval) -> Grid:
    """Return the spacing of the least of doubles; none where zero may be among them."""
    least = np.maximum(doubles.low, -doubles.high)
    apart = least > 0
    _, exponents = np.frexp(np.where(apart, least, 1.0))
    # The least has the finest spacing, of which those of all others are multiples.
    return np.where(apart, exponents - float(BITS), NONE)


def find_grid_of_number(number: float) -> Grid:
    """Return the largest power of two of which a double is a multiple."""
    above, below = float(number).as_integer_ratio()
    if above == 0:
        return np.float64(np.inf)
    # The lowest bit above and the number below are powers of two, each one bit longer than its
    # exponent.
    return np.float64((above & -above).bit_length() - below.bit_length())


def are_doubles(grid: Grid, results: Interval) -> Mask:
    """Say where all multiples that round to these results are doubles themselves."""
    largest = results.largest()
    _, exponents = np.frexp(largest)
    return np.isfinite(largest) & (exponents <= grid + BITS)
