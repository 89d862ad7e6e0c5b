"""Rung: an integral whose integrand contains a whole number n, from one n to the next by parts.

With the integrand f(n, x) and the growth g(n) of the value, f(n + 1, x) - g(n)*f(n, x) is the
derivative of R*f(n, x), R a polynomial in x and in the functions of x in f, and R*f has equal
limits at both ends (Almkvist, Zeilberger, The method of differentiating under the integral sign,
1990). R is solved for; what counts is that its identity is proved, that the integrand and R*f are
continuous between the limits, and that the value for the first n is shown.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations_with_replacement
from typing import NamedTuple

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.cases import Prove
from mechproof.proof.continuity import find_break
from mechproof.proof.coordinates import parametrise
from mechproof.proof.counts import find_first, untie
from mechproof.proof.growth import find_limit
from mechproof.proof.integral_kinds import is_improper
from mechproof.proof.powers import is_analytic
from mechproof.proof.signs import is_nonzero
from mechproof.proof.telescoping import is_nonzero_below, reduce_quotient
from mechproof.record import NthDerivative
from mechproof.record.parts import find_parts
from mechproof.record.relations import KINKED
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain

RUNG = "integration by parts to the next number"
DERIVATIVES = "derivative of the derivative"
# Work limits: the degree of R, and the number of x and its functions in an integrand.
_LARGEST_DEGREE = 3
_MOST_PARTS = 3


class _Claim(NamedTuple):
    """The claim that an integral, or a derivative of order n, equals `value` for all n."""

    integral: sp.Integral | NthDerivative
    value: sp.Expr
    n: sp.Symbol


class Settled(NamedTuple):
    """Both sides with an improper integral replaced by its value, and the rungs that prove it.

    Balls do not enclose such an integral for any n.
    """

    printed: sp.Expr
    rebuilt: sp.Expr
    rung: str


def settle_by_parts(left: sp.Expr, right: sp.Expr, domain: Domain, prove: Prove) -> Settled | None:
    """Put in the value that left = right gives for an improper integral with n, if proved."""
    integrals = {node for side in (left, right) for node in find_parts(side, sp.Integral)}
    if len(integrals) != 1 or not all(map(is_improper, integrals)):
        return None
    if (found := _find(left, right, domain, prove)) is None:
        return None
    claim, rung = found
    value = {claim.integral: claim.value}
    return Settled(left.xreplace(value), right.xreplace(value), rung)


def decide_by_parts(left: sp.Expr, right: sp.Expr, domain: Domain, prove: Prove) -> str | None:
    """Return the rungs if left = right gives the value of its only integral or derivative."""
    found = _find(left, right, domain, prove)
    return found[1] if found else None


def _find(left: sp.Expr, right: sp.Expr, domain: Domain, prove: Prove) -> tuple[_Claim, str] | None:
    for claim in _list_claims(domain.resolve(left - right), domain):
        for counted, part in _list_beginnings(claim, domain):
            integral, value, n = counted
            first = {n: find_first(n, part)}
            is_derivative = isinstance(integral, NthDerivative)
            if _derives(counted, part, prove) if is_derivative else _goes_on(counted, part):
                begun = prove(substitute(integral, first), substitute(value, first), part)
                if begun:
                    return claim, f"{DERIVATIVES if is_derivative else RUNG}, {begun}"
    return None


def _list_beginnings(claim: _Claim, domain: Domain) -> Iterator[tuple[_Claim, Domain]]:
    """Yield a claim with its domain, and also with n from 0 on if n begins with 1."""
    yield claim, domain
    integral, value, n = claim
    if find_first(n, domain) == 1:
        counted = sp.Symbol(n.name, integer=True, nonnegative=True)
        anew = {n: counted}
        from_zero = _Claim(integral.xreplace(anew), value.xreplace(anew), counted)
        yield from_zero, domain.with_set(counted, sp.S.Naturals0)


def _list_claims(difference: sp.Expr, domain: Domain) -> Sequence[_Claim]:
    """Solve a difference that is zero for its only integral or derivative; one claim for each n."""
    integrals = difference.atoms(sp.Integral, NthDerivative)
    if len(integrals) != 1 or difference.has(sp.Sum, sp.Product, *KINKED):
        return []
    (integral,) = integrals
    is_derivative = isinstance(integral, NthDerivative)
    (_, *ends), *others = [integral.args[:3]] if is_derivative else integral.limits
    named = sp.Dummy("integral")
    difference = sp.expand(difference.xreplace({integral: named}))
    scale = difference.coeff(named)
    value = sp.expand(-(difference - scale * named) / scale) if scale != 0 else named
    if others or len(ends) != 2 or value.has(named) or not is_analytic(scale):
        return []
    inside = integral.args[3 if is_derivative else 0]
    counts = [n for n in inside.free_symbols if find_first(n, domain) is not None]
    free = (n for n in counts if not scale.has(n) and not any(end.has(n) for end in ends))
    return [_Claim(integral, value, n) for n in sorted(free, key=str)]


def _derives(claim: _Claim, domain: Domain, prove: Prove) -> bool:
    """Return whether the derivative of order n + 1 follows from the one of order n.

    It must be a derivative near each place: nothing may bind x to a single place or to n.
    """
    (inside, by, x, order), value, n = claim.integral.args, *claim[1:]
    within = domain.set_of(x)
    is_wide = isinstance(within, sp.Interval) and within.measure > 0 and x.is_Symbol
    bound = [relation for relation in domain.where if relation.has(x)]
    is_wide &= all(isinstance(r, sp.Gt | sp.Lt | sp.Ne) and not r.has(n) for r in bound)
    domain, more = untie(n, domain), sp.diff(order, n)
    if not (is_wide and more.is_Integer and more > 0) or x.is_integer:
        return False
    if inside.has(n):
        # The function for n + 1, differentiated `more` times, may be a multiple of the one for n.
        factor = sp.powsimp(sp.diff(inside.subs(n, n + 1), (by, more)) / inside)
        following = value.subs(n, n + 1)
        return not factor.has(by) and prove(factor * value, following, domain) is not None
    return prove(sp.diff(value, (x, more)), value.subs(n, n + 1), domain) is not None


def _goes_on(claim: _Claim, domain: Domain) -> bool:
    """Return whether a claim holds for n + 1 if it does for n."""
    integral, value, n = claim
    domain = untie(n, domain)
    x, lower, upper = integral.limits[0]
    place, run = parametrise(x, lower, upper)
    inside, term = domain.with_set(x, run.interior), integral.function.subs(x, place)
    growth = reduce_quotient(value.subs(n, n + 1) / value) if value != 0 else sp.S.Zero
    if growth is None or not is_nonzero_below(growth, {n: n}, domain):
        return False
    # The growth from n to n + 1 and the logarithmic derivative of the integrand.
    logarithm = sp.expand_log(sp.log(term), force=True)
    step = sp.exp(sp.expand(logarithm.subs(n, n + 1) - logarithm)) - growth
    slope = sp.diff(logarithm, x)
    part = _solve(slope, step, x, inside)
    if part is None or not decide_equal(sp.diff(part, x) + part * slope, step, inside):
        return False
    if any(find_break(function, x, inside) is not None for function in (term, part * term)):
        return False
    sides = ((run.start, 1), (run.end, -1))
    low, high = (find_limit(part * term, x, end, side, domain) for end, side in sides)
    if low is None or high is None or low.is_infinite or high.is_infinite:
        return False
    return decide_equal(low, high, domain) is not None


def _solve(slope: sp.Expr, step: sp.Expr, x: sp.Symbol, domain: Domain) -> sp.Expr | None:
    """Return R with R' + R*slope = step, or None if none is found that always has a value."""
    functions = {f for f in (slope + step).atoms(sp.Function) if f.has(x)}
    waves = {f.args[0] for f in functions if isinstance(f, sp.sin | sp.cos)}
    functions |= {wave(angle) for angle in waves for wave in (sp.sin, sp.cos)}
    parts = [x, *sorted(functions, key=sp.default_sort_key)]
    if len(parts) > _MOST_PARTS:
        return None
    degrees = range(_LARGEST_DEGREE + 1)
    terms = [sp.Mul(*some) for d in degrees for some in combinations_with_replacement(parts, d)]
    unknown = [sp.Dummy() for _ in terms]
    form = sp.Add(*(c * term for c, term in zip(unknown, terms, strict=True)))
    names = {part: sp.Dummy() for part in reversed(parts)}
    left = (sp.diff(form, x) + form * slope - step).xreplace(names)
    if not left.is_rational_function(*names.values()):
        return None
    above = sp.Poly(sp.numer(sp.together(left)), *names.values())
    for angle in waves:
        circle = names[sp.sin(angle)] ** 2 + names[sp.cos(angle)] ** 2 - 1
        above = above.rem(sp.Poly(circle, *names.values()))
    found = next(iter(sp.linsolve(above.coeffs(), unknown)), None)
    if found is None:
        return None
    free = dict.fromkeys(unknown, 0)
    factors = [sp.cancel(one.subs(free)) for one in found]
    if not all(is_nonzero(sp.denom(factor), domain) for factor in factors):
        return None
    return sp.Add(*(factor * term for factor, term in zip(factors, terms, strict=True)))
