"""Whole numbers at which a statement is tried: small ones first, unequal before equal ones."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, islice, permutations

import sympy as sp

from mechproof.proof.signs import is_positive
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain, Point

# A single term hides errors between terms, and no terms hide everything, so the counts 1 and 0 do
# not come first.
_FIRST = (2, 3, 5, 1, 4, 7, 6, 10, 12, 8, 9, 11, 0)
_MOST_TRIED = 2000
STEPS = (sp.floor, sp.ceiling, sp.sign, sp.Heaviside, sp.Mod, sp.Piecewise, sp.KroneckerDelta)


def is_count(symbol: sp.Basic, domain: Domain) -> bool:
    """Return whether a symbol is a whole number that no finite set lists."""
    return bool(symbol.is_integer) and not isinstance(domain.set_of(symbol), sp.FiniteSet)


def has_steps(expression: sp.Expr, domain: Domain) -> bool:
    """Return whether an expression is not continuous in its letters: it has counts or jumps."""
    resolved = domain.resolve(expression)
    runs = (isinstance(domain.set_of(s), sp.Interval) for s in resolved.free_symbols)
    counts = any(s.is_integer for s in resolved.free_symbols)
    return counts or not all(runs) or resolved.has(*STEPS)


def let_run(value: sp.Expr, count: sp.Symbol, domain: Domain) -> tuple[sp.Expr, Domain] | None:
    """Replace a count by any real number from its first value onwards; None if it has no first one.

    None also if there is a factorial or a step, or if the count is in the exponent of a possibly
    negative base, whose powers have no real values between whole exponents.
    """
    first = find_first(count, domain)
    if first is None or value.has(sp.factorial, *STEPS):
        return None
    run = sp.Dummy(count.name, positive=True) if first > 0 else sp.Dummy(count.name, real=True)
    within = {s: values for s, values in domain.within.items() if s != count}
    where = tuple(relation for relation in domain.where if not relation.has(count))
    within[run] = sp.Interval(first, sp.oo)
    written, part = value.xreplace({count: run}), replace(domain, within=within, where=where)
    powers = (power for power in written.atoms(sp.Pow) if power.exp.has(run))
    return (written, part) if all(is_positive(p.base, part) for p in powers) else None


def find_first(count: sp.Basic, domain: Domain) -> sp.Integer | None:
    """Return a whole number that is known to be a lower bound of a count, or None."""
    first = {sp.S.Naturals: sp.S.One, sp.S.Naturals0: sp.S.Zero}.get(domain.set_of(count))
    if first is None:
        return None
    for slack in filter(None, map(find_slack, domain.where)):
        least = sp.expand(count - slack.value)
        if least.is_Rational:
            first = max(first, sp.floor(least) + 1 if slack.strict else sp.ceiling(least))
    return first


def untie(count: sp.Symbol, domain: Domain) -> Domain:
    """Return a domain with all counts from the first one on for all values of the other letters.

    A step from n to n + 1 is taken for the same other letters. Relations that tie these to n may
    hold for one of the two only.
    """
    free = (relation for relation in domain.where if not relation.has(count))
    said = (*free, sp.Ge(count, find_first(count, domain)))
    return replace(domain, where=tuple(relation for relation in said if relation != sp.true))


def choose_counts(counts: list[sp.Basic], domain: Domain, number: int) -> Iterator[Point]:
    """Yield choices of counts that belong to points of the domain, small ones if there are any.

    Raises `RecordError` if none is found.
    """
    if not counts:
        yield {}
        return
    small = (sizes for sizes in _list_small(counts, number) if domain.allows(sizes))
    reached = list(islice((sizes for sizes in small if domain.reaches(sizes)), number))
    if not reached:
        points = domain.points(counts, number)
        reached = [{symbol: point[symbol] for symbol in counts} for point in points]
    yield from reached


def _list_small(counts: list[sp.Basic], number: int) -> Iterator[Point]:
    unlike = (turned for v in permutations(_FIRST, len(counts)) for turned in (v, v[::-1]))
    like = [(start,) * len(counts) for start in _FIRST] if len(counts) > 1 else []
    values = chain(islice(unlike, max(3, number - 4)), like, islice(unlike, _MOST_TRIED))
    return (dict(zip(counts, map(sp.Integer, v), strict=True)) for v in dict.fromkeys(values))
