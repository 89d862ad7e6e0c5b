"""Tasks spread over processes: what hangs or dies there is an error here, never a result."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Generic, TypeVar

# What is loaded before a fork need not be loaded again; elsewhere a fork is not safe.
START = "fork" if sys.platform == "linux" else "spawn"
_ORPHAN_CHECK = 1.0

Task = TypeVar("Task")
Result = TypeVar("Result")


class WorkerError(RuntimeError):
    """A task raised, ran too long, or its process died."""


@dataclass
class _Worker(Generic[Task, Result]):
    process: BaseProcess
    pipe: Connection
    number: int = -1
    deadline: float = float("inf")
    is_lost: bool = False

    def give(self, number: int, task: Task, limit: float) -> None:
        """Send a task; the time runs from now."""
        self.number, self.deadline = number, time.monotonic() + limit
        # A process that died since its last result is found dead when its answer is taken.
        with suppress(OSError):
            self.pipe.send(task)

    def take(self) -> Result | WorkerError:
        """Receive the result of the task at work, or why there is none."""
        if self.is_lost:
            return WorkerError("no answer within the time limit")
        try:
            succeeded, answer = self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            self.is_lost = True
            return WorkerError(f"its process ended with status {self.process.exitcode}")
        if not succeeded:
            return WorkerError(answer)
        result: Result = answer
        return result

    def end(self) -> None:
        """End the process, whatever it does."""
        self.process.kill()
        self.process.join()
        self.pipe.close()


def count_processors() -> int:
    """Return how many processors this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:
        return os.cpu_count() or 1


def run_tasks(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    *,
    limit: float,
    processes: int | None = None,
    start: str = START,
) -> Iterator[tuple[int, Result | WorkerError]]:
    """Yield (number of the task, result) as results come.

    `function` is one of a module. The result of a task that raises, that takes longer than
    `limit` seconds or whose process dies is a `WorkerError`; the others are not held up by it.
    No process is left behind.
    """
    count = min(processes or count_processors(), len(tasks))
    waiting = deque(enumerate(tasks))
    busy: dict[Connection, _Worker[Task, Result]] = {}
    try:
        for _ in range(count):
            _give_next(_start_worker(function, start), waiting, limit, busy)
        while busy:
            for worker in _wait(busy):
                yield worker.number, worker.take()
                del busy[worker.pipe]
                if worker.is_lost and waiting:
                    worker.end()
                    worker = _start_worker(function, start)
                _give_next(worker, waiting, limit, busy)
    finally:
        for worker in busy.values():
            worker.end()


def _give_next(
    worker: _Worker[Task, Result],
    waiting: deque[tuple[int, Task]],
    limit: float,
    busy: dict[Connection, _Worker[Task, Result]],
) -> None:
    """Give a worker the next task, or end it if there is none."""
    if not waiting:
        worker.end()
        return
    worker.give(*waiting.popleft(), limit)
    busy[worker.pipe] = worker


def _wait(busy: dict[Connection, _Worker[Task, Result]]) -> list[_Worker[Task, Result]]:
    """Return the workers that have answered; if none does in time, those that are late."""
    first = min(worker.deadline for worker in busy.values())
    ready = wait(list(busy), max(0.0, first - time.monotonic()))
    if ready:
        return [worker for pipe, worker in busy.items() if pipe in ready]
    late = [worker for worker in busy.values() if worker.deadline <= time.monotonic()]
    for worker in late:
        worker.is_lost = True
    return late


def _start_worker(function: Callable[[Task], Result], start: str) -> _Worker[Task, Result]:
    context = multiprocessing.get_context(start)
    ours, theirs = context.Pipe()
    process = context.Process(target=_serve, args=(function, theirs, os.getpid()), daemon=True)  # type: ignore[attr-defined]
    process.start()
    theirs.close()
    return _Worker(process, ours)


def _serve(function: Callable[[Task], Result], pipe: Connection, parent: int) -> None:
    """Answer tasks until the parent is gone (of its ends of the pipes, siblings hold copies)."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    while True:
        while not pipe.poll(_ORPHAN_CHECK):
            if os.getppid() != parent:
                return
        pipe.send(_answer(function, pipe.recv()))


def _answer(function: Callable[[Task], Result], task: Task) -> tuple[bool, Result | str]:
    try:
        return True, function(task)
    except BaseException as error:
        return False, f"{type(error).__name__}: {error}"
