"""Bound scripts read back: in, the text and the theorem it was written from; out, agreement.

The text is run, not the program: `rounded` is the nearest double of a ball. At points of the box
that must be what the program computes in doubles, and, without roundings, what it is in balls.
"""

from __future__ import annotations

import operator
import random
from collections.abc import Mapping
from fractions import Fraction
from functools import partial, reduce

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.ball_functions import FUNCTIONS
from mechproof.arithmetic.balls import Ball, evaluate, to_ball, working_precision
from mechproof.coq.coq_reading import ROUNDED, Read, ReadStatement, read_script
from mechproof.coq.rounding_scripts import (
    CALLED,
    BoundTheorem,
    FunctionEnclosure,
    Range,
    name_letter,
)
from mechproof.coq.script_comparison import ReadBackError
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, run

POINTS, SEED, BITS = 16, 1, 600
Point = Mapping[str, Fraction]


def compare_bound_script(
    text: str, theorem: BoundTheorem, enclosure: FunctionEnclosure | None = None
) -> None:
    """Raise `ReadBackError` unless a script states the theorem, and what is enclosed."""
    try:
        statement, *others = read_script(text)
        _require(len(others) == bool(enclosure), "how many theorems")
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
    """Return what is said to be near to what, and the bound, for inputs in their ranges."""
    letters = {name_letter(name): ends for name, ends in ranges.items()}
    said = (statement.quantifier, statement.variables, len(statement.conclusions))
    _require(said == ("forall", tuple((letter, "R") for letter in letters), 1), "binders")
    _require(_list_ends(statement.hypotheses) == letters, "ranges")
    (error,) = statement.conclusions
    if not (isinstance(error, sp.Le) and isinstance(error.lhs, sp.Abs)):
        raise ReadBackError("the script of a bound says something else: no inequality")
    value, minus = error.lhs.args[0].args
    return value, sp.Mul(-1, minus, evaluate=False), error.rhs


def _evaluate(terms: _Terms, point: Point) -> list[Ball]:
    evaluation = _Evaluation({name_letter(name): value for name, value in point.items()})
    return [evaluation.find(term) for term in terms]


def _require(holds: bool, part: str) -> None:
    if not holds:
        raise ReadBackError(f"the script of a bound says something else: {part}")


def _list_ends(hypotheses: tuple[Read, ...]) -> dict[str, tuple[Fraction, Fraction]]:
    """Return the ranges that hypotheses state, low and high end of one letter after another."""
    ends = {}
    for low, high in zip(hypotheses[::2], hypotheses[1::2], strict=True):
        if not (isinstance(low, sp.Le) and isinstance(high, sp.Le) and low.rhs == high.lhs):
            raise ReadBackError("the script of a bound says something else: ranges")
        ends[str(low.rhs)] = _read_number(low.lhs), _read_number(high.rhs)
    return ends


def _read_number(term: sp.Basic) -> Fraction:
    number = sp.Rational(term.doit())
    return Fraction(int(number.p), int(number.q))


def _draw(theorem: BoundTheorem) -> list[Point]:
    rng = random.Random(SEED)
    return [
        {
            name: Fraction(float(low + (high - low) * Fraction(rng.random())))
            for name, (low, high) in theorem.ranges.items()
        }
        for _ in range(POINTS)
    ]


def _compare_at(theorem: BoundTheorem, point: Point, read: list[Ball]) -> None:
    doubles = {name: np.float64(float(value)) for name, value in point.items()}
    (computed,) = run(theorem.straight, doubles, _NEAREST)
    _require(bool(read[0] == arb(float(computed))), f"what is computed at {dict(point)}")
    _require(bool(read[1].overlaps(_run(theorem, point))), f"what is exact at {dict(point)}")
    share = abs(read[1]) if theorem.relative else arb(1)
    _require(bool(read[2].overlaps(to_ball(theorem.bound) * share)), "the bound")


def _compare_enclosed(
    theorem: BoundTheorem, enclosure: FunctionEnclosure, point: Point, read: list[Ball]
) -> None:
    _require(bool(read[0].overlaps(_run(theorem, point))), f"what is near at {dict(point)}")
    function = evaluate(enclosure.function, {sp.Symbol(n): v for n, v in point.items()}, BITS)
    _require(bool(read[1].overlaps(function)), f"the function at {dict(point)}")
    _require(bool(read[2].overlaps(to_ball(enclosure.off))), "how near it is")


def _run(theorem: BoundTheorem, point: Point) -> Ball:
    (exact,) = run(theorem.straight, {n: to_ball(v) for n, v in point.items()}, IN_BALLS)
    return exact


class _Evaluation:
    """The values of the terms of a statement at a point, each found once."""

    def __init__(self, given: Point) -> None:
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
    """Return the double that is nearest to a ball, which both of its ends have."""
    ends = []
    for end in (ball.lower(), ball.upper()):
        mantissa, exponent = end.man_exp()
        ends.append(float(Fraction(int(mantissa)) * Fraction(2) ** int(exponent)))
    _require(ends[0] == ends[1], "a rounding that the precision does not decide")
    return ends[0]


def _call(kind: str, value: np.float64) -> np.float64:
    return np.float64(_round(IN_BALLS[kind](arb(float(value)))))


# Functions as statements have them; those of NumPy are not rounded to nearest.
_NEAREST = IN_DOUBLES.but(**{kind: partial(_call, kind) for kind in CALLED})
