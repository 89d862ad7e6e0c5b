"""Ball evaluation: an expression of SymPy -> a function that encloses it for given balls.

Each operation encloses, and so does the whole: the fundamental theorem of interval arithmetic
(Moore 1966), in balls. Integrals are those of Arb (Johansson 2018, by the method of Petras). Equal
parts are evaluated once. An undefined or undecided expression gives a ball that is not finite.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from functools import lru_cache, reduce
from typing import Any

import flint
import sympy as sp
from flint import acb, arb, fmpq

from mechproof.arithmetic.ball_functions import (
    COMPARISONS,
    COMPLEX,
    CONNECTIVES,
    CONSTANTS,
    ENTIRE,
    FUNCTIONS,
    NOT_ANALYTIC,
    NOT_FINITE,
    Ball,
    are_equal,
    take_real_part,
)
from mechproof.arithmetic.layout import Layout, Operation, Plan, Values
from mechproof.arithmetic.roots import enclose_iterate, enclose_root
from mechproof.record import NthDerivative
from mechproof.record.implicit import Implicit, Root
from mechproof.record.parts import find_free

Evaluator = Callable[[Values], Ball]
# A sum of more terms, or a product of more factors, is not written out.
MOST_TERMS = 1000
# Work limit: values of an integrand, for each bit of the precision.
_MOST_VALUES = 500
# Where a word begins in the name of a class.
_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
_ANALYTIC = sp.Dummy("analytic")
# The midpoint and the radius of a ball, or of both parts of a complex one.
_Parts = tuple[tuple[Any, Any], ...]


@lru_cache(maxsize=512)
def compile_expression(expression: sp.Basic) -> Evaluator:
    """Return a function that encloses the expression for balls of its symbols."""
    layout = Layout(expression, plan)
    return lambda values: layout.run(values)[-1]


def plan(node: sp.Basic) -> Plan:
    """Return the operation of a node and the nodes that it needs first."""
    if isinstance(node, sp.Rational):
        number = fmpq(int(node.p), int(node.q))
        return (lambda values: arb(number)), ()
    if node in CONSTANTS:
        constant = CONSTANTS[node]
        return (lambda values: constant()), ()
    if isinstance(node, sp.Symbol | sp.Indexed):
        return (lambda values: _look_up(node, values)), ()
    for kind, rule in _RULES:
        if isinstance(node, kind):
            return rule(node)
    function = FUNCTIONS.get(type(node))
    if function is None:
        name = _CAMEL.sub(" ", type(node).__name__).lower()
        raise NotImplementedError(f"the values of this cannot be enclosed: {name}")
    return _apply(node, function), node.args


def _look_up(symbol: sp.Basic, values: Values) -> Ball:
    # A single search, because SymPy compares two elements of a family by all their assumptions.
    try:
        return values[symbol]
    except KeyError:
        raise KeyError(f"no value given for the symbol {symbol}") from None


def _apply(node: sp.Basic, function: Callable[..., Ball]) -> Operation:
    def apply(values: Values, *arguments: Ball) -> Ball:
        if type(node) not in ENTIRE and any(isinstance(a, acb) for a in arguments):
            return _evaluate_complex(node, values, *arguments)
        # Some functions have values where their argument has none: to flint the sine of infinity is
        # [-1, 1].
        if not all(argument.is_finite() for argument in arguments):
            return NOT_FINITE
        return function(*arguments)

    return apply


def _evaluate_complex(node: sp.Basic, values: Values, *arguments: Ball) -> Ball:
    """Continue a real function into the complex plane; not finite where that is not analytic."""
    function = COMPLEX.get(type(node))
    if function is None:
        return NOT_ANALYTIC
    return function(*arguments, bool(values.get(_ANALYTIC, False)))


def _power(node: sp.Basic) -> Plan:
    exponent = node.args[1]
    if isinstance(exponent, sp.Integer):
        integer = int(exponent)
        return (lambda values, base: base**integer), node.args[:1]
    if isinstance(exponent, sp.Rational) and exponent.q == 2:
        halves = int(exponent.p)
        return (lambda values, base: _square_root(base, values) ** halves), node.args[:1]
    return _apply(node, operator.pow), node.args


def _square_root(base: Ball, values: Values) -> Ball:
    if isinstance(base, acb):
        return base.sqrt(analytic=bool(values.get(_ANALYTIC, False)))
    return base.sqrt()


def _repeat(node: sp.Basic) -> Plan:
    """Return the operation that combines the terms of a sum or the factors of a product."""
    index, lower, upper = node.limits[-1]
    inner = node.func(node.function, *node.limits[:-1]) if node.limits[1:] else node.function
    is_sum = isinstance(node, sp.Sum)
    combine, start_value = (operator.add, arb(0)) if is_sum else (operator.mul, arb(1))

    def put_together(values: Values, first: Ball, last: Ball) -> Ball:
        start, end = _as_integer(first), _as_integer(last)
        if start is None or end is None or not 0 <= end + 1 - start <= MOST_TERMS:
            return NOT_FINITE
        terms = (compile_expression(inner.subs(index, k))(values) for k in range(start, end + 1))
        return reduce(combine, terms, start_value)

    return put_together, (lower, upper)


def _as_integer(ball: Ball) -> int | None:
    """Return a limit as an integer, or None: papers disagree about sums to other limits."""
    integer = ball.unique_fmpz() if ball.is_finite() and ball.is_exact() else None
    return None if integer is None else int(integer)


def _integral(node: sp.Basic) -> Plan:
    (variable, lower, upper), *others = node.limits
    if others:
        raise NotImplementedError("an integral of an integral cannot be enclosed")
    names = find_free(node.function) - {variable}

    def integrate(values: Values, start: Ball, end: Ball) -> Ball:
        given = {name: values[name] for name in names & values.keys()}
        if not all(ball.is_finite() for ball in (start, end, *given.values())):
            return NOT_FINITE
        exact = tuple((name, _take_apart(ball)) for name, ball in given.items())
        ends = _take_apart(start), _take_apart(end)
        return _integrate(node.function, variable, ends, exact, flint.ctx.prec)

    return integrate, (lower, upper)


# Cached, because rows of a paper share integrals and are tried at the same points.
@lru_cache(maxsize=1024)
def _integrate(
    function: sp.Expr,
    variable: sp.Symbol,
    ends: tuple[_Parts, _Parts],
    given: tuple[tuple[sp.Basic, _Parts], ...],
    precision: int,
) -> Ball:
    """Integrate for given balls at flint's working precision, which must equal `precision`."""
    values = {name: _put_together(parts) for name, parts in given}
    start, end = (acb(_put_together(parts)) for parts in ends)
    layout = Layout(function, plan)
    # The integrand is run hundreds of times, so parts without its variable are computed once.
    layout.settle(values)

    def integrand(point: Ball, analytic: bool) -> Ball:
        return acb(layout.run({**values, variable: point, _ANALYTIC: analytic})[-1])

    if not all(integrand(_widen(*two), False).is_finite() for two in ((start, end), (end, start))):
        return NOT_FINITE
    return take_real_part(acb.integral(integrand, start, end, eval_limit=_MOST_VALUES * precision))


