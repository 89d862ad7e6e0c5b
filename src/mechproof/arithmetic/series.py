"""Series: a definition and the range of its variable -> its Taylor series in balls.

It is the same SymPy expression that the proofs are about, with symbols given by others expanded
once. Taylor coefficients are carried from step to step (Moore 1966; Griewank and Walther 2008,
chapter 13), by the power series of Arb; those over a whole ball enclose the remainder. Functions
that SymPy defines by others are rewritten by these. If something is undecided over a ball, such as
the side of an edge, the value is still enclosed, but no derivative is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import reduce
from operator import add, methodcaller
from types import MappingProxyType
from typing import Any

import sympy as sp
from flint import arb, arb_series, ctx
from sympy.codegen.cfunctions import expm1, log1p

from mechproof.arithmetic.ball_functions import COMPARISONS, CONNECTIVES, FUNCTIONS, NOT_FINITE
from mechproof.arithmetic.balls import Ball, to_ball
from mechproof.arithmetic.layout import Given, Layout, Operation, Plan

Series = Any
Rules = Mapping[type[sp.Basic], Callable[..., Any]]
_ALIKE: Rules = MappingProxyType(
    {
        sp.Add: lambda *terms: reduce(add, terms),
        # Flint has these under SymPy's names.
        **{
            kind: methodcaller(kind.__name__)
            for kind in (sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.exp, sp.log)
        },
    }
)
# Functions that SymPy can rewrite by others.
_WRITTEN_BY: Mapping[type[sp.Basic], type[sp.Basic]] = MappingProxyType(
    {
        sp.sec: sp.cos,
        sp.csc: sp.sin,
        sp.cot: sp.cos,
        **dict.fromkeys((sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech, sp.csch, expm1), sp.exp),
        **dict.fromkeys((sp.asinh, sp.acosh, sp.atanh, log1p), sp.log),
        **dict.fromkeys((sp.Mod, sp.frac, sp.ceiling), sp.floor),
    }
)
BITS = 128
CONSTANT_BITS = 640
# The longest series: those of plain numbers are stored at this length.
LONGEST = 64


def plan_function(node: sp.Basic, own: Rules) -> Plan:
    """Return the operation of a node and the nodes it needs first; `own` rules take precedence.

    Raises `NotImplementedError` naming a function that has no series.
    """
    kind = type(node)
    if kind in _WRITTEN_BY:
        return apply(lambda value: value), (node.rewrite(_WRITTEN_BY[kind], deep=False),)
    method = own.get(kind) or _ALIKE.get(kind)
    if method is None:
        raise NotImplementedError(f"no series is known for {kind.__name__}")
    return apply(method), node.args


def apply(method: Callable[..., Any]) -> Operation:
    """Return a function of operands as an operation, which needs no symbols."""
    return lambda values, *operands: method(*operands)


def list_sinc(count: int) -> list[sp.Rational]:
    """List the first `count` Taylor coefficients of sin(x)/x at zero."""
    signs = (sp.S.One, sp.S.Zero, -sp.S.One, sp.S.Zero)
    return [signs[k % 4] / sp.factorial(k + 1) for k in range(count)]


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
    """Return the series of something undecided: coefficients left out would count as zero."""
    return arb_series([NOT_FINITE] * ctx.cap)


def list_terms(series: Series) -> list[Ball]:
    """List the coefficients of a series, padded with zeros to the current length."""
    terms: list[Ball] = series.coeffs()
    return terms + [arb(0)] * (ctx.cap - len(terms))


class TaylorExpression:
    """An expression of one variable, all other symbols numbers or given by others.

    Parts without the variable are computed once.
    """

    def __init__(
        self, expression: sp.Basic, variable: sp.Symbol, given: Given, values: Mapping[Any, Any]
    ) -> None:
        self._variable = variable
        known = {symbol: value for symbol, value in values.items() if symbol != variable}
        # Computed once for all expansions, with more bits than the most precise of these.
        with working(1, CONSTANT_BITS):
            inner = {s: e for s, e in given.items() if s not in (variable, *values)}
            self._layout = Layout(expression, plan, inner, whole=())
            balls = {symbol: arb_series([to_ball(value)]) for symbol, value in known.items()}
            self._layout.settle(balls, _lengthen)
        if unknown := self._layout.needs[-1] - {variable, *known}:
            raise KeyError(f"no value given for {', '.join(sorted(map(str, unknown)))}")

    @property
    def is_moving(self) -> bool:
        """Return whether the expression contains the variable."""
        return self._variable in self._layout.needs[-1]

    def expand(self, place: Series) -> Series:
        """Return the series at a variable that is itself a series."""
        return self._layout.run({self._variable: place})[-1]

    def value(self, place: Any = 0) -> Ball:
        """Return the value at a number."""
        with working(1, ctx.prec):
            return list_terms(self.expand(arb_series([place])))[0]


def _lengthen(value: Any) -> Any:
    """Return a number as a series of any length; leave a decided truth value unchanged."""
    if not isinstance(value, arb_series):
        return value
    with working(1):
        constant = list_terms(value)
    with working(LONGEST):
        return arb_series(constant)


def plan(node: sp.Basic) -> Plan:
    """Return the operation of a node and the nodes that it needs first."""
    if isinstance(node, sp.Symbol):
        return (lambda values: values[node]), ()
    if isinstance(node, sp.Number | sp.NumberSymbol):
        return apply(lambda: arb_series([to_ball(node)])), ()
    if node in (sp.true, sp.false):
        return apply(lambda: bool(node)), ()
    if isinstance(node, sp.Piecewise):
        return apply(_choose), tuple(part for pair in node.args for part in pair.args)
    return plan_function(node, _RULES)


def _choose(*parts: Any) -> Series:
    for value, holds in zip(parts[::2], parts[1::2], strict=True):
        if holds is None:
            break
        if holds:
            return value
    return _leave_open()


def _compare(kind: type[sp.Basic]) -> Callable[[Series, Series], bool | None]:
    return lambda left, right: COMPARISONS[kind](list_terms(left)[0], list_terms(right)[0])


def _multiply(a: Series, b: Series) -> Series:
    # Flint takes zero times a ball that is not finite for zero.
    both_finite = all(list_terms(factor)[0].is_finite() for factor in (a, b))
    return a * b if both_finite else _leave_open()


def _raise(base: Series, exponent: Series) -> Series:
    """Raise to whole and half powers by products, and a positive base to other powers by ln."""
    if not list_terms(base)[0].is_finite():
        return _leave_open()
    halves = (2 * list_terms(exponent)[0]).unique_fmpz() if _is_exact(exponent) else None
    if halves is None:
        return _multiply(exponent, base.log()).exp()
    if halves % 2:
        return _raise_whole(base.sqrt(), int(halves))
    return _raise_whole(base, int(halves) // 2)


def _is_exact(series: Series) -> bool:
    """Return whether a series is a number without a radius."""
    return series.length() <= 1 and all(term.is_exact() for term in series.coeffs())


def _raise_whole(base: Series, exponent: int) -> Series:
    if exponent < 0:
        power = _raise_whole(base, -exponent)
        return _leave_open() if list_terms(power)[0].contains(0) else 1 / power
    if exponent <= 1:
        return base if exponent else arb_series([1])
    half = _raise_whole(base, exponent // 2)
    return half * half * base if exponent % 2 else half * half


def _hold(kind: type[sp.Basic]) -> Callable[..., Series]:
    """Return a step function on series: where its value is one number, its slope is zero."""

    def hold(*operands: Series) -> Series:
        value = FUNCTIONS[kind](*(list_terms(operand)[0] for operand in operands))
        return arb_series([value] if value.is_exact() else [value, *[NOT_FINITE] * (ctx.cap - 1)])

    return hold


def _sinc(a: Series) -> Series:
    """Return the series of sin(a)/a, 1 at zero."""
    start, *rest = list_terms(a)
    if not is_finite(rest):
        return arb_series([start.sinc(), *[NOT_FINITE] * len(rest)])
    change = arb_series([0, *rest])
    terms = reversed(_expand_sinc(start))
    return reduce(lambda total, term: total * change + term, terms, arb_series([0]))


def _expand_sinc(place: Ball) -> list[Ball]:
    """List the terms about a place: as a quotient, or those about zero, whichever are narrower.

    The derivative of order n is the integral of s**n times that of the cosine, for s from 0 to 1.
    """
    reach = arb(0, abs(place).upper())
    zero = enumerate(map(to_ball, list_sinc(ctx.cap)))
    near = [term + reach / ((k + 2) * arb.fac_ui(k)) for k, term in zero]
    if place.contains(0):
        return near
    moving = arb_series([place, 1])
    far = list_terms(moving.sin() / moving)
    return [min(pair, key=arb.rad) for pair in zip(near, far, strict=True)]


def _larger(a: Series, b: Series) -> Series:
    one, other = list_terms(a)[0], list_terms(b)[0]
    if one >= other:
        return a
    if one <= other:
        return b
    return arb_series([one.max(other), *[NOT_FINITE] * (ctx.cap - 1)])


def _direction(y: Series, x: Series) -> Series:
    """Return atan2(y, x) as the integral of (x dy - y dx)/(x**2 + y**2)."""
    start = arb.atan2(list_terms(y)[0], list_terms(x)[0])
    square = x * x + y * y
    if list_terms(square)[0].contains(0):
        return _leave_open()
    if ctx.cap == 1:
        return arb_series([start])
    # The integral starts from zero, and `start` holds the angle there.
    turn = ((x * y.derivative() - y * x.derivative()) / square).integral()
    return turn + start


_RULES: Rules = MappingProxyType(
    {
        **{kind: _compare(kind) for kind in COMPARISONS},
        **CONNECTIVES,
        sp.Mul: lambda *factors: reduce(_multiply, factors),
        sp.Pow: _raise,
        sp.atan2: _direction,
        sp.sinc: _sinc,
        sp.Max: lambda *terms: reduce(_larger, terms),
        sp.Min: lambda *terms: -reduce(_larger, (-term for term in terms)),
        sp.Abs: lambda a: _larger(a, -a),
        **{kind: _hold(kind) for kind in (sp.sign, sp.floor, sp.Heaviside)},
    }
)


def is_finite(terms: Sequence[Ball]) -> bool:
    """Return whether all coefficients are finite."""
    return all(term.is_finite() for term in terms)
