"""Where the tooth hurts: tiny tilts, many teeth, angles near both ends of their range."""

from __future__ import annotations

import numpy as np

from mechproof.kernels import tooth_thickness as kernels
from mechproof.lab.points import draw_ladder, draw_within, spread_ulps, step_ulps
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, Cells, PointSet

COUNT = 120
LARGEST_ANGLE = float(np.nextafter(np.pi / 4, 0))
CELLS = (
    Cells("tilt", (0.0, 1e-4, 1e-3, 1e-2, 1e-1, 0.5)),
    Cells("m", (0.0, 10.0)),
    Cells("z", (4.0, 100.0, 1000.0)),
    Cells("alpha", (0.0, 0.35, 0.7)),
)


def draw_angles(rng: np.random.Generator, count: int) -> Array:
    """Draw profile angles: the usual ones, and ladders down to 0 and up to pi/4."""
    low = np.abs(draw_ladder(rng, count, 1e-12, 1e-2))
    high = LARGEST_ANGLE - np.abs(draw_ladder(rng, count, 1e-15, 1e-2))
    usual = rng.choice([np.pi / 9, 0.25, 0.4, 0.61], count)
    return np.select([(kind := rng.integers(0, 4, count)) == 0, kind == 1], [low, high], usual)


def draw_teeth(rng: np.random.Generator, count: int) -> Array:
    """Draw numbers of teeth from 5 to 1e6."""
    return np.rint(10 ** rng.uniform(np.log10(5), 6, count))


def sizes(rng: np.random.Generator) -> Arguments:
    """Draw modules and profile angles."""
    return 10 ** rng.uniform(-3, 3, COUNT), draw_angles(rng, COUNT)


def at_the_ends(rng: np.random.Generator) -> Arguments:
    """Surround profile angles at both ends of their range by up to 1000 ulps, inside of it."""
    angles = spread_ulps(np.array([1e-300, 1e-8, np.pi / 9, LARGEST_ANGLE]), rng)
    angles = np.clip(angles, 1e-310, LARGEST_ANGLE)
    return 10 ** rng.uniform(-3, 3, len(angles)), angles


def flanks(rng: np.random.Generator) -> Arguments:
    """Draw any chord between the one parallel to the axis and the point of the tooth."""
    alpha = draw_angles(rng, COUNT)
    tilt = rng.uniform(-1, 1, COUNT)
    reach = np.where(tilt < 0, alpha, np.pi / 2 - alpha)
    return tilt * reach, 10 ** rng.uniform(-1, 2, COUNT), draw_teeth(rng, COUNT), alpha


def small_tilts(rng: np.random.Generator) -> Arguments:
    """Climb with the tilt from 1e-300, and take none."""
    tilt = np.concatenate([[0.0], draw_ladder(rng, COUNT - 1)])
    return tilt, np.full(COUNT, 3.0), draw_teeth(rng, COUNT), draw_angles(rng, COUNT)


def few_and_many_teeth(rng: np.random.Generator) -> Arguments:
    """Combine the fewest and the most teeth with small and large tilts."""
    z = rng.choice([4.0, 5.0, 17.0, 1e3, 1e6], COUNT)
    tilt = draw_ladder(rng, COUNT, 1e-17, 0.5)
    return tilt, np.ones(COUNT), z, draw_angles(rng, COUNT)


def heights(rng: np.random.Generator) -> Arguments:
    """Draw depths of chords, small ones and up to the base circle, where the bound blows up."""
    _, m, z, alpha = flanks(rng)
    deepest = np.asarray(kernels.height_change(-alpha, m, z, alpha))
    share = np.concatenate(
        [draw_ladder(rng, COUNT // 2, 1e-100, 1.0), rng.uniform(-1, 1, COUNT // 4)]
    )
    close = 1 - np.abs(draw_ladder(rng, COUNT - len(share), 1e-9, 1e-1))
    return np.concatenate([share, close]) * deepest, m, z, alpha


def depths(rng: np.random.Generator) -> Arguments:
    """Draw depths of any size for the linear model."""
    return draw_ladder(rng, COUNT, 1e-300, 10.0), draw_angles(rng, COUNT)


def errors(rng: np.random.Generator) -> Arguments:
    """Draw errors that add up, and errors that nearly cancel."""
    tip, free = (rng.normal(size=COUNT) * 10 ** rng.uniform(-6, 0, COUNT) for _ in range(2))
    cancelling = step_ulps(tip / 2, rng.integers(-1000, 1001, COUNT))
    return tip, np.where(rng.random(COUNT) < 0.5, free, cancelling), draw_angles(rng, COUNT)


SIZES = (PointSet("sizes", sizes), PointSet("angles at the ends of their range", at_the_ends))
FLANKS = (
    PointSet("generic", flanks),
    PointSet("tilts from 1e-300", small_tilts),
    PointSet("few and many teeth", few_and_many_teeth),
)
HEIGHTS = (PointSet("depths to the base circle", heights),)
DEPTHS = (PointSet("depths from 1e-300", depths),)
ERRORS = (PointSet("adding up and cancelling", errors),)


def in_cell(rng: np.random.Generator, box: Box) -> Arguments:
    """Draw flanks of one box of sizes; modules and angles are positive, teeth whole."""
    columns = {name: draw_within(rng, COUNT // 2, *ends) for name, ends in box.items()}
    z = np.clip(np.rint(np.abs(columns["z"])), *box["z"])
    m, alpha = (np.maximum(np.abs(columns[name]), 1e-12) for name in ("m", "alpha"))
    return columns["tilt"], m, z, alpha


def flank_load(count: int) -> Arguments:
    """Return N tilts, one wheel."""
    return np.linspace(-0.1, 0.1, count), *map(np.array, (3.0, 50.0, np.pi / 9))


def height_load(count: int) -> Arguments:
    """Return N depths, one wheel."""
    return np.linspace(-0.1, 0.1, count), *map(np.array, (3.0, 50.0, np.pi / 9))


def error_load(count: int) -> Arguments:
    """Return N pairs of errors, one wheel."""
    return *np.random.default_rng(8).normal(size=(2, count)), np.array(np.pi / 9)
