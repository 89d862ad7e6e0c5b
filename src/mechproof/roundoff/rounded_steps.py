"""Rounded steps: what each step of a program is over boxes, and what its rounding adds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mechproof.arithmetic.intervals import EPS, Ends, Interval
from mechproof.roundoff.interval_monomials import IntervalMonomial
from mechproof.roundoff.rules import Slopes
from mechproof.roundoff.steps import Step


@dataclass
class RoundedStep:
    """The value of a step before its rounding, its slopes, and the size of its rounding."""

    step: Step
    exact: IntervalMonomial
    slopes: Slopes
    relative: Ends
    absolute: Ends | None
    # Of a number that is no double, what its rounding is, with its sign, as a share of itself.
    known: Interval | None = None

    def weigh(
        self, slopes: Sequence[IntervalMonomial], conditions: Sequence[Interval]
    ) -> list[Ends]:
        """Bound what it adds in eps of each of some scales.

        The slopes are those of an output over each scale, the conditions its condition numbers.
        """
        share, absolute = self.relative / EPS, None
        if self.absolute is not None:
            absolute = self.absolute / EPS
            least = self.exact.expanded().size().low
            share = np.fmin(share, absolute / np.where(least > 0, least, np.nan))
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
    """Return the lowest of bounds of one thing; those that are not finite say nothing."""
    least = np.float64(np.inf)
    for bound in bounds:
        least = np.fmin(least, bound)
    return least
