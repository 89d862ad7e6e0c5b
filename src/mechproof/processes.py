"""Tasks spread over processes: what hangs or dies there is an error here, never a result."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import time
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

    def __init__(self, number: int, reason: str) -> None:
        super().__init__(f"task {number}: {reason}")
        self.number = number
        self.reason = reason


@dataclass
class _Worker(Generic[Task, Result]):
    process: BaseProcess
    pipe: Connection
    number: int = -1
    deadline: float = float("inf")

    def give(self, number: int, task: Task, limit: float) -> None:
        """Send a task; the time runs from now."""
        self.number, self.deadline = number, time.monotonic() + limit
        # A process that died since its last result is found dead when its answer is taken.
        with suppress(OSError):
            self.pipe.send(task)

    def take(self) -> Result:
        """Receive the result of the task at work."""
        try:
            succeeded, answer = self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            status = self.process.exitcode
            raise WorkerError(self.number, f"its process ended with status {status}") from None
        if not succeeded:
            raise WorkerError(self.number, answer)
        result: Result = answer
        return result


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
) -> Iterator[tuple[int, Result]]:
    """Yield (number of the task, result) as results come.

    `function` is one of a module. Raises `WorkerError` for the first task that raises, that takes
    longer than `limit` seconds or whose process dies; no process is left behind.
    """
    count = min(processes or count_processors(), len(tasks))
    workers: list[_Worker[Task, Result]] = []
    try:
        for _ in range(count):
            workers.append(_start_worker(function, start))
        yield from _distribute(workers, tasks, limit)
    finally:
        for worker in workers:
            worker.process.kill()
            worker.process.join()
            worker.pipe.close()


def _distribute(
    workers: Sequence[_Worker[Task, Result]], tasks: Sequence[Task], limit: float
) -> Iterator[tuple[int, Result]]:
    waiting = iter(enumerate(tasks))
    busy = {}
    for worker, (number, task) in zip(workers, waiting, strict=False):
        worker.give(number, task, limit)
        busy[worker.pipe] = worker
    while busy:
        for pipe in _wait(busy):
            worker = busy.pop(pipe)
            yield worker.number, worker.take()
            if following := next(waiting, None):
                worker.give(*following, limit)
                busy[pipe] = worker


def _wait(busy: dict[Connection, _Worker[Task, Result]]) -> list[Connection]:
    first = min(busy.values(), key=lambda worker: worker.deadline)
    ready = wait(list(busy), max(0.0, first.deadline - time.monotonic()))
    if not ready:
        raise WorkerError(first.number, "no answer within the time limit")
    return [pipe for pipe in busy if pipe in ready]


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
