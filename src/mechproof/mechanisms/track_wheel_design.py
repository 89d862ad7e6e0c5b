"""How far a track wheel may be tilted and offset: what is asked, and the turns of a worst pose.

The kernels `tilt_of_planar_error` and `tilt_of_spatial_error` have the inverses; that no direction
is worse, and no other tilt, is proved by the rows "design, ..." of the track wheel's ledger.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from mechproof.arguments.scalars import check_real, choose_one, require
from mechproof.mechanisms.units import Units

QUARTER = math.pi / 2


def check_tilt(tilt: object) -> float:
    """Return a tilt from 0 up to a right angle."""
    number = check_real("tilt", tilt)
    require(0 <= number <= QUARTER, "tilt", tilt, "must lie between 0 and pi/2 rad")
    return number


def check_offset(offset: object) -> float:
    """Return an offset that is not negative."""
    number = check_real("offset", offset)
    require(number >= 0, "offset", offset, "must not be negative")
    return number


def choose_wish(wanted: Mapping[str, object], units: Units) -> tuple[str, float]:
    """Return name and size of the one error that is given."""
    name, error = choose_one(wanted)
    return name, check_real(name, units.take(name, error, "mm"))


def find_angles(tilt: float, phi: float) -> tuple[float, float, float]:
    """Return the turns alpha, beta, gamma that together tilt the part so that `phi` rises most."""
    x, y = math.sin(phi), -math.cos(phi)
    sine, versine = math.sin(tilt), 2 * math.sin(tilt / 2) ** 2
    return (
        math.atan2(x * sine, math.cos(tilt)),
        math.asin(y * sine),
        math.atan2(-versine * x * y, math.cos(tilt) + versine * x * x),
    )
