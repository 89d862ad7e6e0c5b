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
from mechproof.roundoff.germs import Ball, Frame, Germ, ball_between
from mechproof.roundoff.rules import RULES, Slopes
from mechproof.roundoff.running import ARITHMETIC
from mechproof.roundoff.steps import HALF, Step, Straight

UNIT = 2.0**-53
EPS = 2.0**-52
BITS = 53
# Of a power of two: less than a quarter of the spacing below it.
HARDLY = 56
# What 28 bits of pi leave of it, which the reduction multiplies by the number of half turns.
# Where they are exact or a rounding away from it: `compensation` shows that nothing moves them.
RESTS = ("product_rest", "quotient_rest")
PI_REST = 2.0**-26


@dataclass(frozen=True)
class Bar:
    """What errors are relative to: a scale, or the value; whether it is at least the value."""

    scale: Germ | None
    holds_value: bool


@dataclass
class Moving:
    """The value of a step before its rounding, its slopes, and the size of its rounding."""

    step: Step
    exact: Germ
    slopes: Slopes
    relative: Ball
    absolute: Ball | None


class Evaluation:
    """The steps over one box: values forward, derivatives in reverse."""

    def __init__(
        self,
        straight: Straight,
        frame: Frame,
        given: Mapping[str, Germ],
        stated: Mapping[str, Germ],
        turn: Turn | None,
    ) -> None:
        self.frame, self.turn, self.held = frame, turn, straight.held
        self.values: dict[str, Germ] = dict(given)
        # What is computed, its rounding known to be monotone; not what lies on the way to it.
        self.computed = {name: germ.expanded() for name, germ in given.items()}
        self.moving: list[Moving] = []
        for step in straight.steps:
            self.values[step.result] = self._move(step, stated.get(step.result))

    def value(self, operand: Operand) -> Germ:
        """Return the germ of a result, an input or a number."""
        if isinstance(operand, str):
            return self.values[operand]
        return self.frame.constant(arb(operand))

    def _move(self, step: Step, stated: Germ | None) -> Germ:
        given = [self.value(operand) for operand in step.operands]
        if step.kind == "pi_off":
            return self._take_half_turns_off(step, given[0])
        if step.kind == "small_tangent":
            return self._take_small_tangent(step, given[0])
        if step.kind in RESTS:
            # Of what is compensated: a rounding of its own, which nothing here moves.
            rest = given[2].scaled(arb(0, UNIT * (1 + EPS)))
            return self._round(step, rest, (None, None, None))
        if step.kind in ("copy", "approximate"):
            return self._round(step, given[0], (self.frame.constant(arb(1)),))
        exact, slopes = RULES[step.kind](given, self.turn)
        is_exact = step.kind == "subtract" and _is_near(*given)
        return self._round(step, stated or exact, slopes, is_exact)

    def _round(self, step: Step, exact: Germ, slopes: Slopes, is_exact: bool = False) -> Germ:
        relative = 0.0 if is_exact else EPS * step.ulps
        before = self._compute(step, exact)
        limit = None if is_exact or step.kind == "approximate" else _limit(step, before)
        self.computed[step.result] = _round_ends(before, step.ulps)
        self.moving.append(Moving(step, exact, slopes, arb(relative), limit))
        return exact.scaled(arb(1, relative)) if relative else exact

    def _compute(self, step: Step, exact: Germ) -> Ball:
        """Enclose the operation at the computed operands."""
        whole = exact.expanded()
        if step.kind not in ARITHMETIC:
            return whole
        given = [self.computed[o] if isinstance(o, str) else arb(o) for o in step.operands]
        found = ARITHMETIC[step.kind](*given)
        return found if found.is_finite() and not found.rad() > whole.rad() else whole

    def _take_small_tangent(self, step: Step, angle: Germ) -> Germ:
        """Take y for tan(y), off by at most y**2 of itself where |y| <= 1."""
        size: Ball = abs(angle.expanded()).upper()
        off = size**2 if size <= 1 else arb("nan")
        # Beyond a turn it is small as a number, not as a share of the angle.
        small = self.frame.constant(angle.expanded()) if self.turn else angle
        exact = small.scaled(1 + off.union(arb(0)))
        slope = self.frame.constant(arb(1)) + exact.squared()
        self.moving.append(Moving(step, exact, (slope,), off, None))
        value = exact.scaled(1 + arb(0, 1) * off)
        self.computed[step.result] = value.expanded()
        return value

    def _take_half_turns_off(self, step: Step, angle: Germ) -> Germ:
        """Reduce as the support does: exact without a turn, else off by two roundings."""
        exact, error = angle, None
        if self.turn is not None:
            turns = abs(angle.expanded()).upper() / 3 + 1
            exact = self.frame.constant(reduce(angle, self.turn, 2))
            error = (abs(exact.ball).upper() + 2 * PI_REST * turns) * UNIT
        self.moving.append(Moving(step, exact, (self.frame.constant(arb(1)),), arb(0), error))
        value = exact if error is None else self.frame.constant(exact.ball + arb(0, error))
        self.computed[step.result] = value.expanded()
        return value

    def sum_errors(self, output: Operand, bar: Bar) -> float:
        """Bound the error of an output in eps of a scale; infinite where it cannot be bounded."""
        total = sum(self.list_errors(output, bar).values(), arb(0))
        return float(total.upper()) if total.is_finite() else math.inf

    def list_errors(self, output: Operand, bar: Bar) -> dict[str, Ball]:
        """Bound what each step adds to the error of an output, in eps of the scale."""
        one = self.frame.constant(arb(1))
        inverses = [one / scale for scale in self._list_scales(output, bar)]
        slopes = {output: one}
        errors = {}
        for moving in reversed(self.moving):
            slope = slopes.pop(moving.step.result, None)
            if slope is None or moving.step.result in self.held:
                continue
            errors[moving.step.result] = _weigh([slope * over for over in inverses], moving)
            if moving.relative != 0:
                slope = slope.scaled(1 + arb(0, 1) * moving.relative)
            if moving.step.result == output and bar.holds_value:
                # The rounding of the value itself, of which the scale has no less.
                errors[output] = _least([errors[output], moving.relative / EPS])
            for operand, own in zip(moving.step.operands, moving.slopes, strict=True):
                if own is not None and isinstance(operand, str):
                    part = slope * own
                    slopes[operand] = slopes[operand] + part if operand in slopes else part
        return errors

    def _list_scales(self, output: Operand, bar: Bar) -> list[Germ]:
        """List what the scale is at least: the value, and each of two terms of one sign."""
        scales = [bar.scale] if bar.scale else []
        value = self.value(output)
        if not bar.holds_value:
            return scales
        last = next((m.step for m in self.moving if m.step.result == output), None)
        terms = [self.value(o) for o in last.operands] if last and last.kind == "add" else []
        signs = {term.sign for term in terms}
        return [*scales, value, *(terms if signs in ({1}, {-1}) else [])]


