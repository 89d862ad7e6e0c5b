"""One name, one thing: no two modules, packages or public classes of the package share a name."""

from __future__ import annotations

import re
import shutil
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

import mechproof

PACKAGE = Path(mechproof.__path__[0])
# A system has the same name in both folders, which an installed package contains.
SYSTEMS = ("kernels/", "derivations/")
PUBLIC_CLASS = re.compile(r"^class ([A-Za-z]\w*)", re.MULTILINE)


def list_names(package: Path) -> Iterator[tuple[str, str]]:
    """Yield the names of modules, packages and public classes, each with its file."""
    for path in package.rglob("*.py"):
        place = path.relative_to(package).as_posix()
        if place.startswith(SYSTEMS):
            continue
        yield path.parent.name if path.stem == "__init__" else path.stem, place
        for name in PUBLIC_CLASS.findall(path.read_text(encoding="utf-8")):
            yield name, place


def find_twins(package: Path) -> Mapping[str, set[str]]:
    """Return the names that stand for several things, each with the files of these."""
    places = defaultdict(list)
    for name, place in list_names(package):
        places[name].append(place)
    return {name: set(found) for name, found in places.items() if len(found) > 1}


def test_every_name_stands_for_one_thing() -> None:
    assert find_twins(PACKAGE) == {}


@pytest.mark.parametrize(
    ("place", "text", "name", "beside"),
    [
        ("proof/read_as.py", "", "read_as", "latex/read_as.py"),
        ("latex/deeper/read_as.py", "", "read_as", "latex/read_as.py"),
        ("proof/arithmetic.py", "", "arithmetic", "arithmetic/__init__.py"),
        ("proof/latex/__init__.py", "", "latex", "latex/__init__.py"),
        ("proof/fresh.py", "class Reading: ...", "Reading", "latex/read_as.py"),
    ],
)
def test_a_name_that_stands_twice_is_seen(
    place: str, text: str, name: str, beside: str, tmp_path: Path
) -> None:
    for folder in ("latex", "proof", "arithmetic"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "__init__.py").touch()
    (tmp_path / "latex/read_as.py").write_text("class Reading: ...\nclass _Own: ...\n")
    (tmp_path / "proof/ladder.py").write_text("class _Own: ...\n    # class Reading\n")
    assert find_twins(tmp_path) == {}
    (tmp_path / place).parent.mkdir(exist_ok=True)
    (tmp_path / place).write_text(text)
    assert find_twins(tmp_path) == {name: {place, beside}}


def test_a_copied_module_is_seen(tmp_path: Path) -> None:
    copy = shutil.copytree(PACKAGE, tmp_path / "copy", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(copy / "latex" / "numerals.py", copy / "proof" / "numerals.py")
    assert {"latex/numerals.py", "proof/numerals.py"} == find_twins(copy)["numerals"]
