"""Tasks in processes: results, and what hangs, dies or raises."""

from __future__ import annotations

import multiprocessing
import os
import time
from functools import partial
from pathlib import Path

import pytest

from mechproof.processes import WorkerError, run_tasks

STARTS = [s for s in ("fork", "spawn") if s in multiprocessing.get_all_start_methods()]
for_each_start = pytest.mark.parametrize("start", STARTS)
run = partial(run_tasks, limit=60.0, processes=2)


def square(number: int) -> int:
    return number * number


def misbehave(task: str) -> str:
    if task == "hang":
        time.sleep(600)
    if task == "die":
        os._exit(7)
    if task == "raise":
        raise ValueError("a reason")
    return task


@for_each_start
def test_every_task_is_answered_once(start: str) -> None:
    numbers = list(range(20))
    assert sorted(run(square, numbers, start=start)) == [(n, n * n) for n in numbers]


def test_no_task_needs_no_process() -> None:
    assert list(run(square, [])) == []


@for_each_start
@pytest.mark.parametrize(
    ("task", "reason"),
    [("die", "its process ended with status 7"), ("raise", "ValueError: a reason")],
)
def test_a_task_that_fails_is_named_and_holds_nothing_up(
    task: str, reason: str, start: str
) -> None:
    results = dict(run(misbehave, ["fine", task, "fine", "fine", "fine"], start=start))
    failure = results.pop(1)
    assert isinstance(failure, WorkerError)
    assert reason in str(failure)
    assert results == dict.fromkeys((0, 2, 3, 4), "fine")
    assert multiprocessing.active_children() == []


def test_a_task_that_hangs_is_named_and_ended_and_holds_nothing_up() -> None:
    begun = time.monotonic()
    tasks = ["hang", "fine", "hang", "fine", "fine"]
    results = dict(run_tasks(misbehave, tasks, limit=0.5, processes=2))
    assert [str(results[n]) for n in (0, 2)] == ["no answer within the time limit"] * 2
    assert [results[n] for n in (1, 3, 4)] == ["fine"] * 3
    assert time.monotonic() - begun < 30
    assert multiprocessing.active_children() == []


def meet(files: tuple[Path, Path]) -> None:
    """Leave a file and wait for the other's."""
    own, other = files
    own.touch()
    while not other.exists():
        time.sleep(0.01)


def test_tasks_run_at_the_same_time(tmp_path: Path) -> None:
    """One after the other, the first would wait for the second until the limit."""
    one, other = tmp_path / "one", tmp_path / "other"
    assert len(list(run(meet, [(one, other), (other, one)]))) == 2
