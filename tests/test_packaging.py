"""What is installed: every package of the three folders, and the data in them."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tarfile
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).parents[1]
FOLDERS = {
    "src/mechproof": "mechproof",
    "generated": "mechproof/kernels",
    "derivations": "mechproof/derivations",
}
DATA = (
    *("*.tex", "*.txt", "templates/*", "measured/*.json", "certificates/*.json", "py.typed"),
    *("*.schema.json", "font/*", "*.v", "coq.json"),
)
BUILD = "import sys; from setuptools import build_meta as b; getattr(b, sys.argv[1])(sys.argv[2])"


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the sources with one more paper, and the distributions built from it."""
    folder = tmp_path_factory.mktemp("tree")
    for name in ("pyproject.toml", "setup.py", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, folder)
    ignore = shutil.ignore_patterns("__pycache__", "*.egg-info", "quick")
    for name in FOLDERS:
        shutil.copytree(ROOT / name, folder / name, ignore=ignore)
    for name in ("__init__.py", "parts/__init__.py", "parts/rows.py"):
        (folder / "derivations" / "new_paper" / name).parent.mkdir(exist_ok=True)
        (folder / "derivations" / "new_paper" / name).write_text("")
    for kind in ("wheel", "sdist", "editable"):
        target = folder / "built" / kind
        target.mkdir(parents=True)
        command = [sys.executable, "-c", BUILD, f"build_{kind}", str(target)]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    return folder


def list_installed(tree: Path) -> dict[str, str]:
    """Map the installed path of every file to its path in the sources."""
    found = {}
    for folder, package in FOLDERS.items():
        kinds = ("*.py", "*.pyi", *DATA)
        for path in (p for kind in kinds for p in (tree / folder).rglob(kind)):
            inner = path.relative_to(tree / folder).as_posix()
            found[f"{package}/{inner}"] = f"{folder}/{inner}"
    return found


@pytest.mark.slow
def test_a_wheel_has_every_package_and_its_data(tree: Path) -> None:
    (wheel,) = (tree / "built" / "wheel").iterdir()
    names = {name for name in ZipFile(wheel).namelist() if ".dist-info/" not in name}
    assert names == set(list_installed(tree))
    assert "mechproof/derivations/new_paper/parts/rows.py" in names


@pytest.mark.slow
def test_the_sources_have_all_that_is_installed(tree: Path) -> None:
    (archive,) = (tree / "built" / "sdist").iterdir()
    with tarfile.open(archive) as found:
        names = {name.partition("/")[2] for name in found.getnames()}
    assert {"setup.py", "pyproject.toml", *list_installed(tree).values()} <= names


@pytest.mark.slow
def test_an_editable_install_finds_the_three_folders(tree: Path) -> None:
    (wheel,) = (tree / "built" / "editable").iterdir()
    with ZipFile(wheel) as found:
        finders = [name for name in found.namelist() if name.endswith("finder.py")]
        text = "".join(found.read(name).decode() for name in finders)
    assert all(str(tree / folder) in text for folder in FOLDERS)
