"""Functions of small and of large angles: their monomials, after reduction by whole turns.

A function that vanishes with its argument is its argument times a quotient that is monotone in
the argument's size, so that its intervals stay narrow down to zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from flint import arb

from mechproof.arithmetic.interval_functions import (
    Function,
    apply,
    arctangent,
    cosine,
    cotangent,
    sine,
    tangent,
)
from mechproof.arithmetic.intervals import ONE, PI, Ends, Interval, Mask, around, exactly
from mechproof.roundoff.interval_monomials import IntervalMonomial, Powers

# Size of an angle, in radians, above which its tangent is computed by the cotangent, which vanishes
# at the pole.
STEEP = 0.9
# Below this size, by Taylor, the quotients 1 + c*z**2 + ..., |c| <= 1/3, are within 1e-16 of 1.
TINY = 1e-8
SLOPES: Mapping[Function, Callable[[Interval], Interval]] = MappingProxyType(
    {arb.sin: cosine, arb.atan: lambda z: (ONE + z.power(2)).inverted()}
)


@dataclass(frozen=True)
class Turn:
    """An angle that is a power of a variable, and its residue after whole turns are taken off.

    If `is_half`, half a turn is taken off as well.
    """

    powers: Powers
    residue: IntervalMonomial
    whole: Interval
    is_half: bool = False

    def holds(self, monomial: IntervalMonomial) -> bool:
        """Return whether a monomial is a multiple of the angle."""
        return monomial.powers == self.powers

    def count(self, monomial: IntervalMonomial, period: int) -> float:
        """Return the factor by which a monomial is a multiple of the angle, rounded to 1/period."""
        return round(float(np.mean(monomial.span.low)) * period) / period

    def reduce(self, monomial: IntervalMonomial, period: int) -> IntervalMonomial:
        """Return a multiple of the angle, reduced by multiples of pi/period."""
        nearest = self.count(monomial, period)
        over = (monomial.span - exactly(nearest)) * self.whole
        return self.residue.scaled(exactly(nearest)) + self.share(monomial.variables.constant(over))

    def share(self, monomial: IntervalMonomial) -> IntervalMonomial:
        """Return a small part of the angle with the residue's powers as common factors."""
        return monomial.over(self.residue.powers)


def reduce(monomial: IntervalMonomial, turn: Turn | None, period: int) -> IntervalMonomial:
    """Return a function's argument, reduced; `period` is the number of periods in 2*pi."""
    if turn is None or not turn.holds(monomial):
        return monomial
    z = turn.reduce(monomial, period)
    quarters = PI * exactly(turn.count(monomial, period))
    return z + monomial.variables.constant(quarters) if turn.is_half else z


def over_argument(exact: Function, z: Interval) -> Interval:
    """Return function(z)/z for an odd function whose quotient is monotone in |z|."""
    size = z.size()
    first, last = _quotient(exact, size.low), _quotient(exact, size.high)
    found = first.union(last)
    if size.form is None:
        return found
    # By the quotient rule; not finite where the argument may be zero.
    low, high = Interval(size.low, size.low), Interval(size.high, size.high)
    if exact is arb.tan:
        # The series of tan(z)/z has no negative coefficient, so it is convex, and its slope is
        # nowhere negative and largest at the far end.
        least, most = ((ONE + (z * q).power(2) - q) / z for z, q in ((low, first), (high, last)))
        slope = Interval(np.fmax(least.low, 0.0), most.high)
        return found.follow(size, (first, last), slope, 1)
    plain = Interval(size.low, size.high)
    slope = (SLOPES[exact](plain) - found) / plain
    return found.follow(size, (first, last), slope, 0)


def _quotient(exact: Function, size: Ends) -> Interval:
    tiny = size <= TINY
    safe = np.where(tiny, 1.0, size)
    found = apply(exact, safe) / Interval(safe, safe)
    # 0/0 is NaN; below TINY the quotient is within a rounding of 1.
    near = around(1.0, TINY**2)
    return Interval(np.where(tiny, near.low, found.low), np.where(tiny, near.high, found.high))


def take_odd(
    monomial: IntervalMonomial, exact: Function, enclose: Callable[[Interval], Interval], end: float
) -> IntervalMonomial:
    """Return an odd function, function(z)/z being monotone up to `end`, with vanishing factors."""
    z = monomial.expanded()
    if any(monomial.powers) and min(monomial.powers) >= 0:
        inside = z.largest() < end
        if monomial.variables.choose(inside, ~inside) == 0:
            return monomial.scaled(over_argument(exact, z))
    return monomial.variables.name(exact, monomial, enclose(z))


def take_tangent(monomial: IntervalMonomial, turn: Turn | None) -> IntervalMonomial:
    """Return the tangent, computed near a pole by its reciprocal, which vanishes there."""
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
    # sin(z)/z decreases up to 4.49, where tan z = z.
    return take_odd(reduce(monomial, turn, 1), arb.sin, sine, 4.0)


def take_cosine(monomial: IntervalMonomial, turn: Turn | None) -> IntervalMonomial:
    """Return the cosine."""
    argument = reduce(monomial, turn, 1)
    return monomial.variables.name(arb.cos, argument, cosine(argument.expanded()))


def take_arctangent(monomial: IntervalMonomial) -> IntervalMonomial:
    """Return the arctangent, also of reciprocals of values that may vanish."""
    if min(monomial.powers, default=0) < 0 and (sign := monomial.decide_sign()):
        inverse = monomial.variables.constant(ONE) / monomial
        quarter = PI * exactly(0.5 * sign)
        return monomial.variables.constant(quarter - arctangent(inverse.expanded()))
    return take_odd(monomial, arb.atan, arctangent, math.inf)


def are_right(x: IntervalMonomial) -> Mask:
    """Return where a point is right of the origin; at the edge of a box x may vanish."""
    is_positive = x.variables.is_positive(x.powers)
    return (x.span if is_positive else x.expanded()).low > 0


def take_angle(y: IntervalMonomial, x: IntervalMonomial) -> IntervalMonomial:
    """Return the angle of a point; not finite where it may be half a turn.

    Nor where both sides may vanish, unless a factor of both does.
    """
    above, right = y.expanded(), are_right(x)
    up, down = (above.low > 0) & ~right, (above.high < 0) & ~right
    choice = x.variables.choose(right, up, down, ~(right | up | down))
    if choice == 0:
        return take_arctangent(y / x)
    if choice == 3:
        return x.variables.constant(exactly(math.nan))
    quarter = PI * exactly((0.5, -0.5)[choice - 1])
    return x.variables.constant(quarter - arctangent((x / y).expanded()))
