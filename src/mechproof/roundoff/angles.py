"""Functions of small and of large angles: their germs, whole turns taken off.

A function that vanishes with its argument is its argument times a quotient that is monotone in
its size, so that intervals of it stay narrow down to zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mechproof.roundoff.germs import Germ, Powers
from mechproof.roundoff.intervals import (
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

# A tangent is taken through its reciprocal, which vanishes at the pole, from here on.
STEEP = 0.9
# Taylor: the quotients are 1 + c*z**2 + ..., |c| <= 1/3, within 1e-16 of 1 below.
TINY = 1e-8


@dataclass(frozen=True)
class Turn:
    """An angle that stands in a frame as a variable to a power, and what it is less whole turns."""

    powers: Powers
    residue: Interval
    whole: Interval

    def holds(self, germ: Germ) -> bool:
        """Say whether a germ is a multiple of the angle."""
        return germ.powers == self.powers

    def reduce(self, germ: Germ, period: int) -> Interval:
        """Return a multiple of the angle less multiples of pi/period."""
        nearest = round(float(np.mean(germ.span.low)) * period) / period
        over = (germ.span - exactly(nearest)) * self.whole
        return self.residue * exactly(nearest) + over


def reduce(germ: Germ, turn: Turn | None, period: int) -> Interval:
    """Return the argument of a function, period the number of its periods in 2*pi."""
    return turn.reduce(germ, period) if turn and turn.holds(germ) else germ.expanded()


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


def take_odd(
    germ: Germ, z: Interval, name: str, function: Callable[[Interval], Interval], end: float
) -> Germ:
    """Return an odd function, function(z)/z monotone up to an end, keeping what vanishes."""
    if any(germ.powers) and min(germ.powers) >= 0:
        inside = z.largest() < end
        if germ.frame.choose(inside, ~inside) == 0:
            return germ.scaled(over_argument(name, z))
    return germ.frame.constant(function(z))


def take_tangent(germ: Germ, turn: Turn | None) -> Germ:
    """Return the tangent, near its pole by a variable that is its reciprocal."""
    z = reduce(germ, turn, 2)
    steep = (z.low > STEEP) | (z.high < -STEEP)
    if germ.frame.choose(steep, ~steep) == 0:
        return germ.frame.constant(ONE) / germ.frame.add_variable(cotangent(z))
    return _odd_or_reduced(germ, z, turn, "tan", tangent, 1.5)


def take_sine(germ: Germ, turn: Turn | None) -> Germ:
    """Return the sine."""
    return _odd_or_reduced(germ, reduce(germ, turn, 1), turn, "sin", sine, 4.0)


def take_cosine(germ: Germ, turn: Turn | None) -> Germ:
    """Return the cosine."""
    return germ.frame.constant(cosine(reduce(germ, turn, 1)))


def take_arctangent(germ: Germ) -> Germ:
    """Return the arctangent, of the reciprocal of what vanishes, too."""
    if min(germ.powers, default=0) < 0 and (sign := germ.decide_sign()):
        inverse = germ.frame.constant(ONE) / germ
        quarter = PI * exactly(0.5 * sign)
        return germ.frame.constant(quarter - arctangent(inverse.expanded()))
    return take_odd(germ, germ.expanded(), "arctan", arctangent, math.inf)


def _odd_or_reduced(
    germ: Germ,
    z: Interval,
    turn: Turn | None,
    name: str,
    function: Callable[[Interval], Interval],
    end: float,
) -> Germ:
    if turn and turn.holds(germ):
        return germ.frame.constant(function(z))
    return take_odd(germ, z, name, function, end)
