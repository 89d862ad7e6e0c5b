"""Intervals: two arrays of doubles, the ends over many boxes at once, rounded outward.

A product that would fall below the normal range is an error of floating point: NumPy raises it
under `careful`, and only those boxes for which it does pay for ends moved away from there. Interval
arithmetic is that of Moore (1966), one operation for many boxes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from mechproof.arithmetic.balls import working_precision

Array = NDArray[np.float64]
Ends = Any
Mask = Any
# The spacing of doubles at 1, and the largest relative error of rounding to nearest.
EPS, UNIT = 2.0**-52, 2.0**-53
# Numbers that are smaller, but not zero, may be rounded by more than a share of themselves.
LEAST_NORMAL = 2.0**-1022
# Twice the relative error of an end that was rounded to nearest.
OUTWARD = EPS
# Products of two numbers of this size stay within the normal range.
SMALLEST = 1e-100
BITS = 64
KEPT = 2**17
# A little less than pi, and less than the first pole of the tangent, in radians.
BEFORE_PI, BEFORE_POLE = 3.1415926535, 1.5707963267
# A function of flint's balls.
Function = Callable[[Any], Any]


class Interval:
    """All numbers from `low` to `high`; not finite where nothing is known."""

    __slots__ = ("_sign", "high", "low")

    def __init__(self, low: Ends, high: Ends, sign: int | None = None) -> None:
        self.low, self.high = low, high
        self._sign = sign

    @property
    def sign(self) -> int:
        """Return 1 if no number anywhere is negative, -1 if none is positive, 0 otherwise."""
        if self._sign is None:
            self._sign = 1 if self.low.min() >= 0 else -1 if self.high.max() <= 0 else 0
        return self._sign

    @property
    def is_finite(self) -> Mask:
        """Say where both ends are numbers."""
        return np.isfinite(self.low) & np.isfinite(self.high)

    def __neg__(self) -> Interval:
        return Interval(-self.high, -self.low, None if self._sign is None else -self._sign)

    def __add__(self, other: Interval) -> Interval:
        # Two intervals without a sign may have a sum with one, which is found when asked for.
        sign = self._sign if self._sign == other._sign else None
        return widen(self.low + other.low, self.high + other.high, sign or None)

    def __sub__(self, other: Interval) -> Interval:
        return widen(self.low - other.high, self.high - other.low)

    def __mul__(self, other: Interval) -> Interval:
        if other is ONE:
            return self
        if self is ONE:
            return other
        return _multiply(self, other)

    def __truediv__(self, other: Interval) -> Interval:
        return self if other is ONE else self * other.inverted()

    def inverted(self) -> Interval:
        """Return the reciprocals; not finite where zero is among the numbers."""
        apart = (self.low > 0) | (self.high < 0)
        return widen(
            np.divide(1.0, np.where(apart, self.high, np.nan)),
            np.divide(1.0, np.where(apart, self.low, np.nan)),
        )

    def size(self) -> Interval:
        """Return the absolute values."""
        if self.sign:
            return self if self.sign > 0 else -self
        low = np.maximum(np.maximum(self.low, -self.high), 0.0)
        return Interval(low, np.maximum(-self.low, self.high))

    def largest(self) -> Ends:
        """Return the largest absolute value."""
        return np.maximum(-self.low, self.high)

    def union(self, other: Interval) -> Interval:
        """Return the hull of both."""
        return Interval(np.minimum(self.low, other.low), np.maximum(self.high, other.high))

    def intersection(self, other: Interval) -> Interval:
        """Return the numbers in both intervals; where one is not finite, the other."""
        one, two = self.is_finite, other.is_finite
        return Interval(
            np.where(
                one & two, np.maximum(self.low, other.low), np.where(one, self.low, other.low)
            ),
            np.where(
                one & two, np.minimum(self.high, other.high), np.where(one, self.high, other.high)
            ),
        )

    def power(self, exponent: int) -> Interval:
        """Return a whole power."""
        if exponent < 0:
            return self.power(-exponent).inverted()
        # Multiplied with itself, an interval could give an even power negative ends.
        base = self.size() if exponent % 2 == 0 else self
        return Interval(_raise(base.low, exponent).low, _raise(base.high, exponent).high)

    def sqrt(self) -> Interval:
        """Return the roots."""
        return widen(np.sqrt(self.low), np.sqrt(self.high))


def _raise(end: Ends, exponent: int) -> Interval:
    base = value = Interval(end, end)
    for _ in range(exponent - 1):
        value *= base
    return value


def list_corners(a: Interval, b: Interval) -> tuple[tuple[Ends, Ends], tuple[Ends, Ends]] | None:
    """Return the ends whose products are the smallest and the largest, if signs tell them."""
    sign, other = a.sign, b.sign
    if not (sign and other):
        return None
    if sign > 0:
        if other > 0:
            return (a.low, b.low), (a.high, b.high)
        return (a.high, b.low), (a.low, b.high)
    if other > 0:
        return (a.low, b.high), (a.high, b.low)
    return (a.high, b.high), (a.low, b.low)


def _multiply(a: Interval, b: Interval) -> Interval:
    if corners := list_corners(a, b):
        (p, q), (r, s) = corners
        return widen(p * q, r * s, a.sign * b.sign)
    if a.sign or b.sign:
        one, other = (a, b) if a.sign else (b, a)
        if one.sign < 0:
            one, other = -one, -other
        return widen(
            np.minimum(one.low * other.low, one.high * other.low),
            np.maximum(one.low * other.high, one.high * other.high),
        )
    # Minimum and maximum pass NaN on, so that what is not finite stays so.
    p, q, r, s = a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high
    return widen(
        np.minimum(np.minimum(p, q), np.minimum(r, s)),
        np.maximum(np.maximum(p, q), np.maximum(r, s)),
    )


_mode = {"moves": False}


@contextmanager
def careful(*, moves: bool) -> Iterator[None]:
    """Raise FloatingPointError for numbers that are too small; `moves` widens such ends instead."""
    before = _mode["moves"]
    _mode["moves"] = moves
    try:
        with np.errstate(all="ignore", under="raise"):
            yield
    finally:
        _mode["moves"] = before


def widen(low: Ends, high: Ends, sign: int | None = None) -> Interval:
    """Return the interval between two ends that were rounded to nearest; `sign` if it is known."""
    if _mode["moves"]:
        low = np.where(np.abs(low) < SMALLEST, np.minimum(np.sign(low), 0.0) * SMALLEST, low)
        high = np.where(np.abs(high) < SMALLEST, np.maximum(np.sign(high), 0.0) * SMALLEST, high)
    if sign:
        # One factor moves each end outward, and no absolute values are taken.
        outward = sign * OUTWARD
        return Interval(low * (1 - outward), high * (1 + outward), sign)
    return Interval(low - np.abs(low) * OUTWARD, high + np.abs(high) * OUTWARD)


def exactly(number: float) -> Interval:
    """Return the interval of one double."""
    end = np.float64(number)
    return Interval(end, end)


def around(middle: float, reach: Ends) -> Interval:
    """Return an interval around a double."""
    return widen(middle - np.asarray(reach), middle + np.asarray(reach))


def enclose_ball(ball: Any) -> Interval:
    """Return an interval that holds a ball of flint's."""
    return widen(np.float64(float(ball.lower())), np.float64(float(ball.upper())))


