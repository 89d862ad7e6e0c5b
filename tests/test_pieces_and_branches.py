"""A user's own papers: a four-bar linkage with two branches, and a cam with piecewise laws."""

from __future__ import annotations

import ctypes
import json
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from codegen.c_libraries import COMPILER, STRICT, compile_files
from command import run
from test_own_paper import load, run_in

from mechproof import choose, tailor

OTHERS = Path(__file__).parent / "own_paper" / "others"
SIZES = (40.0, 120.0, 80.0, 100.0)
EPS = 2.0**-52


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the derivations and the files generated from them."""
    folder = tmp_path_factory.mktemp("workshop")
    shutil.copytree(OTHERS, folder / "derivations")
    run_in(folder, "regenerate")
    return folder


@pytest.mark.slow
@pytest.mark.xdist_group("pieces")
def test_the_misprints_are_found(workshop: Path) -> None:
    run_in(workshop, "verify", "--json", "rows.json")
    rows = json.loads((workshop / "rows.json").read_text())["rows"]
    refuted = [(r["system"], r["number"]) for r in rows if r["verdict"] == "REFUTED"]
    assert refuted == [("cam", "(3)"), ("four_bar", "(2)")]
    assert {r["verdict"] for r in rows} == {"PROVED", "REFUTED"}


@pytest.mark.usefixtures("judged_here")
def test_the_derivations_begin_as_new_writes_them(tmp_path: Path) -> None:
    for name in ("cam", "four_bar"):
        shutil.copy(OTHERS / f"{name}.tex", tmp_path)
        run_in(tmp_path, "new", f"{name}.py")
        begun, finished = ((f / f"{name}.py").read_text() for f in (tmp_path, OTHERS))
        taken = re.findall(r"^ .*= ?PRINT.(?:where|notation|file),$", begun, re.MULTILINE)
        assert len(taken) == 3
        assert [line for line in taken if line not in finished] == []
    run_in(tmp_path, "verify", "cam.py")


@pytest.mark.slow
@pytest.mark.xdist_group("pieces")
@pytest.mark.parametrize("compiled", [False, True])
def test_both_branches_close_the_loop(workshop: Path, compiled: bool) -> None:
    kernels = load(workshop / "generated" / ("compiled" if compiled else "") / "four_bar.py")
    theta, (a, b, c, d) = np.linspace(-20, 20, 301), SIZES
    found = [kernels.rocker(theta, *SIZES, branch) for branch in (1.0, -1.0)]
    for phi in found:
        gap = np.hypot(d + c * np.cos(phi) - a * np.cos(theta), c * np.sin(phi) - a * np.sin(theta))
        assert np.abs(gap - b).max() <= 64 * EPS * b
        ratio = kernels.velocity_ratio(theta, phi, a, c, d)
        assert np.abs(np.gradient(phi, theta) - ratio)[1:-1].max() < 0.02
    assert np.abs(found[0] - found[1]).min() > 1
    assert math.isnan(kernels.rocker(1.0, *SIZES, 0.5))
    assert math.isnan(kernels.rocker(1.0, 200.0, *SIZES[1:], 1.0))


@pytest.mark.slow
@pytest.mark.xdist_group("pieces")
@pytest.mark.parametrize("compiled", [False, True])
def test_each_piece_of_a_law_is_taken(workshop: Path, compiled: bool) -> None:
    kernels = load(workshop / "generated" / ("compiled" if compiled else "") / "cam.py")
    angles, h = np.array([0.0, math.pi / 3, 2.5, 4 * math.pi / 3, 6.0]), 20.0
    assert kernels.lift(angles, h) == pytest.approx([0, h / 2, h, h / 2, 0], rel=1e-14, abs=0)
    fastest = kernels.velocity(angles, h)
    peaks = [0, 45 * h / 16 / math.pi, 0, -3 * h / math.pi, 0]
    assert fastest == pytest.approx(peaks, rel=1e-14, abs=0)
    # NaN outside the domain, even where the last piece would give a number.
    outside = np.array([-1.0, 7.0, np.nan])
    assert np.isnan(kernels.lift(outside, h)).all()
    assert np.isnan(kernels.lift(np.full(2, 6.0), -h)).all()


@pytest.mark.slow
@pytest.mark.xdist_group("pieces")
@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
def test_the_same_in_c(workshop: Path) -> None:
    run_in(workshop, "emit", "c", "--out", "c")
    for system, name, given in (
        ("cam", "lift", (4.5, 20.0)),
        ("cam", "acceleration", (6.0, 20.0)),
        ("four_bar", "rocker", (1.0, *SIZES, -1.0)),
    ):
        texts = {n: (workshop / "c" / n).read_text() for n in (f"{system}.h", f"{system}.c")}
        function = getattr(compile_files(workshop, texts, STRICT), f"{system}_{name}")
        function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * len(given)
        kernels = load(workshop / "generated" / "compiled" / f"{system}.py")
        assert function(*given) == pytest.approx(getattr(kernels, name)(*given), rel=4 * EPS)


@pytest.mark.thorough
@pytest.mark.xdist_group("pieces")
def test_branches_and_pieces_are_measured_charted_chosen_and_tailored(workshop: Path) -> None:
    run_in(workshop, "measure", "--quick", "rocker", "lift")
    measured = workshop / "generated" / "measured" / "quick"
    run_in(workshop, "chart", "--measured", str(measured), "--out", "charts")
    for name in ("four_bar.rocker", "cam.lift"):
        assert list((workshop / "charts").glob(f"{name}*.svg"))
    crank = dict(zip("abcd", SIZES, strict=True))
    choice = choose("four_bar.rocker", error=1e-9, theta=(0.1, 6), **crank, measured=measured)
    assert choice.error <= 1e-12
    assert choose("cam.lift", error=1e-9, h=20, measured=measured).error <= 1e-12
    sizes = [f"--let={name}={value}" for name, value in {**crank, "sigma": -1}.items()]
    asked = ("emit", "c", "four_bar.rocker", "--error", "1e-6", "--let=theta=0:6", *sizes)
    run_in(workshop, *asked, "--out", "tailored")
    assert (workshop / "tailored" / "four_bar_tailored.c").is_file()
    place = workshop / "derivations"
    assert tailor("cam.lift", error=1e-6, derivations=place, theta=(0.1, 2), h=20).bound <= 1e-6
    with pytest.raises(ValueError, match=r"jumps or is undefined near 2\.0943951"):
        tailor("cam.lift", error=1e-6, derivations=place, theta=(0.1, 3), h=20)
    run_in(workshop, "report")
    for name in ("four_bar.rocker", "cam.lift"):
        page = (workshop / "report" / "quantities" / f"{name}.html").read_text(encoding="utf-8")
        assert "A quick measurement" in page


@pytest.mark.thorough
@pytest.mark.xdist_group("pieces")
def test_compiled_kernels_are_kept_whoever_compiles_them_first(
    workshop: Path, tmp_path: Path
) -> None:
    """Machine code that numba caches in one process is read by the next, by its import name."""
    for folder in ("derivations", "generated"):
        ignored = shutil.ignore_patterns("__pycache__", "measured")
        shutil.copytree(workshop / folder, tmp_path / folder, ignore=ignored)
    call = ("-c", "from generated.compiled.cam import lift; print(lift(2.5, 20.0))")
    measure = ("-m", "mechproof", "measure", "--quick", "cam.lift")
    said = []
    for command in (call, measure, call):
        done = subprocess.run(
            [sys.executable, *command], cwd=tmp_path, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        said.append(done.stdout)
    assert said[0] == said[2] == "20.0\n"
    assert list((tmp_path / "generated" / "compiled" / "__pycache__").glob("cam*.nbc"))


@pytest.mark.slow
def test_what_has_no_operation_is_a_row_of_verify(tmp_path: Path) -> None:
    text = (OTHERS / "four_bar.py").read_text()
    shutil.copy(OTHERS / "four_bar.tex", tmp_path)
    wrong = text.replace('"equation (3)", SHORT)', '"equation (3)", SHORT + zeta(theta))')
    (tmp_path / "four_bar.py").write_text(wrong.replace("sin, sqrt\n", "sin, sqrt, zeta\n", 1))
    done = run("verify", str(tmp_path / "four_bar.py"), "--json", str(tmp_path / "rows.json"))
    assert done.exit_code == 1
    rows = json.loads((tmp_path / "rows.json").read_text())["rows"]
    found = {row["number"]: row["verdict"] for row in rows}
    assert found == {
        "(1)": "PROVED",
        "(2)": "REFUTED",
        "(3)": "PROVED",
        "kernel rocker": "PROVED",
        "kernel velocity_ratio": "UNDECIDED",
    }
    told = " ".join(rows[-1]["reason"].split())
    assert "quantity velocity_ratio: no operation for zeta" in told
    assert "or leave them out to have no kernel" in told
    assert "kernel velocity_ratio is UNDECIDED, but only proved rows are shipped" in done.output
    refused = run("emit", "c", "--derivations", str(tmp_path), "--out", str(tmp_path / "c"))
    assert refused.exit_code == 1
    assert not (tmp_path / "c").exists()


STEPS = """
from sympy import *
from mechproof.record import *
x = Symbol("x", real=True)
def q(name, definition, form=None):
    forms = (Form("as printed", definition if form is None else form),)
    argument = Argument("x", (x,), "a number", usual=(0.1, 1, 10))
    return Quantity(name, "Compute it.", (argument,), definition, forms, "my notes")
