"""Limits of quotients of smooth functions: by continuity, or by derivatives where both vanish."""

from __future__ import annotations

import sympy as sp
from sympy.core.symbol import Str

from mechproof.proof.algebra import decide_equal
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.record import AnyFunction
from mechproof.statement_domains.domain import Domain

_MOST_DERIVATIVES = 9
_ENTIRE = (
    *(sp.Add, sp.Mul, sp.sin, sp.cos, sp.exp, sp.sinh, sp.cosh, sp.tanh, sp.atan, sp.asinh),
    *(sp.erf, sp.Si, AnyFunction, Str),
)


def find_smooth(
    body: sp.Expr, variable: sp.Symbol, point: sp.Expr, domain: Domain
) -> sp.Expr | None:
    """Return the limit of a quotient or power of functions smooth around a point, or None."""
    if point.is_infinite:
        # x tends to infinity as 1/x tends to zero.
        body, point = body.subs(variable, sp.sign(point) / variable), sp.S.Zero
    if isinstance(body, sp.Pow) and body.exp.has(variable):
        logarithm = find_smooth(body.exp * sp.log(body.base), variable, point, domain)
        is_met = logarithm is not None and is_positive(body.base.subs(variable, point), domain)
        return sp.exp(logarithm) if is_met else None
    above, below = sp.fraction(sp.together(body))
    for _ in range(_MOST_DERIVATIVES):
        if not all(_is_smooth(part, variable, point, domain) for part in (above, below)):
            return None
        top, bottom = (part.subs(variable, point) for part in (above, below))
        if is_nonzero(bottom, domain):
            return top / bottom
        if not all(decide_equal(part, sp.S.Zero, domain) for part in (top, bottom)):
            return None
        # By l'Hospital's rule: it needs a derivative of the denominator without zeros near the
        # point.
        above, below = (sp.diff(part, variable) for part in (above, below))
    return None


def _is_smooth(node: sp.Expr, variable: sp.Symbol, point: sp.Expr, domain: Domain) -> bool:
    """Return whether an expression is shown to have all derivatives around a point."""
    if variable not in node.free_symbols:
        return True
    if node == variable:
        return True
    if not all(_is_smooth(part, variable, point, domain) for part in node.args):
        return False
    if isinstance(node, _ENTIRE):
        return True
    base = node.args[0].subs(variable, point)
    if isinstance(node, sp.Pow) and node.exp.is_Integer:
        return node.exp >= 0 or is_nonzero(base, domain)
    if isinstance(node, sp.tan):
        return is_nonzero(sp.cos(base), domain)
    if isinstance(node, sp.asin | sp.acos | sp.atanh):
        return is_positive(1 - base**2, domain)
    return isinstance(node, sp.Pow | sp.log) and is_positive(base, domain)
