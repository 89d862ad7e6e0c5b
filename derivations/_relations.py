"""Statements of several parts, and relations of numbers, which SymPy is kept from deciding."""

from sympy import Expr, Le, Lt

from mechproof.record import Conjunction, Holds, Statement


def all_of(*parts: Statement) -> Conjunction:
    """State that every part is true."""
    return Conjunction(parts)


def less(left: Expr, right: Expr) -> Holds:
    """State left < right."""
    return Holds(Lt(left, right, evaluate=False))


def not_above(left: Expr, right: Expr) -> Holds:
    """State left <= right."""
    return Holds(Le(left, right, evaluate=False))
