from __future__ import annotations

import math
import shutil
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from shutil import which
from types import ModuleType

import numpy as np
import pytest
import sympy as sp
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.lab.accuracy import keep_worst
from mechproof.lab.c_kernels import COMPILER
from mechproof.lab.chart import draw_charts, draw_jumps
from mechproof.lab.measure import describe_machine, describe_ways, measure
from mechproof.lab.record_tables import PAGE, headline, list_claims, list_lines
from mechproof.lab.subject import Subject, find_subjects
from mechproof.lab.timing import Effort, interleave, time_subject
from mechproof.lab.ways import list_ways
from mechproof.lab.worst_search import scaled_errors
from mechproof.measured import (
    COPY,
    IN_C,
    Record,
    find_known,
    read_record,
    read_records,
    write_record,
)
from mechproof.record import Argument, Form, Paper, Quantity, Variable
from mechproof.roundoff.certificate import describe_bound


@pytest.fixture(scope="module")
def record() -> Record:
    (subject,) = find_subjects(("track_wheel.planar_error",))
    return measure(subject, quick=True)


@pytest.mark.slow
def test_record_says_what_was_measured(record: Record) -> None:
    assert record.quick is True
    kernel, naive = (record.errors_of(name) for name in ("kernel", "printed (17)"))
    assert {errors.set for errors in kernel} == {"generic", "tiny"}
    assert all(errors.points <= 24 and errors.worst_at is not None for errors in kernel)
    assert record.worst_of("kernel") <= record.bound == 1
    assert max(errors.worst_ulp for errors in naive) == math.inf
    assert sum(errors.infinite for errors in naive) > 0
    assert {row.way for row in record.times} >= {"kernel", COPY}
    in_c = {row.way for row in record.times if row.way == IN_C}
    assert in_c == {errors.way for errors in record.errors_of(IN_C)}
    assert bool(record.lacking) == (which(COMPILER) is None) == (not in_c)


def test_a_peer_is_measured_and_nothing_is_proved_of_it(record: Record) -> None:
    ways = {way.name: way for way in record.ways}
    assert (ways["kernel"].kind, ways["kernel"].verdict) == ("kernel", "PROVED")
    assert (ways["printed (17)"].kind, ways["sympy.lambdify"].kind) == ("form", "peer")
    assert {way.verdict for way in record.ways if way.kind == "peer"} == {"MEASURED"}


@pytest.mark.parametrize(
    "quantity", ["conformity.wrongly_accepted", "measurement.standard_deviation"]
)
def test_nothing_is_proved_of_hand_written_code(quantity: str) -> None:
    (subject,) = find_subjects((quantity,))
    assert {(way.kind, way.verdict) for way in describe_ways(subject)} == {("peer", "MEASURED")}


def test_record_reads_back(record: Record, tmp_path: Path) -> None:
    file = write_record(record, tmp_path / "measured")
    assert read_record(file) == record
    assert [p.name for p in file.parent.iterdir()] == ["track_wheel.planar_error.json"]


def test_no_path_of_this_machine(record: Record) -> None:
    assert str(Path.home()) not in repr(record)
    assert str(Path.cwd()) not in repr(record)
    assert describe_machine().processor


@pytest.mark.thorough
def test_measure_from_the_command_line(tmp_path: Path) -> None:
    (tmp_path / "generated").mkdir()
    # Kernels are taken from next to the derivations, records go below the root.
    (tmp_path / "derivations").symlink_to(Path(__file__).parents[2] / "derivations")
    arguments = ["measure", "track_wheel.error_sum", "--quick", "--root", str(tmp_path)]
    done = CliRunner().invoke(app, arguments)
    assert done.exit_code == 0, done.output
    assert (tmp_path / "generated/measured/quick/track_wheel.error_sum.json").is_file()
    assert "0 undecided" in " ".join(done.output.split())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["track_wheel.torque"], "torque"),
        (["track_wheel.radius", "--root", "nowhere"], "no folder"),
    ],
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
    # Calls come in blocks of repeats: no form has all of its calls in a row.
    blocks = [a for a, b in zip(order, [*order[1:], ""], strict=True) if a != b]
    assert len(blocks) > 9


