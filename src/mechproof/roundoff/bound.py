"""Bound: in, steps and a frame of balls; out, the most by which all roundings move the result.

Each step is its operation times 1 + d with a d of its own. By the mean value theorem the error is
at most the sum over the steps of |dF/dd| at some d within the bounds: the derivatives are taken
in reverse over balls that hold every such d, so no term of second order is left out.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import arb

from mechproof.codegen.program import Operand
from mechproof.roundoff.angles import Turn, reduce
from mechproof.roundoff.germs import Ball, Frame, Germ
from mechproof.roundoff.rules import RULES
from mechproof.roundoff.steps import HALF, Step, Straight

UNIT = 2.0**-53
EPS = 2.0**-52
BITS = 53
# Of a power of two: less than a quarter of the spacing below it.
HARDLY = 56
# What 28 bits of pi leave of it, which the reduction multiplies by the number of half turns.
PI_REST = 2.0**-26


@dataclass
class Moving:
    """The value of a step before its rounding, its slopes, and the size of its rounding."""

    step: Step
    exact: Germ
    slopes: tuple[Germ, ...]
    relative: Ball
    absolute: Ball | None


class Evaluation:
    """The steps over one box: values forward, derivatives in reverse."""

    def __init__(
        self, straight: Straight, frame: Frame, given: Mapping[str, Germ], turn: Turn | None
    ) -> None:
        self.frame, self.turn = frame, turn
        self.values: dict[str, Germ] = dict(given)
        self.moving: list[Moving] = []
        for step in straight.steps:
            self.values[step.result] = self._move(step)

    def value(self, operand: Operand) -> Germ:
        """Return the germ of a result, an input or a number."""
        if isinstance(operand, str):
            return self.values[operand]
        return self.frame.constant(arb(operand))

    def _move(self, step: Step) -> Germ:
        given = [self.value(operand) for operand in step.operands]
        if step.kind == "pi_off":
            return self._take_half_turns_off(step, given[0])
        if step.kind in ("copy", "approximate"):
            exact, slopes = given[0], (self.frame.constant(arb(1)),)
        else:
            exact, slopes = RULES[step.kind](given, self.turn)
        relative = EPS * step.ulps
        self.moving.append(Moving(step, exact, slopes, arb(relative), _limit(step, exact)))
        return exact.scaled(arb(1, relative)) if relative else exact

    def _take_half_turns_off(self, step: Step, angle: Germ) -> Germ:
        """Reduce as the support does: exact without a turn, else off by two roundings."""
        one = self.frame.constant(arb(1))
        if self.turn is None:
            self.moving.append(Moving(step, angle, (one,), arb(0), None))
            return angle
        rest = reduce(angle, self.turn, 2)
        turns = abs(angle.expanded()).upper() / 3 + 1
        error = (abs(rest).upper() + 2 * PI_REST * turns) * UNIT
        exact = self.frame.constant(rest)
        self.moving.append(Moving(step, exact, (one,), arb(0), error))
        return self.frame.constant(rest + arb(0, error))

    def sum_errors(self, output: Operand, scale: Germ) -> float:
        """Bound the error of an output in eps of a scale; infinite where it cannot be bounded."""
        total = sum(self.list_errors(output, scale).values(), arb(0))
        return float(total.upper()) if total.is_finite() else math.inf

    def list_errors(self, output: Operand, scale: Germ) -> dict[str, Ball]:
        """Bound what each step adds to the error of an output, in eps of a scale."""
        slopes = {output: self.frame.constant(arb(1)) / scale}
        errors = {}
        for moving in reversed(self.moving):
            slope = slopes.pop(moving.step.result, None)
            if slope is None:
                continue
            errors[moving.step.result] = _weigh(slope, moving)
            if moving.step.ulps:
                slope = slope.scaled(arb(1, EPS * moving.step.ulps))
            for operand, own in zip(moving.step.operands, moving.slopes, strict=True):
                if isinstance(operand, str):
                    part = slope * own
                    slopes[operand] = slopes[operand] + part if operand in slopes else part
        return errors


def _weigh(slope: Germ, moving: Moving) -> Ball:
    """Bound a step's share by the size of its result and by the spacing of doubles there."""
    bounds = []
    if moving.relative != 0:
        bounds.append(abs((slope * moving.exact).expanded()) * (moving.relative / EPS))
    if moving.absolute is not None:
        bounds.append(abs(slope.expanded()) * (moving.absolute / EPS))
    finite = [bound.upper() for bound in bounds if bound.is_finite()]
    if not bounds:
        return arb(0)
    return min(finite) if finite else bounds[0]


def _limit(step: Step, exact: Germ) -> Ball | None:
    """Bound a rounding by the spacing of doubles at the largest result."""
    if not step.ulps or step.kind == "approximate":
        return None
    largest = abs(exact.expanded()).upper()
    if not largest.is_finite() or largest == 0:
        return None
    share, exponent = math.frexp(float(largest))
    excess = largest - 2.0 ** (exponent - 1)
    if step.ulps <= HALF == share and excess <= 2.0 ** (exponent - HARDLY):
        # A power of two is a double: what is hardly above it is off by less than what is below.
        exponent -= 1
    return arb(step.ulps * 2.0 ** (exponent - BITS))
