"""Rung: a sum whose terms hold n, by a pair of Wilf and Zeilberger (1990).

With F(n, k) the term and g(n) the growth of the value, F(n + 1, k) - g(n)*F(n, k) is shown to be
G(n, k + 1) - G(n, k), G = R*F with a fraction R. A form of R is solved for; what counts is that
the identity holds as one of fractions, that R has no pole and no factorial is one of a negative
number where k runs, and that what is left at the ends vanishes. Zeilberger's algorithm
(1991) finds a recurrence as well; here the print gives the value, and with it the growth.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.powers import is_analytic, split_powers
from mechproof.proof.signs import is_nonzero
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare

# Work limits: factorials in a term, and coefficients of a polynomial beside those of a factor.
_MOST_FACTORIALS = 6
_MOST_UNKNOWN = 4
RUNG = "Wilf-Zeilberger pair"


class _Claim(NamedTuple):
    """The sum of a term over k, from a first number to n, is the value for all n."""

    term: sp.Expr
    k: sp.Symbol
    first: int
    n: sp.Symbol
    value: sp.Expr


def decide_by_telescoping(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right says what one sum to n of terms with n is, else None."""
    claim = _read(domain.resolve(left - right))
    if claim is None or _count_factorials(claim.term) > _MOST_FACTORIALS:
        return None
    return RUNG if _has_factorials(claim) and _has_value(claim, domain) else None


def _read(difference: sp.Expr) -> _Claim | None:
    """Solve a difference that is zero for the one sum in it."""
    sums = difference.atoms(sp.Sum)
    if len(sums) != 1 or difference.has(sp.Indexed, sp.Integral):
        return None
    (total,) = sums
    (index, first, n), *others = total.limits
    is_count = n.is_Symbol and n.is_positive and n.is_integer
    if others or first not in (0, 1) or not is_count or not total.function.has(n):
        return None
    named = sp.Dummy("sum")
    difference = sp.expand(difference.xreplace({total: named}))
    scale = difference.coeff(named)
    if scale == 0 or scale.has(index, n) or not is_analytic(scale):
        return None
    value = sp.expand(-(difference - scale * named) / scale)
    # A first term that is zero would be a pole where the terms are divided by it.
    begin = 1 if total.function.subs(index, 0) == 0 else int(first)
    sign = {"positive": True} if begin else {"nonnegative": True}
    k = sp.Dummy("k", integer=True, **sign)
    claim = _Claim(total.function.xreplace({index: k}), k, begin, n, value)
    return None if value.has(named) else claim


def _has_factorials(claim: _Claim) -> bool:
    """Tell whether no factorial of a term is one of a negative number."""
    gap, above = (sp.Dummy(name, integer=True, nonnegative=True) for name in ("gap", "above"))
    counts = {claim.n: claim.first + above + gap, claim.k: claim.first + above}
    numbers = [factorial.args[0] for factorial in claim.term.atoms(sp.factorial)]
    written = (x.subs(counts, simultaneous=True) if x.has(claim.k) else x for x in numbers)
    return all(sp.expand(number).is_nonnegative for number in written)


def _count_factorials(term: sp.Expr) -> int:
    """Count factorials with their powers."""
    parts = (factor.as_base_exp() for factor in sp.Mul.make_args(term))
    inside = ((len(base.atoms(sp.factorial)), power) for base, power in parts)
    return sum(number * abs(int(power)) for number, power in inside if number and power.is_Integer)


