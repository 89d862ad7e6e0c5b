"""A row and its verdict -> the theorems that state it: for all values, or at a point.

A relation with laws by pieces becomes one theorem for every choice of pieces, with its conditions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, islice, product

import sympy as sp
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.coq.slope_statements import differentiate_alike
from mechproof.coq.terms import (
    UnwritableError,
    find_wholes,
    give_laws,
    list_integrals,
    list_letters,
    list_needs,
    name_letters,
    write_at,
    write_relation,
)
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    Conjunction,
    Distinct,
    Equality,
    Holds,
    PrintedNumber,
    RecordError,
    Row,
    Statement,
)
from mechproof.record.parts import find_free, find_parts, replace_parts
from mechproof.record.statements import list_parts
from mechproof.statement_domains.domain import Domain, Point, sizes_of
from mechproof.statement_domains.preparation import prepare

# The most points at which a statement is tried, and how many of them come first and are kept for
# comparison.
_POINTS = 40
_COMPARED = 8
_BITS = 256
# Work limit: a relation with this many parts or more is not written.
_LONGEST = 8000


@dataclass(frozen=True)
class Theorem:
    """A conclusion for all values of the symbols that satisfy the hypotheses, or at one point.

    The point `witness` satisfies the hypotheses: they contradict neither each other nor the domain.
    At `points`, a statement read back from its text is compared with this one.
    """

    symbols: tuple[sp.Basic, ...]
    hypotheses: tuple[sp.Basic, ...]
    conclusion: sp.Basic
    witness: Point
    of_all: bool = True
    points: tuple[Point, ...] = ()


def build_theorems(row: Row, verdict: Verdict, domain: Domain) -> list[Theorem]:
    """Return the theorems of a row that is PROVED or REFUTED. Raises `UnwritableError`.

    A separate theorem states that integrands have values between their limits, ahead of the
    theorems that they are part of.
    """
    if verdict is Verdict.REFUTED:
        relations = list(_list_relations(row.statement, domain))
        return [*_state_inner_needs(relations, domain), _refute(relations, domain)]
    theorems: list[Theorem] = []
    for part in list_parts(row.statement):
        if isinstance(part, Distinct):
            relations = list(_equate(part.left, part.right, domain))
            theorems += _state_inner_needs(relations, domain)
            theorems.append(_refute(relations, domain))
        else:
            relations = [r for r in _list_relations(part, domain) if r is not sp.true]
            cases = [case for relation in relations for case in list_cases(relation)]
            relations = [relation for relation, _ in cases]
            _refuse_unwritable(relations)
            theorems += _state_inner_needs(relations, domain)
            theorems += (_state(relation, domain, known) for relation, known in cases)
    if not theorems:
        raise UnwritableError("nothing of it is left to be proved once it is written out")
    return theorems


def _refuse_unwritable(relations: Sequence[sp.Basic]) -> None:
    """Refuse relations that are too long or have no term, before points are searched for."""
    _refuse_long(relations)
    for relation in relations:
        letters = list_letters(relation)
        write_relation(relation, name_letters(letters, relation))


def _refuse_long(relations: Sequence[sp.Basic]) -> None:
    """Refuse relations of too many parts; equal parts of numbers, being shared, count once."""
    parts: Iterator[sp.Basic] = chain.from_iterable(map(sp.preorder_traversal, relations))
    if not any(map(find_free, relations)):
        parts = iter(dict.fromkeys(parts))
    if sum(1 for _ in islice(parts, _LONGEST)) == _LONGEST:
        raise UnwritableError(f"it has {_LONGEST} parts or more")


def _list_relations(statement: Statement, domain: Domain) -> Iterator[sp.Basic]:
    """Yield the relations that a statement asserts, with declared symbols written out."""
    match statement:
        case Conjunction():
            for part in statement.parts:
                yield from _list_relations(part, domain)
        case Equality():
            relations = list(_equate(statement.printed, statement.rebuilt, domain))
            yield from differentiate_alike(relations, statement.differentiated, domain)
        case Holds():
            relation = prepare(domain.resolve(statement.relation))
            yield from relation.args if isinstance(relation, sp.And) else (relation,)
        case PrintedNumber():
            value = prepare(domain.resolve(statement.value))
            yield sp.Le(
                sp.Abs(value - sp.Rational(statement.printed), evaluate=False),
                statement.half_place,
                evaluate=False,
            )
        case _:
            raise UnwritableError(f"a {type(statement).__name__} has no theorem")


def _equate(left: sp.Basic, right: sp.Basic, domain: Domain) -> Iterator[sp.Basic]:
    left, right = (prepare(domain.resolve(side)) for side in (left, right))
    if not isinstance(left, sp.MatrixBase):
        yield sp.Eq(left, right, evaluate=False)
        return
    for place in product(range(left.rows), range(left.cols)):
        yield sp.Eq(left[place], right[place], evaluate=False)


def _state_inner_needs(relations: Iterable[sp.Basic], domain: Domain) -> list[Theorem]:
    sides = chain.from_iterable(relation.args for relation in relations)
    integrals = dict.fromkeys(chain.from_iterable(map(list_integrals, sides)))
    found = {
        need: list_between(integral)
        for integral in integrals
        for need in list_needs(integral.function)
    }
    return [_state(need, domain, between) for need, between in found.items()]


def list_between(integral: sp.Integral) -> tuple[sp.Basic, ...]:
    """List the relations that keep the letter of an integral between its limits.

    There are none if the integrand must have values everywhere: if it has no tangents.
    """
    letter, lower, upper = integral.limits[0]
    if not integral.function.has(sp.tan):
        return ()
    least, most = sp.Min(lower, upper), sp.Max(lower, upper)
    return sp.Le(least, letter, evaluate=False), sp.Le(letter, most, evaluate=False)


def _state(relation: sp.Basic, domain: Domain, between: tuple[sp.Basic, ...] = ()) -> Theorem:
    hypotheses = _list_hypotheses(relation, domain, between)
    _refuse_long(hypotheses)
    symbols = list_letters(relation, *hypotheses)
    said = (relation, *hypotheses)
    points = islice(_list_points(symbols, domain, said), _POINTS)
    first = tuple(islice(points, _COMPARED))
    for point in chain(first, points):
        if all(is_true(h, point) for h in hypotheses):
            compared = (
                first if _are_distinguished(first) else (*first, *_draw(symbols, domain, said))
            )
            return Theorem(symbols, hypotheses, relation, point, points=compared)
    raise UnwritableError("no point of the domain satisfies all hypotheses")


def _refute(relations: Sequence[sp.Basic], domain: Domain) -> Theorem:
    _refuse_unwritable(relations)
    for relation in relations:
        hypotheses = _list_hypotheses(relation, domain)
        _refuse_long(hypotheses)
        symbols = list_letters(relation, *hypotheses)
        for point in _list_points(symbols, domain, (relation, *hypotheses)):
            holds = [is_true(h, point) for h in (*hypotheses, relation)]
            if all(holds[:-1]) and holds[-1] is False:
                return Theorem(symbols, hypotheses, _negate(relation), point, False, (point,))
    raise UnwritableError("no point was found at which it fails")


def _are_distinguished(points: Sequence[Point]) -> bool:
    """Return whether no two letters have the same value at every point."""
    values = list(zip(*(point.values() for point in points), strict=True))
    return len(set(values)) == len(values)


def _draw(
    symbols: Sequence[sp.Basic], domain: Domain, relations: Sequence[sp.Basic]
) -> tuple[Point, ...]:
    """Draw points without regard to published sizes, some of which are equal."""
    with suppress(UnwritableError):
        unpublished = replace(domain, published=())
        return tuple(islice(_list_points(symbols, unpublished, relations), _COMPARED))
    return ()


def is_true(relation: sp.Basic, point: Point) -> bool | None:
    """Return whether a relation holds at a point; None if balls do not decide."""
    numbers = {s: value for s, value in point.items() if not isinstance(value, sp.Lambda)}
    return balls.truth(write_at(relation, point), numbers, _BITS)


def _list_points(
    symbols: Sequence[sp.Basic], domain: Domain, relations: Sequence[sp.Basic]
) -> Iterator[Point]:
    """Yield points: sums get few terms, and families depend on indices at every second point."""
    wholes = find_wholes(*relations)
    for place, point in enumerate(_list_numbers(symbols, domain)):
        few = dict.fromkeys(wholes & point.keys(), sp.Integer(2 + place % 3))
        yield {**point, **few, **give_laws(symbols, relations, place % 2)}


def _list_numbers(symbols: Sequence[sp.Basic], domain: Domain) -> Iterator[Point]:
    wanted = [symbol for symbol in symbols if isinstance(symbol, sp.Symbol)]
    if not wanted:
        yield {}
        return
    published = (domain.points_at(sizes_of(sizes), wanted) for sizes in domain.published)
    for found in chain(chain.from_iterable(published), _try_points(wanted, domain)):
        yield {symbol: found[symbol] for symbol in wanted}


def _try_points(symbols: list[sp.Basic], domain: Domain) -> Iterator[Point]:
    """Yield points of the domain, only a few at first: nearly always one of them will do."""
    try:
        few = domain.points(symbols, _COMPARED)[:_COMPARED]
        yield from few
        yield from domain.points(symbols, _POINTS)[len(few) :]
    except RecordError as error:
        raise UnwritableError(str(error)) from error


def _list_hypotheses(
    relation: sp.Basic, domain: Domain, between: tuple[sp.Basic, ...] = ()
) -> tuple[sp.Basic, ...]:
    """List the symbols' sets, the paper's relations, and the conditions of the sides."""
    met = find_free(relation).union(*map(find_free, between))
    tied = [r for r in domain.where if find_free(r) <= met]
    met_letters = tuple(sorted({s for s in met if isinstance(s, sp.Symbol)}, key=str))
    sets = chain.from_iterable(_bound(s, domain.set_of(s)) for s in met_letters)
    needs = chain.from_iterable(list_needs(side) for side in relation.args)
    listed = dict.fromkeys([*sets, *tied, *between, *needs])
    return tuple(h for h in listed if h not in (sp.true, relation) and not _is_of_elements(h))


def _is_of_elements(hypothesis: sp.Basic) -> bool:
    """Return whether a hypothesis is about single elements; omitting it proves more."""
    sums = find_parts(hypothesis, sp.Sum)
    return bool(find_parts(hypothesis.xreplace(dict.fromkeys(sums, sp.S.One)), sp.Indexed))


def _bound(symbol: sp.Basic, values: sp.Set) -> Iterator[sp.Basic]:
    """Yield the bounds of a set; omitting that numbers are whole proves more."""
    try:
        low, high = values.inf, values.sup
    except (NotImplementedError, AttributeError):
        return
    if low.is_finite:
        yield (sp.Ge if values.contains(low) == True else sp.Gt)(symbol, low, evaluate=False)  # noqa: E712
    if high.is_finite:
        yield (sp.Le if values.contains(high) == True else sp.Lt)(symbol, high, evaluate=False)  # noqa: E712


def _negate(relation: sp.Basic) -> sp.Basic:
    """Return the relation that is true where the given one is not."""
    if not isinstance(relation, Relational):
        raise UnwritableError(f"the negation of {type(relation).__name__} is not written")
    return relation.negated


# A relation, and the conditions under which its pieces are the ones that hold.
Case = tuple[sp.Basic, tuple[sp.Basic, ...]]


def list_cases(relation: sp.Basic, known: tuple[sp.Basic, ...] = ()) -> Iterator[Case]:
    """Yield the cases of a relation, without those whose conditions contradict each other.

    A piece holds where its condition does and those of all earlier pieces do not; where no
    condition holds, the law has no value. Raises `UnwritableError` for a condition that is no
    comparison.
    """
    laws = find_parts(relation, sp.Piecewise)
    inner = [law for law in laws if not find_parts(sp.Tuple(*law.args), sp.Piecewise)]
    if not inner:
        yield relation, known
        return
    law = min(inner, key=sp.default_sort_key)
    before: list[sp.Basic] = []
    for value, condition in law.args:
        new = [*before] if condition is sp.true else [*before, _turn(condition)]
        conditions = tuple(dict.fromkeys((*known, *new)))
        if not any(c.negated.reversed in conditions for c in conditions):
            yield from list_cases(_put(relation, law, value), conditions)
        if condition is sp.true:
            return
        before.append(_turn(condition.negated))


def _put(relation: sp.Basic, law: sp.Piecewise, value: sp.Basic) -> sp.Basic:
    """Replace a law by one of its pieces in both sides, which may become equal."""
    sides = (replace_parts(side, {law: value}) for side in relation.args)
    return relation.func(*sides, evaluate=False)


def _turn(condition: sp.Basic) -> sp.Basic:
    """Write a condition with the smaller side first, so that equal conditions look equal."""
    if not isinstance(condition, Relational) or isinstance(condition, sp.Eq | sp.Ne):
        raise UnwritableError(f"a piece under the condition {condition} is not written")
    if isinstance(condition, sp.Gt | sp.Ge):
        return condition.reversed
    return condition
