"""Laws and windows on many scales, and the four shares as a list."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mechproof.conformity import Normal, Shares, shares

INF = np.inf
# For tests that need compiled shares: one worker compiles them once.
GROUP = "compiled shares"
BAR = 1e-12
Find = Callable[..., Shares]
NAMES = ("rightly_accepted", "wrongly_accepted", "rightly_rejected", "wrongly_rejected")


def four(result: Shares) -> list[Any]:
    return [getattr(result, name) for name in NAMES]


@dataclass(frozen=True)
class Case:
    """A normal part (mu, sigma), a normal error (bias, s) and both windows."""

    mu: float
    sigma: float
    bias: float
    s: float
    tolerance: tuple[float, float]
    acceptance: tuple[float, float]

    def shares(self, find: Find = shares) -> Shares:
        laws = Normal(self.mu, self.sigma), Normal(self.bias, self.s)
        return find(*laws, self.tolerance, self.acceptance)


HARD = {
    "plain": Case(0, 1, 0, 0.3, (-3, 3), (-3, 3)),
    "paper, 6 sigma": Case(-10.5, 7.5, 0.3, 1.7, (-33, 12), (-33, 12)),
    "error far below spread": Case(0, 1, 0, 1e-6, (-3, 3), (-3, 3)),
    "guard band of ten errors": Case(0, 1, 0, 1e-6, (-3, 3), (-2.99999, 2.99999)),
    "error far above spread": Case(0, 1, 0, 1e4, (-3, 3), (-3, 3)),
    "spread far below error": Case(0, 1e-3, 0, 1, (1e-2, 2e-2), (1, 2)),
    "limits 15 sigma away": Case(0, 1, 0, 0.1, (-15, 15), (-15, 15)),
    "both windows in the tail": Case(0, 1, 0, 1e-3, (18, 19), (18, 19)),
    "narrow tolerance in the tail": Case(0, 1, 0, 0.3, (20, 20.001), (19, 21)),
    "narrow acceptance": Case(0, 1, 0, 0.3, (-3, 3), (1, 1 + 1e-9)),
    "both windows narrow": Case(0, 1, 0, 0.3, (-1e-9, 1e-9), (-1e-9, 1e-9)),
    "narrow and disjoint": Case(0, 1, 0, 1e-3, (-0.5, 0.5), (0.51, 0.53)),
    "opposite tails": Case(0, 1, 0, 1, (5, 6), (-6, -5)),
    "bias outside": Case(0, 1, 5, 0.3, (-3, 3), (-3, 3)),
    "huge guard band": Case(0, 1, 0, 0.1, (-8, 8), (-6, 6)),
    "one-sided": Case(0, 1, 0, 0.1, (-INF, 3), (-INF, 2)),
    "opposite sides": Case(0, 1, 0.2, 0.5, (-INF, 3), (-2, INF)),
    "limit at the mean": Case(0, 1, 0, 0.5, (0, INF), (0, INF)),
    "limit almost at the mean": Case(0, 1, 1e-3, 1e-3, (1e-3, 2), (0, 2)),
}


def random_case(rng: np.random.Generator) -> Case:
    """Draw a case: scales over ten decades, windows related by guard bands or not at all."""
    s, width = 10 ** rng.uniform(-6, 4), 10 ** rng.uniform(-6, 1.2)
    middle = rng.choice([0, rng.normal(0, 3), rng.normal(0, 8)])
    bias = rng.choice([0, rng.normal(0, s), rng.normal(0, 5)])
    guard = rng.choice([0, width * rng.uniform(-0.4, 1), s * abs(rng.normal())])
    shift = rng.choice([0, rng.normal(0, width), rng.normal(0, s)])
    tolerance = middle - width / 2, middle + width / 2
    acceptance = tolerance[0] + shift - guard, tolerance[1] + shift + guard
    return Case(rng.normal(0, 0.5), 1, bias, s, tolerance, acceptance)


def random_sets(seed: int, count: int) -> tuple[Normal, Normal, Any, Any]:
    """Draw laws and windows with guard bands on many scales; limits below 8 sigma."""
    rng = np.random.default_rng(seed)
    true = Normal(rng.normal(0, 0.5, count), np.ones(count))
    s = 10 ** rng.uniform(-2, 1.5, count)
    error = Normal(s * rng.normal(0, 1, count), s)
    middle, half = rng.normal(0, 2, count), 10 ** rng.uniform(-2, 0.6, count)
    guard = np.where(rng.random(count) < 0.3, 0, half * rng.uniform(-0.9, 2, count))
    tolerance = middle - half, middle + half
    return true, error, tolerance, (middle - half - guard, middle + half + guard)
