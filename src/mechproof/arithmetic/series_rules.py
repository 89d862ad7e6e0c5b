"""Series rules: what operations and functions of SymPy are of series, whatever their numbers.

They are the rules of Moore (1966) and of Griewank and Walther (2008, chapter 13), as flint has
them: what SymPy has by other functions is written by those.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add, methodcaller
from types import MappingProxyType
from typing import Any

import sympy as sp
from sympy.codegen.cfunctions import expm1, log1p

from mechproof.arithmetic.layout import Operation, Plan

Series = Any
Rules = Mapping[type[sp.Basic], Callable[..., Any]]
_RULES: Rules = MappingProxyType(
    {
        sp.Add: lambda *terms: reduce(add, terms),
        # Flint calls them as SymPy does.
        **{
            kind: methodcaller(kind.__name__)
            for kind in (sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.exp, sp.log)
        },
    }
)
# What SymPy writes by others.
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


def plan_function(node: sp.Basic, own: Rules) -> Plan:
    """Return what to do at a node and the nodes it needs first; `own` are rules of numbers.

    Raises `NotImplementedError` naming a function that has no series.
    """
    kind = type(node)
    if kind in _WRITTEN_BY:
        return apply(lambda value: value), (node.rewrite(_WRITTEN_BY[kind], deep=False),)
    method = own.get(kind) or _RULES.get(kind)
    if method is None:
        raise NotImplementedError(f"no series of {kind.__name__}")
    return apply(method), node.args


def apply(method: Callable[..., Any]) -> Operation:
    """Return a function of operands as an operation, which needs no symbols."""
    return lambda values, *operands: method(*operands)


def list_sinc(count: int) -> list[sp.Rational]:
    """List Taylor coefficients of sin(x)/x at zero."""
    signs = (sp.S.One, sp.S.Zero, -sp.S.One, sp.S.Zero)
    return [signs[k % 4] / sp.factorial(k + 1) for k in range(count)]
