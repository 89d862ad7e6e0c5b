"""Where a statement is meant to hold, and exact points inside it.

The points are those of Halton's sequence (1960), rational and the same each time: any number of
them is spread evenly, which random points are not.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import islice, product
from types import MappingProxyType

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.record import NUMBER, Dimension, Paper, Part, PublishedSizes, RecordError, Toleranced
from mechproof.record.memory import remember_last
from mechproof.record.parts import find_free, find_parts
from mechproof.record.substitution import resolve
from mechproof.statement_domains.dimension_inference import dimensions_of
from mechproof.statement_domains.narrowing import Values, leaves_values, search
from mechproof.statement_domains.set_values import (
    check_given,
    check_relation,
    check_set,
    contains,
    list_closed_ends,
    list_special_values,
    placing,
    radical_inverse,
)

Point = dict[sp.Basic, sp.Expr]
_Pairs = tuple[tuple[sp.Basic, sp.Expr], ...]
_NO_VALUES: Mapping[sp.Basic, sp.Expr] = MappingProxyType({})

_TRIES_PER_POINT = 60
# Ends the reason of a row whose letters have no values.
EMPTY = "is it empty?"
# Tries without a point after which a search begins; points that are enough from that search.
_BARREN = 80
_FEW = 12
# Angles that a reader would try first.
_ROUND_ANGLES = tuple(
    sp.pi * sp.Rational(degrees, 180) for degrees in (30, 45, 60, 90, 120, 150, 180, 270, 360)
)
_ROUND_ANGLES += tuple(-angle for angle in _ROUND_ANGLES)
# Points for each choice of sizes and angles, between which the other symbols vary.
_EACH = 3
# Characters of a name that only tell how it is typeset.
_SETTING = str.maketrans("", "", "\\{} ")


@dataclass(frozen=True)
class Domain:
    """Sets of the free symbols, relations between them, and symbols given by others.

    `published` and `usual` sizes and `dimensions` decide nothing: they only say at which points a
    difference is looked for first, and how it is shown.
    """

    within: Mapping[sp.Basic, sp.Set]
    where: tuple[sp.Basic, ...]
    given: Mapping[sp.Basic, sp.Expr]
    published: tuple[PublishedSizes, ...] = field(default=(), compare=False)
    dimensions: Mapping[sp.Basic, Dimension] = field(default_factory=dict, compare=False)
    usual: Mapping[sp.Basic, sp.Expr] = field(default_factory=dict, compare=False)

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        """Return a hash of names and relations alone, once: SymPy takes long to hash a set."""
        return hash((frozenset(self.within), self.where, frozenset(self.given)))

    @classmethod
    @remember_last(64)
    def of(cls, paper: Paper, on: Part | None = None, inside: Part | None = None) -> Domain:
        """Build the domain of a paper, with sets replaced by `on` and narrowed to `inside`.

        Raises `RecordError` for invalid sets, assumptions and relations, and if it is empty.
        """
        within = {v.symbol: v.within for v in paper.variables if v.given is None}
        given = paper.given
        parts = [part for part in (on, inside) if part]
        named = [(symbol, values) for part in parts for symbol, values in part.within.items()]
        for symbol, values in (*within.items(), *named):
            check_set(symbol, values)
        for symbol, definition in given.items():
            check_given(symbol, definition)
        for symbol in dict.fromkeys(symbol for symbol, _ in named if symbol in given):
            _make_free(symbol, within, given)
        within |= dict(on.within) if on else {}
        for symbol, values in inside.within.items() if inside else ():
            within[symbol] = within.get(symbol, sp.S.Reals).intersect(values)
        where = paper.list_relations(*parts)
        for relation in where:
            check_relation(relation, {*within, *given})
        domain = cls(within, (), given, paper.published, dimensions_of(paper), paper.usual)
        resolved = tuple(domain.resolve(relation) for relation in where)
        for relation, found in zip(where, resolved, strict=True):
            if found == sp.false:
                raise RecordError(f"the domain is empty: {relation} is always false")
        return replace(domain, where=tuple(r for r in resolved if r != sp.true))

    def resolve(self, expression: sp.Basic) -> sp.Basic:
        """Substitute the given symbols until only free ones are left."""
        return resolve(expression, self.given)

    def set_of(self, symbol: sp.Basic) -> sp.Set:
        """Return the set of a symbol (of its base, for an indexed one)."""
        base = symbol.base if isinstance(symbol, sp.Indexed) else symbol
        return self.within.get(base, sp.S.Reals)

    def with_set(self, symbol: sp.Basic, values: sp.Set) -> Domain:
        """Return the domain with this set for a symbol, and without the symbol's relations."""
        where = tuple(relation for relation in self.where if symbol not in relation.free_symbols)
        return replace(self, within={**self.within, symbol: values}, where=where)

    def allows(self, point: Point) -> bool:
        """Return whether a point violates no set and no relation in which it fixes all symbols."""
        relations = [r for r in self.where if find_free(r) <= point.keys()]
        inside = (contains(self.set_of(s), v) != sp.false for s, v in point.items())
        return all(inside) and _allowed(relations, point)

    def is_interior(self, point: Point) -> bool:
        """Return whether no value of the point is an end of its interval."""
        return not any(v in list_closed_ends(self.set_of(s)) for s, v in point.items())

    def points(
        self, symbols: list[sp.Basic], count: int, fixed: Values = _NO_VALUES
    ) -> list[Point]:
        """Return `count` exact interior points, then the corners of closed finite ends.

        All points have the `fixed` values. Raises `RecordError` if no point is found.
        """
        return [*_find_points(self, frozenset(symbols), count, tuple(fixed.items()))]

    def _find_points(self, symbols: frozenset[sp.Basic], count: int, given: _Pairs) -> list[Point]:
        fixed = dict(given)
        names, relations = self._connect({*symbols, *fixed}, fixed)
        ordered = sorted(names - fixed.keys(), key=_plain)
        wanted = count if ordered else 1
        walk = self._walk(ordered, wanted)
        first = self._complete(islice(walk, _BARREN), relations, fixed)
        interior = list(islice(first, wanted))
        if interior:
            rest = self._complete(walk, relations, fixed)
            interior += islice(rest, wanted - len(interior))
        if len(interior) < wanted:
            sets = {symbol: self.set_of(symbol) for symbol in ordered}
            few = min(wanted - len(interior), _FEW)
            found = self._complete(search(sets, relations, fixed, few), relations, fixed)
            interior += islice((point for point in found if point not in interior), few)
        if not interior:
            said = " and ".join(map(str, relations)) or "its sets"
            raise RecordError(f"no point found in the domain where {said}: {EMPTY}")
        corners = self._corners({s: interior[0][s] for s in ordered})
        return interior + list(self._complete(corners, relations, fixed))

    def _complete(
        self, points: Iterable[Point], relations: list[sp.Basic], fixed: Values
    ) -> Iterator[Point]:
        """Yield the points that satisfy all relations, with tied elements and the fixed values."""
        free = [relation for relation in relations if relation.args[0] not in fixed]
        tied = (_tie(free, {**fixed, **point}) for point in points)
        return (point for point in tied if _allowed(relations, point))

    def reaches(self, chosen: Point) -> bool:
        """Return whether a point with these values is found, including all symbols tied to them."""
        names, relations = self._connect(set(chosen), chosen)
        sets = {symbol: self.set_of(symbol) for symbol in names - chosen.keys()}
        if not relations:
            return True
        if not leaves_values(sets, relations, chosen):
            return False
        with suppress(RecordError):
            return bool(self.points(list(chosen), 1, chosen))
        return False

    def points_at(
        self, sizes: Values, symbols: list[sp.Basic], fixed: Values = _NO_VALUES
    ) -> Iterator[Point]:
        """Yield points at sizes and round angles; all other symbols get values inside their sets.

        Nothing is yielded if the domain excludes the sizes, or if there are no sizes and no angles.
        """
        names, _ = self._connect(set(symbols) | fixed.keys(), fixed)
        known = {s: value for s, value in sizes.items() if s in names}
        if not self.allows(known) or (sizes and not known):
            return
        for angles in self._round_angles(names - known.keys() - fixed.keys()):
            with suppress(ValueError):
                if known or angles:
                    yield from self.points(symbols, _EACH, {**fixed, **known, **angles})[:_EACH]

    def _round_angles(self, symbols: set[sp.Basic]) -> Iterator[Point]:
        """Yield different round angles for the angles among the symbols, {} if there are none."""
        free = sorted((s for s in symbols if self.dimension_of(s).is_angle), key=str)
        inside = {s: [a for a in _ROUND_ANGLES if contains(self.set_of(s), a)] for s in free}
        allowed = [(s, values) for s, values in inside.items() if values]
        for turn in range(max((len(values) for _, values in allowed), default=1)):
            yield {s: values[(turn + k) % len(values)] for k, (s, values) in enumerate(allowed)}

    def dimension_of(self, symbol: sp.Basic) -> Dimension:
        """Return the dimension of a symbol (of its base, for an indexed one)."""
        base = symbol.base if isinstance(symbol, sp.Indexed) else symbol
        return self.dimensions.get(base, NUMBER)

    def _connect(self, names: set[sp.Basic], fixed: Values) -> tuple[set[sp.Basic], list[sp.Basic]]:
        """Return the names with all symbols that relations tie to them, and these relations.

        Relations of families are taken for the elements whose indices are among the names.
        """
        indices = {k for s in names if isinstance(s, sp.Indexed) for k in s.indices}
        numbers = sorted(indices, key=sp.default_sort_key)
        stated = dict.fromkeys(r for whole in self.where for r in _write(whole, numbers, fixed))
        tied: list[sp.Basic] = []
        for _ in stated:
            tied = [relation for relation in stated if _symbols(relation) & names]
            names = names.union(*map(_symbols, tied))
        return names, tied

    def _walk(self, ordered: list[sp.Basic], count: int) -> Iterator[Point]:
        spread = [(s, placing(self.set_of(s)), sp.prime(k)) for k, s in enumerate(ordered, 1)]
        for step in range(1, 1 + count * (_TRIES_PER_POINT if self.where else 1)):
            yield {symbol: place(radical_inverse(step, p), step) for symbol, place, p in spread}

    def special_points(self, inside: Point, landmarks: Sequence[sp.Expr] = ()) -> list[Point]:
        """Return points that differ from an inner one by zero, one, fractions of a turn, or ends.

        With landmarks, also by these, one symbol at a time, counts included.
        """
        found = {s: list_special_values(self.set_of(s)) for s in inside if not s.is_integer}
        single = [{**inside, s: value} for s, values in found.items() for value in values]
        single += [
            {**inside, s: value}
            for s in inside
            for value in landmarks
            if contains(self.set_of(s), value) == sp.true
        ]
        longest = max(map(len, found.values()), default=0)
        joint = [
            {**inside, **{s: values[k % len(values)] for s, values in found.items() if values}}
            for k in range(longest)
        ]
        small = [[v for v in (sp.S.Zero, sp.S.One, -sp.S.One) if v in found[s]] for s in found]
        if 1 < len(small) <= 3:
            joint += [{**inside, **dict(zip(found, v, strict=True))} for v in product(*small)]
        counts = {s: value for s, value in inside.items() if s.is_integer}
        _, tied = self._connect(set(inside), counts)
        relations = [relation for relation in tied if _symbols(relation) <= inside.keys()]
        return list(self._complete(single + joint, relations, {}))

    def _corners(self, inside: Point) -> Iterator[Point]:
        ends = {symbol: list_closed_ends(self.set_of(symbol)) for symbol in inside}
        for symbol, values in ends.items():
            for value in values:
                yield {**inside, symbol: value}
        several = [s for s in ends if ends[s]]
        if 1 < len(several) <= 4:
            for corner in product(*(ends[s] for s in several)):
                yield {**inside, **dict(zip(several, corner, strict=True))}


