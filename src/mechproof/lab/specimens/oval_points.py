"""Where the oval pairs hurt: zero, quarter turns, meeting major axes, e near 1, large angles."""

from __future__ import annotations

import numpy as np

from mechproof.lab.points import draw_ladder, draw_within, join, pair_up, spread_ulps, step_ulps
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, Cells, Map, PointSet

# R4/R5 equal (no drift), at the dwell of e2 = 1/5 and inexact below it, and beyond it both ways.
RADII = np.array([[25.0, 25.0], [30.0, 20.0], [20.0, 30.0], [32.0, 18.0], [50.3, 0.7]])
ECCENTRICITIES = np.array([0.0, 1e-300, 0.28, 0.475, 0.9, 0.99, 0.999999, 1 - 1e-12])
MOUNTS = np.array([0.0, 1e-200, 1e-9, np.pi / 4, np.pi / 2, -1.2, 3.0])
QUARTER_TURNS = np.array([1, 2, 3, 4, 101, 100_000])
FARTHEST = 1e6
FARTHEST_X = 2.0**26
# Products with the eccentricity and the angle stay above the subnormals, with all their digits.
SMALLEST, SMALLEST_MOUNTED = 1e-290, 1e-250
WORKING = (0.2, 0.2, 0.4)
WORKING_RADII = (32.0, 18.0, 0.2)

CELLS = (
    Cells("phi1", (0.0, 10.0, 1e3, FARTHEST)),
    Cells("e2", (0.0, 0.28, 0.5, 0.9, 0.99, 0.999999, 1 - 1e-12)),
)