def test_what_is_too_slow_is_not_timed() -> None:
    (subject,) = find_subjects(("measurement.standard_deviation",))
    rows = time_subject(subject, Effort((1_000, 1_000_000), (1, 1), 1e-4))
    assert not [row for row in rows if row.count == 1_000_000 and row.way == "np.std"]
    kernel = [row for row in rows if row.way == "evaluate_type_a"]
    assert kernel
    assert all(row.ratio in (1.0, None) for row in kernel)


def test_a_broken_record_is_named(tmp_path: Path) -> None:
    (tmp_path / "gear.angle.json").write_text("{}", encoding="utf-8")
    done = CliRunner().invoke(app, ["chart", "--measured", str(tmp_path)])
    assert done.exit_code == 2
    assert "gear.angle.json: missing in a Record: bound, cell_errors" in done.output


@pytest.mark.slow
def test_jumps_are_drawn_of_what_jumps() -> None:
    (still,) = find_subjects(("track_wheel.rotation",))
    assert draw_jumps(still) is None
    (position,) = find_subjects(("elliptic_planetary.position",))
    figure = draw_jumps(position)
    assert figure is not None
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    # The number of 66 at which quotient and tangent disagree depends on the tangent's last bit.
    assert any(title.startswith("tan/arctan + floor: ") for title in titles)
    assert "tan/arctan: 3275 wrong of 3301; sweep, 3301 samples" in titles
    assert not any(title.startswith(("kernel", "x + 2 atan2")) for title in titles)


def test_a_kernel_with_out_is_listed_twice() -> None:
    (subject,) = find_subjects(("track_wheel.planar_error",))
    given: list[bool] = []

    def planar_error(errors: np.ndarray, out: np.ndarray | None = None) -> np.ndarray:
        given.append(out is not None)
        return np.hypot(errors[..., 0], errors[..., 1], out=out)

    module = ModuleType("kernels")
    module.planar_error = planar_error  # type: ignore[attr-defined]
    listed = list_ways(subject.quantity, subject.domain, (), (module, None, module), ())
    found = {way.name: way for way in listed}
    assert list(found)[:5] == [
        *("kernel", "kernel, out=", "kernel, float32"),
        *("kernel, compiled", "kernel, compiled, out="),
    ]
    compiled = found["kernel, compiled"]
    assert (compiled.kind, compiled.needs, compiled.rows) == (
        "kernel",
        "fast",
        found["kernel"].rows,
    )
    points = np.array([[3.0, 4.0, 0.0]])
    first, second = (found["kernel, out="].compute(points) for _ in range(2))
    assert second is first
    assert second.tolist() == [5.0]
    assert given == [False, True, True]


def bare_subject() -> Subject:
    """Return a paper's only quantity, the area of a ring, without accuracy bound and rows."""
    inner, outer = sp.symbols("inner outer", positive=True)
    definition = sp.pi * (outer**2 - inner**2)
    quantity = Quantity(
        name="area",
        summary="Area of a ring.",
        arguments=(
            Argument("inner", (inner,), "inner radius", "mm"),
            Argument("outer", (outer,), "outer radius", "mm"),
        ),
        definition=definition,
        forms=(Form("product of sum and difference", definition),),
        source="a test",
    )
    names = {inner: "inner radius", outer: "outer radius"}
    variables = tuple(Variable(s, text, within=sp.Interval(1, 9)) for s, text in names.items())
    paper = Paper("ring", "a test", variables, (), quantities=(quantity,))
    module = ModuleType("kernels")
    module.area = lambda a, b: np.pi * (b - a) * (b + a)  # type: ignore[attr-defined]
    return Subject(paper, quantity, tuple, (module, None))


@pytest.mark.slow
def test_modules_of_a_folder_are_found_by_their_names(tmp_path: Path) -> None:
    """Code that numba caches names its module, which the next process must find by that name."""
    source = Path(__file__).parents[2]
    for folder in ("derivations", "generated"):
        shutil.copytree(source / folder, tmp_path / folder)
    (subject,) = find_subjects(("track_wheel.radius",), tmp_path / "derivations")
    compiled = subject.load_compiled()
    assert compiled is not None
    assert str(tmp_path) in str(compiled.__file__)
    assert import_module(compiled.__name__) is compiled


