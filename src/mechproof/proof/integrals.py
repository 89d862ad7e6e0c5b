"""Rung: a definite integral between numbers has the value that an antiderivative gives.

SymPy only proposes the antiderivative. It counts if its derivative is proved to be the integrand
inside the limits and both are continuous up to them: the fundamental theorem of calculus. One by
tan(x/2) jumps at odd multiples of pi; its arctangent is written without a jump (Jeffrey 1993).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace

import sympy as sp
from sympy.integrals.manualintegrate import manualintegrate
from sympy.polys.polyerrors import PolynomialError

from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break
from mechproof.proof.domain import Domain

RUNG = "antiderivative"
# Work limit: an integrand of more operations is not tried.
_LARGEST = 60
_TANGENT = sp.Dummy("t", real=True)


def decide_by_antiderivative(
    left: sp.Expr, right: sp.Expr, domain: Domain, prove: Callable[..., str | None]
) -> str | None:
    """Return the rungs if left = right is proved with the values of integrals, else None."""
    sides = (domain.resolve(left), domain.resolve(right))
    integrals = sorted({i for side in sides for i in side.atoms(sp.Integral)}, key=str)
    values = {integral: _find_value(integral, domain) for integral in integrals}
    known = {integral: value for integral, value in values.items() if value is not None}
    if not known:
        return None
    rest = prove(*(side.xreplace(known) for side in sides), domain)
    return f"{RUNG}, {rest}" if rest else None


def _find_value(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    integrand, (variable, *limits) = integral.function, integral.limits[0]
    are_numbers = len(limits) == 2 and all(x.is_number and x.is_finite for x in limits)
    if len(integral.limits) > 1 or not are_numbers or integrand.count_ops() > _LARGEST:
        return None
    lower, upper = limits
    if (lower < upper) != sp.true:
        return None
    closed = _run(domain, variable, sp.Interval(lower, upper))
    if find_break(integrand, variable, closed) is not None:
        return None
    within = _run(domain, variable, sp.Interval.open(lower, upper))
    for candidate in _propose(integrand, variable):
        if find_break(candidate, variable, closed) is None and decide_equal(
            sp.diff(candidate, variable), integrand, within
        ):
            return candidate.subs(variable, upper) - candidate.subs(variable, lower)
    return None


def _run(domain: Domain, variable: sp.Symbol, values: sp.Interval) -> Domain:
    where = tuple(r for r in domain.where if variable not in r.free_symbols)
    return replace(domain, within={**domain.within, variable: values}, where=where)


def _propose(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    found = manualintegrate(integrand, variable)
    if not found.has(sp.Integral):
        yield from _list_pieces(found)
    with suppress(PolynomialError, NotImplementedError):
        yield from _propose_by_half_angle(integrand, variable)


def _propose_by_half_angle(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate what is rational in the sine and cosine of the variable by t = tan(x/2)."""
    t = _TANGENT
    circle = {sp.sin(variable): 2 * t / (1 + t**2), sp.cos(variable): (1 - t**2) / (1 + t**2)}
    rational = sp.together(sp.expand_trig(integrand).xreplace(circle) * 2 / (1 + t**2))
    if rational.has(variable):
        return
    found = manualintegrate(sp.apart(sp.cancel(rational), t), t)
    if not found.has(sp.Integral):
        turned = found.replace(sp.atan, lambda slope: _turn(slope, variable))
        yield from _list_pieces(turned.subs(t, sp.tan(variable / 2)))


def _list_pieces(candidate: sp.Expr) -> Iterator[sp.Expr]:
    """List what SymPy proposes for one sign of a parameter and for the other."""
    node = min(candidate.atoms(sp.Piecewise), key=sp.default_sort_key, default=None)
    if node is None:
        yield candidate
        return
    for value, _ in node.args:
        yield from _list_pieces(candidate.xreplace({node: value}))


def _turn(slope: sp.Expr, variable: sp.Symbol) -> sp.Expr:
    """Write atan(a*t + b), t = tan(x/2), as x/2 and an angle that does not jump."""
    slope = sp.expand(slope)
    a, b = slope.coeff(_TANGENT, 1), slope.coeff(_TANGENT, 0)
    if slope != sp.expand(a * _TANGENT + b):
        return sp.atan(slope)
    sine, cosine = sp.sin(variable), sp.cos(variable)
    across = (a - 1) * sine + b * (1 + cosine)
    along = (1 + cosine) + a * (1 - cosine) + b * sine
    return variable / 2 + sp.atan(across / along)
