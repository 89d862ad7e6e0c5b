"""Comparing and writing the generated package."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Mapping
from pathlib import Path

import pytest

from mechproof.codegen.regenerate import (
    STAMP,
    Change,
    ForeignFileError,
    compare_files,
    render_package,
    update_files,
)
from mechproof.derivations import elliptic_planetary
from mechproof.record import Paper

HEAD = '"""Kernels.\n\nRegenerate with `mechproof regenerate`; edits are overwritten.\n"""\n'
FILES = {
    "__init__.py": HEAD,
    "a.py": f"{HEAD}x = 1\ny = 2\n",
    "forms/a.py": f"{HEAD}z = 1\n",
    "LEDGER.md": "# Ledger\n",
}


def update(folder: Path, files: Mapping[str, str]) -> list[Change]:
    changes = compare_files(folder, files)
    update_files(folder, changes)
    return changes


def contents(folder: Path) -> dict[str, str]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_text() for path in files}


def test_update_writes_and_there_is_then_no_difference(tmp_path: Path) -> None:
    target = tmp_path / "generated"
    assert [change.name for change in update(target, FILES)] == sorted(FILES)
    assert contents(target) == FILES
    assert compare_files(target, FILES) == []


def test_every_difference_is_named(tmp_path: Path) -> None:
    update(tmp_path, FILES)
    (tmp_path / "a.py").write_text(f"{HEAD}x = 1\ny = 3\n")
    (tmp_path / "LEDGER.md").unlink()
    (tmp_path / "old.py").write_text(f"{HEAD}gone = True\n")
    before = contents(tmp_path)
    missing, different, surplus = (c.describe() for c in compare_files(tmp_path, FILES))
    assert missing.startswith("missing: LEDGER.md")
    assert different.startswith("different: a.py")
    assert "-y = 3\n+y = 2\n" in different
    assert surplus.startswith("surplus: old.py")
    assert "-gone = True" in surplus
    assert contents(tmp_path) == before
    assert [c.name for c in update(tmp_path, FILES) if c.is_removal] == ["old.py"]
    assert contents(tmp_path) == FILES


def test_line_ends_and_encodings_are_differences(tmp_path: Path) -> None:
    update(tmp_path, FILES)
    text = FILES["a.py"].encode()
    for wrong in (text.replace(b"\n", b"\r\n"), text + b"\xff"):
        (tmp_path / "a.py").write_bytes(wrong)
        assert len(compare_files(tmp_path, FILES)) == 1


@pytest.mark.parametrize(
    "name",
    [
        "notes.txt",
        "helper.py",
        "forms/helper.py",
        "measured/record.json",
        "compiled/native.so",
        "__pycache__/a.pyc",
        ".git/config",
    ],
)
def test_what_was_not_generated_is_left_alone(tmp_path: Path, name: str) -> None:
    update(tmp_path, FILES)
    file = tmp_path / name
    file.parent.mkdir(exist_ok=True)
    file.write_text("made_by = 'hand'\n")
    assert compare_files(tmp_path, FILES) == []
    update(tmp_path, {})
    assert contents(tmp_path) == {name: "made_by = 'hand'\n"}


def test_a_folder_whose_files_are_removed_goes_with_them(tmp_path: Path) -> None:
    update(tmp_path, FILES)
    update(tmp_path, {name: text for name, text in FILES.items() if "/" not in name})
    assert not (tmp_path / "forms").exists()


@pytest.mark.parametrize("name", ["a.py", "forms/a.py"])
def test_a_name_taken_by_a_foreign_file_is_refused(tmp_path: Path, name: str) -> None:
    file = tmp_path / name
    file.parent.mkdir(exist_ok=True)
    file.write_text("made_by = 'hand'\n")
    with pytest.raises(ForeignFileError, match=rf"{name}: .* move it away or delete it"):
        compare_files(tmp_path, FILES)
    file.write_text("\n")  # nothing to lose
    update(tmp_path, FILES)
    assert contents(tmp_path) == FILES


def test_interrupted_write_leaves_the_old_files_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    update(tmp_path, FILES)
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
            update(tmp_path, changed)
    assert contents(tmp_path) == FILES
    assert compare_files(tmp_path, FILES) == []


def test_interrupted_placing_leaves_each_file_old_or_new(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    update(tmp_path, FILES)
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
            update(tmp_path, changed)
    present = contents(tmp_path)
    assert set(present) == set(FILES)
    assert all(text in (FILES[name], changed[name]) for name, text in present.items())


def test_package_has_modules_for_systems_with_forms_and_no_others() -> None:
    paper = dataclasses.replace(elliptic_planetary.PAPER, system="system")
    bare = Paper("bare", "", (), ())
    files = render_package([paper, bare])
    folders = ("", "forms/", "compiled/")
    assert set(files) == {f"{d}{n}.py" for d in folders for n in ("__init__", "system")}
    assert all(text.endswith("\n") and STAMP.search(text) for text in files.values())
    own = render_package([paper, bare], is_own=True)
    assert set(own) - set(files) == {"compiled/elementary.py"}
    assert STAMP.search(own["compiled/elementary.py"])
