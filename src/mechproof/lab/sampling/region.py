"""Region: the domain of a quantity as relations of its arguments, and the doubles inside it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.lab.sampling.zero_sets import Columns, call
from mechproof.lab.ways import Array
from mechproof.programs.argument_conditions import set_relations
from mechproof.record.relations import find_slack, is_comparison
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.set_values import COUNTS

# A computed limit is kept away from by what so many roundings of the arguments move it: nearer,
# no kernel can know on which side it is.
MARGIN = 64 * float(np.finfo(float).eps)
# How far outside an approximate root on an edge may seem to be.
ROUGHLY = 1e-9


@dataclass(frozen=True)
class Region:
    """Where the arguments may lie: their sets, and relations between them."""

    symbols: tuple[sp.Symbol, ...]
    domain: Domain

    @cached_property
    def relations(self) -> tuple[sp.Basic, ...]:
        """Return the relations that decide: ends of intervals, whole numbers, limits.

        Those of finite sets are values.
        """
        own = set(self.symbols)
        sets = (r for s in self.symbols for r in set_relations(s, self.domain.set_of(s)))
        ends = (r for r in sets if isinstance(r, Relational) and not _is_endless(r))
        return (*ends, *(r for r in self.domain.where if r.free_symbols <= own))

    @cached_property
    def edges(self) -> tuple[sp.Expr, ...]:
        """Return what vanishes at the ends of bounded intervals and at the limits of relations.

        Zero is no edge of a size that is only positive: it is as far away as infinity.
        """
        unbounded = {s for s in self.symbols if not self.domain.set_of(s).sup.is_finite}
        slacks = filter(None, map(find_slack, self.relations))
        vanishing = [
            slack.value
            for slack in slacks
            if len(slack.value.free_symbols) > 1 or not slack.value.free_symbols & unbounded
        ]
        return tuple(dict.fromkeys(vanishing))

    def ends(self, symbol: sp.Symbol) -> tuple[float, float]:
        """Return both ends of the set of a symbol as doubles."""
        return self._ends[symbol]

    @cached_property
    def _ends(self) -> Mapping[sp.Symbol, tuple[float, float]]:
        sets = {s: self.domain.set_of(s) for s in self.symbols}
        return {s: (float(values.inf), float(values.sup)) for s, values in sets.items()}

    def is_count(self, symbol: sp.Symbol) -> bool:
        """Return whether a symbol takes whole numbers only."""
        return self.domain.set_of(symbol) in COUNTS

    def list_values(self, symbol: sp.Symbol) -> list[float]:
        """List the values of a symbol that has so many, none for any other."""
        return self._values.get(symbol, [])

    @cached_property
    def _values(self) -> Mapping[sp.Symbol, list[float]]:
        sets = {s: self.domain.set_of(s) for s in self.symbols}
        return {s: [*map(float, v.args)] for s, v in sets.items() if v.is_FiniteSet}

    def is_discrete(self, symbol: sp.Symbol) -> bool:
        """Return whether next to a value of a symbol there is no other."""
        return self.is_count(symbol) or bool(self.list_values(symbol))

    def mark_inside(self, columns: Columns) -> Array:
        """Mark the points that lie inside, as doubles and for certain.

        An irrational end is its double; from a computed limit they keep the margin of rounding.
        """
        kept = self.mark_near(columns, MARGIN)
        computed = [r for r in self.relations if not is_comparison(r)]
        for index in np.flatnonzero(kept) if computed else ():
            point = {s: float(columns[s][index]) for s in self.symbols}
            kept[index] = all(balls.truth(relation, point) is True for relation in computed)
        return kept

    def mark_near(self, columns: Columns, margin: float = -ROUGHLY) -> Array:
        """Mark the points that are inside by a relative margin; a negative one lets some out."""
        kept: Array = np.all([np.isfinite(columns[s]) for s in self.symbols], axis=0)
        for symbol, values in self._values.items():
            kept = kept & np.isin(columns[symbol], values)
        for relation in self.relations:
            kept = kept & _holds(relation, columns, margin)
        return kept


def _is_endless(relation: sp.Basic) -> bool:
    return any(side.is_infinite for side in relation.args)


def _holds(relation: sp.Basic, columns: Columns, margin: float) -> Array:
    """Mark where a relation holds in doubles, by a margin where it is computed."""
    slack = find_slack(relation)
    if slack is None:
        return np.asarray(call(relation.lhs, columns) == call(relation.rhs, columns))
    greater, smaller = (call(side, columns) for side in (relation.gts, relation.lts))
    if is_comparison(relation):
        leaves_edge = slack.strict and margin > 0
        return np.asarray(greater > smaller if leaves_edge else greater >= smaller)
    with np.errstate(all="ignore"):
        return np.asarray(greater - smaller > margin * call(_condition(slack.value), columns))


@lru_cache(maxsize=256)
def _condition(slack: sp.Expr) -> sp.Expr:
    """Return by how much relative changes of the arguments change a slack.

    It is the absolute condition number of Higham (2002, section 1.6), to the first order.
    """
    symbols = sorted(slack.free_symbols, key=str)
    return sp.Add(*(sp.Abs(s * sp.diff(slack, s)) for s in symbols))
