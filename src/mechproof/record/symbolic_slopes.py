"""Slopes: the derivative of an expression as SymPy has it, each part of it differentiated once."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from mechproof.record.parts import find_free


# Derivatives of a formula by its letters, and of what is made of it, have most parts in common.
@lru_cache(maxsize=1 << 14)
def differentiate(node: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """Return what `sympy.diff` does, which asks of each part anew whether it has the symbol."""
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
    return sp.diff(node, symbol)
