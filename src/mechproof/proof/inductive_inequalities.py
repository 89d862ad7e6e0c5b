"""Rung: an inequality for all whole numbers n, from one to the next.

D(n) > 0 holds for the first n, and D(n + 1) - c*D(n) >= 0 with some c > 0 from there on, so that it
holds for all. With c = 1 that is a comparison of differences; with the quotient of a term of D and
the one before, which is c for a power and n + 1 for a factorial, one of quotients. The step is an
inequality of real numbers n, and shown as any other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import sympy as sp

from mechproof.proof.canonical_sums import write_out
from mechproof.proof.counts import find_first, let_run
from mechproof.proof.definedness import has_values
from mechproof.proof.half_angles import is_negative_somewhere
from mechproof.proof.induction import follow, is_plain
from mechproof.proof.sign_forms import drop_signed_factors
from mechproof.proof.signs import is_nonnegative, is_nonzero, is_positive
from mechproof.proof.telescoping import reduce_quotient
from mechproof.record import Slack
from mechproof.record.parts import has_parts
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare

RUNG = "induction of an inequality"
# Work limits: first numbers that are looked at singly, letters of a step, terms and operations.
_MOST_SINGLE = 6
_MOST_LETTERS = 2
_MOST_TERMS = 5
_LARGEST = 60
# Of a slack, on a domain.
Show = Callable[[Slack, Domain], str | None]


def holds_by_steps(slack: Slack, domain: Domain, show: Show) -> bool:
    """Tell whether a number is shown to be positive, or not negative, for all of a count."""
    value = domain.resolve(slack.value)
    if value.count_ops() > _LARGEST or has_parts(value, sp.Integral, sp.Piecewise):
        return False
    counts = (n for n in value.free_symbols if find_first(n, domain) is not None)
    return any(_holds(Slack(value, slack.strict), n, domain, show) for n in sorted(counts, key=str))


def _holds(slack: Slack, n: sp.Symbol, domain: Domain, show: Show) -> bool:
    first = find_first(n, domain)
    totals = [total for total in slack.value.atoms(sp.Sum, sp.Product) if total.has(n)]
    if first is None or not all(is_plain(total, n) for total in totals):
        return False
    steps = list(_list_steps(slack.value, n)) if _goes_on(slack.value, n, domain) else []
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
    """Yield c with D(n + 1) - c*D(n), where nothing of sums and products to n is left in it."""
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


def _goes_on(value: sp.Expr, n: sp.Symbol, domain: Domain) -> bool:
    """Tell whether D(n) and D(n + 1) have values for all n: a step from what has none says nothing.

    The square root of x + n, which has values for more x with every n, begins for few.
    """
    for side in follow(value, n)[:2]:
        powers = [power for power in side.atoms(sp.Pow) if power.exp.has(n)]
        if not all(p.exp.is_nonnegative or is_nonzero(p.base, domain) for p in powers):
            return False
        # Of others, as roots to n, no quotient is a fraction.
        if not all(power.exp.is_polynomial(n) for power in powers):
            return False
        if not has_values(*_name_factorials(side, domain)):
            return False
    return True


def _name_factorials(value: sp.Expr, domain: Domain) -> tuple[sp.Expr, Domain]:
    """Let factorials of what is not negative be positive numbers."""
    nodes = [node for node in value.atoms(sp.factorial) if node.args[0].is_nonnegative]
    named = {node: sp.Dummy("factorial", positive=True) for node in nodes}
    positive = dict.fromkeys(named.values(), sp.Interval.open(0, sp.oo))
    return value.xreplace(named), replace(domain, within={**domain.within, **positive})


def _let_run(
    factor: sp.Expr, rest: sp.Expr, n: sp.Symbol, strict: bool, domain: Domain
) -> tuple[sp.Expr, Domain] | None:
    """Let n be real in a step whose factor is positive, or not negative if that is enough."""
    rest, domain = _name_factorials(rest, domain)
    run = let_run(sp.Tuple(factor, rest), n, domain)
    if run is None:
        return None
    (factor, rest), part = run
    if not (is_positive if strict else is_nonnegative)(factor, part):
        return None
    return drop_signed_factors(sp.factor(rest), part), part
