"""Error tables: bounds on the error of an elementary function, for pieces of its arguments."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mechproof.arithmetic.intervals import PI, Array, Ends, Interval, exactly

# More than the relative rounding errors of computing a place.
SLACK = 2.0**-40


@dataclass(frozen=True, eq=False)
class ErrorTable:
    """Bounds in eps of the value, for pieces between `edges` of the places of arguments.

    `highest[i, j]` is the largest bound over pieces i to j. The place of an angle is its distance
    from the nearest multiple of pi; angles up to `largest` have one. Angles below `near` are not
    reduced and have their own bounds, `unreduced`. Other arguments are meant to be at most `legal`.
    Beyond the last edge no bound is known.
    """

    edges: Array
    highest: Array
    unreduced: Array | None = None
    near: float = 0.0
    largest: float = np.inf
    legal: float = np.inf

    @property
    def most(self) -> float:
        """Return the bound for all arguments."""
        return float(self.highest[0, -1])

    @property
    def is_of_angles(self) -> bool:
        """Return whether the arguments are angles."""
        return self.unreduced is not None

    def of_angle(self, angle: Interval, reduced: Interval) -> Ends:
        """Return the bounds for angles, given also as reduced by whole turns."""
        assert self.unreduced is not None
        least, most = _fold(reduced)
        usual = self._find(self.highest, least, most)
        size = angle.largest()
        near = self._find(self.unreduced, angle.size().low, size)
        found = np.where(size < self.near, near, usual)
        return np.where(size <= self.largest, found, np.nan)

    def limit(self, argument: Interval, off: Ends) -> Interval:
        """Return an argument limited in size to `legal` plus the error that it may have."""
        most = np.where(np.isfinite(off), self.legal + off, np.inf)
        return Interval(np.maximum(argument.low, -most), np.minimum(argument.high, most))

    def of_size(self, size: Interval) -> Ends:
        """Return the bounds for sizes; a size s above 1 has the place 2 - 1/s."""
        return self._find(self.highest, _place(size.low, -SLACK), _place(size.high, SLACK))

    def _find(self, highest: Array, low: Ends, high: Ends) -> Ends:
        last = len(self.edges) - 2
        known = np.isfinite(low) & np.isfinite(high)
        first = np.searchsorted(self.edges, np.where(known, low, 0.0), "right") - 1
        after = np.searchsorted(self.edges, np.where(known, high, self.edges[-1]), "left") - 1
        # Clipped to the last piece, a place beyond the last edge would look bounded.
        beyond = known & (high > self.edges[-1])
        first = np.clip(first, 0, last)
        found = highest[first, np.clip(after, first, last)]
        return np.where(beyond, np.nan, found)


def find_highest(bounds: Array) -> Array:
    """Return the matrix of the highest bounds over pieces i to j."""
    rows: list[Any] = []
    for first in range(len(bounds)):
        rows.append(np.maximum.accumulate(np.where(np.arange(len(bounds)) < first, 0.0, bounds)))
    return np.array(rows)


def _place(size: Ends, slack: float) -> Ends:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(size <= 1, size, 2 - 1 / size) * (1 + slack)


def _fold(angle: Interval) -> tuple[Ends, Ends]:
    """Return the least and the largest distance of angles from multiples of pi."""
    middle = np.where(angle.is_finite, angle.low + (angle.high - angle.low) / 2, 0.0)
    turns = np.rint(middle / np.pi)
    near = angle - PI * Interval(turns, turns)
    size, quarter = near.size(), PI * exactly(0.5)
    low = np.maximum(np.minimum(size.low, (PI - Interval(size.high, size.high)).low), 0.0)
    return low, np.where(size.high < quarter.low, size.high, np.minimum(quarter.high, size.high))
