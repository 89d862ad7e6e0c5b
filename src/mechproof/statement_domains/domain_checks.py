"""Checks of what is declared of a domain: sets, given symbols, relations."""

from __future__ import annotations

from functools import cache

import sympy as sp

from mechproof.record import RecordError
from mechproof.statement_domains.assumptions import describe_excess, facts_of, find_excess
from mechproof.statement_domains.set_values import COUNTS


@cache
def check_set(symbol: sp.Basic, where: sp.Set) -> None:
    """Refuse sets without a rule for points, and values that SymPy is told do not occur."""
    if not (where in COUNTS or isinstance(where, sp.Interval | sp.FiniteSet)):
        raise RecordError(
            f"{symbol} in {where}: allowed are Interval, FiniteSet, Naturals, Integers"
        )
    if excess := find_excess(symbol, facts_of(where)):
        raise RecordError(
            f"{symbol} in {where}: the SymPy symbol is declared to be narrower: "
            f"{describe_excess(excess)}"
        )


@cache
def check_given(symbol: sp.Basic, definition: sp.Expr) -> None:
    """Refuse what SymPy is told of a given symbol and does not know of its definition."""
    known = {name: getattr(definition, f"is_{name}") for name in symbol.assumptions0}
    if excess := find_excess(symbol, {**known, **facts_of(sp.S.Reals)}):
        raise RecordError(
            f"{symbol} = {definition}: declare the symbol real only, not {describe_excess(excess)}"
        )


def check_relation(relation: sp.Basic, declared: set[sp.Basic]) -> None:
    """Refuse symbols that are not declared; those of indices run over all that there are."""
    labels = {getattr(symbol, "label", symbol) for symbol in declared}
    entries = relation.atoms(sp.Indexed)
    indices = {s for entry in entries for index in entry.indices for s in index.free_symbols}
    if unknown := relation.free_symbols - entries - indices - declared - labels:
        names = ", ".join(sorted(map(str, unknown)))
        raise RecordError(f"the domain {relation}: {names} is no declared symbol")
