"""Intervals: two arrays of doubles, the ends over many boxes at once, rounded outward.

A product that falls below the normal range is a floating-point error, which NumPy raises under
`careful`; only boxes for which that happens pay for ends moved away from there. Interval arithmetic
is that of Moore (1966), one operation for many boxes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.linear_forms import (
    STILL,
    LinearForm,
    along,
    follow,
    invert,
    state,
    take_root,
)

Array = NDArray[np.float64]
Ends = Any
Mask = Any
# The spacing of doubles at 1, and the largest relative error of rounding to nearest.
EPS, UNIT = 2.0**-52, 2.0**-53
# Nonzero numbers smaller than this may have larger relative rounding errors.
LEAST_NORMAL = 2.0**-1022
# Twice the relative error of an end that was rounded to nearest.
OUTWARD = EPS
# Products of two numbers of this size stay within the normal range.
SMALLEST = 1e-100
BITS = 64


class Interval:
    """All numbers from `low` to `high`; not finite where nothing is known.

    With a `form` they are the values of a quantity that is known along the sides of boxes.
    """

    __slots__ = ("_sign", "form", "high", "low")

    def __init__(
        self, low: Ends, high: Ends, sign: int | None = None, form: LinearForm | None = None
    ) -> None:
        self.low, self.high, self.form = low, high, form
        self._sign = sign

    def narrowed(self, take: Callable[..., LinearForm], *given: Any) -> Interval:
        """Return the intersection with the linear form that `take` makes of the given arguments."""
        # The forms themselves account for numbers that are too small.
        with np.errstate(under="ignore"):
            form = take(*given)
            low = np.fmax(self.low, form.middle - form.reach)
            high = np.fmin(self.high, form.middle + form.reach)
        return Interval(low, high, self._sign or None, form)

    @property
    def stated(self) -> LinearForm:
        """Return the form, or that of the ends alone."""
        return self.form or state(self.low, self.high)

    @property
    def sign(self) -> int:
        """Return 1 if no number anywhere is negative, -1 if none is positive, 0 otherwise."""
        if self._sign is None:
            self._sign = 1 if self.low.min() >= 0 else -1 if self.high.max() <= 0 else 0
        return self._sign

    @property
    def is_finite(self) -> Mask:
        """Return where both ends are finite."""
        return np.isfinite(self.low) & np.isfinite(self.high)

    def __neg__(self) -> Interval:
        sign = None if self._sign is None else -self._sign
        return Interval(-self.high, -self.low, sign, -self.form if self.form else None)

    def __add__(self, other: Interval) -> Interval:
        # Two intervals without a sign may have a sum with one, which is found when asked for.
        sign = self._sign if self._sign == other._sign else None
        total = widen(self.low + other.low, self.high + other.high, sign or None)
        if self.form or other.form:
            return total.narrowed(LinearForm.__add__, self.stated, other.stated)
        return total

    def __sub__(self, other: Interval) -> Interval:
        if self.form or other.form:
            return self + -other
        return widen(self.low - other.high, self.high - other.low)

    def __mul__(self, other: Interval) -> Interval:
        if other is ONE:
            return self
        if self is ONE:
            return other
        product = _multiply(self, other)
        if self.form or other.form:
            return product.narrowed(LinearForm.__mul__, self.stated, other.stated)
        return product

    def __truediv__(self, other: Interval) -> Interval:
        return self if other is ONE else self * other.inverted()

    def inverted(self) -> Interval:
        """Return the reciprocals; not finite where zero is among the numbers."""
        apart = (self.low > 0) | (self.high < 0)
        low, high = np.where(apart, self.low, np.nan), np.where(apart, self.high, np.nan)
        found = widen(np.divide(1.0, high), np.divide(1.0, low))
        return found.narrowed(invert, self.form, low, high) if self.form else found

    def size(self) -> Interval:
        """Return the moduli."""
        if self.sign:
            return self if self.sign > 0 else -self
        low = np.maximum(np.maximum(self.low, -self.high), 0.0)
        found = Interval(low, np.maximum(-self.low, self.high))
        if self.form is None:
            return found
        sign = np.where(self.low >= 0, 1.0, np.where(self.high <= 0, -1.0, np.nan))
        return found.narrowed(LinearForm.__mul__, self.form, LinearForm(sign, STILL, 0.0))

    def largest(self) -> Ends:
        """Return the largest modulus."""
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
        # Multiplied by itself, an interval could give an even power negative ends.
        base = self.size() if exponent % 2 == 0 else self
        found = Interval(_raise(base.low, exponent).low, _raise(base.high, exponent).high)
        if self.form is None or exponent == 0:
            return found
        if exponent == 2:
            return found.narrowed(LinearForm.square, self.form)
        return self if exponent == 1 else found.narrowed(_raise_form, self.form, exponent)

    def sqrt(self) -> Interval:
        """Return the square roots."""
        found = widen(np.sqrt(self.low), np.sqrt(self.high))
        return found.narrowed(take_root, self.form, self.low, self.high) if self.form else found

    def follow(
        self, z: Interval, values: tuple[Interval, Interval], slopes: Interval, bend: Ends
    ) -> Interval:
        """Narrow the values of a function of `z`, given its values at both ends and its slopes.

        `bend` is 1 where it is convex, -1 where it is concave.
        """
        if z.form is None:
            return self
        return self.narrowed(follow, z.form, (z.low, z.high), values, slopes, bend)

    @property
    def signs(self) -> Ends:
        """Return 1 where no number is negative, -1 where none is positive, 0 elsewhere."""
        return np.where(self.low >= 0, 1, np.where(self.high <= 0, -1, 0))


def _raise(end: Ends, exponent: int) -> Interval:
    base = value = Interval(end, end)
    for _ in range(exponent - 1):
        value *= base
    return value


def _raise_form(form: LinearForm, exponent: int) -> LinearForm:
    if exponent == 1:
        return form
    half = _raise_form(form, exponent // 2).square()
    return half * form if exponent % 2 else half


def list_corners(a: Interval, b: Interval) -> tuple[tuple[Ends, Ends], tuple[Ends, Ends]] | None:
    """Return the ends with the least and with the largest product; None if signs do not decide."""
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
    # Minimum and maximum pass NaN on, so that non-finite values stay non-finite.
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
        # One factor moves each end outward, and no moduli are taken.
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
    """Return an interval that contains a ball of flint's."""
    return widen(np.float64(float(ball.lower())), np.float64(float(ball.upper())))


def between(low: Ends, high: Ends) -> Interval:
    """Return an interval between doubles; not finite if it is infinite."""
    endless = ~np.isfinite(high - low)
    return Interval(np.where(endless, np.nan, low), np.where(endless, np.nan, high))


def list_spans(boxes: Array, *, has_forms: bool = False, is_bent: bool = False) -> list[Interval]:
    """Return the interval of each side, for many boxes at once, shape (boxes, sides, 2).

    With `has_forms`, sides that are finite in all boxes have linear forms: bent ones if `is_bent`.
    """
    spans = [between(boxes[:, i, 0], boxes[:, i, 1]) for i in range(boxes.shape[1])]
    finite = [span for span in spans if has_forms and np.all(span.is_finite)]
    for side, span in enumerate(finite):
        span.form = along(side, len(finite), span.low, span.high, is_bent=is_bent)
    return spans


ONE = exactly(1.0)
with working_precision(BITS):
    PI = enclose_ball(arb.pi())
