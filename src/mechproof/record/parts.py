"""The distinct parts of an expression, the symbols free in it, and its slopes, part by part.

SymPy's own searches visit a part as often as it occurs, and start anew for each question.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from typing import Any

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

# Functions of angles, functions that give one, and expressions with more terms than they show.
TURNING = (sp.sin, sp.cos, sp.tan)
CIRCULAR = (*TURNING, sp.cot, sp.sec, sp.csc)
ARCS = (sp.asin, sp.acos, sp.atan)
ANGLES = (*ARCS, sp.atan2)
# For each inverse function, the function and the interval of the values.
INVERSES: Mapping[type[sp.Expr], tuple[type[sp.Expr], sp.Interval]] = {
    sp.asin: (sp.sin, sp.Interval(-sp.pi / 2, sp.pi / 2)),
    sp.acos: (sp.cos, sp.Interval(0, sp.pi)),
    sp.atan: (sp.tan, sp.Interval.open(-sp.pi / 2, sp.pi / 2)),
    sp.asinh: (sp.sinh, sp.Interval(-sp.oo, sp.oo)),
    sp.acosh: (sp.cosh, sp.Interval(0, sp.oo)),
    sp.atanh: (sp.tanh, sp.Interval(-sp.oo, sp.oo)),
}
ENDLESS = (sp.Integral, sp.Sum, sp.Product, sp.Limit)
# Functions that are differentiated by the chain rule.
_PLAIN = (*CIRCULAR, *ANGLES, sp.exp, sp.log)


# Statements are processed one after another, so that few expressions are in use at once.
@lru_cache(maxsize=256)
def list_parts(expression: sp.Basic) -> tuple[sp.Basic, ...]:
    """Return the expression and all expressions in it, each once."""
    found: dict[sp.Basic, None] = {}
    left = [expression]
    while left:
        node = left.pop()
        if node not in found:
            found[node] = None
            left += node.flat() if isinstance(node, sp.MatrixBase) else node.args
    return tuple(found)


def find_parts(expression: sp.Basic, *kinds: Any) -> set[Any]:
    """Return the parts of the given kinds."""
    return {part for part in list_parts(expression) if isinstance(part, kinds)}


def find_roots(expression: sp.Basic) -> set[Any]:
    """Return the square roots, and their odd powers."""
    powers = find_parts(expression, sp.Pow)
    return {power for power in powers if power.exp.is_Rational and power.exp.q == 2}


def has_parts(expression: sp.Basic, *kinds: Any) -> bool:
    """Return whether there are parts of the given kinds."""
    return any(isinstance(part, kinds) for part in list_parts(expression))


def replace_parts(expression: sp.Basic, values: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """Replace parts by values, like SymPy's `xreplace`, which rebuilds repeated parts each time."""
    known: dict[Any, Any] = dict(values)

    def visit(node: Any) -> Any:
        if not isinstance(node, sp.Basic):
            return node
        if node not in known:
            parts = [visit(part) for part in node.args]
            # An equal part is kept: rebuilt, a relation that is left unevaluated would be decided.
            is_kept = all(
                new is old or new == old for new, old in zip(parts, node.args, strict=True)
            )
            known[node] = node if is_kept else node.func(*parts)
        return known[node]

    if isinstance(expression, sp.MatrixBase):
        return expression.applyfunc(visit)
    return visit(expression)


# Cached for each part, because statements share their parts.
@lru_cache(maxsize=1 << 15)
def find_free(expression: sp.Basic) -> frozenset[sp.Basic]:
    """Return the free symbols, as SymPy's `free_symbols`."""
    if isinstance(expression, sp.MatrixBase):
        return frozenset[sp.Basic]().union(*map(find_free, expression.flat()))
    if not _has_those_of_its_parts(expression.__class__):
        return frozenset(expression.free_symbols)
    return frozenset[sp.Basic]().union(*map(find_free, expression.args))


@cache
def _has_those_of_its_parts(kind: type[sp.Basic]) -> bool:
    """Return whether a class has SymPy's default rule; some metaclasses hide the attribute."""
    rules = (vars(base)["free_symbols"] for base in kind.__mro__ if "free_symbols" in vars(base))
    return next(rules) is sp.Basic.free_symbols


def find_bound(expression: sp.Basic) -> set[sp.Symbol]:
    """Return the symbols that sums, products, integrals and limits bind."""
    nodes = find_parts(expression, ExprWithLimits, sp.Limit)
    return {
        symbol
        for node in nodes
        for symbol in ([node.args[1]] if isinstance(node, sp.Limit) else node.bound_symbols)
    }


# Cached, because derivatives of a formula by its letters have most of their parts in common.
@lru_cache(maxsize=1 << 14)
def differentiate(node: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """Return the same as `sympy.diff`, which searches every part anew for the symbol."""
    if symbol not in find_free(node):
        return sp.S.Zero
    if node.is_Add:
        return sp.Add(*(differentiate(term, symbol) for term in node.args))
    if node.is_Mul:
        slopes = [differentiate(factor, symbol) for factor in node.args]
        changed = [n for n, slope in enumerate(slopes) if slope]
        terms = ((*node.args[:n], slopes[n], *node.args[n + 1 :]) for n in changed)
        return sp.Add(*(sp.Mul(*factors) for factors in terms))
    if node.is_Pow and node.exp.is_Rational:
        return node * (differentiate(node.base, symbol) * node.exp / node.base)
    if isinstance(node, _PLAIN):
        inner = ((n, differentiate(part, symbol)) for n, part in enumerate(node.args, start=1))
        return sp.Add(*(node.fdiff(n) * slope for n, slope in inner if slope))
    return sp.diff(node, symbol)
