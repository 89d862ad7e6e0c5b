"""Search for points of narrow domains: each chosen value narrows the ranges of the others.

Linear relations narrow the range of each symbol by those of the others, as in the propagation of
bounds in constraint programming (Davis 1987); where only one symbol of a relation is left, so do
the roots of a polynomial. The results are proposals: the caller has to decide whether all relations
hold there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import sympy as sp

from mechproof.record.relations import find_slack
from mechproof.statement_domains.set_values import COUNTS, place, radical_inverse

Values = Mapping[sp.Basic, sp.Expr]
# Work limit: relations that form a circle could narrow for ever.
_ROUNDS = 12
# Different starts after which a search without a result is given up.
_STARTS = 24


@dataclass(frozen=True)
class _Range:
    """The least and the largest value left for a symbol, and whether these are excluded."""

    low: sp.Expr
    high: sp.Expr
    low_open: bool = False
    high_open: bool = False

    @classmethod
    def of(cls, where: sp.Set) -> _Range:
        opens = (where.left_open, where.right_open) if isinstance(where, sp.Interval) else ()
        return cls(where.inf, where.sup, *map(bool, opens))

    @property
    def is_empty(self) -> bool:
        at_end = self.low == self.high and (self.low_open or self.high_open)
        return bool(self.low > self.high) or at_end

    def end_above(self, end: sp.Expr, is_open: bool) -> _Range:
        if self.high < end or (self.high == end and self.high_open >= is_open):
            return self
        return replace(self, high=end, high_open=is_open)

    def end_below(self, end: sp.Expr, is_open: bool) -> _Range:
        if self.low > end or (self.low == end and self.low_open >= is_open):
            return self
        return replace(self, low=end, low_open=is_open)

    def within(self, where: sp.Set) -> sp.Set:
        return where.intersect(sp.Interval(self.low, self.high, self.low_open, self.high_open))


Ranges = dict[sp.Basic, _Range]


@dataclass(frozen=True)
class _Gap:
    """The number that a relation makes positive, or non-negative; its factors if it is linear."""

    size: sp.Expr
    strict: bool
    factors: Mapping[sp.Basic, sp.Expr]
    constant: sp.Expr


def search(
    sets: Mapping[sp.Basic, sp.Set], relations: Sequence[sp.Basic], fixed: Values, wanted: int
) -> Iterator[dict[sp.Basic, sp.Expr]]:
    """Yield points that may lie in the domain; each symbol in turn is chosen first."""
    gaps = [gap for relation in relations for gap in _list_gaps(relation)]
    names = sorted(sets.keys() - fixed.keys(), key=str)
    start = _narrow({**_ranges(sets), **_ranges(_single(fixed))}, gaps)
    found = 0
    for step in range(1, (_STARTS + 2 * wanted) * (start is not None) + 1):
        turn = step % max(len(names), 1)
        point = _choose(names[turn:] + names[:turn], sets, gaps, dict(fixed), start or {}, step)
        found += point is not None
        if point is not None:
            yield point
        elif step >= _STARTS and not found:
            return


def leaves_values(
    sets: Mapping[sp.Basic, sp.Set], relations: Sequence[sp.Basic], chosen: Values
) -> bool:
    """Return whether narrowing leaves values for each symbol once some are chosen.

    Values are removed by exact arithmetic: if none are left, the domain is empty.
    """
    gaps = [gap for relation in relations for gap in _list_gaps(relation)]
    return _narrow({**_ranges(sets), **_ranges(_single(chosen))}, gaps) is not None


def _choose(
    names: Sequence[sp.Basic],
    sets: Mapping[sp.Basic, sp.Set],
    gaps: Sequence[_Gap],
    point: dict[sp.Basic, sp.Expr],
    ranges: Ranges,
    step: int,
) -> dict[sp.Basic, sp.Expr] | None:
    left: Ranges | None = ranges
    for number, symbol in enumerate(names, start=1):
        if left is None:
            return None
        where = left[symbol].within(sets[symbol])
        for gap in gaps:
            if gap.size.free_symbols - point.keys() == {symbol}:
                where = where.intersect(_where_positive(gap, symbol, point))
        if where.is_empty or not isinstance(where, _PLACED):
            return None
        value = place(_part_of(where, step), radical_inverse(step, sp.prime(number)), step)
        point[symbol] = value
        met = [gap for gap in gaps if symbol in gap.factors]
        left = _narrow({**left, symbol: _Range(value, value)}, gaps, met)
    return point if left is not None else None


_PLACED = (sp.Interval, sp.FiniteSet, sp.Range, sp.Union, *map(type, COUNTS))


def _ranges(sets: Mapping[sp.Basic, sp.Set]) -> Ranges:
    return {symbol: _Range.of(where) for symbol, where in sets.items()}


def _single(values: Values) -> dict[sp.Basic, sp.Set]:
    return {symbol: sp.FiniteSet(value) for symbol, value in values.items()}


def _list_gaps(relation: sp.Basic) -> list[_Gap]:
    if slack := find_slack(relation):
        return [_take_apart(*slack)]
    if isinstance(relation, sp.Equality):
        size = relation.lhs - relation.rhs
        return [_take_apart(sign * size, False) for sign in (1, -1)]
    if isinstance(relation, sp.And):
        return [gap for part in relation.args for gap in _list_gaps(part)]
    return []


def _take_apart(size: sp.Expr, strict: bool) -> _Gap:
    symbols = sorted(size.free_symbols | size.atoms(sp.Indexed), key=str)
    factors = {s: sp.expand(size).coeff(s) for s in symbols}
    constant = sp.expand(size - sum(factor * s for s, factor in factors.items()))
    is_linear = constant.is_Rational and all(f.is_Rational for f in factors.values())
    used = {s: f for s, f in factors.items() if f != 0}
    return _Gap(size, strict, used if is_linear else {}, constant)


def _narrow(
    ranges: Ranges, gaps: Sequence[_Gap], first: Sequence[_Gap] | None = None
) -> Ranges | None:
    """Return the ranges narrowed by linear relations, or None if one becomes empty."""
    waiting = list(gaps if first is None else first)
    for _ in range(_ROUNDS * len(gaps)):
        if not waiting:
            break
        gap = waiting.pop(0)
        changed = dict(_narrow_by(gap, ranges))
        if any(found.is_empty for found in changed.values()):
            return None
        ranges = {**ranges, **changed}
        waiting += [
            other
            for other in gaps
            if changed.keys() & other.factors.keys() and other not in waiting
        ]
    return ranges


def _narrow_by(gap: _Gap, ranges: Ranges) -> Iterator[tuple[sp.Basic, _Range]]:
    """Yield each range that a linear relation narrows even at the other symbols' best values."""
    for symbol, factor in gap.factors.items():
        others = [(f, ranges[s]) for s, f in gap.factors.items() if s != symbol]
        most = gap.constant + sum(f * (r.high if f > 0 else r.low) for f, r in others)
        if not most.is_Rational:
            continue
        is_open = gap.strict or any(r.high_open if f > 0 else r.low_open for f, r in others)
        turn = _Range.end_below if factor > 0 else _Range.end_above
        found = turn(ranges[symbol], -most / factor, is_open)
        if found != ranges[symbol]:
            yield symbol, found


def _where_positive(gap: _Gap, symbol: sp.Basic, point: Values) -> sp.Set:
    """Return where a polynomial in one symbol is positive, or zero at a rational number."""
    size = gap.size.xreplace(dict(point))
    polynomial = sp.Poly(size, symbol) if size.is_polynomial(symbol) else None
    if polynomial is None or not all(c.is_Rational for c in polynomial.coeffs()):
        return sp.S.Reals
    roots = list(dict.fromkeys(polynomial.real_roots())) if polynomial.degree() > 0 else []
    parts = [
        sp.Interval.open(low, high)
        for low, high in pairwise([-sp.oo, *roots, sp.oo])
        if polynomial.eval(place(sp.Interval.open(low, high), sp.S.Half, 1)) > 0
    ]
    reached = [] if gap.strict else [root for root in roots if root.is_Rational]
    return sp.Union(*parts, sp.FiniteSet(*reached))


def _part_of(where: sp.Set, step: int) -> sp.Set:
    """Return one of the parts of a set, each in turn."""
    parts = where.args if isinstance(where, sp.Union) else (where,)
    return parts[step % len(parts)]
