"""Ball arithmetic: a SymPy expression at exact values -> an enclosure (python-flint).

Every number that leaves this module encloses the true value. An expression that is undefined
at the point, or that cannot be decided there (a comparison inside the ball), gives a
non-finite ball, never a guess.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache
from typing import Any

import flint
import sympy as sp
from flint import acb, arb, fmpq

from mechproof.record import ValueWhere

Ball = Any
Values = Mapping[sp.Basic, Any]
Evaluator = Callable[[Values], Ball]
Operation = Callable[..., Ball]
Plan = tuple[Operation, tuple[sp.Basic, ...]]

PRECISIONS = (64, 128, 256, 512, 1024)
NOT_FINITE = arb("nan")
NOT_ANALYTIC = acb("nan")
# A sum of more terms is not written out.
MOST_TERMS = 1000
_ANALYTIC = sp.Dummy("analytic")


@contextmanager
def working_precision(bits: int) -> Iterator[None]:
    """Set flint's precision for a block and put the old one back."""
    before = flint.ctx.prec
    flint.ctx.prec = bits
    try:
        yield
    finally:
        flint.ctx.prec = before


def to_ball(number: Any) -> Ball:
    """Return the ball of a double, an integer or a fraction, exact, or of a number of SymPy."""
    if isinstance(number, arb | acb):
        return number
    if isinstance(number, sp.Float):
        number = sp.Rational(number)
    if isinstance(number, sp.Rational):
        return arb(fmpq(int(number.p), int(number.q)))
    if isinstance(number, Fraction):
        return arb(fmpq(number.numerator, number.denominator))
    if isinstance(number, sp.Expr):
        return _compile(number)({})
    return arb(int(number)) if isinstance(number, int) else arb(float(number))


def evaluate(expression: sp.Basic, values: Values, bits: int = 128) -> Ball:
    """Enclose `expression` at `values` (symbol -> exact number) with `bits` of precision.

    Returns an `arb`; non-finite where the expression is undefined or undecided.
    Raises `NotImplementedError` naming a function that has no ball version.
    """
    with working_precision(bits):
        result = _compile(expression)(_to_balls(values))
        return result if isinstance(result, arb) else _real_part(result)


def evaluate_until(
    expression: sp.Basic,
    values: Values,
    relative_bits: int,
    precisions: tuple[int, ...] = PRECISIONS,
) -> Ball:
    """Raise the precision until the ball has `relative_bits` correct bits; non-finite if never."""
    for bits in precisions:
        ball = evaluate(expression, values, bits)
        if ball.is_finite() and (ball.rel_accuracy_bits() >= relative_bits or ball == 0):
            return ball
    return NOT_FINITE


def show(ball: Ball, digits: int = 12) -> str:
    """Return the ball as text: midpoint and radius."""
    return str(ball.str(digits))


def show_apart(left: Ball, right: Ball) -> tuple[str, str]:
    """Return two balls as texts, with as many digits as tell them apart."""
    for digits in (12, 24, 48, 96):
        texts = show(left, digits), show(right, digits)
        with working_precision(4 * digits + 64):
            if not arb(texts[0]).overlaps(arb(texts[1])):
                return texts
    with working_precision(PRECISIONS[-1]):
        return show(left), f"{show(right)}, the difference is {show(right - left, 3)}"


def truth(relation: sp.Basic, values: Values, bits: int = 128) -> bool | None:
    """Decide a relation (or And, Or, Not of relations) at a point; None where balls overlap."""
    with working_precision(bits):
        return _truth(relation, _to_balls(values))


def _to_balls(values: Values) -> dict[sp.Basic, Ball]:
    return {symbol: to_ball(value) for symbol, value in values.items()}


def _real_part(ball: Ball) -> Ball:
    return ball.real if ball.imag.contains(0) else NOT_FINITE


@lru_cache(maxsize=512)
def _compile(expression: sp.Basic) -> Evaluator:
    """Lay an expression out as a list of operations on slots, equal parts sharing one slot."""
    slots: dict[sp.Basic, int] = {}
    steps: list[tuple[Operation, tuple[int, ...]]] = []

    def place(node: sp.Basic) -> int:
        if node not in slots:
            operation, arguments = _operation(node)
            indices = tuple(place(argument) for argument in arguments)
            slots[node] = len(steps)
            steps.append((operation, indices))
        return slots[node]

    place(expression)

    def run(values: Values) -> Ball:
        results: list[Ball] = []
        for operation, indices in steps:
            results.append(operation(values, *[results[k] for k in indices]))
        return results[-1]

    return run


def _operation(node: sp.Basic) -> Plan:
    """Return what to do at a node and the nodes it needs first."""
    if isinstance(node, sp.Rational):
        number = fmpq(int(node.p), int(node.q))
        return (lambda values: arb(number)), ()
    if node in _CONSTANTS:
        constant = _CONSTANTS[node]
        return (lambda values: constant()), ()
    if isinstance(node, sp.Symbol | sp.Indexed):
        return (lambda values: _look_up(node, values)), ()
    for kind, rule in _RULES:
        if isinstance(node, kind):
            return rule(node)
    function = _FUNCTIONS.get(type(node))
    if function is None:
        raise NotImplementedError(f"no ball version of {type(node).__name__}")
    return _apply(node, function), node.args


