"""Functions of small and of large angles: their germs, whole turns taken off.

A function that vanishes with its argument is its argument times a quotient that is monotone in
its size, so that balls of it stay narrow down to zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from mechproof.roundoff.germs import Ball, Germ, Powers

# A tangent is taken through its reciprocal, which vanishes at the pole, from here on.
STEEP = 0.9
# Taylor: the quotients are 1 + c*z**2 + ..., |c| <= 1/3, within 1e-16 of 1 below.
TINY = 1e-8


@dataclass(frozen=True)
class Turn:
    """An angle that stands in a frame as a variable to a power, and what it is less whole turns."""

    powers: Powers
    residue: Ball
    whole: Ball

    def reduce(self, germ: Germ, period: int) -> Ball | None:
        """Return a multiple of the angle less multiples of pi/period; None for no such multiple."""
        if germ.powers != self.powers:
            return None
        nearest = round(float(germ.ball.mid()) * period) / period
        return self.residue * nearest + (germ.ball - nearest) * self.whole


def reduce(germ: Germ, turn: Turn | None, period: int) -> Ball:
    """Return the argument of a function, period the number of its periods in 2*pi."""
    found = turn.reduce(germ, period) if turn else None
    return germ.expanded() if found is None else found


def over_argument(function: Callable[[Ball], Ball], z: Ball) -> Ball:
    """Return function(z)/z for an odd function, that quotient monotone in |z|."""
    ends = (z.abs_lower(), z.abs_upper())
    near, far = (function(end) / end if end > TINY else arb(1, TINY**2) for end in ends)
    return near.union(far)


def take_odd(germ: Germ, z: Ball, function: Callable[[Ball], Ball], end: float) -> Germ:
    """Return an odd function, function(z)/z monotone up to an end, keeping what vanishes."""
    vanishes = any(germ.powers) and min(germ.powers) >= 0
    if vanishes and abs(z) < end:
        return germ.scaled(over_argument(function, z))
    return germ.frame.constant(function(z))


def take_tangent(germ: Germ, turn: Turn | None) -> Germ:
    """Return the tangent, near its pole by a variable that is its reciprocal."""
    z = reduce(germ, turn, 2)
    if abs(z) > STEEP:
        pole = germ.frame.add_variable(z.cot())
        return germ.frame.variable(pole, -1)
    return _odd_or_reduced(germ, z, turn, arb.tan, 1.5)


def take_sine(germ: Germ, turn: Turn | None) -> Germ:
    """Return the sine."""
    return _odd_or_reduced(germ, reduce(germ, turn, 1), turn, arb.sin, 4.0)


def take_cosine(germ: Germ, turn: Turn | None) -> Germ:
    """Return the cosine."""
    return germ.frame.constant(reduce(germ, turn, 1).cos())


def take_arctangent(germ: Germ) -> Germ:
    """Return the arctangent, of the reciprocal of what vanishes, too."""
    if min(germ.powers, default=0) < 0:
        inverse = germ.frame.constant(arb(1)) / germ
        half = arb.pi() / 2 * germ.ball.sgn()
        return germ.frame.constant(half - inverse.expanded().atan())
    return take_odd(germ, germ.expanded(), arb.atan, math.inf)


def _odd_or_reduced(
    germ: Germ, z: Ball, turn: Turn | None, function: Callable[[Ball], Ball], end: float
) -> Germ:
    if turn and germ.powers == turn.powers:
        return germ.frame.constant(function(z))
    return take_odd(germ, z, function, end)
