"""Rungs: sums with n terms, and inequalities, from one whole number to the next.

A sum has a value that begins and grows as the sum does: both sides are equal for the smallest n,
and grow equally from each n to n + 1, so by induction they are equal for all n. Geometric and
telescoping sums are thus proved without being evaluated; the value comes from the print (Petkovšek,
Wilf, Zeilberger, A = B, 1996, chapter 1), so no algorithm such as Gosper's (1978) has to find it.

An inequality D(n) > 0 holds for all n if it holds for the first n and, from there on,
D(n + 1) - c*D(n) >= 0 for some c > 0. With c = 1 this compares differences; with c the quotient of
successive terms of D (c for a power c**n, n + 1 for a factorial) it compares quotients. The step is
an inequality in real numbers n, and is proved like any other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

from mechproof.proof.algebra import decide_equal
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.counts import find_first, let_run, untie
from mechproof.proof.definedness import has_values
from mechproof.proof.half_angles import is_negative_somewhere
from mechproof.proof.integrals import find_value
from mechproof.proof.inverses import decide_by_inverse
from mechproof.proof.powers import decide_by_logarithms, is_analytic, split_powers
from mechproof.proof.sign_forms import drop_signed_factors
from mechproof.proof.signs import is_nonnegative, is_nonzero, is_positive
from mechproof.proof.telescoping import reduce_quotient
from mechproof.record import Slack
from mechproof.record.parts import has_parts
from mechproof.record.substitution import put_values, substitute
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare

RUNG = "induction"
_TO_COUNTS = (sp.Sum, sp.Product, sp.Integral)
# Work limit: terms that are added or dropped from n to n + 1.
_MOST_STEPS = 4


def decide_by_induction(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right is proved by induction over a count, else None."""
    difference = _sum_inside(domain.resolve(left - right), domain)
    for count in sorted(_list_counts(difference), key=str):
        if (first := find_first(count, domain)) is None:
            continue
        begun = write_out(substitute(difference, {count: first}))
        if _vanishes(begun, domain) and _grows(difference, count, untie(count, domain)):
            return RUNG
    return None


