"""C sources: no compiler warns, flags that lose NaN are refused, headers state the results."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path
from shutil import which

import pytest
from c_libraries import STRICT, needs_compiler, render
from quantities import KERNELS
from typer.testing import CliRunner
from weights import first_of

from mechproof.cli.commands import app

pytestmark = needs_compiler
COMPILERS = [
    pytest.param(name, marks=pytest.mark.skipif(not which(name), reason=f"there is no {name}"))
    for name in ("gcc", "clang")
]
# The first source has everything: sums, matrices, several forms and their conditions.
SYSTEMS = sorted(
    {name.partition(".")[0] for name in KERNELS}, key=lambda name: (name != "track_wheel", name)
)
SOURCES = [(system, single) for system in SYSTEMS for single in (False, True)]


def compile_only(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    whole = [*command, "-S", "-o", os.devnull]
    return subprocess.run(whole, cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.slow
@pytest.mark.parametrize("compiler", first_of(COMPILERS))
@pytest.mark.parametrize(("system", "single"), first_of(SOURCES))
def test_no_compiler_warns(compiler: str, system: str, single: bool, tmp_path: Path) -> None:
    files = render(system, single)
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    header, source = files
    for optimised in (("-O0",), ("-O3", "-march=native")):
        done = compile_only(tmp_path, compiler, *STRICT, "-Wshadow", *optimised, source)
        assert done.returncode == 0, done.stderr
    as_cpp = ("-x", "c++", "-std=c++11", *(f for f in STRICT if f != "-std=c99"))
    done = compile_only(tmp_path, compiler, *as_cpp, source)
    assert not done.stderr or "cc1plus" in done.stderr
    (tmp_path / "included.cpp").write_text(f'#include "{header}"\n')
    done = compile_only(tmp_path, compiler, "-Wall", "-Wextra", "-pedantic", "included.cpp")
    assert not done.stderr or "cc1plus" in done.stderr


@pytest.mark.parametrize("compiler", first_of(COMPILERS))
@pytest.mark.parametrize("flag", ["-ffast-math", "-Ofast", "-ffinite-math-only"])
def test_arithmetic_that_loses_nan_is_refused(compiler: str, flag: str, tmp_path: Path) -> None:
    for name, text in render("track_wheel", False).items():
        (tmp_path / name).write_text(text)
    done = compile_only(tmp_path, compiler, "-std=c99", "-O2", flag, "track_wheel.c")
    assert done.returncode != 0
    assert "compile without -ffast-math" in done.stderr


def test_a_header_says_what_is_computed_where_and_how_exactly() -> None:
    text = render("elliptic_planetary", False)["elliptic_planetary.h"]
    _, _, ratio = text.partition("Compute the transmission ratio")
    for line in (
        " * R1: radius of the epicycle (mm)",
        " * e: eccentricity of the ellipse (pure number)",
        " * Result: pure number",
        " *     ratio = 1 + k*(1 - e**2)/(1 + e**2 - 2*e*cos(x))",
        " *     k = R1/R2",
        " * Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.",
        " * Accuracy: 10 eps of the value and the effect of eps*x, where |x| <= 2**26 and",
    ):
        assert line in ratio
    assert "out_ratio: pure number" in ratio.partition("in one pass")[2]


def test_a_source_in_float_tells_the_error_that_a_search_finds(tmp_path: Path) -> None:
    """The header states the largest error in eps that the search found, and its points."""
    (tmp_path / "length.py").write_text(LENGTH)
    runner = CliRunner()
    done = runner.invoke(
        app, ["emit", "c", str(tmp_path / "length.py"), "--float32", "--out", str(tmp_path)]
    )
    assert done.exit_code == 0, done.output
    told = re.search(
        r"Accuracy: (\S+) eps of the value; the worst of (\d+) points",
        (tmp_path / "length_single.h").read_text(),
    )
    assert told is not None
    assert 0.5 < float(told[1]) < 1.0
    assert int(told[2]) > 1000


LENGTH = '''
"""A length in a plane."""

from sympy import Symbol, sqrt

from mechproof.record import Accuracy, Argument, Form, Paper, Quantity, Variable

x, y = Symbol("x", real=True), Symbol("y", real=True)
length = sqrt(x**2 + y**2)
PAPER = Paper(
    system="length",
    citation="a note",
    variables=(Variable(x, "a side"), Variable(y, "a side")),
    rows=(),
    quantities=(
        Quantity(
            "length",
            "Compute the length.",
            (Argument("x", (x,), "a side"), Argument("y", (y,), "a side")),
            length,
            (Form("direct", length),),
            "here",
            accuracy=Accuracy(1),
        ),
    ),
)
'''
