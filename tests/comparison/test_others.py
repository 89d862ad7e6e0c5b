"""Scripts for other tools state the same program, for which they prove the same bounds."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from mechproof.arithmetic.cover import bound_largest
from mechproof.comparison import fptaylor, gappa
from mechproof.coq import checker
from mechproof.fpcore import read_cores
from mechproof.pipeline.bounding import read_boundings
from mechproof.pipeline.bounds_page import HEADS, compare
from mechproof.roundoff.boxed import BoxedProgram, Convention, put_in_box

DOCS = Path(__file__).parents[2] / "docs"
FILE = DOCS / "fpbench" / "benchmarks.fpcore"
TEXT = "(FPCore (x y) :pre (and (<= 1 x 2) (<= -1 y 3)) (- (fma x y 0.1) (sqrt (* 0.5 (- x)))))"
needs_gappa = pytest.mark.skipif(not gappa.is_installed(), reason="Gappa is not installed")
needs_fptaylor = pytest.mark.skipif(not fptaylor.is_installed(), reason="no FPTaylor")


def program_of(name: str, *, rounded: bool = False) -> BoxedProgram:
    (core,) = (core for core in read_cores(FILE.read_text("utf-8")) if core.name == name)
    return put_in_box(core.straight, core.box, Convention(rounded, ulps=0.5))


def test_scripts_have_each_step_with_its_rounding() -> None:
    (core,) = read_cores(TEXT)
    program = put_in_box(core.straight, core.box, Convention())
    script = gappa.write_script(program, None, 4).splitlines()
    assert script[0] == "@rnd = float<ieee_64, ne>;"
    assert "v0 = rnd(xv0);" in script
    assert "v2 = 3602879701896397b-55;" in script
    assert "Mv2 = 1/10;" in script
    assert "v3 = rnd(v0 * v1 + v2);" in script
    # Neither a power of two nor a sign causes rounding.
    assert "v5 = 1b-1 * v4;" in script
    assert script[-2].endswith("|v7 - Mv7| in ? }")
    assert script[-1] == "$ v0 in 2, v1 in 2;"
    task = fptaylor.write_task(program)
    assert "v3 = rnd[64, ne, 1](v0 * v1 + v2);" in task
    assert "v2 = rnd[64, ne, 1](1/10);" in task
    assert "float64 v1 in [0 - 1 / 1, 3 / 1];" in task


@pytest.mark.slow
@needs_gappa
def test_gappa_proves_what_is_proved_here_and_refuses_less() -> None:
    for name in ("rigidBody1", "himmilbeau"):
        program = program_of(name, rounded=True)
        found = bound_largest(program.bound, program.box, 0.002, 20_000)
        assert gappa.proves(program, 1.002 * found.bound)
        assert not gappa.proves(program, 0.9 * found.reached)


@needs_gappa
def test_gappa_has_no_bound_of_functions() -> None:
    program = program_of("logexp")
    assert gappa.find_bound(program) is None
    assert not gappa.can_write(program)


@needs_fptaylor
def test_fptaylor_bounds_the_same() -> None:
    found = fptaylor.find_bound(program_of("rigidBody1", rounded=True))
    assert found is not None
    assert found == pytest.approx(2.9488e-13, rel=1e-3)


def test_pages_have_a_row_for_each_program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for other in (gappa, fptaylor, checker):
        monkeypatch.setattr(other, "is_installed", lambda: False)
    file = tmp_path / "one.fpcore"
    file.write_text('(FPCore (x) :name "one" :pre (<= 1 x 2) (/ x 3))', encoding="utf-8")
    cited = tmp_path / "cited.json"
    cited.write_text('{"sources": {"A": "a book"}, "doubles": {"one": {"A": 1.0, "B": 2.0}}}')
    page = compare(read_boundings(file), cited)
    rows = re.findall(r"^\| one .*$", page, re.M)
    assert len(rows) == len(HEADS)
    assert rows[0].endswith("| - | - | - | 1 (A) | < 0.001 |")
    assert rows[1].endswith("| - | - | - | - | - |")
    assert "- A: a book." in page


@pytest.mark.slow
@pytest.mark.skipif(not checker.is_installed(), reason="Coq is not installed")
def test_pages_have_what_coq_proves(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for other in (gappa, fptaylor):
        monkeypatch.setattr(other, "is_installed", lambda: False)
    monkeypatch.delitem(HEADS, "rounded")
    file = tmp_path / "one.fpcore"
    file.write_text('(FPCore (x) :name "one" :pre (<= 1 x 7/4) (/ x 3))', encoding="utf-8")
    page = compare(read_boundings(file), tmp_path / "cited.json")
    ((proved, coq),) = re.findall(r"^\| one \| ([\d.e-]+) \| ([\d.e-]+) \|", page, re.M)
    assert float(proved) <= float(coq) <= 1.02 * float(proved)
    assert "Coq 1 of the 1 that it proves." in page


def test_the_page_of_the_benchmarks_is_what_is_proved() -> None:
    """The table has a row for each program; the bounds of some are computed again."""
    page = (DOCS / "bounds.md").read_text("utf-8")
    tables = page.split("## ")[1:3]
    names = [core.name for core in read_cores(FILE.read_text("utf-8"))]
    for table, rounded in zip(tables, (False, True), strict=True):
        rows = dict(re.findall(r"^\| (\w+) \| ([\d.e-]+) \|", table, re.M))
        assert list(rows) == names
        # Coq's bound is never below the bound proved here, nor more than twice as large.
        for numbers in re.findall(
            r"^\| \w+ \| ([\d.e-]+) \| ([\d.e-]+) \| ([\d.e-]+|-) ", table, re.M
        ):
            proved, coq, found = (0.0 if n == "-" else float(n) for n in numbers)
            assert max(proved, found) <= coq <= 2.001 * proved
        for name in ("verhulst", "carbonGas", "rigidBody1"):
            program = program_of(name, rounded=rounded)
            found = bound_largest(program.bound, program.box, 0.002, 20_000).bound
            # Rounded up to four digits, that is to a thousandth.
            assert found <= float(rows[name]) <= 1.001 * found
