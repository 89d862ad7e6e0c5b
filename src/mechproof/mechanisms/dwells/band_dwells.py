"""All eccentricities at which the output stays in a band over a given carrier angle, by R4/R5.

Let w be the angle, +-b the band, k = R4/R5, q and `moved` as in `band`. That the search is complete
rests on these facts; "row" names a proved row of the ledger.

1. If the output does not turn back (q k >= 1 for k > 1, <= 1 for k < 1), its speed has its least
   size at the place and grows on both sides, so the least movement over w is that about the place:
   the condition is moved(w/2) >= -b.
2. moved(d) rises with e2 at every d, because arctan(q t) rises with q (row "... turns back").
3. The output turns back by at most M, which rises with e2 (row "... how far the output turns
   back"). While M <= b, the longest interval in the band is that about the place: a band that
   contains one turn of the output contains both, and beyond them the movement is convex.
4. For M > b, an interval in the band contains only one turn, because the other swing is longer than
   the band by the drift. The larger e2 is, the smaller is the carrier angle in which the drive
   passes from any speed to any other (row "... time spent at a speed"). So it takes less angle to
   move away from the turn by a given distance: with a lower speed function, more of the distance is
   covered at higher speeds, each of which takes less. For distances beyond the middle of the swing
   this needs a swing that grows with e2, as it does for k >= 1, and for k < 1 while
   k (q + 1/q) < 2.
5. So at each k the eccentricities form one interval: moved(w/2) >= -b begins it, and M = b or the
   interval about a turn ends it.
6. If w is a period or more, the output drifts by more than the band.

Fact 4 is used only where its conditions hold; otherwise the ratio is left open.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from mechproof.mechanisms.dwells.ball_decisions import EnclosedDrive, Open, as_ball, is_above, sure
from mechproof.mechanisms.dwells.band import find_longest, find_longest_of_equal, start_swing
from mechproof.mechanisms.dwells.ratio import MARGIN, Span


class BandRequest(NamedTuple):
    """Carrier angle, half the band and the largest eccentricity, all exact."""

    width: Fraction
    band: Fraction
    largest_e: Fraction


def find_spans(k: Fraction, asked: BandRequest) -> list[Span]:
    """Return the interval of eccentricities, if there is one.

    Raises `Open` if it could not be decided.
    """
    if k == 1:
        return _find_equal(asked)
    period = as_ball(1).pi() / as_ball(k)
    drift = period * abs(as_ball(k) - 1)
    if not drift > 2 * as_ball(asked.band):
        raise Open("in a period the output drifts by no more than the band")
    if sure(is_above(as_ball(asked.width), period), "whether w is above the period"):
        return []
    return _find_one(k, asked)


def _find_one(k: Fraction, asked: BandRequest) -> list[Span]:
    limit = asked.largest_e
    peak = _find_peak(k, asked)
    best = limit if peak is None else peak - MARGIN
    last = limit if peak is None else peak + MARGIN
    half = as_ball(asked.width) / 2
    # It rises with e2: if it is below zero at the last eccentricity, it is so everywhere.
    if EnclosedDrive(k, last).moved(half) + as_ball(asked.band) < 0:
        return []
    if not _holds(k, best, asked):
        raise Open("the longest dwell is just as wide as asked, to 1e-9 of e2")
    low = _find_low(k, asked)
    high = limit if peak is None else _find_high(k, peak, asked)
    start, end = find_longest(float(k), float(best), float(asked.band))
    exact = abs(k - 1) / (k + 1)
    return [
        Span(
            place="slowest" if k > 1 else "fastest",
            low=low,
            high=high,
            exact=exact if low <= exact <= high else None,
            best=best,
            width=end - start,
        )
    ]


def _find_peak(k: Fraction, asked: BandRequest) -> Fraction | None:
    """Return the e2 at which the output turns back by the band; None if there is none."""
    at_limit = EnclosedDrive(k, asked.largest_e)
    if not at_limit.turns_back or sure(
        is_above(as_ball(asked.band), at_limit.top), "whether M at the limit is below b"
    ):
        return None

    def excess(e: float) -> float:
        swing = start_swing(float(k), e)
        return swing.moved(swing.turning) - float(asked.band)

    first = float(abs(k - 1) / (k + 1))
    peak = _solve(excess, first, float(asked.largest_e))
    before, after = EnclosedDrive(k, peak - MARGIN), EnclosedDrive(k, peak + MARGIN)
    below = not before.turns_back or as_ball(asked.band) > before.top
    if not (below and after.top > as_ball(asked.band)):
        raise Open("M = b was not enclosed")
    return peak


def _find_low(k: Fraction, asked: BandRequest) -> Fraction:
    """Return the least e2, where the movement about the place equals the band; 0 if all hold."""
    half, band, ratio = float(asked.width) / 2, float(asked.band), float(k)
    if ratio > 1:
        q = math.tan(min(half + band, math.pi / 2)) / math.tan(ratio * half)
        e = (1 - q) / (1 + q)
    else:
        q = math.tan(max(half - band, 0.0)) / math.tan(ratio * half)
        e = (q - 1) / (q + 1)
    if e <= 0:
        return Fraction(0)
    low = Fraction(e)
    ball = as_ball(asked.width) / 2

    def spare(e: Fraction) -> Any:
        return EnclosedDrive(k, e).moved(ball) + as_ball(asked.band)

    if not (spare(low + MARGIN) > 0 and (low <= MARGIN or spare(low - MARGIN) < 0)):
        raise Open("the least e2 was not enclosed")
    return low + MARGIN


def _find_high(k: Fraction, peak: Fraction, asked: BandRequest) -> Fraction:
    """Return the largest e2, where the interval about a turn is as wide as asked."""
    limit, band = asked.largest_e, float(asked.band)
    if peak + MARGIN >= limit or not _holds(k, peak + MARGIN, asked):
        return peak - MARGIN
    _check_monotone(k, asked)
    if _holds(k, limit, asked):
        return limit

    def excess(e: float) -> float:
        start, end = find_longest(float(k), e, band)
        return end - start - float(asked.width)

    high = _solve(excess, float(peak + MARGIN), float(limit))
    if not _holds(k, high - MARGIN, asked) or _holds(k, high + MARGIN, asked):
        raise Open("the largest e2 was not enclosed")
    return high - MARGIN


def _check_monotone(k: Fraction, asked: BandRequest) -> None:
    """Raise `Open` unless the swing certainly grows with e2 while it is within the whole band."""
    first = abs(k - 1) / (k + 1)
    e = asked.largest_e
    while k < 1:
        drive = EnclosedDrive(k, e)
        q = drive.exact[1]
        beyond = e == asked.largest_e or drive.top > 2 * as_ball(asked.band)
        if not beyond or e - first < MARGIN:
            raise Open("the swing is not shown to grow with e2")
        if k * (q + 1 / q) < 2:
            return
        e = first + (e - first) / 2


def _holds(k: Fraction, e: Fraction, asked: BandRequest) -> bool:
    """Return, decided in balls, whether the output stays in the band over the angle."""
    drive, width, band = EnclosedDrive(k, e), as_ball(asked.width), as_ball(asked.band)
    if not drive.turns_back or sure(is_above(band, drive.top), "whether M is below b"):
        return sure(
            is_above(drive.moved(width / 2), -band), "whether the width fits about the place"
        )
    a = _place_about_turn(drive, float(asked.width))
    start, bottom = as_ball(a), drive.top - 2 * band
    end = start + width
    if not (drive.goes_back(start) is True and drive.goes_back(end) is False):
        raise Open("the interval about a turn was not enclosed")
    if not as_ball(1).pi() / drive.k > end:
        raise Open("the interval about a turn is longer than a period")
    ends = drive.moved(start), drive.moved(end)
    # An interval that starts earlier is lower at its start, one that starts later at its end.
    if all(value >= bottom for value in ends):
        return True
    if all(value < bottom for value in ends):
        return False
    raise Open("whether the width fits about a turn")


def _place_about_turn(drive: EnclosedDrive, width: float) -> float:
    """Return the start of the interval about a turn with equal positions at both ends."""
    swing = drive.floats
    low, high = -swing.turning, min(swing.turning, 2 * swing.half - swing.turning - width)
    if swing.moved(low) >= swing.moved(low + width):
        return low + 1e-12
    return float(_solve(lambda a: swing.moved(a) - swing.moved(a + width), low, high))


def _find_equal(asked: BandRequest) -> list[Span]:
    """Return the interval for R4 = R5 (row "dwells, equal circles"): L falls as M rises."""
    width, band, limit = map(as_ball, asked)
    least = band.sin()
    if not sure(is_above(limit, least), "whether sin(b) is below the limit") or width >= width.pi():
        return []
    rest = (2 * band).cos() - width.cos()
    top = ((2 * band).sin() / rest).atan() if rest > 0 else width.pi() / 2
    low = Fraction(float(least.upper()))
    largest = top.sin()
    at_limit = sure(is_above(largest, limit), "whether the largest e2 is above the limit")
    high = asked.largest_e if at_limit else Fraction(float(largest.lower()))
    best = min(low + MARGIN, high)
    start, end = find_longest_of_equal(float(best), float(asked.band))
    return [Span("turns", low, high, None, best, end - start)]


def _solve(function: Callable[[float], float], low: float, high: float) -> Fraction:
    from scipy.optimize import brentq

    return Fraction(brentq(function, low, high, xtol=1e-15, rtol=1e-15))
