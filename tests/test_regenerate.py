"""Comparing and writing the generated package."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

import pytest

from mechproof.codegen.regenerate import compare_or_update, render_package
from mechproof.derivations import elliptic_planetary
from mechproof.record import Paper

FILES = {"__init__.py": "", "a.py": "x = 1\ny = 2\n", "LEDGER.md": "# Ledger\n"}


def contents(folder: Path) -> dict[str, str]:
    return {p.name: p.read_text() for p in folder.iterdir() if p.is_file()}


def test_update_writes_and_check_is_then_silent(tmp_path: Path) -> None:
    target = tmp_path / "generated"
    assert len(compare_or_update(target, FILES, check=False)) == len(FILES)
    assert contents(target) == FILES
    assert compare_or_update(target, FILES, check=True) == []
    assert compare_or_update(target, FILES, check=False) == []


def test_check_names_every_difference_and_the_repair(tmp_path: Path) -> None:
    compare_or_update(tmp_path, FILES, check=False)
    (tmp_path / "a.py").write_text("x = 1\ny = 3\n")
    (tmp_path / "LEDGER.md").unlink()
    (tmp_path / "old.py").write_text("gone = True\n")
    before = contents(tmp_path)
    missing, different, surplus, repair = compare_or_update(tmp_path, FILES, check=True)
    assert missing.startswith("missing: LEDGER.md")
    assert different.startswith("different: a.py")
    assert "-y = 3\n+y = 2\n" in different
    assert surplus.startswith("surplus: old.py")
    assert "-gone = True" in surplus
    assert "mechproof regenerate" in repair
    assert contents(tmp_path) == before
    compare_or_update(tmp_path, FILES, check=False)
    assert contents(tmp_path) == FILES


def test_line_ends_and_encodings_are_differences(tmp_path: Path) -> None:
    compare_or_update(tmp_path, FILES, check=False)
    for wrong in (b"x = 1\r\ny = 2\r\n", b"x = 1\ny = 2\n\xff"):
        (tmp_path / "a.py").write_bytes(wrong)
        assert len(compare_or_update(tmp_path, FILES, check=True)) == 2


@pytest.mark.parametrize("folder", ["measured", "compiled", "__pycache__"])
def test_foreign_folders_are_left_alone(tmp_path: Path, folder: str) -> None:
    compare_or_update(tmp_path, FILES, check=False)
    (tmp_path / folder).mkdir()
    (tmp_path / folder / "kept").write_text("kept")
    assert compare_or_update(tmp_path, FILES, check=True) == []
    compare_or_update(tmp_path, FILES, check=False)
    assert (tmp_path / folder / "kept").exists()


def test_interrupted_write_leaves_the_old_files_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compare_or_update(tmp_path, FILES, check=False)
    write, calls = Path.write_text, []

    def fail_on_second(self: Path, *args: object, **kwargs: object) -> int:
        calls.append(self)
        if len(calls) == 2:
            raise OSError("no space left")
        return write(self, *args, **kwargs)  # type: ignore[arg-type]

    changed = {name: text + "# new\n" for name, text in FILES.items()}
    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_text", fail_on_second)
        with pytest.raises(OSError, match="no space left"):
            compare_or_update(tmp_path, changed, check=False)
    assert contents(tmp_path) == FILES
    assert compare_or_update(tmp_path, FILES, check=True) == []


def test_interrupted_placing_leaves_each_file_old_or_new(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compare_or_update(tmp_path, FILES, check=False)
    replace, calls = os.replace, []

    def fail_on_second(source: Path, target: Path) -> None:
        calls.append(target)
        if len(calls) == 2:
            raise KeyboardInterrupt
        replace(source, target)

    changed = {name: text + "# new\n" for name, text in FILES.items()}
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", fail_on_second)
        with pytest.raises(KeyboardInterrupt):
            compare_or_update(tmp_path, changed, check=False)
    present = contents(tmp_path)
    assert set(present) == set(FILES)
    assert all(text in (FILES[name], changed[name]) for name, text in present.items())


def test_package_has_one_module_per_system_with_quantities() -> None:
    paper = dataclasses.replace(elliptic_planetary.PAPER, system="system")
    bare = Paper("bare", "", (), ())
    files = render_package([paper, bare])
    assert set(files) == {"__init__.py", "system.py"}
    assert all(text.endswith("\n") for text in files.values())
