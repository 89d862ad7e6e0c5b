"""Errors with executors, and the messages that name them."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
from jobs import JOBS, make_executor

from mechproof.executors import run_in_order, spawn_generators
from mechproof.lab import measure as measuring
from mechproof.lab.subject import find_subjects
from mechproof.tolerance import Size, corner_range
from mechproof.tools.processes import WorkerError


def fail(x: Any, s: Any) -> Any:
    raise ArithmeticError("not today")


def end(x: Any, s: Any) -> Any:
    os._exit(3)


def spread(function: Any, executor: Any) -> Any:
    return corner_range(function, [1.0, 2.0], {"s": Size(2, 1, -1)}, executor=executor)


@pytest.mark.parametrize("kind", ["threads", "processes"])
def test_the_error_of_a_function_is_raised(kind: str) -> None:
    with make_executor(kind) as executor, pytest.raises(ArithmeticError, match="not today"):
        spread(fail, executor)


def test_a_lost_worker_is_reported() -> None:
    with (
        make_executor("processes") as executor,
        pytest.raises(WorkerError, match=r"lost a task .*a worker died"),
    ):
        spread(end, executor)


def test_an_executor_that_was_shut_down_is_reported() -> None:
    executor = ThreadPoolExecutor(1)
    executor.shutdown()
    with pytest.raises(WorkerError, match="shut down"):
        spread(fail, executor)


def test_a_function_that_cannot_be_sent_is_named() -> None:
    with (
        make_executor("processes") as executor,
        pytest.raises(TypeError, match=r"cannot be sent between processes.*lambda.*top level"),
    ):
        spread(lambda x, s: x * s, executor)


def test_a_result_that_cannot_be_sent_is_named() -> None:
    with (
        make_executor("processes") as executor,
        pytest.raises(TypeError, match="cannot be sent between processes"),
    ):
        next(run_in_order(make_lambda, [1], executor))


def make_lambda(task: int) -> Any:
    return lambda: task


@pytest.mark.slow
def test_a_subject_made_by_hand_is_not_taken_for_another() -> None:
    (subject,) = find_subjects(("track_wheel.planar_error",))
    changed = dataclasses.replace(subject, peers=())
    with (
        make_executor("processes") as executor,
        pytest.raises(TypeError, match=r"track_wheel.planar_error\) was not found by find_subj"),
    ):
        measuring.measure(changed, quick=True, executor=executor)


@pytest.mark.parametrize("job", JOBS, ids=lambda job: job.__name__)
def test_what_is_no_executor_is_named(job: Callable[[Any], Any]) -> None:
    with pytest.raises(TypeError, match=r"executor = 2: must be None or a concurrent\.futures"):
        job(2)


def test_a_generator_that_cannot_spawn_is_named() -> None:
    class Seeds(np.random.bit_generator.ISeedSequence):
        def generate_state(self, n_words: int, dtype: Any = np.uint32) -> Any:
            return np.ones(n_words, dtype)

    rng = np.random.Generator(np.random.PCG64(Seeds()))  # type: ignore[abstract]
    with pytest.raises(TypeError, match=r"rng = Generator\(PCG64\).*: must be seeded so that"):
        next(spawn_generators(rng))
