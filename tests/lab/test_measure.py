from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.lab.chart import Dot, draw_charts, find_front
from mechproof.lab.measure import describe_machine, measure, write_record
from mechproof.lab.subject import find_subjects
from mechproof.lab.table import write_tables
from mechproof.lab.timing import Effort, interleave, time_subject

KEYS = {"quantity", "machine", "versions", "seeds", "forms", "accuracy", "times", "worst_found"}


@pytest.fixture(scope="module")
def record() -> Any:
    (subject,) = find_subjects(("planar_error",))
    return measure(subject, quick=True)


def test_record_says_what_was_measured(record: Any) -> None:
    assert set(record) >= KEYS
    assert record["quick"] is True
    kernel = next(r for r in record["accuracy"] if r["form"] == "kernel")
    assert kernel["points"] == 24
    assert kernel["worst_where_the_bar_holds"] <= record["bar"] == 1
    naive = next(r for r in record["accuracy"] if r["form"] == "sqrt(x**2 + y**2)")
    assert naive["worst_ulp"] == math.inf
    assert naive["infinite"] > 0
    assert {row["form"] for row in record["times"]} >= {"kernel", "memory copy"}


def test_record_is_strict_json_and_reads_back(record: Any, tmp_path: Path) -> None:
    file = write_record(record, tmp_path / "measured")
    text = file.read_text(encoding="utf-8")

    def refuse(name: str) -> None:
        raise AssertionError(name)

    again = json.loads(text, parse_constant=refuse)
    assert again["quantity"] == "track_wheel.planar_error"
    assert again["worst_found"] == record["worst_found"]
    assert [p.name for p in file.parent.iterdir()] == [file.name]


def test_no_path_of_this_machine(record: Any) -> None:
    text = json.dumps(record)
    assert str(Path.home()) not in text
    assert str(Path.cwd()) not in text
    assert describe_machine()["processor"]


def test_measure_from_the_command_line(tmp_path: Path) -> None:
    (tmp_path / "generated").mkdir()
    arguments = ["measure", "error_sum", "--quick", "--root", str(tmp_path)]
    done = CliRunner().invoke(app, arguments)
    assert done.exit_code == 0, done.output
    assert (tmp_path / "generated/measured/quick/track_wheel.error_sum.json").is_file()
    assert "0 undecided" in " ".join(done.output.split())


@pytest.mark.parametrize(
    ("arguments", "says"),
    [(["torque"], "torque"), (["ratio", "--root", "nowhere"], "no folder")],
)
def test_bad_usage(arguments: list[str], says: str) -> None:
    done = CliRunner().invoke(app, ["measure", *arguments])
    assert done.exit_code == 2
    assert says in " ".join(done.output.split())


def test_calls_are_interleaved() -> None:
    order: list[str] = []
    calls = {name: (lambda name=name: order.append(name)) for name in "abc"}
    times = interleave(calls, rounds=5)
    assert {name: len(t) for name, t in times.items()} == dict.fromkeys("abc", 5)
    # In blocks of repeats: no form has all of its calls next to one another.
    blocks = [a for a, b in zip(order, [*order[1:], ""], strict=True) if a != b]
    assert len(blocks) > 9


def test_what_is_too_slow_is_listed_untimed() -> None:
    (subject,) = find_subjects(("standard_deviation",))
    rows = time_subject(subject, Effort((1_000, 1_000_000), (1, 1), 1e-4))
    assert {row.rounds for row in rows if row.count == 1_000_000 and row.form == "np.std"} == {0}
    kernel = [row for row in rows if row.form == "kernel" and row.rounds]
    assert kernel
    assert all(row.ratio in (1.0, None) for row in kernel)


def test_the_front_has_what_nothing_beats() -> None:
    dots = [
        Dot(name, "form", time, 0.0, error, 1000)
        for name, time, error in (("a", 1, 9), ("b", 2, 9), ("c", 3, 1), ("d", 4, 2), ("e", 9, 0.5))
    ]
    assert [dot.form for dot in find_front(dots)] == ["a", "c", "e"]