# Cached, as all entries of a matrix, and all rungs of a proof, ask for the same points.
_find_points = lru_cache(maxsize=256)(Domain._find_points)


def sizes_of(published: PublishedSizes) -> Point:
    """Return the published sizes, nominal ones for those with limits."""
    return {
        symbol: size.nominal if isinstance(size, Toleranced) else sp.sympify(size)
        for symbol, size in published.sizes.items()
    }


def _make_free(
    symbol: sp.Basic, within: dict[sp.Basic, sp.Set], given: dict[sp.Basic, sp.Expr]
) -> None:
    """Turn x = g(phi, ...) into phi = h(x, ...), g being linear in the unrestricted phi."""
    definition = given.pop(symbol)
    for candidate in sorted(definition.free_symbols, key=str):
        slope = sp.diff(definition, candidate)
        if within.get(candidate) == sp.S.Reals and slope != 0 and not slope.has(candidate):
            rest = definition.subs(candidate, 0)
            given[candidate] = (symbol - rest) / slope
            del within[candidate]
            within[symbol] = sp.S.Reals
            return
    raise RecordError(f"{symbol} = {definition} cannot be solved for an unrestricted symbol")


@lru_cache(maxsize=512)
def _symbols(relation: sp.Basic) -> frozenset[sp.Basic]:
    """Return the elements and the symbols of a relation, without the labels of its elements."""
    items = find_parts(relation, sp.Indexed)
    labels = {item.base.label for item in items} | find_parts(relation, sp.IndexedBase)
    return frozenset(items | (find_free(relation) - labels))


