"""The facts that the derivation states about a quantity and that points are made from.

The region of a quantity is its domain as relations between arguments, and the doubles in it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.lab.sampling.zero_sets import Columns, ZeroSet, call
from mechproof.lab.ways import Arguments, Array
from mechproof.programs.argument_conditions import set_relations
from mechproof.record import Argument, PublishedSizes, Singular, Toleranced
from mechproof.record.relations import find_slack, is_comparison
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.set_values import COUNTS

# Points keep away from a computed limit by the amount that 64 roundings of the arguments move it:
# any nearer, no kernel can know which side it is on.
MARGIN = 64 * float(np.finfo(float).eps)
# Relative distance by which an approximate root on an edge may seem to lie outside.
ROUGHLY = 1e-9


@dataclass(frozen=True)
class Region:
    """Where the arguments may lie: their sets, and relations between them."""

    symbols: tuple[sp.Symbol, ...]
    domain: Domain

    @cached_property
    def relations(self) -> tuple[sp.Basic, ...]:
        """Return the deciding relations: ends of intervals, whole numbers, limits.

        Finite sets are left out, as they are given by their values.
        """
        own = set(self.symbols)
        sets = (r for s in self.symbols for r in set_relations(s, self.domain.set_of(s)))
        ends = (r for r in sets if isinstance(r, Relational) and not _is_endless(r))
        return (*ends, *(r for r in self.domain.where if r.free_symbols <= own))

    @cached_property
    def edges(self) -> tuple[sp.Expr, ...]:
        """Return expressions that are zero at ends of bounded intervals and at limits of relations.

        Zero is not an edge for a positive unbounded size: it is as far away as infinity.
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
        """Return the values of a symbol with a finite set; empty for any other symbol."""
        return self._values.get(symbol, [])

    @cached_property
    def _values(self) -> Mapping[sp.Symbol, list[float]]:
        sets = {s: self.domain.set_of(s) for s in self.symbols}
        return {s: [*map(float, v.args)] for s, v in sets.items() if v.is_FiniteSet}

    def is_discrete(self, symbol: sp.Symbol) -> bool:
        """Return whether the values of a symbol are isolated."""
        return self.is_count(symbol) or bool(self.list_values(symbol))

    def mark_inside(self, columns: Columns) -> Array:
        """Return a mask of the points that certainly lie inside, as doubles.

        An irrational end is rounded to a double; points keep the rounding margin from computed
        limits.
        """
        kept = self.mark_near(columns, MARGIN)
        computed = [r for r in self.relations if not is_comparison(r)]
        for index in np.flatnonzero(kept) if computed else ():
            point = {s: float(columns[s][index]) for s in self.symbols}
            kept[index] = all(balls.truth(relation, point) is True for relation in computed)
        return kept

    def mark_near(self, columns: Columns, margin: float = -ROUGHLY) -> Array:
        """Return a mask of points inside by a relative margin; a negative one admits others."""
        kept: Array = np.all([np.isfinite(columns[s]) for s in self.symbols], axis=0)
        for symbol, values in self._values.items():
            kept = kept & np.isin(columns[symbol], values)
        for relation in self.relations:
            kept = kept & _holds(relation, columns, margin)
        return kept


def _is_endless(relation: sp.Basic) -> bool:
    return any(side.is_infinite for side in relation.args)


def _holds(relation: sp.Basic, columns: Columns, margin: float) -> Array:
    """Return a mask of where a relation holds in doubles, with a margin if it is computed."""
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
    """Return how much relative changes of the arguments change a slack.

    This is the absolute condition number of Higham (2002, section 1.6), to first order.
    """
    symbols = sorted(slack.free_symbols, key=str)
    return sp.Add(*(sp.Abs(s * sp.diff(slack, s)) for s in symbols))


# Factor by which wide sizes may lie below and above the usual and published ones.
WIDE = 1e3
# A set that keeps fewer points than this in its domain says nothing.
FEWEST = 16


