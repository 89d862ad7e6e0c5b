"""Error sums: in, steps with slopes and roundings over boxes; out, bounds on a result's error.

One backward pass gives the derivative of a result with respect to each step. The effects of
all roundings are added up in eps of a scale, and by condition numbers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from mechproof.arithmetic.intervals import EPS, ONE, Ends, Interval, around, exactly
from mechproof.programs.program import Operand
from mechproof.roundoff.condition_numbers import (
    CarriedConditions,
    RoundedStep,
    find_condition_numbers,
    spread,
    take_least,
)
from mechproof.roundoff.interval_monomials import BoxVariables, IntervalMonomial
from mechproof.roundoff.steps import CONSTANT, RESTS, Step

UNKNOWN = exactly(np.nan)


@dataclass(frozen=True)
class ErrorScale:
    """The quantity that errors are relative to: a scale, or the value itself if `scale` is None.

    `holds_value` states that the scale is at least the value. In absolute values, `terms`, if any,
    and the value, if it is held, add up to the scale. Each of `least` is a lower bound of it.
    """

    scale: IntervalMonomial | None
    holds_value: bool
    terms: Sequence[IntervalMonomial] = ()
    least: Sequence[IntervalMonomial] = ()


class ErrorSums:
    """The rounded steps of a program over boxes, and how far they move its results.

    `values` enclose each result with its errors, `made` names those that steps compute, and `held`
    those whose own roundings are not counted.
    """

    variables: BoxVariables
    values: dict[str, IntervalMonomial]
    rounded: list[RoundedStep]
    held: Collection[str]
    made: Collection[str]

    def value(self, operand: Operand) -> IntervalMonomial:
        """Return the monomial that encloses a result, an input or a number."""
        if isinstance(operand, str):
            return self.values[operand]
        return self.variables.constant(exactly(operand))

    @property
    def _one(self) -> IntervalMonomial:
        return self.variables.constant(ONE)

    def sum_errors(self, output: Operand, bar: ErrorScale) -> Ends:
        """Bound the error of an output in eps of a scale; infinite where it cannot be bounded."""
        total = sum(self.list_errors(output, replace(bar, terms=())).values(), np.float64(0.0))
        if bar.terms and (bar.scale is None or np.any(bar.scale.is_wide)):
            shares = self._list_shares(output, bar).values()
            total = take_least(total, spread([*shares], len(bar.terms) + bar.holds_value))
        # The first factor covers the roundings of the sum; the second is needed because errors are
        # relative to a value that some of the roundings have already moved.
        total = total * (1 + EPS * len(self.rounded)) * (1 + 2 * EPS * total)
        return np.where(np.isfinite(total), total, np.inf)

    def list_errors(self, output: Operand, bar: ErrorScale) -> dict[str, Ends]:
        """Bound each step's contribution to the error of an output, in eps of the scale."""
        return {r: take_least(*found) for r, found in self._list_shares(output, bar).items()}

    def list_moves(self, output: Operand, scale: IntervalMonomial) -> dict[str, Interval]:
        """Return how far the largest rounding of each step moves an output, in eps of a scale.

        The signs refer to the same rounding of a step for every output, so moves can be combined.
        """
        inverse = self._one / scale
        return {
            rounded.step.result: rounded.move((slope * inverse * rounded.exact).expanded())
            for rounded, slope in self._pass_back(output)
        }

    def _pass_back(self, output: Operand) -> Iterator[tuple[RoundedStep, IntervalMonomial]]:
        """Yield the steps, last first, each with the output's derivative with respect to it."""
        slopes = {output: self._one}
        # One backward pass serves all steps: when a step is met, its whole effect on the output is
        # known.
        for rounded in reversed(self.rounded):
            slope = slopes.pop(rounded.step.result, None)
            if slope is None or rounded.step.result in self.held:
                continue
            yield rounded, slope
            if np.any(rounded.relative) and rounded.known is None:
                slope = slope.scaled(around(1.0, rounded.relative))
            for operand, own in zip(rounded.step.operands, rounded.slopes, strict=True):
                if own is not None and isinstance(operand, str):
                    part = slope * own
                    # Summed before any absolute value is taken: the slopes of a value that is used
                    # twice may cancel.
                    slopes[operand] = slopes[operand] + part if operand in slopes else part

    def _list_shares(self, output: Operand, bar: ErrorScale) -> dict[str, list[Ends]]:
        """Bound each step's contribution to the error, in eps of each lower bound of the scale."""
        scales = self._list_scales(output, bar)
        inverses = [self._one / scale for scale in scales]
        # The output's condition number with respect to itself is known from the start: 1.
        value = self.value(output)
        carried = CarriedConditions(output, [ONE if s is value else UNKNOWN for s in scales])
        errors: dict[str, list[Ends]] = {}
        numbers = None
        for rounded, slope in self._pass_back(output):
            if rounded.known is not None:
                # The errors of constants are known, so they add up with their signs.
                part = (slope * rounded.exact).scaled(rounded.known)
                numbers = part if numbers is None else numbers + part
                continue
            overs = [slope * inverse for inverse in inverses]
            found = [(over * rounded.exact).expanded() for over in overs]
            conditions = carried.take(rounded.step.result, found)
            errors[rounded.step.result] = rounded.weigh(overs, conditions)
            if bar.holds_value:
                self._carry(rounded, conditions, carried)
            if rounded.step.result == output and np.any(rounded.relative):
                shares = errors[rounded.step.result]
                if bar.holds_value:
                    # The last rounding is a share of the value, and the scale is at least the
                    # value.
                    place = len(shares) - len(bar.terms) - 1
                    shares[place] = take_least(shares[place], rounded.relative / EPS)
                elif bar.least:
                    share = self._compare_terms(rounded.step, inverses)
                    shares[0] = take_least(shares[0], rounded.relative / EPS * share)
        if numbers is not None:
            sizes = [(numbers * inverse).expanded().largest() for inverse in inverses]
            errors[CONSTANT] = [size / EPS for size in sizes]
        return errors

    def _compare_terms(self, step: Step, inverses: Sequence[IntervalMonomial]) -> Ends:
        """Bound a sum by its terms, each as a multiple of some lower bound of the scale."""
        if step.kind not in ("add", "subtract"):
            return np.inf
        a, b = (self.value(operand) for operand in step.operands)
        one, other = (
            take_least(*((term * inverse).expanded().largest() for inverse in inverses))
            for term in (a, b)
        )
        # The difference of two values of the same sign is no larger than the larger of them.
        is_difference = a.decide_sign() * b.decide_sign() == (-1 if step.kind == "add" else 1)
        return np.maximum(one, other) if is_difference else one + other

    def _carry(
        self, rounded: RoundedStep, conditions: Sequence[Interval], carried: CarriedConditions
    ) -> None:
        """Pass a step's condition numbers on to the steps that compute its operands."""
        step = rounded.step
        taken = [o if isinstance(o, str) and o in self.made else 0.0 for o in step.operands]
        if step.kind in RESTS or not any(taken):
            return
        given = [self.value(operand) for operand in step.operands]
        numbers = find_condition_numbers(step.kind, given, rounded.exact, rounded.slopes)
        carried.carry(conditions, rounded.relative, taken, numbers)

    def _list_scales(self, output: Operand, bar: ErrorScale) -> list[IntervalMonomial]:
        """List lower bounds of the scale: itself, the value, terms that add up to it, and so on."""
        scales = [bar.scale] if bar.scale else []
        value = self.value(output)
        if not bar.holds_value:
            return [*scales, *bar.least, *bar.terms]
        last = next((m.step for m in self.rounded if m.step.result == output), None)
        terms = [self.value(o) for o in last.operands] if last and last.kind == "add" else []
        signs = {term.decide_sign() for term in terms}
        return [*scales, *(terms if signs in ({1}, {-1}) else []), *bar.least, value, *bar.terms]
