"""Points chosen to hurt: the parts from which the tables build their point sets.

Every set is drawn anew from a seed: searches climb from the sets of the seed TUNE, tables report
those of the seed REPORT, so nothing is reported on the points it was found on. The exact singular
points belong to both. Of a sequence that is the same for all, the even seed takes the even points
and the odd seed the odd ones.
"""

from __future__ import annotations

import zlib

import numpy as np

from mechproof.lab.specimen import Arguments, Array
from mechproof.lab.subject import Box, PointSet, Subject

TUNE, REPORT = 20240826, 20261231
ULPS = (0, 1, -1, 2, -2, 10, -10, 100, -100, 1000, -1000)
GENERIC_COUNT = 200


def draw_points(point_set: PointSet, seed: int) -> Arguments:
    """Draw a point set; sets of other names get other numbers from the same seed."""
    points = point_set.make(np.random.default_rng([seed, zlib.crc32(point_set.name.encode())]))
    return tuple(c[seed % 2 :: 2] for c in points) if point_set.halved else points


def step_ulps(value: Array, steps: Array) -> Array:
    """Move doubles by whole numbers of ulps, across zero and powers of two as well."""
    ordered = _to_order(np.asarray(value, np.float64)) + np.asarray(steps, np.int64)
    return _from_order(ordered)


def _to_order(value: Array) -> Array:
    bits = value.view(np.int64)
    return np.where(bits < 0, np.int64(-(2**63)) - bits, bits)


def _from_order(order: Array) -> Array:
    bits = np.where(order < 0, np.int64(-(2**63)) - order, order)
    value: Array = np.asarray(bits, np.int64).view(np.float64)
    return value


def spread_ulps(values: Array, rng: np.random.Generator) -> Array:
    """Return each value, its neighbours up to 1000 ulps, and as many at random among them."""
    random = rng.integers(-1000, 1001, len(ULPS))
    steps = np.concatenate([np.array(ULPS), random])
    return step_ulps(np.repeat(np.asarray(values, float), len(steps)), np.tile(steps, len(values)))


def draw_ladder(
    rng: np.random.Generator, count: int, low: float = 1e-300, high: float = 1e-1
) -> Array:
    """Draw numbers of both signs, one to each of `count` equal steps of the logarithm."""
    steps = (np.arange(count) + rng.random(count)) / count
    size = np.exp(np.log(low) + steps * (np.log(high) - np.log(low)))
    signed: Array = np.where(rng.random(count) < 0.5, -size, size)
    return signed


def draw_within(rng: np.random.Generator, count: int, low: float, high: float) -> Array:
    """Draw sizes of both signs in [low, high]: both ends, half evenly, half by the logarithm."""
    floor = low if low > 0 else min(1e-300, high)
    by_logarithm = np.exp(rng.uniform(np.log(floor), np.log(high), count - count // 2))
    size = np.concatenate([rng.uniform(low, high, count // 2), by_logarithm])
    size[:2] = low, high
    return rng.permutation(np.clip(size, low, high) * rng.choice([-1.0, 1.0], count))


def pair_up(*columns: Array) -> Arguments:
    """Return every combination of the columns, flat."""
    return tuple(axis.ravel() for axis in np.meshgrid(*map(np.asarray, columns), indexing="ij"))


def join(*parts: Arguments) -> Arguments:
    """Put the points of several draws after one another."""
    whole = [np.broadcast_arrays(*part) if _is_flat(part) else part for part in parts]
    return tuple(np.concatenate(columns) for columns in zip(*whole, strict=True))


def _is_flat(part: Arguments) -> bool:
    return all(np.ndim(argument) <= 1 for argument in part)


def generic_set(subject: Subject) -> PointSet:
    """Spread points over the domain of a quantity that has no rows."""
    symbols = [s for argument in subject.quantity.arguments for s in argument.symbols]
    counts = [len(argument.symbols) for argument in subject.quantity.arguments]

    def make(_: np.random.Generator) -> Arguments:
        inside = subject.domain.points(symbols, GENERIC_COUNT)
        table = np.array([[float(point[s]) for s in symbols] for point in inside])
        columns = np.split(table, np.cumsum(counts)[:-1], axis=1)
        return tuple(c[:, 0] if c.shape[1] == 1 else c for c in columns)

    return PointSet("domain", make, halved=True)


def list_sets(subject: Subject) -> tuple[PointSet, ...]:
    """List the point sets of a subject: those of its rows, or points of its domain."""
    return subject.study.sets or (generic_set(subject),)


def list_boxes(subject: Subject) -> list[Box]:
    """List the boxes between the edges of the cells; none without cells."""
    cells = subject.study.cells
    if not cells:
        return []
    spans = [list(zip(c.edges, c.edges[1:], strict=False)) for c in cells]
    grids = np.meshgrid(*(np.arange(len(s)) for s in spans), indexing="ij")
    indices = zip(*(grid.ravel() for grid in grids), strict=True)
    names = [c.argument for c in cells]
    return [{n: s[i] for n, s, i in zip(names, spans, row, strict=True)} for row in indices]
