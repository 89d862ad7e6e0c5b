"""Points chosen to hurt: named sets of them.

Every set is drawn anew from a seed: searches start from the sets of the seed TUNE, tables report
those of the seed REPORT, so nothing is reported on the points it was found on. The exact singular
points belong to both.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mechproof.lab.ways import Arguments, Array

TUNE, REPORT = 20240826, 20261231


@dataclass(frozen=True)
class PointSet:
    """Named points: `make` draws the arguments, in the order of the quantity's arguments.

    The leading axis runs over the points; an argument with fewer axes is shared by all of them.
    If `ordered`, the first argument rises from 0 in even steps and all others are shared.
    """

    name: str
    make: Callable[[np.random.Generator], Arguments]
    ordered: bool = False


def draw_points(point_set: PointSet, seed: int) -> Arguments:
    """Draw a point set; sets with other names get other numbers from the same seed."""
    return point_set.make(np.random.default_rng([seed, zlib.crc32(point_set.name.encode())]))


def draw_ladder(
    rng: np.random.Generator, count: int, low: float = 1e-300, high: float = 1e-1
) -> Array:
    """Draw numbers of both signs, one in each of `count` equal steps of the logarithm."""
    steps = (np.arange(count) + rng.random(count)) / count
    size = np.exp(np.log(low) + steps * (np.log(high) - np.log(low)))
    signed: Array = np.where(rng.random(count) < 0.5, -size, size)
    return signed


def choose_evenly(count: int, wanted: int | None) -> Array:
    """Return `wanted` of `count` places, evenly spread; all if `wanted` is None or not fewer."""
    if wanted is None or wanted >= count:
        return np.arange(count)
    return np.linspace(0, count - 1, wanted).astype(int)


def join(*parts: Arguments) -> Arguments:
    """Concatenate the points of several draws."""
    whole = [np.broadcast_arrays(*part) if _is_flat(part) else part for part in parts]
    return tuple(np.concatenate(columns) for columns in zip(*whole, strict=True))


def _is_flat(part: Arguments) -> bool:
    return all(np.ndim(argument) <= 1 for argument in part)
