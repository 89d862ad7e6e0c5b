"""Rung: equal derivatives, equal constants, and both sides continuous over the whole domain.

Needed where arctangents or integrals stand: a formula that differentiates correctly can
still jump (Jeffrey 1993, of what computer algebra finds by tan(x/2)), so continuity is proved
before the constant is believed.
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break, has_pole
from mechproof.record.symbolic_slopes import differentiate
from mechproof.statement_domains.domain import Domain

RUNG = "derivative, constant, continuity"
_TRANSCENDENTAL = (
    *(sp.Integral, sp.atan, sp.atan2, sp.asin, sp.acos, sp.log),
    *(sp.asinh, sp.acosh, sp.atanh),
)
_CANDIDATES = 2


def decide_by_derivative(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right is proved by some variable, else None."""
    left, right = domain.resolve(left), domain.resolve(right)
    for variable in _variables(left - right, domain):
        if _agrees(left, right, variable, domain):
            return RUNG
    return None


def explain_break(expression: sp.Expr, domain: Domain, *, is_shown: bool = False) -> str:
    """Say which subexpression is not continuous or was not shown to be, empty if all are.

    With `is_shown` only what is not continuous is told.
    """
    expression = domain.resolve(expression)
    for variable in _variables(expression, domain):
        found = find_break(expression, variable, domain)
        if found is None:
            continue
        if has_pole(found, variable, domain):
            return f"{found} is not continuous in {variable} over the domain"
        if not is_shown:
            return f"{found} was not shown to be continuous in {variable} over the domain"
    return ""


def _variables(expression: sp.Expr, domain: Domain) -> list[sp.Symbol]:
    """Return the candidates: symbols of limits or arguments, unrestricted ones first."""
    limits = {s for i in expression.atoms(sp.Integral) for s in i.limits[0][2].free_symbols}
    nodes = expression.atoms(*_TRANSCENDENTAL)
    symbols = limits or {s for node in nodes for s in node.free_symbols}
    coupled = {s for relation in domain.where for s in relation.free_symbols}
    connected = [s for s in symbols - coupled if isinstance(domain.set_of(s), sp.Interval)]
    return sorted(connected, key=lambda s: (_rank(domain.set_of(s)), str(s)))[:_CANDIDATES]


def _rank(where: sp.Interval) -> int:
    """Put running variables first: the whole line, then what lies on both sides of zero."""
    if where == sp.S.Reals:
        return 0
    return 1 if where.contains(0) == sp.true and where.start != 0 else 2


def _agrees(left: sp.Expr, right: sp.Expr, variable: sp.Symbol, domain: Domain) -> bool:
    start = _base_point(domain.set_of(variable))
    slope = differentiate(left - right, variable)
    return (
        decide_equal(slope, sp.Integer(0), domain) is not None
        and decide_equal(_at(left, variable, start), _at(right, variable, start), domain)
        is not None
        and find_break(left, variable, domain) is None
        and find_break(right, variable, domain) is None
    )


def _base_point(where: sp.Interval) -> sp.Expr:
    if where.contains(0) == sp.true:
        return sp.Integer(0)
    if where.start.is_finite and not where.left_open:
        return where.start
    if where.end.is_finite and not where.right_open:
        return where.end
    if where.start.is_finite and where.end.is_finite:
        return (where.start + where.end) / 2
    return where.start + 1 if where.start.is_finite else where.end - 1


def _at(expression: sp.Expr, variable: sp.Symbol, value: sp.Expr) -> sp.Expr:
    """Substitute; an integral between equal limits is zero."""
    result = expression.subs(variable, value)
    empty = [i for i in result.atoms(sp.Integral) if i.limits[0][1] == i.limits[0][2]]
    return result.subs(dict.fromkeys(empty, sp.Integer(0)))
