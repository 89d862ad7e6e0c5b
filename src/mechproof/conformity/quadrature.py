"""The four masses for any two laws, by Gauss quadrature of positive integrands over panels."""

from __future__ import annotations

import numpy as np

from mechproof.conformity.plane import subtract_twice
from mechproof.laws import Law
from mechproof.laws.kinds import find_centre, move, select
from mechproof.laws.windows import Array

# Two overlapping steps of 18 nats fall by 36: 28 nodes integrate exp(-36 x) to rounding.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(28)


def law_masses(
    true: Law, error: Law, tolerance: Array, acceptance: Array
) -> tuple[Array, Array, Array, Array]:
    """Rightly and wrongly accepted, rightly and wrongly rejected masses.

    The parameters of the laws have shape (n,), the limits shape (2, n); the results (n,). Places
    are counted from the centres of the laws, exactly where they are far from 0 and so do not keep
    the digits of what is small beside them.
    """
    count = tolerance.shape[1]
    middle, bias = find_centre(true), find_centre(error)
    true, error, tolerance = move(true, -middle), move(error, -bias), tolerance - middle
    with np.errstate(invalid="ignore"):
        acceptance = subtract_twice(acceptance, middle, bias)
    fixed = true.knots()[:, 0] == true.knots()[:, -1]
    accepted, rejected = np.zeros((2, count, 2))
    for integrate, rows in ((_add_fixed, fixed), (_add_panels, ~fixed)):
        (index,) = np.nonzero(rows)
        if index.size:
            laws = select(true, (count,), index), select(error, (count,), index)
            limits = tolerance[:, index], acceptance[:, index]
            accepted[index], rejected[index] = integrate(*laws, *limits)
    return accepted[:, 1], accepted[:, 0], rejected[:, 0], rejected[:, 1]


def _add_fixed(true: Law, error: Law, tolerance: Array, acceptance: Array) -> tuple[Array, Array]:
    """Split the masses by conformity, shape (n, 2) = (no, yes); Y has one value."""
    value = true.knots()[:, 0]
    conforming = (tolerance[0] < value) & (value < tolerance[1])
    side = np.stack([~conforming, conforming], axis=1)
    room = acceptance - value
    return side * error.probability(*room)[:, None], side * error.outside(*room)[:, None]


def _add_panels(true: Law, error: Law, tolerance: Array, acceptance: Array) -> tuple[Array, Array]:
    """Split the masses by conformity, shape (n, 2) = (no, yes); Y has a density."""
    count = tolerance.shape[1]
    cuts = _panel_cuts(true, error, tolerance, acceptance)
    row, panel = np.nonzero(np.diff(cuts, axis=1) != 0)
    start, end = cuts[row, panel], cuts[row, panel + 1]
    half = 0.5 * (end - start)
    step = half[:, None] * (1 + NODES)
    # Distances to the acceptance limits are taken from the panel's end: y itself is rounded.
    room = (acceptance[:, row] - start)[:, :, None] - step
    each = row[:, None]
    density = select(true, (count,), each).pdf(start[:, None] + step)
    conforming = (tolerance[0, row] <= start) & (end <= tolerance[1, row])
    errors = select(error, (count,), each)
    decisions = errors.probability(*room), errors.outside(*room)
    side = 2 * row + conforming
    masses = ((density * chance) @ WEIGHTS * half for chance in decisions)
    sums = np.array([np.bincount(side, mass, 2 * count) for mass in masses])
    accepted, rejected = sums.reshape(2, count, 2)
    return accepted, rejected


def _panel_cuts(true: Law, error: Law, tolerance: Array, acceptance: Array) -> Array:
    """Ascending abscissae, shape (n, panels + 1), between which every factor is smooth."""
    own = true.knots()
    shifted = acceptance.T[:, :, None] - error.knots()[:, None, :]
    others = np.concatenate([shifted.reshape(own.shape[0], -1), tolerance.T], axis=1)
    inside = np.clip(others, own[:, :1], own[:, -1:])
    cuts: Array = np.sort(np.concatenate([own, inside], axis=1), axis=1)
    return cuts
