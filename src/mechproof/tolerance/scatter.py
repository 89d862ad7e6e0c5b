"""The range of a function for sizes that scatter by stated laws (Monte Carlo)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.arrays import check_array
from mechproof.arguments.scalars import check_count, check_probability, require
from mechproof.laws.kinds import LAWS, list_parameters
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


class Scatter(Protocol):
    """How a size scatters: a law of `mechproof.laws`, or whatever else can be sampled."""

    def sample(self, rng: np.random.Generator, size: int, /) -> Any:
        """Draw `size` independent values."""


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
    laws: Callable[[Size], Scatter] | Mapping[str, Scatter],
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
        The law of every size with a tolerance, by name, or what makes it of a size: `Size.uniform`,
        `lambda size: size.normal(6)`.
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
    laws: Callable[[Size], Scatter] | Mapping[str, Scatter],
    rng: np.random.Generator,
    count: int,
) -> dict[str, float | Floats]:
    """Return samples of the sizes with a tolerance and the numbers of the fixed ones."""
    is_source = isinstance(rng, np.random.Generator)
    require(is_source, "rng", rng, "must be a numpy.random.Generator", TypeError)
    varying = check_sizes(sizes)
    law_of = _find_laws(laws, varying)
    samples: dict[str, float | Floats] = {name: size.nominal for name, size in sizes.items()}
    for name in varying:
        samples[name] = _sample(f"laws[{name!r}]", law_of[name], rng, count)
    return samples


def _find_laws(
    laws: Callable[[Size], Scatter] | Mapping[str, Scatter], varying: Mapping[str, Size]
) -> Mapping[str, Scatter]:
    if isinstance(laws, Mapping):
        check_names("laws", laws, varying)
        return laws
    allowed = "must be laws by the names of sizes, or a function of a Size such as Size.uniform"
    require(callable(laws), "laws", laws, allowed, TypeError)
    return {name: laws(size) for name, size in varying.items()}


def _sample(name: str, law: Scatter, rng: np.random.Generator, count: int) -> Floats:
    is_law = callable(getattr(law, "sample", None))
    require(is_law, name, law, "must be a law, or have a method sample(rng, size)", TypeError)
    single = not isinstance(law, LAWS) or all(p.ndim == 0 for p in list_parameters(law))
    require(single, name, law, "must have one number for each parameter")
    values = np.asarray(law.sample(rng, count), np.float64)
    require(values.shape == (count,), name, law, f"gave shape {values.shape} for {count} values")
    return values


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
