"""Compare scripts, read back from their text, with the theorems that they were written from.

Structure is compared part by part: quantifier, number of variables, number and relation of all
hypotheses and conclusions. Sides are compared in balls at points of the domain. For a bound, the
script's text is evaluated, not the program: `rounded` is the nearest double of a ball. At points of
the box the result must be what the program computes in doubles, and, without roundings, in balls.
"""

from __future__ import annotations

import operator
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial, reduce

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.ball_functions import FUNCTIONS
from mechproof.arithmetic.balls import Ball, evaluate, to_ball, working_precision
from mechproof.coq.coq_reading import ROUNDED, Joined, Read, ReadStatement, read_script
from mechproof.coq.rounding_scripts import (
    CALLED,
    BoundTheorem,
    FunctionEnclosure,
    Range,
    name_letter,
)
from mechproof.coq.terms import Names, find_ranks, find_wholes, name_symbols
from mechproof.coq.theorems import Theorem, is_true
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, run
from mechproof.statement_domains.domain import Point

_JOINTS = {"/\\": sp.And, "\\/": sp.Or}
POINTS, SEED, BITS = 16, 1, 600
ExactPoint = Mapping[str, Fraction]


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
        raise ReadBackError(f"statements {list(found)} instead of {list(wanted)}")
    for name, statement in wanted.items():
        _compare(found[name], statement)


@dataclass(frozen=True)
class _Wanted:
    theorem: Theorem
    quantifier: str
    hypotheses: tuple[sp.Basic, ...]
    conclusions: tuple[sp.Basic, ...]


def _expect(theorems: Sequence[Theorem]) -> Iterator[tuple[str, _Wanted]]:
    """Yield each statement's name and its expected content."""
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
        raise ReadBackError(f"{read.name}: unexpected binders: {read.quantifier} {read.variables}")
    if [name for name, _ in read.variables] != list(kinds):
        raise ReadBackError(f"{read.name}: variables in an unexpected order: {read.variables}")
    back = {_read_as(symbol, name): symbol for symbol, name in names.items()}
    pairs = [(read.hypotheses, wanted.hypotheses), (read.conclusions, wanted.conclusions)]
    for ours, theirs in pairs:
        if len(ours) != len(theirs):
            raise ReadBackError(f"{read.name}: {len(ours)} relations instead of {len(theirs)}")
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
            raise ReadBackError(f"{name}: {one.sign} instead of {other.func.__name__}")
        for part, meant in zip(one.parts, parts, strict=True):
            _compare_relations(name, part, meant, back, points)
        return
    if one.func is not other.func or len(one.args) != len(other.args):
        raise ReadBackError(f"{name}: {one.func.__name__} instead of {other.func.__name__}")
    for side, meant in _pair_sides(name, one, other, back):
        told = side.xreplace(back)
        for point in points if told != meant else ():
            if is_true(sp.Ne(told, meant, evaluate=False), point):
                raise ReadBackError(f"{name}: a side has an unexpected value at {point}: {side}")


def _pair_sides(
    name: str, one: sp.Basic, other: sp.Basic, back: Point
) -> Iterator[tuple[sp.Basic, sp.Basic]]:
    """Pair the sides of two relations; from derivatives by one letter, pair their functions."""
    for side, meant in zip(one.args, other.args, strict=True):
        derivatives = [isinstance(part, sp.Derivative) for part in (side, meant)]
        if not any(derivatives):
            yield side, meant
        elif all(derivatives) and [back.get(s) for s in side.variables] == list(meant.variables):
            yield side.expr, meant.expr
        else:
            raise ReadBackError(f"{name}: {side} instead of {meant}")


def compare_bound_script(
    text: str, theorem: BoundTheorem, enclosure: FunctionEnclosure | None = None
) -> None:
    """Raise `ReadBackError` unless a script states the theorem and the given enclosure."""
    try:
        statement, *others = read_script(text)
        _require(len(others) == bool(enclosure), "number of theorems")
        terms = _list_compared(statement, theorem.ranges)
        enclosed: _Terms | None = None
        if enclosure:
            ((name, (_, high)),) = theorem.ranges.items()
            enclosed = _list_compared(others[0], {name: (Fraction(0), high)})
    except ValueError as fault:
        raise ReadBackError(str(fault)) from fault
    for point in _draw(theorem):
        with working_precision(BITS):
            _compare_at(theorem, point, _evaluate(terms, point))
            if enclosure and enclosed:
                _compare_enclosed(theorem, enclosure, point, _evaluate(enclosed, point))


_Terms = tuple[sp.Expr, sp.Expr, sp.Expr]


