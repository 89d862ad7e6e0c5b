"""Checks of what is declared of a domain, and of what SymPy is told of its symbols.

It may be told no more than follows from the set of a symbol, or from its limits: SymPy uses
assumptions while an expression is built, so that one too many cannot be taken back.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import sympy as sp

from mechproof.record import RecordError
from mechproof.statement_domains.set_values import COUNTS

Facts = Mapping[str, bool]


@cache
def facts_of(where: sp.Set) -> Facts:
    """Return the assumptions that hold for every member of a set of real numbers."""
    told: dict[str, bool] = {"real": True}
    if where.is_subset(sp.S.Integers):
        told["integer"] = True
    if where.is_subset(sp.Interval(0, sp.oo)):
        told["nonnegative"] = True
    if where.is_subset(sp.Interval(-sp.oo, 0)):
        told["nonpositive"] = True
    if where.contains(0) == sp.false:
        told["nonzero"] = True
    facts = dict(sp.Dummy(**told).assumptions0)
    if isinstance(where, sp.FiniteSet):
        names = sp.Dummy(integer=True, positive=True, prime=True).assumptions0
        shared = {name: {getattr(member, f"is_{name}") for member in where} for name in names}
        facts |= {name: next(iter(found)) for name, found in shared.items() if len(found) == 1}
    return facts


def find_excess(symbol: Any, facts: Facts) -> list[str]:
    """Name what SymPy is told of a symbol beyond the facts."""
    told = symbol.assumptions0
    return sorted(name for name, value in told.items() if value and not facts.get(name)) + sorted(
        f"not {name}" for name, value in told.items() if not value and facts.get(name) is not False
    )


def describe_excess(excess: list[str]) -> str:
    """Return the first few of what `find_excess` found."""
    return ", ".join(excess[:3]) + (", ..." if len(excess) > 3 else "")


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
