"""Linear forms: a quantity as a linear function along the sides of a box, plus a bounded rest.

Within a box a quantity is a number, plus a multiple of the distance from the middle of each side,
plus a rest. In sums and products the multiples for each side add up before any modulus is taken, so
that a variable in several terms counts only once: the rest is of second order in the sides. This is
affine arithmetic (de Figueiredo and Stolfi 2004), with all roundings in the rest.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np

Ends = Any
# More than all roundings of an operation, relative to the sizes of its operands, for a dozen sides;
# and more than what falls below the normal range.
ROUNDED, UNDERFLOWN = 2.0**-46, 2.0**-1000


class LinearForm:
    """A middle, the change from there to the end of each side, and the largest rest."""

    def __init__(self, middle: Ends, changes: Mapping[int, Ends], rest: Ends) -> None:
        self.middle, self.changes, self.rest = middle, changes, rest

    @cached_property
    def reach(self) -> Ends:
        """Return how far the quantity may be from the middle."""
        return sum(map(np.abs, self.changes.values()), self.rest)

    @cached_property
    def size(self) -> Ends:
        """Return the largest modulus that the quantity may have."""
        return np.abs(self.middle) + self.reach

    def __neg__(self) -> LinearForm:
        changes = {side: -change for side, change in self.changes.items()}
        return LinearForm(-self.middle, changes, self.rest)

    def __add__(self, other: LinearForm) -> LinearForm:
        rest = self.rest + other.rest + ROUNDED * (self.size + other.size)
        changes = _join(self.changes, other.changes)
        return LinearForm(self.middle + other.middle, changes, rest)

    def __mul__(self, other: LinearForm) -> LinearForm:
        one, two = self.middle, other.middle
        shift, rest = self._bend(other)
        rest = rest + self.size * other.rest + (np.abs(two) + other.reach) * self.rest
        changes = _join(_scale(self.changes, two), _scale(other.changes, one))
        return LinearForm(one * two + shift, changes, rest + self._round(other))

    def _bend(self, other: LinearForm) -> tuple[Ends, Ends]:
        """Return the middle of the product of both changes, and its largest distance from there."""
        shift = rest = np.float64(0.0)
        before: list[tuple[Ends, Ends]] = []
        for side in {**self.changes, **other.changes}:
            one, two = self.changes.get(side, 0.0), other.changes.get(side, 0.0)
            # The square of a position along one side, from -1 to 1, lies between 0 and 1.
            half = one * two / 2
            shift, rest = shift + half, rest + np.abs(half)
            rest = sum((np.abs(one * b + two * a) for a, b in before), rest)
            before.append((one, two))
        return shift, rest

    def square(self) -> LinearForm:
        """Return the square; that of the change lies between zero and the square of `reach`."""
        half, middle = self.reach * self.reach / 2, self.middle
        rest = 2 * np.abs(middle) * self.rest + half + self._round(self)
        return LinearForm(middle * middle + half, _scale(self.changes, 2 * middle), rest)

    def _round(self, other: LinearForm) -> Ends:
        return ROUNDED * (self.size * other.size) + UNDERFLOWN

    def scaled(self, factor: Ends, low: Ends, high: Ends) -> LinearForm:
        """Return a multiple of the quantity plus a term between two ends."""
        slack = ROUNDED * np.maximum(np.abs(low), np.abs(high)) + UNDERFLOWN
        return self * LinearForm(factor, {}, 0.0) + state(low - slack, high + slack)


def _scale(changes: Mapping[int, Ends], factor: Ends) -> dict[int, Ends]:
    return {side: factor * change for side, change in changes.items()}


def _join(one: Mapping[int, Ends], other: Mapping[int, Ends]) -> dict[int, Ends]:
    joined = dict(one)
    for side, change in other.items():
        joined[side] = joined[side] + change if side in joined else change
    return joined


def state(low: Ends, high: Ends) -> LinearForm:
    """Return the form of a quantity of which only the ends are known."""
    middle = low / 2 + high / 2
    return LinearForm(middle, {}, np.maximum(high - middle, middle - low) * (1 + ROUNDED))


def along(side: int, low: Ends, high: Ends) -> LinearForm:
    """Return the form of the position along a side of a box."""
    ends = state(low, high)
    return LinearForm(ends.middle, {side: ends.rest}, np.zeros_like(ends.rest))


def invert(form: LinearForm, low: Ends, high: Ends) -> LinearForm:
    """Return the reciprocal of a quantity between two ends of one sign."""
    near, far = np.minimum(np.abs(low), np.abs(high)), np.maximum(np.abs(low), np.abs(high))
    # With x times the steepness of its chord, 1/x is least in between and largest at an end.
    steep = 1 / (near * far)
    least, most = 2 * np.sqrt(steep), np.maximum(1 / near + steep * near, 1 / far + steep * far)
    below = low < 0
    return form.scaled(-steep, np.where(below, -most, least), np.where(below, -least, most))


def take_root(form: LinearForm, low: Ends, high: Ends) -> LinearForm:
    """Return the root of a quantity between two ends."""
    one, two = np.sqrt(low), np.sqrt(high)
    # Less x times the steepness of its chord, the root is least at an end and largest in between.
    steep = 1 / (one + two)
    return form.scaled(steep, np.minimum(one - steep * low, two - steep * high), 1 / (4 * steep))


def follow(
    form: LinearForm, ends: tuple[Ends, Ends], values: tuple[Any, Any], slopes: Any, bend: Ends
) -> LinearForm:
    """Return a function of a quantity between two ends, from its values there and its slopes.

    Values and slopes are intervals; `bend` is 1 where it is convex, -1 where it is concave.
    """
    (low, high), (first, last), width = ends, values, ends[1] - ends[0]
    mean = slopes.low / 2 + slopes.high / 2
    chord = (last.high - first.low) / np.where(width > 0, width, np.nan)
    steep = np.where((chord > slopes.low) & (chord < slopes.high), chord, mean)
    # Less the chord, the function is no farther off than where lines with these slopes meet.
    spread = slopes.high - slopes.low
    above, below = slopes.high - steep, steep - slopes.low
    off = width * above * (below / np.where(spread > 0, spread, 1.0))
    one, two = first.low - steep * low, last.low - steep * high
    three, four = first.high - steep * low, last.high - steep * high
    size = np.maximum(first.largest(), last.largest()) + off
    slack = ROUNDED * (size + np.abs(steep) * np.maximum(np.abs(low), np.abs(high)))
    lowest = np.minimum(one, two) - np.where(bend == -1, 0.0, off) - slack
    return form.scaled(
        steep, lowest, np.maximum(three, four) + np.where(bend == 1, 0.0, off) + slack
    )