def between(low: Ends, high: Ends) -> Interval:
    """Return an interval between doubles; not finite for an endless one."""
    endless = ~np.isfinite(high - low)
    return Interval(np.where(endless, np.nan, low), np.where(endless, np.nan, high))


def list_spans(boxes: Array) -> list[Interval]:
    """Return the interval of each side, in many boxes at once, shape (boxes, sides, 2)."""
    return [between(boxes[:, i, 0], boxes[:, i, 1]) for i in range(boxes.shape[1])]


ONE = exactly(1.0)
with working_precision(BITS):
    PI = enclose_ball(arb.pi())


# Cached, because halved boxes share ends.
@lru_cache(KEPT)
def _enclose(function: Function, value: float) -> tuple[float, float]:
    if not math.isfinite(value):
        return math.nan, math.nan
    with working_precision(BITS):
        ball = function(arb(value))
        return float(ball.lower()), float(ball.upper())


def apply(function: Function, values: Ends) -> Interval:
    """Return a function at doubles."""
    # Boxes that lie side by side share ends, too.
    some, places = np.unique(values, return_inverse=True)
    found = np.array([_enclose(function, value) for value in some.tolist()])
    return widen(found[places, 0], found[places, 1])


def _rise(function: Function, z: Interval) -> Interval:
    return Interval(apply(function, z.low).low, apply(function, z.high).high)


def tangent(z: Interval) -> Interval:
    """Return tangents; not finite beyond the first pole."""
    known = z.largest() < BEFORE_POLE
    return _rise(arb.tan, Interval(np.where(known, z.low, np.nan), np.where(known, z.high, np.nan)))


def cotangent(z: Interval) -> Interval:
    """Return cotangents; not finite where z is zero or beyond half a turn."""
    known = (z.largest() < BEFORE_PI) & ((z.low > 0) | (z.high < 0))
    low, high = np.where(known, z.low, np.nan), np.where(known, z.high, np.nan)
    return Interval(apply(arb.cot, high).low, apply(arb.cot, low).high)


def arctangent(z: Interval) -> Interval:
    """Return arctangents."""
    return _rise(arb.atan, z)


def exponential(z: Interval) -> Interval:
    """Return exponentials."""
    return _rise(arb.exp, z)


def logarithm(z: Interval) -> Interval:
    """Return logarithms; not finite where z is not positive."""
    known = z.low > 0
    return _rise(arb.log, Interval(np.where(known, z.low, np.nan), np.where(known, z.high, np.nan)))


def sine(z: Interval) -> Interval:
    """Return sines."""
    return _wave(arb.sin, z, np.float64(0.25))


def cosine(z: Interval) -> Interval:
    """Return cosines."""
    return _wave(arb.cos, z, np.float64(0.0))


def _wave(function: Function, z: Interval, crest: Ends) -> Interval:
    """Return a wave; `crest` is where it is largest, in turns."""
    ends = apply(function, z.low).union(apply(function, z.high))
    turns = z / (PI * exactly(2.0))
    # The margin of 1e-9 may count a crest too many, which only widens the result.
    top = np.floor(turns.high - crest + 1e-9) >= np.ceil(turns.low - crest - 1e-9)
    trough = crest + 0.5
    bottom = np.floor(turns.high - trough + 1e-9) >= np.ceil(turns.low - trough - 1e-9)
    low, high = np.maximum(ends.low, -1.0), np.minimum(ends.high, 1.0)
    return Interval(np.where(bottom, -1.0, low), np.where(top, 1.0, high))
