"""Region: the domain of a quantity as relations of its arguments, and the doubles inside it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.lab.sampling.roots import Columns, call
from mechproof.lab.ways import Array
from mechproof.programs.domain import set_relations
from mechproof.proof.domain import Domain

COUNTS = (sp.S.Naturals, sp.S.Naturals0)
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
        """Return the relations that decide: ends of intervals, whole numbers, limits."""
        own = set(self.symbols)
        sets = (r for s in self.symbols for r in set_relations(s, self.domain.set_of(s)))
        ends = (r for r in sets if not any(side.is_infinite for side in r.args))
        return (*ends, *(r for r in self.domain.where if r.free_symbols <= own))

    @cached_property
    def edges(self) -> tuple[sp.Expr, ...]:
        """Return what vanishes at the ends of bounded intervals and at the limits of relations.

        Zero is no edge of a size that is only positive: it is as far away as infinity.
        """
        unbounded = {s for s in self.symbols if not self.domain.set_of(s).sup.is_finite}
        limits = [r for r in self.relations if not isinstance(r, sp.Eq)]
        gaps = [
            r.gts - r.lts
            for r in limits
            if len(r.free_symbols) > 1 or not r.free_symbols & unbounded
        ]
        return tuple(dict.fromkeys(gaps))

    def ends(self, symbol: sp.Symbol) -> tuple[float, float]:
        """Return both ends of the set of a symbol as doubles."""
        values = self.domain.set_of(symbol)
        return float(values.inf), float(values.sup)

    def is_count(self, symbol: sp.Symbol) -> bool:
        """Return whether a symbol takes whole numbers only."""
        return self.domain.set_of(symbol) in COUNTS

    def mark_inside(self, columns: Columns) -> Array:
        """Mark the points that lie inside, as doubles and for certain.

        An irrational end is its double; from a computed limit they keep the margin of rounding.
        """
        kept = self.mark_near(columns, MARGIN)
        computed = [r for r in self.relations if not _is_comparison(r)]
        for index in np.flatnonzero(kept) if computed else ():
            point = {s: float(columns[s][index]) for s in self.symbols}
            kept[index] = all(balls.truth(relation, point) is True for relation in computed)
        return kept

    def mark_near(self, columns: Columns, margin: float = -ROUGHLY) -> Array:
        """Mark the points that are inside by a relative margin; a negative one lets some out."""
        kept: Array = np.all([np.isfinite(columns[s]) for s in self.symbols], axis=0)
        for relation in self.relations:
            kept = kept & _holds(relation, columns, margin)
        return kept


def _holds(relation: sp.Basic, columns: Columns, margin: float) -> Array:
    """Mark where a relation holds in doubles, by a margin where it is computed."""
    if isinstance(relation, sp.Eq):
        return np.asarray(call(relation.lhs, columns) == call(relation.rhs, columns))
    left, right = (call(side, columns) for side in (relation.gts, relation.lts))
    if _is_comparison(relation):
        strict = isinstance(relation, sp.StrictGreaterThan | sp.StrictLessThan) and margin > 0
        return np.asarray(left > right if strict else left >= right)
    with np.errstate(all="ignore"):
        return np.asarray(left - right > margin * call(_condition(relation), columns))


@lru_cache(maxsize=256)
def _condition(relation: sp.Basic) -> sp.Expr:
    """Return what relative changes of the arguments make of the gap between both sides."""
    gap = relation.gts - relation.lts
    return sp.Add(*(sp.Abs(s * sp.diff(gap, s)) for s in sorted(gap.free_symbols, key=str)))


def _is_comparison(relation: sp.Basic) -> bool:
    """Return whether no rounding decides a relation."""
    return all(map(is_plain, relation.args)) and not isinstance(relation, sp.Eq)


def is_plain(side: sp.Expr) -> bool:
    """Return whether a side of a relation is a number, a symbol, or the absolute value of one."""
    inner = side.args[0] if isinstance(side, sp.Abs) else side
    return bool(inner.is_Symbol or inner.is_number or isinstance(inner, sp.Indexed))
