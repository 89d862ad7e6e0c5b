"""Bound: in, steps and boxes of variables; out, a bound on how far all roundings move the result.

Each step is its operation times 1 + d, with its own d. By the mean value theorem the error is at
most the sum over the steps of |dF/dd| at some d within the bounds: the derivatives are taken in
reverse over intervals that contain every such d, so no second-order term is lost. Rounding follows
Higham's standard model (2002, chapter 2). FPTaylor (Solovyev et al. 2018) bounds the same sum at
d = 0 and adds a bound of the second order; here there is none to add. A relative error is also
added up by condition numbers (`condition_numbers`): as all roundings grow from zero, the value
changes by shares of itself; shares with the sum C change it by a share of at most exp(C) - 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from mechproof.arithmetic.balls import to_ball, working_precision
from mechproof.arithmetic.intervals import (
    EPS,
    ONE,
    Ends,
    Interval,
    Mask,
    around,
    enclose_ball,
    exactly,
)
from mechproof.programs.operations import COMPARISONS
from mechproof.programs.program import Operand
from mechproof.roundoff.angles import Turn, reduce
from mechproof.roundoff.condition_numbers import (
    RoundedStep,
    take_least,
)
from mechproof.roundoff.endpoint_rounding import (
    NO_GRID,
    Grid,
    RoundedEndpoints,
    are_doubles,
    find_grid,
    find_grid_of_number,
    find_own_grid,
    limit_by_spacing,
    limit_by_terms,
    round_endpoints,
    shifts,
    widen_by_ulps,
    within_one,
)
from mechproof.roundoff.error_sums import UNKNOWN, ErrorScale, ErrorSums
from mechproof.roundoff.error_tables import ErrorTable
from mechproof.roundoff.interval_monomials import BoxVariables, IntervalMonomial
from mechproof.roundoff.rules import RULES, Slopes, enclose_rest
from mechproof.roundoff.running import IN_DOUBLES, find_number
from mechproof.roundoff.steps import CHOICE, CONSTANT, EXACT, HALF, RESTS, Step, StraightLineProgram

# Precision, in bits, at which the rounding errors of constants are computed.
CONSTANT_BITS = 256
# Functions whose values never exceed 1 in size.
LIMITED = ("sin", "cos")
# The kinds of operation whose rounding can be bounded.
KINDS = frozenset({*RULES, *RESTS, CONSTANT, "small_tangent", "copy", "approximate"})


class ErrorAnalysis(ErrorSums):
    """An analysis of steps over many boxes: values forward, derivatives in reverse.

    With `has_grids`, every input must be a double, unless it is rounded before any other use.
    """

    def __init__(
        self,
        straight: StraightLineProgram,
        variables: BoxVariables,
        given: Mapping[str, IntervalMonomial],
        stated: Mapping[str, IntervalMonomial],
        turn: Turn | None,
        find_profile: Callable[[str], ErrorTable] | None = None,
        *,
        has_grids: bool = False,
    ) -> None:
        self.variables, self.turn, self.held = variables, turn, straight.held
        self._scaled, self._find_profile = frozenset(straight.scaled), find_profile
        self.values: dict[str, IntervalMonomial] = dict(given)
        # Enclosures of the computed results, using that rounding is monotone; `values` also enclose
        # everything between these and the exact results.
        self.computed = {
            name: UNKNOWN if name in self._scaled else monomial.expanded()
            for name, monomial in given.items()
        }
        self._grids: dict[str, Grid] | None = None
        if has_grids:
            self._grids = {name: find_own_grid(span) for name, span in self.computed.items()}
        self.rounded: list[RoundedStep] = []
        self._is_exact = all(step.ulps == EXACT for step in straight.steps)
        self.made = frozenset(step.result for step in straight.steps)
        for step in straight.steps:
            self._move(step, stated.get(step.result))

    def _move(self, step: Step, stated: IntervalMonomial | None) -> None:
        if step.kind == CONSTANT:
            self._take_constant(step)
            return
        given = [self.value(operand) for operand in step.operands]
        if step.kind == "small_tangent":
            self._take_small_tangent(step, given[0])
        elif step.kind in RESTS:
            # The rest of a compensated operation counts as an independent value, which no operand
            # moves.
            self._round(step, enclose_rest(given[2]), (None, None, None))
        elif step.kind in COMPARISONS or step.kind == CHOICE:
            self._decide(step, given)
        elif step.kind in ("copy", "approximate"):
            self._round(step, given[0], (self._one,))
        else:
            exact, slopes = self._apply(step, given)
            if step.proved and step.ulps:
                # Error tables of functions of two arguments are indexed by the quotient.
                error = self._look_up(step, given[0] / given[1] if given[1:] else given[0]) * EPS
                self._add(
                    step, exact, slopes, error, None, exact.scaled(around(1.0, error)).expanded()
                )
            else:
                self._round(step, stated or exact, slopes, self._are_exact(step, given))

    def _apply(
        self, step: Step, given: Sequence[IntervalMonomial]
    ) -> tuple[IntervalMonomial, Slopes]:
        exact, find_slopes = RULES[step.kind](self.turn, *given)
        return exact, (None,) * len(given) if self._is_exact else find_slopes()

    def _decide(self, step: Step, given: Sequence[IntervalMonomial]) -> None:
        """Add the result of a comparison or a choice.

        Where roundings may flip the test, the error may be as large as the difference of the two
        sides (Goubault and Putot 2013), in addition to their own errors.
        """
        exact, slopes = self._apply(step, given)
        jump: Ends = np.float64(0.0)
        if step.kind == CHOICE and all(slopes[1:]) and not self._is_exact:
            jump = (given[1] - given[2]).expanded().largest()
        self._add(step, exact, slopes, np.float64(0.0), jump, exact.expanded())

    def _take_constant(self, step: Step) -> None:
        (operand,) = step.operands
        double = float(IN_DOUBLES[CONSTANT](operand))
        with working_precision(CONSTANT_BITS):
            ball = to_ball(find_number(operand))
            exact, off = enclose_ball(ball), enclose_ball(to_ball(double) / ball - 1)
        self.rounded.append(
            RoundedStep(step, self.variables.constant(exact), (None,), off.largest(), None, off)
        )
        self.computed[step.result] = exactly(double)
        if self._grids is not None:
            self._grids[step.result] = find_grid_of_number(double)
        self.values[step.result] = self.variables.constant(exact.union(exactly(double)))

    def _look_up(self, step: Step, monomial: IntervalMonomial) -> Ends:
        """Return the proved bound on a function's error, in eps of its value."""
        assert self._find_profile is not None
        error_table, argument = self._find_profile(step.proved), monomial.expanded()
        if error_table.is_of_angles:
            return error_table.of_angle(argument, reduce(monomial, self.turn, 2).expanded())
        if np.any(argument.largest() > error_table.legal):
            argument = error_table.limit(argument, self._sum_all(step.operands[0]))
        return error_table.of_size(argument.size())

    def _sum_all(self, operand: Operand) -> Ends:
        """Bound the absolute error of an operand; ValueError if held roundings are not counted."""
        if self.held:
            raise ValueError(f"{operand}: an argument may be off by held values: {self.held}")
        return self.sum_errors(operand, ErrorScale(self._one, False)) * EPS

    def _round(
        self, step: Step, exact: IntervalMonomial, slopes: Slopes, is_exact: Mask = False
    ) -> None:
        if self._is_exact:
            # Where nothing is rounded, the enclosure of the computed result is never used.
            self._add(step, exact, slopes, np.float64(0.0), None, UNKNOWN)
            return
        given = [self.computed[o] if isinstance(o, str) else exactly(o) for o in step.operands]
        if any(span is UNKNOWN for span in given):
            found = RoundedEndpoints(exact.expanded(), lambda: np.inf)
        else:
            found = round_endpoints(step.kind, given, exact.expanded())
        if step.ulps <= HALF and step.kind in LIMITED:
            # Correct rounding keeps a value of at most 1 at most 1; a less accurate library may
            # exceed it.
            found = RoundedEndpoints(within_one(found.span), lambda: 0.0)
        limit = None
        is_rounded = step.kind != "approximate"
        is_exact, grid = is_exact | shifts(step.kind, given), NO_GRID
        if self._grids is not None:
            grid = find_grid(step.kind, [self._find_grid(o, self._grids) for o in step.operands])
            is_exact = is_exact | are_doubles(grid, found.span)
        relative = np.where(is_exact, 0.0, EPS * step.ulps)
        if step.ulps and is_rounded:
            limit = limit_by_spacing(found, step.ulps)
            if step.result in self._scaled:
                # The terms of a scaled result are doubles too, but times an unknown factor, so
                # their spacing is unknown.
                limit, given = np.inf, [self.value(o).expanded() for o in step.operands]
            if step.ulps <= HALF:
                limit = take_least(limit, limit_by_terms(step.kind, given))
            limit = np.where(is_exact, 0.0, limit)
        span = (
            found.span if is_rounded and step.ulps <= HALF else widen_by_ulps(found.span, step.ulps)
        )
        self._add(step, exact, slopes, relative, limit, span)
        if self._grids is not None and is_rounded and self.computed[step.result] is not UNKNOWN:
            self._grids[step.result] = np.maximum(grid, find_own_grid(span))

    @staticmethod
    def _find_grid(operand: Operand, grids: Mapping[str, Grid]) -> Grid:
        if isinstance(operand, str):
            return grids.get(operand, NO_GRID)
        return find_grid_of_number(operand)

    def _add(
        self,
        step: Step,
        exact: IntervalMonomial,
        slopes: Slopes,
        relative: Ends,
        absolute: Ends | None,
        computed: Interval,
    ) -> None:
        """Record a step with bounds on its rounding error, relative to the value and absolute."""
        if step.result in self._scaled:
            computed = UNKNOWN
        self.rounded.append(RoundedStep(step, exact, slopes, relative, absolute))
        self.computed[step.result] = computed
        moved = exact.scaled(around(1.0, relative)) if np.any(relative) else exact
        self.values[step.result] = moved

    def _take_small_tangent(self, step: Step, angle: IntervalMonomial) -> None:
        """Add a step that takes y for tan(y): off by at most a share y**2 where |y| <= 1."""
        size = angle.expanded().largest()
        off = np.where(size <= 1, size**2, np.nan) * (1 + EPS)
        # Once reduced by whole turns it is a small number, not a small share of the whole angle.
        small = self.turn.share(angle) if self.turn else angle
        exact = small.scaled(ONE.union(around(1.0, off)))
        value = exact.scaled(around(1.0, off))
        self._add(step, exact, (self._one + exact.power(2),), off, None, value.expanded())

    def _are_exact(self, step: Step, given: Sequence[IntervalMonomial]) -> Mask:
        """Return where a subtraction is exact as its operands are within a factor of two."""
        if step.kind != "subtract" or step.result in self._scaled:
            return False
        one, other = (monomial.expanded() for monomial in given)
        # Sterbenz's lemma (1974); for negative numbers the two conditions cannot both hold.
        return (2 * other.low >= one.high) & (other.high <= 2 * one.low)
