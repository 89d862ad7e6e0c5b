"""Cases: sides that are given by pieces, or hold a symbol with few values, one case at a time.

Each condition is once taken to be true and once to be false, on the part of the domain where it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import replace

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.relational import Relational

from mechproof.proof.domain import Domain
from mechproof.record.relations import find_slack, solve
from mechproof.record.substitution import substitute

Sides = tuple[sp.Expr, sp.Expr]
# Of both sides and the domain.
Prove = Callable[..., str | None]
RUNG = "case by case"


def decide_by_pieces(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sides by pieces equal, whichever condition of a piece holds; None for other sides."""
    condition = min(_list_conditions(sides), key=sp.default_sort_key, default=None)
    if condition is None:
        return None
    cases = {True: narrow(domain, condition), False: narrow(domain, condition.negated)}
    return _join(
        prove(*(_assume(side, condition, holds=holds) for side in sides), part)
        for holds, part in cases.items()
        if part is not None
    )


def decide_by_values(sides: Sides, domain: Domain, prove: Prove) -> str | None:
    """Prove sides equal for each value of a symbol that has few; None where none has."""
    symbols = {symbol for side in sides for symbol in side.free_symbols} & domain.within.keys()
    listed = [s for s in symbols if isinstance(domain.set_of(s), sp.FiniteSet)]
    if not listed:
        return None
    symbol = min(listed, key=str)
    values = [{symbol: value} for value in domain.set_of(symbol).args]
    return _join(
        prove(*(substitute(side, value) for side in sides), _fix(domain, value)) for value in values
    )


def narrow(domain: Domain, relation: Relational) -> Domain | None:
    """Return the part of a domain on which a relation holds, None for nothing.

    What is no inequality narrows nothing, what is not solved is a relation of the part.
    """
    relation = domain.resolve(relation)
    if relation == sp.false:
        return None
    if find_slack(relation) is None:
        return domain
    symbols = relation.free_symbols
    if len(symbols) == 1 and symbols <= domain.within.keys():
        (symbol,) = symbols
        with suppress(NotImplementedError):
            narrowed = domain.set_of(symbol).intersect(solve(relation, symbol))
            if narrowed == sp.S.EmptySet:
                return None
            if isinstance(narrowed, sp.Interval | sp.FiniteSet):
                return replace(domain, within={**domain.within, symbol: narrowed})
    return replace(domain, where=(*domain.where, relation))


def _list_conditions(sides: Sides) -> set[Relational]:
    """Collect the conditions of pieces in symbols that are bound nowhere."""
    pieces = {piece for side in sides for piece in side.atoms(sp.Piecewise)}
    free = {symbol for side in sides for symbol in side.free_symbols}
    bound = {
        symbol
        for side in sides
        for node in side.atoms(ExprWithLimits, sp.Limit)
        for symbol in ([node.args[1]] if isinstance(node, sp.Limit) else node.bound_symbols)
    }
    conditions = {c for piece in pieces for _, cond in piece.args for c in cond.atoms(Relational)}
    return {c.canonical for c in conditions if c.free_symbols <= free - bound}


def _assume(side: sp.Expr, condition: Relational, *, holds: bool) -> sp.Expr:
    """Return a side with the pieces that are left, and for |v| the sign that a condition tells."""
    known = {
        relation: sp.sympify(truth)
        for stated, truth in ((condition, holds), (condition.negated, not holds))
        for relation in side.atoms(Relational)
        if relation.canonical == stated.canonical
    }
    slack = find_slack(condition)
    if slack is None:
        return side.xreplace(known)
    size = {sp.Abs(slack.value): slack.value if holds else -slack.value}
    return side.xreplace(known).xreplace(size)


def _fix(domain: Domain, value: Mapping[sp.Basic, sp.Expr]) -> Domain:
    within = {symbol: values for symbol, values in domain.within.items() if symbol not in value}
    where = tuple(substitute(relation, value) for relation in domain.where)
    return replace(domain, within=within, where=where, given={**domain.given, **value})


def _join(rungs: Iterable[str | None]) -> str | None:
    """Name the rungs of all cases, None if one has none."""
    found = {RUNG: None}
    for rung in rungs:
        if rung is None:
            return None
        found |= dict.fromkeys(rung.split(", "))
    return ", ".join(found)
