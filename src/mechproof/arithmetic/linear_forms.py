"""Linear forms: a quantity as a linear function along the sides of a box, plus a bounded rest.

Within a box a quantity is a number, plus a multiple of the distance from the middle of each side,
plus a rest. In sums and products the multiples for each side add up before any modulus is taken, so
that a variable in several terms counts only once: the rest is of second order in the sides. This is
affine arithmetic (de Figueiredo and Stolfi 2004), with all roundings in the rest.

A bent form also has multiples of the products of two such distances, which add up in the same way,
so that its rest is of third order: a Taylor model of degree 2 (Makino and Berz 2003).
"""

from __future__ import annotations

from typing import Any

import numpy as np

Ends = Any
# More than all roundings of an operation, relative to the sizes of its operands, for a dozen sides,
# or eight of bent forms; and more than what falls below the normal range.
ROUNDED, UNDERFLOWN = 2.0**-46, 2.0**-1000
# The changes of a quantity that does not change along any side, and the bends of one without.
STILL = np.zeros((1, 1))


class LinearForm:
    """A middle, the changes from there to the end of each side, and the largest rest.

    A bent form also has `bends`, one for each pair of sides, as `list_pairs` lists them.
    """

    __slots__ = ("bends", "bow", "changes", "middle", "reach", "rest", "size", "swing")

    def __init__(self, middle: Ends, changes: Ends, rest: Ends, bends: Ends = STILL) -> None:
        self.middle, self.changes, self.rest, self.bends = middle, changes, rest, bends
        # The farthest that the changes lead from the middle, and the bends; the farthest that the
        # quantity may be from there, and its largest possible size.
        self.swing = 0.0 if changes is STILL else np.add.reduce(np.abs(changes))
        self.bow = 0.0 if bends is STILL else np.add.reduce(np.abs(bends))
        self.reach = self.swing + self.bow + rest
        self.size = np.abs(middle) + self.reach

    @property
    def is_bent(self) -> bool:
        """Return whether the form has multiples of the products of two distances."""
        return self.bends is not STILL

    def __neg__(self) -> LinearForm:
        return LinearForm(-self.middle, -self.changes, self.rest, _scale(self.bends, -1))

    def __add__(self, other: LinearForm) -> LinearForm:
        rest = self.rest + other.rest + ROUNDED * (self.size + other.size)
        bends = self.bends + other.bends if self.is_bent or other.is_bent else STILL
        return LinearForm(self.middle + other.middle, self.changes + other.changes, rest, bends)

    def __mul__(self, other: LinearForm) -> LinearForm:
        one, two = self.middle, other.middle
        rest = self.size * other.rest + (np.abs(two) + other.reach) * self.rest
        rest = rest + self._round(other)
        if other.changes is STILL:
            return LinearForm(one * two, two * self.changes, rest, _scale(self.bends, two))
        if self.changes is STILL:
            return LinearForm(one * two, one * other.changes, rest, _scale(other.bends, one))
        changes = two * self.changes + one * other.changes
        if self.is_bent or other.is_bent:
            bends = two * self.bends + one * other.bends + self._cross(other)
            rest = rest + self.swing * other.bow + self.bow * (other.swing + other.bow)
            return LinearForm(one * two, changes, rest, bends)
        shift, bent = self._enclose_product(other)
        return LinearForm(one * two + shift, changes, rest + bent)

    def _cross(self, other: LinearForm) -> Ends:
        """Return the bends of the product of both changes."""
        first, second = list_pairs(len(self.changes))
        a, b = self.changes, other.changes
        both: Ends = a[first] * b[second] + a[second] * b[first]
        both[first == second] /= 2
        return both

    def _enclose_product(self, other: LinearForm) -> tuple[Ends, Ends]:
        """Return the middle of the product of both changes, and how far it may be from there."""
        # The square of the position along one side, which is from -1 to 1, is from 0 to 1.
        half = self.changes * other.changes / 2
        return np.add.reduce(half), self.swing * other.swing - np.add.reduce(np.abs(half))

    def square(self) -> LinearForm:
        """Return the square; that of the change lies between zero and the square of `reach`."""
        if self.is_bent:
            return self * self
        half, middle = self.reach * self.reach / 2, self.middle
        rest = 2 * np.abs(middle) * self.rest + half + self._round(self)
        return LinearForm(middle * middle + half, 2 * middle * self.changes, rest)

    def away(self) -> LinearForm:
        """Return how far the quantity is from the middle."""
        return LinearForm(np.zeros_like(self.middle), self.changes, self.rest, self.bends)

    def _round(self, other: LinearForm) -> Ends:
        return ROUNDED * (self.size * other.size) + UNDERFLOWN

    def scaled(self, factor: Ends, low: Ends, high: Ends) -> LinearForm:
        """Return a multiple of the quantity plus a term between two ends."""
        slack = ROUNDED * np.maximum(np.abs(low), np.abs(high)) + UNDERFLOWN
        return self * LinearForm(factor, STILL, 0.0) + state(low - slack, high + slack)