def draw_eccentricities(rng: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Draw both from the list, not both zero: the output would rest, and no digit be right."""
    e1, e2 = (rng.choice(ECCENTRICITIES, count) for _ in range(2))
    return e1, np.where(e1 + e2 == 0, 0.28, e2)


def with_ovals(rng: np.random.Generator, phi1: Array) -> Arguments:
    """Give each angle eccentricities and a mount of the lists; a third has equal ovals."""
    count = len(phi1)
    e1, e2 = draw_eccentricities(rng, count)
    alike = (rng.random(count) < 1 / 3) & (e1 > 0)
    mount = np.where(rng.random(count) < 0.7, rng.choice(MOUNTS, count), rng.uniform(-4, 4, count))
    return phi1, e1, np.where(alike, e1, e2), mount


def near_zero(rng: np.random.Generator) -> Arguments:
    """Climb the ladder of phi1 to both sides."""
    return with_ovals(rng, np.concatenate([draw_ladder(rng, 400), np.zeros(20)]))


def quarter_turns(rng: np.random.Generator) -> Arguments:
    """Surround the quarter turns: up to 1000 ulps, and ladders on both sides."""
    turns = QUARTER_TURNS * np.pi / 2
    beside = np.add.outer(turns[:4], draw_ladder(rng, 60, 1e-15)).ravel()
    return with_ovals(rng, np.concatenate([np.repeat(spread_ulps(turns, rng), 2), beside]))


def find_meeting(e1: Array, mount: Array) -> Array:
    """Return the carrier angle at which the major axis of the mounted wheel 6 passes phi6 = 0."""
    meeting: Array = np.arctan2(-(1 - e1) * np.sin(mount), (1 + e1) * np.cos(mount))
    return meeting


def steep(rng: np.random.Generator) -> Arguments:
    """Go over the peak of the ratio, (1 - e1)*(1 - e2) wide, and over the slope beside it."""
    e1, e2, mount = pair_up(ECCENTRICITIES[2:], ECCENTRICITIES[2:], MOUNTS)
    width = draw_ladder(rng, len(e1), 1e-4, 1e4) * (1 - e1) * (1 - e2)
    turns = rng.choice([0, 0, 1, -3], len(e1)) * np.pi
    return find_meeting(e1, mount) + width + turns, e1, e2, mount


def far(rng: np.random.Generator) -> Arguments:
    """Draw angles up to 1e6 rad."""
    return with_ovals(rng, rng.uniform(-FARTHEST, FARTHEST, 300))


def generic(rng: np.random.Generator) -> Arguments:
    """Draw a few turns, eccentricities up to 0.95, any mount."""
    e1, e2 = rng.uniform(0, 0.95, (2, 300))
    return rng.uniform(-30, 30, 300), e1, e2, rng.uniform(-np.pi, np.pi, 300)


def at_rest(rng: np.random.Generator) -> Arguments:
    """Mount equal ovals side by side, where the output rests, and nearly so."""
    count = 200
    e = rng.choice(ECCENTRICITIES[2:], count)
    mount = np.pi / 2 + draw_ladder(rng, count, 1e-16, 1e-3)
    return rng.uniform(-7, 7, count), e, e, mount


def one_sweep(end: float, count: int, sizes: tuple[float, ...]) -> PointSet:
    """Sample phi1 evenly from 0 on."""
    grid, shared = np.linspace(0, end, count), tuple(map(np.array, sizes))
    name = f"linspace(0, {end / np.pi:g} pi, {count}), {', '.join(f'{s:g}' for s in sizes)}"
    return PointSet(name, lambda rng: (grid, *shared), ordered=True)


SETS = (
    PointSet("generic", generic),
    PointSet("near zero", near_zero),
    PointSet("quarter turns", quarter_turns),
    PointSet("steep", steep),
    PointSet("far", far),
    PointSet("at rest", at_rest),
    one_sweep(8 * np.pi, 801, WORKING),
    one_sweep(2 * np.pi, 401, (0.9, 0.9, 0.0)),
)


def is_representable(phi1: Array, e: Array) -> Array:
    """Mark the points at which the product of an angle and an eccentricity does not underflow."""
    found: Array = (phi1 * e == 0) & ((phi1 == 0) | (e == 0)) | (np.abs(phi1) * e >= SMALLEST)
    return found


def both_representable(phi1: Array, e1: Array, e2: Array, mount: Array) -> Array:
    """Mark the points of the bars: the larger eccentricity decides, and e2 if there is a mount."""
    mounted = (mount == 0) | (e2 == 0) | (np.abs(mount) * e2 >= SMALLEST_MOUNTED)
    found: Array = is_representable(phi1, np.maximum(e1, e2)) & mounted
    return found


def ovals_in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw points of one box: even, by the logarithm, and around the meeting of the major axes."""
    count = 60
    (least, most), (low, high) = box["phi1"], box["e2"]
    e1, e2 = (draw_shortfalls(rng, 2 * count, *ends) for ends in ((0.0, high), (low, high)))
    mount = rng.permutation(np.resize(np.append(MOUNTS, rng.uniform(-3, 3, 5)), 2 * count))
    turns = np.round(rng.uniform(least, most, 2 * count) / np.pi) * np.pi
    width = draw_ladder(rng, 2 * count, 1e-6, 10.0) * (1 - e1) * (1 - e2)
    phi1 = np.clip(np.abs(find_meeting(e1, mount) + turns + width), least, most)
    phi1[:count] = draw_within(rng, count, least, most)
    return phi1, e1, e2, mount


def draw_shortfalls(rng: np.random.Generator, count: int, low: float, high: float) -> Array:
    """Draw eccentricities with 1 - e by the logarithm, both ends among them."""
    e = 1 - np.exp(rng.uniform(np.log1p(-high), np.log1p(-low), count))
    e[:2] = low, high
    return rng.permutation(np.clip(e, low, high))


def map_of_meeting(size: int) -> tuple[Arguments, Array, Array]:
    """Span the distance from where the major axes meet, and 1 - e2, both by the logarithm."""
    distance, shortfall = np.logspace(-12, np.log10(np.pi / 4), size), np.logspace(-12, 0, size)
    upward, across = pair_up(shortfall, distance)
    e1, mount = np.array(WORKING[0]), np.array(np.pi / 4)
    return (find_meeting(e1, mount) + across, e1, 1 - upward, mount), distance, shortfall


def meeting_map(*forms: str) -> Map:
    """Map these forms around the meeting of the major axes of the pair 6-3, mounted at 45 deg."""
    axes = "phi1 beyond the meeting", "1 - e2"
    return Map("mount = pi/4", map_of_meeting, *axes, forms)


def workload(count: int) -> Arguments:
    """Return N carrier angles over 16 turns, scalar sizes."""
    return np.linspace(0, 32 * np.pi, count), *map(np.array, WORKING)


# A cylindrical pair 4-5 ----------------------------------------------------------------------


def with_radii(phi1: Array, e2: Array, which: Array) -> Arguments:
    """Return the arguments for given rows of RADII; equal circles would rest, as above."""
    resting = (RADII[which, 0] == RADII[which, 1]) & (e2 == 0)
    return phi1, RADII[which, 0], RADII[which, 1], np.where(resting, 0.28, e2)


def _which(rng: np.random.Generator, count: int) -> Array:
    which: Array = rng.integers(0, len(RADII), count)
    return which


def generic_cylinders(rng: np.random.Generator) -> Arguments:
    """Draw a few turns, any e2 up to 0.95."""
    count = 300
    return with_radii(rng.uniform(-30, 30, count), rng.uniform(0, 0.95, count), _which(rng, count))


def cylinders_near_zero(rng: np.random.Generator) -> Arguments:
    """Climb the ladder of phi1 for every e2."""
    phi1, e2 = pair_up(np.concatenate([[0.0], draw_ladder(rng, 30)]), ECCENTRICITIES)
    return with_radii(phi1, e2, _which(rng, len(phi1)))


def singular_cylinders(rng: np.random.Generator) -> Arguments:
    """Surround whole and half turns of x: up to 1000 ulps, and ladders on both sides."""
    parts = []
    for row, (r4, r5) in enumerate(RADII):
        turns = QUARTER_TURNS * np.pi / 2 * r5 / r4
        close = spread_ulps(turns[turns <= FARTHEST], rng)
        beside = np.add.outer(turns[:4], draw_ladder(rng, 12, 1e-15)).ravel()
        phi1, e2 = pair_up(np.concatenate([close, beside]), rng.choice(ECCENTRICITIES, 2))
        parts.append(with_radii(phi1, e2, np.full(len(phi1), row)))
    return join(*parts)


def steep_cylinders(rng: np.random.Generator) -> Arguments:
    """Go over the peak of the ratio, 1 - e2 wide, for every e2 and after many turns."""
    turns = np.concatenate([np.arange(4), rng.integers(4, 10_000, 3)])
    turn, e2, width = pair_up(turns, ECCENTRICITIES, draw_ladder(rng, 9, 1e-3, 1e2))
    which = _which(rng, len(turn))
    r4, r5 = RADII[which].T
    return with_radii((turn * np.pi + width * (1 - e2)) * r5 / r4, e2, which)


def far_cylinders(rng: np.random.Generator) -> Arguments:
    """Draw angles up to 1e6 rad."""
    e2 = np.repeat(ECCENTRICITIES, 40)
    return with_radii(rng.uniform(-FARTHEST, FARTHEST, len(e2)), e2, _which(rng, len(e2)))


def dwell(rng: np.random.Generator) -> Arguments:
    """Surround the double zeros of the ratio of variant 3 and of its inverse, also far away."""
    turns = np.concatenate([np.arange(6), rng.integers(10, 10_000, 4)])
    turn, beside = pair_up(turns, np.append(draw_ladder(rng, 30, 1e-15), 0.0))
    against = np.concatenate([(2 * turn + 1) * np.pi / 3 + beside, turn * np.pi * 1.5 + beside])
    which = np.repeat([1, 2], len(turn))
    return with_radii(against, np.full(len(which), 0.2), which)


CYLINDER_SETS = (
    PointSet("generic", generic_cylinders),
    PointSet("near zero", cylinders_near_zero),
    PointSet("singular", singular_cylinders),
    PointSet("steep", steep_cylinders),
    PointSet("far", far_cylinders),
    PointSet("dwell", dwell),
    one_sweep(32 * np.pi, 3301, WORKING_RADII),
    one_sweep(32 * np.pi, 101, WORKING_RADII),
    one_sweep(2 * np.pi, 1001, (*WORKING_RADII[:2], 0.9)),
)


def within_low_word(phi1: Array, r4: Array, r5: Array, e2: Array) -> Array:
    """Mark the points of the bars: |x| <= 2**26, and the product with e2 does not underflow."""
    near: Array = 2 * np.abs(phi1 * r4 / r5) <= FARTHEST_X
    return near & is_representable(phi1, e2)


def cylinders_in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw points of one box: even, by the logarithm, on and around whole and half turns of x."""
    count = 60
    (least, most), (low, high) = box["phi1"], box["e2"]
    which = _which(rng, 2 * count)
    r4, r5 = RADII[which].T
    e2 = draw_shortfalls(rng, 2 * count, low, high)
    half = np.pi * r5 / r4 / 2
    beside = draw_ladder(rng, 2 * count, 1e-9, 10.0) * (1 - e2) / np.pi
    # Half of those beside a half turn are on it, as near as doubles come.
    beside[count:][::2] = 0
    turns = np.round(rng.uniform(least, most, 2 * count) / half)
    phi1 = np.clip((turns + beside) * half, least, most)
    phi1 = np.clip(step_ulps(phi1, rng.integers(-1, 2, 2 * count)), least, most)
    phi1[:count] = draw_within(rng, count, least, most)
    return phi1, r4, r5, e2


def map_of_peak(size: int) -> tuple[Arguments, Array, Array]:
    """Span the distance of x from a whole turn, and 1 - e2, both by the logarithm."""
    distance, shortfall = np.logspace(-12, np.log10(np.pi), size), np.logspace(-12, 0, size)
    upward, across = pair_up(shortfall, distance)
    r4, r5 = map(np.array, WORKING_RADII[:2])
    return ((2 * np.pi * 7 + across) * r5 / r4 / 2, r4, r5, 1 - upward), distance, shortfall


def peak_map(*forms: str) -> Map:
    """Map these forms around the seventh whole turn of x."""
    return Map("around x = 14 pi", map_of_peak, "x - 14 pi", "1 - e2", forms)


def workload_of_cylinders(count: int) -> Arguments:
    """Return N carrier angles over 16 turns, scalar sizes: variant 4."""
    return np.linspace(0, 32 * np.pi, count), *map(np.array, WORKING_RADII)