def test_charts_are_drawn_twice_alike(tmp_path: Path) -> None:
    (subject,) = find_subjects(("planar_error",))
    record = measure(subject, quick=True)
    first = draw_charts(subject, record, tmp_path / "a")
    second = draw_charts(subject, record, tmp_path / "b")
    assert {file.suffix for file in first} == {".png", ".svg"}
    for one, two in zip(first, second, strict=True):
        assert one.read_bytes() == two.read_bytes()


def test_maps_and_jumps_are_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    from mechproof.lab import maps

    monkeypatch.setattr(maps, "SIZE", 8)
    (position,) = find_subjects(("elliptic_planetary.position",))
    figure = maps.draw_map(position, position.study.maps[0])
    assert len(figure.axes) == 5  # three forms, the worst of them, the scale
    (other,) = find_subjects(("rotation",))
    assert maps.draw_jumps(other) is None
    figure = maps.draw_jumps(position)
    assert figure is not None
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert "tan/arctan + floor: 29 wrong of 3301; linspace(0, 32 pi, 3301), e = 0.475" in titles
    assert not any(title.startswith(("kernel", "kepler")) for title in titles)


def test_a_kernel_with_out_is_listed_twice() -> None:
    from mechproof.lab.specimen import list_kernel

    (subject,) = find_subjects(("planar_error",))
    given: list[bool] = []

    def kernel(errors: np.ndarray, out: np.ndarray | None = None) -> np.ndarray:
        given.append(out is not None)
        return np.hypot(errors[..., 0], errors[..., 1], out=out)

    found = {s.name: s for s in list_kernel(kernel, subject.quantity, subject.paper)}
    assert list(found) == ["kernel", "kernel, out=", "kernel, float32"]
    points = np.array([[3.0, 4.0, 0.0]])
    first, second = (found["kernel, out="].compute(points) for _ in range(2))
    assert second is first
    assert second.tolist() == [5.0]
    assert given == [False, True, True]


def test_a_quantity_without_rows_is_measured_too() -> None:
    """A new system needs rows only for its specimens: points and workload come by themselves."""
    from dataclasses import replace

    from mechproof.lab.subject import Study

    (subject,) = find_subjects(("displacement",))
    bare = replace(subject, study=Study())
    names = [s.name for s in bare.specimens]
    assert names == [
        "kernel",
        "kernel, out=",
        "kernel, float32",
        "sympy.lambdify",
        "sympy.lambdify, cse",
    ]
    record = measure(bare, quick=True)
    assert {row["set"] for row in record["accuracy"]} == {"domain"}
    assert record["boxes"] == []
    assert any(row["form"] == "kernel" and row["count"] == 1000 for row in record["times"])


def test_the_tables_show_every_form_and_what_was_lost(record: Any, tmp_path: Path) -> None:
    write_record(record, tmp_path)
    page = write_tables(tmp_path).read_text(encoding="utf-8")
    accuracy, _ = page.split("\nN vectors\n")
    rows = {line.split("|")[1].strip(): line for line in accuracy.splitlines() if line[:2] == "| "}
    assert {form["name"] for form in record["forms"]} <= rows.keys()
    assert f"eps of {record['scale']}" not in rows["kernel"]
    assert record["scale"] in page
    # What overflows is counted, and the set where it first did is named.
    naive = [cell.strip() for cell in rows["sqrt(x**2 + y**2)"].split("|")]
    lost = sum(r["infinite"] for r in record["accuracy"] if r["form"] == "sqrt(x**2 + y**2)")
    assert str(lost) in naive
    assert lost > 0
    assert naive[-2] == "vectors"


def test_a_form_that_was_not_timed_says_so(record: Any, tmp_path: Path) -> None:
    untimed = [{**row, "rounds": 0, "median": None, "ratio": None} for row in record["times"]]
    write_record({**record, "times": untimed}, tmp_path)
    assert "not timed" in write_tables(tmp_path).read_text(encoding="utf-8")
