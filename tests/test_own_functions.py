"""A user's own paper with every kind of function: its kernels can be tailored."""

from __future__ import annotations

import shutil
import subprocess
import sys
from contextlib import chdir
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from command import run
from test_own_paper import run_in

from mechproof import tailor
from mechproof.tailoring.request import read_request

OWN = Path(__file__).parent / "own_paper" / "functions"
OF_X, OF_Y, OF_BOTH = {"x": (-0.5, 0.5)}, {"y": (0.5, 3)}, {"x": (-0.5, 0.5), "y": 1.5}
SIZES: dict[str, dict[str, Any]] = {
    **dict.fromkeys(("arccosine", "secant", "tangent", "area", "wave", "total"), OF_X),
    **dict.fromkeys(("logarithm", "root", "cosecant", "cotangent"), OF_Y),
    **dict.fromkeys(("power", "smaller", "larger"), OF_BOTH),
    "branch": {**OF_BOTH, "s": -1},
    "rest": {"y": (0.25, 1.75)},
    "direction": {"x": (-0.5, -0.25)},
    "pieces": {"x": (0.3, 0.9)},
}
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("functions")]


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of the derivations, with the generated files next to it."""
    folder = tmp_path_factory.mktemp("workshop")
    shutil.copytree(OWN, folder / "derivations")
    run_in(folder, "regenerate")
    return folder / "derivations"


def test_it_is_said_how_the_kernels_are_imported(place: Path) -> None:
    done = run("regenerate", "--derivations", str(place))
    assert done.exit_code == 0
    told, line = done.output.splitlines()[-1].split(": ")
    assert told == f"in Python, started in {place.parent}"
    asked = [sys.executable, "-c", f"{line}; print(functions.secant(0.0))"]
    shown = subprocess.run(asked, cwd=place.parent, capture_output=True, text=True, check=False)
    assert shown.stdout == "1.0\n", shown.stderr
    checked = run("regenerate", "--check", "--derivations", str(place))
    assert "from generated import" not in checked.output


def test_what_is_generated_names_no_paper_of_the_package(place: Path) -> None:
    texts = {file.name: file.read_text() for file in place.parent.glob("generated/*.*")}
    assert "\nGenerated from the derivation functions with SymPy" in texts["functions.py"]
    assert not [n for n, t in texts.items() if "mechproof.derivations" in t or "elliptic" in t]


@pytest.mark.parametrize("name", SIZES)
def test_a_tailored_kernel_is_within_its_bound(place: Path, name: str) -> None:
    request = read_request(f"functions.{name}", 1e-9, SIZES[name], place)
    kernel = tailor(f"functions.{name}", error=1e-9, derivations=place, **SIZES[name])
    first, *others = request.quantity.arguments
    sizes = {a.symbols[0]: request.values[a.name] for a in others}
    for point in np.linspace(kernel.low, kernel.high, 17).tolist():
        exact = {s: sp.Rational(v) for s, v in {**sizes, first.symbols[0]: point}.items()}
        true = request.quantity.definition.doit().subs(exact).evalf(30)
        assert abs(kernel(point) - true) <= kernel.bound <= 1e-9


@pytest.mark.parametrize(
    ("name", "sizes", "seam"),
    [
        ("direction", {"x": (-0.5, 0.75)}, r"jumps or is undefined near -?\d.\d+e-1\d:"),
        ("rest", {"y": (0.5, 3)}, "jumps or is undefined near 2:"),
    ],
)
def test_a_seam_within_the_range_is_named(
    place: Path, name: str, sizes: dict[str, Any], seam: str
) -> None:
    with pytest.raises(ValueError, match=seam):
        tailor(f"functions.{name}", error=1e-9, derivations=place, **sizes)


def test_a_function_that_has_no_series_is_named(place: Path) -> None:
    request = read_request("functions.wave", 1e-9, {"x": (0, 1)}, place)
    (x,) = request.quantity.arguments[0].symbols
    told = (
        "name = 'functions.wave': no series is known for erf: cannot be tailored; call its kernel"
    )
    with pytest.raises(ValueError, match=told):
        request.define(sp.erf(x))


def test_the_command_writes_one_and_refuses_a_seam(place: Path) -> None:
    ask = ("emit", "c", "functions.power", "--error", "1e-6", "--let", "y=1.5")
    run_in(place.parent, *ask, "--let", "x=-0.5:0.5", "--out", "c")
    assert (place.parent / "c" / "functions_tailored.c").is_file()
    refused = ("emit", "c", "functions.rest", "--error", "1e-6", "--let", "y=1:3")
    with chdir(place.parent):
        done = run(*refused)
    assert done.exit_code == 2
    told = " ".join(done.output.split())
    assert "y = (1.0, 3.0): functions.rest jumps or is undefined near 2" in told


def test_a_derivation_that_fails_is_told(place: Path, tmp_path: Path) -> None:
    shutil.copytree(place.parent / "generated", tmp_path / "generated")
    (tmp_path / "derivations").mkdir()
    (tmp_path / "derivations" / "functions.py").write_text("1 / 0\n")
    with chdir(tmp_path):
        done = run("emit", "c", "functions.power", "--error", "1e-6", "--let", "x=0:1")
    assert done.exit_code == 1
    assert "functions.py:1: ZeroDivisionError" in "".join(done.output.split("\n"))