@dataclass(frozen=True)
class Facts:
    """Arguments with their usual sizes, their domain, singular places and published sizes.

    `share` is the part of every set that is drawn.
    """

    arguments: tuple[Argument, ...]
    domain: Domain
    singular: tuple[Singular, ...] = ()
    published: tuple[PublishedSizes, ...] = ()
    share: float = 1.0

    def part(self, count: int) -> int:
        """Return how many of `count` points are drawn: at least one."""
        return max(1, round(count * self.share))

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """Return the symbols of all arguments in order."""
        return tuple(symbol for argument in self.arguments for symbol in argument.symbols)

    @cached_property
    def region(self) -> Region:
        """Return the region in which the arguments may lie."""
        return Region(self.symbols, self.domain)

    @cached_property
    def usual(self) -> Mapping[sp.Symbol, tuple[float, ...]]:
        """Return the usual sizes of the symbols that have some."""
        return {s: a.usual for a in self.arguments for s in a.symbols if a.usual}

    @cached_property
    def printed(self) -> tuple[Mapping[sp.Symbol, Array], ...]:
        """Return the published sizes as doubles: nominal, lower and upper limit."""
        rows = [{s: v for s, v in p.sizes.items() if s in self.symbols} for p in self.published]
        return tuple({s: _list_limits(v) for s, v in row.items()} for row in rows if row)

    @cached_property
    def printed_anywhere(self) -> Mapping[sp.Symbol, Array]:
        """Return the published sizes of each symbol, from all rows together."""
        empty: Array = np.empty(0)
        return {
            s: np.concatenate([empty, *(row[s] for row in self.printed if s in row)])
            for s in self.symbols
        }

    @cached_property
    def singular_places(self) -> tuple[ZeroSet, ...]:
        """Return the singular places, as equations of the arguments.

        Raises ValueError for an equation that has no argument, or a symbol that is neither an
        argument nor an integer.
        """
        return tuple(self._place(row) for row in self.singular)

    def _place(self, row: Singular) -> ZeroSet:
        written_out = self.domain.resolve(row.equation)
        place = ZeroSet(written_out.lhs - written_out.rhs, row.text or str(row.equation))
        own, others = place.split(self.symbols)
        if not own or not all(s.is_integer for s in others):
            raise ValueError(
                f"singular set {row.equation}: {others} are neither arguments nor integers"
            )
        return place

    @cached_property
    def edges(self) -> tuple[ZeroSet, ...]:
        """Return the edges of the domain."""
        return tuple(ZeroSet(gap, f"edge {sp.Eq(gap, 0)}") for gap in self.region.edges)

    @cached_property
    def places(self) -> tuple[ZeroSet, ...]:
        """Return the singular places, then the edges that are not among them."""
        known = {place.gap for place in self.singular_places}
        others = [e for e in self.edges if e.gap not in known and -e.gap not in known]
        return (*self.singular_places, *others)

    @cached_property
    def own_places(self) -> Mapping[sp.Symbol, list[float]]:
        """Return the numbers at which a symbol is on a place whatever the other arguments are."""
        return {symbol: self._list_own_places(symbol) for symbol in self.symbols}

    def _list_own_places(self, symbol: sp.Symbol) -> list[float]:
        gaps = [sp.expand(p.gap) for p in self.places if p.gap.free_symbols == {symbol}]
        slopes = [(gap, sp.diff(gap, symbol)) for gap in gaps]
        return sorted(float(-gap.subs(symbol, 0) / s) for gap, s in slopes if s in (1, -1))

    def mark_in_reach(self, symbol: sp.Symbol, values: Array, *, recurring: bool) -> Array:
        """Return a mask of sizes that are not far beyond the usual and published ones.

        For places that recur endlessly, roots beyond the usual sizes are left out; other roots may
        follow the other arguments towards zero.
        """
        known = [size for size in self.printed_anywhere[symbol] if size]
        known += [edge for edge in self.usual.get(symbol, ()) if edge > 0]
        sizes = np.abs(known or [1.0])
        low, high = self.region.ends(symbol)
        # For a positive, unbounded size, zero is as far away as infinity.
        least = sizes.min() / WIDE if recurring and low == 0 and np.isinf(high) else 0.0
        most = sizes.max() * (1 if recurring else WIDE)
        inside: Array = (np.abs(values) >= least) & (np.abs(values) <= most)
        return inside

    def unpack(self, arguments: Arguments) -> Columns:
        """Return the values of every symbol, one for each point: the inverse of `pack`."""
        columns = [part for a in arguments for part in (a.T if a.ndim > 1 else [a])]
        return dict(zip(self.symbols, columns, strict=True))

    def pack(self, columns: Columns) -> Arguments:
        """Return the arguments, with components of vectors on the last axis."""
        grouped = ([columns[s] for s in a.symbols] for a in self.arguments)
        return tuple(g[0] if len(g) == 1 else np.stack(g, axis=-1) for g in grouped)


def _list_limits(size: sp.Expr | Toleranced) -> Array:
    if not isinstance(size, Toleranced):
        return np.array([float(size)])
    ends = (0, size.lower, size.upper)
    return np.array([*dict.fromkeys(float(size.nominal + end) for end in ends)])
