"""The same results to the last bit from threads, processes and a cluster, and what goes wrong."""

from __future__ import annotations

import dataclasses
import itertools
import multiprocessing
import os
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from distributed import Client, LocalCluster
from typer.testing import CliRunner

from mechproof import ThicknessInspection, WedgeLinkage
from mechproof.cli import app
from mechproof.conformity import Normal, Uniform, simulate_shares
from mechproof.executors import IN_FLIGHT, run_in_order, spawn_generators
from mechproof.kernels import wedge_linkage
from mechproof.lab import measure as measuring
from mechproof.lab.subject import Subject, find_subjects
from mechproof.measured import Record
from mechproof.processes import START, WorkerError
from mechproof.record import Argument, Form, Paper, Quantity, Variable
from mechproof.tolerance import Size, certified_range, corner_range, monte_carlo_range
from mechproof.tolerance.scatter import DRAWN

# One worker of pytest: it has the one cluster.
pytestmark = pytest.mark.xdist_group("cluster")

SIZES = WedgeLinkage.published_sizes(1)
WHEEL = {"R": Size(41.5, 0.1, -0.1), "A": Size(3.75, 0.2, -0.1), "z": Size(6)}
x, a, b = sp.symbols("x a b", real=True)
ARGUMENTS = tuple(Argument(str(s), (s,), str(s)) for s in (x, a, b))
VALUE = x * b + sp.Max(0, a - a**2 / 2)
OWN = Paper(
    "own",
    "",
    tuple(Variable(s, str(s)) for s in (x, a, b)),
    (),
    quantities=(Quantity("f", "Compute f.", ARGUMENTS, VALUE, (Form("f", VALUE),), "here"),),
)
BOX = {"a": Size(0.0, 1.5, -1.0), "b": Size(2.0, 0.5, -0.5)}
X1 = np.array([-40.0, -37.1, np.nan, -20.0, -1.0, 0.0])
KINDS = ("threads", "one process", "processes", "cluster")


def make_executor(kind: str) -> Executor:
    if kind == "threads":
        return ThreadPoolExecutor(3)
    context = multiprocessing.get_context(START)
    return ProcessPoolExecutor(1 if kind == "one process" else 2, context)


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with (
        LocalCluster(2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module", params=KINDS)
def executor(request: pytest.FixtureRequest) -> Iterator[Executor]:
    if request.param == "cluster":
        yield request.getfixturevalue("client").get_executor()
        return
    with make_executor(request.param) as executor:
        yield executor


def corners(executor: Executor | None) -> Any:
    return corner_range(wedge_linkage.position, X1, SIZES, chunk=64, executor=executor)


def boundaries(executor: Executor | None) -> Any:
    deviations = {"l_BC": (1.0, -1.0), "alpha_KL": (0.02, -0.01)}
    return WedgeLinkage.published(1).tolerance_range(X1, deviations, executor=executor)


def scatter(executor: Executor | None) -> Any:
    return monte_carlo_range(
        wedge_linkage.position,
        X1,
        SIZES,
        laws=Size.uniform,
        rng=np.random.default_rng(7),
        count=2 * DRAWN + 1,
        executor=executor,
    )


def bounds(executor: Executor | None) -> Any:
    angles = np.append(np.linspace(0, 6, 9), np.nan)
    return certified_range("track_wheel", "radius", angles, WHEEL, executor=executor)


def own(executor: Executor | None) -> Any:
    return certified_range(OWN, "f", [0.0, 1.0], BOX, executor=executor)


def shares(executor: Executor | None) -> Any:
    gauge = Normal.from_width(0, 0.004, 4)
    inspection = ThicknessInspection.published(
        true=Normal.from_width(-0.0345, 0.045, 6),
        tip_diameter=Uniform(-0.03, 0.03),
        height=gauge,
        thickness=gauge,
    )
    rng = np.random.default_rng(8)
    return inspection.simulate(rng=rng, count=100_001, chunk=10_000, executor=executor)


def accuracy(executor: Executor | None) -> Any:
    (subject,) = find_subjects(("track_wheel.planar_error",))
    record = measuring.measure(subject, quick=True, executor=executor)
    return record.sets, record.cells, record.cell_errors, record.ranges, record.searched


JOBS = (corners, boundaries, scatter, bounds, own, shares, accuracy)
SERIAL: dict[str, Any] = {}


def to_bytes(result: Any) -> Any:
    if dataclasses.is_dataclass(result):
        return [to_bytes(getattr(result, f.name)) for f in dataclasses.fields(result)]
    if isinstance(result, list | tuple):
        return [to_bytes(item) for item in result]
    return result.tobytes() if isinstance(result, np.ndarray | np.generic) else repr(result)


@pytest.fixture(autouse=True)
def _untimed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measuring, "time_subject", lambda *given: ())
    monkeypatch.setattr(measuring, "time_ufuncs", dict)


@pytest.mark.parametrize("job", JOBS, ids=lambda job: job.__name__)
def test_results_are_the_same_to_the_last_bit(
    executor: Executor, job: Callable[[Executor | None], Any]
) -> None:
    if job.__name__ not in SERIAL:
        SERIAL[job.__name__] = to_bytes(job(None))
    assert to_bytes(job(executor)) == SERIAL[job.__name__]


def test_the_comparison_sees_one_bit() -> None:
    assert to_bytes([np.array([1.0])]) != to_bytes([np.array([np.nextafter(1.0, 2.0)])])


def test_what_only_a_cluster_can_send_is_sent(client: Client) -> None:
    result = corner_range(
        lambda x, s: x * s, [1.0], {"s": Size(2, 1, -1)}, executor=client.get_executor()
    )
    assert (result.lower, result.upper) == (1, 3)


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


# Order and memory


class Held(Executor):
    """Does a task when its result is asked for, and counts those under way."""

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


# Errors


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
        pytest.raises(TypeError, match=r"cannot be sent to another process.*lambda.*top level"),
    ):
        spread(lambda x, s: x * s, executor)


def test_a_result_that_cannot_be_sent_is_named() -> None:
    with (
        make_executor("processes") as executor,
        pytest.raises(TypeError, match="cannot be sent to another process and back"),
    ):
        next(run_in_order(make_lambda, [1], executor))


def make_lambda(task: int) -> Any:
    return lambda: task


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


# The command line


@pytest.mark.thorough
def test_measure_in_processes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    used: list[Executor | None] = []

    def note(subject: Subject, executor: Executor | None, **named: Any) -> Record:
        used.append(executor)
        raise KeyboardInterrupt

    (tmp_path / "generated").mkdir()
    (tmp_path / "derivations").symlink_to(Path(__file__).parents[1] / "derivations")
    monkeypatch.setattr(measuring, "measure", note)
    arguments = ["measure", "track_wheel.error_sum", "--quick", "--root", str(tmp_path)]
    CliRunner().invoke(app, [*arguments, "--processes", "2"])
    CliRunner().invoke(app, arguments)
    assert [type(executor) for executor in used] == [ProcessPoolExecutor, type(None)]