def render_tables(folder: Path) -> str:
    return "\n".join(list_lines(read_records(folder)))


@pytest.mark.slow
def test_a_quantity_without_an_accuracy_bound_is_measured_like_any_other(tmp_path: Path) -> None:
    record = measure(bare_subject(), quick=True)
    assert (record.bound, record.scale, record.error_unit) == (None, "", "ulp of the value")
    # Scaled errors are in ulp of the value; the kernel rounds pi, two sums and two products.
    for row in record.sets:
        assert row.worst_scaled == row.worst_ulp
    assert 0 < max(errors.worst_ulp for errors in record.errors_of("kernel")) <= 4
    assert all(0 < found.scaled <= 4 for found in record.searched)
    assert headline(record).endswith("ulp of the value; 72 points, 0 undecided")
    file = write_record(record, tmp_path)
    assert read_record(file) == record
    assert "Scaled: ulp of the value." in render_tables(tmp_path)
    assert draw_charts(record, None, tmp_path)[0].stat().st_size > 10_000


def test_an_input_that_is_known_to_be_bad_counts_for_every_way(record: Record) -> None:
    (subject,) = find_subjects(("track_wheel.planar_error",))
    known = record.searched[0].at
    mild = tuple(replace(found, scaled=0.0) for found in record.searched)
    for found in keep_worst(subject, mild, (known,)):
        (error,) = scaled_errors(
            subject,
            next(way.compute for way in subject.shipped if way.name == found.way),
            tuple(np.array([value]) for value in known),
        )
        assert 0 < error <= found.scaled


def test_inputs_of_another_quantity_are_not_known(record: Record, tmp_path: Path) -> None:
    assert find_known(tmp_path, record.quantity, 1) == ()
    write_record(record, tmp_path)
    assert find_known(tmp_path, record.quantity, 1) == tuple(f.at for f in record.searched)
    with pytest.raises(ValueError, match="its inputs have 1 arguments"):
        find_known(tmp_path, record.quantity, 2)


def test_the_tables_show_every_way_and_what_was_lost(record: Record, tmp_path: Path) -> None:
    write_record(record, tmp_path)
    page = render_tables(tmp_path)
    accuracy, _ = page.split("\nN values of displacement\n")
    lines = [line for line in accuracy.splitlines() if line[:1] == "|"]
    # Ways with equal errors share a line.
    rows = {name: line for line in lines for name in line.split("|")[1].split("; ")}
    assert {way.name for way in record.ways} <= rows.keys()
    assert rows["kernel, out="] == rows["kernel"] != rows["kernel, float32"]
    assert f"Scaled: eps of {record.scale}." in page
    # Overflows are counted, and the first set with one is named.
    naive = rows["printed (17)"].split("|")
    lost = [errors for errors in record.errors_of("printed (17)") if errors.infinite]
    assert naive[-3:-1] == [str(sum(errors.infinite for errors in lost)), lost[0].set]


def test_a_way_that_was_not_timed_says_so(record: Record, tmp_path: Path) -> None:
    timed = tuple(row for row in record.times if row.way != "sympy.lambdify")
    assert len(timed) < len(record.times)
    for times, says in ((record.times, False), (timed, True)):
        write_record(replace(record, times=times), tmp_path)
        page = render_tables(tmp_path)
        assert ("|sympy.lambdify|not timed|not timed|" in page) is says


def test_the_page_in_the_repository_is_of_the_records() -> None:
    """The page stored with the records says what they say."""
    folder = Path(__file__).parents[2] / "generated" / "measured"
    page, records = (folder / PAGE).read_text(encoding="utf-8"), read_records(folder)
    assert page == "\n".join(list_lines(records))
    # The page lists each proved bound with the measured error, and nothing else.
    claims = [claim for record in records for claim in list_claims(record)]
    proved = page.split("## What is proved")[1].split("\n## ")[0]
    assert all(f"|{describe_bound(claim)}|{claim.found:g}|" in proved for claim in claims)
    assert proved.count("\n|") == len(claims) + 2
    assert "## What is proved" not in "\n".join(list_lines(records, lambda record: ()))
    # The page stays readable: some 25 lines for each quantity, and one for each claim.
    assert len(page.encode()) < 1_700 * len(records) + 130 * len(claims)
