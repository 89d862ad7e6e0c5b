"""Rules: the value and the partial derivatives of each kind of operation, in monomials.

These are the elementary partial derivatives of automatic differentiation (Griewank and Walther
2008), over boxes; `bound` accumulates them in reverse.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from mechproof.arithmetic.interval_functions import exponential, logarithm
from mechproof.arithmetic.intervals import (
    EPS,
    ONE,
    UNIT,
    Ends,
    Interval,
    Mask,
    around,
    exactly,
)
from mechproof.roundoff.angles import (
    Turn,
    are_right,
    take_angle,
    take_arctangent,
    take_cosine,
    take_sine,
    take_tangent,
)
from mechproof.roundoff.interval_monomials import IntervalMonomial

EITHER = Interval(np.float64(-1.0), np.float64(1.0))
SOME = Interval(np.float64(0.0), np.float64(1.0))

# Derivatives of an operation's value with respect to each operand; None for zero.
Slopes = tuple[IntervalMonomial | None, ...]
# The value of an operation, and a function that returns its slopes, which is not called where
# nothing is rounded.
Moved = tuple[IntervalMonomial, Callable[[], Slopes]]
# Takes the angle that is reduced by whole turns, then the operands.
Rule = Callable[..., Moved]


def _one(monomial: IntervalMonomial) -> IntervalMonomial:
    return monomial.variables.constant(ONE)


def _number(monomial: IntervalMonomial, number: float) -> IntervalMonomial:
    return monomial.variables.constant(exactly(number))


def _divide(turn: Turn | None, a: IntervalMonomial, b: IntervalMonomial) -> Moved:
    quotient = a / b
    return quotient, lambda: (_one(a) / b, -(quotient / b))


def _sqrt(turn: Turn | None, a: IntervalMonomial) -> Moved:
    # Odd powers of a vanishing variable have no root among the monomials, and neither have squares
    # of a variable of either sign.
    halves = a.variables.intern(tuple([p // 2 for p in a.powers]))
    if any(p % 2 for p in a.powers) or not a.variables.is_positive(halves):
        root = a.variables.constant(a.expanded().sqrt())
    else:
        root = IntervalMonomial(a.variables, a.span.sqrt(), halves)
    return root, lambda: (_number(a, 0.5) / root,)


def _hypot(turn: Turn | None, a: IntervalMonomial, b: IntervalMonomial) -> Moved:
    root, _ = _sqrt(turn, a.power(2) + b.power(2))
    return root, lambda: (a / root, b / root)


def _absolute(turn: Turn | None, a: IntervalMonomial) -> Moved:
    if sign := a.decide_sign():
        return (a if sign > 0 else -a), lambda: (_number(a, sign),)
    return a.size(), lambda: (a.variables.constant(EITHER),)


def _either(
    a: IntervalMonomial, b: IntervalMonomial, lead: Interval, choose: Callable[[Ends, Ends], Ends]
) -> Moved:
    """Return the first operand where `lead` is never negative, the second where never positive.

    Elsewhere `choose` combines both.
    """
    one = _one(a)
    leads, follows = lead.low >= 0, lead.high <= 0
    choice = a.variables.choose(leads, follows & ~leads, ~(leads | follows))
    if choice < 2:
        return (a, b)[choice], lambda: ((one, None), (None, one))[choice]
    some = a.variables.constant(SOME)
    return a.extreme(b, choose), lambda: (some, some)


def enclose_rest(rounded: IntervalMonomial) -> IntervalMonomial:
    """Enclose what rounding to nearest took from a result."""
    return rounded.scaled(around(0.0, UNIT * (1 + EPS)))


def _less(turn: Turn | None, a: IntervalMonomial, b: IntervalMonomial) -> Moved:
    lead = (b - a).expanded()
    return _decide(a, lead.low > 0, lead.high <= 0)


def _less_equal(turn: Turn | None, a: IntervalMonomial, b: IntervalMonomial) -> Moved:
    lead = (b - a).expanded()
    return _decide(a, lead.low >= 0, lead.high < 0)


def _decide(one: IntervalMonomial, holds: Mask, fails: Mask) -> Moved:
    """Return 1 where a comparison surely holds, 0 where it surely fails, [0, 1] elsewhere."""
    truth = Interval(np.where(holds, 1.0, 0.0), np.where(fails, 0.0, 1.0))
    return one.variables.constant(truth), lambda: (None, None)


def _choose(
    turn: Turn | None, test: IntervalMonomial, a: IntervalMonomial, b: IntervalMonomial
) -> Moved:
    """Return the chosen operand; where the choice is unknown, an enclosure of both."""
    is_first, is_second = test.span.low == 1, test.span.high == 0
    chosen = a.variables.choose(is_first, is_second, ~(is_first | is_second))
    if chosen < 2:
        one = _one(a)
        return (a, b)[chosen], lambda: ((None, one, None), (None, None, one))[chosen]
    some = a.variables.constant(SOME)
    return a.hull(b), lambda: (None, some, some)


def _tan(turn: Turn | None, a: IntervalMonomial) -> Moved:
    tangent = take_tangent(a, turn)
    return tangent, lambda: (_one(tangent) + tangent.power(2),)


def _arctan2(turn: Turn | None, y: IntervalMonomial, x: IntervalMonomial) -> Moved:
    def find_slopes() -> Slopes:
        right = are_right(x)
        if x.variables.choose(right, ~right) == 0:
            # By the quotient, which keeps factors that both sides have.
            quotient = y / x
            slope = _one(x) / (x * (_one(x) + quotient.power(2)))
            return slope, -(quotient * slope)
        square = x.power(2) + y.power(2)
        return x / square, -(y / square)

    return take_angle(y, x), find_slopes


def _exp(turn: Turn | None, a: IntervalMonomial) -> Moved:
    value = a.variables.constant(exponential(a.expanded()))
    return value, lambda: (value,)


def _log(turn: Turn | None, a: IntervalMonomial) -> Moved:
    return a.variables.constant(logarithm(a.expanded())), lambda: (_one(a) / a,)


RULES: Mapping[str, Rule] = MappingProxyType(
    {
        "add": lambda turn, a, b: (a + b, lambda: (_one(a), _one(a))),
        "subtract": lambda turn, a, b: (a - b, lambda: (_one(a), -_one(a))),
        "multiply": lambda turn, a, b: (a * b, lambda: (b, a)),
        "divide": _divide,
        "fma": lambda turn, a, b, c: (a * b + c, lambda: (b, a, _one(a))),
        "negate": lambda turn, a: (-a, lambda: (-_one(a),)),
        "square": lambda turn, a: (a.power(2), lambda: (a.scaled(exactly(2.0)),)),
        "sqrt": _sqrt,
        "hypot": _hypot,
        "absolute": _absolute,
        "maximum": lambda turn, a, b: _either(a, b, (a - b).expanded(), np.maximum),
        "minimum": lambda turn, a, b: _either(a, b, (b - a).expanded(), np.minimum),
        "sum_rest": lambda turn, a, b, s: (enclose_rest(s), lambda: (_one(a), _one(a), -_one(a))),
        "less": _less,
        "less_equal": _less_equal,
        "greater": lambda turn, a, b: _less(turn, b, a),
        "greater_equal": lambda turn, a, b: _less_equal(turn, b, a),
        "choose": _choose,
        "sin": lambda turn, a: (take_sine(a, turn), lambda: (take_cosine(a, turn),)),
        "cos": lambda turn, a: (take_cosine(a, turn), lambda: (-take_sine(a, turn),)),
        "tan": _tan,
        "arctan": lambda turn, a: (take_arctangent(a), lambda: (_one(a) / (_one(a) + a.power(2)),)),
        "arctan2": _arctan2,
        "exp": _exp,
        "log": _log,
    }
)
