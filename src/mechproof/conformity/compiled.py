"""Exact shares of parts, compiled: one loop for two normal laws, by numba.

>>> from mechproof.conformity.compiled import shares

takes the arguments of `mechproof.conformity.shares`, with its accuracy, NaN and errors. numba
compiles the formulas of that function for single numbers. Only what differs is here: exponentials
and tails of the normal law in plain arithmetic, and integrals as sums over a table of nodes. Many
parameter sets are distributed over the processors.

Needs numba; nothing else imports it.
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from mechproof.compiled_support import (
    POINTS,
    choose,
    count_numbers,
    inner,
    loop,
    machine,
    points,
    put,
    run_parts,
    stand_in,
    take,
)
from mechproof.conformity import arc, bivariate_normal, plane
from mechproof.conformity.arc import LENGTHS, make_panel
from mechproof.conformity.risks import Limits, Shares, find_shares
from mechproof.executors import slices
from mechproof.kernels.compiled import elementary
from mechproof.laws import Law, pointwise, windows
from mechproof.laws.windows import Array

PART = 4096  # parameter sets that one thread takes at a time
THREADED = 4 * PART  # the number from which a second thread pays
ROW = 8  # nodes: in whole rows there are no single ones left over
ROOT = float(np.sqrt(2 * np.pi))


def _stack_panels() -> tuple[Array, Array]:
    """Return the rows where panels begin, and the nodes of all panels in whole rows."""
    tables = []
    for size in range(LENGTHS.size):
        exponents, powers, weights = make_panel(size)
        table = np.zeros((4, -(-weights.size // ROW) * ROW))
        table[:, : weights.size] = [*exponents, powers[1], weights]
        tables.append(table.reshape(4, -1, ROW).swapaxes(0, 1))
    return np.cumsum([0, *map(len, tables)]), np.ascontiguousarray(np.concatenate(tables))


STARTS, PANELS = _stack_panels()
# numba takes arrays of a module as constants.
FEW_NODES, FEW_WEIGHTS = windows.FEW_NODES, windows.FEW_WEIGHTS
UNIT_NODES, UNIT_WEIGHTS = windows.UNIT_NODES, windows.UNIT_WEIGHTS

FORMULAS = (
    *(windows.subtract_tails, windows.complete, windows.find_tails, windows.normal_interval),
    *(windows.normal_density, windows.scale_distance, arc.choose_size),
    *(plane.subtract_twice, plane.find_gap, plane.place_plane, plane.place_corner),
    *(
        plane.subtract_ordered,
        plane.place,
        bivariate_normal.complete_corner,
        bivariate_normal.integrate_sides,
    ),
    *(
        bivariate_normal.is_needed,
        bivariate_normal.add_quadrants,
        bivariate_normal.find_quadrants,
        bivariate_normal.find_accepted,
    ),
    *(bivariate_normal.find_conforming, bivariate_normal.add_masses),
)
for formula in FORMULAS:
    stand_in(formula, forceinline=True)(formula)

stand_in(pointwise.choose)(lambda condition, a, b: choose(condition, a, b))
stand_in(pointwise.exp)(lambda x: elementary.exp(x))
stand_in(pointwise.hypot)(lambda a, b: elementary.hypot(a, b))
stand_in(pointwise.normal_tail)(lambda z: elementary.normal_tail(z))


@stand_in(pointwise.compute_where)
def _compute_where(condition: Any, function: Any, arguments: Any, otherwise: Any) -> Any:
    return function(*arguments) if condition else otherwise


# Sums in any order: several terms at a time.
SUM = {"fastmath": {"reassoc", "contract"}}


@stand_in(windows.integrate_density, **SUM)
def _integrate_density(start: float, width: float) -> float:
    half = 0.5 * width
    middle, total = start + half, 0.0
    for n in range(FEW_NODES.size):
        z = middle + half * FEW_NODES[n]
        total += elementary.exp(-0.5 * z * z) * FEW_WEIGHTS[n]
    return total * (half / ROOT)


@stand_in(bivariate_normal.integrate_strip, **SUM)
def _integrate_strip(start: float, width: float, argument: float, slope: float) -> float:
    total = 0.0
    for n in range(UNIT_NODES.size):
        step = width * UNIT_NODES[n]
        beyond, _ = windows.find_tails(argument + slope * step)
        total += windows.normal_density(start + step) * beyond * UNIT_WEIGHTS[n]
    return total * width


@stand_in(bivariate_normal.integrate_rectangle, **SUM)
def _integrate_rectangle(
    start: float, width: float, low: float, high: float, slope: float, span: float
) -> float:
    total = 0.0
    for n in range(UNIT_NODES.size):
        step = width * UNIT_NODES[n]
        inner = windows.normal_interval(low - slope * step, high - slope * step, span)
        total += windows.normal_density(start + step) * inner * UNIT_WEIGHTS[n]
    return total * width


@stand_in(arc.integrate_arc, **SUM)
def _integrate_arc(p: float, q: float, one: float, square: float) -> float:
    size, total = arc.choose_size(p, q), 0.0
    for row in range(STARTS[size], STARTS[size + 1]):
        for n in range(ROW):
            value = elementary.exp(p * PANELS[row, 0, n] + q * PANELS[row, 1, n])
            total += value * PANELS[row, 3, n] / (one + square * PANELS[row, 2, n])
    return total * (one + square) / (2 * np.pi)


@inner
def _place(block: Any, sets: Any, start: int, stop: int) -> None:
    for i in range(start, stop):
        tolerance, acceptance = (sets[4, i], sets[5, i]), (sets[6, i], sets[7, i])
        law, error = (sets[0, i], sets[1, i]), (sets[2, i], sets[3, i])
        put(block, i - start, plane.place(*law, *error, tolerance, acceptance))


@inner
def _add(masses: Any, block: Any, start: int, stop: int) -> None:
    example = plane.place(0.0, 1.0, 0.0, 1.0, (-1.0, 1.0), (-1.0, 1.0))
    for i in range(start, stop):
        four = bivariate_normal.add_masses(*take(block, i - start, example))
        masses[0, i], masses[1, i], masses[2, i], masses[3, i] = four


def _make_fill(version: int) -> Any:
    """Return the loop over parameter sets, which fills their masses.

    numba caches the compiled loop while this file and what the loop encloses stay the same.
    """

    @loop
    def fill(masses: Any, sets: Any) -> int:
        example = plane.place(0.0, 1.0, 0.0, 1.0, (-1.0, 1.0), (-1.0, 1.0))
        block = np.empty(count_numbers(example) * POINTS)
        for start in range(0, sets.shape[1], POINTS):
            stop = min(start + POINTS, sets.shape[1])
            _place(block, sets, start, stop)
            _add(masses, block, start, stop)
        return version

    return fill


def _hash_sources(*modules: ModuleType) -> int:
    texts = b"".join(Path(str(module.__file__)).read_bytes() for module in modules)
    return int(sha256(texts).hexdigest()[:15], 16)


# Modules with the formulas that the loop uses.
SOURCES = (bivariate_normal, plane, arc, windows, pointwise, elementary, machine, points)
_fill = _make_fill(_hash_sources(*SOURCES))


def _fill_masses(masses: Array, parameters: Sequence[Array]) -> None:
    """Fill the masses of two normal laws, for many sets on several threads."""
    count = masses.shape[1]

    def fill(part: slice) -> None:
        found = np.empty((4, part.stop - part.start))
        _fill(found, np.stack([p[part] for p in parameters]))
        masses[:, part] = found

    if count < THREADED:
        fill(slice(0, count))
    else:
        run_parts(fill, slices(count, PART))


def shares(true: Law, error: Law, tolerance: Limits, acceptance: Limits | None = None) -> Shares:
    """Return the exact shares of rightly and wrongly accepted and rejected parts, compiled.

    See `mechproof.conformity.shares`. Laws that are not both normal use its quadrature.
    """
    return find_shares(true, error, tolerance, acceptance, _fill_masses)
