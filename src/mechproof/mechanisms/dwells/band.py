"""The longest interval of the carrier in which a drive of oval wheels keeps its output in a band.

Near x = pi for R4 > R5, near x = 0 for R4 < R5, the output first becomes slow: at d from that place
it has moved by d - arctan(q tan(k d)) (rows "dwells, position from ..."), with the arctangent
continued. Here this is called `moved`, positive while the output turns back. Up to q k = 1 it does
not turn back, and the longest interval in a band is centred on the place. Beyond, this still holds
while it turns back by at most half the band; after that, the interval is about an angle where the
output turns.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from mechproof.arguments.scalars import refuse, require
from mechproof.mechanisms.oval_pairs import OnePair, classify
from mechproof.mechanisms.parameters import Given, check_number

Interval = tuple[float, float]


class Swing(NamedTuple):
    """A drive seen from the place where it first becomes slow: R4/R5, and q there."""

    k: float
    q: float

    @property
    def sign(self) -> int:
        """1 where the output runs against the carrier away from the place, else -1."""
        return 1 if self.k > 1 else -1

    @property
    def turning(self) -> float:
        """Carrier angle from the place to where the output turns; 0 if it does not."""
        ahead = (1 - self.k * self.q) / (self.q * (self.k - self.q))
        return math.atan(math.sqrt(ahead)) / self.k if ahead > 0 else 0.0

    @property
    def half(self) -> float:
        """Half of the period of the ratio in the carrier's angle."""
        return math.pi / (2 * self.k)

    def moved(self, d: float) -> float:
        """How far the output has moved back at d, less than a period from the place."""
        driver = self.k * d
        driven = math.atan2(self.q * math.sin(driver), math.cos(driver))
        return self.sign * (d - driven)


def start_swing(k: float, e: float) -> Swing:
    """Return the drive with R4/R5 = k, seen from the place where it first becomes slow."""
    q = (1 - e) / (1 + e)
    return Swing(k, q if k > 1 else 1 / q)


def find_longest(k: float, e: float, band: float) -> Interval:
    """Return the longest interval, counted from the place, with the output within +-band.

    The drift in a period must exceed the width of the band.
    """
    swing = start_swing(k, e)
    turn = swing.turning
    top = swing.moved(turn)
    if top <= band:
        end = _solve(swing, -band, turn, swing.half)
        return -end, end
    return _solve(swing, top - 2 * band, -turn, turn), _solve(
        swing, top - 2 * band, turn, swing.half
    )


def find_longest_of_equal(e: float, band: float) -> Interval:
    """Return the longest interval for R4 = R5, from x = 0; infinite if a band has all positions.

    In terms of the angle 2 phi1 - phi3 the output swings like a sine (row "dwells, equal circles");
    it is largest where that angle is 3/2 pi.
    """
    top = math.asin(e)
    if top <= band:
        return -math.inf, math.inf
    length = math.acos(math.cos(2 * band) - math.sin(2 * band) / math.tan(top))
    middle = 3 * math.pi / 4 + (top - 2 * band) / 2
    return middle - length / 2, middle + length / 2


def _solve(swing: Swing, wanted: float, low: float, high: float) -> float:
    from scipy.optimize import brentq

    root: float = brentq(lambda d: swing.moved(d) - wanted, low, high, xtol=1e-15, rtol=1e-15)
    return root


NEVER = (math.nan, math.nan)
ALWAYS = (-math.inf, math.inf)


def find_longest_dwell(one: OnePair, eta: Given | None, band: float | None) -> Interval:
    """Return the interval of `OvalPlanetary.longest_dwell` for two pairs that act as one."""
    if (eta is None) == (band is None):
        refuse("band", band, f"give exactly one of band and eta = {eta!r}", TypeError)
    if band is None:
        limit = check_number("eta", eta)
        require(limit > 0, "eta", eta, "must be positive")
        found = classify(one, limit)
        if found.kind == "rest":
            return ALWAYS
        return max(found.rests, key=lambda rest: rest[1] - rest[0], default=NEVER)
    half = check_number("band", band)
    require(0 < half < math.pi / 4, "band", band, "must be above 0 and below pi/4")
    return _keep_within(one, float(half))


def _keep_within(one: OnePair, band: float) -> Interval:
    k, e = float(one.rate), float(one.e)
    if one.rate == 1:
        place, (start, end) = 0.0, find_longest_of_equal(e, band)
    else:
        drift = math.pi * abs(k - 1) / k
        allowed = f"must be below half the output's advance in a period, {drift / 2!r}"
        require(drift > 2 * band, "band", band, allowed)
        place = math.pi / (2 * k) if k > 1 else 0.0
        start, end = find_longest(k, e, band)
    return one.phase + place + start, one.phase + place + end