def _widen(end: Ball, other: Ball) -> Ball:
    """Return an end of an interval together with its immediate neighbourhood inside.

    An integrand without a finite enclosure there has none over the whole interval, however often
    that is halved.
    """
    return acb(end.real.union(end.real + (other - end).real * arb(2) ** (-2 * flint.ctx.prec)))


def _take_apart(ball: Ball) -> _Parts:
    """Return a ball exactly: midpoints and radii as whole numbers times powers of two."""
    parts = (ball,) if isinstance(ball, arb) else (ball.real, ball.imag)
    return tuple((part.mid().man_exp(), part.rad().man_exp()) for part in parts)


def _put_together(parts: _Parts) -> Ball:
    balls = [arb(middle, radius) for middle, radius in parts]
    return acb(*balls) if balls[1:] else balls[0]


def _piecewise(node: sp.Basic) -> Plan:
    def choose(values: Values) -> Ball:
        # An integrand that is one piece throughout the real part of a box is that piece in the box:
        # only its continuation from there is integrated.
        real = {name: b.real if isinstance(b, acb) else b for name, b in values.items()}
        for expression, condition in node.args:
            holds = decide(condition, real)
            if holds is None:
                return NOT_FINITE
            if holds:
                # Compiled here rather than made an operand of the choice, as other branches need
                # not have values here.
                return compile_expression(expression)(values)
        return NOT_FINITE

    return choose, ()


def _delta(node: sp.Basic) -> Plan:
    def compare(values: Values, first: Ball, second: Ball) -> Ball:
        equal = are_equal(first, second)
        return NOT_FINITE if equal is None else arb(int(equal))

    return compare, node.args


def _implicit(node: sp.Basic) -> Plan:
    enclose = enclose_root if isinstance(node, Root) else enclose_iterate
    return (lambda values: enclose(node, values, _run)), ()


def _run(expression: sp.Basic, values: Values) -> Ball:
    return compile_expression(expression)(values)


_WITHOUT_BALL = (sp.AccumBounds, NthDerivative)
_RULES: tuple[tuple[type[sp.Basic], Callable[[sp.Basic], Plan]], ...] = (
    *((kind, lambda node: ((lambda values: NOT_FINITE), ())) for kind in _WITHOUT_BALL),
    (sp.Add, lambda node: ((lambda values, *terms: reduce(operator.add, terms)), node.args)),
    (sp.Mul, lambda node: ((lambda values, *factors: reduce(operator.mul, factors)), node.args)),
    (sp.Pow, _power),
    (sp.Sum, _repeat),
    (sp.Product, _repeat),
    (sp.Integral, _integral),
    (Implicit, _implicit),
    (sp.Piecewise, _piecewise),
    (sp.KroneckerDelta, _delta),
)


def decide(relation: sp.Basic, values: Values) -> bool | None:
    """Decide a relation (or And, Or, Not of relations) for balls; None where they overlap."""
    if relation in (sp.true, sp.false):
        return bool(relation)
    if type(relation) in CONNECTIVES:
        return CONNECTIVES[type(relation)](*(decide(part, values) for part in relation.args))
    left, right = (compile_expression(side)(values) for side in relation.args)
    if not (left.is_finite() and right.is_finite()):
        return None
    return COMPARISONS[type(relation)](left, right)
