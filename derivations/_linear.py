"""Equations that are linear in one unknown, solved."""

import sympy as sp


def solve_linear(equation: sp.Equality | sp.Expr, unknown: sp.Expr) -> sp.Expr:
    """Return the unknown, a symbol or a power of one; an expression is to be zero.

    `solve` would simplify and check the solution for longer than the rest of a paper takes to load.
    """
    gap = equation.lhs - equation.rhs if isinstance(equation, sp.Equality) else equation
    place = sp.Dummy("place")
    slope, offset = sp.Poly(gap.subs(unknown, place), place).all_coeffs()
    return sp.factor_terms(sp.cancel(-offset / slope))
