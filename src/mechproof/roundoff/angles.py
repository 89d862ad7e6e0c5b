"""Functions of small and of large angles: their germs, whole turns taken off.

A function that vanishes with its argument is its argument times a quotient that is monotone in
its size, so that intervals of it stay narrow down to zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mechproof.arithmetic.intervals import (
    ONE,
    PI,
    Ends,
    Interval,
    apply,
    arctangent,
    around,
    cosine,
    cotangent,
    exactly,
    sine,
    tangent,
)
from mechproof.roundoff.germs import Germ, Powers

# A tangent is taken through its reciprocal, which vanishes at the pole, from here on.
STEEP = 0.9
# Taylor: the quotients are 1 + c*z**2 + ..., |c| <= 1/3, within 1e-16 of 1 below.
TINY = 1e-8


@dataclass(frozen=True)
class Turn:
    """An angle that stands in a frame as a variable to a power, and what it is less whole turns.

    Half a turn is taken off too if `is_half`.
    """

    powers: Powers
    residue: Germ
    whole: Interval
    is_half: bool = False

    def holds(self, germ: Germ) -> bool:
        """Say whether a germ is a multiple of the angle."""
        return germ.powers == self.powers

    def count(self, germ: Germ, period: int) -> float:
        """Return which multiple of the angle it is, to 1/period."""
        return round(float(np.mean(germ.span.low)) * period) / period

    def reduce(self, germ: Germ, period: int) -> Germ:
        """Return a multiple of the angle less multiples of pi/period."""
        nearest = self.count(germ, period)
        over = (germ.span - exactly(nearest)) * self.whole
        return self.residue.scaled(exactly(nearest)) + self.share(germ.frame.constant(over))

    def share(self, germ: Germ) -> Germ:
        """Return a small part of the angle as a share of what vanishes with whole turns off."""
        return germ.over(self.residue.powers)


def reduce(germ: Germ, turn: Turn | None, period: int) -> Germ:
    """Return the argument of a function, period the number of its periods in 2*pi."""
    if turn is None or not turn.holds(germ):
        return germ
    z = turn.reduce(germ, period)
    quarters = PI * exactly(turn.count(germ, period))
    return z + germ.frame.constant(quarters) if turn.is_half else z


def over_argument(name: str, z: Interval) -> Interval:
    """Return function(z)/z for an odd function, that quotient monotone in |z|."""
    size = z.size()
    return _quotient(name, size.low).union(_quotient(name, size.high))


def _quotient(name: str, size: Ends) -> Interval:
    tiny = size <= TINY
    safe = np.where(tiny, 1.0, size)
    found = apply(name, safe) / Interval(safe, safe)
    near = around(1.0, TINY**2)
    return Interval(np.where(tiny, near.low, found.low), np.where(tiny, near.high, found.high))


def take_odd(germ: Germ, name: str, function: Callable[[Interval], Interval], end: float) -> Germ:
    """Return an odd function, function(z)/z monotone up to an end, keeping what vanishes."""
    z = germ.expanded()
    if any(germ.powers) and min(germ.powers) >= 0:
        inside = z.largest() < end
        if germ.frame.choose(inside, ~inside) == 0:
            return germ.scaled(over_argument(name, z))
    return germ.frame.constant(function(z))


def take_tangent(germ: Germ, turn: Turn | None) -> Germ:
    """Return the tangent, near its pole by what is its reciprocal and vanishes there."""
    one = germ.frame.constant(ONE)
    if turn and turn.is_half and turn.holds(germ) and turn.count(germ, 2) % 1:
        rest = _take_tangent(turn.reduce(germ, 2))
        return -(one / (rest if any(rest.powers) else germ.frame.add_variable(rest.span)))
    argument = reduce(germ, turn, 2)
    z = argument.expanded()
    steep = (z.low > STEEP) | (z.high < -STEEP)
    if germ.frame.choose(steep, ~steep) == 0:
        return one / germ.frame.add_variable(cotangent(z))
    return _take_tangent(argument)


def _take_tangent(germ: Germ) -> Germ:
    return take_odd(germ, "tan", tangent, 1.5)


def take_sine(germ: Germ, turn: Turn | None) -> Germ:
    """Return the sine."""
    return take_odd(reduce(germ, turn, 1), "sin", sine, 4.0)


def take_cosine(germ: Germ, turn: Turn | None) -> Germ:
    """Return the cosine."""
    return germ.frame.constant(cosine(reduce(germ, turn, 1).expanded()))


def take_arctangent(germ: Germ) -> Germ:
    """Return the arctangent, of the reciprocal of what vanishes, too."""
    if min(germ.powers, default=0) < 0 and (sign := germ.decide_sign()):
        inverse = germ.frame.constant(ONE) / germ
        quarter = PI * exactly(0.5 * sign)
        return germ.frame.constant(quarter - arctangent(inverse.expanded()))
    return take_odd(germ, "arctan", arctangent, math.inf)
