"""Where a statement is meant to hold, and exact points inside it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, product

import sympy as sp

from mechproof.proof import balls
from mechproof.record import Paper, Part

Point = dict[sp.Basic, sp.Rational]

_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71)
_TRIES_PER_POINT = 60


@dataclass(frozen=True)
class Domain:
    """Sets of the free symbols, relations between them, and symbols given by others."""

    within: Mapping[sp.Basic, sp.Set]
    where: tuple[sp.Basic, ...]
    given: Mapping[sp.Basic, sp.Expr]

    @classmethod
    def of(cls, paper: Paper, part: Part | None = None) -> Domain:
        """Build the domain of a paper, narrowed to a part."""
        within = {v.symbol: v.within for v in paper.variables if v.given is None}
        given = {v.symbol: v.given for v in paper.variables if v.given is not None}
        narrowed = dict(part.within) if part else {}
        for symbol in [s for s in narrowed if s in given]:
            _make_free(symbol, within, given)
        within |= narrowed
        where = paper.where + (part.where if part else ())
        domain = cls(within, (), given)
        return cls(within, tuple(domain.resolve(relation) for relation in where), given)

    def resolve(self, expression: sp.Basic) -> sp.Basic:
        """Substitute the given symbols until only free ones are left."""
        for _ in range(len(self.given) + 1):
            found = expression.free_symbols & self.given.keys()
            if not found:
                return expression
            replacement = {symbol: self.given[symbol] for symbol in found}
            expression = expression.subs(replacement, simultaneous=True)
        raise ValueError(f"symbols are given in a circle: {sorted(map(str, found))}")

    def set_of(self, symbol: sp.Basic) -> sp.Set:
        """Return the set of a symbol (of its base, for an indexed one)."""
        base = symbol.base if isinstance(symbol, sp.Indexed) else symbol
        return self.within.get(base, sp.S.Reals)

    def points(self, symbols: list[sp.Basic], count: int) -> list[Point]:
        """Return `count` exact interior points, then the corners of closed finite ends."""
        relations = [r for r in self.where if r.free_symbols & set(symbols)]
        names = {s for relation in relations for s in relation.free_symbols} | set(symbols)
        ordered = sorted(names, key=str)
        inside = (point for point in self._walk(ordered, count) if _allowed(relations, point))
        interior = list(islice(inside, count))
        if not interior:
            raise ValueError(f"no point found in the domain of {[str(s) for s in ordered]}")
        return interior + [p for p in self._corners(interior[0]) if _allowed(relations, p)]

    def _walk(self, ordered: list[sp.Basic], count: int) -> Iterator[Point]:
        tries = count * (_TRIES_PER_POINT if self.where else 1)
        for step in range(1, tries + 1):
            yield {
                symbol: _place(self.set_of(symbol), _radical_inverse(step, _PRIMES[k % 20]), step)
                for k, symbol in enumerate(ordered)
            }

    def _corners(self, inside: Point) -> Iterator[Point]:
        ends = {symbol: _closed_ends(self.set_of(symbol)) for symbol in inside}
        for symbol, values in ends.items():
            for value in values:
                yield {**inside, symbol: value}
        several = [s for s in ends if ends[s]]
        if 1 < len(several) <= 4:
            for corner in product(*(ends[s] for s in several)):
                yield {**inside, **dict(zip(several, corner, strict=True))}


def _make_free(
    symbol: sp.Basic, within: dict[sp.Basic, sp.Set], given: dict[sp.Basic, sp.Expr]
) -> None:
    """Turn x = g(phi, ...) round into phi = h(x, ...), phi being linear in g and unrestricted."""
    definition = given.pop(symbol)
    for candidate in sorted(definition.free_symbols, key=str):
        slope = sp.diff(definition, candidate)
        if within.get(candidate) == sp.S.Reals and slope != 0 and not slope.has(candidate):
            rest = definition.subs(candidate, 0)
            given[candidate] = (symbol - rest) / slope
            del within[candidate]
            within[symbol] = sp.S.Reals
            return
    raise ValueError(f"{symbol} = {definition} cannot be solved for an unrestricted symbol")


def _allowed(relations: list[sp.Basic], point: Point) -> bool:
    return all(balls.truth(relation, point) is True for relation in relations)


def _radical_inverse(step: int, base: int) -> sp.Rational:
    numerator, denominator = 0, 1
    while step:
        step, digit = divmod(step, base)
        numerator, denominator = numerator * base + digit, denominator * base
    return sp.Rational(numerator, denominator)


def _place(where: sp.Set, u: sp.Rational, step: int) -> sp.Rational:
    """Map u in (0, 1) into the set; the odds of the whole line are spread over several turns."""
    if where in (sp.S.Naturals, sp.S.Naturals0):
        return sp.Integer(1 + step % 4)
    low, high = where.inf, where.sup
    if low.is_infinite and high.is_infinite:
        return (2 * u - 1) / (u * (1 - u)) if u != sp.Rational(1, 2) else sp.Rational(3, 4)
    if high.is_infinite:
        return _rational(low, above=True) + 4 * u / (1 - u)
    if low.is_infinite:
        return _rational(high, above=False) - 4 * (1 - u) / u
    bottom, top = _rational(low, above=True), _rational(high, above=False)
    return bottom + (top - bottom) * u


def _rational(end: sp.Expr, above: bool) -> sp.Rational:
    """Return an end of an interval, or a rational just inside it where the end is irrational."""
    if end.is_Rational:
        return sp.Rational(end)
    return sp.Rational(int(sp.floor(end * 1000)) + int(above), 1000)


def _closed_ends(where: sp.Set) -> list[sp.Rational]:
    if not isinstance(where, sp.Interval):
        return []
    ends = ((where.start, where.left_open), (where.end, where.right_open))
    return [sp.Rational(end) for end, is_open in ends if not is_open and end.is_Rational]
