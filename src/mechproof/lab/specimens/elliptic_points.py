"""Where the elliptical pair hurts: zero, whole and half turns of x, e near 1, large angles."""

from __future__ import annotations

import numpy as np

from mechproof.lab.points import draw_ladder, draw_within, join, pair_up, spread_ulps, step_ulps
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, Cells, Map, PointSet

# R1/R2 exact (66/16), inexact (80/30), and close to 1.
RADII = np.array([[66.0, 16.0], [80.0, 30.0], [50.3, 50.2]])
ECCENTRICITIES = np.array([0.0, 1e-300, 1e-8, 0.28, 0.475, 0.9, 0.99, 0.999999, 1 - 1e-12])
HALF_TURNS = np.array([1, 2, 3, 4, 101, 100_000])
FARTHEST = 1e6
FARTHEST_X = 2.0**26
# The fourth power of a tangent, up to 1e64, divides e in the acceleration.
SMALLEST = 1e-200
WORKING = (66.0, 16.0, 0.475)

CELLS = (
    Cells("phi1", (0.0, 10.0, 1e3, FARTHEST)),
    Cells("e", (0.0, 0.28, 0.5, 0.9, 0.99, 0.999999, 1 - 1e-12)),
)


def with_radii(phi1: Array, e: Array, which: Array) -> Arguments:
    """Return the arguments for given rows of RADII."""
    return phi1, RADII[which, 0], RADII[which, 1], e


def generic(rng: np.random.Generator) -> Arguments:
    """Draw a few turns, any e up to 0.95."""
    count = 400
    return with_radii(rng.uniform(-30, 30, count), rng.uniform(0, 0.95, count), _which(rng, count))


def near_zero(rng: np.random.Generator) -> Arguments:
    """Climb the ladder of phi1 for every e."""
    ladder = np.concatenate([[0.0], draw_ladder(rng, 30)])
    phi1, e = pair_up(ladder, ECCENTRICITIES)
    return with_radii(phi1, e, _which(rng, len(phi1)))


def singular(rng: np.random.Generator) -> Arguments:
    """Surround whole and half turns of x: up to 1000 ulps, and ladders on both sides."""
    parts = []
    for row, (r1, r2) in enumerate(RADII):
        turns = HALF_TURNS * np.pi * r2 / r1
        close = spread_ulps(turns[turns <= FARTHEST], rng)
        beside = np.add.outer(turns[:4], draw_ladder(rng, 12, 1e-15)).ravel()
        phi1, e = pair_up(np.concatenate([close, beside]), rng.choice(ECCENTRICITIES, 2))
        parts.append(with_radii(phi1, e, np.full(len(phi1), row)))
    return join(*parts)


def steep(rng: np.random.Generator) -> Arguments:
    """Go over the peak of the ratio, 1 - e wide, for every e and after many turns."""
    turns = np.concatenate([np.arange(4), rng.integers(4, 10_000, 3)]) * 2
    turn, e, width = pair_up(turns, ECCENTRICITIES, draw_ladder(rng, 9, 1e-3, 1e2))
    which = _which(rng, len(turn))
    r1, r2 = RADII[which].T
    return with_radii((turn * np.pi + width * (1 - e)) * r2 / r1, e, which)


def far(rng: np.random.Generator) -> Arguments:
    """Draw angles up to 1e6 rad."""
    e = np.repeat(ECCENTRICITIES, 40)
    return with_radii(rng.uniform(-FARTHEST, FARTHEST, len(e)), e, _which(rng, len(e)))


def one_sweep(end: float, count: int, e: float) -> PointSet:
    """Sample phi1 evenly from 0 on, R1/R2 = 66/16."""
    grid = np.linspace(0, end, count)
    sizes = tuple(np.array(v) for v in (*WORKING[:2], e))
    name = f"linspace(0, {end / np.pi:g} pi, {count}), e = {e:g}"
    return PointSet(name, lambda rng: (grid, *sizes), ordered=True)


# Long enough for the polynomials of the kernels, in more than one block.
AS_TIMED = one_sweep(32 * np.pi, 16_384, WORKING[2])
SETS = (
    PointSet("generic", generic),
    PointSet("near zero", near_zero),
    PointSet("singular", singular),
    PointSet("steep", steep),
    PointSet("far", far),
    AS_TIMED,
    one_sweep(32 * np.pi, 3301, WORKING[2]),
    one_sweep(32 * np.pi, 161, WORKING[2]),
    one_sweep(2 * np.pi, 1001, 0.9),
)


def near_enough(phi1: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Mark the points of the bars: |x| <= 2**26."""
    return np.asarray(np.abs(phi1 * r1 / r2) <= FARTHEST_X)


def near_and_large_enough(phi1: Array, r1: Array, r2: Array, e: Array) -> Array:
    """Mark the points of the bar of the acceleration: no product with e underflows either."""
    representable: Array = (e == 0) | (e >= SMALLEST)
    return near_enough(phi1, r1, r2, e) & representable


def in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw points of one box: even, by the logarithm, on and around whole and half turns of x."""
    count = 60
    (least, most), (low, high) = box["phi1"], box["e"]
    which = _which(rng, 2 * count)
    r1, r2 = RADII[which].T
    e = 1 - np.exp(rng.uniform(np.log1p(-high), np.log1p(-low), 2 * count))
    e[:2] = low, high
    e = np.clip(rng.permutation(e), low, high)
    spread = draw_within(rng, count, least, most)
    half = np.pi * r2 / r1
    turns = np.round(rng.uniform(least, most, 2 * count) / half)
    beside = draw_ladder(rng, 2 * count, 1e-9, 10.0) * (1 - e) / np.pi
    # Half of those beside a half turn are on it, as near as doubles come.
    beside[count:][::2] = 0
    phi1 = np.clip((turns + beside) * half, least, most)
    phi1 = np.clip(step_ulps(phi1, rng.integers(-1, 2, 2 * count)), least, most)
    phi1[:count] = spread
    return phi1, r1, r2, e


def _which(rng: np.random.Generator, count: int) -> Array:
    which: Array = rng.integers(0, len(RADII), count)
    return which


def map_of_peak(size: int) -> tuple[Arguments, Array, Array]:
    """Span the distance of x from a whole turn, and 1 - e, both by the logarithm."""
    distance, shortfall = np.logspace(-12, np.log10(np.pi), size), np.logspace(-12, 0, size)
    upward, across = pair_up(shortfall, distance)
    phi1 = (2 * np.pi * 7 + across) * WORKING[1] / WORKING[0]
    sizes = tuple(np.array(v) for v in WORKING[:2])
    return (phi1, *sizes, 1 - upward), distance, shortfall


PEAK = "x - 14 pi", "1 - e"


def peak_map(*forms: str) -> Map:
    """Map these forms around the seventh whole turn of x."""
    return Map("around x = 14 pi", map_of_peak, *PEAK, forms)


def workload(count: int) -> Arguments:
    """Return N carrier angles over 16 turns, scalar sizes: variant 2 of Table 1."""
    return np.linspace(0, 32 * np.pi, count), *(np.array(v) for v in WORKING)
