"""Work in chunks, spread over the executor of `concurrent.futures` that a caller brings.

The chunks are the same whoever does them, and their results come in order: nothing depends on the
executor or on the number of its workers. Chunks that draw random numbers have generators of their
own, spawned from the caller's. A bounded number of chunks is under way at a time. No process is
started here: that, and watching over tasks that may hang or die, is the task of `processes`.
"""

from __future__ import annotations

import pickle
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from itertools import islice
from multiprocessing.reduction import ForkingPickler
from threading import Lock
from typing import Any, NamedTuple, TypeVar

import numpy as np

from mechproof.arguments.array_checks import check_generator
from mechproof.arguments.scalars import refuse, require

Task = TypeVar("Task")
Result = TypeVar("Result")

# The precision of balls is global to a process: threads that compute with balls take turns.
BALLS = Lock()
# Tasks sent to a worker at once, as sending one costs as much as doing a small one.
BATCH = 16
# Batches running or waiting: enough for about ten workers, and few enough for the memory.
IN_FLIGHT = 32


class _Failure(NamedTuple):
    """An exception raised by a task; all other exceptions are the executor's own."""

    error: Exception


def check_executor(executor: Any) -> None:
    """Raise TypeError unless the argument is None or an executor."""
    fits = executor is None or isinstance(executor, Executor)
    allowed = "must be None or a concurrent.futures.Executor"
    require(fits, "executor", executor, allowed, TypeError)


def slices(total: int, step: int) -> Iterator[slice]:
    """Cut range(total) into slices of at most `step`."""
    return (slice(start, min(start + step, total)) for start in range(0, total, step))


def spawn_generators(rng: Any) -> Iterator[np.random.Generator]:
    """Yield independent generators, spawned one by one; TypeError if `rng` cannot spawn."""
    check_generator("rng", rng)
    while True:
        try:
            (child,) = rng.spawn(1)
        except TypeError:
            refuse(
                "rng", rng, "must be seeded so that it can be spawned, as by default_rng", TypeError
            )
        yield child


def run_in_order(
    function: Callable[[Task], Result],
    tasks: Iterable[Task],
    executor: Executor | None = None,
    *,
    batch: int = BATCH,
) -> Iterator[Result]:
    """Yield function(task) for every task, in order; without an executor, in this thread.

    NumPy's error handling is the caller's. Tasks are drawn as they are sent: at most IN_FLIGHT
    times `batch` of them, or their results, are held. Raises what a task raises; TypeError if
    function, task or result cannot be sent to another process and back; `WorkerError` if the
    executor has lost a worker and the task.
    """
    if executor is None:
        yield from map(function, tasks)
        return
    waiting: deque[Future[list[Result] | _Failure]] = deque()
    source = iter(tasks)
    batches = iter(lambda: list(islice(source, batch)), [])
    try:
        for chosen in batches:
            waiting.append(_submit(executor, function, chosen))
            if len(waiting) == IN_FLIGHT:
                yield from _take(waiting.popleft())
        while waiting:
            yield from _take(waiting.popleft())
    finally:
        for future in waiting:
            future.cancel()


def _submit(
    executor: Executor, function: Callable[[Task], Result], tasks: list[Task]
) -> Future[list[Result] | _Failure]:
    try:
        if isinstance(executor, ProcessPoolExecutor):
            # Checks at once that the task can be sent: in Python 3.11.2 a pool whose last tasks
            # are cancelled may never end.
            ForkingPickler.dumps((function, tasks))
        return executor.submit(_run, function, tasks, np.geterr())
    except Exception as error:
        raise _explain(error) from error


def _take(future: Future[list[Result] | _Failure]) -> list[Result]:
    try:
        answer = future.result()
    except Exception as error:
        raise _explain(error) from error
    if isinstance(answer, _Failure):
        raise answer.error
    return answer


def _run(
    function: Callable[[Task], Result], tasks: list[Task], errors: Any
) -> list[Result] | _Failure:
    try:
        with np.errstate(**errors):
            return [function(task) for task in tasks]
    except Exception as error:
        return _Failure(error)


def _explain(error: Exception) -> Exception:
    """Return the error to raise for an exception of the executor itself."""
    from mechproof.tools.processes import WorkerError

    if isinstance(error, pickle.PicklingError | AttributeError | TypeError):
        return TypeError(
            f"the task or its result cannot be sent between processes ({error}): define "
            "functions and classes at the top level of a module, or use threads"
        )
    return WorkerError(
        f"the executor lost a task ({type(error).__name__}: {error}): a worker died, cannot load "
        "its task, or the executor was shut down"
    )