def _write(relation: sp.Basic, numbers: list[sp.Basic], fixed: Values) -> Iterator[sp.Basic]:
    """Yield a relation for the elements of families with these indices, others unchanged."""
    if not relation.has(sp.Indexed):
        yield relation
        return
    written = relation
    if relation.has(sp.Sum):
        met = find_free(relation)
        written = _write_sums(relation, tuple((s, v) for s, v in fixed.items() if s in met))
    if written.has(sp.Sum):
        return
    free = {k for item in written.atoms(sp.Indexed) for k in item.indices if k.is_Symbol}
    for values in product(numbers, repeat=len(free)):
        one = written.xreplace(dict(zip(sorted(free, key=str), values, strict=True)))
        if one.atoms(sp.Indexed):
            yield one


@lru_cache(maxsize=512)
def _write_sums(relation: sp.Basic, fixed: _Pairs) -> sp.Basic:
    """Write out a relation's sums, cached, as every point of every row needs those of a domain."""
    return relation.subs(fixed).doit()


def _plain(symbol: sp.Basic) -> str:
    """Return a name without its typesetting, which must not affect values."""
    return str(symbol).translate(_SETTING)


def _tie(relations: list[sp.Basic], point: Point) -> Point:
    """Give elements on the left of an equation the values that it gives them."""
    for relation in relations:
        if isinstance(relation, sp.Eq) and relation.lhs in point:
            point = {**point, relation.lhs: relation.rhs.xreplace(point)}
    return point


def _allowed(relations: list[sp.Basic], point: Point) -> bool:
    return all(
        # Exactly equal fractions, which balls cannot show to be equal.
        (isinstance(relation, sp.Eq) and relation.xreplace(point) == sp.true)
        or balls.truth(relation, point) is True
        for relation in relations
    )
