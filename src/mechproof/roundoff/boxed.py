"""Boxed programs: in, steps and the box of their inputs; out, a bound on the error and the worst.

The error is absolute or relative to the exact value, as in FPTaylor (Solovyev et al. 2018). Inputs
are doubles, or real numbers whose rounding is a separate step. Long doubles lead the climb to the
worst input (`climb`), as for kernels (`worst`), and balls judge it. A real input is represented by
a double and a share of the way to the midpoint between it and the next one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from flint import arb

from mechproof.arithmetic.balls import to_ball, working_precision
from mechproof.arithmetic.cover import Box, Boxes, Side
from mechproof.arithmetic.intervals import EPS, LEAST_NORMAL, ONE, Array, list_spans
from mechproof.programs.program import Operand
from mechproof.roundoff.bound import KINDS, ErrorAnalysis
from mechproof.roundoff.climb import Points, Schedule, climb_and_judge
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables, bound_in_groups
from mechproof.roundoff.running import (
    IN_BALLS,
    IN_DOUBLES,
    IN_EXTENDED,
    IS_LONGER,
    LONG_DOUBLE,
    look_up,
    run,
    run_steps,
)
from mechproof.roundoff.steps import (
    CONSTANT,
    FUNCTIONS,
    HALF,
    NORMAL,
    Step,
    StraightLineProgram,
    keep_needed,
    name_constant,
)
from mechproof.roundoff.written_scales import share_equal_steps

Range = tuple[Fraction, Fraction]
BITS = 256
DRAWN, SEED = 400, 1
BY_LONG_DOUBLES, ROUNDS = Schedule(300, 4), 100
# Largest share of the way to the midpoint between two doubles: nearer to it, a real number might be
# rounded to the other double.
NEAREST = 1 - 2.0**-20


@dataclass(frozen=True)
class Convention:
    """What counts as the error: whether inputs are rounded, and whether it is relative.

    `ulps` is the largest error assumed of a library function, in ulps of its result.
    """

    rounded_inputs: bool = False
    relative: bool = False
    ulps: float = 1.0

    def __post_init__(self) -> None:
        if not HALF <= self.ulps <= 2.0**20:
            raise ValueError(f"ulps = {self.ulps}: must satisfy 0.5 <= ulps <= 2**20")


@dataclass(frozen=True)
class BoxedProgram:
    """Steps with one output, the exact ranges of its inputs, and the box of doubles for them."""

    straight: StraightLineProgram
    ranges: Mapping[str, Range]
    box: Box
    convention: Convention

    def bound(self, boxes: Boxes) -> Array:
        """Bound the error over boxes, absolute or as a share of the value; infinite if unknown."""

        def compute(part: Boxes, forced: tuple[int, ...]) -> Array:
            analysis = self._analyse(part, forced)
            one = analysis.variables.constant(ONE)
            relative = self.convention.relative
            bar = ErrorScale(None, True) if relative else ErrorScale(one, False)
            return np.broadcast_to(analysis.sum_errors(self.straight.outputs[0], bar), len(part))

        # EPS is a power of two, so this product is exact.
        return bound_in_groups(compute, boxes) * EPS

    def _analyse(self, boxes: Boxes, forced: tuple[int, ...]) -> ErrorAnalysis:
        spans = list_spans(boxes)
        positive = [bool(np.all(boxes[:, i, 0] >= 0)) for i in range(boxes.shape[1])]
        poles = sum(step.kind == "tan" for step in self.straight.steps)
        variables = BoxVariables(spans, positive, poles, forced)
        given = {name: variables.variable(i) for i, name in enumerate(self.straight.inputs)}
        return ErrorAnalysis(self.straight, variables, given, {}, None, has_grids=True)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """List the assumptions that the bound rests on, as texts."""
        kinds = sorted({step.kind for step in self.straight.steps} & FUNCTIONS.keys())
        within = f"{self.convention.ulps:g} ulp"
        return (*(f"{kind} within {within}" for kind in kinds), NORMAL)


def put_in_box(
    straight: StraightLineProgram, ranges: Mapping[str, Range], convention: Convention
) -> BoxedProgram:
    """Return a program over a box; ValueError for operations without a rule or empty ranges."""
    if not straight.inputs:
        raise ValueError("it has no letters, so there is no box to bound it over")
    if unknown := sorted({step.kind for step in straight.steps} - KINDS):
        raise ValueError(f"roundings of {', '.join(unknown)} cannot be bounded")
    steps = tuple(_state_error(step, convention) for step in straight.steps)
    straight = share_equal_steps(replace(straight, steps=steps))
    straight = keep_needed(straight)
    if convention.rounded_inputs:
        straight = _round_inputs(straight)
    box = tuple(_enclose(name, ranges[name], convention) for name in straight.inputs)
    ranges = {name: ranges[name] for name in straight.inputs}
    return BoxedProgram(straight, ranges, box, convention)


def _state_error(step: Step, convention: Convention) -> Step:
    """Return a step with the error that a convention states; a quotient of numbers is one number.

    Rounded to nearest, such a quotient is the double nearest to the fraction.
    """
    if step.kind == "divide" and not any(isinstance(o, str) for o in step.operands):
        above, below = (Fraction(o) for o in step.operands)
        step = replace(step, kind=CONSTANT, operands=(name_constant(above / below),))
    return replace(step, ulps=convention.ulps) if step.kind in FUNCTIONS else step


def _round_inputs(straight: StraightLineProgram) -> StraightLineProgram:
    names: dict[Operand, str] = {name: f"rounded {name}" for name in straight.inputs}
    first = (Step(rounded, "copy", (name,), HALF) for name, rounded in names.items())
    return replace(straight, steps=(*first, *straight.rename(names).steps))


def _enclose(name: str, ends: Range, convention: Convention) -> Side:
    """Return the outermost doubles within a range or, if inputs are rounded, those enclosing it."""
    low, high = (float(end) for end in ends)
    inward = not convention.rounded_inputs
    if low != ends[0] and (low < ends[0]) is inward:
        low = math.nextafter(low, math.inf if inward else -math.inf)
    if high != ends[1] and (high > ends[1]) is inward:
        high = math.nextafter(high, -math.inf if inward else math.inf)
    if low > high:
        raise ValueError(f"{name}: no double lies in [{ends[0]}, {ends[1]}]")
    return low, high


@dataclass(frozen=True)
class WorstInput:
    """The exact inputs of the worst error found, and that error, absolute or relative."""

    error: float
    at: Mapping[str, Fraction]


def find_worst_input(program: BoxedProgram, boxes: Sequence[Box]) -> WorstInput | None:
    """Return the worst input found by a climb from points of boxes; None without a finite error."""
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
    """Return the error at exact inputs, measured in balls; -1 outside the ranges.

    Also -1 for results that are not finite or below the normal range.
    """
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
        # The lower end of the ball: the error is certainly at least that.
        return float(error.lower()) if error.is_finite() else -1.0


def _draw(side: tuple[float, float], rng: np.random.Generator) -> Array:
    """Draw doubles from a side, including its ends."""
    drawn = rng.uniform(*side, DRAWN)
    drawn[:2] = side
    return np.clip(drawn, *side)


def _take_exactly(point: Sequence[float], count: int) -> Iterator[Fraction]:
    """Yield the real numbers represented by doubles and shares of the way to the next midpoints."""
    shares = point[count:] or [0.0] * count
    for double, share in zip(point[:count], shares, strict=True):
        share = min(max(share, -NEAREST), NEAREST)
        gap = Fraction(float(np.nextafter(double, np.copysign(np.inf, share)))) - Fraction(double)
        yield Fraction(double) + abs(Fraction(share)) * gap / 2


def _estimate(program: BoxedProgram, points: Points) -> Array:
    """Estimate the error in long doubles; -1 outside the box."""
    count = len(program.box)
    doubles = points[:count]
    inside = np.ones(len(doubles[0]), bool)
    given: dict[str, Any] = {}
    for i, (name, side) in enumerate(zip(program.straight.inputs, program.box, strict=True)):
        inside &= (doubles[i] >= side[0]) & (doubles[i] <= side[1])
        given[name] = doubles[i].astype(LONG_DOUBLE)
        if len(points) > count:
            share = np.clip(points[count + i], -NEAREST, NEAREST)
            gap = np.nextafter(doubles[i], np.copysign(np.inf, share)) - doubles[i]
            given[name] = given[name] + np.abs(share).astype(LONG_DOUBLE) * gap / 2
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
