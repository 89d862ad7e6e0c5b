"""All processes are started here, and none outlives its parent.

Tasks are watched over: one that hangs or dies gives an error, never a result. Tasks that are
trusted to end get an executor, and `executors` spreads them.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import signal
import sys
import threading
import time
from _thread import interrupt_main
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from ctypes import CDLL
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Generic, TypeVar

# A forked process has everything loaded before; outside Linux a fork is not safe.
START = "fork" if sys.platform == "linux" else "spawn"
_SET_PARENT_DEATH_SIGNAL = 1
# Signals that ask a process to end, if the system has them.
ENDING = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
# Number of tasks that a process gets at once while others are still being made.
AHEAD = 128

Task = TypeVar("Task")
Result = TypeVar("Result")


class WorkerError(RuntimeError):
    """A task raised an exception, ran too long, or its process died."""


@dataclass
class _Worker(Generic[Task, Result]):
    """A process and its numbered tasks, in order; it has what the first `knows` batches need."""

    process: BaseProcess
    pipe: Connection
    knows: int
    has: deque[tuple[int, Task]] = field(default_factory=deque)
    deadline: float = float("inf")
    is_lost: bool = False

    def give(self, number: int, task: Task, limit: float) -> None:
        """Send a task; for the first, the time limit starts now."""
        if not self.has:
            self.deadline = time.monotonic() + limit
        self.has.append((number, task))
        # A process that died since its last result is found dead when its answer is taken.
        with suppress(OSError):
            self.pipe.send(task)

    def take(self, limit: float) -> tuple[int, Result | WorkerError]:
        """Return the first task's number and its result, or why there is none."""
        number, _ = self.has.popleft()
        self.deadline = time.monotonic() + limit
        return number, self._receive()

    def _receive(self) -> Result | WorkerError:
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
        """End the process, whatever it is doing."""
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

    `function` must be a module-level function. The result of a task that raises, that takes longer
    than `limit` seconds or whose process dies is a `WorkerError`; other tasks are not held up by
    it. No process is left behind.
    """
    return run_batches(function, [lambda: tasks], limit=limit, processes=processes, start=start)


def run_batches(
    function: Callable[[Task], Result],
    makers: Sequence[Callable[[], Sequence[Task]]],
    *,
    limit: float,
    processes: int | None = None,
    start: str = START,
) -> Iterator[tuple[int, Result | WorkerError]]:
    """Run batches of tasks like `run_tasks`, each while the next is still being made here.

    A batch is done by processes that were started after it had been made, so that a forked one has
    everything that was loaded for it.
    """
    pool = _Pool(function, limit, start)
    count = processes or count_processors()
    try:
        for left in reversed(range(len(makers))):
            pool.add(makers[-1 - left]())
            if left:
                yield from pool.take_ready(0.0)
                # One processor makes the next batch; the others have tasks ahead meanwhile.
                pool.fill(count, AHEAD)
        while pool.fill(count, 1):
            yield from pool.take_ready(None)
    finally:
        pool.end()


@contextmanager
def start_executor(processes: int) -> Iterator[Executor | None]:
    """Start an executor of `processes` processes and end it; None for a single one."""
    if processes == 1:
        yield None
        return
    context = multiprocessing.get_context(START)
    with ProcessPoolExecutor(processes, context, end_with_parent) as executor:
        yield executor


class _Pool(Generic[Task, Result]):
    """The waiting tasks and the processes at work on others."""

    def __init__(self, function: Callable[[Task], Result], limit: float, start: str) -> None:
        self.function, self.limit, self.start = function, limit, start
        self.waiting: deque[tuple[int, Task]] = deque()
        self.workers: list[_Worker[Task, Result]] = []
        # For each batch, the number of the first task after it.
        self.ends: list[int] = []

    def add(self, batch: Sequence[Task]) -> None:
        """Append a batch to the waiting tasks."""
        first = self.ends[-1] if self.ends else 0
        self.waiting.extend(enumerate(batch, start=first))
        self.ends.append(first + len(batch))

    def fill(self, count: int, ahead: int) -> bool:
        """Give each of up to `count` processes `ahead` tasks; return whether any is at work."""
        for worker in [worker for worker in self.workers if not worker.has]:
            if not self._can_go_on(worker):
                self._end(worker)
        while len(self.workers) < min(count, len(self.waiting) + len(self.workers)):
            self.workers.append(self._start())
            self._give(self.workers[-1], ahead)
        for worker in self.workers:
            self._give(worker, ahead)
        return bool(self.workers)

    def _can_go_on(self, worker: _Worker[Task, Result]) -> bool:
        """Return whether the next task is of a batch that existed when the process started."""
        knows = self.ends[worker.knows - 1]
        return bool(self.waiting) and not worker.is_lost and self.waiting[0][0] < knows

    def _give(self, worker: _Worker[Task, Result], ahead: int) -> None:
        while len(worker.has) < ahead and self._can_go_on(worker):
            worker.give(*self.waiting.popleft(), self.limit)

    def take_ready(self, seconds: float | None) -> Iterator[tuple[int, Result | WorkerError]]:
        """Yield the answers available within some seconds; if None, wait for one."""
        for worker in self._wait(seconds):
            yield worker.take(self.limit)
            while worker.has and not worker.is_lost and worker.pipe.poll():
                yield worker.take(self.limit)
            if worker.is_lost:
                self.waiting.extendleft(reversed(worker.has))
                worker.has.clear()

    def _wait(self, seconds: float | None) -> list[_Worker[Task, Result]]:
        """Return the processes that have answered; if none does in time, those that are late."""
        # A process without a task, because another one has it, has nothing to answer.
        busy = [worker for worker in self.workers if worker.has]
        first = min((worker.deadline for worker in busy), default=0.0)
        until_late = max(0.0, first - time.monotonic())
        pipes = [worker.pipe for worker in busy]
        ready = wait(pipes, until_late if seconds is None else min(seconds, until_late))
        if ready:
            return [worker for worker in busy if worker.pipe in ready]
        late = [worker for worker in busy if worker.deadline <= time.monotonic()]
        for worker in late:
            worker.is_lost = True
        return late

    def _start(self) -> _Worker[Task, Result]:
        context = multiprocessing.get_context(self.start)
        ours, theirs = context.Pipe()
        arguments = (self.function, theirs)
        process = context.Process(target=_serve, args=arguments, daemon=True)  # type: ignore[attr-defined]
        process.start()
        theirs.close()
        return _Worker(process, ours, len(self.ends))

    def _end(self, worker: _Worker[Task, Result]) -> None:
        worker.end()
        self.workers.remove(worker)

    def end(self) -> None:
        """End all processes."""
        for worker in self.workers:
            worker.end()


def _serve(function: Callable[[Task], Result], pipe: Connection) -> None:
    """Answer tasks until the parent ends this process, or has itself ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    end_with_parent()
    # Memory shared with the parent stays shared only while the garbage collector leaves it alone.
    gc.freeze()
    while True:
        pipe.send(_answer(function, pipe.recv()))