def decide_by_quotients(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if sides with factorials begin alike and grow by the same factor, else None.

    Both sides are positive for all n, so equality at n implies equality at n + 1.
    """
    sides = [domain.resolve(side) for side in (left, right)]
    if not any(side.has(sp.gamma) for side in sides) or not all(s.is_positive for s in sides):
        return None
    for count in sorted({n for side in sides for n in side.free_symbols}, key=str):
        if (first := find_first(count, domain)) is None:
            continue
        begun = [substitute(side, {count: first}) for side in sides]
        after = [side.subs(count, count + 1) for side in sides]
        crossed = after[0] * sides[1] - after[1] * sides[0]
        part = untie(count, domain)
        if _vanishes(begun[0] - begun[1], domain) and _vanishes(crossed, part):
            return RUNG
    return None


def sum_up(body: sp.Expr, variable: sp.Symbol, domain: Domain) -> sp.Expr:
    """Replace sums and products up to a variable by values that SymPy proposes, where proved.

    The variable counts from 1.
    """
    count = sp.Dummy("n", integer=True, positive=True)
    counted = domain.with_set(count, sp.S.Naturals)
    for total in sorted(body.atoms(sp.Sum, sp.Product), key=sp.default_sort_key):
        factor, term = sp.S.One, total.function
        if isinstance(total, sp.Sum):
            factor, term = term.as_independent(total.limits[0][0], as_Add=False)
        plain = total.func(term, *total.limits).xreplace({variable: count})
        value = _propose(plain) if plain.has(count) else plain
        if not value.has(sp.Sum, sp.Product) and decide_by_induction(plain, value, counted):
            body = body.xreplace({total: factor * value.xreplace({count: variable})})
    return body


def _propose(total: sp.Sum | sp.Product) -> sp.Expr:
    value: sp.Expr = total.doit()
    # SymPy raises a TypeError if a term has complex roots.
    with suppress(TypeError):
        return sp.combsimp(value) if value.has(sp.RisingFactorial) else value
    return total


def _sum_inside(difference: sp.Expr, domain: Domain) -> sp.Expr:
    """Evaluate inner sums whose upper limit contains the index of the enclosing sum."""
    summed = {}
    for total in difference.atoms(sp.Sum):
        inner, *outer = total.limits
        if len(outer) == 1 and outer[0][1].is_positive and inner[2].has(outer[0][0]):
            term = sum_up(sp.Sum(total.function, inner), outer[0][0], domain)
            summed[total] = total.func(term, *outer)
    return difference.xreplace(summed)


def _list_counts(difference: sp.Expr) -> set[sp.Symbol]:
    """Return the counts up to which sums, products and integrals run, all of them plain."""
    sums = difference.atoms(*_TO_COUNTS)
    if any(len(limits) != 3 for total in sums for limits in total.limits):
        return set()
    ends = {symbol for total in sums for symbol in total.limits[0][2].free_symbols}
    counts = {end for end in ends if end.is_positive and end.is_integer}
    return {n for n in counts if all(is_plain(total, n) for total in sums if total.has(n))}


def is_plain(total: ExprWithLimits, count: sp.Symbol) -> bool:
    """Return whether the one index's limits move by whole steps with n, with terms free of n.

    The terms of a sum may also change by a common factor, as a^(n - k) does.
    """
    (_, lower, upper), *others = total.limits
    if isinstance(total, sp.Integral):
        is_moved = sp.diff(upper, count).is_number and not (lower.has(count) or others)
        return bool(is_moved and not total.function.has(count))
    rates = [sp.diff(end, count) for end in (lower, upper)]
    first = (upper - lower).subs(count, 1)
    return bool(
        not others
        and all(rate.is_Integer and 0 <= rate <= _MOST_STEPS for rate in rates)
        and rates[0] <= rates[1]
        and first.is_Integer
        and first >= -1
        and lower.subs(count, 1).is_Integer
        and not _change(total, count).has(total.limits[0][0])
    )


def _change(total: ExprWithLimits, count: sp.Symbol) -> sp.Expr:
    """Return the factor by which the terms of a sum change from n to n + 1.

    A power with a whole exponent changes by its base, even where that is zero. If there is no such
    factor, the index is returned.
    """
    if not total.function.has(count):
        return sp.S.One
    factors = [factor.as_base_exp() for factor in sp.Mul.make_args(total.function)]
    if isinstance(total, sp.Product) or any(
        base.has(count) or not exponent.is_integer for base, exponent in factors
    ):
        return total.limits[0][0]
    steps = (base ** sp.expand(e.subs(count, count + 1) - e) for base, e in factors)
    return sp.Mul(*steps)


def _grows(difference: sp.Expr, count: sp.Symbol, domain: Domain) -> bool:
    """Return whether the difference stays zero from n to n + 1."""
    before, following, products = follow(difference, count)
    if not products:
        return _vanishes(following - before, domain)
    # The induction hypothesis, difference = 0, is solved for the value of the product at n.
    slope = before.diff(*products)
    named = before.free_symbols - difference.free_symbols
    if len(products) > 1 or slope.has(count, *named) or not is_analytic(slope):
        return False
    following = following.subs(products[0], products[0] - before / slope)
    return _vanishes(sp.expand(following * slope), domain)


def follow(number: sp.Expr, count: sp.Symbol) -> tuple[sp.Expr, sp.Expr, list[sp.Symbol]]:
    """Return a number for n and for n + 1, with its sums and products up to n named.

    The third result lists the names of those that change by a factor.
    """
    totals = [total for total in number.atoms(*_TO_COUNTS) if total.has(count)]
    kept = {total: sp.Dummy() for total in totals}
    before = number.xreplace(kept)
    after = {kept[total]: _go_on(total, count, kept[total]) for total in totals}
    following = before.subs(count, count + 1).xreplace(after)
    changed = (t for t in totals if isinstance(t, sp.Product) or _change(t, count) != 1)
    return before, following, [kept[total] for total in changed]


def _go_on(total: ExprWithLimits, count: sp.Symbol, value: sp.Symbol) -> sp.Expr:
    """Return a total for n + 1 from its value for n, with the terms gained and lost."""
    index, lower, upper = total.limits[0]
    if isinstance(total, sp.Integral):
        moved = total.function.subs(index, index + upper)
        return value + sp.Integral(moved, (index, 0, sp.diff(upper, count)))
    come = [upper + k for k in range(1, int(sp.diff(upper, count)) + 1)]
    go = [lower + k for k in range(int(sp.diff(lower, count)))]
    term = total.function.subs(count, count + 1)
    more, less = ([term.subs(index, k) for k in numbers] for numbers in (come, go))
    if isinstance(total, sp.Product):
        return value * sp.Mul(*more) / sp.Mul(*less)
    return value * _change(total, count) + sp.Add(*more) - sp.Add(*less)


def _vanishes(value: sp.Expr, domain: Domain) -> bool:
    value = split_powers(prepare(put_values(value, domain, (sp.Integral,), find_value)))
    rungs = (decide_equal, decide_by_logarithms, decide_by_inverse)
    return any(rung(value, sp.S.Zero, domain) for rung in rungs)


OF_INEQUALITIES = "induction of an inequality"
# Work limits: first numbers that are checked singly, letters, terms and operations of a step.
_MOST_SINGLE = 6
_MOST_LETTERS = 2
_MOST_TERMS = 5
_LARGEST = 60
# Names the rung that shows the sign of a slack on a domain.
Show = Callable[[Slack, Domain], str | None]


def holds_by_steps(slack: Slack, domain: Domain, show: Show) -> bool:
    """Return whether induction shows a slack positive, or non-negative if it is not strict."""
    value = domain.resolve(slack.value)
    if value.count_ops() > _LARGEST or has_parts(value, sp.Integral, sp.Piecewise):
        return False
    counts = (n for n in value.free_symbols if find_first(n, domain) is not None)
    return any(
        _holds(Slack(_shift_indices(value, n), slack.strict), n, domain, show)
        for n in sorted(counts, key=str)
    )


def _shift_indices(value: sp.Expr, n: sp.Symbol) -> sp.Expr:
    """Shift the index of sums of terms of n + k by n, so that only the limits contain n."""
    shifted = {}
    for total in value.atoms(sp.Sum, sp.Product):
        (k, lower, upper), *others = total.limits
        term = total.function.subs(k, k - n)
        if not others and total.function.has(n) and not term.has(n):
            shifted[total] = total.func(term, (k, lower + n, upper + n))
    return value.xreplace(shifted)


def _holds(slack: Slack, n: sp.Symbol, domain: Domain, show: Show) -> bool:
    first = find_first(n, domain)
    totals = [total for total in slack.value.atoms(sp.Sum, sp.Product) if total.has(n)]
    if first is None or not all(is_plain(total, n) for total in totals):
        return False
    steps = list(_list_steps(slack.value, n)) if goes_on(slack.value, n, untie(n, domain)) else []
    for start in range(int(first), int(first) + _MOST_SINGLE):
        beginning = sp.expand(write_out(substitute(slack.value, {n: sp.Integer(start)})))
        if not show(Slack(beginning, slack.strict), domain):
            return False
        part = replace(domain, where=(*domain.where, sp.Ge(n, start)))
        runs = [run for step in steps if (run := _let_run(*step, n, slack.strict, part))]
        small = (run for run in runs if len(run[0].free_symbols) <= _MOST_LETTERS)
        fitting = [run for run in small if not is_negative_somewhere(*run)]
        if fitting:
            return any(show(Slack(rest, False), run) for rest, run in fitting)
    return False


def _list_steps(value: sp.Expr, n: sp.Symbol) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Yield c and D(n + 1) - c*D(n) if the latter no longer contains sums or products up to n."""
    before, following, _ = follow(value, n)
    kept = before.free_symbols - value.free_symbols
    terms = [term for term in sp.Add.make_args(sp.expand(value)) if term.has(n)]
    if len(terms) > _MOST_TERMS:
        return
    pairs = (follow(term, n) for term in terms)
    quotients = (reduce_quotient(later / now) for now, later, _ in pairs)
    for factor in dict.fromkeys([sp.S.One, *(q for q in quotients if q is not None)]):
        rest = sp.expand(prepare(following - factor * before))
        if not rest.has(*kept):
            yield factor, rest


def goes_on(value: sp.Expr, n: sp.Symbol, domain: Domain) -> bool:
    """Return whether D(n) and D(n + 1) have values for all n; otherwise a step proves nothing.

    The square root of x + n, for example, has values for more x as n grows.
    """
    for side in follow(value, n)[:2]:
        powers = [power for power in side.atoms(sp.Pow) if power.exp.has(n)]
        if not all(p.exp.is_nonnegative or is_nonzero(p.base, domain) for p in powers):
            return False
        # Other exponents, as in the n-th root of x, give quotients that are not rational.
        if not all(power.exp.is_polynomial(n) for power in powers):
            return False
        if not has_values(*name_factorials(side, domain)):
            return False
    return True


def name_factorials(value: sp.Expr, domain: Domain) -> tuple[sp.Expr, Domain]:
    """Replace factorials of non-negative numbers by positive variables."""
    nodes = [node for node in value.atoms(sp.factorial) if node.args[0].is_nonnegative]
    named = {node: sp.Dummy("factorial", positive=True) for node in nodes}
    positive = dict.fromkeys(named.values(), sp.Interval.open(0, sp.oo))
    return value.xreplace(named), replace(domain, within={**domain.within, **positive})


def _let_run(
    factor: sp.Expr, rest: sp.Expr, n: sp.Symbol, strict: bool, domain: Domain
) -> tuple[sp.Expr, Domain] | None:
    """Let n be real in a step with a positive factor, or non-negative one if not `strict`."""
    rest, domain = name_factorials(rest, domain)
    run = let_run(sp.Tuple(factor, rest), n, domain)
    if run is None:
        return None
    (factor, rest), part = run
    if not (is_positive if strict else is_nonnegative)(factor, part):
        return None
    return drop_signed_factors(sp.factor(rest), part), part
