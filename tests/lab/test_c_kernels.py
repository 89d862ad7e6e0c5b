"""Kernels in C, also on a GPU, as ways to compute: they have numba's bits, and may be missing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from quantities import find_subject

from mechproof.choice import choose
from mechproof.lab import c_kernels
from mechproof.lab.c_kernels import COMPILER, KernelInC, find_in_c, find_on_gpu
from mechproof.lab.chart import draw_chart
from mechproof.lab.chart_points import list_workloads
from mechproof.lab.record_tables import list_lines
from mechproof.lab.subject import find_subjects
from mechproof.measured import IN_C, ON_GPU, find_files, read_record, write_record
from mechproof.record import Paper

needs_compiler = pytest.mark.skipif(
    c_kernels.shutil.which(COMPILER) is None, reason="there is no C compiler"
)
FINDERS = (
    pytest.param(find_in_c, marks=needs_compiler),
    pytest.param(
        find_on_gpu, marks=pytest.mark.skipif(not c_kernels.find_gpu(), reason="there is no GPU")
    ),
)
RNG = np.random.default_rng(7)
POSES = RNG.uniform(-1, 1, (5, 3))
# Every kind of argument: one mechanism and many, rows and columns of points, no points.
CALLS: tuple[tuple[str, tuple[Any, ...]], ...] = (
    ("elliptic_planetary.position", (np.linspace(-9, 9, 7), 66, 16, 0.475)),
    ("elliptic_planetary.position", (np.linspace(-9, 9, 7)[:, None], 66, 16, [0.0, 0.3, 1.0])),
    ("elliptic_planetary.position", (1.0, 66, 16, [0.475])),
    ("elliptic_planetary.position", (1.0, 66, 16, 0.475)),
    ("elliptic_planetary.position", (np.ones(0), 66, 16, 0.475)),
    ("track_wheel.displacement", (POSES.T[::-1].T, POSES[0], POSES[1])),
    ("track_wheel.displacement", (POSES[0], POSES, POSES[1])),
    ("track_wheel.rotation", tuple(POSES.T)),
    ("track_wheel.error_sum", (abs(POSES), [1.0, 2.0, 3.0], 1.5, 1.1)),
    ("track_wheel.error_sum_correlated", (abs(POSES), abs(POSES), 1.5, np.eye(3), [[1.1]] * 5)),
)


@pytest.mark.slow
@pytest.mark.parametrize("find", FINDERS)
@pytest.mark.parametrize(("name", "arguments"), CALLS)
def test_it_computes_the_bits_of_the_compiled_kernel(
    name: str, arguments: tuple[Any, ...], find: Callable[[str, Paper], KernelInC | None]
) -> None:
    subject = find_subject(name)
    kernel = find(subject.quantity.name, subject.paper)
    assert kernel is not None
    found = kernel(*arguments)
    wanted = np.asarray(getattr(subject.load_compiled(), subject.quantity.name)(*arguments))
    assert found.shape == wanted.shape
    assert np.array_equal(found, wanted, equal_nan=True)


@pytest.mark.slow
@needs_compiler
def test_it_is_one_of_the_ways_and_not_chosen_for_python(tmp_path: Path) -> None:
    (way,) = (way for way in find_subject("track_wheel.radius").ways if way.name == IN_C)
    assert (way.kind, way.rows) == ("source", ())
    record = read_record(find_files()["track_wheel.radius"])
    (fast,) = (way for way in record.ways if way.name == "kernel, compiled")
    others = tuple(way for way in record.ways if way.kind != "source")
    known = replace(fast, name=IN_C, kind="source", verdict="MEASURED", rung="", needs="")
    errors = [replace(e, way=IN_C) for e in record.cell_errors if e.way == fast.name]
    times = [replace(t, way=IN_C, median=0.1) for t in record.times if t.way == fast.name]
    record = replace(
        record,
        ways=(*others, known),
        cell_errors=(*(e for e in record.cell_errors if e.way != IN_C), *errors),
        times=(*(t for t in record.times if t.way != IN_C), *times),
    )
    write_record(record, tmp_path)
    assert not record.lacking
    chosen = choose("track_wheel.radius", error=1e-9, phi=(0, 6), measured=tmp_path)
    assert IN_C not in {chosen.way, *(other.way for other in chosen.others)}
    lacking = replace(record, ways=others)
    assert lacking.lacking == f"Not measured: {IN_C}."
    for one in (record, lacking):
        told = [
            "\n".join(list_lines([one])),
            draw_chart(one, *list_workloads(one)[0]).axes[-1].get_xlabel(),
        ]
        assert {"Not measured" in text for text in told} == {bool(one.lacking)}


def test_without_what_it_needs_there_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(c_kernels.shutil, "which", lambda name: None)
    (subject,) = find_subjects(("track_wheel.largest_radius",))
    assert find_in_c("largest_radius", subject.paper) is None
    assert find_on_gpu("largest_radius", subject.paper) is None
    assert {IN_C, ON_GPU}.isdisjoint(way.name for way in replace(subject).ways)


@needs_compiler
def test_c_has_no_kernel_where_there_is_none() -> None:
    assert find_in_c("rightly_accepted", find_subject("conformity.rightly_accepted").paper) is None
