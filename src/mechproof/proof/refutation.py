"""Rung: a counterexample whose balls separate both sides; and the weaker enclosure."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice, permutations

import sympy as sp

from mechproof.proof import balls
from mechproof.proof.domain import Domain, Point
from mechproof.proof.verdict import Evidence

POINTS = 40
PRECISIONS = (64, 192)
_LARGEST_COUNT = 12


@dataclass(frozen=True)
class Comparison:
    """Two expressions at the points of a domain."""

    counterexample: Evidence | None
    agreeing: int
    undecided: int
    widest: str
    undefined: str = ""


def compare(
    printed: sp.Basic,
    rebuilt: sp.Basic,
    domain: Domain,
    count: int = POINTS,
    precisions: tuple[int, ...] = PRECISIONS,
) -> Comparison:
    """Look for a point at which the balls of both sides are disjoint."""
    agreeing = undecided = 0
    undefined = ""
    widest = balls.to_ball(0)
    for point in points_for((printed, rebuilt), domain, count):
        left, right, decided = _enclose_both(printed, rebuilt, point, precisions)
        if decided == "apart":
            return Comparison(_describe(point, left, right), agreeing, undecided, "")
        agreeing += decided == "together"
        undecided += decided == "open"
        one_has_a_value = left.is_finite() != right.is_finite()
        if one_has_a_value and not undefined and domain.is_interior(point):
            undefined = ", ".join(f"{name} = {value}" for name, value in _texts(point).items())
        if decided == "together":
            widest = widest.max((left - right).abs_upper())
    undefined = undefined or ("" if agreeing else "any point tried")
    return Comparison(None, agreeing, undecided, balls.show(widest, 3), undefined)


def find_violation(relation: sp.Basic, domain: Domain, count: int = POINTS) -> Evidence | None:
    """Return a point at which the relation is certainly false, if one is found."""
    for point in points_for((relation,), domain, count):
        if balls.truth(relation, point, 256) is False:
            sides = [s for r in _relations(relation) for s in r.args]
            values = [balls.show(balls.evaluate(_expand(s, point), point)) for s in sides]
            return Evidence(f"{relation} is false", _texts(point), *values[:2])
    return None


def points_for(expressions: tuple[sp.Basic, ...], domain: Domain, count: int) -> list[Point]:
    """Return points that give every symbol of the expressions a value, indexed ones included."""
    counts = sorted(
        {s for e in expressions for s in e.free_symbols if s.is_Symbol and s.is_integer}, key=str
    )
    symbols = {s for e in expressions for s in e.free_symbols if isinstance(s, sp.Symbol)}
    bases = {i.base.label for e in expressions for i in e.atoms(sp.Indexed)}
    plain = sorted(symbols - bases, key=str)
    result: list[Point] = []
    for sizes in _choose_counts(counts, domain):
        indexed = {i for e in expressions for i in _expand(e, sizes).atoms(sp.Indexed)}
        free = [s for s in plain if s not in sizes] + sorted(indexed, key=str)
        result += domain.points(free, count, sizes) if free else [sizes]
    return result


def _choose_counts(counts: list[sp.Basic], domain: Domain) -> list[Point]:
    """Return the two smallest choices of unlike counts that the domain allows."""
    if not counts:
        return [{}]
    choices = (
        dict(zip(counts, map(sp.Integer, values), strict=True))
        for start in range(2, _LARGEST_COUNT)
        for values in permutations(range(start, start + len(counts)))
    )
    return list(islice((sizes for sizes in choices if domain.allows(sizes)), 2))


def _expand(expression: sp.Basic, sizes: Point) -> sp.Basic:
    """Write sums with a numeric count out, so that their indexed symbols appear."""
    if not expression.has(sp.Sum):
        return expression
    counts = {s: v for s, v in sizes.items() if isinstance(s, sp.Symbol) and s.is_integer}
    return expression.subs(counts).doit()


def _enclose_both(
    printed: sp.Basic, rebuilt: sp.Basic, point: Point, precisions: tuple[int, ...]
) -> tuple[balls.Ball, balls.Ball, str]:
    printed, rebuilt = (_expand(side, point) for side in (printed, rebuilt))
    decided = "open"
    for bits in precisions:
        left, right = (balls.evaluate(side, point, bits) for side in (printed, rebuilt))
        if left.is_finite() and right.is_finite():
            if not left.overlaps(right):
                return left, right, "apart"
            decided = "together"
    return left, right, decided


def _describe(point: Point, left: balls.Ball, right: balls.Ball) -> Evidence:
    return Evidence("both sides as balls", _texts(point), balls.show(left), balls.show(right))


def _texts(point: Point) -> dict[str, str]:
    return {str(symbol): str(value) for symbol, value in sorted(point.items(), key=_by_name)}


def _by_name(item: tuple[sp.Basic, sp.Basic]) -> str:
    return str(item[0])


def _relations(relation: sp.Basic) -> list[sp.Basic]:
    return sorted(relation.atoms(sp.core.relational.Relational), key=str)
