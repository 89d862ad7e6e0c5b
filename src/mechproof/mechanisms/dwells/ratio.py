"""All eccentricities at which |ratio| <= eta over a given carrier angle, by R4/R5.

With v = 1 - ratio, the speed of wheel 3 against the carrier, the output is slow while
1 - eta <= v <= 1 + eta, and v falls from x = 0 to x = pi. Such an interval lies about x = pi, about
x = 0, or between the two. About either, v > u at an angle x from there is a quadratic condition on
e2 (row "dwells, ratio within eta at an angle"). Between them, the larger e2 is, the smaller is the
carrier angle from one speed to the other (row "dwells, time spent at a speed"). So all ends are
roots in closed form except one, the only root of a decreasing function. Drives whose ratio is
within eta throughout are at rest, and are left out.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Literal, NamedTuple

from mechproof.mechanisms.dwells.ball_decisions import Open, as_ball, is_above, sure
from mechproof.mechanisms.oval_pairs import OnePair, classify

End = Any  # a Fraction, or a ball


class RestRequest(NamedTuple):
    """Carrier angle, largest |ratio| of a rest and the largest eccentricity, all exact."""

    width: Fraction
    eta: Fraction
    largest_e: Fraction


class Speeds(NamedTuple):
    """R4/R5 and the least and the largest speed of wheel 3 against the carrier in a rest."""

    k: Fraction
    least: Fraction
    largest: Fraction

    def angle(self, e: Fraction, speed: Fraction) -> Any:
        """Return x where the wheel has a speed, as a ball, limited to [0, pi]."""
        exact = (1 + e * e - self.k / speed * (1 - e * e)) / (2 * e)
        if not -1 < exact < 1:
            return as_ball(0) if exact >= 1 else as_ball(1).pi()
        return as_ball(exact).acos()


def find_longest(k: Fraction, e: Fraction, eta: Fraction) -> float:
    """Return the longest carrier angle over which |ratio| <= eta."""
    found = classify(OnePair(k, e, 1 - e, 0.0), eta)
    if found.kind == "rest":
        return math.inf
    return max((end - start for start, end in found.rests), default=0.0)


def find_spans(k: Fraction, asked: RestRequest) -> list[Span]:
    """Return the intervals of eccentricities, in ascending order.

    Raises `Open` if they could not be decided.
    """
    speeds = Speeds(k, 1 - asked.eta, 1 + asked.eta)
    half = as_ball(k) * as_ball(asked.width)
    if sure(is_above(half, half.pi()), "whether w is above the period"):
        return []
    found: dict[Place, list[tuple[End, End]]] = {
        "slowest": _find_about_pi(speeds, half, asked),
        "fastest": _find_about_0(speeds, half, asked),
        "turns": _find_between(speeds, half, asked),
    }
    spans = [_write(k, asked, at, *ends) for at, intervals in found.items() for ends in intervals]
    return sorted(spans, key=lambda span: span.low)


def _write(k: Fraction, asked: RestRequest, place: Place, low: End, high: End) -> Span:
    """Return a span of doubles inside the interval; ends that are fractions stay exact."""
    inner = [
        low if isinstance(low, Fraction) else Fraction(math.nextafter(float(low.upper()), 1.0)),
        high if isinstance(high, Fraction) else Fraction(math.nextafter(float(high.lower()), 0.0)),
    ]
    exact, (a, b) = abs(k - 1) / (k + 1), inner
    if b < a:
        raise Open("the interval of e2 is no wider than a double")
    # Open where the ratio is within eta throughout, or the interval about a place begins.
    if place == "turns" or (
        a == abs(k - 1 - asked.eta) / (k + 1 + asked.eta) and k <= 1 + asked.eta
    ):
        a = min(a + MARGIN, b)
    candidates = [a, b, *_stationary(k, asked, a, b)]
    widths = [find_longest(k, e, asked.eta) for e in candidates]
    width = max(widths)
    best = candidates[widths.index(width)]
    return Span(place, inner[0], b, exact if inner[0] <= exact <= b else None, best, width)


def _stationary(k: Fraction, asked: RestRequest, a: Fraction, b: Fraction) -> list[Fraction]:
    """Return an e2 in (a, b) with the longest interval about x = 0: (q + 1/q) k/(1 - eta) = 2."""
    spread = 2 * float((1 - asked.eta) / k)
    if spread <= 2:
        return []
    e = Fraction(math.sqrt((spread - 2) / (spread + 2)))
    return [e] if a < e < b else []


def _cut(low: list[End], high: list[End]) -> list[tuple[End, End]]:
    """Return the interval from the largest of `low` to the least of `high`, unless it is empty."""
    first, last = low[0], high[0]
    for end in low[1:]:
        first = end if sure(is_above(end, first), "which of two ends is larger") else first
    for end in high[1:]:
        last = end if sure(is_above(last, end), "which of two ends is larger") else last
    return [(first, last)] if sure(is_above(last, first), "whether an interval is empty") else []


def _find_about_pi(speeds: Speeds, half: Any, asked: RestRequest) -> list[tuple[End, End]]:
    k, least, largest = speeds
    low = [abs(k - largest) / (k + largest)]
    high = [(k - least) / (k + least), asked.largest_e]
    # (largest + k) e² + 2 largest cos(half) e + largest - k >= 0
    u, scale = as_ball(largest), as_ball(largest + k)
    discriminant = as_ball(k) ** 2 - (u * half.sin()) ** 2
    if not _cut(low, high) or discriminant < 0:
        return _cut(low, high)
    root = _root_of(discriminant)
    ends = [(-u * half.cos() + sign * root) / scale for sign in (-1, 1)]
    return [*_cut(low, [*high, ends[0]]), *_cut([*low, ends[1]], high)]


def _find_about_0(speeds: Speeds, half: Any, asked: RestRequest) -> list[tuple[End, End]]:
    k, least, largest = speeds
    low = [abs(k - least) / (k + least)]
    high = [(largest - k) / (largest + k), asked.largest_e]
    # (least + k) e² - 2 least cos(half) e + least - k <= 0
    u, scale = as_ball(least), as_ball(least + k)
    discriminant = as_ball(k) ** 2 - (u * half.sin()) ** 2
    if not _cut(low, high) or discriminant < 0:
        return []
    root = _root_of(discriminant)
    ends = [(u * half.cos() + sign * root) / scale for sign in (-1, 1)]
    return _cut([*low, ends[0]], [*high, ends[1]])


def _root_of(discriminant: Any) -> Any:
    """Return the root of a non-negative number; raise `Open` if its sign is not certain."""
    if not discriminant >= 0:
        raise Open("whether a discriminant is negative")
    return discriminant.sqrt()


def _find_between(speeds: Speeds, half: Any, asked: RestRequest) -> list[tuple[End, End]]:
    k, least, largest = speeds
    start = max(Fraction(0), (k - least) / (k + least), (largest - k) / (largest + k))
    if start >= asked.largest_e:
        return []

    def spare(e: Fraction) -> Any:
        return speeds.angle(e, least) - speeds.angle(e, largest) - 2 * half

    if start == 0 or spare(start) < 0:
        return []
    if not spare(start) > 0:
        raise Open("whether the width fits where both intervals part")
    if spare(asked.largest_e) >= 0:
        return [(start, asked.largest_e)]
    low, high = start, asked.largest_e
    while high - low > MARGIN / 10**3:
        middle = Fraction(float(low + high) / 2)
        if sure(is_above(spare(middle), 0), "whether the width fits between both intervals"):
            low = middle
        else:
            high = middle
    return [(start, low)]


# Where the carrier passes a dwell: about x = pi, about x = 0, or where the output turns.
Place = Literal["slowest", "fastest", "turns"]
# Ends of intervals that are not fractions are enclosed to within this.
MARGIN = Fraction(1, 10**9)


class Span(NamedTuple):
    """Eccentricities from `low` to `high` at which a drive dwells, where, and the best of them.

    `exact` is the one at which the ratio has a double zero, if it is among them; at `best` the
    dwell is longest, over the carrier angle `width`.
    """

    place: Place
    low: Fraction
    high: Fraction
    exact: Fraction | None
    best: Fraction
    width: float
