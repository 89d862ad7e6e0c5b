"""Shares: what a rounding adds in shares of a scale, by condition numbers and term by term.

By what share of a scale an output moves with a step moved by a share is its condition number. Of
products and quotients they are 1 and -1, and a sum has each term once: carried from the output back
to a step (Bauer 1974), they lose nothing to how wide a box is where only these are passed. A slope,
a value and the inverse of a scale over a box do, each of which is known to a box apart.

Errors a1, a2, ... of which some are at most shares of one term of a sum and others of another add
up, over the sum, to the largest total that a term has, whatever the terms are beside each other. So
where terms vanish together, no quotient of theirs is needed. It is a backward error (Higham 2002,
chapter 1): every rounding is a change of one term.
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
# By the operand that is taken the condition number is 1, by the other 0; which one that is may not
# be known.
CHOICES = ("maximum", "minimum", CHOICE)


class CarriedConditions:
    """The condition numbers of an output by the steps that are still to be passed, scale by scale.

    `starts` are those by the output itself, one for each scale.
    """

    def __init__(self, output: Operand, starts: Sequence[Interval]) -> None:
        self._known: dict[Operand, list[Interval]] = {output: list(starts)}

    def take(self, result: Operand, others: Sequence[Interval]) -> list[Interval]:
        """Return the condition numbers by a step, narrowed by others that are known for it."""
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
        """Pass a step: what the output owes to it, it owes to the step's operands.

        `conditions` are the output's condition numbers by the step, `numbers` those of the step by
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
    """Return the condition numbers of a step by its operands; None for one that has no effect."""
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
    """Return the exponents of the operands if the result is a product of powers; else nothing."""
    letters = [sp.Dummy(positive=True) for _ in range(count)]
    meaning = SYMBOLIC[kind](*letters)
    if not isinstance(meaning, sp.Expr):
        return ()
    numbers = [sp.cancel(letter * meaning.diff(letter) / meaning) for letter in letters]
    is_power = all(n.is_Rational and sp.Rational(float(n)) == n for n in numbers)
    return tuple(map(float, numbers)) if is_power else ()


def _find_share(term: IntervalMonomial, other: IntervalMonomial) -> Interval:
    """Return a term's share of a sum."""
    # The first is finite where the term does not vanish, the second where the rest of the sum does
    # not.
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
        """Bound the rounding as a share of the value, in eps."""
        share = self.relative / EPS
        if self.absolute is not None:
            least = self.exact.expanded().size().low
            share = np.fmin(share, self.absolute / EPS / np.where(least > 0, least, np.nan))
        return share

    def move(self, condition: Interval) -> Interval:
        """Return how the largest rounding moves an output, in eps of a scale, with the sign."""
        if self.known is not None:
            return condition * self.known / exactly(EPS)
        share = self._share * (1 + 8 * EPS)
        # An exact operation moves nothing, even where its condition number is not known.
        return condition * Interval(share, share) if np.any(share) else exactly(0.0)

    def weigh(
        self, slopes: Sequence[IntervalMonomial], conditions: Sequence[Interval]
    ) -> list[Ends]:
        """Bound the error that the step adds, in eps of each of some scales.

        The slopes are those of an output over each scale, the conditions its condition numbers.
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
    """Return the lowest of several bounds of one quantity, leaving out NaN and infinity."""
    least = np.float64(np.inf)
    for bound in bounds:
        least = np.fmin(least, bound)
    return least


# Limits that are tried: an error is charged to a term only if its share of the term is at most so
# many times its share of the sum.
HARDLY_MORE = (1.25, 2.0, 4.0, np.inf)


def spread(errors: Sequence[Sequence[Ends]], terms: int) -> Ends:
    """Bound a sum of errors, each given as shares of what the sum is at least, its terms last."""
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
    """Charge each error to the terms that are charged least so far, levelling their totals."""
    loads = np.zeros_like(of_terms[0])
    rest: Ends = np.float64(0.0)
    for whole, shares in zip(of_sum, of_terms, strict=True):
        least = shares.min(axis=0)
        # An error without a finite share of any term stays with the whole sum, where it may be
        # infinite too.
        is_put = (whole > 0) & np.isfinite(least) & (least <= factor * whole)
        rest = rest + np.where(is_put, 0.0, whole)
        levels = np.where(np.isfinite(shares), _fill(loads, shares), 0.0)
        loads = np.where(is_put, np.maximum(loads, levels), loads)
    return rest + loads.max(axis=0)


def _fill(loads: Array, shares: Array) -> Array:
    """Return the level to which an error fills the lowest terms, by its share of each term."""
    order = np.argsort(loads, axis=0)
    with np.errstate(divide="ignore"):
        sizes = 1 / np.take_along_axis(shares, order, axis=0)
    # The lowest terms take all of the error; the right number of them is the one with the lowest
    # level.
    before = np.cumsum(np.take_along_axis(loads, order, axis=0) * sizes, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = (1 + before) / np.cumsum(sizes, axis=0) * (1 + 8 * EPS * len(loads))
    level: Array = np.fmin.reduce(found, axis=0)
    return level
