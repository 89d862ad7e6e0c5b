"""Intervals of eccentricities at which a drive dwells."""

from __future__ import annotations

from fractions import Fraction
from typing import Literal, NamedTuple

# Where the carrier passes a dwell: about x = pi, about x = 0, or where the output turns.
Place = Literal["slowest", "fastest", "turns"]
# Ends of intervals that are no fractions are enclosed to this.
MARGIN = Fraction(1, 10**9)


class Span(NamedTuple):
    """Eccentricities from `low` to `high` at which it dwells, where, and which are the best.

    `exact` is the one at which the ratio has a double zero, if it is among them; at `best` the
    dwell is longest, `width` of the carrier.
    """

    place: Place
    low: Fraction
    high: Fraction
    exact: Fraction | None
    best: Fraction
    width: float
