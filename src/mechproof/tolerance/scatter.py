"""The range of a function for sizes with stated probability laws: Monte Carlo, as in JCGM 101."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_count, check_function, check_probability, require
from mechproof.executors import check_executor, run_in_order, slices, spawn_generators
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
)

# Samples per generator; the result depends on it.
DRAWN = 2**16

Samples = dict[str, float | Floats]


class Scatter(Protocol):
    """How a size scatters: a law of `mechproof.laws`, or anything else that can be sampled."""

    def sample(self, rng: np.random.Generator, size: int, /) -> Any:
        """Draw `size` independent values."""


@dataclass(frozen=True, eq=False)
class MonteCarloRange:
    """Range of stated probability, mean and standard deviation, all of the inputs' shape.

    `undefined` counts the samples at which the function is NaN. If there are any, no range is
    claimed: everything else is NaN there.
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
    executor: Executor | None = None,
) -> MonteCarloRange:
    """Sample independent sizes and return the symmetric range of the given probability.

    The ends are the sample quantiles (1 ∓ probability)/2. The share of samples beyond an end has a
    standard deviation of √(q(1-q)/count) about its q: 9 % of q at the defaults.

    Parameters
    ----------
    function, inputs, sizes, progress, executor
        As in `corner_range`.
    laws
        The law of every size with a tolerance, by name, or a function that makes it from a size,
        such as `Size.uniform` or `lambda size: size.normal(6)`.
    rng
        Source of the samples; the same samples serve all inputs. Every 65,536 of them come from a
        generator spawned from this one, in the order of `sizes`.
    probability
        Between 0 and 1; 0.9973 is ± 3 standard deviations of a normal law.
    count
        Number of samples, at least 2.
    chunk
        Values per call. Memory use is a few times this, plus `count` numbers for every size and for
        a few inputs at a time; an executor holds up to 32 chunks of every size.

    Raises
    ------
    TypeError, ValueError, mechproof.tools.processes.WorkerError
        As in `corner_range`; with processes, the laws must be picklable.

    """
    check_count("count", count, least=2)
    check_count("chunk", chunk)
    check_function("function", function)
    check_probability("probability", probability)
    check_executor(executor)
    points = check_array("inputs", inputs)
    report = Report(points.size * count, progress)
    samples = _draw(sizes, laws, rng, count, executor)
    tail = (1 - probability) / 2
    results = np.empty((4, points.size))
    undefined = np.empty(points.size, np.int64)
    parts = [*slices(points.size, max(1, chunk // count))]
    tasks = (
        (points.reshape(-1, 1)[part], _take(samples, columns), columns.stop - columns.start)
        for part in parts
        for columns in _cut(part, count, chunk)
    )
    blocks = run_in_order(partial(_evaluate_samples, function), tasks, executor, batch=1)
    for part in parts:
        values = np.empty((part.stop - part.start, count))
        for columns in _cut(part, count, chunk):
            values[:, columns] = next(blocks)
            report.add(values[:, columns].size)
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
    executor: Executor | None,
) -> Samples:
    """Return samples of the sizes with a tolerance and the numbers of the fixed ones."""
    varying = check_sizes(sizes)
    law_of = _find_laws(laws, varying)
    samples: Samples = {name: size.nominal for name, size in sizes.items()}
    drawn = {name: np.empty(count) for name in varying}
    parts = [*slices(count, DRAWN)]
    tasks = zip((part.stop - part.start for part in parts), spawn_generators(rng), strict=False)
    found = run_in_order(
        partial(_sample, {n: law_of[n] for n in varying}), tasks, executor, batch=1
    )
    for part, values in zip(parts, found, strict=True):
        for name in varying:
            drawn[name][part] = values[name]
    return samples | drawn


def _find_laws(
    laws: Callable[[Size], Scatter] | Mapping[str, Scatter], varying: Mapping[str, Size]
) -> Mapping[str, Scatter]:
    if isinstance(laws, Mapping):
        check_names("laws", laws, varying)
        return laws
    allowed = "must map names of sizes to laws, or be a function of a Size such as Size.uniform"
    require(callable(laws), "laws", laws, allowed, TypeError)
    return {name: laws(size) for name, size in varying.items()}


def _sample(
    laws: Mapping[str, Scatter], task: tuple[int, np.random.Generator]
) -> dict[str, Floats]:
    count, rng = task
    return {name: _sample_law(f"laws[{name!r}]", laws[name], rng, count) for name in laws}


def _sample_law(name: str, law: Scatter, rng: np.random.Generator, count: int) -> Floats:
    is_law = callable(getattr(law, "sample", None)) and not isinstance(law, type)
    require(is_law, name, law, "must be a law, or have a method sample(rng, size)", TypeError)
    single = not isinstance(law, LAWS) or all(p.ndim == 0 for p in list_parameters(law))
    require(single, name, law, "must have one number for each parameter")
    values = np.asarray(law.sample(rng, count), np.float64)
    require(values.shape == (count,), name, law, f"gave shape {values.shape} for {count} values")
    return values


def _cut(part: slice, count: int, chunk: int) -> Iterator[slice]:
    """Cut the samples into parts that are evaluated at once for a part of the inputs."""
    return slices(count, chunk // (part.stop - part.start))


def _take(samples: Samples, part: slice) -> Samples:
    return {n: s[part] if isinstance(s, np.ndarray) else s for n, s in samples.items()}


def _evaluate_samples(function: Function, task: tuple[Floats, Samples, int]) -> Floats:
    inputs, samples, count = task
    return evaluate(function, inputs, samples, (inputs.size, count))
