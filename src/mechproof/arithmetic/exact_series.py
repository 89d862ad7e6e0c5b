"""Exact series: an expression in one symbol -> its rational Taylor coefficients at zero.

The layout and the rules are those of `series`, with rationals for balls: a ball that contains zero
is not known to be zero, and a proof near zero begins with coefficients that vanish.
"""

from __future__ import annotations

from functools import reduce
from operator import mul
from types import MappingProxyType

import sympy as sp
from flint import fmpq, fmpq_series

from mechproof.arithmetic.layout import Layout, Plan
from mechproof.arithmetic.series import Rules, Series, apply, list_sinc, plan_function, working

# Number of coefficients: one fewer than in balls, which enclose the remainder, too.
ORDER = 63


def expand_at_zero(expression: sp.Expr, symbol: sp.Symbol) -> list[sp.Rational] | None:
    """Return `ORDER` coefficients, or None if there are none or they are not rational."""
    with working(ORDER):
        try:
            layout = Layout(expression, _plan, whole=())
            found = layout.run({symbol: fmpq_series([0, 1])})[-1].coeffs()
        except (ValueError, ZeroDivisionError, KeyError, NotImplementedError):
            return None
    terms = [sp.Rational(int(c.p), int(c.q)) for c in found]
    return terms + [sp.S.Zero] * (ORDER - len(terms))


def _plan(node: sp.Basic) -> Plan:
    if isinstance(node, sp.Symbol):
        return (lambda values: values[node]), ()
    if isinstance(node, sp.Rational):
        return apply(lambda: fmpq_series([_number(node)])), ()
    if isinstance(node, sp.Pow) and node.exp.is_Integer:
        return apply(lambda base: _raise(base, int(node.exp))), (node.base,)
    return plan_function(node, _RULES)


def _raise(base: Series, exponent: int) -> Series:
    return base**exponent if exponent > 0 else 1 / base**-exponent


def _number(number: sp.Rational) -> fmpq:
    return fmpq(int(number.p), int(number.q))


_RULES: Rules = MappingProxyType(
    {
        sp.Mul: lambda *factors: reduce(mul, factors),
        sp.Pow: lambda base, exponent: (exponent * base.log()).exp(),
        sp.sinc: lambda a: fmpq_series([*map(_number, list_sinc(ORDER))])(a),
    }
)
