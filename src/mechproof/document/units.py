"""Units as they are written in brackets -> physical dimensions."""

from __future__ import annotations

import re
from collections.abc import Mapping

from mechproof.record import ANGLE, LENGTH, NUMBER, Dimension

_TIME, _MASS = Dimension(time=1), Dimension(mass=1)
_FORCE = _MASS * LENGTH / _TIME**2
_BASE: Mapping[str, Dimension] = {
    **dict.fromkeys(("", "1", "-", "%"), NUMBER),
    **dict.fromkeys(("rad", "deg", "°", "mrad", "'", '"'), ANGLE),
    **dict.fromkeys(("m", "mm", "cm", "dm", "km", "um", "µm", "nm", "in", "ft"), LENGTH),
    **dict.fromkeys(("s", "ms", "us", "µs", "min", "h"), _TIME),
    **dict.fromkeys(("kg", "g", "t", "mg"), _MASS),
    **dict.fromkeys(("K", "°C"), Dimension(temperature=1)),
    **dict.fromkeys(("Hz", "kHz"), NUMBER / _TIME),
    **dict.fromkeys(("rpm", "r/min"), ANGLE / _TIME),
    **dict.fromkeys(("N", "kN", "mN", "MN"), _FORCE),
    **dict.fromkeys(("Nm", "kNm", "Nmm", "J", "kJ"), _FORCE * LENGTH),
    **dict.fromkeys(("Pa", "kPa", "MPa", "GPa", "bar"), _FORCE / LENGTH**2),
    **dict.fromkeys(("W", "kW"), _FORCE * LENGTH / _TIME),
}
_FACTOR = re.compile(r"(?P<unit>[^\s·*/^()\d-][^\s·*/^()\d-]*|1)(?:\^?\{?(?P<power>-?\d+)\}?)?\s*")
_SIGN = re.compile(r"\s*([·*/]?)\s*")


class UnitError(ValueError):
    """A unit that is not known."""


def read_unit(text: str) -> Dimension:
    """Return the dimension of a unit such as mm, m/s^2, N m or 1/s.

    Raises `UnitError` naming what is not known of it.
    """
    if text.strip() in _BASE:
        return _BASE[text.strip()]
    found, place, sign = NUMBER, 0, ""
    while place < len(text):
        factor = _FACTOR.match(text, place)
        if factor is None or factor["unit"] not in _BASE:
            wrong = factor["unit"] if factor else text[place:]
            raise UnitError(f"the unit {wrong!r} of [{text}] is not known")
        power = int(factor["power"] or 1)
        found *= _BASE[factor["unit"]] ** (-power if sign == "/" else power)
        between = _SIGN.match(text, factor.end())
        sign, place = (between[1], between.end()) if between else ("", len(text))
    return found
