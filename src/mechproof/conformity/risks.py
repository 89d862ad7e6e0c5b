"""Exact shares of parts, risks of one measured value, and shares counted in a simulation.

These are the risks of JCGM 106:2012, where they are integrals of two densities. For arbitrary laws,
positive integrands are integrated by Gauss quadrature over panels.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_finite, check_pair
from mechproof.arguments.scalars import check_count, check_progress
from mechproof.conformity.bivariate_normal import normal_masses
from mechproof.conformity.plane import subtract_twice
from mechproof.executors import check_executor, run_in_order, slices, spawn_generators
from mechproof.laws import Law, Normal
from mechproof.laws.kinds import LAWS, check_law, find_centre, list_parameters, move, select
from mechproof.laws.windows import Array

Limits = tuple[ArrayLike, ArrayLike]

NORMAL_CHUNK = 8192  # parameter sets at a time: temporaries that the heap keeps
LAW_CHUNK = 32  # parameter sets at a time, up to some 1 MB each
LEVEL = 0.95  # of the one-sided bounds of a simulated share


@dataclass(frozen=True, eq=False)
class Shares:
    """The four shares of parts; arrays of the broadcast shape, or NumPy scalars."""

    rightly_accepted: Any
    wrongly_accepted: Any
    rightly_rejected: Any
    wrongly_rejected: Any


@dataclass(frozen=True, eq=False)
class SimulatedShares(Shares):
    """Shares counted among `count` simulated parts, with their uncertainty.

    `standard_error` is the binomial sqrt(p (1 - p) / count), NaN where no part or every part fell
    in a share: the estimate 0 would be false there. `lower` and `upper` are one-sided bounds, each
    at the 95 % level (Clopper and Pearson); for no part in `count`, `upper` is close to 3/count.
    """

    count: int
    standard_error: Shares
    lower: Shares
    upper: Shares


def shares(true: Law, error: Law, tolerance: Limits, acceptance: Limits | None = None) -> Shares:
    """Return the exact shares of rightly and wrongly accepted and rejected parts.

    `true` is the law of the true deviation and `error` that of the measurement error, whose mean is
    the bias. `tolerance` and `acceptance` are pairs (lower, upper) in the same unit, infinite for a
    one-sided limit. Without `acceptance`, the tolerance limits are used (simple acceptance). All
    parameters broadcast. Where one is NaN, so are the shares.

    Accuracy: for two normal laws, every share above 1e-100 is right to a relative 1e-12, however
    small it is next to the others; for other laws, to 1e-12 if the widths of both laws and windows
    and the distances between them lie within a factor of 1000, wherever they all lie. A law of
    width 0 is a fixed value.

    Raises ValueError for a lower limit that is not below the upper one and for finite numbers
    beyond 1e150, and TypeError for anything but laws, pairs and real numbers without mask or unit.

    Source: paper on tooth thickness, algorithm steps 1-10; JCGM 106:2012, 9.5.
    """
    return find_shares(true, error, tolerance, acceptance, _fill_normal)


def find_shares(
    true: Law,
    error: Law,
    tolerance: Limits,
    acceptance: Limits | None,
    fill_normal: Callable[[Array, Sequence[Array]], None],
) -> Shares:
    """Find shares; `fill_normal` fills the masses of normal laws, given flat parameters."""
    for name, law in (("true", true), ("error", error)):
        check_law(name, law)
    limits = _check_limits(tolerance, acceptance)
    inputs = [*list_parameters(true), *list_parameters(error), *limits]
    shape = np.broadcast_shapes(*(p.shape for p in inputs))
    missing = np.any(np.broadcast_arrays(*map(np.isnan, inputs)), axis=0)
    masses = np.empty((4, missing.size))
    flat = [np.broadcast_to(p, shape).reshape(-1) for p in inputs]
    if isinstance(true, Normal) and isinstance(error, Normal):
        fill_normal(masses, flat)
    else:
        for part in slices(missing.size, LAW_CHUNK):
            laws = select(true, shape, part), select(error, shape, part)
            windows = (np.stack([p[part] for p in pair]) for pair in (flat[-4:-2], flat[-2:]))
            masses[:, part] = law_masses(*laws, *windows)
    return Shares(*(np.where(missing, np.nan, m.reshape(shape))[()] for m in masses))


def _fill_normal(masses: Array, parameters: Sequence[Array]) -> None:
    """Fill the masses of two normal laws, by arc integrals."""
    for part in slices(masses.shape[1], NORMAL_CHUNK):
        mu, sigma, bias, s, low, high, least, most = (p[part] for p in parameters)
        with np.errstate(all="ignore"):
            masses[:, part] = normal_masses(mu, sigma, bias, s, (low, high), (least, most))


def conformance_probability(
    measured: ArrayLike, true: Normal, error: Normal, tolerance: Limits
) -> tuple[Any, Any]:
    """Return the probabilities that a part with this measured value conforms, and does not.

    The first is the conformance probability. The second is the specific consumer's risk if the
    part is accepted; the first is the specific producer's risk if it is rejected. Both come from
    the normal law of Y given Y + E = measured, each relatively accurate to 1e-12 down to 1e-20.
    Arguments and errors as in `shares`.

    Source: JCGM 106:2012, 7.2 and 9.3.
    """
    for name, law in (("true", true), ("error", error)):
        check_law(name, law, Normal)
    low, high = check_pair("tolerance", tolerance)
    rho = np.hypot(true.std, error.std)
    with np.errstate(invalid="ignore"):
        gain = np.where(rho == 0, 0.0, np.asarray(true.std) / rho)
        spread = np.where(rho == 0, 0.0, np.asarray(error.std) / rho)
    surprise = subtract_twice(check_finite("measured", measured), true.mean, error.mean)
    # Relative to the mean of Y, since far from 0 a shift would lose digits.
    given = Normal.of_checked(mean=gain**2 * surprise, std=np.asarray(true.std) * spread)
    window = low - true.mean, high - true.mean
    return given.probability(*window), given.outside(*window)


def simulate_shares(
    true: Law,
    error: Law | Sequence[Law],
    tolerance: Limits,
    acceptance: Limits | None = None,
    *,
    rng: np.random.Generator,
    count: int,
    chunk: int = 1 << 18,
    progress: Callable[[int, int], object] | None = None,
    executor: Executor | None = None,
) -> SimulatedShares:
    """Return the shares among `count` simulated parts of every parameter set.

    Arguments are as in `shares`; several error laws are independent errors that add up. Each worker
    holds about `chunk` values at a time (at least one per parameter set), whatever the count, and
    draws each chunk from a generator spawned from `rng`. `progress` is called as progress(parts
    done, count) after every chunk. The counts are the same with any `executor` of
    `concurrent.futures`. Raises ValueError for a count or chunk below 1 and for reversed limits,
    and `mechproof.tools.processes.WorkerError` if the executor loses a worker and does not recover.

    Source: paper on tooth thickness, algorithm steps 1-10.
    """
    count, chunk = check_count("count", count), check_count("chunk", chunk)
    check_executor(executor)
    check_progress(progress)
    check_law("true", true)
    if not isinstance(error, Sequence):
        check_law("error", error)
    errors = [error] if isinstance(error, LAWS) else list(error)
    for i, law in enumerate(errors):
        check_law(f"error[{i}]", law)
    limits = _check_limits(tolerance, acceptance)
    inputs = [p for law in (true, *errors) for p in list_parameters(law)] + list(limits)
    shape = np.broadcast_shapes(*(p.shape for p in inputs))
    missing = np.any(np.broadcast_arrays(*map(np.isnan, inputs)), axis=0)
    parts = max(1, chunk // max(1, int(np.prod(shape))))
    sizes = ((part.stop - part.start, *shape) for part in slices(count, parts))
    tasks = zip(sizes, spawn_generators(rng), strict=False)
    counts = np.zeros((4, *shape))
    counting = run_in_order(partial(_count, (true, *errors), limits), tasks, executor, batch=1)
    for part, found in zip(slices(count, parts), counting, strict=True):
        counts[:3] += found
        if progress is not None:
            progress(part.stop, count)
    counts[3] = count - counts[:3].sum(axis=0)
    return _estimate(np.where(missing, np.nan, counts), count)


def _count(
    laws: Sequence[Law],
    limits: Sequence[Array],
    task: tuple[tuple[int, ...], np.random.Generator],
) -> list[Any]:
    """Simulate as many parts as the first axis of `size`; count all outcomes but the last."""
    (size, rng), (true, *errors) = task, laws
    low, high, low_accepted, high_accepted = limits
    value = true.sample(rng, size)
    measured = value + sum(law.sample(rng, size) for law in errors)
    conforms = (low < value) & (value < high)
    accepted = (low_accepted < measured) & (measured < high_accepted)
    outcomes = (conforms & accepted, ~conforms & accepted, ~conforms & ~accepted)
    return [outcome.sum(axis=0) for outcome in outcomes]


def _estimate(counts: Array, count: int) -> SimulatedShares:
    """Return shares, binomial standard errors and Clopper-Pearson bounds of counts (axis 0)."""
    from scipy.special import betaincinv

    share, other = counts / count, count - counts
    within = (counts > 0) & (other > 0)
    deviation = np.where(within, np.sqrt(share * (1 - share) / count), np.nan)
    lower = np.where(counts == 0, 0.0, betaincinv(counts, other + 1, 1 - LEVEL))
    upper = np.where(other == 0, 1.0, betaincinv(counts + 1, other, LEVEL))
    four = [Shares(*(v[()] for v in values)) for values in (deviation, lower, upper)]
    right, wrong, rightly_out, wrongly_out = (v[()] for v in share)
    return SimulatedShares(right, wrong, rightly_out, wrongly_out, count, *four)


def _check_limits(tolerance: Limits, acceptance: Limits | None) -> list[Array]:
    """Return lower and upper tolerance limit, lower and upper acceptance limit."""
    accepted = tolerance if acceptance is None else acceptance
    return [
        *check_pair("tolerance", tolerance),
        *check_pair("acceptance", accepted),
    ]


# Two overlapping steps of 18 nats fall by 36: 28 nodes integrate exp(-36 x) to rounding.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(28)


def law_masses(
    true: Law, error: Law, tolerance: Array, acceptance: Array
) -> tuple[Array, Array, Array, Array]:
    """Return the rightly and wrongly accepted, rightly and wrongly rejected masses.

    The parameters of the laws have shape (n,), the limits shape (2, n); the results (n,). Positions
    are relative to the centres of the laws, by exact subtraction: far from 0 they would not keep
    the digits of small differences.
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
    """Return ascending abscissae, shape (n, panels + 1), with smooth factors in between."""
    own = true.knots()
    shifted = acceptance.T[:, :, None] - error.knots()[:, None, :]
    others = np.concatenate([shifted.reshape(own.shape[0], -1), tolerance.T], axis=1)
    inside = np.clip(others, own[:, :1], own[:, -1:])
    cuts: Array = np.sort(np.concatenate([own, inside], axis=1), axis=1)
    return cuts
