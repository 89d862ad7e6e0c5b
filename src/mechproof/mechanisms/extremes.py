"""The extremes of a periodic quantity."""

from __future__ import annotations

from typing import NamedTuple

# The fields that are angles, and their unit.
PLACES = {"at_maximum": "rad", "at_minimum": "rad", "period": "rad"}


class Extremes(NamedTuple):
    """Largest and smallest value of a periodic quantity and the angles where they occur (rad).

    Each recurs with `period`: at_maximum + m*period, at_minimum + m*period. `maximum` and
    `minimum` have the unit of the quantity.
    """

    maximum: float
    at_maximum: float
    minimum: float
    at_minimum: float
    period: float
