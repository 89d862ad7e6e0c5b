"""Sizes whose squares, and products of few squares, stay within the doubles."""

import sympy as sp

POWER = 50
LARGEST = sp.Integer(10) ** POWER


def is_moderate(size: sp.Expr) -> sp.Basic:
    """State that a size is neither vast nor tiny."""
    return sp.And(size >= 1 / LARGEST, size <= LARGEST)


def is_zero_or_moderate(number: sp.Expr) -> sp.Basic:
    """State that a number of either sign is zero or its size is moderate."""
    return sp.Or(sp.Eq(number, 0), is_moderate(sp.Abs(number)))
