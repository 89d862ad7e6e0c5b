"""What an import costs, and that the layers keep to theirs."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import mechproof
from mechproof import kernel_support, kernels

HEAVY = ("sympy", "jinja2", "flint", "matplotlib", "numba", "scipy")

PROBES = {
    "package": "import mechproof; mechproof.__version__",
    "kernel": "from mechproof.kernels import elliptic_planetary as k; k.position(1.0, 66, 16, 0.4)",
    "planetary": "import mechproof; mechproof.EllipticPlanetary(66, 16, 0.4).ratio(1.0)",
    "wheel": "import mechproof; mechproof.TrackWheel(41.5, 3.75, 6, 20).planar_error(1.0)",
}


def loaded_after(code: str) -> set[str]:
    done = subprocess.run(
        [sys.executable, "-c", f"{code}\nimport sys; print(*sys.modules)"],
        capture_output=True,
        text=True,
        check=True,
    )
    return {name.partition(".")[0] for name in done.stdout.split()}


@pytest.mark.parametrize("name", PROBES)
def test_runtime_loads_nothing_heavy(name: str) -> None:
    assert loaded_after(PROBES[name]).isdisjoint(HEAVY)


def test_package_itself_loads_no_numpy() -> None:
    assert "numpy" not in loaded_after("import mechproof")


def test_the_probe_sees_a_heavy_import() -> None:
    assert "sympy" in loaded_after("import mechproof.record")


def imported(path: Path) -> set[str]:
    """Packages a file imports anywhere, of our own the first two names."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(f"{'.' * node.level}{node.module or ''}")
    return {".".join(name.split(".")[: 2 if name.startswith("mechproof") else 1]) for name in names}


def test_kernels_import_numpy_and_their_support_alone() -> None:
    for path in Path(kernels.__path__[0]).glob("*.py"):
        assert imported(path) <= {"numpy", "typing", "mechproof.kernel_support"}, path.name


def test_the_support_of_kernels_imports_numpy_alone() -> None:
    allowed = {"__future__", "math", "numpy", "typing"}
    for path in Path(kernel_support.__path__[0]).glob("*.py"):
        assert imported(path) <= allowed, path.name


def test_public_names() -> None:
    assert set(mechproof.__all__) <= set(dir(mechproof))
    assert mechproof.EllipticPlanetary.__module__ == "mechproof.elliptic_planetary"
    with pytest.raises(AttributeError, match="no attribute 'Gearbox'"):
        _ = mechproof.Gearbox
