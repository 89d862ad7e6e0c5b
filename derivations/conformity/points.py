"""Points where shares are hard: far tails, tiny and huge errors, limits at a mean, odd windows.

Correlations of the true and the measured deviation run from 0 (huge errors) to 1 (tiny errors).
`POINTS` maps each quantity to its point sets by name, `IN_CELL` draws spreads between given edges,
`WORKLOADS` is what is timed for N sets of parameters.
"""

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from .._peers import Arguments, Array, Draw
from . import DEFINITIONS

Cell = Mapping[str, tuple[float, float]]

SETS = 80


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
    """Draw limits of `nearest` to `farthest` standard deviations, one up to twice as far."""
    error = 10 ** rng.uniform(-2, 0.5, count)
    mean, offset = rng.choice([0, 0.3], count), rng.choice([0, 0.1, -0.3], count) * error
    reach = rng.uniform(nearest, farthest, count) * np.hypot(1, error) * np.ones((2, 1))
    reach[rng.integers(0, 2, count), np.arange(count)] *= rng.uniform(1, 2, count)
    return mean, np.ones(count), offset, error, mean - reach[0], mean + reach[1]


def extreme_errors(rng: np.random.Generator, count: int) -> Arguments:
    """Draw errors from 1e-6 to 1e6 times the true spread."""
    std, error = np.ones(count), 10 ** rng.uniform(-6, 6, count)
    return windows(rng, count, std, error)


def biased(rng: np.random.Generator, count: int) -> Arguments:
    """Draw no bias, and a bias of up to 8 standard deviations, beyond the limits as well."""
    std, error = np.ones(count), 10 ** rng.uniform(-2, 1, count)
    mean, _, _, _, lower, upper = windows(rng, count, std, error)
    spread = np.hypot(std, error)
    offset = np.where(np.arange(count) % 4 == 0, 0, rng.uniform(-8, 8, count) * spread)
    return mean, std, offset, error, lower, upper


def limits_at_means(rng: np.random.Generator, count: int) -> Arguments:
    """Put a limit at the mean of the true or of the measured deviation, or next to it."""
    std, error = np.ones(count), 10 ** rng.uniform(-2, 1, count)
    mean, offset = rng.normal(size=count), rng.choice([0, 1], count) * error
    beside = rng.choice([-1, 1], count) * 10 ** rng.uniform(-300, -1, count)
    at = mean + rng.choice([0, 1], count) * offset + rng.choice([0, 1], count) * beside
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
    width = 10 ** rng.uniform(-12, 0, count) * spread
    return np.zeros(count), std, rng.choice([0, 0.5], count) * error, error, lower, lower + width


def in_cell(rng: np.random.Generator, cell: Cell) -> Arguments:
    """Draw the spreads of one cell."""
    logarithms = (np.log(cell[name]) for name in ("true_std", "error_std"))
    drawn = (np.exp(rng.uniform(low, high, SETS)) for low, high in logarithms)
    return windows(rng, SETS, *drawn)


def many_sets(count: int) -> Arguments:
    """Return N sets of parameters."""
    rng = np.random.default_rng(7)
    std = np.ones(count)
    return windows(rng, count, std, std * rng.uniform(0.1, 0.5, count))


SETS_OF_PARAMETERS: Mapping[str, Draw] = {
    "limits of 1 to 7 standard deviations": partial(usual, count=SETS),
    "tails to 1e-19": partial(reach_out, count=40, nearest=5, farthest=9),
    "tails to 1e-300": partial(reach_out, count=30, nearest=9, farthest=34),
    "errors of 1e-6 to 1e6 spreads": partial(extreme_errors, count=40),
    "bias up to 8 standard deviations": partial(biased, count=40),
    "limits at the means": partial(limits_at_means, count=30),
    "one-sided": partial(one_sided, count=30),
    "narrow": partial(narrow, count=30),
}
POINTS: Mapping[str, Mapping[str, Draw]] = dict.fromkeys(DEFINITIONS, SETS_OF_PARAMETERS)
IN_CELL: Mapping[str, Callable[[np.random.Generator, Cell], Arguments]] = dict.fromkeys(
    DEFINITIONS, in_cell
)
WORKLOADS: Mapping[str, Mapping[str, Callable[[int], Arguments]]] = {
    name: {"N sets": many_sets} for name in DEFINITIONS
}
