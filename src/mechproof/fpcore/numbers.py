"""Numbers of FPCore: decimals, fractions and hexadecimals, all exact."""

from __future__ import annotations

import re
from fractions import Fraction

_DECIMAL = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d{1,4})?", re.IGNORECASE)
_FRACTION = re.compile(r"[+-]?\d+/0*[1-9]\d*")
_HEXADECIMAL = re.compile(r"([+-]?)0x([0-9a-f]+)(?:\.([0-9a-f]+))?(?:p([+-]?\d{1,4}))?", re.I)


def read_number(text: str) -> Fraction | None:
    """Return the value of a number, None for what is none."""
    if _DECIMAL.fullmatch(text) or _FRACTION.fullmatch(text):
        return Fraction(text)
    if found := _HEXADECIMAL.fullmatch(text):
        sign, whole, part, power = found.groups()
        digits = int(whole + (part or ""), 16) * Fraction(2) ** (
            int(power or 0) - 4 * len(part or "")
        )
        return -digits if sign == "-" else digits
    return None
