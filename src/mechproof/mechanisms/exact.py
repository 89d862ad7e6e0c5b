"""Parameters that stay exact where they are given so."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np

from mechproof.arguments.scalars import check_count, check_items, check_real, refuse, require

Number = float | Fraction
# Decimal strings are exact, too; every parameter is kept as a Fraction or a float.
Given = float | Fraction | Decimal | str


def check_teeth(teeth: tuple[int, int]) -> tuple[int, int]:
    """Return the least and the largest number of teeth."""
    first, last = (check_count("teeth", z) for z in check_items("teeth", teeth, 2, "must be two"))
    require(first <= last, "teeth", teeth, "must be the least and the largest number")
    return first, last


def check_number(name: str, value: Any) -> Number:
    """Return an exact fraction, or a float for what is one."""
    if isinstance(value, np.integer):
        value = int(value)
    if isinstance(value, str | Decimal | int | Fraction) and not isinstance(value, bool):
        try:
            return Fraction(value)
        except (ValueError, OverflowError):
            refuse(name, value, "must be a finite number")
    return check_real(name, value)
