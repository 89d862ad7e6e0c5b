"""Series: in, a definition and the range of its variable; out, its Taylor series in balls.

The same SymPy expression that the proofs are about, symbols given by others expanded once. Taylor
coefficients are carried from step to step (Moore 1966), by the power series of Arb; those over a
whole ball enclose the remainder. What is undecided over a ball, as the side of an edge, leaves the
value enclosed and no derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import reduce
from operator import add, methodcaller, mul
from types import MappingProxyType
from typing import Any

import sympy as sp
from flint import arb, arb_series, ctx

from mechproof.arithmetic.ball_functions import COMPARISONS
from mechproof.arithmetic.balls import Ball, to_ball
from mechproof.arithmetic.layout import Given, Layout, Operation, Plan, Values

Series = Any
BITS = 128
CONSTANT_BITS = 640
# No series is longer than those of numbers.
LONGEST = 64
NAN = arb("nan")


@contextmanager
def working(order: int, bits: int = BITS) -> Iterator[None]:
    """Set flint's precision and the length of series for a block."""
    precision, length = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = bits, order
    try:
        yield
    finally:
        ctx.prec, ctx.cap = precision, length


def _leave_open() -> Series:
    """Return the series of what is not decided: a coefficient that is left out would be zero."""
    return arb_series([NAN] * ctx.cap)


def list_terms(series: Series) -> list[Ball]:
    """List the coefficients of a series, as many as series have."""
    terms: list[Ball] = series.coeffs()
    return terms + [arb(0)] * (ctx.cap - len(terms))


class TaylorExpression:
    """An expression of one variable, all other symbols numbers or given by others.

    What no variable is in is computed once.
    """

    def __init__(
        self, expression: sp.Basic, variable: sp.Symbol, given: Given, values: Mapping[Any, Any]
    ) -> None:
        self._variable = variable
        known = {symbol: value for symbol, value in values.items() if symbol != variable}
        with working(1, CONSTANT_BITS):
            inner = {s: e for s, e in given.items() if s not in (variable, *values)}
            self._layout = Layout(expression, plan, inner, whole=())
            balls = {symbol: arb_series([to_ball(value)]) for symbol, value in known.items()}
            self._layout.settle(balls, _lengthen)
        if unknown := self._layout.needs[-1] - {variable, *known}:
            raise KeyError(f"no value given for {', '.join(sorted(map(str, unknown)))}")

    @property
    def is_moving(self) -> bool:
        """Say whether the variable is in the expression."""
        return self._variable in self._layout.needs[-1]

    def expand(self, place: Series) -> Series:
        """Return the series where the variable is a series itself."""
        return self._layout.run({self._variable: place})[-1]

    def value(self, place: Any = 0) -> Ball:
        """Return the value at a number."""
        with working(1, ctx.prec):
            return list_terms(self.expand(arb_series([place])))[0]


def _lengthen(value: Any) -> Any:
    """Return a number as a series of any length; what is decided as it is."""
    if not isinstance(value, arb_series):
        return value
    with working(1):
        constant = list_terms(value)
    with working(LONGEST):
        return arb_series(constant)


def plan(node: sp.Basic) -> Plan:
    """Return what to do at a node and the nodes it needs first."""
    if isinstance(node, sp.Symbol):
        return (lambda values: values[node]), ()
    if isinstance(node, sp.Number | sp.NumberSymbol):
        return (lambda values: arb_series([to_ball(node)])), ()
    if node in (sp.true, sp.false):
        return (lambda values: bool(node)), ()
    if isinstance(node, sp.Piecewise):
        return _choose, tuple(part for pair in node.args for part in pair.args)
    if isinstance(node, sp.Pow):
        return (lambda values, base: _raise(base, node.exp)), (node.base,)
    if type(node) in COMPARISONS:
        return (lambda values, a, b: _compare(type(node), a, b)), node.args
    for kind, method in _RULES.items():
        if isinstance(node, kind):
            return _apply(method), node.args
    raise NotImplementedError(f"no series of {type(node).__name__}")


def _apply(method: Callable[..., Series]) -> Operation:
    return lambda values, *operands: method(*operands)


def _choose(values: Values, *parts: Any) -> Series:
    for value, holds in zip(parts[::2], parts[1::2], strict=True):
        if holds is None:
            break
        if holds:
            return value
    return _leave_open()


def _compare(kind: type[sp.Basic], left: Series, right: Series) -> bool | None:
    return COMPARISONS[kind](list_terms(left)[0], list_terms(right)[0])


def _raise(base: Series, exponent: sp.Basic) -> Series:
    if isinstance(exponent, sp.Integer):
        power = reduce(mul, [base] * abs(int(exponent)), arb_series([1]))
        if exponent > 0:
            return power
        return _leave_open() if list_terms(power)[0].contains(0) else 1 / power
    if isinstance(exponent, sp.Rational) and exponent.q == 2:
        return _raise(base.sqrt(), sp.Integer(exponent.p))
    raise NotImplementedError(f"no series of a power {exponent}")


def _larger(a: Series, b: Series) -> Series:
    one, other = list_terms(a)[0], list_terms(b)[0]
    if one >= other:
        return a
    if one <= other:
        return b
    return arb_series([one.max(other), *[NAN] * (ctx.cap - 1)])


def _direction(y: Series, x: Series) -> Series:
    """Return atan2(y, x) as the integral of (x dy - y dx)/(x**2 + y**2)."""
    start = arb.atan2(list_terms(y)[0], list_terms(x)[0])
    square = x * x + y * y
    if list_terms(square)[0].contains(0):
        return _leave_open()
    if ctx.cap == 1:
        return arb_series([start])
    turn = ((x * y.derivative() - y * x.derivative()) / square).integral()
    return turn + start


_RULES: Mapping[type[sp.Basic], Callable[..., Series]] = MappingProxyType(
    {
        sp.Add: lambda *terms: reduce(add, terms),
        sp.Mul: lambda *terms: reduce(mul, terms),
        # Flint calls them as SymPy does.
        **{
            kind: methodcaller(kind.__name__)
            for kind in (sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.exp, sp.log)
        },
        sp.atan2: _direction,
        sp.Max: lambda *terms: reduce(_larger, terms),
        sp.Abs: lambda a: _larger(a, -a),
    }
)


def is_finite(terms: Sequence[Ball]) -> bool:
    """Say whether all coefficients are finite."""
    return all(term.is_finite() for term in terms)
