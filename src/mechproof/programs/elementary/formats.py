"""Float formats: their bits, the range of angle reduction, and the degrees that suffice."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath as mp

from mechproof.arithmetic.balls import Ball

DIGITS = 60


@dataclass(frozen=True)
class Format:
    """A binary format with `bits` of precision and the degrees of its approximations.

    `largest` is the largest angle up to which the reduced angle is exact to an ulp of itself.
    Numbers from 2**`exponent` on are infinite. Sums of squares keep their digits where the larger
    number is between 2**-`squares` and 2**`squares`; any other is first scaled by 2**`scale` or
    2**-`scale`.
    """

    name: str
    bits: int
    largest: float
    tangent: tuple[int, int]
    sine: int
    cosine: int
    arctangent: int
    small_arctangent: int
    exponential: int
    tail: int
    squares: int
    scale: int
    exponent: int

    @property
    def eps(self) -> float:
        """Return the spacing of the format's numbers just above 1."""
        return float(2.0 ** (1 - self.bits))

    def round(self, value: mp.mpf) -> float:
        """Return the number of the format nearest to `value`."""
        with mp.workprec(self.bits):
            return float(+value)

    def split(self, value: mp.mpf, count: int) -> tuple[float, ...]:
        """Return `count` numbers of the format whose sum approximates `value`, largest first."""
        words: list[float] = []
        with mp.workdps(DIGITS):
            for _ in range(count):
                words.append(self.round(value - mp.fsum(words)))
        return tuple(words)


DOUBLE = Format("double", 53, 2.0**26, (3, 3), 5, 5, 21, 13, 4, 22, 500, 600, 1024)
SINGLE = Format("single", 24, 2.0**11, (1, 2), 2, 2, 8, 5, 2, 12, 50, 90, 128)


def take_middle(ball: Ball) -> mp.mpf:
    """Return the middle of a ball, exactly."""
    number, power = ball.mid().man_exp()
    return mp.make_mpf(mp.libmp.from_man_exp(int(number), int(power)))
