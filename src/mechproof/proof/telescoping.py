"""Rung: a sum whose terms contain n, by a pair of Wilf and Zeilberger (1990).

With the term F(n, k), F(n + 1, k) - g(n)*F(n, k) is shown to equal G(n, k + 1) - G(n, k), G = R*F
with a fraction R. An ansatz for R and the growth g are solved for, as in Zeilberger's algorithm
(1991). What counts is that the identity of fractions holds; that, over the range of k, R and g have
no pole and no factorial in a numerator is that of a negative number; and that the value begins and
grows as the sum does, remainders at the ends included. In a denominator, a factorial of a negative
number makes a term zero, also as a limit.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.counts import find_first, untie
from mechproof.proof.powers import is_analytic, split_powers
from mechproof.proof.signs import is_nonzero
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare

# Work limits: factorials in a term, and coefficients of P beyond the degree of the factor.
_MOST_FACTORIALS = 6
_MOST_UNKNOWN = 4
# Work limit: terms before this index may all be zero.
_LATEST = 4
RUNG = "Wilf-Zeilberger pair"


class _Claim(NamedTuple):
    """The claim that the sum of a term over k, from `first` to n, equals `value` for all n."""

    term: sp.Expr
    k: sp.Symbol
    first: int
    n: sp.Symbol
    value: sp.Expr


def decide_by_telescoping(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right gives the value of one sum to n with n in it, else None."""
    claim = _read(domain.resolve(left - right))
    if claim is None or _count_factorials(claim.term) > _MOST_FACTORIALS:
        return None
    return RUNG if _has_factorials(claim) and _has_value(claim, domain) else None


def _read(difference: sp.Expr) -> _Claim | None:
    """Solve a difference that is zero for its only sum; None if it has no such sum."""
    sums = difference.atoms(sp.Sum)
    if len(sums) != 1 or difference.has(sp.Indexed, sp.Integral):
        return None
    (total,) = sums
    (index, first, n), *others = total.limits
    is_count = n.is_Symbol and n.is_positive and n.is_integer
    is_near = first.is_Integer and 0 <= first < _LATEST
    if others or not is_near or not is_count or not total.function.has(n):
        return None
    named = sp.Dummy("sum")
    difference = sp.expand(difference.xreplace({total: named}))
    scale = difference.coeff(named)
    if scale == 0 or scale.has(index, n) or not is_analytic(scale):
        return None
    value = sp.expand(-(difference - scale * named) / scale)
    # Leading zero terms are skipped: terms are divided by each other.
    numbers = range(int(first), _LATEST)
    begin = next((k for k in numbers if total.function.subs(index, k) != 0), _LATEST)
    sign = {"positive": True} if begin else {"nonnegative": True}
    k = sp.Dummy("k", integer=True, **sign)
    claim = _Claim(total.function.xreplace({index: k}), k, begin, n, value)
    return None if value.has(named) else claim


def _has_factorials(claim: _Claim) -> bool:
    """Return whether no factorial in a numerator is that of a negative number."""
    counts = _count_on(claim)
    above, _ = sp.fraction(claim.term)
    numbers = [factorial.args[0] for factorial in above.atoms(sp.factorial)]
    written = (x.subs(counts, simultaneous=True) if x.has(claim.k) else x for x in numbers)
    return all(sp.expand(number).is_nonnegative for number in written)


def _count_on(claim: _Claim) -> dict[sp.Symbol, sp.Expr]:
    """Return k as `first` plus a count, and n as k plus a count."""
    gap, above = (sp.Dummy(name, integer=True, nonnegative=True) for name in ("gap", "above"))
    return {claim.n: claim.first + above + gap, claim.k: claim.first + above}


def _count_factorials(term: sp.Expr) -> int:
    """Count factorials, each as often as its power says."""
    parts = (factor.as_base_exp() for factor in sp.Mul.make_args(term))
    inside = ((len(base.atoms(sp.factorial)), power) for base, power in parts)
    return sum(number * abs(int(power)) for number, power in inside if number and power.is_Integer)


