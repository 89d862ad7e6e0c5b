"""Functions of small and of large angles: their monomials, whole turns taken off.

A function that vanishes with its argument is its argument times a quotient that is monotone in
its size, so that intervals of it stay narrow down to zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from flint import arb

from mechproof.arithmetic.intervals import (
    ONE,
    PI,
    Ends,
    Function,
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
from mechproof.roundoff.interval_monomials import IntervalMonomial, Powers

# A tangent is taken through its reciprocal, which vanishes at the pole, from here on.
STEEP = 0.9
# Taylor: the quotients are 1 + c*z**2 + ..., |c| <= 1/3, within 1e-16 of 1 below.
TINY = 1e-8


@dataclass(frozen=True)
class Turn:
    """An angle that is a variable to a power, and what it is less whole turns.

    Half a turn is taken off too if `is_half`.
    """

    powers: Powers
    residue: IntervalMonomial
    whole: Interval
    is_half: bool = False

    def holds(self, monomial: IntervalMonomial) -> bool:
        """Say whether a monomial is a multiple of the angle."""
        return monomial.powers == self.powers

    def count(self, monomial: IntervalMonomial, period: int) -> float:
        """Return which multiple of the angle it is, to 1/period."""
        return round(float(np.mean(monomial.span.low)) * period) / period

    def reduce(self, monomial: IntervalMonomial, period: int) -> IntervalMonomial:
        """Return a multiple of the angle less multiples of pi/period."""
        nearest = self.count(monomial, period)
        over = (monomial.span - exactly(nearest)) * self.whole
        return self.residue.scaled(exactly(nearest)) + self.share(monomial.variables.constant(over))

    def share(self, monomial: IntervalMonomial) -> IntervalMonomial:
        """Return a small part of the angle as a share of what vanishes with whole turns off."""
        return monomial.over(self.residue.powers)


def reduce(monomial: IntervalMonomial, turn: Turn | None, period: int) -> IntervalMonomial:
    """Return the argument of a function, period the number of its periods in 2*pi."""
    if turn is None or not turn.holds(monomial):
        return monomial
    z = turn.reduce(monomial, period)
    quarters = PI * exactly(turn.count(monomial, period))
    return z + monomial.variables.constant(quarters) if turn.is_half else z


def over_argument(exact: Function, z: Interval) -> Interval:
    """Return function(z)/z for an odd function, that quotient monotone in |z|."""
    size = z.size()
    return _quotient(exact, size.low).union(_quotient(exact, size.high))


def _quotient(exact: Function, size: Ends) -> Interval:
    tiny = size <= TINY
    safe = np.where(tiny, 1.0, size)
    found = apply(exact, safe) / Interval(safe, safe)
    # Zero over zero is no number; below TINY the quotient is 1 but for less than a rounding.
    near = around(1.0, TINY**2)
    return Interval(np.where(tiny, near.low, found.low), np.where(tiny, near.high, found.high))


def take_odd(
    monomial: IntervalMonomial, exact: Function, enclose: Callable[[Interval], Interval], end: float
) -> IntervalMonomial:
    """Return an odd function, function(z)/z monotone up to an end, keeping what vanishes."""
    z = monomial.expanded()
    if any(monomial.powers) and min(monomial.powers) >= 0:
        inside = z.largest() < end
        if monomial.variables.choose(inside, ~inside) == 0:
            return monomial.scaled(over_argument(exact, z))
    return monomial.variables.name(exact, monomial, enclose(z))


def take_tangent(monomial: IntervalMonomial, turn: Turn | None) -> IntervalMonomial:
    """Return the tangent, near its pole by what is its reciprocal and vanishes there."""
    one = monomial.variables.constant(ONE)
    if turn and turn.is_half and turn.holds(monomial) and turn.count(monomial, 2) % 1:
        rest = _take_tangent(turn.reduce(monomial, 2))
        return -(one / (rest if any(rest.powers) else monomial.variables.add_variable(rest.span)))
    argument = reduce(monomial, turn, 2)
    z = argument.expanded()
    steep = (z.low > STEEP) | (z.high < -STEEP)
    if monomial.variables.choose(steep, ~steep) == 0:
        return one / monomial.variables.add_variable(cotangent(z))
    return _take_tangent(argument)


def _take_tangent(monomial: IntervalMonomial) -> IntervalMonomial:
    return take_odd(monomial, arb.tan, tangent, 1.5)


def take_sine(monomial: IntervalMonomial, turn: Turn | None) -> IntervalMonomial:
    """Return the sine."""
    # sin(z)/z falls up to 4.49, where tan z = z.
    return take_odd(reduce(monomial, turn, 1), arb.sin, sine, 4.0)


def take_cosine(monomial: IntervalMonomial, turn: Turn | None) -> IntervalMonomial:
    """Return the cosine."""
    argument = reduce(monomial, turn, 1)
    return monomial.variables.name(arb.cos, argument, cosine(argument.expanded()))


def take_arctangent(monomial: IntervalMonomial) -> IntervalMonomial:
    """Return the arctangent, of the reciprocal of what vanishes, too."""
    if min(monomial.powers, default=0) < 0 and (sign := monomial.decide_sign()):
        inverse = monomial.variables.constant(ONE) / monomial
        quarter = PI * exactly(0.5 * sign)
        return monomial.variables.constant(quarter - arctangent(inverse.expanded()))
    return take_odd(monomial, arb.atan, arctangent, math.inf)


def take_angle(y: IntervalMonomial, x: IntervalMonomial) -> IntervalMonomial:
    """Return the angle of a point, not finite where it may lie on the ray of half a turn."""
    above, ahead = y.expanded(), x.expanded()
    masks = (ahead.low > 0, above.low > 0, above.high < 0)
    right, up, down = masks[0], masks[1] & ~masks[0], masks[2] & ~masks[0]
    choice = x.variables.choose(right, up, down, ~(right | up | down))
    if choice == 0:
        return take_arctangent(y / x)
    if choice == 3:
        return x.variables.constant(exactly(math.nan))
    quarter = PI * exactly((0.5, -0.5)[choice - 1])
    return x.variables.constant(quarter - arctangent((x / y).expanded()))
