"""Shares: what a rounding adds in shares of a scale, by condition numbers and term by term.

The condition number of an output with respect to a step is the share of the scale by which the
output moves per share by which the step moves. Products and quotients have 1 and -1, and a sum has
each term once: carried back from the output to a step (Bauer 1974) through such operations only,
condition numbers lose nothing to the width of a box. The product of a slope, a value and the
inverse of a scale does, as each factor is enclosed separately.

Let some errors be shares of one term of a sum and others of another. Over the sum, they add up to
at most the largest total that a single term has, whatever the ratios of the terms. So where terms
vanish together, no quotient of theirs is needed. This is a backward error (Higham 2002, chapter 1):
every rounding is a change of one term.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import sympy as sp

from mechproof.arithmetic.intervals import EPS, ONE, Array, Ends, Interval, around, exactly
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import Operand
from mechproof.roundoff.interval_monomials import IntervalMonomial
from mechproof.roundoff.rules import SOME, Slopes
from mechproof.roundoff.steps import CHOICE, Step

SUMS = ("add", "subtract", "fma")
# The condition number is 1 for the operand that is taken and 0 for the other; which one is taken
# may be unknown.
CHOICES = ("maximum", "minimum", CHOICE)


class CarriedConditions:
    """The condition numbers of an output for the steps yet to be passed, scale by scale.

    `starts` are those for the output itself, one for each scale.
    """

    def __init__(self, output: Operand, starts: Sequence[Interval]) -> None:
        self._known: dict[Operand, list[Interval]] = {output: list(starts)}

    def take(self, result: Operand, others: Sequence[Interval]) -> list[Interval]:
        """Return, and forget, the condition numbers for a step, intersected with `others`."""
        known = self._known.pop(result, None)
        if known is None:
            return list(others)
        return [one.intersection(other) for one, other in zip(known, others, strict=True)]

    def carry(
        self,
        conditions: Sequence[Interval],
        moved: Ends,
        operands: Sequence[Operand],
        numbers: Sequence[Interval | None],
    ) -> None:
        """Pass a step: add its condition numbers to those for its operands, by the chain rule.

        `conditions` are the output's condition numbers for the step, `numbers` the step's own for
        its operands, `moved` the largest share by which its rounding moves it.
        """
        own = around(1.0, moved * (1 + 4 * EPS))
        for operand, number in zip(operands, numbers, strict=True):
            if number is None or not isinstance(operand, str):
                continue
            parts = [condition * number * own for condition in conditions]
            known = self._known.get(operand)
            self._known[operand] = (
                [a + b for a, b in zip(known, parts, strict=True)] if known else parts
            )


def find_condition_numbers(
    kind: str,
    given: Sequence[IntervalMonomial],
    exact: IntervalMonomial,
    slopes: Sequence[IntervalMonomial | None],
) -> list[Interval | None]:
    """Return a step's condition numbers for its operands; None for operands without effect."""
    if kind in CHOICES:
        return [None if slope is None else SOME for slope in slopes]
    if powers := _find_powers(kind, len(given)):
        return [exactly(power) for power in powers]
    found = [
        None if slope is None else (slope * operand / exact).expanded()
        for slope, operand in zip(slopes, given, strict=True)
    ]
    if kind not in SUMS:
        return found
    *factors, last = given
    first = factors[0] * factors[1] if kind == "fma" else factors[0]
    last = -last if kind == "subtract" else last
    shares = [*[_find_share(first, last)] * len(factors), _find_share(last, first)]
    return [
        None if one is None else one.intersection(share)
        for one, share in zip(found, shares, strict=True)
    ]


@cache
def _find_powers(kind: str, count: int) -> tuple[float, ...]:
    """Return the operands' exponents if the result is a product of powers; empty otherwise."""
    letters = [sp.Dummy(positive=True) for _ in range(count)]
    meaning = SYMBOLIC[kind](*letters)
    if not isinstance(meaning, sp.Expr):
        return ()
    numbers = [sp.cancel(letter * meaning.diff(letter) / meaning) for letter in letters]
    is_power = all(n.is_Rational and sp.Rational(float(n)) == n for n in numbers)
    return tuple(map(float, numbers)) if is_power else ()


def _find_share(term: IntervalMonomial, other: IntervalMonomial) -> Interval:
    """Return a term's share of its sum with another."""
    # The first is finite where the term does not vanish, the second where the other does not.
    of_rest = (ONE + (other / term).expanded()).inverted()
    return of_rest.intersection(ONE - (ONE + (term / other).expanded()).inverted())


