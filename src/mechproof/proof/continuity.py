"""Where an expression may fail to be continuous in one variable: needed for antiderivatives."""

from __future__ import annotations

import sympy as sp

from mechproof.proof.half_angles import find_sign_there, is_shown_there
from mechproof.proof.signs import is_positive, is_within_quarter_turn
from mechproof.record import Slack, list_needs
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
    """Return whether a tangent of what is linear in the variable meets a pole within its set."""
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
    """Limits must be continuous, the integrand continuous wherever its variable runs."""
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
    """From 0 to a symbol, the variable stays in the symbol's interval if that contains 0."""
    lower, upper = limits
    where = domain.set_of(upper) if upper.is_Symbol else sp.S.Reals
    return where if lower == 0 and where.contains(0) == sp.true else sp.S.Reals
