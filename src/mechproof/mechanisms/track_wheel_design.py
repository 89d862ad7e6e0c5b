"""How far a track wheel may be tilted and offset: inverses of its largest errors.

A tilt tau about a horizontal axis moves a point at the height H and at the distance s from the
vertical plane of the axis, on the side that rises, by s*(1 - cos(tau)) + H*sin(tau) in the plane,
towards the axis, and by 2*sin(tau/2)*hypot(s, H) in space. Both grow with s, and with an offset e
that way by e in the plane. So no point of the track moves further than a crest, where s is the
largest radius rho; there the normal of the track is radial, and the error along it is that in the
plane. With t = tan(tau/2) each error w gives an equation q*t**2 + 2*b*t = g:

    in the plane: g = w - e,        b = H,      q = 2*rho - g
    in space:     g = w**2 - e**2,  b = 2*e*H,  q = 4*(rho**2 + H**2 + e*rho) - g

Up to tau = pi/2 both errors rise with the tilt and the offset, so that the root is the only one.
The rows "design, ..." of the track wheel's ledger prove all of it, from equation (15) of Kapitonov,
Yakubovsky 2022.
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


def solve_tilt(name: str, error: float, offset: float, rho: float, height: float) -> float:
    """Return the tilt with which the largest error is the one given, which is within reach."""
    # In units of the distance from the origin no square leaves the range of doubles.
    unit = math.hypot(rho, height)
    w, e, s, h = (size / unit for size in (error, offset, rho, height))
    if name == "planar_error":
        g, b = w - e, h
        q = 2 * s - g
    else:
        g, b = (w - e) * (w + e), 2 * e * h
        q = 4 * (1 + e * s) - g
    root = math.sqrt(max(b * b + q * g, 0.0))
    return 2 * math.atan2(g, b + root)


def find_angles(tilt: float, phi: float) -> tuple[float, float, float]:
    """Return the turns alpha, beta, gamma that together tilt the part so that `phi` rises most."""
    x, y = math.sin(phi), -math.cos(phi)
    sine, versine = math.sin(tilt), 2 * math.sin(tilt / 2) ** 2
    return (
        math.atan2(x * sine, math.cos(tilt)),
        math.asin(y * sine),
        math.atan2(-versine * x * y, math.cos(tilt) + versine * x * x),
    )
