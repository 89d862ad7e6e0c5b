"""The longest dwell of one drive."""

from __future__ import annotations

import math

from mechproof.arguments.scalars import refuse, require
from mechproof.mechanisms.dwells.band import Interval, find_longest, find_longest_of_equal
from mechproof.mechanisms.exact import Given, check_number
from mechproof.mechanisms.oval_planetary_kinds import OnePair, classify

NEVER = (math.nan, math.nan)
ALWAYS = (-math.inf, math.inf)


def find_longest_dwell(one: OnePair, eta: Given | None, band: float | None) -> Interval:
    """Return the interval of `OvalPlanetary.longest_dwell`, of two pairs that act as one."""
    if (eta is None) == (band is None):
        refuse("band", band, f"give it or eta, which is {eta!r}", TypeError)
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
        allowed = f"must be below half of what the output advances in a period, {drift / 2!r}"
        require(drift > 2 * band, "band", band, allowed)
        place = math.pi / (2 * k) if k > 1 else 0.0
        start, end = find_longest(k, e, band)
    return one.phase + place + start, one.phase + place + end
