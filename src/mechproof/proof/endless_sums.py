"""Sums without end: the limit of the partial sums, where both are shown.

SymPy proposes the partial sum, by Gosper's algorithm (1978); that of a geometric series is known.
It counts if it begins and grows as the sum does, by induction, and has a limit. A sum is infinite
whose terms have values and are in the end no less than those of c/k or c/(k*ln k), c > 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import sympy as sp
from sympy.concrete.gosper import gosper_sum

from mechproof.proof.definedness import has_values
from mechproof.proof.growth import find_limit
from mechproof.proof.induction import decide_by_induction, sum_up
from mechproof.proof.signs import find_sign, is_positive
from mechproof.proof.telescoping import is_nonzero_below
from mechproof.record.parts import find_bound, find_parts
from mechproof.statement_domains.domain import Domain

RUNG = "limit of partial sums"
# Work limit: a term of more operations is not tried.
_LARGEST = 40
_N = sp.Dummy("n", integer=True, positive=True)
_ABOVE = sp.Dummy("above", integer=True, nonnegative=True)


def settle_endless(expression: Any, domain: Domain) -> Any:
    """Put the values of sums without end in their places, as far as they are shown."""
    return put_values(expression, partial(_find_value, domain))


def put_values(expression: Any, find: Callable[[sp.Sum], sp.Expr | None]) -> Any:
    """Put values in the places of sums that have no letters of others; none leaves a sum.

    Infinity is put for a sum that stands alone.
    """
    bound = set(find_bound(expression))
    sums = (s for s in find_parts(expression, sp.Sum, sp.Product) if not s.free_symbols & bound)
    values = ((node, find(node)) for node in sorted(sums, key=str))
    known = {node: value for node, value in values if value is not None}
    finite = {node: value for node, value in known.items() if not value.is_infinite}
    return known.get(expression, expression.xreplace(finite))


def read_endless(total: sp.Sum) -> tuple[sp.Expr, sp.Symbol, sp.Integer] | None:
    """Return the term, the index and its first number; nothing of a sum that is too large."""
    (k, first, last), *others = total.limits
    term = total.function
    is_read = not others and last == sp.oo and first.is_Integer and term.count_ops() <= _LARGEST
    return (term, k, first) if is_read else None


def _find_value(domain: Domain, total: sp.Sum) -> sp.Expr | None:
    if (read := read_endless(total)) is None:
        return None
    term, k, first = read
    if isinstance(total, sp.Product):
        partial = sum_up(sp.Product(term, (k, first, _N)), _N, domain)
        return None if partial.has(sp.Product) else _find_limit(partial, domain)
    if (endless := _find_infinity(term, k, first, domain)) is not None:
        return endless
    ratio = sp.powsimp(term.subs(k, k + 1) / term)
    if not ratio.has(k):
        return term.subs(k, first) / (1 - ratio) if is_positive(1 - ratio**2, domain) else None
    if not is_nonzero_below(term, {k: first + _ABOVE}, domain):
        return None
    partial_sum = sp.Sum(term, (k, first, _N))
    for value in _propose(partial_sum, domain):
        if decide_by_induction(partial_sum, value, domain):
            return _find_limit(value, domain)
    return None


def _propose(total: sp.Sum, domain: Domain) -> Iterator[sp.Expr]:
    """Propose a partial sum: by Gosper's algorithm, as logarithm of a product, as arctangents."""
    term, (k, first, last) = total.function, total.limits[0]
    if (found := gosper_sum(term, (k, first, last))) is not None:
        yield found
    if isinstance(term, sp.log):
        yield sp.log(sum_up(sp.Product(term.args[0], (k, first, last)), last, domain))
    if isinstance(term, sp.atan):
        yield from _propose_arctangents(total)


def _propose_arctangents(total: sp.Sum) -> Iterator[sp.Expr]:
    """Propose a sum of atan(c/(k**2 + b*k + d)), the change of atan(s/c*(k + (b - s)/2)) by s."""
    (k, first, last), *_ = total.limits
    above, below = (sp.Poly(part, k) for part in sp.fraction(sp.together(total.function.args[0])))
    if above.degree() != 0 or below.degree() != 2:
        return
    square, middle, _ = below.all_coeffs()
    for step in (1, 2):
        slope, shift = step * square / above.LC(), (middle / square - step) / 2
        places = [[slope * (end + n + shift) for n in range(step)] for end in (first, last + 1)]
        begin, end = (sp.Add(*map(sp.atan, arguments)) for arguments in places)
        yield end - begin


def _find_infinity(
    term: sp.Expr, k: sp.Symbol, first: sp.Integer, domain: Domain
) -> sp.Expr | None:
    """Return plus or minus infinity, by which a harmonic series or a slower one is exceeded."""
    from_first = domain.with_set(_ABOVE, sp.S.Naturals0)
    running = term.subs(k, first + _ABOVE)
    counts = [factorial.args[0] for factorial in running.atoms(sp.factorial)]
    if not (has_values(running, from_first) and all(count.is_nonnegative for count in counts)):
        return None
    for size in (k, k * sp.log(k)):
        limit = find_limit(term * size, k, sp.oo, -1, domain)
        sign = find_sign(sp.sign(limit), domain) if limit is not None else None
        if sign is not None and sign.strict:
            return sign.direction * sp.oo
    return None


def _find_limit(partial: sp.Expr, domain: Domain) -> sp.Expr | None:
    limit = find_limit(partial, _N, sp.oo, 1, domain)
    return None if limit is None or limit.is_infinite else limit