def _weigh(slopes: Sequence[Germ], moving: Moving) -> Ball:
    """Bound a step's share by the size of its result and by the spacing of doubles there."""
    bounds = []
    for slope in slopes:
        if moving.relative != 0:
            share: Ball = abs((slope * moving.exact).expanded())
            bounds.append(share * (moving.relative / EPS))
        if moving.absolute is not None:
            bounds.append(abs(slope.expanded()) * (moving.absolute / EPS))
    return _least(bounds) if bounds else arb(0)


def _least(bounds: Sequence[Ball]) -> Ball:
    """Return the lowest of bounds of one thing; those that are not finite say nothing."""
    finite = [bound.upper() for bound in bounds if bound.is_finite()]
    return min(finite) if finite else bounds[0]


def _is_near(a: Germ, b: Germ) -> bool:
    """Say whether two doubles differ by at most a factor of two: their difference is exact."""
    one, other = a.expanded(), b.expanded()
    return bool(2 * other.lower() >= one.upper() and other.upper() <= 2 * one.lower())


def _limit(step: Step, before: Ball) -> Ball | None:
    """Bound a rounding by the spacing of doubles at the largest result."""
    largest = abs(before).upper()
    if not step.ulps or not largest.is_finite() or largest == 0:
        return None
    share, exponent = math.frexp(float(largest))
    excess = largest - 2.0 ** (exponent - 1)
    if step.ulps <= HALF == share and excess <= 2.0 ** (exponent - HARDLY):
        # A power of two is a double: what is hardly above it is off by less than what is below.
        exponent -= 1
    spacing = arb(step.ulps * 2.0 ** (exponent - BITS))
    low, high = float(before.lower()), float(before.upper())
    return abs(before - low).upper() if low == high and step.ulps <= HALF else spacing


def _round_ends(before: Ball, ulps: float) -> Ball:
    """Enclose the rounded value: to round to nearest keeps the order."""
    if not ulps or not before.is_finite():
        return before
    if ulps > HALF:
        return before * arb(1, EPS * ulps)
    return ball_between(float(before.lower()), float(before.upper()))
