"""Printing of a value with its uncertainty, rounded together (GUM 7.2.2 and 7.2.6).

The uncertainty keeps two significant digits and the value is rounded to the same decimal
place, half to even, from the shortest decimal that reads back as the same double. An
uncertainty whose leading digits are 95 or more goes up into the next decade (0.096 becomes
0.10, as in the rule of the Particle Data Group): at most 5.3 %, where two digits alone cost 4.8 %.
"""

from __future__ import annotations

import math
from decimal import ROUND_HALF_EVEN, Context, Decimal
from typing import NamedTuple

# 1e308 rounded at the place of the smallest double still fits.
_WIDE = Context(prec=700, rounding=ROUND_HALF_EVEN)

# Plain decimals where Python's own repr of a double is plain.
_PLAIN_EXPONENTS = range(-4, 16)


class Rounded(NamedTuple):
    """The texts of value and uncertainty, the latter in last digits too, and the power of ten."""

    value: str
    uncertainty: str
    digits: str
    power: str


def format_shorthand(value: float, uncertainty: float, unit: str = "") -> str:
    """Return `0.68(28)°`: in brackets the standard uncertainty in units of the last digit."""
    rounded = round_together(value, uncertainty)
    return f"{rounded.value}({rounded.digits}){rounded.power}{_suffix(unit)}"


def format_expanded(value: float, uncertainty: float, unit: str = "") -> str:
    """Return `0.68° ± 0.56°`."""
    rounded = round_together(value, uncertainty)
    suffix = rounded.power + _suffix(unit)
    return f"{rounded.value}{suffix} ± {rounded.uncertainty}{suffix}"


def round_together(value: float, uncertainty: float) -> Rounded:
    """Round both at the place of the uncertainty's second digit.

    An uncertainty that is zero, and a value or uncertainty that is not finite, give no place
    to round at: both are then printed as they are.
    """
    if uncertainty == 0 or not (math.isfinite(value) and math.isfinite(uncertainty)):
        spread = f"{float(uncertainty):g}"
        return Rounded(repr(float(value)), spread, spread, "")
    exact_value, exact_spread = (Decimal(repr(float(x))) for x in (value, uncertainty))
    place = _last_place(exact_spread)
    centre, spread_at_place = _quantize(exact_value, place), _quantize(exact_spread, place)
    leading = max(centre.adjusted(), spread_at_place.adjusted())
    exponent = 0 if leading in _PLAIN_EXPONENTS else leading
    spread = _write(spread_at_place, exponent)
    return Rounded(
        value=_write(centre, exponent),
        uncertainty=spread,
        digits=spread.replace(".", "").lstrip("0"),
        power=f"e{exponent}" if exponent else "",
    )


def _last_place(uncertainty: Decimal) -> int:
    first = uncertainty.adjusted()
    carries = uncertainty >= Decimal("9.5").scaleb(first)
    return first if carries else first - 1


def _quantize(number: Decimal, place: int) -> Decimal:
    rounded = number.quantize(Decimal((0, (1,), place)), context=_WIDE)
    return rounded if rounded else abs(rounded)


def _write(number: Decimal, exponent: int) -> str:
    return f"{number.scaleb(-exponent, context=_WIDE):f}"


def _suffix(unit: str) -> str:
    # The degree sign is written against the number; every other unit is set off by a space.
    return unit if unit in ("", "°") else f" {unit}"
