"""Points chosen to hurt: the parts from which the tables build their point sets.

Every set is drawn anew from a seed: searches climb from the sets of the seed TUNE, tables report
those of the seed REPORT, so nothing is reported on the points it was found on. The exact singular
points belong to both.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mechproof.lab.method import Arguments, Array

TUNE, REPORT = 20240826, 20261231
LOWEST = np.int64(-(2**63))


@dataclass(frozen=True)
class PointSet:
    """Named points: `make` draws the arguments, in the order of the quantity's arguments.

    The leading axis runs over the points; an argument of fewer axes is shared by all of them.
    `ordered`: the first argument rises from 0 in even steps, all others are shared.
    """

    name: str
    make: Callable[[np.random.Generator], Arguments]
    ordered: bool = False


def draw_points(point_set: PointSet, seed: int) -> Arguments:
    """Draw a point set; sets of other names get other numbers from the same seed."""
    return point_set.make(np.random.default_rng([seed, zlib.crc32(point_set.name.encode())]))


def step_ulps(value: Array, steps: Array) -> Array:
    """Move doubles by whole numbers of ulps, across zero and powers of two as well."""
    ordered = _to_order(np.asarray(value, np.float64)) + np.asarray(steps, np.int64)
    return _from_order(ordered)


def _to_order(value: Array) -> Array:
    bits = value.view(np.int64)
    return np.where(bits < 0, LOWEST - np.minimum(bits, 0), bits)


def _from_order(order: Array) -> Array:
    bits = np.where(order < 0, LOWEST - np.minimum(order, 0), order)
    value: Array = np.asarray(bits, np.int64).view(np.float64)
    return value


def draw_ladder(
    rng: np.random.Generator, count: int, low: float = 1e-300, high: float = 1e-1
) -> Array:
    """Draw numbers of both signs, one to each of `count` equal steps of the logarithm."""
    steps = (np.arange(count) + rng.random(count)) / count
    size = np.exp(np.log(low) + steps * (np.log(high) - np.log(low)))
    signed: Array = np.where(rng.random(count) < 0.5, -size, size)
    return signed


def join(*parts: Arguments) -> Arguments:
    """Put the points of several draws after one another."""
    whole = [np.broadcast_arrays(*part) if _is_flat(part) else part for part in parts]
    return tuple(np.concatenate(columns) for columns in zip(*whole, strict=True))


def _is_flat(part: Arguments) -> bool:
    return all(np.ndim(argument) <= 1 for argument in part)
