"""What factors are like where their variable is large: what they are times what goes to one."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.orders import join_logarithms
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.statement_domains.domain import Domain

# What they are off one by is like this where their argument is small.
LIKE_ONE: Mapping[type[sp.Basic], Callable[[sp.Expr], sp.Expr]] = {
    sp.exp: lambda u: u,
    sp.cosh: lambda u: u**2 / 2,
    sp.cos: lambda u: -(u**2) / 2,
}
# Those that are like their argument where it is small.
LIKE_ARGUMENT = (sp.sin, sp.tan, sp.asin, sp.atan, sp.sinh, sp.tanh, sp.asinh, sp.atanh)
# Returns the limit of what the variable is in, None where it is not shown.
Find = Callable[[sp.Expr], sp.Expr | None]


def write_like(factor: sp.Expr, y: sp.Symbol, find: Find, domain: Domain) -> sp.Expr:
    """Write a factor that is u times what goes to one as u: ln(1 + u), sin u where u goes to 0."""
    factor = (join_logarithms(factor) if isinstance(factor, sp.Add) else None) or factor
    if isinstance(factor, sp.log):
        small = sp.cancel(factor.args[0] - 1)
    elif isinstance(factor, sp.Add):
        return _write_difference(factor, y, find, domain)
    elif isinstance(factor, LIKE_ARGUMENT):
        (small,) = factor.args
    else:
        return factor
    return small if find(small) == 0 else factor


def _write_difference(sum_: sp.Add, y: sp.Symbol, find: Find, domain: Domain) -> sp.Expr:
    """Write a sum whose terms come to numbers that cancel as what is left: e^u - 1, 1 - cos u.

    So is the root of what comes to a number. Of what is left of the terms the largest counts.
    """
    number, rest = sum_.as_independent(y, as_Add=True)
    parts = [_part(term, y, find, domain) for term in sp.Add.make_args(rest)]
    known = [part for part in parts if part is not None]
    is_known = len(known) == len(parts) and all(small != 0 for _, small in known)
    if not is_known or not decide_equal(-number, sum(n for n, _ in known), domain):
        return sum_
    for _, largest in known:
        ratios = [find(sp.cancel(small / largest)) for _, small in known]
        limits = [ratio for ratio in ratios if ratio is not None and ratio.is_finite]
        if len(limits) == len(known) and is_nonzero(scale := sp.Add(*limits), domain):
            return scale * largest
    return sum_


def _part(
    term: sp.Expr, y: sp.Symbol, find: Find, domain: Domain
) -> tuple[sp.Expr, sp.Expr] | None:
    """Return the number that a term comes to, and what the rest of it is like."""
    scale, moving = term.as_independent(y, as_Add=False)
    if type(moving) in LIKE_ONE:
        (u,) = moving.args
        return (scale, scale * LIKE_ONE[type(moving)](u)) if find(u) == 0 else None
    if not isinstance(moving, sp.Pow) or moving.exp.has(y):
        return None
    base = find(moving.base)
    if base is None or not base.is_finite or not is_positive(base, domain):
        return None
    value = scale * base**moving.exp
    return value, value * moving.exp * sp.cancel(moving.base / base - 1)
