"""Ledgers cached as a whole: what causes one to be made again, and what is never cached."""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path
from types import ModuleType

import pytest
from weights import first_of

from mechproof.derivation import DerivationError
from mechproof.pipeline import ledger_cache, verification
from mechproof.pipeline.ledger_cache import LedgerCache
from mechproof.pipeline.verification import find_ledgers
from mechproof.proof.verdict import Verdict
from mechproof.tools.cache import HERE, VARIABLE, _find_helpers, list_program

HEAD = """
import os, sys, time
from pathlib import Path
from sympy import S, Function, cos, sin, symbols
from mechproof.record import *
x, y = symbols("x y", real=True)
class Own(Function):
    pass
HERE = Path(__file__).parent
def paper(right, name="mine"):
    variables = (Variable(x, "a number"), Variable(y, "another"))
    row = Equation("(1)", "1", Equality((x + y)**2, right))
    return Paper(name, "my notes", variables, (row,))
"""
TRUE, FALSE = "x**2 + 2*x*y + y**2", "x**2 + 3*x*y + y**2"


class Folder:
    """A folder with one derivation; `was_loaded` says whether the last judging loaded it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.file = path / "mine.py"
        self.was_loaded = False

    def write(self, text: str, name: str = "mine.py") -> None:
        file = self.path / name
        file.write_text(text, encoding="utf-8")
        # A file as recent as the load itself is not cached.
        before = time.time() - 10
        os.utime(file, (before, before))

    def judge(self) -> Verdict:
        said: list[str] = []
        (ledger,) = find_ledgers([self.file], limit=20.0, report=said.append)
        self.was_loaded = any(text.startswith("loading") for text in said)
        (row,) = ledger.judgements
        return row.verdict


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Folder:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    monkeypatch.syspath_prepend(tmp_path)
    return Folder(tmp_path)


def test_what_has_not_changed_is_not_loaded_again(folder: Folder) -> None:
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n")
    (first,) = find_ledgers([folder.file])
    (again,) = find_ledgers([folder.file])
    assert folder.judge() is Verdict.PROVED
    assert not folder.was_loaded
    assert again.judgements == first.judgements
    assert (again.system, again.citation) == (first.system, first.citation)
    assert (again.findings, again.shipped) == (first.findings, first.shipped)
    find_ledgers([folder.file], use_cache=False, report=(said := []).append)
    assert said[0].startswith("loading")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "text", "use"),
    [
        ("other.py", "", "RIGHT"),
        ("_shared.py", "right = 'RIGHT'", "read(__import__('importlib').import_module("
         "'._shared', __package__).right)"),
        ("data.txt", "RIGHT", "read((HERE / 'data.txt').read_text())"),
    ],
)  # fmt: skip
def test_whatever_a_derivation_opens_counts(folder: Folder, file: str, text: str, use: str) -> None:
    reader = "read = lambda text: __import__('sympy').sympify(text, {'x': x, 'y': y})"
    for right, verdict in ((TRUE, Verdict.PROVED), (FALSE, Verdict.REFUTED)):
        folder.write(text.replace("RIGHT", right), file)
        folder.write(f"{HEAD}\n{reader}\nPAPER = paper({use.replace('RIGHT', right)})\n")
        assert folder.judge() is verdict
        assert folder.was_loaded
        assert folder.judge() is verdict
        assert not folder.was_loaded


def test_a_module_that_another_derivation_loaded_counts(folder: Folder) -> None:
    """It is not opened again: its content counts as it was when the module was loaded."""
    folder.write("FACTOR = 2", "helper_of_two_papers.py")
    use = "import helper_of_two_papers as h\n"
    text = f"{HEAD}{use}\nPAPER = paper(x**2 + h.FACTOR*x*y + y**2, 'NAME')\n"
    folder.write(text.replace("NAME", "other"), "other.py")
    folder.write(text.replace("NAME", "mine"))
    find_ledgers([folder.path / "other.py"])
    assert folder.judge() is Verdict.PROVED
    (kept,) = json.loads(LedgerCache(folder.file).store.file.read_bytes()).values()
    assert str(folder.path / "helper_of_two_papers.py") in kept["read"]
    folder.write("FACTOR = 3", "helper_of_two_papers.py")
    folder.judge()
    assert folder.was_loaded


def test_a_module_under_the_name_of_a_library_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A library of that name had been loaded from a folder of installed packages."""
    for folder in ("site-packages", "own"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "shadowed.py").touch()
        one = ModuleType("shadowed")
        one.__file__ = str(tmp_path / folder / "shadowed.py")
        monkeypatch.setitem(sys.modules, "shadowed", one)
        found = {path.parent.name for path in _find_helpers() if path.stem == "shadowed"}
        assert found == {folder} - {"site-packages"}


