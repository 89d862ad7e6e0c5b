"""Exact series: in, an expression of one symbol; out, its Taylor coefficients at zero, rational."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add, methodcaller, mul
from types import MappingProxyType
from typing import Any

import sympy as sp
from flint import ctx, fmpq, fmpq_series
from sympy.codegen.cfunctions import expm1, log1p

# So many coefficients are carried: one fewer than in balls, which enclose the remainder.
ORDER = 63
Series = Any
_FUNCTIONS: Mapping[type[sp.Basic], Callable[[Series], Series]] = MappingProxyType(
    {
        # Flint calls them as SymPy does.
        **{
            kind: methodcaller(kind.__name__)
            for kind in (sp.sin, sp.cos, sp.tan, sp.exp, sp.log, sp.atan, sp.asin)
        },
        expm1: lambda a: a.exp() - 1,
        log1p: lambda a: (1 + a).log(),
    }
)


def expand_at_zero(expression: sp.Expr, symbol: sp.Symbol) -> list[sp.Rational] | None:
    """Return `ORDER` coefficients; None where there are none, or none that are rational."""
    length, ctx.cap = ctx.cap, ORDER
    try:
        found = _expand(expression, symbol).coeffs()
    except (ValueError, ZeroDivisionError, KeyError):
        return None
    finally:
        ctx.cap = length
    terms = [sp.Rational(int(c.p), int(c.q)) for c in found]
    return terms + [sp.S.Zero] * (ORDER - len(terms))


def _expand(node: sp.Basic, symbol: sp.Symbol) -> Series:
    if node == symbol:
        return fmpq_series([0, 1])
    if isinstance(node, sp.Rational):
        return fmpq_series([fmpq(int(node.p), int(node.q))])
    if isinstance(node, sp.Add | sp.Mul):
        parts = (_expand(part, symbol) for part in node.args)
        return reduce(add if node.is_Add else mul, parts)
    if isinstance(node, sp.Pow):
        return _raise(_expand(node.base, symbol), node.exp)
    return _FUNCTIONS[type(node)](*(_expand(part, symbol) for part in node.args))


def _raise(base: Series, exponent: sp.Expr) -> Series:
    if exponent.is_Integer:
        return base ** int(exponent) if exponent > 0 else 1 / base ** int(-exponent)
    if (2 * exponent).is_Integer:
        return _raise(base.sqrt(), 2 * exponent)
    raise ValueError(f"the power {exponent} of a series")
