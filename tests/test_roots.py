"""A user's own papers whose quantities are roots of equations: Kepler's and the involute's."""

from __future__ import annotations

import ctypes
import json
import shutil
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from codegen.c_libraries import COMPILER, STRICT, compile_files
from command import run
from test_own_paper import load, run_in

from mechproof import choose, tailor

ROOTS = Path(__file__).parent / "own_paper" / "roots"
EPS = 2.0**-52
WHERE = [
    (0.3, 0.5),
    (1e-3, 0.7),
    (-2.5, 0.01),
    (40.7, 0.65),
    (-1e4, 0.3),
    (3.14159, 0.7),
    (2.0, 0.0),
]


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the derivations and the files generated from them."""
    folder = tmp_path_factory.mktemp("roots")
    shutil.copytree(ROOTS, folder / "derivations")
    run_in(folder, "regenerate")
    return folder


def solve(mean: float, size: float) -> mp.mpf:
    with mp.workdps(40):
        return mp.findroot(lambda z: z - mp.mpf(size) * mp.sin(z) - mp.mpf(mean), mean)


@pytest.mark.slow
@pytest.mark.xdist_group("roots")
def test_that_the_steps_converge_is_a_row(workshop: Path) -> None:
    run_in(workshop, "verify", "--json", "rows.json")
    rows = json.loads((workshop / "rows.json").read_text())["rows"]
    assert {row["verdict"] for row in rows} == {"PROVED"}
    rungs = {r["number"]: r["rung"] for r in rows if r["number"].endswith(", converges")}
    assert rungs.keys() == {
        "kernel anomaly, converges",
        "kernel rate, converges",
        "kernel pressure_angle, converges",
    }
    assert all("Newton's method in balls" in rung for rung in rungs.values())


@pytest.mark.slow
@pytest.mark.xdist_group("roots")
@pytest.mark.parametrize("compiled", [False, True])
def test_the_kernels_are_right(workshop: Path, compiled: bool) -> None:
    folder = workshop / "generated" / ("compiled" if compiled else "")
    kepler, involute = load(folder / "kepler.py"), load(folder / "involute.py")
    means, sizes = np.array(WHERE).T
    want = [solve(*one) for one in WHERE]
    for found, exact in zip(kepler.anomaly(means, sizes), want, strict=True):
        # The angle is rounded, and divided by the rate.
        assert abs(found - float(exact)) <= 16 * EPS * max(1e-3, abs(float(exact)))
    rates = [float(1 / (1 - s * mp.cos(z))) for (_, s), z in zip(WHERE, want, strict=True)]
    assert kepler.rate(means[:4], sizes[:4]) == pytest.approx(rates[:4], rel=64 * EPS)
    angles = np.array([0.08, 0.2, 0.349, 0.7, 0.9])
    assert involute.pressure_angle(np.tan(angles) - angles) == pytest.approx(angles, rel=1e-12)
    assert np.isnan(kepler.anomaly([1.0, np.nan, 1.0], [0.9, 0.5, np.nan])).all()
    assert np.isnan(involute.pressure_angle([-0.1, 0.6, np.nan])).all()


@pytest.mark.slow
@pytest.mark.xdist_group("roots")
@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
def test_the_same_in_c(workshop: Path) -> None:
    run_in(workshop, "emit", "c", "--out", "c")
    texts = {n: (workshop / "c" / n).read_text() for n in ("kepler.h", "kepler.c")}
    function = compile_files(workshop, texts, STRICT).kepler_anomaly
    function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * 2
    for mean, size in WHERE:
        assert function(mean, size) == pytest.approx(float(solve(mean, size)), rel=16 * EPS)


@pytest.mark.thorough
@pytest.mark.xdist_group("roots")
def test_a_root_is_measured_charted_and_chosen_but_not_tailored(workshop: Path) -> None:
    run_in(workshop, "measure", "--quick", "anomaly")
    measured = workshop / "generated" / "measured" / "quick"
    choice = choose("kepler.anomaly", error=1e-9, M=(0.1, 3), e=(0.1, 0.5), measured=measured)
    assert choice.error <= 1e-12
    run_in(workshop, "chart", "--measured", str(measured), "--out", "charts")
    assert list((workshop / "charts").glob("kepler.anomaly*.svg"))
    wanted = "a root of an equation cannot be tailored; call its kernel"
    with pytest.raises(ValueError, match=wanted):
        tailor("kepler.anomaly", error=1e-6, derivations=workshop / "derivations", e=0.2, M=(0, 6))


WRONG = {
    "another equation": (
        '(Form("Newton\'s method", ANOMALY),)',
        '(Form("Newton\'s method", ANOMALY.subs(e, -e)),)',
        "kernel anomaly is REFUTED",
    ),
    "too few steps": ("steps=5", "steps=3", "kernel anomaly, converges is "),
    "a bracket without a root": (
        "(E, M - 1, M + 1)",
        "(E, M + 1, M + 2)",
        "there is no root in the bracket",
    ),
    "a domain without end": (
        "within=Interval(0, Rational(7, 10))",
        "within=Interval(0, oo)",
        "e is not bounded: state a closed interval for it",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_root_is_not_shipped(tmp_path: Path, name: str) -> None:
    right, wrong, told = WRONG[name]
    text = (ROOTS / "kepler.py").read_text()
    assert right in text
    text = text.replace(right, wrong, 1).replace("diff, sin\n", "diff, oo, sin\n", 1)
    (tmp_path / "kepler.py").write_text(text)
    done = run("verify", str(tmp_path / "kepler.py"))
    assert done.exit_code == 1
    assert told in " ".join(done.output.split())
