"""Points where sums of errors and poses are hard although no equation says so.

Sums: sizes far apart, zeros, correlations near one, squares beyond the doubles. Poses: points next
to the axis of the turn, where the displacement nearly vanishes.
"""

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from .._peers import Arguments, Array, Draw

Terms = Callable[[np.random.Generator, int], Arguments]

COUNT, POSES = 20, 150


def draw_usual(rng: np.random.Generator, count: int) -> Arguments:
    """Draw usual tolerances, sensitivities and scatters."""
    shape = (COUNT, count)
    return 10 ** rng.uniform(-6, 0, shape), rng.uniform(-2, 2, shape), rng.uniform(0.5, 2, shape)


def draw_apart(rng: np.random.Generator, count: int) -> Arguments:
    """Draw sizes up to a hundred decades apart, and zeros."""
    tolerance, influence, scatter = 10 ** rng.uniform(-50, 50, (3, COUNT, count))
    influence *= rng.choice([-1, 1], influence.shape)
    return tolerance * (rng.random(tolerance.shape) < 0.7), influence, scatter


def draw_beyond(rng: np.random.Generator, count: int) -> Arguments:
    """Draw tolerances whose squares overflow or underflow, some next to others that do not."""
    tolerance, influence, scatter = draw_usual(rng, count)
    size = 10 ** (rng.uniform(160, 290, (COUNT, 1)) * rng.choice([-1, 1], (COUNT, 1)))
    return tolerance * size, influence, scatter


def independent(terms: Terms, rng: np.random.Generator) -> Arguments:
    """Draw sums of nine errors."""
    return *terms(rng, 9), rng.uniform(1, 2, COUNT)


def correlated(terms: Terms, rng: np.random.Generator) -> Arguments:
    """Draw sums of five errors with correlation matrices, with unit diagonal and exact symmetry."""
    rows = rng.normal(size=(COUNT, 5, 15))
    return *terms(rng, 5), correlate(rows), rng.uniform(1, 2, COUNT)


def nearly_alike(terms: Terms, rng: np.random.Generator) -> Arguments:
    """Draw sums of five errors that are almost the same, with correlations above 1 - 1e-9."""
    common = rng.normal(size=(COUNT, 1, 15))
    own = rng.normal(size=(COUNT, 5, 15)) * 10 ** rng.uniform(-4.5, -1, (COUNT, 1, 1))
    return *terms(rng, 5), correlate(common + own), rng.uniform(1, 2, COUNT)


def correlate(rows: Array) -> Array:
    """Return the matrices of the cosines between rows."""
    unit = rows / np.linalg.norm(rows, axis=-1, keepdims=True)
    upper = np.triu(unit @ unit.swapaxes(-1, -2), 1)
    matrix: Array = np.clip(upper + upper.swapaxes(-1, -2), -1, 1) + np.eye(rows.shape[1])
    return matrix


def thermal(terms: Terms, rng: np.random.Generator) -> Arguments:
    """Draw sums with a temperature error from small to nearly the whole total."""
    share = (1 - 10 ** rng.uniform(-14, -1, COUNT)) / 1.7
    return *terms(rng, 6), np.full(COUNT, 1.2), share, np.full(COUNT, 1.2 * 1.7)


def near_the_axis(rng: np.random.Generator) -> Arguments:
    """Draw poses and points almost on the axis of each turn."""
    from scipy.spatial.transform import Rotation

    angles = rng.uniform(-np.pi, np.pi, (POSES, 3))
    axis = Rotation.from_euler("XYZ", angles).as_rotvec()
    along = axis / np.linalg.norm(axis, axis=1, keepdims=True)
    beside = rng.normal(size=angles.shape) * 10 ** rng.uniform(-15, -1, (POSES, 1))
    shift = rng.choice([0.0, 1.0], (POSES, 1)) * rng.uniform(-50, 50, angles.shape)
    return 50 * along + beside, angles, shift


def sum_nine(count: int) -> Arguments:
    """Return N sums of nine errors."""
    rng = np.random.default_rng(5)
    return rng.random((count, 9)), np.ones(9), np.ones(9), np.array(1.2)


def sum_correlated(count: int) -> Arguments:
    """Return N sums of five errors with one correlation matrix."""
    rng = np.random.default_rng(5)
    matrix = correlate(rng.normal(size=(1, 5, 15)))[0]
    return rng.random((count, 5)), np.ones(5), np.ones(5), matrix, np.array(1.2)


def sum_thermal(count: int) -> Arguments:
    """Return N sums of six errors with a temperature error of a third of the total."""
    rng = np.random.default_rng(5)
    terms = rng.random((count, 6)), np.ones(6), np.ones(6)
    return *terms, np.array(1.2), np.array(0.3), np.array(1.0)


def list_sums(draw: Callable[[Terms, np.random.Generator], Arguments]) -> Mapping[str, Draw]:
    """Return the point sets of a sum: usual terms, sizes far apart, squares beyond the doubles."""
    return {
        "usual": partial(draw, draw_usual),
        "sizes a hundred decades apart": partial(draw, draw_apart),
        "squares beyond the doubles": partial(draw, draw_beyond),
    }


POINTS: Mapping[str, Mapping[str, Draw]] = {
    "displacement": {"near the axis": near_the_axis},
    "error_sum": list_sums(independent),
    "error_sum_thermal": list_sums(thermal),
    "error_sum_correlated": {
        **list_sums(correlated),
        "correlations near one": partial(nearly_alike, draw_usual),
    },
}
WORKLOADS: Mapping[str, Mapping[str, Callable[[int], Arguments]]] = {
    "error_sum": {"N sums of nine": sum_nine},
    "error_sum_correlated": {"N sums of five": sum_correlated},
    "error_sum_thermal": {"N sums of six": sum_thermal},
}
