"""Building: in, a request; out, the cheapest model whose enclosed bound meets it.

Coefficients are rounded one by one; Brisebarre and Chevillard (2007) search for the best ones among
doubles. The enclosure includes the resulting loss.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import pairwise

import mpmath as mp
import numpy as np
from flint import arb, arb_series

from mechproof.arguments.scalars import refuse
from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import Series, list_terms, working
from mechproof.programs.elementary.fits import FIT_BITS, interpolate
from mechproof.programs.elementary.formats import DOUBLE, take_middle
from mechproof.tailoring.design import Array, Plan, Stretch, list_plans, plan_odd, plan_pieces
from mechproof.tailoring.enclosure import (
    Bound,
    BreakError,
    ExceededError,
    Repetition,
    bound_outside,
    enclose,
    seek_break,
)
from mechproof.tailoring.model import Model, PeriodReduction, Piece, Pieces
from mechproof.tailoring.request import Request

BITS = 53
# The most periods that can be subtracted, so that a word of the period still has enough bits.
MOST_PERIODS = 2**23
# Shares of the error that may be lost outside the polynomials where the range is free, and by one
# word of the period alone.
OUTSIDE, ONE_WORD = 0.25, 1 / 16
# Share of the remaining error at which the first plan aims, and shares of that for later plans,
# much lower in case the samples behind the plans miss something steep.
AIM = 0.8
LOWER = (1.0, 0.7, 0.5, 0.35, 0.25, 1e-2, 1e-3, 1e-4)
# Estimated relative rounding error of a polynomial.
ROUNDED = 2.0**-52
# How often and by what factor an error is raised until reachable; bisections that then lower it.
RAISED, STEP, CLOSER = 8, 8.0, 2
SLOPE_POINTS = 2049


class NotReachedError(ArithmeticError):
    """Raised if no plan meets the error."""


@dataclass(frozen=True)
class Built:
    """A model and its bound."""

    model: Model
    bound: Bound


class Approximand:
    """The function to approximate: on one period, less the gain, or on the range itself."""

    def __init__(self, request: Request, repetition: Repetition | None) -> None:
        self.request, self.repetition = request, repetition
        self._definition = request.define(request.quantity.definition)
        self._rate: Ball = repetition.rate if repetition else arb(0)
        self._slow = float(self._rate.mid())
        low, high = self.ends = self._find_ends()
        corners = request.corners(low, high)
        odd = repetition is not None and self._is_odd(high)
        self.stretch = Stretch(
            self.approximate, 0.0 if odd else low, high, odd, repetition is not None, corners
        )
        points = np.linspace(low, high, SLOPE_POINTS)
        values = self.approximate(points)
        self.size = float(np.max(np.abs(values)))
        with np.errstate(all="ignore"):
            self.slope = float(np.max(np.abs(np.gradient(values, points))))

    def _find_ends(self) -> tuple[float, float]:
        if self.repetition is None:
            assert self.request.ends is not None
            return self.request.ends
        half = float(self.repetition.period.mid()) / 2
        return -half, half

    def _is_odd(self, end: float) -> bool:
        """Guess whether the function is odd; the resulting model is enclosed on both sides."""
        points = np.linspace(0, end, 33)
        sums = self.approximate(points) + self.approximate(-points)
        return bool(np.max(np.abs(sums)) <= 2.0**-46 * np.max(np.abs(self.approximate(points))))

    def approximate(self, points: Array) -> Array:
        """Return the function at points, computed by the shipped kernel."""
        return self.request.kernel(points) - self._slow * points

    def expand(self, place: Series) -> Series:
        """Return the function as a series."""
        value = self._definition.expand(place)
        return value - self._rate * place if self.repetition else value

    def exact(self, place: Ball) -> Ball:
        """Return the function at a place, in balls."""
        return list_terms(self.expand(arb_series([place])))[0]


def build(request: Request) -> Built:
    """Build the model; raise ValueError if the error cannot be reached."""
    task = Approximand(request, _repetition_over(request))
    if not math.isfinite(task.size):
        refuse(
            request.variable, request.ends, f"{request.name} is undefined somewhere in this range"
        )
    try:
        try:
            return _build(task, request.error)
        except NotReachedError:
            seek_break(task.expand, *task.ends)
            least = _find_reachable(task)
    except NotReachedError:
        refuse("error", request.error, "no kernel tailored to these sizes comes near it")
    except BreakError as error:
        what = f"{request.name} jumps or is undefined near {error.place:.9g}"
        refuse(request.variable, request.ends, f"{what}: give a range on one side of it")
    where = f"for {request.variable} = {request.ends}" if request.ends else "over one period"
    refuse("error", request.error, f"must be at least {least}: hardly less can be reached {where}")


def _repetition_over(request: Request) -> Repetition | None:
    """Return the repetition; None without one, or if the range is shorter than a period."""
    found, ends = request.repetition(), request.ends
    is_short = ends is not None and found is not None and ends[1] - ends[0] < found.period
    return None if is_short else found


def _find_reachable(task: Approximand) -> str:
    """Return roughly the smallest error that can be reached."""
    error = max(task.request.error, ROUNDED * task.size)
    error = max(error, _lose_outside(task, *_choose_range(task, error)))
    for _ in range(RAISED):
        error = float(round_up(error * STEP))
        with suppress(NotReachedError):
            bound = _build(task, error).bound
            break
    else:
        raise NotReachedError
    least = max(error / STEP, bound.roundings)
    for _ in range(CLOSER):
        middle = float(round_up((least * error) ** 0.5))
        try:
            _build(task, middle)
            error = middle
        except NotReachedError:
            least = middle
    return round_up(error)


def round_up(number: float) -> str:
    """Write a bound with three digits, rounded up."""
    text = f"{number:.2e}"
    step = 10.0 ** (math.floor(math.log10(number)) - 2)
    return text if float(text) >= number else f"{number + step:.2e}"


def _build(task: Approximand, error: float) -> Built:
    low, high, reduction = _choose_range(task, error)
    rest = error - _lose_outside(task, low, high, reduction) - ROUNDED * task.size
    if rest <= 0:
        raise NotReachedError

    def attempt(plan: Plan) -> Built | None:
        with working(1):
            model = Model(task.request.variable, low, high, reduction, _fit(plan, task.exact))
        try:
            return Built(model, enclose(model, task.expand, task.repetition, error))
        except ExceededError:
            return None

    for plan in _list_plans(task.stretch, AIM * rest):
        if (built := attempt(plan)) is not None:
            return _lower(task.stretch, plan, built, attempt)
    raise NotReachedError


def _fit(plan: Plan, exact: Callable[[Ball], Ball]) -> Pieces:
    """Fit every piece of a plan."""
    with working(1, FIT_BITS):
        if plan.odd:
            end = plan.edges[-1]
            reaches = [plan.edges[1], end - plan.edges[1]][: plan.count]
            spans = [(c, arb(reach)) for c, reach in zip((0.0, end), reaches, strict=False)]
            powers = range(1, 2 * plan.terms, 2)
        else:
            pairs = pairwise(plan.edges)
            spans = [(low + (high - low) / 2, (arb(high) - low) / 2) for low, high in pairs]
            powers = range(plan.terms)
        pieces = [_fit_piece(exact, centre, reach, powers) for centre, reach in spans]
    return Pieces(plan.edges[1:-1], tuple(pieces), plan.odd, plan.mirrored)


def _fit_piece(exact: Callable[[Ball], Ball], centre: float, reach: Ball, powers: range) -> Piece:
    """Fit a polynomial about a centre."""
    found = interpolate(lambda x: exact(centre + x), arb(0), reach, powers)
    rounded = (0.0 if c.contains(0) else DOUBLE.round(take_middle(c)) for c in found)
    return Piece(centre, tuple(rounded))


def _lose_outside(
    task: Approximand, low: float, high: float, reduction: PeriodReduction | None
) -> float:
    """Bound the error of the reduction and the final sum, outside the polynomials."""
    if reduction is None or task.repetition is None:
        return 0.0
    return bound_outside(reduction, task.repetition, max(-low, high), task.slope)


def _list_plans(stretch: Stretch, tolerance: float) -> Iterator[Plan]:
    """Yield the cheapest plan, then the cheapest for ever lower tolerances."""
    for share in LOWER:
        plans = list_plans(stretch, share * tolerance)
        if not plans:
            return
        yield plans[0]


def _lower(
    stretch: Stretch, plan: Plan, built: Built, attempt: Callable[[Plan], Built | None]
) -> Built:
    """Return the model with as few terms as possible while the enclosed bound meets the error."""
    while plan.terms > 2:
        terms = plan.terms - 1
        fewer = (
            plan_odd(stretch, terms, plan.count)
            if plan.odd
            else plan_pieces(stretch, terms, plan.count, plan.error)
        )
        found = attempt(fewer) if fewer else None
        if fewer is None or found is None:
            break
        plan, built = fewer, found
    return built


def _choose_range(task: Approximand, error: float) -> tuple[float, float, PeriodReduction | None]:
    """Return the range and its reduction; a free range is as long as the error permits."""
    request, repetition = task.request, task.repetition
    if repetition is None:
        assert request.ends is not None
        return *request.ends, None
    period = float(repetition.period.mid())
    if request.ends is not None:
        low, high = request.ends
        if max(-low, high) > MOST_PERIODS * period:
            most = f"must lie within {MOST_PERIODS} periods, {MOST_PERIODS * period:.6g}"
            refuse(request.variable, request.ends, most)
        return low, high, _reduce(task, repetition, max(-low, high), error)
    farthest = 2.0 ** math.floor(math.log2(MOST_PERIODS * period))
    while True:
        reduction = _reduce(task, repetition, farthest, error)
        outside = bound_outside(reduction, repetition, farthest, task.slope)
        if outside <= OUTSIDE * error or farthest <= period:
            break
        farthest /= 2
    return -farthest, farthest, reduction


def _reduce(
    task: Approximand, repetition: Repetition, farthest: float, error: float
) -> PeriodReduction:
    """Return a reduction that subtracts whole periods, with one word of the period if enough."""
    rate = DOUBLE.round(take_middle(repetition.rate))
    period = take_middle(repetition.period)
    short = replace(DOUBLE, bits=BITS - 1 - math.ceil(farthest / float(period) + 1).bit_length())
    first = short.round(period)
    with mp.workprec(4 * BITS):
        words = first, DOUBLE.round(period - first)
        per_period = DOUBLE.round(1 / period)
    one = PeriodReduction((DOUBLE.round(period),), per_period, rate)
    two = PeriodReduction(words, per_period, rate)
    plain = replace(one, rate=0.0)
    still = replace(repetition, rate=arb(0))
    is_enough = bound_outside(plain, still, farthest, task.slope) <= ONE_WORD * error
    return one if is_enough else two
