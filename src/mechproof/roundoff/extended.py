"""Extended precision: steps in long doubles, thousands of times as fast as in balls.

They are sure of nothing: a search is led by them, and balls judge what it finds. The points are on
the last axis, what is summed over on those before.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp

from mechproof.programs.program import CONSTANTS, Operand
from mechproof.roundoff.running import ON_ARRAYS

FORMAT = np.longdouble
BITS = int(np.finfo(FORMAT).nmant) + 1
# Where long doubles are doubles, they tell nothing of a rounding; x87 has 64 bits.
IS_LONGER = BITS >= 64
# Veltkamp's factor, and digits for constants.
FACTOR, DIGITS = FORMAT(2) ** ((BITS + 1) // 2) + 1, 40


def _split(a: Any) -> tuple[Any, Any]:
    scaled = a * FACTOR
    high = scaled - (scaled - a)
    return high, a - high


def _quadratic_form(x: Any, m: Any) -> Any:
    return np.sum(x[:, np.newaxis] * x * m, axis=(0, 1))


def _product_rest(a: Any, b: Any, p: Any) -> Any:
    (a_high, a_low), (b_high, b_low) = _split(FORMAT(1) * a), _split(FORMAT(1) * b)
    return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low


def _quotient_rest(a: Any, b: Any, q: Any) -> Any:
    p = q * b
    return ((a - p) - _product_rest(q, b, p)) / b


def _first_axes(count: Operand) -> tuple[int, ...]:
    return tuple(range(int(count)))


def _divide(digits: str) -> Any:
    above, _, below = digits.partition("/")
    return FORMAT(above) / FORMAT(below or "1")


# Of the constants; infinity is known to all that run.
DIGITS_OF = {n: str(sp.N(v, DIGITS)) for n, v in CONSTANTS.items() if v != sp.oo}
IN_EXTENDED = ON_ARRAYS.but(
    number=FORMAT,
    # By its digits: a whole number of Python's may become a double on the way.
    constant=lambda operand: _divide(DIGITS_OF.get(operand, str(operand))),
    product_rest=_product_rest,
    quotient_rest=_quotient_rest,
    quadratic_form=_quadratic_form,
    nonnegative_form=_quadratic_form,
    sum=lambda a, count: np.sum(a, axis=_first_axes(count)),
    every=lambda a, count: np.all(a, axis=_first_axes(count)),
)
