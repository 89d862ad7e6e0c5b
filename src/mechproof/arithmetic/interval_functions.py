"""Interval functions: elementary functions of intervals, by balls at their ends.

If the argument has a linear form, so has the result: by its values at both ends, its slopes between
them, and where it is convex or concave.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from flint import arb

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.intervals import BITS, ONE, PI, Ends, Interval, Mask, exactly, widen

KEPT = 2**17
# A little less than pi, and less than the first pole of the tangent, in radians.
BEFORE_PI, BEFORE_POLE = 3.1415926535, 1.5707963267
# A function of flint's balls.
Function = Callable[[Any], Any]
Slope = Callable[[Interval], Interval]
# Values everywhere, and those at both ends.
Wave = tuple[Interval, tuple[Interval, Interval]]


# Cached, because halved boxes share ends.
@lru_cache(KEPT)
def _enclose(function: Function, value: float) -> tuple[float, float]:
    if not math.isfinite(value):
        return math.nan, math.nan
    with working_precision(BITS):
        ball = function(arb(value))
        return float(ball.lower()), float(ball.upper())


def apply(function: Function, values: Ends) -> Interval:
    """Return enclosures of a function at doubles."""
    # Adjacent boxes share ends, too.
    some, places = np.unique(values, return_inverse=True)
    found = np.array([_enclose(function, value) for value in some.tolist()])
    return widen(found[places, 0], found[places, 1])


def _rise(function: Function, z: Interval, slope: Slope, bend: Slope) -> Interval:
    """Return a monotone function of z; `slope` and the sign of `bend` follow from its value."""
    first, last = apply(function, z.low), apply(function, z.high)
    found = first.union(last)
    if z.form is None:
        return found
    return found.follow(z, (first, last), slope(found), bend(found).signs)


def _keep(z: Interval, known: Mask) -> Interval:
    """Keep the intervals where a mask says so; elsewhere they are not finite."""
    return Interval(np.where(known, z.low, np.nan), np.where(known, z.high, np.nan), form=z.form)


def _forget(z: Interval) -> Interval:
    return Interval(z.low, z.high)


def tangent(z: Interval) -> Interval:
    """Return tangents; not finite beyond the first pole."""
    known = _keep(z, z.largest() < BEFORE_POLE)
    return _rise(arb.tan, known, lambda t: ONE + t.power(2), lambda t: t)


def cotangent(z: Interval) -> Interval:
    """Return cotangents; not finite where z is zero or beyond half a turn."""
    known = _keep(z, (z.largest() < BEFORE_PI) & ((z.low > 0) | (z.high < 0)))
    return _rise(arb.cot, known, lambda t: -(ONE + t.power(2)), lambda t: t)


def arctangent(z: Interval) -> Interval:
    """Return arctangents."""
    slope = (ONE + _forget(z).power(2)).inverted()
    return _rise(arb.atan, z, lambda _: slope, lambda angle: -angle)


def exponential(z: Interval) -> Interval:
    """Return exponentials."""
    return _rise(arb.exp, z, lambda value: value, lambda value: value)


def logarithm(z: Interval) -> Interval:
    """Return logarithms; not finite where z is not positive."""
    known = _keep(z, z.low > 0)
    return _rise(arb.log, known, lambda _: _forget(known).inverted(), lambda _: -ONE)


def sine(z: Interval) -> Interval:
    """Return sines."""
    return _follow_wave(_wave(arb.sin, z, 0.25), z, lambda: cosine(_forget(z)))


def cosine(z: Interval) -> Interval:
    """Return cosines."""
    return _follow_wave(_wave(arb.cos, z, 0.0), z, lambda: -sine(_forget(z)))


def _follow_wave(wave: Wave, z: Interval, slope: Callable[[], Interval]) -> Interval:
    found, values = wave
    return found.follow(z, values, slope(), -found.signs) if z.form else found


def _wave(function: Function, z: Interval, crest: float) -> Wave:
    """Return a wave, and its values at both ends; `crest` is where it is largest, in turns."""
    first, last = apply(function, z.low), apply(function, z.high)
    ends = first.union(last)
    turns = _forget(z) / (PI * exactly(2.0))
    # The margin of 1e-9 may count a crest too many, which only widens the result.
    top = np.floor(turns.high - crest + 1e-9) >= np.ceil(turns.low - crest - 1e-9)
    trough = crest + 0.5
    bottom = np.floor(turns.high - trough + 1e-9) >= np.ceil(turns.low - trough - 1e-9)
    low, high = np.maximum(ends.low, -1.0), np.minimum(ends.high, 1.0)
    found = Interval(np.where(bottom, -1.0, low), np.where(top, 1.0, high))
    return found, (first, last)
