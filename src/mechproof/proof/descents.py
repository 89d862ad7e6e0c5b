"""Rung: a quantity that falls from each whole number n to the next is at least its limit.

So a sum of positive terms is less than the infinite sum, and 2 - 1/(n + 1) exceeds the sum of
1/k**2. Induction from n to n + 1 cannot show this, since the difference of the sides falls.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from mechproof.proof.counts import find_first, let_run, untie
from mechproof.proof.endless_sums import SUMS, find_endless, find_series
from mechproof.proof.fraction_sums import find_fractions
from mechproof.proof.growth import find_limit
from mechproof.proof.induction import follow, goes_on, is_plain, name_factorials
from mechproof.proof.sign_forms import drop_signed_factors
from mechproof.proof.signs import is_positive
from mechproof.record import Slack
from mechproof.record.parts import has_parts
from mechproof.record.substitution import put_values
from mechproof.statement_domains.domain import Domain

RUNG = "descent to a limit"
# Work limit: operations in a quantity.
_LARGEST = 60
# Returns the name of the rung that shows the sign of a slack on a domain, or None.
Show = Callable[[Slack, Domain], str | None]


def holds_by_descent(slack: Slack, domain: Domain, show: Show) -> bool:
    """Return whether a slack is shown to be positive, or not negative, for all values of n."""
    value = domain.resolve(slack.value)
    if value.count_ops() > _LARGEST or has_parts(value, sp.Integral, sp.Piecewise):
        return False
    counts = [n for n in value.free_symbols if find_first(n, domain) is not None]
    return len(counts) == 1 and _holds(Slack(value, slack.strict), counts[0], domain, show)


def _holds(slack: Slack, n: sp.Symbol, domain: Domain, show: Show) -> bool:
    totals = [total for total in slack.value.atoms(sp.Sum, sp.Product) if total.has(n)]
    if not totals or not all(_is_endless(total, n) for total in totals):
        return False
    if not goes_on(slack.value, n, untie(n, domain)):
        return False
    limit = _find_limit(slack.value, totals, n, domain)
    if limit is None or not show(Slack(limit, False), domain):
        return False
    return _falls(slack, n, domain, show) or bool(
        slack.strict
        and show(Slack(limit, True), domain)
        and _falls(slack._replace(strict=False), n, domain, show)
    )


def _is_endless(total: sp.Sum | sp.Product, n: sp.Symbol) -> bool:
    """Return whether a larger n only adds terms to a sum or product, the others unchanged."""
    _, lower, upper = total.limits[0]
    return is_plain(total, n) and not total.function.has(n) and lower.is_Integer and upper == n


def _find_limit(
    value: sp.Expr, totals: list[sp.Expr], n: sp.Symbol, domain: Domain
) -> sp.Expr | None:
    """Return the limit of a number linear in sums and products, with factors free of n."""
    names = {total: sp.Dummy("total", real=True) for total in totals}
    named = value.xreplace(names)
    rest = named.subs(dict.fromkeys(names.values(), 0))
    slopes = {total: sp.diff(named, name) for total, name in names.items()}
    if any(slope.has(n, *names.values()) for slope in slopes.values()):
        return None
    limit = find_limit(rest, n, sp.oo, -1, domain)
    if limit is None or limit.is_infinite:
        return None
    for total, slope in slopes.items():
        k, lower, _ = total.limits[0]
        endless = total.func(total.function, (k, lower, sp.oo))
        for find in (find_endless, find_series, find_fractions):
            endless = put_values(endless, domain, SUMS, find)
        if endless.has(sp.Sum, sp.Product) or endless.is_infinite:
            return None
        limit += slope * endless
    return limit


def _falls(slack: Slack, n: sp.Symbol, domain: Domain, show: Show) -> bool:
    """Return whether the value for n + 1 is shown to be less, or no more, than that for n."""
    before, following, products = follow(slack.value, n)
    positive = sp.Interval.open(0, sp.oo)
    named = {name: sp.Dummy("product", positive=True) for name in products}
    if any(not _is_positive(total, domain) for total in slack.value.atoms(sp.Product)):
        return False
    domain = replace(domain, within={**domain.within, **dict.fromkeys(named.values(), positive)})
    fall = sp.expand(before - following).xreplace(named)
    fall, domain = name_factorials(fall, domain)
    run = let_run(fall, n, domain)
    if run is None or not fall.free_symbols <= {n, *domain.within}:
        return False
    fall, part = run
    return bool(show(Slack(drop_signed_factors(sp.factor(fall), part), slack.strict), part))


def _is_positive(product: sp.Product, domain: Domain) -> bool:
    k, lower, _ = product.limits[0]
    above = sp.Dummy("above", integer=True, nonnegative=True)
    counted = domain.with_set(above, sp.S.Naturals0)
    return is_positive(product.function.subs(k, lower + above), counted)
