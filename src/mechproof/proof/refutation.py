"""Rung: a counterexample whose balls separate both sides; and the weaker enclosure.

Zippel (1979) and Schwartz (1980) try identities at points and bound the probability that a false
polynomial identity passes. No such bound is claimed here, where functions need not be polynomials:
a point at which the balls are disjoint refutes; points at which they meet prove nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

import sympy as sp
from flint import arb
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFunction

from mechproof.arithmetic import balls
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.counts import choose_counts, is_count
from mechproof.proof.verdict import Evidence
from mechproof.proof.witness_text import describe, show_point
from mechproof.record import NthDerivative
from mechproof.record.exactness import RecordError
from mechproof.record.parts import find_free, find_parts, has_parts
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain, Point, sizes_of

BALLS = "separating balls"
POINTS = 40
EVERY_POINT = "every point tried"
# Numbers of points where each takes long, and where finding that a value is missing takes long.
FEW, FEWEST = 10, 4
PRECISIONS = (64, 192, 512)
# A first look, to refute false statements early; numbers are computed fast, so they get more bits.
_FIRST_POINTS, _FIRST_PRECISIONS, _PRECISIONS_OF_NUMBERS = 2, (64,), (64, 2048)
# Choices of counts that are tried; more in a thorough search.
_CHOICES = 3
_MORE_CHOICES = 14
# Statements that hold near zero may fail far away, or beyond the numbers that they name, if these
# are larger than the first landmark.
_FIRST_LANDMARK = 5
_FAR = (sp.Integer(10) ** 6, sp.Integer(10) ** 15)
_NEAR = (sp.Rational(1, 10**3), sp.Rational(1, 10**6))
# Longest relation, in characters, that is quoted in full.
_LONGEST_RELATION = 120
# Expressions that are written out for each value of their counts.
# An index may contain a count: for n = 2 the element with the index n + 1 is the third.
COUNTED = (sp.Sum, sp.Product, NthDerivative, sp.Indexed)
_STEPS = (sp.floor, sp.ceiling, sp.Mod)
# Balls wider than this do not show how close two sides are.
_NARROW = arb(2) ** -32


@dataclass(frozen=True)
class Comparison:
    """How two expressions compare at points of a domain, with the widest distance met."""

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
    has_integrals = has_parts(printed, sp.Integral) or has_parts(rebuilt, sp.Integral)
    for point in points_for((printed, rebuilt), domain, count, thorough=count == POINTS):
        # Integrals take long: give up if points keep failing, and use few bits once enough agree.
        if has_integrals and undecided >= FEWEST:
            break
        if has_integrals and agreeing >= FEWEST:
            precisions = precisions[:1]
        left, right, decided = _enclose_both(
            printed, rebuilt, point, precisions, gives_up=has_integrals
        )
        if decided == "apart":
            sides, values = (printed, rebuilt), (left, right)
            found = describe("the two sides", sides, values, point, domain)
            return Comparison(found, agreeing, undecided, "")
        agreeing += decided == "together"
        undecided += decided == "open"
        one_has_a_value = left.is_finite() != right.is_finite()
        if one_has_a_value and not undefined and domain.is_interior(point):
            undefined = name_point(point, domain)
        if decided == "together":
            widest = widest.max((left - right).abs_upper())
    undefined = undefined or ("" if agreeing else EVERY_POINT)
    # An absolute distance of 1 or more says nothing about how close large numbers are.
    shown = balls.show(widest, 3) if widest < 1 else ""
    return Comparison(None, agreeing, undecided, shown, undefined)


def are_seen_to_differ(sides: Sequence[sp.Expr], domain: Domain) -> bool:
    """Return whether sides differ at one of the first points, so slow rungs can be skipped."""
    one, other = sides
    is_number = not any(side.free_symbols or side.has(sp.Integral) for side in sides)
    precisions = _PRECISIONS_OF_NUMBERS if is_number else _FIRST_PRECISIONS
    # If no point of the domain is found, nothing is known yet.
    with suppress(RecordError, NotImplementedError):
        return compare(one, other, domain, _FIRST_POINTS, precisions).counterexample is not None
    return False


def find_violation(relation: sp.Basic, domain: Domain) -> Evidence | None:
    """Return a point at which the relation is certainly false, if one is found."""
    # Integrals over long intervals take long.
    is_thorough = not has_parts(relation, sp.Integral)
    for point in points_for((relation,), domain, POINTS, thorough=is_thorough):
        if balls.truth(put_exactly(relation, point), point, 256) is False:
            first, second, *_ = min(relation.atoms(Relational), key=str).args
            left, right = (
                balls.evaluate(put_exactly(s, point), point, 256) for s in (first, second)
            )
            what = f"{_name_relation(relation)} is false"
            return describe(what, (first, second), (left, right), point, domain)
    return None


def points_for(
    expressions: tuple[sp.Basic, ...], domain: Domain, count: int, thorough: bool = False
) -> Iterator[Point]:
    """Yield points that give every symbol of the expressions a value, indexed ones included.

    A thorough search tries published sizes and round angles first, then more counts, and special
    points last. Raises `RecordError` if no point of the domain is found.
    """
    plain, counts = list_letters(expressions, domain)
    if thorough:
        yield from _published_points(expressions, counts, plain, domain)
    number = _MORE_CHOICES if thorough else _CHOICES
    special: list[Point] = []
    for sizes in choose_counts(counts, domain, number):
        points = domain.points([*plain, *list_elements(expressions, sizes)], count, sizes)
        yield from points
        if thorough and not special:
            special += domain.special_points(points[0], _list_landmarks(expressions))
    yield from special


def list_letters(
    expressions: Sequence[sp.Basic], domain: Domain
) -> tuple[list[sp.Basic], list[sp.Basic]]:
    """List the letters that are not families, with those that are counts separately."""
    free = {s for e in expressions for s in find_free(e)}
    bases = {i.base.label for e in expressions for i in find_parts(e, sp.Indexed)}
    symbols = {s for s in free if isinstance(s, sp.Symbol)} - bases
    counts = sorted((s for s in symbols if is_count(s, domain)), key=str)
    return sorted(symbols - set(counts), key=str), counts


def _list_landmarks(expressions: tuple[sp.Basic, ...]) -> list[sp.Expr]:
    """List numbers near zero, far away, and at and beyond the large ones that expressions name.

    Return nothing if counts set numbers of terms or elements.
    """
    if any(has_parts(e, *COUNTED) for e in expressions):
        return []
    named = {abs(c) for e in expressions for c in e.atoms(sp.Rational) if abs(c) > _FIRST_LANDMARK}
    sizes = [*_NEAR, *(f * c for c in (*sorted(named), *_FAR) for f in (1, 2))]
    return [sign * size for size in sizes for sign in (1, -1)]


@lru_cache(maxsize=64)
def refuse_empty(domain: Domain) -> None:
    """Raise `RecordError` if no point is found that satisfies a relation of the domain."""
    for relation in domain.where:
        numbers = {k for item in relation.atoms(sp.Indexed) for k in item.indices}
        first = dict.fromkeys(numbers & relation.free_symbols, sp.S.One)
        next(points_for((substitute(relation, first),), domain, 1))


def _published_points(
    expressions: tuple[sp.Basic, ...], counts: list[sp.Basic], plain: list[sp.Basic], domain: Domain
) -> Iterator[Point]:
    """Yield points at the published sizes that the domain allows, then at round angles alone.

    Where usual sizes exist, points with these for symbols without a published size come first.
    """
    usual = {s: v for s, v in domain.usual.items() if s in {*counts, *plain}}
    published: list[Point] = [*map(sizes_of, domain.published), {}]
    for sizes in (*({**usual, **p} for p in published if usual), *published):
        for others in islice(choose_counts([s for s in counts if s not in sizes], domain, 1), 1):
            elements = list_elements(expressions, {**others, **sizes})
            yield from domain.points_at(sizes, [*plain, *counts, *elements], others)


def list_elements(expressions: tuple[sp.Basic, ...], sizes: Point) -> list[sp.Basic]:
    """List the elements of families that appear once counts have their sizes."""
    families = (e for e in expressions if find_parts(e, sp.Indexed))
    elements = {i for e in families for i in find_parts(put_exactly(e, sizes), sp.Indexed)}
    return sorted(elements, key=str)


def put_exactly(expression: sp.Basic, point: Point) -> sp.Basic:
    """Put in the values that no ball holds exactly, and counts, so that sums are written out.

    With floors, every value is put in: a multiple of 1/6, which no ball holds exactly, may be a
    whole number.
    """
    if isinstance(expression, Relational | BooleanFunction):
        parts = [put_exactly(part, point) for part in expression.args]
        unevaluated = {"evaluate": False} if expression.is_Relational else {}
        return expression.func(*parts, **unevaluated)
    has_counts = has_parts(expression, *COUNTED)
    has_steps = has_parts(expression, *_STEPS)
    free = find_free(expression)
    exact = {
        s: v
        for s, v in point.items()
        if s in free
        and (
            not v.is_Rational
            or (has_counts and v.is_Integer and isinstance(s, sp.Symbol))
            or has_steps
        )
    }
    # SymPy would multiply two imaginary roots to a real number; over the reals they have no value.
    if exact and _leaves_the_reals(expression, point):
        return sp.nan
    return _write_out_at(expression, tuple(exact.items()))


# Many points share their counts, and an expression written out once is also compiled once.
@lru_cache(maxsize=256)
def _write_out_at(expression: sp.Basic, exact: tuple[tuple[sp.Basic, sp.Basic], ...]) -> sp.Basic:
    return write_out(substitute(expression, dict(exact)))


def _leaves_the_reals(expression: sp.Basic, point: Point) -> bool:
    """Return whether a root or logarithm outside of cases has a certainly negative argument."""
    for argument, letters in _list_radicands(expression):
        if letters <= point.keys():
            ball = balls.evaluate(argument, point)
            if ball.is_finite() and ball < 0:
                return True
    return False


# Cached for each part, as a statement is tried at many points.
@lru_cache(maxsize=4096)
def _list_radicands(expression: sp.Basic) -> tuple[tuple[sp.Expr, frozenset[sp.Basic]], ...]:
    """List the arguments of roots and logarithms, with the letters of what they are in."""
    if isinstance(expression, sp.Piecewise):
        return ()
    free = find_free(expression)
    inner = [one for part in expression.args for one in _list_radicands(part)]
    is_root = isinstance(expression, sp.Pow) and not expression.exp.is_integer
    if is_root or isinstance(expression, sp.log):
        inner.append((expression.args[0], free))
    return tuple(dict.fromkeys((argument, letters | free) for argument, letters in inner))


def _enclose_both(
    printed: sp.Basic,
    rebuilt: sp.Basic,
    point: Point,
    precisions: tuple[int, ...],
    *,
    gives_up: bool,
) -> tuple[balls.Ball, balls.Ball, str]:
    """Enclose both sides with increasing bits, or give up if the first do not make them narrow."""
    printed, rebuilt = (put_exactly(side, point) for side in (printed, rebuilt))
    decided = "open"
    for bits in precisions:
        left, right = (balls.evaluate(side, point, bits) for side in (printed, rebuilt))
        if left.is_finite() and right.is_finite():
            if not left.overlaps(right):
                return left, right, "apart"
            is_narrow = (left - right).abs_upper() < _NARROW * left.abs_upper().max(arb(1))
            decided = "together" if is_narrow else decided
        if gives_up and decided == "open":
            break
    return left, right, decided


def _name_relation(relation: sp.Basic) -> str:
    """Write a short relation out; call a long one by the names of its displayed sides."""
    text = str(relation)
    sides = f"printed {relation.rel_op} rebuilt" if relation.is_Relational else "the relation"
    return text if len(text) <= _LONGEST_RELATION else sides


def name_point(point: Point, domain: Domain) -> str:
    """Write the values of the letters at a point."""
    return ", ".join(f"{name} = {value}" for name, value in show_point(point, domain).items())
