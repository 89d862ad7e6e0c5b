"""The range of a function for sizes that scatter by stated laws (Monte Carlo)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.arrays import check_array
from mechproof.arguments.scalars import check_count, check_probability, require
from mechproof.tolerance.sizes import (
    CHUNK,
    Floats,
    Function,
    Progress,
    Report,
    Size,
    check_names,
    check_sizes,
    evaluate,
    slices,
)


class Law(Protocol):
    """How a size scatters, about the middle between its limits."""

    def sample(self, rng: np.random.Generator, count: int) -> Floats:
        """Draw deviations from the middle, in units of half the tolerance."""


@dataclass(frozen=True)
class Uniform:
    """Equally likely anywhere between the limits."""

    def sample(self, rng: np.random.Generator, count: int) -> Floats:
        """Draw deviations in [-1, 1)."""
        return rng.uniform(-1, 1, count)


@dataclass(frozen=True)
class Normal:
    """Normal; the tolerance is `multiple` standard deviations wide, and limits are exceeded."""

    multiple: float

    def __post_init__(self) -> None:
        """Check the multiple."""
        if not 0 < self.multiple < np.inf:
            raise ValueError(f"multiple = {self.multiple}: must be positive and finite")

    def sample(self, rng: np.random.Generator, count: int) -> Floats:
        """Draw deviations of standard deviation 2/multiple."""
        return rng.normal(0, 2 / self.multiple, count)


@dataclass(frozen=True)
class TruncatedNormal:
    """As `Normal`, of the sizes between the limits only (the others are sorted out).

    Outside 1e-3 <= multiple <= 70 it cannot be told from `Uniform` or from `Normal`.
    """

    multiple: float

    def __post_init__(self) -> None:
        """Check the multiple."""
        if not 1e-3 <= self.multiple <= 70:
            raise ValueError(
                f"multiple = {self.multiple}: must lie between 1e-3 (below: use Uniform) "
                "and 70 (above: use Normal)"
            )

    def sample(self, rng: np.random.Generator, count: int) -> Floats:
        """Draw deviations in [-1, 1] through the inverse distribution function."""
        from scipy.special import ndtr, ndtri

        end = self.multiple / 2
        # Drawn in the lower half, where probabilities keep their digits, and mirrored.
        half = ndtri(rng.uniform(ndtr(-end), 0.5, count)) / end
        return np.asarray(np.where(rng.integers(2, size=count), half, -half))


@dataclass(frozen=True, eq=False)
class MonteCarloRange:
    """Range of stated probability, mean and standard deviation, all of the inputs' shape.

    `undefined` counts the samples for which the function is NaN; where there is one, no range
    is claimed: everything else is NaN there.
    """

    probability: float
    count: int
    lower: Any
    upper: Any
    mean: Any
    standard_deviation: Any
    undefined: Any


def monte_carlo_range(
    function: Function,
    inputs: ArrayLike,
    sizes: Mapping[str, Size],
    *,
    laws: Law | Mapping[str, Law],
    rng: np.random.Generator,
    probability: float = 0.9973,
    count: int = 100_000,
    chunk: int = CHUNK,
    progress: Progress | None = None,
) -> MonteCarloRange:
    """Sample independent sizes and return the symmetric range of the given probability.

    The ends are the sample's quantiles (1 ∓ probability)/2. The share of samples beyond an end
    scatters about its q by √(q(1-q)/count): 9 % of q at the defaults.

    Parameters
    ----------
    function, inputs, sizes, progress
        As in `corner_range`.
    laws
        One law for all sizes with a tolerance, or one per name.
    rng
        Source of the samples, drawn in the order of `sizes`; the same samples serve all inputs.
    probability
        Between 0 and 1; 0.9973 is ± 3 standard deviations of a normal law.
    count
        Number of samples, at least 2.
    chunk
        Values per call. Memory is a few times this, and `count` numbers for every size and
        for a few inputs at a time.

    Raises
    ------
    TypeError, ValueError
        Names the parameter.

    """
    check_count("count", count, least=2)
    check_count("chunk", chunk)
    check_probability("probability", probability)
    points = check_array("inputs", inputs)
    report = Report(points.size * count, progress)
    samples = _draw(sizes, laws, rng, count)
    tail = (1 - probability) / 2
    results = np.empty((4, points.size))
    undefined = np.empty(points.size, np.int64)
    for part in slices(points.size, max(1, chunk // count)):
        values = _evaluate_samples(
            function, points.reshape(-1, 1)[part], samples, count, chunk, report
        )
        results[:2, part] = np.quantile(values, (tail, 1 - tail), axis=1)
        results[2, part] = values.mean(axis=1)
        results[3, part] = values.std(axis=1, ddof=1)
        undefined[part] = np.count_nonzero(np.isnan(values), axis=1)
    lower, upper, mean, deviation = (row.reshape(points.shape)[()] for row in results)
    counts = undefined.reshape(points.shape)[()]
    return MonteCarloRange(probability, count, lower, upper, mean, deviation, counts)


def _draw(
    sizes: Mapping[str, Size],
    laws: Law | Mapping[str, Law],
    rng: np.random.Generator,
    count: int,
) -> dict[str, float | Floats]:
    """Return samples of the sizes with a tolerance and the numbers of the fixed ones."""
    is_source = isinstance(rng, np.random.Generator)
    require(is_source, "rng", rng, "must be a numpy.random.Generator", TypeError)
    varying = check_sizes(sizes)
    law_of = laws if isinstance(laws, Mapping) else dict.fromkeys(varying, laws)
    check_names("laws", law_of, varying)
    samples: dict[str, float | Floats] = {name: size.nominal for name, size in sizes.items()}
    for name, size in varying.items():
        deviations = law_of[name].sample(rng, count)
        middle = size.nominal + size.middle_deviation
        samples[name] = middle + size.tolerance / 2 * deviations
    return samples


def _evaluate_samples(
    function: Function,
    inputs: Floats,
    samples: Mapping[str, float | Floats],
    count: int,
    chunk: int,
    report: Report,
) -> Floats:
    values = np.empty((inputs.size, count))
    for part in slices(count, chunk // inputs.size):
        chosen = {
            name: size[part] if isinstance(size, np.ndarray) else size
            for name, size in samples.items()
        }
        values[:, part] = evaluate(function, inputs, chosen, values[:, part].shape)
        report.add(values[:, part].size)
    return values
