"""Design: in, a function on an interval; out, pieces and degrees of polynomials that may suffice.

Everything here is an estimate in doubles from Chebyshev coefficients at some points, whose decay
shows the error at each degree (Trefethen 2013). Designs are fitted and enclosed afterwards.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Function = Callable[[Array], Array]
# Nodes for odd polynomials on half a period, and inner edges tried there.
NODES, EDGES = 256, 96
# Number of coefficients beyond the last one of a polynomial from which its error is estimated.
AHEAD = 8
UNIT, GROWTH = 2.0**-53, 1 + 2**0.5
MOST_PIECES, MOST_TERMS = 16, 26
# How often a tolerance is raised by half until the pieces suffice.
LOOSENED = 12
# A piece that passes an edge by less than this share of itself ends there.
PASSED = 0.1


@dataclass(frozen=True)
class Plan:
    """Pieces between `edges`, each with the stated number of coefficients.

    `odd`: polynomials in odd powers, about 0 and about the end, half a period away. `mirrored`: the
    pieces of an odd function, right of 0. `error` is an estimate.
    """

    edges: tuple[float, ...]
    terms: int
    odd: bool
    mirrored: bool
    error: float

    @property
    def count(self) -> int:
        """Return the number of pieces."""
        return len(self.edges) - 1

    @property
    def cost(self) -> int:
        """Estimate the operations: each coefficient is multiplied in, and selected by piece."""
        overhead = 4 if self.odd and self.count > 1 else 0
        return self.terms * self.count + self.count - 1 + overhead + 3 * self.mirrored


@dataclass(frozen=True)
class Stretch:
    """A function on an interval; it need not be smooth at `corners`.

    `odd`: the function is odd, and the interval right of 0. `periodic`: the interval is a period,
    or half of one.
    """

    function: Function
    low: float
    high: float
    odd: bool
    periodic: bool
    corners: tuple[float, ...] = ()


@cache
def _transform(count: int) -> tuple[Array, Array]:
    """Return the Chebyshev nodes and the matrix from values there to coefficients."""
    angles = (2 * np.arange(count) + 1) * np.pi / (2 * count)
    matrix = 2 / count * np.cos(np.outer(np.arange(count), angles))
    matrix[0] /= 2
    return np.cos(angles), matrix


def _expand(function: Function, low: Array, high: Array, count: int) -> Array:
    """Return absolute Chebyshev coefficients, one interval per row; NaN counts as infinite."""
    nodes, matrix = _transform(count)
    middle, half = (low + high) / 2, (high - low) / 2
    values = function(middle[:, None] + half[:, None] * nodes)
    found: Array = np.abs(values @ matrix.T)
    return np.where(np.isnan(found), np.inf, found)


def _estimate(sizes: Array) -> Array:
    """Estimate the error of keeping the coefficients before each: truncation and rounding.

    The terms of T_k in powers add up to (1 + sqrt(2))**k in size where its value is 1, so that much
    cancels.
    """
    padded = np.pad(sizes, [(0, 0), (0, AHEAD)])
    windows = np.lib.stride_tricks.sliding_window_view(padded, AHEAD, axis=1)
    left_out = np.asarray(windows.sum(axis=2)[:, : sizes.shape[1]])
    summed = np.cumsum(sizes * GROWTH ** np.arange(sizes.shape[1]), axis=1)
    return np.asarray(left_out + UNIT * np.pad(summed, [(0, 0), (1, 0)])[:, :-1])


def list_plans(stretch: Stretch, tolerance: float) -> list[Plan]:
    """List plans that may meet a tolerance, the cheapest first."""
    plans: list[Plan] = []
    if stretch.odd and stretch.periodic:
        plans += (
            plan
            for count in (1, 2)
            for terms in range(1, NODES // 4)
            if (plan := plan_odd(stretch, terms, count)).error <= tolerance
        )
    for terms in range(2, MOST_TERMS):
        edges = _cut(stretch, terms, tolerance)
        if edges is not None:
            plans.append(Plan(tuple(edges), terms, False, stretch.odd, tolerance))
            if len(edges) == 2:
                break
    return sorted(plans, key=lambda plan: (plan.cost, plan.error))


def plan_odd(stretch: Stretch, terms: int, count: int) -> Plan:
    """Plan polynomials with `terms` odd powers: one about 0 and, if count is 2, one at the end."""
    end = stretch.high
    inner, near, far = _expand_odd(stretch)
    worst = near if count == 1 else np.maximum(near, far)
    best = len(inner) - 1 if count == 1 else int(np.argmin(worst[:-1, terms]))
    edges = (0.0, end) if count == 1 else (0.0, float(inner[best]), end)
    return Plan(edges, terms, True, False, float(worst[best, terms]))


@lru_cache(maxsize=4)
def _expand_odd(stretch: Stretch) -> tuple[Array, Array, Array]:
    """Return inner edges and the errors, by number of terms, of polynomials on either side."""
    end = stretch.high
    inner = end * np.linspace(0, 1, EDGES + 1)[1:] ** 2
    near = _estimate(_expand(stretch.function, -inner, inner, NODES))[:, ::2]
    far = _estimate(_expand(stretch.function, inner, 2 * end - inner, NODES))[:, ::2]
    return inner, near, far


def plan_pieces(stretch: Stretch, terms: int, count: int, tolerance: float) -> Plan | None:
    """Plan at most `count` pieces of equal error, at the first tolerance that permits them."""
    plan = None
    for _ in range(LOOSENED):
        edges = _cut(stretch, terms, tolerance)
        if edges is not None and len(edges) - 1 <= count:
            plan = Plan(tuple(edges), terms, False, stretch.odd, tolerance)
            break
        tolerance *= 1.5
    return plan


def _cut(stretch: Stretch, terms: int, tolerance: float) -> list[float] | None:
    """Cut the interval into the longest possible pieces; None if there are too many."""
    edges = [stretch.low]
    while edges[-1] < stretch.high:
        if len(edges) > MOST_PIECES:
            return None
        edges.append(_reach(stretch, edges[-1], terms, tolerance))
        if edges[-1] <= edges[-2]:
            return None
    return edges


def _reach(stretch: Stretch, start: float, terms: int, tolerance: float) -> float:
    """Return the end of the longest piece from `start` that meets the tolerance."""
    nodes = terms + AHEAD
    shares = np.linspace(1, 0, 9)[:-1]
    low, span = 0.0, stretch.high - start
    for _ in range(4):
        # Eight ends are tried at once, as a call costs more than its points.
        tried = low + shares * (span - low)
        first = np.full(tried.shape, start)
        errors = _estimate(_expand(stretch.function, first, start + tried, nodes))[:, terms]
        good = np.flatnonzero(errors <= tolerance)
        best = int(good[0]) if good.size else len(tried)
        if best == 0:
            low = span
            break
        span = float(tried[best - 1])
        low = float(tried[best]) if good.size else low
    end = stretch.high if start + low >= stretch.high else start + low
    passed = [c for c in stretch.corners if start < c < end and end - c <= PASSED * (end - start)]
    return max(passed, default=end)
