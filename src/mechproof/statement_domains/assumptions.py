"""What SymPy may be told of a symbol: no more than follows from its set, or from its limits.

SymPy uses assumptions while an expression is built, so that one too many cannot be taken back.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import sympy as sp

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
