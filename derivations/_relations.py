"""Statements of several parts, and numbers and their relations, which balls decide, not SymPy."""

from collections.abc import Mapping

from sympy import Basic, Expr, Le, Lt

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


def put_numbers(expression: Basic, values: Mapping[Basic, Basic]) -> Basic:
    """Put numbers for symbols and evaluate nothing.

    SymPy would spend seconds on the assumptions of what comes out; its context that keeps it from
    evaluating empties its cache, which costs more still.
    """
    known = dict(values)

    def put(part: Basic) -> Basic:
        if part not in known:
            parts = tuple(map(put, part.args))
            same = parts == part.args
            known[part] = part if same else part.func(*parts, evaluate=False)
        return known[part]

    return put(expression)
