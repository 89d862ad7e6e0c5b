"""Antiderivatives by SymPy's rules of integration, and of fractions; nothing is proved here."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from sympy.integrals.manualintegrate import manualintegrate
from sympy.integrals.rationaltools import ratint, ratint_ratpart


def propose_by_rules(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate by SymPy's rules, which are those of integration by hand."""
    found = _close(manualintegrate(integrand, variable), sp.Integral(integrand, variable))
    if not found.has(sp.Integral):
        yield from list_pieces(found)


def _close(found: sp.Expr, whole: sp.Integral) -> sp.Expr:
    """Solve an integral by parts that has led back to itself: I = A + c*I."""
    around = sp.expand(found).coeff(whole)
    return (found - around * whole).expand() / (1 - around) if around not in (0, 1) else found


def propose_by_fractions(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a quotient of polynomials by its partial fractions, or its quadratic factors.

    The rational part of the integral needs no rules, which take long.
    """
    if not integrand.is_rational_function(variable):
        return
    if integrand.free_symbols == {variable}:
        yield ratint(integrand, variable, real=True)
    whole, rest = split_fraction(integrand, variable)
    for found in propose_by_rules(sp.apart(rest, variable), variable):
        yield whole + found


def split_fraction(fraction: sp.Expr, variable: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Return the rational part of an integral, and what is left to integrate (Horowitz 1971)."""
    above, below = sp.fraction(sp.cancel(fraction))
    whole, above = sp.div(above, below, variable)
    part, rest = ratint_ratpart(above, below, variable)
    return sp.Poly(whole, variable).integrate().as_expr() + part, rest


def list_pieces(candidate: sp.Expr) -> Iterator[sp.Expr]:
    """List SymPy's proposals for every case, such as one sign of a parameter and the other."""
    node = min(candidate.atoms(sp.Piecewise), key=sp.default_sort_key, default=None)
    if node is None:
        yield candidate
        return
    for value, _ in node.args:
        yield from list_pieces(candidate.xreplace({node: value}))
