"""What is timed and drawn of the linkage: many inputs, many linkages, all limit combinations."""

from __future__ import annotations

import numpy as np

from mechproof.lab.points import pair_up
from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.specimens.wedge_points import (
    ALPHA_KL,
    L_GH,
    LIMITS,
    NOMINAL,
    STROKE,
    run_of,
)
from mechproof.lab.subject import Map


def one_linkage(count: int) -> Arguments:
    """Return N displacements of the stroke, the nominal first set."""
    return np.linspace(-STROKE, 0, count), *map(np.array, NOMINAL[0])


def many_linkages(count: int) -> Arguments:
    """Return one displacement, N linkages within the limits of the first set."""
    low, high = LIMITS[0].T
    sizes = np.random.default_rng(6).uniform(low, np.nextafter(high, np.inf), (count, 10))
    return np.array(-30.0), *sizes.T.copy()


def combinations(count: int) -> Arguments:
    """Return all 256 limit combinations of the first set for each of N/256 displacements.

    N is rounded to whole displacements; below 256 it is one, and the first N combinations.
    """
    varying = np.flatnonzero(LIMITS[0, :, 0] < LIMITS[0, :, 1])
    chosen = np.zeros((10, min(count, 2 ** len(varying))), int)
    chosen[varying] = np.arange(chosen.shape[1]) >> np.arange(len(varying))[:, np.newaxis] & 1
    inputs = max(1, round(count / chosen.shape[1]))
    sizes = np.take_along_axis(LIMITS[0], chosen, axis=1)
    return np.linspace(-STROKE, 0, inputs)[:, np.newaxis], *sizes


LOADS = (("N inputs, one linkage", one_linkage), ("one input, N linkages", many_linkages))
POSITION_LOADS = (*LOADS, ("256 limit combinations, N/256 inputs", combinations))


def lever_load(count: int) -> Arguments:
    """Return N displacements, one lever."""
    return one_linkage(count)[:4]


def roller_load(count: int) -> Arguments:
    """Return N displacements, one roller lever."""
    return np.linspace(0, 60, count), np.array(60.0), np.array(NOMINAL[0, ALPHA_KL])


def map_of_contact(size: int) -> tuple[Arguments, Array, Array]:
    """Span |x1| and how much of the rod's run is left after the clearance, by the logarithm."""
    moved, left = np.logspace(-12, 1.5, size), np.logspace(-14, -0.01, size)
    upward, across = pair_up(left, moved)
    sizes = np.repeat(NOMINAL[:1].T, len(across), axis=1)
    sizes[L_GH] = run_of(-across, sizes) * (1 - upward)
    return (-across, *sizes), moved, left


def map_of_roller(size: int) -> tuple[Arguments, Array, Array]:
    """Span the displacement and R as parts of l_KL, by the logarithm."""
    moved, rest = np.logspace(-14, -0.4, size), np.logspace(-14, -0.4, size)
    upward, across = pair_up(rest, moved)
    return (60 * across, np.array(60.0), np.arccos(across + upward)), moved, rest


def contact_map(*forms: str) -> Map:
    """Map forms of the chain over the motion and the part of it behind the clearance."""
    names = "|x1|, mm", "1 - l_GH/x5"
    return Map("first set, l_GH below x5", map_of_contact, *names, forms, against="across")


def roller_map(*forms: str) -> Map:
    """Map forms of the roller lever."""
    return Map("l_KL = 60", map_of_roller, "x5/l_KL", "R/l_KL", forms, against="across")