def _has_value(claim: _Claim, domain: Domain) -> bool:
    """Tell whether a claim holds for n = 1 and, if for n, for n + 1."""
    term, k, lower, n, value = claim
    begun = write_out(substitute(sp.Sum(term, (k, lower, n)), {n: sp.S.One}))
    if not _is_zero(begun - value.subs(n, 1), domain):
        return False
    following = term.subs(n, n + 1)
    change = reduce_quotient(following / term)
    growth = sp.S.Zero if value == 0 else reduce_quotient(value.subs(n, n + 1) / value)
    if change is None or growth is None or not is_nonzero_below(growth, {n: n}, domain):
        return False
    # The value is multiplied by its growth; what the sum is beyond that must vanish.
    step = sp.cancel(sp.together(change - growth))
    part = _find_part(step, term, k, domain)
    gap = sp.Dummy("gap", integer=True, nonnegative=True)
    if part is None or not all(is_nonzero_below(f, {n: k + gap}, domain) for f in (part, step)):
        return False
    ends = (part * term).subs(k, n) - (part * term).subs(k, lower)
    rest = (step * term).subs(k, n) + following.subs(k, n + 1)
    return _is_zero(ends + rest, domain)


def reduce_quotient(quotient: sp.Expr) -> sp.Expr | None:
    """Return a quotient of like terms as a fraction, None where something else is left."""
    written = sp.combsimp(sp.powsimp(quotient))
    written = sp.cancel(sp.together(split_powers(prepare(written))))
    is_fraction = written.is_rational_function(*written.free_symbols)
    # What stands for a power would not follow a step of its exponent.
    return written if is_fraction and written.free_symbols <= quotient.free_symbols else None


def _find_part(step: sp.Expr, term: sp.Expr, k: sp.Symbol, domain: Domain) -> sp.Expr | None:
    """Return R for which step*term is shown to be the difference of R*term, None for none."""
    growth = reduce_quotient(term.subs(k, k + 1) / term)
    part = None if growth is None else _solve(step, growth, _find_polynomial(term, k), k)
    if growth is None or part is None:
        return None
    return part if decide_equal(part.subs(k, k + 1) * growth - part, step, domain) else None


def _find_polynomial(term: sp.Expr, k: sp.Symbol) -> sp.Expr:
    """Return the factors of a term that are polynomials in k."""
    return sp.Mul(*(f for f in sp.Mul.make_args(term) if f.has(k) and f.is_polynomial(k)))


def _solve(step: sp.Expr, growth: sp.Expr, factor: sp.Expr, k: sp.Symbol) -> sp.Expr | None:
    """Solve for R = v(k - 1)*P/(f*w), P a polynomial, f the factor of the term that is one.

    v and w are what the growth of the rest and the step are divided by. That is faster than
    Gosper's algorithm where factors are squares.
    """
    rest = sp.cancel(growth * factor / factor.subs(k, k + 1))
    form = sp.denom(rest).subs(k, k - 1) / (factor * sp.denom(step))
    count = _MOST_UNKNOWN + sp.degree(factor, k)
    unknown = sp.symbols(f"c:{count}", cls=sp.Dummy)
    form *= sp.Add(*(c * k**power for power, c in enumerate(unknown)))
    # The unknowns stand in the identity linearly: its numerator gives one equation for each power
    # of k.
    left = sp.numer(sp.together(form.subs(k, k + 1) * growth - form - step))
    found = next(iter(sp.linsolve(sp.Poly(left, k).coeffs(), unknown)), None)
    values = {} if found is None else dict(zip(unknown, found, strict=True))
    return form.xreplace(values).subs(dict.fromkeys(unknown, 0)) if values else None


def is_nonzero_below(fraction: sp.Expr, counts: dict[sp.Symbol, sp.Expr], domain: Domain) -> bool:
    """Tell whether a fraction has no pole for any of the counts."""
    _, below = sp.fraction(sp.together(fraction))
    written = below.xreplace(counts)
    whole = {s for s in {*counts, *written.free_symbols} if s.is_integer and s.is_nonnegative}
    naturals = {s: sp.S.Naturals if s.is_positive else sp.S.Naturals0 for s in whole}
    return is_nonzero(written, replace(domain, within={**domain.within, **naturals}))


def _is_zero(value: sp.Expr, domain: Domain) -> bool:
    return decide_equal(split_powers(prepare(value)), sp.S.Zero, domain) is not None
