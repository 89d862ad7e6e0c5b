"""Scripts read back, compared with the theorems that they were written from.

Structure is compared part by part: quantifier, number of variables, number and relation of every
hypothesis and conclusion. Sides are compared in balls at points of the domain.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from mechproof.coq.coq_reading import Joined, Read, ReadStatement, read_script
from mechproof.coq.families import find_ranks, find_wholes
from mechproof.coq.terms import Names, name_symbols
from mechproof.coq.theorems import Theorem, is_true
from mechproof.statement_domains.domain import Point

_JOINTS = {"/\\": sp.And, "\\/": sp.Or}


class ReadBackError(ValueError):
    """A script does not say what it was written from; the text says where."""


def compare_script(text: str, theorems: Sequence[Theorem]) -> None:
    """Raise `ReadBackError` unless a script states these theorems, each with its witness."""
    try:
        found = {statement.name: statement for statement in read_script(text)}
    except ValueError as error:
        raise ReadBackError(str(error)) from error
    wanted = dict(_expect(theorems))
    if list(found) != list(wanted):
        raise ReadBackError(f"statements {list(found)} where {list(wanted)} were expected")
    for name, statement in wanted.items():
        _compare(found[name], statement)


@dataclass(frozen=True)
class _Wanted:
    theorem: Theorem
    quantifier: str
    hypotheses: tuple[sp.Basic, ...]
    conclusions: tuple[sp.Basic, ...]


def _expect(theorems: Sequence[Theorem]) -> Iterator[tuple[str, _Wanted]]:
    """Yield the name of each statement and what it should say."""
    for number, theorem in enumerate(theorems, start=1):
        hypotheses, name = theorem.hypotheses, f"part_{number}"
        if not theorem.of_all:
            yield name, _Wanted(theorem, "exists", (), (*hypotheses, theorem.conclusion))
            continue
        if hypotheses:
            yield f"{name}_inhabited", _Wanted(theorem, "exists", (), hypotheses)
        yield name, _Wanted(theorem, "forall", hypotheses, (theorem.conclusion,))


def _compare(read: ReadStatement, wanted: _Wanted) -> None:
    theorem = wanted.theorem
    names = name_symbols(theorem.symbols)
    quantifier = wanted.quantifier if names else ""
    kinds = dict(_list_kinds(theorem, names))
    if (read.quantifier, dict(read.variables)) != (quantifier, kinds):
        raise ReadBackError(f"{read.name}: {read.quantifier} {read.variables}")
    if [name for name, _ in read.variables] != list(kinds):
        raise ReadBackError(f"{read.name}: variables in the order {read.variables}")
    back = {_read_as(symbol, name): symbol for symbol, name in names.items()}
    pairs = [(read.hypotheses, wanted.hypotheses), (read.conclusions, wanted.conclusions)]
    for ours, theirs in pairs:
        if len(ours) != len(theirs):
            raise ReadBackError(f"{read.name}: {len(ours)} relations where {len(theirs)} are meant")
        for one, other in zip(ours, theirs, strict=True):
            _compare_relations(read.name, one, other, back, theorem.points)


def _list_kinds(theorem: Theorem, names: Names) -> Iterator[tuple[str, str]]:
    """Yield the letters with their kinds in Coq."""
    whole = sp.Tuple(theorem.conclusion, *theorem.hypotheses)
    wholes, ranks = find_wholes(whole), find_ranks(whole)
    for symbol in theorem.symbols:
        kind = "nat" if symbol in wholes else "nat -> " * ranks.get(symbol, 0) + "R"
        yield names[symbol], kind


def _read_as(symbol: sp.Basic, name: str) -> sp.Basic:
    return sp.IndexedBase(name) if isinstance(symbol, sp.IndexedBase) else sp.Symbol(name)


def _compare_relations(
    name: str, one: Read, other: sp.Basic, back: Point, points: Sequence[Point]
) -> None:
    if isinstance(one, Joined):
        parts = sorted(other.args, key=sp.default_sort_key)
        if other.func is not _JOINTS[one.sign] or len(parts) != len(one.parts):
            raise ReadBackError(f"{name}: {one.sign} where {other.func.__name__} is meant")
        for part, meant in zip(one.parts, parts, strict=True):
            _compare_relations(name, part, meant, back, points)
        return
    if one.func is not other.func or len(one.args) != len(other.args):
        raise ReadBackError(f"{name}: {one.func.__name__} where {other.func.__name__} is meant")
    for side, meant in _pair_sides(name, one, other, back):
        told = side.xreplace(back)
        for point in points if told != meant else ():
            if is_true(sp.Ne(told, meant, evaluate=False), point):
                raise ReadBackError(f"{name}: a side is not what is meant at {point}: {side}")


def _pair_sides(
    name: str, one: sp.Basic, other: sp.Basic, back: Point
) -> Iterator[tuple[sp.Basic, sp.Basic]]:
    """Pair the sides of two relations; of derivatives by one letter, what is differentiated."""
    for side, meant in zip(one.args, other.args, strict=True):
        derivatives = [isinstance(part, sp.Derivative) for part in (side, meant)]
        if not any(derivatives):
            yield side, meant
        elif all(derivatives) and [back.get(s) for s in side.variables] == list(meant.variables):
            yield side.expr, meant.expr
        else:
            raise ReadBackError(f"{name}: {side} where {meant} is meant")
