"""Algebra common to several papers: linear equations, moderate sizes, the eps of doubles."""

import sympy as sp

EPS = sp.Rational(1, 2**52)
# Squares of such sizes, and products of few squares, stay within the doubles.
POWER = 50
LARGEST = sp.Integer(10) ** POWER


def is_moderate(size: sp.Expr) -> sp.Basic:
    """State that a size is neither vast nor tiny."""
    return sp.And(size >= 1 / LARGEST, size <= LARGEST)


def is_zero_or_moderate(number: sp.Expr) -> sp.Basic:
    """State that a number of either sign is zero or its size is moderate."""
    return sp.Or(sp.Eq(number, 0), is_moderate(sp.Abs(number)))


def solve_linear(equation: sp.Equality | sp.Expr, unknown: sp.Expr) -> sp.Expr:
    """Return the unknown, a symbol or a power of one; an expression is set to zero.

    `solve` would simplify and check the solution for longer than the rest of a paper takes to load.
    """
    gap = equation.lhs - equation.rhs if isinstance(equation, sp.Equality) else equation
    place = sp.Dummy("place")
    slope, offset = sp.Poly(gap.subs(unknown, place), place).all_coeffs()
    return sp.factor_terms(sp.cancel(-offset / slope))