def end_with_parent() -> None:
    """End this process when its parent is gone, however that ended and whatever is running here.

    A thread waits for the parent. It does not get to run while a library computes for long outside
    Python; in that case Linux ends the process.
    """
    for number in ENDING:
        # Handlers with which the parent tidies up are not for this process.
        if callable(signal.getsignal(number)):
            signal.signal(number, signal.SIG_DFL)
    if sys.platform == "linux":
        CDLL(None).prctl(_SET_PARENT_DEATH_SIGNAL, signal.SIGKILL)
    threading.Thread(target=_wait_for_parent, daemon=True).start()


def _wait_for_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _answer(function: Callable[[Task], Result], task: Task) -> tuple[bool, Result | str]:
    try:
        return True, function(task)
    except BaseException as error:
        return False, f"{type(error).__name__}: {error}"


@contextmanager
def limit_time(seconds: float) -> Iterator[None]:
    """Stop the block after some seconds in the main thread; raises `TimeoutError`.

    A library call that returns late is stopped late.
    """
    main, late = threading.main_thread(), threading.Event()

    def stop() -> None:
        late.set()
        if hasattr(signal, "pthread_kill") and main.ident is not None:
            signal.pthread_kill(main.ident, signal.SIGINT)
        else:
            interrupt_main()

    def interrupt(number: int, frame: object) -> None:
        if late.is_set() or before is not signal.SIG_IGN:
            raise KeyboardInterrupt

    if threading.current_thread() is not main:
        yield
        return
    # Interrupts by the user may be ignored, as in the background; the timer's must not be.
    before = signal.signal(signal.SIGINT, interrupt)
    timer = threading.Timer(seconds, stop)
    timer.start()
    try:
        yield
    except KeyboardInterrupt:
        if not late.is_set():
            raise
        raise TimeoutError(f"no answer within {seconds:g} s") from None
    finally:
        timer.cancel()
        # A process with two threads could not be forked.
        timer.join()
        signal.signal(signal.SIGINT, before)
