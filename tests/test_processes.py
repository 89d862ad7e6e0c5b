"""Tasks in processes: results, and tasks that hang, die or raise."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from command import hear_hangups
from weights import first_of

from mechproof.tools import processes
from mechproof.tools.processes import WorkerError, run_batches, run_tasks

STARTS = [s for s in ("fork", "spawn") if s in multiprocessing.get_all_start_methods()]
for_each_start = pytest.mark.parametrize("start", STARTS)
run = partial(run_tasks, limit=60.0, processes=2)


@pytest.fixture(autouse=True)
def no_process_is_left() -> Iterator[None]:
    """Check that every process that a test started has ended; other tests may have their own."""
    before = multiprocessing.active_children()
    yield
    assert {*multiprocessing.active_children()} <= {*before}


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


@pytest.mark.slow
@for_each_start
def test_every_task_is_answered_once(start: str) -> None:
    numbers = list(range(20))
    assert sorted(run(square, numbers, start=start)) == [(n, n * n) for n in numbers]


def test_no_task_needs_no_process() -> None:
    assert list(run(square, [])) == []


@pytest.mark.parametrize("start", first_of(STARTS))
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


def test_a_task_that_hangs_is_named_and_ended_and_holds_nothing_up() -> None:
    begun = time.monotonic()
    tasks = ["hang", "fine", "hang", "fine", "fine"]
    results = dict(run_tasks(misbehave, tasks, limit=0.5, processes=2))
    assert [str(results[n]) for n in (0, 2)] == ["no answer within the time limit"] * 2
    assert [results[n] for n in (1, 3, 4)] == ["fine"] * 3
    assert time.monotonic() - begun < 30


def meet(files: tuple[Path, Path]) -> None:
    """Leave a file and wait for the other's."""
    own, other = files
    own.touch()
    while not other.exists():
        time.sleep(0.01)


def test_tasks_run_at_the_same_time(tmp_path: Path) -> None:
    """If run one after the other, the first would wait for the second until the limit."""
    one, other = tmp_path / "one", tmp_path / "other"
    assert len(list(run(meet, [(one, other), (other, one)]))) == 2


LOADED: list[int] = []


def see(_: int) -> int:
    return len(LOADED)


@pytest.mark.skipif("fork" not in STARTS, reason="no process inherits what is loaded here")
def test_processes_know_what_was_loaded_for_their_batch(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "LOADED", [])

    def load(number: int) -> list[int]:
        LOADED.append(number)
        return [number] * 4

    makers = [partial(load, number) for number in range(3)]
    seen = dict(run_batches(see, makers, limit=60.0, processes=2, start="fork"))
    assert all(seen[number] > number // 4 for number in range(12))


def test_a_batch_is_done_while_the_next_is_made(tmp_path: Path) -> None:
    """The maker of the second batch waits for the file that the first batch's task touches."""
    file = tmp_path / "done"

    def wait() -> list[Path]:
        while not file.exists():
            time.sleep(0.01)
        return [tmp_path / "other"]

    makers = [lambda: [file], wait]
    assert dict(run_batches(Path.touch, makers, limit=60.0, processes=1)) == {0: None, 1: None}


def test_a_process_without_a_task_is_late_with_nothing() -> None:
    """Another process, started later, has taken the waiting task."""
    pool = processes._Pool(square, 0.2, STARTS[0])
    pool.add([3])
    try:
        idle = pool._start()
        idle.deadline = time.monotonic()
        pool.workers.append(pool._start())
        pool.fill(1, 1)
        pool.workers.append(idle)
        assert list(pool.take_ready(60.0)) == [(0, 9)]
        assert not list(pool.take_ready(0.0))
    finally:
        pool.end()


def test_tasks_given_ahead_to_a_process_that_dies_are_done_by_another() -> None:
    makers = [lambda: ["fine", "die", "fine", "hang", "fine"], lambda: ["fine"]]
    results = dict(run_batches(misbehave, makers, limit=0.5, processes=2))
    assert {n for n, result in results.items() if isinstance(result, WorkerError)} == {1, 3}
    assert len(results) == 6


LONG = {
    # Python and, with the interpreter's lock held throughout, C.
    "Python": "while True: pass",
    "C": "pow(7, 10**9)",
}
PARENT = """
import os, sys
from pathlib import Path
from mechproof.tools.processes import run_tasks

def work(folder):
    Path(folder, str(os.getpid())).touch()
    {work}

if __name__ == "__main__":
    list(run_tasks(work, sys.argv[1:] * 2, limit=600.0, processes=2, start={start!r}))
"""


def is_alive(process: int) -> bool:
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
@pytest.mark.parametrize(
    ("start", "work"), [("fork", "Python"), ("fork", "C"), ("spawn", "Python")]
)
@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
def test_no_process_outlives_its_parent(
    tmp_path: Path, start: str, work: str, ending: signal.Signals
) -> None:
    script, folder = tmp_path / "parent.py", tmp_path / "at_work"
    folder.mkdir()
    script.write_text(PARENT.format(start=start, work=LONG[work]))
    command = [sys.executable, str(script), str(folder)]
    parent = subprocess.Popen(command, preexec_fn=hear_hangups)
    wait_until(lambda: len(list(folder.iterdir())) == 2)
    time.sleep(0.2)
    parent.send_signal(ending)
    parent.wait(30)
    workers = [int(path.name) for path in folder.iterdir()]
    wait_until(lambda: not any(map(is_alive, workers)))


def wait_until(holds: Callable[[], bool]) -> None:
    end = time.monotonic() + 60
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.05)
