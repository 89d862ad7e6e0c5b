"""Types of kernels as checkers see them: stubs state what functions take and return."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from mechproof import kernels

ROOT = Path(__file__).parents[2]
GENERATED = ROOT / "generated"
STUBS = sorted(file.relative_to(GENERATED).with_suffix("") for file in GENERATED.rglob("*.pyi"))
PREAMBLE = """
import numpy as np
from numpy.typing import NDArray

from changed import position as changed
from mechproof import EllipticPlanetary, ToothThickness, TrackWheel, WedgeLinkage
from mechproof.kernels import elliptic_planetary, oval_planetary, track_wheel
from mechproof.kernels.compiled import elliptic_planetary as compiled
from mechproof.kernels.derivatives import elliptic_planetary as derivatives

angles: NDArray[np.float64] = np.linspace(0, 1, 6).reshape(2, 3)
drive, wedge = EllipticPlanetary(60, 20, 0.3), WedgeLinkage.published(1)
tooth, wheel = ToothThickness.published(), TrackWheel(60, 0.3, 8, 20)
"""
NUMBER, ARRAY, ANY = "float64", "ndarray[float64]", "Any"
SOME_ARRAY = "ndarray[Any]"
REVEALED = {
    "elliptic_planetary.position(0.3, 60, 20, e=0.3)": NUMBER,
    "elliptic_planetary.position(angles, R1=60, R2=20, e=0.3)": ARRAY,
    "elliptic_planetary.position(1, 60, 20, angles)": ARRAY,
    "elliptic_planetary.position([0.3, 1], 60, 20, 0.3)": ANY,
    "elliptic_planetary.position(angles, 60, 20, 0.3, out=angles)": ANY,
    "elliptic_planetary.largest_ratio(60, 20, 0.3)": NUMBER,
    "oval_planetary.position(angles, 0.1, 0.2)": ARRAY,
    "track_wheel.planar_error(angles)": ANY,
    "track_wheel.track(0.3, 60, 0.3, 8, 20)": SOME_ARRAY,
    "compiled.position(0.3, 60, 20, 0.3)": NUMBER,
    "compiled.position(angles, 60, 20, 0.3)": ARRAY,
    "compiled.motion(0.3, 60, 20, 0.3)": SOME_ARRAY,
    "derivatives.position(0.3, 60, 20, 0.3)": SOME_ARRAY,
    "drive.position(0.3)": NUMBER,
    "drive.ratio(angles, degrees=True)": ARRAY,
    "drive.jerk([0.3, 1])": ANY,
    "drive.position(phi1=angles)": ANY,
    "drive.carrier_angle(90, degrees=True)": NUMBER,
    "drive.carrier_angle(angles)": ARRAY,
    "wheel.radius(angles)": ARRAY,
    "wheel.normal_error(0.3)": NUMBER,
    "wheel.rotation()": ARRAY,
    "wedge.position(-20)": NUMBER,
    "wedge.velocity(angles)": ARRAY,
    "tooth.thickness_change(angles)": ARRAY,
    "tooth.constant_chord": NUMBER,
}
# With a stub in which a number gives `Any`.
REVEALED_OF_CHANGED = {"changed(0.3, 60, 20, 0.3)": NUMBER}
REFUSED = (
    "elliptic_planetary.position(0.3, 60, 20)",
    "elliptic_planetary.position(0.3, 60, 20, f=0.3)",
    "elliptic_planetary.position(None, 60, 20, 0.3)",
    "elliptic_planetary.position(0.3, 60, 20, 0.3).append(1)",
    "drive.position(0.3).append(1)",
    "drive.position(0.3, f=1)",
    "drive.position(phi3=0.3)",
    "wedge.position(-20, degrees=True)",
)


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Return mypy's line for each use: the revealed type or an error."""
    folder = tmp_path_factory.mktemp("types")
    (folder / "mechproof").mkdir()
    for name in ("__init__.py", "kernel_support", "arguments", "mechanisms"):
        (folder / "mechproof" / name).symlink_to(ROOT / "src" / "mechproof" / name)
    (folder / "mechproof" / "kernels").symlink_to(GENERATED)
    stub = (GENERATED / "elliptic_planetary.pyi").read_text()
    (folder / "changed.pyi").write_text(stub.replace("-> _float64", "-> Any"))
    shown = [f"reveal_type({use})" for use in (*REVEALED, *REVEALED_OF_CHANGED)]
    (folder / "use.py").write_text("\n".join([PREAMBLE, *shown, *REFUSED]))
    command = [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "use.py"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert not done.stderr
    lines = done.stdout.splitlines()
    kinds = r"note: Revealed type is|error:"
    return [line for line in lines if re.match(rf"use\.py:\d+: ({kinds})", line)]


def shorten(line: str) -> str:
    """Return the type that mypy reveals, abbreviated as above; empty for an error."""
    found = re.search(r'Revealed type is "(.*)"', line)
    if found is None:
        return ""
    array = re.fullmatch(r"numpy\.ndarray\[.*numpy\.dtype\[(.*)\]\]", found[1])
    name = f"ndarray[{array[1]}]" if array else found[1]
    return name.replace("numpy.", "")


@pytest.mark.slow
def test_checkers_see_what_numbers_and_arrays_give(found: list[str]) -> None:
    assert list(map(shorten, found[: len(REVEALED)])) == list(REVEALED.values())


@pytest.mark.slow
def test_another_stub_would_be_seen(found: list[str]) -> None:
    (line,) = found[len(REVEALED) : len(REVEALED) + 1]
    assert [shorten(line)] != list(REVEALED_OF_CHANGED.values())


@pytest.mark.slow
def test_checkers_refuse_other_arguments_and_wrong_use_of_results(found: list[str]) -> None:
    rest = found[len(REVEALED) + len(REVEALED_OF_CHANGED) :]
    assert all("error:" in line for line in rest)
    assert len({line.split(":")[1] for line in rest}) == len(REFUSED)


@pytest.mark.parametrize("use", REVEALED)
def test_results_are_of_the_type_that_is_told(use: str) -> None:
    names: dict[str, object] = {}
    exec(PREAMBLE.replace("from changed import position as changed", ""), names)
    result = eval(use, names)
    told = REVEALED[use]
    if told == NUMBER:
        assert type(result) is np.float64
    elif told != ANY:
        assert type(result) is np.ndarray
        assert result.dtype == np.float64


def list_arguments(stub: str) -> list[tuple[str, list[str]]]:
    """List a stub's functions, once for each overload, with the names of their arguments."""
    functions = [part for part in ast.parse(stub).body if isinstance(part, ast.FunctionDef)]
    return [(f.name, [a.arg for a in (*f.args.args, *f.args.kwonlyargs)]) for f in functions]


def list_wrong(module: ModuleType, stub: str) -> set[str]:
    """Return the stub's functions whose arguments differ from those in the module."""
    return {
        name
        for name, told in list_arguments(stub)
        if told not in (own := [*inspect.signature(getattr(module, name)).parameters], own[:-1])
    }


def load(stub: Path) -> ModuleType:
    return importlib.import_module(f"{kernels.__name__}.{'.'.join(stub.parts)}")


@pytest.mark.parametrize("stub", STUBS, ids=str)
def test_stubs_have_the_functions_of_their_modules_with_their_arguments(stub: Path) -> None:
    text, module = (GENERATED / stub).with_suffix(".pyi").read_text(), load(stub)
    beside = () if len(stub.parts) == 1 else load(Path(stub.name)).__all__
    assert {*dict(list_arguments(text)), *beside} == {*module.__all__}
    assert not list_wrong(module, text)


def test_arguments_in_another_order_are_seen() -> None:
    module = load(Path("elliptic_planetary"))
    assert list_wrong(module, "def ratio(phi1, R2, R1, e): ...") == {"ratio"}
    assert not list_wrong(module, "def ratio(phi1, R1, R2, e): ...")
