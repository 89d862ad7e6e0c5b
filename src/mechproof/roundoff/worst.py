"""Worst: from the boxes with the largest bound to the input that is off most, held by balls."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from flint import arb

from mechproof.codegen.kernel import input_names
from mechproof.proof.balls import working_precision
from mechproof.roundoff.intervals import Array
from mechproof.roundoff.regions import Box, Region
from mechproof.roundoff.running import IN_BALLS, run
from mechproof.roundoff.subject import Subject

Points = dict[str, Array]
BITS = 200
DRAWN, KEPT, CHILDREN, ROUNDS = 200, 64, 8, 150
# Free coordinates are drawn from so many octaves.
OCTAVES = 16.0


@dataclass(frozen=True)
class Found:
    """An input and its error in eps of the scale."""

    eps: float
    at: Mapping[str, float]


def find_worst(subject: Subject, region: Region, boxes: Sequence[Box], seed: int) -> Found:
    """Draw points of the boxes and climb from the worst by some ulps."""
    rng = np.random.default_rng(seed)
    drawn = [draw(subject, region, box, DRAWN, rng) for box in boxes]
    crowd = {name: np.concatenate([points[name] for points in drawn]) for name in drawn[0]}
    crowd, errors = _keep_worst(subject, crowd)
    for _ in range(ROUNDS):
        moved = {name: _move(np.repeat(column, CHILDREN), rng) for name, column in crowd.items()}
        together = {name: np.concatenate([crowd[name], moved[name]]) for name in crowd}
        crowd, errors = _keep_worst(subject, together)
    return Found(float(errors[0]), {name: float(column[0]) for name, column in crowd.items()})


def measure(subject: Subject, points: Mapping[str, Array]) -> Array:
    """Return the errors of the steps in doubles in eps of the scale, -1 outside the domain."""
    with np.errstate(all="ignore"):
        outputs = subject.compute(points)
        inside = subject.holds(points)
    errors = np.full(outputs.shape[1], -1.0)
    names = list(points)
    with working_precision(BITS):
        for i in np.flatnonzero(inside & np.isfinite(outputs).all(axis=0)):
            given = {name: arb(float(points[name][i])) for name in names}
            exact = run(subject.exact, given, IN_BALLS)
            errors[i] = subject.weigh(outputs[:, i], exact, given)
    return errors


def _keep_worst(subject: Subject, points: Points) -> tuple[Points, Array]:
    errors = measure(subject, points)
    order = np.argsort(-errors, kind="stable")[:KEPT]
    return {name: column[order] for name, column in points.items()}, errors[order]


def draw(
    subject: Subject, region: Region, box: Box, count: int, rng: np.random.Generator
) -> Points:
    """Draw arguments from a box of a region."""
    sides = [_draw_side(side, count, rng) for side in box]
    coordinates = dict(zip(region.names, sides, strict=False))
    if region.is_turned:
        rest = region.angle if region.chart.rest is None else region.chart.rest
        left = sp.lambdify(list(coordinates), rest, "numpy")(*coordinates.values())
        coordinates[region.angle] = _wind(region, left, sides[-1])
    names = input_names(subject.kernel.quantity)
    expressions = list(region.chart.arguments.values())
    compute = sp.lambdify(list(coordinates), expressions, "numpy")
    with np.errstate(all="ignore"):
        values = compute(*coordinates.values())
    return {
        names[symbol]: np.broadcast_to(value, count).astype(float)
        for symbol, value in zip(region.chart.arguments, values, strict=True)
    }


def _draw_side(side: tuple[float, float], count: int, rng: np.random.Generator) -> Array:
    low, high = side
    if not math.isinf(high):
        return rng.uniform(low, high, count)
    signs = rng.choice((-1.0, 1.0), count) if math.isinf(low) else 1.0
    sizes: Array = signs * 2 ** rng.uniform(0, OCTAVES, count)
    return sizes


def _wind(region: Region, rest: Array, inverse: Array) -> Array:
    turns = np.rint((1 / inverse - rest) / (2 * np.pi)) if region.turns is None else region.turns
    whole: Array = 2 * np.pi * turns + rest
    return whole


def _move(column: Array, rng: np.random.Generator) -> Array:
    """Move by some ulps, by a share, to another's value, or not at all."""
    ulps = np.rint(rng.normal(size=column.shape) * 2.0 ** rng.uniform(0, 30, column.shape))
    shares = rng.normal(size=column.shape) * 2.0 ** rng.uniform(-20, -2, column.shape)
    moved = [column + ulps * np.spacing(column), column * (1 + shares), rng.permutation(column)]
    choice = rng.integers(0, 5, column.shape)
    return np.select([choice == i for i in range(3)], moved, column)
