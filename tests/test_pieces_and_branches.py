"""Papers of a user's own: a four-bar linkage in two branches, and a cam whose laws are pieces."""

from __future__ import annotations

import ctypes
import json
import math
import shutil
from pathlib import Path

import numpy as np
import pytest
from codegen.c_libraries import COMPILER, STRICT, compile_files
from command import run
from test_own_paper import load, run_in

OTHERS = Path(__file__).parent / "own_paper" / "others"
SIZES = (40.0, 120.0, 80.0, 100.0)
EPS = 2.0**-52


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the derivations and what is generated from them."""
    folder = tmp_path_factory.mktemp("workshop")
    shutil.copytree(OTHERS, folder / "derivations")
    run_in(folder, "regenerate")
    return folder


@pytest.mark.xdist_group("pieces")
def test_the_misprints_are_found(workshop: Path) -> None:
    run_in(workshop, "verify", "--json", "rows.json")
    rows = json.loads((workshop / "rows.json").read_text())["rows"]
    refuted = [(r["system"], r["number"]) for r in rows if r["verdict"] == "REFUTED"]
    assert refuted == [("cam", "(3)"), ("four_bar", "(2)")]
    assert {r["verdict"] for r in rows} == {"PROVED", "REFUTED"}


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


@pytest.mark.xdist_group("pieces")
@pytest.mark.parametrize("compiled", [False, True])
def test_each_piece_of_a_law_is_taken(workshop: Path, compiled: bool) -> None:
    kernels = load(workshop / "generated" / ("compiled" if compiled else "") / "cam.py")
    angles, h = np.array([0.0, math.pi / 3, 2.5, 4 * math.pi / 3, 6.0]), 20.0
    assert kernels.lift(angles, h) == pytest.approx([0, h / 2, h, h / 2, 0], rel=1e-14, abs=0)
    fastest = kernels.velocity(angles, h)
    peaks = [0, 45 * h / 16 / math.pi, 0, -3 * h / math.pi, 0]
    assert fastest == pytest.approx(peaks, rel=1e-14, abs=0)
    # Where the last piece is a number, too.
    outside = np.array([-1.0, 7.0, np.nan])
    assert np.isnan(kernels.lift(outside, h)).all()
    assert np.isnan(kernels.lift(np.full(2, 6.0), -h)).all()


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


def test_what_has_no_operation_is_told_by_verify(tmp_path: Path) -> None:
    text = (OTHERS / "cam.py").read_text()
    wrong = text.replace("LIFT = join(", "LIFT = zeta(2 + theta) * join(")
    (tmp_path / "cam.py").write_text(wrong.replace("pi, sin\n", "pi, sin, zeta\n", 1))
    done = run("verify", str(tmp_path / "cam.py"))
    assert done.exit_code == 1
    told = " ".join(done.output.split())
    assert "quantity lift: no operation for zeta" in told
    assert "or leave them out for no kernel of it" in told
