"""Find where an expression may be discontinuous in one variable, and a rung that relies on it.

The rung: equal derivatives, equal constants, and both sides continuous over the whole domain. A
formula with arctangents or integrals that differentiates correctly can still jump (Jeffrey 1993, on
results of computer algebra by tan(x/2)), so continuity is proved before the constant is trusted.
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.half_angles import find_sign_there, is_shown_there
from mechproof.proof.signs import is_positive, is_within_quarter_turn
from mechproof.record import Slack, list_needs
from mechproof.record.parts import INVERSES, differentiate
from mechproof.statement_domains.domain import Domain

_POLES = 4
_EVERYWHERE = (
    *(sp.sin, sp.cos, sp.atan, sp.exp, sp.Abs, sp.Max, sp.Min, sp.erf, sp.erfc, sp.Si),
    *(sp.sinh, sp.cosh, sp.tanh, sp.asinh),
)
_WHERE_DEFINED = (sp.log, sp.asin, sp.acos, sp.atanh, sp.acosh)


def find_break(expression: sp.Basic, variable: sp.Symbol, domain: Domain) -> sp.Basic | None:
    """Return a subexpression not shown to be continuous on the domain, or None if all are."""
    if variable not in expression.free_symbols:
        return None
    if isinstance(expression, sp.Integral):
        return _find_break_of_integral(expression, variable, domain)
    for argument in expression.args:
        found = find_break(argument, variable, domain)
        if found is not None:
            return found
    return None if _is_continuous_node(expression, domain) else expression


def has_pole(node: sp.Basic, variable: sp.Symbol, domain: Domain) -> bool:
    """Return whether a tangent of a linear argument has a pole inside the variable's set."""
    if not isinstance(node, sp.tan):
        return False
    slope = sp.diff(node.args[0], variable)
    if slope.has(variable) or not (is_positive(slope, domain) or is_positive(-slope, domain)):
        return False
    start = node.args[0].xreplace({variable: sp.S.Zero})
    poles = ((sp.pi * (2 * k + 1) / 2 - start) / slope for k in range(-_POLES, _POLES))
    inside = domain.set_of(variable).interior
    return inside == sp.S.Reals or any(inside.contains(pole) == sp.true for pole in poles)


def _is_continuous_node(node: sp.Basic, domain: Domain) -> bool:
    if node.is_Symbol or isinstance(node, (sp.Add, sp.Mul, *_EVERYWHERE)):
        return True
    if isinstance(node, sp.Pow) and node.exp.is_integer:
        sign = None if node.exp.is_nonnegative else find_sign_there(node.base, domain)
        return bool(node.exp.is_nonnegative) or (sign is not None and sign.strict)
    if isinstance(node, sp.tan):
        return is_within_quarter_turn(node.args[0], domain)
    if isinstance(node, sp.atan2):
        return is_shown_there(Slack(node.args[1], True), domain)
    if isinstance(node, _WHERE_DEFINED) or (isinstance(node, sp.Pow) and node.exp.is_Rational):
        return all(is_shown_there(need, domain) for need in list_needs(node))
    return isinstance(node, sp.Pow) and is_shown_there(Slack(node.base, True), domain)


def _find_break_of_integral(
    node: sp.Integral, variable: sp.Symbol, domain: Domain
) -> sp.Basic | None:
    """Return a limit, or a part of the integrand between the limits, not shown continuous."""
    for bound, *limits in node.limits:
        for limit in limits:
            found = find_break(limit, variable, domain)
            if found is not None:
                return found
        between = domain.with_set(bound, _range_between(limits, domain))
        for moving in (bound, variable):
            found = find_break(node.function, moving, between)
            if found is not None:
                return found
    return None


def _range_between(limits: list[sp.Expr], domain: Domain) -> sp.Set:
    """Return the range of an integral's variable; from 0 to a symbol, that symbol's interval."""
    lower, upper = limits
    where = domain.set_of(upper) if upper.is_Symbol else sp.S.Reals
    return where if lower == 0 and where.contains(0) == sp.true else sp.S.Reals


RUNG = "derivative, constant, continuity"
_TRANSCENDENTAL = (*INVERSES, sp.atan2, sp.log, sp.Integral)
_CANDIDATES = 2


def decide_by_derivative(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right is proved by the derivative in some variable, else None."""
    left, right = domain.resolve(left), domain.resolve(right)
    for variable in _variables(left - right, domain):
        if _agrees(left, right, variable, domain):
            return RUNG
    return None


def explain_break(expression: sp.Expr, domain: Domain, *, is_shown: bool = False) -> str:
    """Name a subexpression that is, or may be, discontinuous; "" if all are continuous.

    With `is_shown`, only one that is certainly discontinuous is named.
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
    """Return the candidates: symbols of limits or arguments, those with the widest sets first."""
    limits = {s for i in expression.atoms(sp.Integral) for s in i.limits[0][2].free_symbols}
    nodes = expression.atoms(*_TRANSCENDENTAL)
    symbols = limits or {s for node in nodes for s in node.free_symbols}
    coupled = {s for relation in domain.where for s in relation.free_symbols}
    connected = [s for s in symbols - coupled if isinstance(domain.set_of(s), sp.Interval)]
    return sorted(connected, key=lambda s: (_rank(domain.set_of(s)), str(s)))[:_CANDIDATES]


def _rank(where: sp.Interval) -> int:
    """Rank the whole line first, then sets with zero inside them, then others."""
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
    """Substitute a value; an integral between equal limits becomes zero."""
    result = expression.subs(variable, value)
    empty = [i for i in result.atoms(sp.Integral) if i.limits[0][1] == i.limits[0][2]]
    return result.subs(dict.fromkeys(empty, sp.Integer(0)))