def _list_compared(statement: ReadStatement, ranges: Mapping[str, Range]) -> _Terms:
    """Return two terms and the stated bound on their distance, for inputs in the given ranges."""
    letters = {name_letter(name): ends for name, ends in ranges.items()}
    said = (statement.quantifier, statement.variables, len(statement.conclusions))
    _require(said == ("forall", tuple((letter, "R") for letter in letters), 1), "binders")
    _require(_list_ends(statement.hypotheses) == letters, "ranges")
    (error,) = statement.conclusions
    if not (isinstance(error, sp.Le) and isinstance(error.lhs, sp.Abs)):
        raise ReadBackError("the script of a bound does not state its theorem: no inequality")
    value, minus = error.lhs.args[0].args
    return value, sp.Mul(-1, minus, evaluate=False), error.rhs


def _evaluate(terms: _Terms, point: ExactPoint) -> list[Ball]:
    evaluation = _Evaluation({name_letter(name): value for name, value in point.items()})
    return [evaluation.find(term) for term in terms]


def _require(holds: bool, part: str) -> None:
    if not holds:
        raise ReadBackError(f"the script of a bound does not state its theorem: {part}")


def _list_ends(hypotheses: tuple[Read, ...]) -> dict[str, tuple[Fraction, Fraction]]:
    """Return the ranges stated by hypotheses, which come in pairs: a letter's low and high end."""
    ends = {}
    for low, high in zip(hypotheses[::2], hypotheses[1::2], strict=True):
        if not (isinstance(low, sp.Le) and isinstance(high, sp.Le) and low.rhs == high.lhs):
            raise ReadBackError("the script of a bound does not state its theorem: ranges")
        ends[str(low.rhs)] = _read_number(low.lhs), _read_number(high.rhs)
    return ends


def _read_number(term: sp.Basic) -> Fraction:
    number = sp.Rational(term.doit())
    return Fraction(int(number.p), int(number.q))


def _draw(theorem: BoundTheorem) -> list[ExactPoint]:
    rng = random.Random(SEED)
    return [
        {
            name: Fraction(float(low + (high - low) * Fraction(rng.random())))
            for name, (low, high) in theorem.ranges.items()
        }
        for _ in range(POINTS)
    ]


def _compare_at(theorem: BoundTheorem, point: ExactPoint, read: list[Ball]) -> None:
    doubles = {name: np.float64(float(value)) for name, value in point.items()}
    (computed,) = run(theorem.straight, doubles, _NEAREST)
    _require(bool(read[0] == arb(float(computed))), f"computed value at {dict(point)}")
    _require(bool(read[1].overlaps(_run(theorem, point))), f"exact value at {dict(point)}")
    share = abs(read[1]) if theorem.relative else arb(1)
    _require(bool(read[2].overlaps(to_ball(theorem.bound) * share)), "bound")


def _compare_enclosed(
    theorem: BoundTheorem, enclosure: FunctionEnclosure, point: ExactPoint, read: list[Ball]
) -> None:
    _require(bool(read[0].overlaps(_run(theorem, point))), f"approximation at {dict(point)}")
    function = evaluate(enclosure.function, {sp.Symbol(n): v for n, v in point.items()}, BITS)
    _require(bool(read[1].overlaps(function)), f"function at {dict(point)}")
    _require(bool(read[2].overlaps(to_ball(enclosure.off))), "distance from the function")


def _run(theorem: BoundTheorem, point: ExactPoint) -> Ball:
    (exact,) = run(theorem.straight, {n: to_ball(v) for n, v in point.items()}, IN_BALLS)
    return exact


class _Evaluation:
    """The values of the terms of a statement at a point, each computed once."""

    def __init__(self, given: ExactPoint) -> None:
        self._known: dict[sp.Basic, Ball] = {
            sp.Symbol(letter): to_ball(value) for letter, value in given.items()
        }

    def find(self, term: sp.Basic) -> Ball:
        """Return the value of a term."""
        if term not in self._known:
            self._known[term] = self._find(term)
        return self._known[term]

    def _find(self, term: sp.Basic) -> Ball:
        if isinstance(term, sp.Rational):
            return to_ball(Fraction(int(term.p), int(term.q)))
        if isinstance(term, sp.Pow):
            base, power = self.find(term.base), Fraction(str(term.exp))
            return base.sqrt() if power == Fraction(1, 2) else base ** int(power)
        parts = [self.find(part) for part in term.args]
        if isinstance(term, sp.Add):
            return reduce(operator.add, parts)
        if isinstance(term, sp.Mul):
            return reduce(operator.mul, parts)
        if term.func in FUNCTIONS:
            return FUNCTIONS[term.func](*parts)
        _require(term.func == ROUNDED, str(term.func))
        return arb(_round(parts[0]))


def _round(ball: arb) -> Ball:
    """Return the double that is nearest to both ends of a ball."""
    exact = (end.fmpq() for end in (ball.lower(), ball.upper()))
    low, high = (float(Fraction(int(end.p), int(end.q))) for end in exact)
    _require(low == high, "rounding not decided at this precision")
    return low


def _call(kind: str, value: np.float64) -> np.float64:
    return np.float64(_round(IN_BALLS[kind](arb(float(value)))))


# Functions as in the statements, rounded to nearest, which NumPy's are not.
_NEAREST = IN_DOUBLES.but(**{kind: partial(_call, kind) for kind in CALLED})
