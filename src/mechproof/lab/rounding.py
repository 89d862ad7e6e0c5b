"""Rounding: a program in balls, each operation with the error that doubles may make in it.

What the ball of a result does not hold, no order of roundings can have given: the source that was
run is not the program. It is the running error analysis of Wilkinson (Higham 2002, section 3.3)
with a ball for the sum of bounds. The arithmetic of IEEE 754 is rounded to nearest; of NumPy's
functions every loop is taken to stay within `LOOPS` ulps.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from flint import arb

from mechproof.arithmetic.balls import working_precision
from mechproof.lab.ways import Array
from mechproof.programs.code import Stage
from mechproof.programs.operations import KINDS, VIEWS, Arithmetic, Rounding
from mechproof.programs.program import Program, spell_out_forms
from mechproof.roundoff.running import IN_BALLS, ON_ARRAYS, run

# So many that what balls round is nothing beside the roundings of doubles.
BITS = 192
# Half an ulp of a double and of a float32, relative.
UNIT, SINGLE_UNIT = 2.0**-53, 2.0**-24
SMALLEST = 2.0**-1074
LOOPS = 4
LOSSES: Mapping[Rounding, float] = {
    Rounding.EXACT: 0.0,
    Rounding.NEAREST: 1.0,
    Rounding.LIBRARY: 2.0 * LOOPS,
}
# An undecided choice encloses both; doubles give an angle to the vector that is zero; a sum that is
# never negative may be rounded to it.
ENCLOSING = IN_BALLS.but(
    arctan2=arb.atan2,
    choose=lambda holds, a, b: a.union(b) if holds is None else a if holds else b,
    nonnegative=lambda total, size: total.union(arb(0)) if total < 0 else total,
)


@dataclass(frozen=True)
class RoundedBalls:
    """Balls, and whether they are of float32; numbers as they are written are neither."""

    balls: Any
    is_single: bool | None = False


# As the doubles that a kernel takes them for.
CONSTANTS = {
    **{"#pi": RoundedBalls(arb(np.pi)), "#e": RoundedBalls(arb(np.e))},
    **{"#inf": RoundedBalls(arb("inf")), "#nan": RoundedBalls(arb("nan"))},
}


def enclose_stage(stage: Stage, inputs: Mapping[str, float | Array]) -> list[arb]:
    """Return balls that hold whatever doubles the stage computes of its inputs.

    `inputs` are numbers, or arrays where an axis is summed over. An undecided branch gives both.
    """
    with working_precision(BITS):
        known = {name: _as_balls(value) for name, value in inputs.items()}
        prepared = _run(stage.prepare, known)
        running = tuple(known[name] for name in stage.running)
        if stage.evaluate is None:
            return _map_affinely([v.balls for v in prepared], [v.balls for v in running])
        given = dict(zip(stage.evaluate.inputs, running + prepared, strict=True))
        return [value.balls for value in _run(stage.evaluate, given)]


def decide(condition: Program, inputs: Mapping[str, float | Array]) -> bool:
    """Return whether a condition on the inputs is certainly true."""
    with working_precision(BITS):
        known = {name: _as_balls(value) for name, value in inputs.items()}
        (result,) = _run(condition, known)
        return result.balls is True


def _as_balls(value: float | Array) -> RoundedBalls:
    return RoundedBalls(np.frompyfunc(lambda v: arb(float(v)), 1, 1)(np.asarray(value, float)))


def _run(program: Program, known: Mapping[str, RoundedBalls]) -> tuple[RoundedBalls, ...]:
    return run(spell_out_forms(program), {**known, **CONSTANTS}, ROUNDED)


def _operate(kind: str, *given: RoundedBalls) -> RoundedBalls:
    told = [value.is_single for value in given if value.is_single is not None]
    single = kind == "single" or (bool(told) and all(told))
    return RoundedBalls(_enclose(kind, single, *(v.balls for v in given)), single)


def _enclose(kind: str, single: bool, *values: Any) -> Any:
    if kind in VIEWS:
        return ON_ARRAYS[kind](values[0])
    if kind == "sum":
        return _sum(values[0])
    if kind == "whole_turns_off":
        return np.frompyfunc(_take_turns_off, 1, 1)(values[0])
    exact = np.frompyfunc(ENCLOSING[kind], len(values), 1)(*values)
    loss = LOSSES[KINDS[kind].rounding] * (SINGLE_UNIT if single else UNIT)
    if not loss:
        return exact
    if kind == "tangent_quotient":
        return np.frompyfunc(lambda q, y, a, b: _spread_quotient(q, a, b, loss), 4, 1)(
            exact, *values
        )
    return np.frompyfunc(lambda ball: _spread(ball, loss), 1, 1)(exact)


ROUNDED = Arithmetic(
    {
        **{kind: partial(_operate, kind) for kind in KINDS},
        "number": lambda value: RoundedBalls(arb(value), None),
    }
)


def _spread(ball: arb, relative: float) -> arb:
    """Return the ball with room for a relative error, and for one below the least double."""
    return (
        ball + arb(0, float(abs(ball).upper()) * relative + SMALLEST) if ball.is_finite() else ball
    )


def _spread_quotient(quotient: arb, a: arb, b: arb, relative: float) -> arb:
    """Return room for an error of the largest value of t/(a + b*t**2), as the support states."""
    largest = float((1 / (2 * (a * b).sqrt())).upper()) * float(
        (1 + (b / a).max(a / b).sqrt()).upper()
    )
    return quotient + arb(0, largest * relative) if quotient.is_finite() else arb(0, largest)


def _take_turns_off(x: arb) -> arb:
    """Return x less the turns that the double next to it loses, with the rounding of both."""
    if not x.is_finite():
        return x
    turns = round(float(x.mid()) / (2 * np.pi))
    return x - 2 * arb.pi() * turns + arb(0, 4 * UNIT * float(abs(x).upper()))


def _sum(array: Any) -> Any:
    terms = np.asarray(array, object).ravel()
    total = sum(terms, start=arb(0))
    size = sum((float(abs(t).upper()) for t in terms), start=0.0)
    return total + arb(0, size * UNIT * len(terms))


def _map_affinely(entries: list[Any], point: list[Any]) -> list[Any]:
    """Return M @ p + v with the error of sums and products in any order."""
    count = len(point)
    rows = [entries[i * count : (i + 1) * count] for i in range(count)]
    found = []
    for row, shift in zip(rows, entries[-count:], strict=True):
        terms = [m * p for m, p in zip(row, point, strict=True)] + [shift]
        size = sum((float(abs(t).upper()) for t in terms), start=0.0)
        found.append(sum(terms, start=arb(0)) + arb(0, 2 * (count + 1) * UNIT * size))
    return found
