"""Time: calls of several ways interleaved in one run, medians, spread, and ratios by round.

Hoefler and Belli (2015) ask for medians with quartiles, as times are not normally distributed. Ways
are compared round by round, as other work of the machine slows all of a round. Kernels tailored to
the sizes of a timed call show what an asked error costs.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np
import sympy as sp

from mechproof.lab.sampling.point_sets import list_workloads
from mechproof.lab.subject import Subject
from mechproof.lab.ways import COMPILED, Arguments, Array, Way
from mechproof.measured import COPY, MeasuredTailoring, Timing, round_off
from mechproof.tailoring import tailor
from mechproof.tailoring.tailored import Tailored

# Key of the number of points at which the paces were taken.
COUNTED = ""
SEED = 11
# Seconds: a much shorter call is repeated, so that the cost of the clock does not count.
SHORTEST = 5e-4
LONG_ENOUGH = 2.5
UFUNCS = (np.tan, np.arctan, np.sin, np.cos, np.arctan2, np.sqrt, np.divide, np.multiply)
# Number of points, few enough that argument and result stay in a core's own cache.
UFUNC_COUNT, UFUNC_ROUNDS = 16_384, 9
# Number of points for the first estimate, which decides which ways are too slow for a size.
PROBE = 16


@dataclass(frozen=True)
class Effort:
    """How much is timed: sizes, rounds for each, and seconds that a single call may take."""

    sizes: tuple[int, ...]
    rounds: tuple[int, ...]
    longest: float


FULL = Effort((1_000, 100_000, 10_000_000), (15, 15, 5), 1.5)
QUICK = Effort((1_000, 100_000), (3, 3), 0.2)


def time_subject(
    subject: Subject, effort: Effort, tailored: Sequence[Tailoring] = ()
) -> list[Timing]:
    """Time all ways of a quantity on all its workloads, except calls that take too long.

    Tailored kernels are timed on the workloads that they were tailored to.
    """
    rows: list[Timing] = []
    for name, workload in list_workloads(subject):
        ways = (*subject.ways, *(way for about, way in tailored if about.workload == name))
        pace = _probe(ways, workload(PROBE))
        # A way that is too slow for every size still gets the time of its few points.
        slow = [w for w in ways if not _is_worth(w, pace, effort, effort.sizes[0])]
        rows += [_summarise(w.name, name, PROBE, [pace[w.name] * PROBE]) for w in slow]
        for count, rounds in zip(effort.sizes, effort.rounds, strict=True):
            arguments = workload(count)
            fitting = ways if _fits(arguments, effort) else ()
            worth = [w for w in fitting if _is_worth(w, pace, effort, count)]
            rows += _time_size(subject, name, arguments, worth, (count, rounds), pace)
    return rows


def _is_worth(way: Way, pace: dict[str, float], effort: Effort, count: int) -> bool:
    """Return whether one call is estimated to be short enough.

    Time is proportional to the number of points, except for a solver of a whole sweep, for which it
    depends on the range.
    """
    if way.ordered:
        # The last call, on fewer points, may have been a first one.
        return pace[way.name] * pace[COUNTED] <= 2 * effort.longest
    return pace[way.name] * count <= effort.longest


def _probe(ways: Sequence[Way], arguments: Arguments) -> dict[str, float]:
    """Estimate seconds per point from the second call on a few points; the first may import."""
    with np.errstate(all="ignore"):
        calls = {w.name: _bind(w.compute, arguments, w.place) for w in ways}
        for call in calls.values():
            call()
        times = {name: _time_call(call, 1) / PROBE for name, call in calls.items()}
    return {**times, COUNTED: PROBE}


def _fits(arguments: Arguments, effort: Effort) -> bool:
    """Return whether the arguments take no more than two arrays of the largest size."""
    return sum(np.asarray(a).nbytes for a in arguments) <= 2 * 8 * effort.sizes[-1]


def _time_size(
    subject: Subject,
    workload: str,
    arguments: Arguments,
    worth: Sequence[Way],
    size: tuple[int, int],
    pace: dict[str, float],
) -> list[Timing]:
    """Time one size (points, rounds); `pace` has the seconds per point at smaller sizes."""
    count, rounds = size
    calls: dict[str, Callable[[], object]] = {
        w.name: _bind(w.compute, arguments, w.place) for w in worth
    }
    calls[COPY] = _copy_call(np.shape(subject.kernel(*arguments)))
    times = interleave(calls, rounds)
    pace |= {name: float(np.median(t)) / count for name, t in times.items()} | {COUNTED: count}
    first = times.get(subject.ways[0].name)
    return [_summarise(name, workload, count, times[name], first) for name in calls]


def time_ufuncs() -> dict[str, float]:
    """Return ns per point of the ufuncs in kernels: no kernel is faster than its ufuncs."""
    values = np.random.default_rng(SEED).uniform(-50, 50, UFUNC_COUNT)
    target = np.empty_like(values)
    calls: dict[str, Callable[[], object]] = {
        ufunc.__name__: _bind(ufunc, (values,) * ufunc.nin + (target,)) for ufunc in UFUNCS
    }
    times = interleave(calls, UFUNC_ROUNDS)
    return {name: round_off(float(np.median(t)) / UFUNC_COUNT * 1e9) for name, t in times.items()}


def _bind(
    compute: Callable[..., Any], arguments: Arguments, place: Callable[[Any], Any] | None = None
) -> Callable[[], object]:
    """Bind arrays, moved to where a way computes; other arguments become plain numbers."""
    written: list[Any] = [a if np.ndim(a) else np.asarray(a).item() for a in arguments]
    if place is not None:
        written = [*map(place, written)]
    return lambda: compute(*written)


def _copy_call(shape: tuple[int, ...]) -> Callable[[], object]:
    source, target = np.ones(shape), np.empty(shape)
    return lambda: np.copyto(target, source)


def interleave(calls: Mapping[str, Callable[[], object]], rounds: int) -> dict[str, list[float]]:
    """Return seconds per call of every way in every round, in a new random order each round.

    A way is dropped after LONG_ENOUGH seconds and two rounds.
    """
    rng = np.random.default_rng(SEED)
    with np.errstate(all="ignore"):
        single = {name: _time_call(call, 1) for name, call in calls.items()}
        single = {name: min(single[name], _time_call(call, 1)) for name, call in calls.items()}
        repeats = {name: max(1, int(SHORTEST / t)) for name, t in single.items()}
        times: dict[str, list[float]] = {name: [] for name in calls}
        for turn in range(rounds):
            for name in rng.permutation(list(calls)):
                if turn < 2 or turn * single[name] < LONG_ENOUGH:
                    times[name].append(_time_call(calls[name], repeats[name]))
    return times


def _time_call(call: Callable[[], object], repeats: int) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - start) / repeats


def _summarise(
    way: str, workload: str, count: int, mine: list[float], first: list[float] | None = None
) -> Timing:
    """Summarise the rounds of one way; `first` are the times of the first way."""
    quartiles = np.quantile(mine, [0.25, 0.5, 0.75]) / count * 1e9
    lower, median, upper = (round_off(float(q)) for q in quartiles)
    ratio = None if first is None else round_off(_median_ratio(mine, first))
    return Timing(workload, way, count, len(mine), median, lower, upper, ratio)


def _median_ratio(mine: list[float], reference: list[float]) -> float:
    """Return the median of the ratios in the rounds that both were timed in."""
    return float(np.median([a / b for a, b in zip(mine, reference, strict=False)]))


# Errors that tailored kernels are asked for, in the unit of the quantity.
ASKED = (1e-3, 1e-6, 1e-9, 1e-12)

Tailoring = tuple[MeasuredTailoring, Way]


def list_tailored(subject: Subject, count: int) -> list[Tailoring]:
    """Tailor a quantity of the package to its timed calls with `count` points.

    Without numba, or if no function is computed, there is nothing to gain and none is returned.
    """
    is_packaged = subject.origin is not None and subject.origin[1] is None
    if not (is_packaged and find_spec("numba") and subject.exact.has(sp.Function)):
        return []
    calls = ((name, workload(count)) for name, workload in list_workloads(subject))
    return [found for name, call in calls for found in _tailor(subject, name, call)]


def _tailor(subject: Subject, workload: str, call: Arguments) -> Iterator[Tailoring]:
    """Yield tailored kernels for attainable errors, if only the first argument varies."""
    first, *others = subject.quantity.arguments
    running, *numbers = (np.asarray(a, float) for a in call)
    if running.ndim != 1 or any(a.ndim for a in numbers):
        return
    ends = float(running.min()), float(running.max())
    sizes = {a.name: float(number) for a, number in zip(others, numbers, strict=True)}
    arguments: dict[str, Any] = {first.name: ends, **sizes}
    for asked in ASKED:
        try:
            kernel = tailor(subject.name, error=asked, derivations=subject.folder, **arguments)
        except (TypeError, ValueError):
            return
        yield _describe(kernel, workload, ends, sizes), _as_way(kernel)


def _describe(
    kernel: Tailored, workload: str, ends: tuple[float, float], sizes: dict[str, float]
) -> MeasuredTailoring:
    return MeasuredTailoring(
        _name(kernel), workload, kernel.asked, kernel.bound, sizes, ends, kernel.degrees
    )


def _as_way(kernel: Tailored) -> Way:
    def compute(running: Array, *sizes: Array) -> Array:
        del sizes
        found: Array = kernel(running)
        return found

    return Way(_name(kernel), compute, "form", needs=COMPILED)


def _name(kernel: Tailored) -> str:
    return f"tailored to {kernel.asked:g}"