def _scale(bends: Ends, factor: Ends) -> Ends:
    return bends if bends is STILL else factor * bends


def list_pairs(sides: int) -> tuple[Ends, Ends]:
    """List the first and the second sides of all pairs, of a side with itself, too."""
    first, second = np.triu_indices(sides)
    return first, second


def state(low: Ends, high: Ends) -> LinearForm:
    """Return the form of a quantity of which only the ends are known."""
    middle = low / 2 + high / 2
    return LinearForm(middle, STILL, np.maximum(high - middle, middle - low) * (1 + ROUNDED))


def along(side: int, sides: int, low: Ends, high: Ends, *, is_bent: bool = False) -> LinearForm:
    """Return the form of the position along a side of a box."""
    ends = state(low, high)
    changes = np.zeros((sides, *np.shape(ends.rest)))
    changes[side] = ends.rest
    bends = np.zeros((len(list_pairs(sides)[0]), *np.shape(ends.rest))) if is_bent else STILL
    return LinearForm(ends.middle, changes, np.zeros_like(ends.rest), bends)


def invert(form: LinearForm, low: Ends, high: Ends) -> LinearForm:
    """Return the reciprocal of a quantity between two ends of one sign."""
    near, far = np.minimum(np.abs(low), np.abs(high)), np.maximum(np.abs(low), np.abs(high))
    # With x times the steepness of its chord, 1/x is least in between and largest at an end.
    steep = 1 / (near * far)
    least, most = 2 * np.sqrt(steep), np.maximum(1 / near + steep * near, 1 / far + steep * far)
    below = low < 0
    found = form.scaled(-steep, np.where(below, -most, least), np.where(below, -least, most))
    if not form.is_bent:
        return found
    # 1/(m + u) = 1/m - u/m**2 + u**2/m**3 - u**3/(m**3*(m + u))
    part = 1 / form.middle
    series = part, -(part**2), part**3
    return _take_closer(found, _expand(form, low, high, series, part**3 / near))


def take_root(form: LinearForm, low: Ends, high: Ends) -> LinearForm:
    """Return the root of a quantity between two ends."""
    one, two = np.sqrt(low), np.sqrt(high)
    # Less x times the steepness of its chord, the root is least at an end and largest in between.
    steep = 1 / (one + two)
    found = form.scaled(steep, np.minimum(one - steep * low, two - steep * high), 1 / (4 * steep))
    if not form.is_bent:
        return found
    root, least = np.sqrt(form.middle), np.minimum(low, form.middle)
    series = root, 1 / (2 * root), -1 / (8 * root**3)
    return _take_closer(found, _expand(form, low, high, series, 1 / (16 * least**2.5)))


def _expand(
    form: LinearForm, low: Ends, high: Ends, series: tuple[Ends, Ends, Ends], last: Ends
) -> LinearForm:
    """Return a function's Taylor polynomial at the middle; `last` times u**3 bounds its error."""
    value, slope, half = series
    off = form.away()
    far = np.maximum(np.abs(high - form.middle), np.abs(low - form.middle))
    # The coefficients are rounded, too.
    slack = ROUNDED * (np.abs(value) + np.abs(slope) * far + np.abs(half) * far**2)
    rest = np.abs(last) * far**3 * (1 + ROUNDED) + slack
    bent = off * off * LinearForm(half, STILL, 0.0)
    return bent + off * LinearForm(slope, STILL, 0.0) + LinearForm(value, STILL, rest)


def _take_closer(plain: LinearForm, bent: LinearForm) -> LinearForm:
    """Return the bent form where its rest is smaller; in wide boxes it is not."""
    is_closer = bent.rest < plain.rest
    return LinearForm(
        *(
            np.where(is_closer, one, other)
            for one, other in (
                (bent.middle, plain.middle),
                (bent.changes, plain.changes),
                (bent.rest, plain.rest),
                (bent.bends, plain.bends),
            )
        )
    )


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
