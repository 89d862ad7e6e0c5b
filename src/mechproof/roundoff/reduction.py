"""Reduction: the rounding error of an angle less the nearest number of quarter turns.

The angle and the number times the first word are multiples of one unit, and their difference is
small: the first fma is exact. The second rounds once. The last word amounts to no more than the
rounding of the third fma unless the angle is within `NEAR` of a multiple, and what the three words
omit is negligible. The words are those of Cody and Waite (1980), with an fma in place of trailing
zeros (Boldo, Daumas and Li 2009).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import floor

from flint import arb

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.intervals import EPS, UNIT
from mechproof.programs.elementary.fits import MARGIN
from mechproof.programs.elementary.formats import DOUBLE

# Precision in bits: three words of pi/2 have some 159, and what they omit takes twice as many.
BITS = 300
# Angles at least this far from a multiple of a quarter turn hardly need the last word.
NEAR = 2.0**-24
# Factor that covers the roundings of the computations here, and other small shares.
MORE = 1 + 2.0**-20


@dataclass(frozen=True)
class ReductionError:
    """The error of a reduced angle in eps of itself, besides the half ulp of one rounding.

    `near` is for angles within `NEAR` of a multiple of a quarter turn, `far` for all others.
    """

    far: float
    near: float


@cache
def bound_reduction(per: float, words: tuple[float, ...]) -> ReductionError:
    """Bound the error of reduced angles up to the largest; ValueError if that cannot be shown."""
    if len(words) != 3:
        raise ValueError(f"{words}: not three words of a quarter turn")
    with working_precision(BITS):
        quarter = arb.pi() / 2
        left = _above(abs(quarter + sum(map(arb, words), arb(0))))
        # The words are negative, so that an fma subtracts them.
        after_first = _above(abs(quarter + arb(words[0])))
        miss = _above(abs(arb(per) - 1 / quarter))
    largest = DOUBLE.largest
    # The number of quarter turns is the integer next to a rounded product of two doubles.
    beyond_half = largest * (miss + per * EPS) * MORE
    most = largest * per * MORE + 1
    rest = (0.5 + beyond_half) / per * MORE
    least_taken = 0.5 / per * (1 - EPS)
    later, least = abs(words[2]), find_nearest(largest)
    first_is_exact = (
        least_taken > 0.5
        and Fraction(words[0]) % Fraction(UNIT) == 0
        and rest + most * after_first < 1
    )
    if not first_is_exact:
        raise ValueError(f"{words[0]}: the first product and difference may be rounded")
    if beyond_half > MARGIN / 4 or most * (later + left) > least * (MORE - 1):
        raise ValueError(f"{words}: not enough of a quarter turn, or not the nearest number")
    return ReductionError(
        far=most * (later + left) / NEAR / EPS * MORE,
        near=(1 + most * left / least / EPS) * MORE - 0.5,
    )


def _above(ball: arb) -> float:
    return float(ball.upper()) * MORE


@cache
def find_nearest(largest: float) -> float:
    """Bound from below the distance of doubles up to `largest` from multiples of a quarter turn.

    In a binade doubles are multiples of a unit, and the multiples of pi/2 that come nearest to
    them are those by the denominators of a continued fraction's convergents.
    """
    with working_precision(BITS):
        mantissa, exponent = (arb.pi() / 2).mid().man_exp()
    quarter = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    nearest, end = Fraction(1), Fraction(1)
    while end <= largest:
        unit = end * Fraction(UNIT)
        # Convergents are the best approximations: no other number of quarters comes nearer.
        for number in _list_denominators(quarter / unit, end / quarter + 1):
            over = number * quarter / unit
            nearest = min(nearest, abs(over - round(over)) * unit)
        end *= 2
    # Halved, which covers the error of pi at this precision.
    return float(nearest / 2)


def _list_denominators(number: Fraction, most: Fraction) -> Iterator[int]:
    """Yield the denominators, up to `most`, of the convergents of a number."""
    before, last = 0, 1
    while last <= most:
        yield last
        number = number - floor(number)
        if not number:
            return
        number = 1 / number
        before, last = last, floor(number) * last + before