def _has_value(claim: _Claim, domain: Domain) -> bool:
    """Return whether a claim holds for the first n, and for n + 1 if for n."""
    term, k, lower, n, value = claim
    if (first := find_first(n, domain)) is None:
        return False
    start = max(first, lower)
    if not all(_holds_at(claim, number, domain) for number in range(int(first), start + 1)):
        return False
    domain, following = untie(n, domain), term.subs(n, n + 1)
    change, growth = (reduce_quotient(x / term) for x in (following, term.subs(k, k + 1)))
    found = change and growth and _solve(change, growth, _find_polynomial(term, k), k)
    if not found:
        return False
    # The sum grows by the factor `rate`; the rest of the change has to telescope.
    rate, part = found
    step = change - rate
    if not all(_has_no_pole(f, claim, start, domain) for f in (part, step, rate)):
        return False
    if decide_equal(part.subs(k, k + 1) * growth - part, step, domain) is None:
        return False
    ends = (part * term).subs(k, n) - (part * term).subs(k, lower)
    rest = (step * term).subs(k, n) + following.subs(k, n + 1)
    return _is_zero(ends + rest + rate * value - value.subs(n, n + 1), domain)


def _holds_at(claim: _Claim, number: int, domain: Domain) -> bool:
    """Return whether a claim holds for one n; a sum that ends before it begins is zero."""
    term, k, lower, n, value = claim
    total = sp.Sum(term, (k, lower, n)) if number >= lower else sp.S.Zero
    sides = (substitute(side, {n: sp.Integer(number)}) for side in (total, value))
    return _is_zero(sp.Add(write_out(next(sides)), -next(sides)), domain)


def _has_no_pole(fraction: sp.Expr, claim: _Claim, start: int, domain: Domain) -> bool:
    """Return whether a fraction has no pole for any n from `start` on and any k up to n."""
    counts = _count_on(claim)
    later = {claim.n: start + sp.Dummy("gap", integer=True, nonnegative=True)}
    _, below = sp.fraction(sp.factor(fraction))
    return all(
        is_nonzero_below(1 / factor, counts if factor.has(claim.k) else later, domain)
        for factor in sp.Mul.make_args(below)
    )


def reduce_quotient(quotient: sp.Expr) -> sp.Expr | None:
    """Return a quotient of like terms as a fraction, or None if it does not reduce to one."""
    written = sp.combsimp(sp.powsimp(quotient))
    written = sp.cancel(sp.together(split_powers(prepare(written))))
    is_fraction = written.is_rational_function(*written.free_symbols)
    # A new symbol for a power would not change when its exponent takes a step.
    return written if is_fraction and written.free_symbols <= quotient.free_symbols else None


def _find_polynomial(term: sp.Expr, k: sp.Symbol) -> sp.Expr:
    """Return the factors of a term that are polynomials in k."""
    return sp.Mul(*(f for f in sp.Mul.make_args(term) if f.has(k) and f.is_polynomial(k)))


def _solve(
    change: sp.Expr, growth: sp.Expr, factor: sp.Expr, k: sp.Symbol
) -> tuple[sp.Expr, sp.Expr] | None:
    """Solve for a rate and for R = v(k - 1)*P/(f*w), where P is an unknown polynomial.

    f is the polynomial factor of the term; v and w are the denominators of the growth of the rest
    and of the change. This is faster than Gosper's algorithm if factors are squares.
    """
    rest = sp.cancel(growth * factor / factor.subs(k, k + 1))
    form = sp.denom(rest).subs(k, k - 1) / (factor * sp.denom(change))
    count = _MOST_UNKNOWN + sp.degree(factor, k)
    rate, *unknown = sp.symbols(f"c:{count + 1}", cls=sp.Dummy)
    form *= sp.Add(*(c * k**power for power, c in enumerate(unknown)))
    # The identity is linear in the unknowns: each power of k in its numerator gives one equation.
    left = sp.numer(sp.together(form.subs(k, k + 1) * growth - form - change + rate))
    found = next(iter(sp.linsolve(sp.Poly(left, k).coeffs(), [rate, *unknown])), None)
    if found is None:
        return None
    values = dict(zip([rate, *unknown], found, strict=True))
    free = dict.fromkeys(values, 0)
    return rate.xreplace(values).subs(free), form.xreplace(values).subs(free)


def is_nonzero_below(fraction: sp.Expr, counts: dict[sp.Symbol, sp.Expr], domain: Domain) -> bool:
    """Return whether a fraction has no pole for any of the counts."""
    _, below = sp.fraction(sp.together(fraction))
    written = below.xreplace(counts)
    whole = {s for s in {*counts, *written.free_symbols} if s.is_integer and s.is_nonnegative}
    naturals = {s: sp.S.Naturals if s.is_positive else sp.S.Naturals0 for s in whole}
    return is_nonzero(written, replace(domain, within={**domain.within, **naturals}))


def _is_zero(value: sp.Expr, domain: Domain) -> bool:
    return decide_equal(split_powers(prepare(value)), sp.S.Zero, domain) is not None
