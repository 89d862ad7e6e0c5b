"""Rung: an inequality of integrals by the sign of what is integrated.

A number added to integrals over one finite interval is the integral of a constant: A is at most
the integral of f from a to b if A/(b - a) is at most f in between. The integrand has to be
continuous up to both ends, so that the integral exists.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from mechproof.proof.continuity import find_break
from mechproof.proof.coordinates import parametrise
from mechproof.proof.growth import find_limit
from mechproof.proof.integrals import list_free
from mechproof.proof.signs import is_shown
from mechproof.record import Slack
from mechproof.record.parts import has_parts
from mechproof.statement_domains.domain import Domain

RUNG = "sign of the integrand"


def holds_by_integrand(slack: Slack, domain: Domain, show: Callable[[Slack, Domain], bool]) -> bool:
    """Return whether `show` proves a number with integrals positive, or non-negative if allowed."""
    value = domain.resolve(slack.value)
    moduli = sorted((m for m in value.atoms(sp.Abs) if has_parts(m, sp.Integral)), key=str)
    if not moduli:
        return _is_shown(value, slack.strict, domain, show)
    # With a negative factor, c*|u| is the lesser of c*u and -c*u: both have to be checked.
    (modulus, *others), size = moduli, sp.Dummy("size", nonnegative=True)
    factor = sp.expand(value.xreplace({modulus: size})).coeff(size)
    if others or not is_shown(Slack(-factor, False), domain):
        return False
    sides = (value.xreplace({modulus: sign * modulus.args[0]}) for sign in (1, -1))
    return all(_is_shown(side, slack.strict, domain, show) for side in sides)


def _is_shown(
    value: sp.Expr, strict: bool, domain: Domain, show: Callable[[Slack, Domain], bool]
) -> bool:
    integrals = list_free(value)
    limits = {integral.limits[0][1:] for integral in integrals}
    if len(limits) != 1 or any(len(integral.limits) > 1 for integral in integrals):
        return False
    lower, upper = limits.pop()
    names = {integral: sp.Dummy("integral") for integral in integrals}
    named = sp.expand(value.xreplace(names))
    factors = {integral: named.coeff(name) for integral, name in names.items()}
    rest = sp.expand(named - sum(factors[integral] * name for integral, name in names.items()))
    length = upper - lower
    if named.has(sp.Abs) or any(part.has(*names.values()) for part in (rest, *factors.values())):
        return False
    rate = sp.cancel(rest / length)
    # If the limits may coincide the integral is zero there, and so must be the other side.
    may_meet = not strict and sp.denom(sp.together(rate)).is_number
    if length.is_infinite or not is_shown(Slack(length, not may_meet), domain):
        return False
    variable = sp.Dummy("x", real=True)
    place, run = parametrise(variable, lower, upper)
    moved = [
        factor * integral.function.subs(integral.variables[0], place)
        for integral, factor in factors.items()
    ]
    inside = domain.with_set(variable, run.interior)
    if not all(_has_integral(part, variable, run, inside) for part in moved):
        return False
    return show(Slack(rate + sp.Add(*moved), strict), inside)


def _has_integral(f: sp.Expr, x: sp.Symbol, run: sp.Interval, inside: Domain) -> bool:
    """Return whether a function is shown to be continuous, with limits at both ends."""
    if find_break(f, x, inside.with_set(x, run)) is None:
        return True
    if find_break(f, x, inside) is not None:
        return False
    limits = [find_limit(f, x, e, side, inside) for e, side in ((run.start, 1), (run.end, -1))]
    return all(limit is not None and limit.is_finite for limit in limits)
