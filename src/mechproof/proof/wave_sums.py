"""Rung: sums of sines and cosines whose angles rise by the same step, 2*pi/n for n planets.

With d the step, the sum of cos(c + k*d) from p to q is sin(c + (q + 1/2)*d) - sin(c + (p - 1/2)*d)
divided by 2*sin(d/2), as each term is such a difference; where d/2 is no multiple of pi. A product
of n sines with the step pi/n is that of n times the first angle, divided by 2**(n - 1).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp
from sympy.simplify.fu import TR8

from mechproof.proof.algebra import decide_equal
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.cases import Prove, Sides, put_in
from mechproof.proof.signs import is_nonnegative, is_positive
from mechproof.statement_domains.domain import Domain

RUNG = "angles that rise by the same step"
# Work limits: first numbers that are looked at one by one, and operations of a term.
_MOST_ALONE = 4
_LARGEST = 40


def decide_by_steps(left: sp.Expr, right: sp.Expr, domain: Domain, prove: Prove) -> str | None:
    """Return the rungs if left = right is proved with the values of such sums and products.

    The first numbers, for which a step may be a whole turn, are looked at one by one.
    """
    sides = (domain.resolve(left), domain.resolve(right))
    sums = {total for side in sides for total in side.atoms(sp.Sum, sp.Product)}
    counts = {n for total in sums for n in _list_counts(total)}
    if len(counts) != 1:
        return None
    (n,) = counts
    for first in range(1, _MOST_ALONE + 1):
        later = replace(domain, where=(*domain.where, n >= first)) if first > 1 else domain
        values = {total: _find_value(total, n, later) for total in sums}
        if None not in values.values():
            alone = ({n: sp.Integer(number)} for number in range(1, first))
            if not all(_holds_at(one, sides, domain, prove) for one in alone):
                return None
            rest = prove(*(side.xreplace(values) for side in sides), later)
            return f"{RUNG}, {rest}" if rest else None
    return None


def _list_counts(total: sp.Sum | sp.Product) -> set[sp.Symbol]:
    """Return the numbers of terms that the angles of these have."""
    ends = {s for limit in total.limits for end in limit[1:] for s in end.free_symbols}
    in_waves = {s for wave in total.function.atoms(sp.sin, sp.cos) for s in wave.free_symbols}
    return {n for n in ends & in_waves if n.is_integer and n.is_positive}


def _holds_at(
    point: Mapping[sp.Basic, sp.Expr], sides: Sides, domain: Domain, prove: Prove
) -> bool:
    """Tell whether the sides are equal for one number, which the domain may exclude."""
    *parts, fixed = put_in(sides, domain, point)
    return sp.false in fixed.where or bool(prove(*map(write_out, parts), fixed))


def _find_value(total: sp.Sum | sp.Product, n: sp.Symbol, domain: Domain) -> sp.Expr | None:
    (k, first, last), *others = total.limits
    if others or total.function.count_ops() > _LARGEST:
        return None
    if not is_nonnegative(last - first + 1, domain):
        return None
    if isinstance(total, sp.Product):
        return _multiply(total, n)
    term = sp.expand(TR8(sp.expand(total.function)))
    if decide_equal(term, total.function, domain) is None:
        return None
    ends = (first - sp.S.Half, last + sp.S.Half)
    parts = [_add_up(part, k, ends, n, domain) for part in sp.Add.make_args(term)]
    return None if None in parts else sp.Add(*parts)


def _add_up(
    term: sp.Expr, k: sp.Symbol, ends: tuple[sp.Expr, sp.Expr], n: sp.Symbol, domain: Domain
) -> sp.Expr | None:
    """Return the sum of a term between half numbers, None if it is no sine or cosine."""
    low, high = ends
    factor, wave = term.as_independent(k)
    if wave == 1:
        return factor * (high - low)
    if not isinstance(wave, sp.sin | sp.cos):
        return None
    (angle,) = wave.args
    step = sp.diff(angle, k)
    if step.has(k) or not _is_within_turn(step, domain):
        return None
    grown = sp.sin if isinstance(wave, sp.cos) else lambda u: -sp.cos(u)
    at_ends = (grown(_split(angle.subs(k, end), n)) for end in (high, low))
    return factor * sp.Add(next(at_ends), -next(at_ends)) / (2 * sp.sin(step / 2))


def _multiply(product: sp.Product, n: sp.Symbol) -> sp.Expr | None:
    """Return a product of n sines or cosines, of n - 1 without the one of no angle."""
    k, first, last = product.limits[0]
    factor, wave = product.function.as_independent(k, as_Add=False)
    if not isinstance(wave, sp.sin | sp.cos):
        return None
    angle = wave.args[0] + (sp.pi / 2 if isinstance(wave, sp.cos) else 0)
    start, step = angle.subs(k, first), sp.diff(angle, k)
    count = sp.expand(last - first + 1)
    if sp.expand(step - sp.pi / n) != 0:
        return None
    if count == n:
        return factor**n * sp.sin(sp.expand(n * start)) / 2 ** (n - 1)
    if count == n - 1 and sp.expand(start - step) == 0:
        return factor**count * n / 2 ** (n - 1)
    return None


def _is_within_turn(step: sp.Expr, domain: Domain) -> bool:
    """Tell whether a step is shown to be between nothing and a whole turn."""
    part = sp.cancel(step / (2 * sp.pi))
    return any(is_positive(p, domain) and is_positive(1 - p, domain) for p in (part, -part))


def _split(angle: sp.Expr, n: sp.Symbol) -> sp.Expr:
    """Write an angle with whole turns apart: pi - pi/(2*n + 1)."""
    return sp.expand(sp.apart(sp.together(angle), n)) if angle.is_rational_function(n) else angle
