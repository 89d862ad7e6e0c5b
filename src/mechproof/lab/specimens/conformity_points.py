"""Where the shares hurt: tails, tiny and huge errors, large biases, limits at a mean, odd windows.

Correlations of the true and the measured deviation run from 0 (huge errors) to 1 (tiny errors).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from mechproof.lab.points import draw_ladder, draw_within
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, Cells, PointSet

SETS = 80
CELLS = (Cells("true_std", (0.01, 1.0)), Cells("error_std", (0.001, 0.1, 1.0)))
# Shares of the parts between the limits.
CONFORMING = ("rightly_accepted", "wrongly_rejected")
MOST_NATS = 460.0
Draw = Callable[[np.random.Generator, int], Arguments]


def windows(rng: np.random.Generator, count: int, std: Array, error: Array) -> Arguments:
    """Draw limits of 1 to 7 standard deviations, both laws shifted."""
    mean, offset = rng.uniform(-0.5, 0.5, count) * std, rng.uniform(-0.5, 0.5, count) * error
    reach = rng.uniform(1, 7, (2, count)) * np.hypot(std, error)
    return mean, std, offset, error, -reach[0], reach[1]


def usual(rng: np.random.Generator, count: int) -> Arguments:
    """Draw errors of 1 % to all of the true spread."""
    std = 10 ** rng.uniform(-2, 0, count)
    return windows(rng, count, std, std * 10 ** rng.uniform(-2, 0, count))


def reach_out(rng: np.random.Generator, count: int, nearest: float, farthest: float) -> Arguments:
    """Draw limits of so many standard deviations, one of them up to twice as far."""
    error = 10 ** rng.uniform(-2, 0.5, count)
    mean, offset = rng.choice([0, 0.3], count), rng.choice([0, 0.1, -0.3], count) * error
    reach = rng.uniform(nearest, farthest, count) * np.hypot(1, error) * np.ones((2, 1))
    reach[rng.integers(0, 2, count), np.arange(count)] *= rng.uniform(1, 2, count)
    return mean, np.ones(count), offset, error, mean - reach[0], mean + reach[1]


def tails(rng: np.random.Generator, count: int) -> Arguments:
    """Draw limits of 5 to 9 standard deviations: shares down to 1e-19."""
    return reach_out(rng, count, 5, 9)


def far_tails(rng: np.random.Generator, count: int) -> Arguments:
    """Draw limits of 9 to 34 standard deviations: shares down to 1e-300."""
    return reach_out(rng, count, 9, 34)


def extreme_errors(rng: np.random.Generator, count: int) -> Arguments:
    """Climb with the error from 1e-6 to 1e6 times the true spread."""
    std, error = np.ones(count), np.abs(draw_ladder(rng, count, 1e-6, 1e6))
    return windows(rng, count, std, error)


def biased(rng: np.random.Generator, count: int) -> Arguments:
    """Draw no bias, and a bias of up to 8 standard deviations, beyond the limits as well."""
    std, error = np.ones(count), 10 ** rng.uniform(-2, 1, count)
    mean, _, _, _, lower, upper = windows(rng, count, std, error)
    spread = np.hypot(std, error)
    offset = np.where(np.arange(count) % 4 == 0, 0, rng.uniform(-8, 8, count) * spread)
    return mean, std, offset, error, lower, upper


def limits_at_means(rng: np.random.Generator, count: int) -> Arguments:
    """Put a limit on the mean of the true or of the measured deviation, or beside it."""
    std, error = np.ones(count), 10 ** rng.uniform(-2, 1, count)
    mean, offset = rng.normal(size=count), rng.choice([0, 1], count) * error
    at = (
        mean
        + rng.choice([0, 1], count) * offset
        + rng.choice([0, 1], count) * draw_ladder(rng, count)
    )
    width = rng.uniform(1, 6, count) * np.hypot(std, error)
    lower = rng.choice([True, False], count)
    return (
        mean,
        std,
        offset,
        error,
        np.where(lower, at, at - width),
        np.where(lower, at + width, at),
    )


def one_sided(rng: np.random.Generator, count: int) -> Arguments:
    """Put one limit where no part ever comes: a one-sided tolerance."""
    std, error = np.ones(count), 10 ** rng.uniform(-2, 1, count)
    spread = np.hypot(std, error)
    near, far = rng.uniform(-6, 6, count) * spread, 40 * spread
    lower = rng.choice([True, False], count)
    bias = rng.choice([0, 0.5], count) * error
    return (
        np.zeros(count),
        std,
        bias,
        error,
        np.where(lower, near, -far),
        np.where(lower, far, near),
    )


def narrow(rng: np.random.Generator, count: int) -> Arguments:
    """Draw tolerances from 1e-12 to one spread wide, up to 6 spreads from the mean."""
    std, error = np.ones(count), 10 ** rng.uniform(-2, 1, count)
    spread = np.hypot(std, error)
    lower = rng.uniform(-6, 6, count) * spread
    width = np.abs(draw_ladder(rng, count, 1e-12, 1)) * spread
    return np.zeros(count), std, rng.choice([0, 0.5], count) * error, error, lower, lower + width


def point_set(name: str, draw: Draw, count: int) -> PointSet:
    """Name a set of so many parameters."""
    return PointSet(name, lambda rng: draw(rng, count))


SETS_OF_PARAMETERS = (
    point_set("limits of 1 to 7 standard deviations", usual, SETS),
    point_set("tails to 1e-19", tails, 40),
    point_set("tails to 1e-300", far_tails, 30),
    point_set("errors of 1e-6 to 1e6 spreads", extreme_errors, 40),
    point_set("bias up to 8 standard deviations", biased, 40),
    point_set("limits at the means", limits_at_means, 30),
    point_set("one-sided", one_sided, 30),
    point_set("narrow", narrow, 30),
)


def is_far_from_underflow(
    name: str, mean: Array, std: Array, offset: Array, error: Array, low: Array, high: Array
) -> Array:
    """Mark the sets whose likeliest part of a share is not beyond 460 nats (1e-200)."""
    conforming = [low, high, np.clip(mean, low, high)]
    others = [np.minimum(mean, low), np.maximum(mean, high)]
    nats = []
    for y in conforming if name in CONFORMING else others:
        near = y + offset
        inner, outer = (np.clip(near, low, high),), (np.minimum(near, low), np.maximum(near, high))
        for m in inner if name.endswith("accepted") else outer:
            nats.append((((y - mean) / std) ** 2 + ((m - near) / error) ** 2) / 2)
    far: Array = np.min(nats, axis=0) <= MOST_NATS
    return far


def in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw spreads of one box."""
    columns = (np.abs(draw_within(rng, SETS, *box[n])) for n in ("true_std", "error_std"))
    return windows(rng, SETS, *columns)


def workload(count: int) -> Arguments:
    """Return N sets of parameters."""
    rng = np.random.default_rng(7)
    std = np.ones(count)
    return windows(rng, count, std, std * rng.uniform(0.1, 0.5, count))