PAPER = Paper("steps", "my notes", (Variable(x, "a number"),), (), quantities=(%s))
"""


@pytest.mark.slow
def test_ceilings_and_steps_have_kernels(tmp_path: Path) -> None:
    (tmp_path / "derivations").mkdir()
    derived = (
        'q("teeth", ceiling(x/3 + 1)), q("push", (x - 1)**2*Heaviside(x - 1)),'
        'q("half", Heaviside(x)), q("closed", x + Heaviside(x - 1, 1))'
    )
    (tmp_path / "derivations" / "steps.py").write_text(STEPS % derived)
    run_in(tmp_path, "regenerate")
    x = np.array([-4.0, -0.5, 0.0, 1.0, 2.5, 6.0, np.nan])
    teeth = [0.0, 1.0, 1.0, 2.0, 2.0, 3.0, np.nan]
    for folder in ("", "compiled"):
        kernels = load(tmp_path / "generated" / folder / "steps.py")
        np.testing.assert_array_equal(kernels.teeth(x), teeth)
        np.testing.assert_array_equal(kernels.push(x), [0, 0, 0, 0, 2.25, 25, np.nan])
        np.testing.assert_array_equal(kernels.half(x), [0, 0, 0.5, 1, 1, 1, np.nan])
        np.testing.assert_array_equal(kernels.closed(x), [-4, -0.5, 0, 2, 3.5, 7, np.nan])


def test_another_step_is_refuted(tmp_path: Path) -> None:
    wrong = 'q("teeth", ceiling(x), floor(x) + 1), q("open", Heaviside(x, 1), Heaviside(x, 0))'
    (tmp_path / "steps.py").write_text(STEPS % wrong)
    done = run("verify", str(tmp_path / "steps.py"))
    assert done.exit_code == 1
    assert "REFUTED  2" in done.output
    for name in ("teeth", "open"):
        assert f"kernel {name} is REFUTED" in " ".join(done.stderr.split())
