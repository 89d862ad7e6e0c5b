"""Worst inputs of boxed programs: in, boxes; out, an input and the error there, judged by balls.

Long doubles lead the climb (`climb`), as for kernels (`worst`). A real input is a double and a
share of the way to where the next double begins.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from flint import arb

from mechproof.arithmetic.balls import to_ball, working_precision
from mechproof.arithmetic.cover import Box
from mechproof.arithmetic.intervals import LEAST_NORMAL, Array
from mechproof.roundoff.boxed import BoxedProgram
from mechproof.roundoff.climb import Points, Schedule, climb_and_judge
from mechproof.roundoff.extended import FORMAT, IN_EXTENDED, IS_LONGER
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, look_up, run, run_steps

BITS = 256
DRAWN, SEED = 400, 1
BY_LONG_DOUBLES, ROUNDS = Schedule(300, 4), 100
# Nearer to where the next double begins a real number may be rounded there.
NEAREST = 1 - 2.0**-20


@dataclass(frozen=True)
class WorstInput:
    """The exact inputs that were found, and the error there, absolute or relative."""

    error: float
    at: Mapping[str, Fraction]


def find_worst_input(program: BoxedProgram, boxes: Sequence[Box]) -> WorstInput | None:
    """Climb from points of boxes; None where no point of them has a finite error."""
    rng = np.random.default_rng(SEED)
    count = len(program.box)
    columns = [np.concatenate([_draw(box[i], rng) for box in boxes]) for i in range(count)]
    if program.convention.rounded_inputs:
        size = (count, len(columns[0]))
        columns += [*(rng.choice((-1.0, 1.0), size) * rng.uniform(0.5, 1.0, size))]
    start = tuple(columns)

    estimate = partial(_estimate, program) if IS_LONGER else None

    def judge(points: Points) -> Array:
        exact = (_take_exactly(point, count) for point in zip(*points, strict=True))
        names = program.straight.inputs
        return np.array([measure(program, dict(zip(names, at, strict=True))) for at in exact])

    found = climb_and_judge(judge, estimate, start, BY_LONG_DOUBLES, ROUNDS, rng)
    if not len(found.heights) or found.heights.max() < 0:
        return None
    point, error = found.worst
    exact = _take_exactly([*map(float, point)], count)
    return WorstInput(error, dict(zip(program.straight.inputs, exact, strict=True)))


def measure(program: BoxedProgram, at: Mapping[str, Fraction]) -> float:
    """Return the error at exact inputs, as balls have it; -1 outside the ranges, or near zero."""
    if any(not low <= at[name] <= high for name, (low, high) in program.ranges.items()):
        return -1.0
    given = {name: np.float64(float(value)) for name, value in at.items()}
    with np.errstate(all="ignore"):
        (found,) = run(program.straight, given, IN_DOUBLES)
    if not np.isfinite(found):
        return -1.0
    with working_precision(BITS):
        values = run_steps(program.straight, {n: to_ball(v) for n, v in at.items()}, IN_BALLS)
        balls = (value for value in values.values() if isinstance(value, arb))
        if any(ball != 0 and ball.abs_upper() < LEAST_NORMAL for ball in balls):
            return -1.0
        exact = look_up(values, program.straight.outputs[0], IN_BALLS)
        error = abs(arb(float(found)) - exact)
        error = error / abs(exact) if program.convention.relative else error
        # The lower end: as much it is for certain.
        return float(error.lower()) if error.is_finite() else -1.0


def _draw(side: tuple[float, float], rng: np.random.Generator) -> Array:
    """Draw doubles of a side, its ends among them."""
    drawn = rng.uniform(*side, DRAWN)
    drawn[:2] = side
    return np.clip(drawn, *side)


def _take_exactly(point: Sequence[float], count: int) -> Iterator[Fraction]:
    """Yield the real numbers of doubles and of their shares."""
    shares = point[count:] or [0.0] * count
    for double, share in zip(point[:count], shares, strict=True):
        share = min(max(share, -NEAREST), NEAREST)
        gap = Fraction(float(np.nextafter(double, np.copysign(np.inf, share)))) - Fraction(double)
        yield Fraction(double) + abs(Fraction(share)) * gap / 2


def _estimate(program: BoxedProgram, points: Points) -> Array:
    """Measure in long doubles, nearly; -1 outside the box."""
    count = len(program.box)
    doubles = points[:count]
    inside = np.ones(len(doubles[0]), bool)
    given: dict[str, Any] = {}
    for i, (name, side) in enumerate(zip(program.straight.inputs, program.box, strict=True)):
        inside &= (doubles[i] >= side[0]) & (doubles[i] <= side[1])
        given[name] = doubles[i].astype(FORMAT)
        if len(points) > count:
            share = np.clip(points[count + i], -NEAREST, NEAREST)
            gap = np.nextafter(doubles[i], np.copysign(np.inf, share)) - doubles[i]
            given[name] = given[name] + np.abs(share).astype(FORMAT) * gap / 2
    with np.errstate(all="ignore"):
        (found,) = run(
            program.straight, dict(zip(program.straight.inputs, doubles, strict=True)), IN_DOUBLES
        )
        values = run_steps(program.straight, given, IN_EXTENDED)
        exact = look_up(values, program.straight.outputs[0], IN_EXTENDED)
        error = np.abs(found - exact)
        error = error / np.abs(exact) if program.convention.relative else error
        known = inside & np.isfinite(error)
        for value in values.values():
            known &= (value == 0) | (np.abs(value) >= LEAST_NORMAL)
        return np.where(known, error, -1.0).astype(float)
