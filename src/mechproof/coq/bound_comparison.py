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
    PLAIN_FUNCTIONS,
    BoundTheorem,
    FunctionEnclosure,
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
        if enclosure:
            _compare_enclosed(others[0], theorem, enclosure)
    except ValueError as fault:
        raise ReadBackError(str(fault)) from fault
    inputs = theorem.straight.inputs
    letters = [name_letter(name) for name in inputs]
    said = (statement.quantifier, statement.variables, len(statement.conclusions))
    _require(said == ("forall", tuple((letter, "R") for letter in letters), 1), "binders")
    ranges = [theorem.ranges[name] for name in inputs]
    _require(_list_ends(statement.hypotheses) == dict(zip(letters, ranges, strict=True)), "ranges")
    error = statement.conclusions[0]
    if not (isinstance(error, sp.Le) and isinstance(error.lhs, sp.Abs)):
        raise ReadBackError("the script of a bound says something else: no inequality")
    computed, minus = error.lhs.args[0].args
    exact = sp.Mul(-1, minus, evaluate=False)
    for point in _draw(theorem):
        given = dict(zip(letters, (point[name] for name in inputs), strict=True))
        with working_precision(BITS):
            _compare_at(theorem, point, [_Evaluation(given).find(e) for e in (computed, exact)])
            bar = _Evaluation(given).find(error.rhs)
            share = abs(_Evaluation(given).find(exact)) if theorem.relative else arb(1)
            _require(bool((bar - to_ball(theorem.bound) * share).contains(0)), "the bound")


def _compare_enclosed(
    statement: ReadStatement, theorem: BoundTheorem, enclosure: FunctionEnclosure
) -> None:
    """Compare a statement on one input with the program and the function, in balls."""
    ((name, (_, high)),) = theorem.ranges.items()
    letter = name_letter(name)
    said = (statement.quantifier, statement.variables, len(statement.conclusions))
    _require(said == ("forall", ((letter, "R"),), 1), "binders of what is enclosed")
    _require(
        _list_ends(statement.hypotheses) == {letter: (Fraction(0), high)},
        "ranges of what is enclosed",
    )
    (error,) = statement.conclusions
    if not (isinstance(error, sp.Le) and isinstance(error.lhs, sp.Abs)):
        raise ReadBackError("the script of a bound says something else: no inequality")
    _require(_read_number(error.rhs) == enclosure.off, "how much it is off")
    value, minus = error.lhs.args[0].args
    for point in _draw(theorem):
        given = {letter: point[name]}
        with working_precision(BITS):
            read = [_Evaluation(given).find(term) for term in (value, minus)]
            ball = to_ball(point[name])
            (exact,) = run(theorem.straight, {name: ball}, IN_BALLS)
            _require(bool(read[0].overlaps(exact)), f"what is enclosed at {point}")
            function = evaluate(enclosure.function, {sp.Symbol(name): ball})
            _require(bool(read[1].overlaps(-function)), f"the function at {point}")


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


def _compare_at(theorem: BoundTheorem, point: Point, read: list[arb]) -> None:
    doubles = {name: np.float64(float(value)) for name, value in point.items()}
    (computed,) = run(theorem.straight, doubles, _NEAREST)
    _require(bool(read[0] == arb(float(computed))), f"what is computed at {dict(point)}")
    balls = {name: to_ball(value) for name, value in point.items()}
    (exact,) = run(theorem.straight, balls, IN_BALLS)
    _require(bool(read[1].overlaps(exact)), f"what is exact at {dict(point)}")


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
_NEAREST = IN_DOUBLES.but(**{kind: partial(_call, kind) for kind in PLAIN_FUNCTIONS})
