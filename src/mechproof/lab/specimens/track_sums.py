"""Where sums of errors hurt: sizes far apart, zeros, correlations near one, squares too large."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import PointSet

COUNT = 20
# The squares of such factors, and products of three, are doubles.
SMALLEST, LARGEST = 1e-50, 1e50
Terms = Callable[[np.random.Generator, int], Arguments]


def draw_usual(rng: np.random.Generator, count: int) -> Arguments:
    """Draw tolerances, sensitivities and scatters as they are."""
    shape = (COUNT, count)
    return 10 ** rng.uniform(-6, 0, shape), rng.uniform(-2, 2, shape), rng.uniform(0.5, 2, shape)


def draw_apart(rng: np.random.Generator, count: int) -> Arguments:
    """Draw sizes of up to a hundred decades apart, and none."""
    tolerance, influence, scatter = 10 ** rng.uniform(-50, 50, (3, COUNT, count))
    influence *= rng.choice([-1, 1], influence.shape)
    return tolerance * (rng.random(tolerance.shape) < 0.7), influence, scatter


def draw_beyond(rng: np.random.Generator, count: int) -> Arguments:
    """Draw tolerances whose squares overflow or underflow, some beside others that stay."""
    tolerance, influence, scatter = draw_usual(rng, count)
    size = 10 ** (rng.uniform(160, 290, (COUNT, 1)) * rng.choice([-1, 1], (COUNT, 1)))
    return tolerance * size, influence, scatter


def keep_squares(*arguments: Array) -> Array:
    """Mark the sums whose factors lie in the range of the bar."""
    sizes = [np.abs(a) for a in arguments[:3]]
    kept = [(s == 0) | ((s >= SMALLEST) & (s <= LARGEST)) for s in sizes]
    inside: Array = np.all(kept[0] & kept[1] & kept[2], axis=-1)
    return inside


def independent(rng: np.random.Generator, terms: Terms) -> Arguments:
    """Draw sums of nine errors."""
    return *terms(rng, 9), rng.uniform(1, 2, COUNT)


def correlated(rng: np.random.Generator, terms: Terms) -> Arguments:
    """Draw sums of five errors with correlation matrices, ones and symmetry to the last bit."""
    rows = rng.normal(size=(COUNT, 5, 15))
    return *terms(rng, 5), correlate(rows), rng.uniform(1, 2, COUNT)


def nearly_alike(rng: np.random.Generator, terms: Terms) -> Arguments:
    """Draw sums of five errors that are almost the same, correlations from 1 - 1e-9 on."""
    common = rng.normal(size=(COUNT, 1, 15))
    own = rng.normal(size=(COUNT, 5, 15)) * 10 ** rng.uniform(-4.5, -1, (COUNT, 1, 1))
    return *terms(rng, 5), correlate(common + own), rng.uniform(1, 2, COUNT)


def correlate(rows: Array) -> Array:
    """Return the matrices of the cosines between rows."""
    unit = rows / np.linalg.norm(rows, axis=-1, keepdims=True)
    upper = np.triu(unit @ unit.swapaxes(-1, -2), 1)
    matrix: Array = np.clip(upper + upper.swapaxes(-1, -2), -1, 1) + np.eye(rows.shape[1])
    return matrix


def thermal(rng: np.random.Generator, terms: Terms) -> Arguments:
    """Draw sums with a temperature error from small to nearly the whole total."""
    share = (1 - 10 ** rng.uniform(-14, -1, COUNT)) / 1.7
    return *terms(rng, 6), np.full(COUNT, 1.2), share, np.full(COUNT, 1.2 * 1.7)


def sums(
    draw: Callable[[np.random.Generator, Terms], Arguments], terms: Terms
) -> Callable[[np.random.Generator], Arguments]:
    """Bind the terms of a sum."""
    return lambda rng: draw(rng, terms)


def list_sums(draw: Callable[[np.random.Generator, Terms], Arguments]) -> tuple[PointSet, ...]:
    """List the sets of a sum: usual terms, sizes apart, squares beyond the doubles."""
    return (
        PointSet("usual", sums(draw, draw_usual)),
        PointSet("sizes a hundred decades apart", sums(draw, draw_apart)),
        PointSet("squares beyond the doubles", sums(draw, draw_beyond)),
    )


INDEPENDENT, THERMAL = list_sums(independent), list_sums(thermal)
CORRELATED = (
    *list_sums(correlated),
    PointSet("correlations near one", sums(nearly_alike, draw_usual)),
)


def independent_load(count: int) -> Arguments:
    """Return N sums of nine errors."""
    rng = np.random.default_rng(5)
    return rng.random((count, 9)), np.ones(9), np.ones(9), np.array(1.2)
