"""Rung: a sum with n terms has a value that begins and grows as the sum does.

Both sides are equal for the smallest n, and for every n their differences from the one before are:
by induction they are equal for all. So geometric and telescoping sums are proved without being
summed up; the value comes from the print (Petkovšek, Wilf, Zeilberger, A = B, 1996, chapter 1).
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.domain import Domain
from mechproof.proof.inverses import decide_by_inverse
from mechproof.proof.powers import decide_by_logarithms, is_analytic, split_powers
from mechproof.proof.preparation import prepare
from mechproof.proof.sums import write_out
from mechproof.record.substitution import substitute

RUNG = "induction"


def decide_by_induction(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right is proved by induction over a count, else None."""
    difference = domain.resolve(left - right)
    for count in sorted(_list_counts(difference), key=str):
        if _begins(difference, count, domain) and _grows(difference, count, domain):
            return RUNG
    return None


def _list_counts(difference: sp.Expr) -> set[sp.Symbol]:
    """Return the symbols up to which sums and products run from an integer, each term once."""
    sums = difference.atoms(sp.Sum, sp.Product)
    ends = {total.limits[0][2].as_coeff_Add()[1] for total in sums if _is_plain(total)}
    counts = {end for end in ends if end.is_Symbol and end.is_positive and end.is_integer}
    return {n for n in counts if all(_is_plain(total) for total in sums if total.has(n))}


def _is_plain(total: sp.Sum) -> bool:
    """Tell whether a sum has one index and runs from an integer to n + k, its terms without n."""
    (_, lower, upper), *others = total.limits
    shift, count = upper.as_coeff_Add()
    return bool(
        not others
        and lower.is_Integer
        and shift.is_Integer
        and lower <= shift + 2
        and not total.function.has(count)
    )


def _begins(difference: sp.Expr, count: sp.Symbol, domain: Domain) -> bool:
    return _vanishes(write_out(substitute(difference, {count: sp.S.One})), domain)


def _grows(difference: sp.Expr, count: sp.Symbol, domain: Domain) -> bool:
    """Tell whether the step from n to n + 1 adds nothing to the difference."""
    last = {
        total: total.function.subs(total.limits[0][0], total.limits[0][2] + 1)
        for total in difference.atoms(sp.Sum, sp.Product)
        if total.has(count)
    }
    kept = {total: sp.Dummy() for total in last}
    before = difference.xreplace(kept)
    after = {
        kept[total]: kept[total] * more if isinstance(total, sp.Product) else kept[total] + more
        for total, more in last.items()
    }
    following = before.subs(count, count + 1).xreplace(after)
    products = [kept[total] for total in last if isinstance(total, sp.Product)]
    if not products:
        return _vanishes(following - before, domain)
    # What a product is for n follows from the difference, which is taken to vanish there.
    slope = before.diff(*products)
    if len(products) > 1 or slope.has(count, *kept.values()) or not is_analytic(slope):
        return False
    following = following.subs(products[0], products[0] - before / slope)
    return _vanishes(sp.expand(following * slope), domain)


def _vanishes(value: sp.Expr, domain: Domain) -> bool:
    value = split_powers(prepare(value))
    rungs = (decide_equal, decide_by_logarithms, decide_by_inverse)
    return any(rung(value, sp.S.Zero, domain) for rung in rungs)
