"""Rules: for each kind of operation its value and its partial derivatives, in monomials.

These are the elementary partial derivatives of automatic differentiation (Griewank and Walther
2008), over boxes: `bound` takes them in reverse.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from mechproof.arithmetic.intervals import (
    EPS,
    ONE,
    UNIT,
    Ends,
    Interval,
    Mask,
    around,
    exactly,
    exponential,
    logarithm,
)
from mechproof.roundoff.angles import (
    Turn,
    take_angle,
    take_arctangent,
    take_cosine,
    take_sine,
    take_tangent,
)
from mechproof.roundoff.interval_monomials import IntervalMonomial

EITHER = Interval(np.float64(-1.0), np.float64(1.0))
SOME = Interval(np.float64(0.0), np.float64(1.0))

# How the value of an operation moves with each operand; None where it does not.
Slopes = tuple[IntervalMonomial | None, ...]
Moved = tuple[IntervalMonomial, Slopes]
Rule = Callable[[Sequence[IntervalMonomial], Turn | None], Moved]


def _one(monomial: IntervalMonomial) -> IntervalMonomial:
    return monomial.variables.constant(ONE)


def _add(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    return a + b, (_one(a), _one(a))


def _subtract(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    return a - b, (_one(a), -_one(a))


def _multiply(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    return a * b, (b, a)


def _divide(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    quotient = a / b
    return quotient, (_one(a) / b, -(quotient / b))


def _fma(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b, c = given
    return a * b + c, (b, a, _one(a))


def _negate(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    return -given[0], (-_one(given[0]),)


def _square(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    return given[0].squared(), (given[0].scaled(exactly(2.0)),)


def _sqrt(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    (a,) = given
    # Odd powers of what vanishes have no root among the monomials, nor squares of what has any
    # sign.
    halves = a.variables.intern(tuple([p // 2 for p in a.powers]))
    if any(p % 2 for p in a.powers) or not a.variables.is_positive(halves):
        root = a.variables.constant(a.expanded().sqrt())
    else:
        root = IntervalMonomial(a.variables, a.span.sqrt(), halves)
    return root, (a.variables.constant(exactly(0.5)) / root,)


def _hypot(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    root, _ = _sqrt((a.squared() + b.squared(),), turn)
    return root, (a / root, b / root)


def _absolute(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    (a,) = given
    if sign := a.decide_sign():
        return (a if sign > 0 else -a), (a.variables.constant(exactly(sign)),)
    return a.size(), (a.variables.constant(EITHER),)


def _maximum(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    return _either(a, b, (a - b).expanded(), np.maximum)


def _minimum(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    return _either(a, b, (b - a).expanded(), np.minimum)


def _either(
    a: IntervalMonomial, b: IntervalMonomial, lead: Interval, choose: Callable[[Ends, Ends], Ends]
) -> Moved:
    """Return the first where it leads, the second where it does not, both where undecided."""
    one = _one(a)
    leads, follows = lead.low >= 0, lead.high <= 0
    choice = a.variables.choose(leads, follows & ~leads, ~(leads | follows))
    if choice < 2:
        return (a, b)[choice], ((one, None), (None, one))[choice]
    some = a.variables.constant(SOME)
    return a.extreme(b, choose), (some, some)


def enclose_rest(rounded: IntervalMonomial) -> IntervalMonomial:
    """Return what rounding to nearest took from a result."""
    return rounded.scaled(around(0.0, UNIT * (1 + EPS)))


def _sum_rest(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    one = _one(given[0])
    return enclose_rest(given[2]), (one, one, -one)


def _less(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    lead = (b - a).expanded()
    return _decide(a, lead.low > 0, lead.high <= 0)


def _less_equal(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    a, b = given
    lead = (b - a).expanded()
    return _decide(a, lead.low >= 0, lead.high < 0)


def _decide(one: IntervalMonomial, holds: Mask, fails: Mask) -> Moved:
    """Return 1 where a comparison holds and 0 where it does not, whatever the roundings are."""
    truth = Interval(np.where(holds, 1.0, 0.0), np.where(fails, 0.0, 1.0))
    return one.variables.constant(truth), (None, None)


def _choose(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    """Return what is chosen, where nobody knows which one, both."""
    test, a, b = given
    is_first, is_second = test.span.low == 1, test.span.high == 0
    chosen = a.variables.choose(is_first, is_second, ~(is_first | is_second))
    if chosen < 2:
        return (a, b)[chosen], ((None, _one(a), None), (None, None, _one(a)))[chosen]
    some = a.variables.constant(SOME)
    return a.hull(b), (None, some, some)


def _tan(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    tangent = take_tangent(given[0], turn)
    return tangent, (_one(tangent) + tangent.squared(),)


def _sin(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    return take_sine(given[0], turn), (take_cosine(given[0], turn),)


def _cos(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    return take_cosine(given[0], turn), (-take_sine(given[0], turn),)


def _arctan(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    (a,) = given
    return take_arctangent(a), (_one(a) / (_one(a) + a.squared()),)


def _arctan2(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    y, x = given
    square = x.squared() + y.squared()
    return take_angle(y, x), (x / square, -(y / square))


def _exp(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    (a,) = given
    value = a.variables.constant(exponential(a.expanded()))
    return value, (value,)


def _log(given: Sequence[IntervalMonomial], turn: Turn | None) -> Moved:
    (a,) = given
    return a.variables.constant(logarithm(a.expanded())), (_one(a) / a,)


RULES: Mapping[str, Rule] = MappingProxyType(
    {
        "add": _add,
        "subtract": _subtract,
        "multiply": _multiply,
        "divide": _divide,
        "fma": _fma,
        "negate": _negate,
        "square": _square,
        "sqrt": _sqrt,
        "hypot": _hypot,
        "absolute": _absolute,
        "maximum": _maximum,
        "minimum": _minimum,
        "sum_rest": _sum_rest,
        "less": _less,
        "less_equal": _less_equal,
        "greater": lambda given, turn: _less(given[::-1], turn),
        "greater_equal": lambda given, turn: _less_equal(given[::-1], turn),
        "choose": _choose,
        "sin": _sin,
        "cos": _cos,
        "tan": _tan,
        "arctan": _arctan,
        "arctan2": _arctan2,
        "exp": _exp,
        "log": _log,
    }
)
