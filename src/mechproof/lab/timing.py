"""Time: calls of several forms interleaved in one run, medians, spread, and ratios by round."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from mechproof.lab.oracle import count_points
from mechproof.lab.points import TUNE, draw_points, list_sets
from mechproof.lab.specimen import Arguments, Specimen
from mechproof.lab.subject import Subject

COPY, REFERENCE = "memory copy", "kernel"
# The entry of the paces with the number of points they were taken at.
COUNTED = ""
SEED = 11
# A call much shorter than this is repeated, so that the clock's own cost does not count.
SHORTEST = 5e-4
LONG_ENOUGH = 2.5
UFUNCS = (np.tan, np.arctan, np.sin, np.cos, np.arctan2, np.sqrt, np.divide, np.multiply)
# Few enough that argument and result stay in a core's own cache.
UFUNC_COUNT, UFUNC_ROUNDS = 16_384, 9
# Points of the first estimate, which decides what is too slow for a size.
PROBE = 16


@dataclass(frozen=True)
class Effort:
    """How much is timed: sizes, rounds of each, and the longest single call that is worth it."""

    sizes: tuple[int, ...]
    rounds: tuple[int, ...]
    longest: float


FULL = Effort((1_000, 100_000, 10_000_000), (15, 15, 5), 1.5)
QUICK = Effort((1_000, 100_000), (3, 3), 0.2)


@dataclass(frozen=True)
class Timing:
    """Nanoseconds per point of one form at one size.

    median, and the quartiles of the rounds; `ratio` is the median of (this form : reference)
    within each round. `rounds` 0: not timed, a call would take too long or too much memory.
    """

    form: str
    workload: str
    count: int
    rounds: int
    median: float | None = None
    lower: float | None = None
    upper: float | None = None
    ratio: float | None = None

    def as_dict(self) -> dict[str, Any]:
        """Return the record."""
        return asdict(self)


def time_subject(subject: Subject, effort: Effort) -> list[Timing]:
    """Time all forms of a subject on all its workloads."""
    rows: list[Timing] = []
    for name, workload in subject.study.workloads or (default_workload(subject),):
        pace = _probe(subject, workload(PROBE))
        # What is too slow for every size has at least the time of its few points.
        slow = [s for s in subject.specimens if not _is_worth(s, pace, effort, effort.sizes[0])]
        rows += [_summarise(s.name, name, PROBE, {}, [pace[s.name] * PROBE]) for s in slow]
        for count, rounds in zip(effort.sizes, effort.rounds, strict=True):
            arguments = workload(count)
            forms = subject.specimens if _fits(arguments, effort) else ()
            worth = [s.name for s in forms if _is_worth(s, pace, effort, count)]
            rows += _time_size(subject, name, arguments, worth, (count, rounds), pace)
    return rows


def default_workload(subject: Subject) -> tuple[str, Callable[[int], Arguments]]:
    """Repeat the points of the first set that is not ordered, as often as needed."""
    first = next(s for s in list_sets(subject) if not s.ordered)
    drawn = draw_points(first, TUNE)
    many = count_points(subject, drawn)

    def make(count: int) -> Arguments:
        rows = np.arange(count) % many
        return tuple(a[rows] if np.shape(a)[:1] == (many,) else a for a in drawn)

    return f"N points, {first.name}", make


def _is_worth(specimen: Specimen, pace: dict[str, float], effort: Effort, count: int) -> bool:
    """Estimate whether one call is short enough.

    Time goes with the number of points, but for a solver of a whole sweep with its range.
    """
    if specimen.ordered:
        # The call before, on fewer points, may be a first one.
        return pace[specimen.name] * pace[COUNTED] <= 2 * effort.longest
    return pace[specimen.name] * count <= effort.longest


def _probe(subject: Subject, arguments: Arguments) -> dict[str, float]:
    """Estimate seconds per point from one call on a few points."""
    with np.errstate(all="ignore"):
        calls = {s.name: _bind(s.compute, arguments) for s in subject.specimens}
        times = {name: _time_call(call, 1) / PROBE for name, call in calls.items()}
    return {**times, COUNTED: PROBE}


def _fits(arguments: Arguments, effort: Effort) -> bool:
    """Say whether the arguments take no more than two arrays of the largest size."""
    return sum(np.asarray(a).nbytes for a in arguments) <= 2 * 8 * effort.sizes[-1]


def _time_size(
    subject: Subject,
    workload: str,
    arguments: Arguments,
    worth: list[str],
    size: tuple[int, int],
    pace: dict[str, float],
) -> list[Timing]:
    """Time one size (points, rounds); `pace` has the seconds per point of smaller sizes."""
    count, rounds = size
    forms = {s.name: s.compute for s in subject.specimens}
    calls: dict[str, Callable[[], object]] = {f: _bind(forms[f], arguments) for f in worth}
    calls[COPY] = _copy_call(np.shape(subject.kernel(*arguments)))
    times = interleave(calls, rounds)
    pace |= {name: float(np.median(t)) / count for name, t in times.items()} | {COUNTED: count}
    rows = [_summarise(f, workload, count, times, times[f]) for f in calls]
    return rows + [Timing(f, workload, count, 0) for f in forms if f not in calls]


def time_ufuncs() -> dict[str, float]:
    """Return ns per point of the ufuncs that forms are made of: no form is faster than its own."""
    values = np.random.default_rng(SEED).uniform(-50, 50, UFUNC_COUNT)
    target = np.empty_like(values)
    calls: dict[str, Callable[[], object]] = {
        ufunc.__name__: _bind(ufunc, (values,) * ufunc.nin + (target,)) for ufunc in UFUNCS
    }
    times = interleave(calls, UFUNC_ROUNDS)
    return {name: round(float(np.median(t)) / UFUNC_COUNT * 1e9, 3) for name, t in times.items()}


def _bind(compute: Callable[..., Any], arguments: Arguments) -> Callable[[], object]:
    return lambda: compute(*arguments)


def _copy_call(shape: tuple[int, ...]) -> Callable[[], object]:
    source, target = np.ones(shape), np.empty(shape)
    return lambda: np.copyto(target, source)


def interleave(calls: Mapping[str, Callable[[], object]], rounds: int) -> dict[str, list[float]]:
    """Return seconds per call of every form in every round, the order drawn anew each round.

    A form leaves after LONG_ENOUGH seconds and two rounds.
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
    form: str, workload: str, count: int, times: Mapping[str, list[float]], mine: list[float]
) -> Timing:
    lower, median, upper = np.quantile(mine, [0.25, 0.5, 0.75]) / count * 1e9
    ratio = _median_ratio(mine, times[REFERENCE]) if REFERENCE in times else None
    return Timing(
        form, workload, count, len(mine), float(median), float(lower), float(upper), ratio
    )


def _median_ratio(mine: list[float], reference: list[float]) -> float:
    """Return the median of the ratios of the rounds that both were timed in."""
    return float(np.median([a / b for a, b in zip(mine, reference, strict=False)]))
