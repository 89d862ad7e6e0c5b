"""`mechproof bound` reports proved bounds, errors found and open boxes; so does Python."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import mechproof
from mechproof.cli import app
from mechproof.fpcore import FPCoreError
from mechproof.pipeline.pasted import PastedError

CORES = """(FPCore (x) :name "half" :pre (<= 1 x 2) (/ x (+ x 0.1)))
(FPCore (x) :name "pole" :pre (<= 1 x 2) (/ x (- x 1)))
"""


def run(*arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["bound", *arguments])
    return result.exit_code, result.output


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "two.fpcore"
    path.write_text(CORES, encoding="utf-8")
    return path


def test_files_are_bounded_and_what_is_not_fails(file: Path, tmp_path: Path) -> None:
    code, output = run(str(file), "--json", str(tmp_path / "bounds.json"))
    assert code == 1
    assert "half: error at most " in output
    assert "  found " in output
    assert "pole: no bound of the error is proved where 1 <= x <= 1" in output
    half, pole = json.loads((tmp_path / "bounds.json").read_text("utf-8"))["bounds"]
    assert half["found"] <= half["proved"] <= 2e-16
    assert (half["error"], half["inputs"], half["open"]) == ("absolute", "doubles", "")
    assert pole["proved"] is None


def test_expressions_are_bounded(tmp_path: Path) -> None:
    code, output = run(r"y=\frac{a x}{1+x^2}", "--where", "1<x<2", "--let", "a=3", "--relative")
    assert code == 0
    # Four roundings; those of the square and of the divisor count less.
    assert "relative error at most 3.3" in output
    assert run(r"\pi x", "--where", "1<x<2")[0] == 0
    code, output = run(r"\sin x", "--where", "0<x<1", "--ulps", "0.75", "--rounded-inputs")
    assert code == 0
    assert "inputs rounded" in output
    assert "sin within 0.75 ulp" in output


def test_an_assumption_that_does_not_hold_is_found_out() -> None:
    """The sines of NumPy and of glibc are off by up to 0.515 ulp."""
    code, output = run(r"\sin x", "--where", "1<x<1.5", "--ulps", "0.5")
    assert code == 1
    assert "proved assuming sin within 0.5 ulp" in output


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["x+y", "--where", "0<x<1"], "--where gives no number <= y"),
        ([r"\frac13+\sqrt2"], "it has no letters, so there is no box to bound it over"),
        (["x+y", "--where", "0<x<y", "--where", "0<y<1"], "must be a range of one letter"),
        (["x<1", "--where", "0<x<1", "--tolerance", "2"], "--tolerance 2"),
        (["x", "--where", "0<x<1", "--ulps", "0.1"], "ulps = 0.1: must satisfy"),
        (["a.fpcore"], "a.fpcore: No such file"),
        (["a.fpcore", "--where", "0<x<1"], "of its own arguments, in :pre"),
        (["a.fpcore", "x"], "x: does not end in .fpcore"),
        ([r"\int_0^x t dt", "--where", "0<x<1"], "no operation for Integral"),
        (["x=y=z", "--where", "0<x<1"], "one expression is needed"),
    ],
)
def test_bad_usage_is_refused(arguments: list[str], told: str) -> None:
    code, output = run(*arguments)
    assert code == 2
    assert told in output


def test_python_has_the_same(file: Path) -> None:
    half, pole = mechproof.bound(file)
    assert half.found <= half.proved
    assert pole.open == "1 <= x <= 1"
    (one,) = mechproof.bound("x^2", where=["1<=x<=2"], relative=True)
    assert one.proved <= 1.01 * 2.0**-53
    with pytest.raises(FPCoreError, match=r"none\.fpcore: No such file"):
        mechproof.bound("none.fpcore")
    with pytest.raises(PastedError, match="no number <= x"):
        mechproof.bound("x^2")
    with pytest.raises(ValueError, match="tolerance = 1"):
        mechproof.bound("x^2", where=["1<=x<=2"], tolerance=1)
    with pytest.raises(TypeError, match="where = '1<x<2'"):
        mechproof.bound("x^2", where="1<x<2")