def test_another_program_or_another_version_counts(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n")
    folder.judge()
    monkeypatch.setattr(ledger_cache, "digest_program", lambda: "another")
    folder.judge()
    assert folder.was_loaded


def test_the_program_is_all_of_the_package_but_papers_and_kernels() -> None:
    files = {path.relative_to(HERE).as_posix() for path in list_program()}
    assert {
        "latex/expansion.py",
        "codegen/templates/numpy_module.py.jinja",
        "tools/cache.py",
    } <= files
    assert not [name for name in files if name.startswith(("derivations/", "kernels/"))]


def test_a_file_that_is_gone_counts(folder: Folder) -> None:
    folder.write("", "data.txt")
    folder.write(f"{HEAD}\nopen(HERE / 'data.txt').close()\nPAPER = paper({TRUE})\n")
    folder.judge()
    (folder.path / "data.txt").unlink()
    with pytest.raises(DerivationError, match=r"data\.txt"):
        folder.judge()


@pytest.mark.parametrize(
    "text",
    [
        f"Path(__file__).write_text(Path(__file__).read_text())\nPAPER = paper({TRUE})\n",
        "PAPER = paper(Own(x))\n",
    ],
    ids=["written while it is loaded", "a row without a key"],
)
def test_what_may_be_another_next_time_is_not_kept(folder: Folder, text: str) -> None:
    folder.write(f"{HEAD}\n{text}")
    folder.judge()
    folder.judge()
    assert folder.was_loaded


def test_a_failure_is_not_kept(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n")

    def fail(*row: object) -> None:
        raise RuntimeError("no memory")

    with monkeypatch.context() as patch:
        patch.setattr(verification, "judge", fail)
        (ledger,) = find_ledgers([folder.file])
    assert ledger.failures
    assert folder.judge() is Verdict.PROVED


@pytest.mark.parametrize("text", first_of([b"", b"{", b"[]", b"null", b'{"program": 1}', b"\xff"]))
def test_a_file_that_cannot_be_read_is_as_good_as_absent(folder: Folder, text: bytes) -> None:
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n")
    folder.judge()
    file = LedgerCache(folder.file).store.file
    good = file.read_bytes()
    file.write_bytes(text)
    assert folder.judge() is Verdict.PROVED
    assert folder.was_loaded
    assert file.read_bytes() == good


def test_a_row_that_cannot_be_read_is_judged_anew(folder: Folder) -> None:
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n")
    folder.judge()
    file = LedgerCache(folder.file).store.file
    kept = json.loads(file.read_bytes())
    (entry,) = kept.values()
    entry["ledger"]["judgements"][0]["verdict"] = "TRUE"
    file.write_text(json.dumps(kept))
    assert folder.judge() is Verdict.PROVED
    assert folder.was_loaded


def test_a_kept_paper_and_a_new_one_may_not_have_one_name(folder: Folder) -> None:
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n")
    folder.judge()
    folder.write(f"{HEAD}\nPAPER = paper({TRUE})\n", "other.py")
    with pytest.raises(DerivationError, match=r"has the same name as that of .*'mine'"):
        find_ledgers([folder.file, folder.path / "other.py"])