def _look_up(symbol: sp.Basic, values: Values) -> Ball:
    if symbol not in values:
        raise KeyError(f"no value given for the symbol {symbol}")
    return values[symbol]


def _apply(node: sp.Basic, function: Callable[..., Ball]) -> Operation:
    def apply(values: Values, *arguments: Ball) -> Ball:
        if type(node) not in _ENTIRE and any(isinstance(a, acb) for a in arguments):
            return _evaluate_complex(node, values, *arguments)
        if not all(argument.is_finite() for argument in arguments):
            return NOT_FINITE
        return function(*arguments)

    return apply


def _evaluate_complex(node: sp.Basic, values: Values, *arguments: Ball) -> Ball:
    """Continue a real function into the complex plane; not finite where that is not analytic."""
    function = _COMPLEX.get(type(node))
    if function is None:
        raise NotImplementedError(f"no analytic version of {type(node).__name__}")
    return function(*arguments, bool(values.get(_ANALYTIC, False)))


def _within_strip(ball: Ball, analytic: bool) -> bool:
    """Tell whether a ball is off the cuts of the arctangent."""
    return not analytic or bool(abs(ball.imag) < 1)


def _within_slit(ball: Ball, analytic: bool) -> bool:
    """Tell whether a ball is off the cuts of arcsine and arccosine."""
    return not analytic or bool(abs(ball.real) < 1)


def _add(node: sp.Basic) -> Plan:
    return (lambda values, first, *rest: _accumulate(operator.add, first, rest)), node.args


def _multiply(node: sp.Basic) -> Plan:
    return (lambda values, first, *rest: _accumulate(operator.mul, first, rest)), node.args


def _accumulate(combine: Callable[[Ball, Ball], Ball], first: Ball, rest: Iterable[Ball]) -> Ball:
    for ball in rest:
        first = combine(first, ball)
    return first


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


def _sum(node: sp.Basic) -> Plan:
    index, lower, upper = node.limits[-1]
    inner = node.function if len(node.limits) == 1 else sp.Sum(node.function, *node.limits[:-1])

    def add_terms(values: Values, first: Ball, last: Ball) -> Ball:
        start, end = _as_integer(first), _as_integer(last)
        if start is None or end is None or not 0 <= end + 1 - start <= MOST_TERMS:
            return NOT_FINITE
        terms = (_compile(inner.subs(index, k))(values) for k in range(start, end + 1))
        return _accumulate(operator.add, arb(0), terms)

    return add_terms, (lower, upper)


def _as_integer(ball: Ball) -> int | None:
    """Return the integer that a limit is; papers do not agree on what a sum to another one is."""
    integer = ball.unique_fmpz() if ball.is_finite() and ball.is_exact() else None
    return None if integer is None else int(integer)


def _integral(node: sp.Basic) -> Plan:
    (variable, lower, upper), *others = node.limits
    if others:
        raise NotImplementedError("no ball version of a multiple Integral")
    function = _compile(node.function)

    def integrate(values: Values, start: Ball, end: Ball) -> Ball:
        def integrand(point: Ball, analytic: bool) -> Ball:
            return acb(function({**values, variable: point, _ANALYTIC: analytic}))

        if not (start.is_finite() and end.is_finite()):
            return NOT_FINITE
        return _real_part(acb.integral(integrand, acb(start), acb(end)))

    return integrate, (lower, upper)


def _piecewise(node: sp.Basic) -> Plan:
    def choose(values: Values) -> Ball:
        for expression, condition in node.args:
            holds = _truth(condition, values)
            if holds is None:
                return NOT_FINITE
            if holds:
                return _compile(expression)(values)
        return NOT_FINITE

    return choose, ()


def _delta(node: sp.Basic) -> Plan:
    def compare(values: Values, first: Ball, second: Ball) -> Ball:
        equal = _equal(first, second)
        return NOT_FINITE if equal is None else arb(int(equal))

    return compare, node.args


def _truth(relation: sp.Basic, values: Values) -> bool | None:
    if relation in (sp.true, sp.false):
        return bool(relation)
    if isinstance(relation, sp.And | sp.Or):
        parts = [_truth(part, values) for part in relation.args]
        decisive = isinstance(relation, sp.Or)
        if decisive in parts:
            return decisive
        return None if None in parts else not decisive
    if isinstance(relation, sp.Not):
        part = _truth(relation.args[0], values)
        return None if part is None else not part
    left, right = (_compile(side)(values) for side in relation.args)
    if not (left.is_finite() and right.is_finite()):
        return None
    return _COMPARISONS[type(relation)](left, right)


def _certain(yes: Ball, no: Ball) -> bool | None:
    return True if yes else False if no else None


def _equal(left: Ball, right: Ball) -> bool | None:
    exact = left.is_exact() and right.is_exact() and left == right
    return _certain(exact, not left.overlaps(right))


