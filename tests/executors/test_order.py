"""The order of tasks: how many run at once, what is reported, and when times are taken."""

from __future__ import annotations

import itertools
import warnings
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jobs import SIZES, X1, accuracy
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.conformity import Normal, simulate_shares
from mechproof.executors import IN_FLIGHT, run_in_order
from mechproof.lab import measure as measuring
from mechproof.lab.subject import Subject
from mechproof.measured import Record
from mechproof.tolerance import certified_range


class Held(Executor):
    """Run a task only when its result is requested, and count the tasks under way."""

    def __init__(self) -> None:
        self.under_way = self.most = 0

    def submit(self, function: Any, /, *given: Any, **named: Any) -> Future[Any]:
        self.under_way += 1
        self.most = max(self.most, self.under_way)
        future: Future[Any] = Future()

        def result(timeout: float | None = None) -> Any:
            self.under_way -= 1
            return function(*given, **named)

        future.result = result  # type: ignore[method-assign]
        return future


def double(x: int) -> int:
    return 2 * x


@pytest.mark.parametrize("batch", [1, 7])
def test_few_tasks_are_under_way_however_many_there_are(batch: int) -> None:
    taken = itertools.count()
    tasks = (next(taken) for _ in range(1000))
    held = Held()
    results = run_in_order(double, tasks, held, batch=batch)
    assert next(results) == 0
    assert next(taken) <= IN_FLIGHT * batch
    assert [r % 2 for r in results] == [0] * 999
    assert held.most == min(IN_FLIGHT, -(-1000 // batch))


def test_results_come_in_order() -> None:
    with ThreadPoolExecutor(4) as threads:
        assert [*run_in_order(double, range(500), threads, batch=3)] == [*range(0, 1000, 2)]


def test_what_is_left_is_cancelled() -> None:
    cancelled: list[Future[Any]] = []

    class Noting(Held):
        def submit(self, *given: Any, **named: Any) -> Future[Any]:
            future = super().submit(*given, **named)
            future.cancel = lambda: cancelled.append(future)  # type: ignore[method-assign,assign,func-returns-value]
            return future

    results = run_in_order(double, range(5), Noting(), batch=1)
    next(results)
    results.close()  # type: ignore[attr-defined]
    assert len(cancelled) == 4


@pytest.mark.thorough
def test_progress_is_reported() -> None:
    calls: list[tuple[int, int]] = []

    def note(done: int, total: int) -> None:
        calls.append((done, total))

    with ThreadPoolExecutor(2) as threads:
        certified_range("wedge_linkage", "position", X1[:2], SIZES, progress=note, executor=threads)
        assert calls == [(1, 2), (2, 2)]
        calls.clear()
        law, rng = Normal(0, 1), np.random.default_rng(1)
        simulate_shares(
            law, law, (-1, 1), rng=rng, count=25, chunk=10, progress=note, executor=threads
        )
    assert calls == [(10, 25), (20, 25), (25, 25)]


def test_warnings_are_handled_as_they_are_here() -> None:
    with (
        ThreadPoolExecutor(1) as threads,
        warnings.catch_warnings(),
        np.errstate(invalid="ignore"),
    ):
        warnings.simplefilter("error")
        assert np.isnan([*run_in_order(np.sqrt, [np.float64(-1)], threads)])
    with ThreadPoolExecutor(1) as threads, np.errstate(invalid="raise"):
        results = run_in_order(np.sqrt, [np.float64(-1)], threads)
        with pytest.raises(FloatingPointError):
            next(results)


@pytest.mark.slow
def test_times_are_taken_when_nothing_is_under_way(monkeypatch: pytest.MonkeyPatch) -> None:
    held, seen = Held(), []
    monkeypatch.setattr(measuring, "time_subject", lambda *given: seen.append(held.under_way) or ())
    accuracy(held)
    assert held.most > 1
    assert seen == [0]


def test_a_run_of_a_generator_spawns_what_it_needs_and_no_more() -> None:
    rng = np.random.default_rng(3)
    law = Normal(0, 1)
    simulate_shares(law, law, (-1, 1), rng=rng, count=25, chunk=10)
    assert rng.bit_generator.seed_seq.n_children_spawned == 3  # type: ignore[attr-defined]


@pytest.mark.thorough
def test_measure_in_processes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    used: list[Executor | None] = []

    def note(subject: Subject, executor: Executor | None, **named: Any) -> Record:
        used.append(executor)
        raise KeyboardInterrupt

    (tmp_path / "generated").mkdir()
    (tmp_path / "derivations").symlink_to(Path(__file__).parents[2] / "derivations")
    monkeypatch.setattr(measuring, "measure", note)
    arguments = ["measure", "track_wheel.error_sum", "--quick", "--root", str(tmp_path)]
    CliRunner().invoke(app, [*arguments, "--processes", "2"])
    CliRunner().invoke(app, arguments)
    assert [type(executor) for executor in used] == [ProcessPoolExecutor, type(None)]
