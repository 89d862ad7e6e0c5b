"""Boxed programs: in, steps and the box of their inputs; out, a bound of the error over it.

The absolute error or that relative to the exact value, as FPTaylor (Solovyev et al. 2018) has them.
Inputs are doubles, or real numbers whose rounding is a step of its own.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from mechproof.arithmetic.cover import Box, Boxes, Side
from mechproof.arithmetic.intervals import EPS, ONE, Array, list_spans
from mechproof.programs.program import Operand
from mechproof.roundoff.bound import KINDS, ErrorAnalysis, ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables, bound_in_groups
from mechproof.roundoff.premises import FUNCTIONS, NORMAL
from mechproof.roundoff.steps import (
    CONSTANT,
    HALF,
    Step,
    StraightLineProgram,
    keep_needed,
    name_constant,
)
from mechproof.roundoff.written_scales import share_equal_steps

Range = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Convention:
    """What is counted: inputs that are rounded, an error relative to the value.

    `ulps` is what a function of a library is off by at most, in ulps of its result.
    """

    rounded_inputs: bool = False
    relative: bool = False
    ulps: float = 1.0

    def __post_init__(self) -> None:
        if not HALF <= self.ulps <= 2.0**20:
            raise ValueError(f"ulps = {self.ulps}: must satisfy 0.5 <= ulps <= 2**20")


@dataclass(frozen=True)
class BoxedProgram:
    """Steps with one output, the ranges of its inputs, and the box of doubles that has them."""

    straight: StraightLineProgram
    ranges: Mapping[str, Range]
    box: Box
    convention: Convention

    def bound(self, boxes: Boxes) -> Array:
        """Bound the error over boxes, as a number or a share of the value; infinite if unknown."""

        def compute(part: Boxes, forced: tuple[int, ...]) -> Array:
            analysis = self._analyse(part, forced)
            one = analysis.variables.constant(ONE)
            relative = self.convention.relative
            bar = ErrorScale(None, True) if relative else ErrorScale(one, False)
            return np.broadcast_to(analysis.sum_errors(self.straight.outputs[0], bar), len(part))

        # A power of two: nothing is rounded.
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
        """List what the bound rests on."""
        kinds = sorted({step.kind for step in self.straight.steps} & FUNCTIONS.keys())
        within = f"{self.convention.ulps:g} ulp"
        return (*(f"{kind} within {within}" for kind in kinds), NORMAL)


def put_in_box(
    straight: StraightLineProgram, ranges: Mapping[str, Range], convention: Convention
) -> BoxedProgram:
    """Return a program over a box; ValueError for operations without a rule, and empty ranges."""
    if not straight.inputs:
        raise ValueError("it has no letter, so that there is no box to bound it over")
    if unknown := sorted({step.kind for step in straight.steps} - KINDS):
        raise ValueError(f"no rounding of {', '.join(unknown)} can be bounded")
    steps = tuple(_state_error(step, convention) for step in straight.steps)
    straight = share_equal_steps(replace(straight, steps=steps))
    straight = keep_needed(straight)
    if convention.rounded_inputs:
        straight = _round_inputs(straight)
    box = tuple(_enclose(name, ranges[name], convention) for name in straight.inputs)
    ranges = {name: ranges[name] for name in straight.inputs}
    return BoxedProgram(straight, ranges, box, convention)


def _state_error(step: Step, convention: Convention) -> Step:
    """Return a step with what is known of its error, of a quotient of two numbers as of one.

    To nearest, a quotient of two numbers is the double that is nearest to the fraction.
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
    """Return the doubles of a range, or those between which its real numbers lie."""
    low, high = (float(end) for end in ends)
    inward = not convention.rounded_inputs
    if low != ends[0] and (low < ends[0]) is inward:
        low = math.nextafter(low, math.inf if inward else -math.inf)
    if high != ends[1] and (high > ends[1]) is inward:
        high = math.nextafter(high, -math.inf if inward else math.inf)
    if low > high:
        raise ValueError(f"{name}: no double is in [{ends[0]}, {ends[1]}]")
    return low, high