_COMPARISONS: dict[type[sp.Basic], Callable[[Ball, Ball], bool | None]] = {
    sp.StrictLessThan: lambda a, b: _certain(a < b, a >= b),
    sp.LessThan: lambda a, b: _certain(a <= b, a > b),
    sp.StrictGreaterThan: lambda a, b: _certain(a > b, a <= b),
    sp.GreaterThan: lambda a, b: _certain(a >= b, a < b),
    sp.Equality: _equal,
    sp.Unequality: lambda a, b: None if (e := _equal(a, b)) is None else not e,
}

_CONSTANTS: dict[sp.Basic, Callable[[], Ball]] = {
    sp.pi: arb.pi,
    sp.E: arb.const_e,
    sp.EulerGamma: arb.const_euler,
    sp.I: lambda: NOT_FINITE,
    sp.nan: lambda: NOT_FINITE,
    sp.zoo: lambda: NOT_FINITE,
    sp.oo: lambda: NOT_FINITE,
    -sp.oo: lambda: NOT_FINITE,
}

_RULES: tuple[tuple[type[sp.Basic], Callable[[sp.Basic], Plan]], ...] = (
    (sp.AccumBounds, lambda node: ((lambda values: NOT_FINITE), ())),
    (sp.Add, _add),
    (sp.Mul, _multiply),
    (sp.Pow, _power),
    (sp.Sum, _sum),
    (sp.Integral, _integral),
    (sp.Piecewise, _piecewise),
    (sp.KroneckerDelta, _delta),
)

_FUNCTIONS: dict[type[sp.Basic], Callable[..., Ball]] = {
    sp.sin: lambda x: x.sin(),
    sp.cos: lambda x: x.cos(),
    sp.tan: lambda x: x.tan(),
    sp.cot: lambda x: x.cot(),
    sp.asin: lambda x: x.asin(),
    sp.acos: lambda x: x.acos(),
    sp.atan: lambda x: x.atan(),
    sp.atan2: lambda y, x: _arctangent(y, x),
    sp.exp: lambda x: x.exp(),
    sp.log: lambda x: x.log(),
    sp.sec: lambda x: x.sec(),
    sp.csc: lambda x: x.csc(),
    sp.sinh: lambda x: x.sinh(),
    sp.cosh: lambda x: x.cosh(),
    sp.tanh: lambda x: x.tanh(),
    sp.coth: lambda x: x.coth(),
    sp.asinh: lambda x: x.asinh(),
    sp.acosh: lambda x: x.acosh(),
    sp.atanh: lambda x: x.atanh(),
    sp.erf: lambda x: x.erf(),
    sp.erfc: lambda x: x.erfc(),
    sp.factorial: lambda x: (x + 1).gamma(),
    ValueWhere: lambda value, needed: value,
    sp.floor: lambda x: x.floor(),
    sp.ceiling: lambda x: x.ceil(),
    sp.Abs: abs,
    sp.sign: lambda x: x.sgn(),
    sp.Max: lambda *xs: _fold(arb.max, xs),
    sp.Min: lambda *xs: _fold(arb.min, xs),
    sp.elliptic_e: lambda m: _real_part(acb(m).elliptic_e()),
    sp.elliptic_k: lambda m: _real_part(acb(m).elliptic_k()),
    sp.betainc_regularized: lambda a, b, x0, x1: _beta(a, b, x1) - _beta(a, b, x0),
}

# Of a complex ball, and whether the integration asks for an analytic function.
_COMPLEX: dict[type[sp.Basic], Callable[..., Ball]] = {
    ValueWhere: lambda z, needed, analytic: z if needed.is_finite() else NOT_ANALYTIC,
    sp.Abs: lambda z, analytic: z.real_abs(analytic),
    sp.sign: lambda z, analytic: z.real_sgn(analytic),
    sp.Pow: lambda z, exponent, analytic: acb(z).pow(exponent, analytic),
    sp.log: lambda z, analytic: z.log(analytic),
    sp.atan: lambda z, analytic: z.atan() if _within_strip(z, analytic) else NOT_ANALYTIC,
    sp.asin: lambda z, analytic: z.asin() if _within_slit(z, analytic) else NOT_ANALYTIC,
    sp.acos: lambda z, analytic: z.acos() if _within_slit(z, analytic) else NOT_ANALYTIC,
}

_ENTIRE = (
    *(sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc, sp.exp, sp.erf, sp.erfc),
    *(sp.sinh, sp.cosh, sp.tanh, sp.coth),
)


def _beta(a: Ball, b: Ball, x: Ball) -> Ball:
    return arb(0) if x == 0 else arb.beta_lower(x, a, b, regularized=True)


def _arctangent(y: Ball, x: Ball) -> Ball:
    """Enclose atan2; flint gives [-pi, pi] where the vector may be zero, which has no argument."""
    return NOT_FINITE if y.contains(0) and x.contains(0) else arb.atan2(y, x)


def _fold(function: Callable[[Ball, Ball], Ball], balls: tuple[Ball, ...]) -> Ball:
    return _accumulate(function, balls[0], balls[1:])