@dataclass
class RoundedStep:
    """The value of a step before its rounding, its slopes, and the size of its rounding."""

    step: Step
    exact: IntervalMonomial
    slopes: Slopes
    relative: Ends
    absolute: Ends | None
    # For a number that is no double: its rounding error with its sign, as a share of itself.
    known: Interval | None = None

    @property
    def _share(self) -> Ends:
        """Bound the rounding error as a share of the value, in eps."""
        share = self.relative / EPS
        if self.absolute is not None:
            least = self.exact.expanded().size().low
            share = np.fmin(share, self.absolute / EPS / np.where(least > 0, least, np.nan))
        return share

    def move(self, condition: Interval) -> Interval:
        """Return how far the largest rounding moves an output, with its sign, in eps of a scale."""
        if self.known is not None:
            return condition * self.known / exactly(EPS)
        share = self._share * (1 + 8 * EPS)
        # An exact operation moves nothing, even where its condition number is not known.
        return condition * Interval(share, share) if np.any(share) else exactly(0.0)

    def weigh(
        self, slopes: Sequence[IntervalMonomial], conditions: Sequence[Interval]
    ) -> list[Ends]:
        """Bound the error that the step adds to an output, in eps of each of several scales.

        `slopes` are the output's derivatives over each scale, `conditions` its condition numbers.
        """
        share, absolute = self._share, None
        if self.absolute is not None:
            absolute = self.absolute / EPS
        # An exact operation adds nothing, even where its slope is not known.
        is_exact = np.maximum(share, 0.0 if absolute is None else absolute) == 0
        bounds = []
        for slope, condition in zip(slopes, conditions, strict=True):
            found = [condition.largest() * share] if np.any(self.relative) else []
            if absolute is not None:
                found.append(slope.expanded().largest() * absolute)
            bounds.append(np.where(is_exact, 0.0, take_least(*found) * (1 + 8 * EPS)))
        return bounds


def take_least(*bounds: Ends) -> Ends:
    """Return the lowest of several bounds on one quantity; NaN and infinity bound nothing."""
    least = np.float64(np.inf)
    for bound in bounds:
        least = np.fmin(least, bound)
    return least


# Limits to try: an error is charged to a term only if its share of the term is at most this many
# times its share of the sum.
HARDLY_MORE = (1.25, 2.0, 4.0, np.inf)


def spread(errors: Sequence[Sequence[Ends]], terms: int) -> Ends:
    """Bound a sum of errors, each given as shares of lower bounds of the scale, its terms last."""
    of_sum = [take_least(*shares) for shares in errors]
    totals = [sum(of_sum, np.float64(0.0))]
    if terms > 1:
        # Some shares are one number for all boxes.
        shape = np.broadcast_shapes(*(np.shape(s) for shares in errors for s in shares[-terms:]))
        of_terms = [
            np.array([np.broadcast_to(share, shape) for share in shares[-terms:]])
            for shares in errors
        ]
        totals += [_share_out(of_sum, of_terms, factor) for factor in HARDLY_MORE]
    return take_least(*totals)


def _share_out(of_sum: Sequence[Ends], of_terms: Sequence[Array], factor: float) -> Ends:
    """Charge each error to the terms charged least so far; return rest plus largest total."""
    loads = np.zeros_like(of_terms[0])
    rest: Ends = np.float64(0.0)
    for whole, shares in zip(of_sum, of_terms, strict=True):
        least = shares.min(axis=0)
        # An error without a finite share of any term is charged to the whole sum, where it may be
        # infinite too.
        is_put = (whole > 0) & np.isfinite(least) & (least <= factor * whole)
        rest = rest + np.where(is_put, 0.0, whole)
        levels = np.where(np.isfinite(shares), _fill(loads, shares), 0.0)
        loads = np.where(is_put, np.maximum(loads, levels), loads)
    return rest + loads.max(axis=0)


def _fill(loads: Array, shares: Array) -> Array:
    """Return the level to which an error raises the lowest loads, given its share of each term."""
    order = np.argsort(loads, axis=0)
    with np.errstate(divide="ignore"):
        sizes = 1 / np.take_along_axis(shares, order, axis=0)
    # The lowest terms take the whole error; the right number of them is the one that gives the
    # lowest level.
    before = np.cumsum(np.take_along_axis(loads, order, axis=0) * sizes, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = (1 + before) / np.cumsum(sizes, axis=0) * (1 + 8 * EPS * len(loads))
    level: Array = np.fmin.reduce(found, axis=0)
    return level
