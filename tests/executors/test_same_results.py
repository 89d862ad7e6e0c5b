"""Threads, processes and a cluster give the same results to the last bit."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from distributed import Client, LocalCluster
from jobs import JOBS, make_executor
from weights import make_thorough

from mechproof.tolerance import Size, corner_range

# For one pytest worker, which holds the only cluster.
pytestmark = pytest.mark.xdist_group("cluster")
KINDS = ("threads", "one process", "processes", "cluster")
# Every job in processes, the first in every kind of executor; all others are thorough tests.
CASES = [
    case if kind == "processes" or job is JOBS[0] else make_thorough(case)
    for kind in KINDS
    for job in JOBS
    for case in (pytest.param(kind, job, id=f"{kind}-{job.__name__}"),)
]


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with (
        LocalCluster(2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def executor(request: pytest.FixtureRequest) -> Iterator[Executor]:
    if request.param == "cluster":
        yield request.getfixturevalue("client").get_executor()
        return
    with make_executor(request.param) as executor:
        yield executor


SERIAL: dict[str, Any] = {}


def to_bytes(result: Any) -> Any:
    if dataclasses.is_dataclass(result):
        return [to_bytes(getattr(result, f.name)) for f in dataclasses.fields(result)]
    if isinstance(result, list | tuple):
        return [to_bytes(item) for item in result]
    return result.tobytes() if isinstance(result, np.ndarray | np.generic) else repr(result)


@pytest.mark.slow
@pytest.mark.parametrize(("executor", "job"), CASES, indirect=["executor"])
def test_results_are_the_same_to_the_last_bit(
    executor: Executor, job: Callable[[Executor | None], Any]
) -> None:
    if job.__name__ not in SERIAL:
        SERIAL[job.__name__] = to_bytes(job(None))
    assert to_bytes(job(executor)) == SERIAL[job.__name__]


def test_the_comparison_sees_one_bit() -> None:
    assert to_bytes([np.array([1.0])]) != to_bytes([np.array([np.nextafter(1.0, 2.0)])])


@pytest.mark.slow
def test_what_only_a_cluster_can_send_is_sent(client: Client) -> None:
    result = corner_range(
        lambda x, s: x * s, [1.0], {"s": Size(2, 1, -1)}, executor=client.get_executor()
    )
    assert (result.lower, result.upper) == (1, 3)


@pytest.mark.slow
def test_a_cluster_recovers_from_a_lost_worker(client: Client, tmp_path: Path) -> None:
    mark = tmp_path / "died once"

    def die_once(x: Any, s: Any) -> Any:
        if not mark.exists():
            mark.touch()
            os._exit(1)
        return x * s

    given: Any = [1.0], {"s": Size(2, 1, -1)}
    result = corner_range(die_once, *given, executor=client.get_executor(retries=2))
    assert mark.exists()
    assert (result.lower, result.upper) == (1, 3)
