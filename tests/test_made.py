"""Comparing and writing folders of made files: only files that were made are removed."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path

import pytest

from mechproof.tools.made import STAGED, Change, ForeignFileError, Made

LIST = "made.sha256"
FILES = {
    "__init__.py": "",
    "a.py": "x = 1\ny = 2\n",
    "forms/a.py": "z = 1\n",
    "certificates/a.json": "{}\n",
    "LEDGER.md": "# Ledger\n",
}
EDITED = "made_by = 'hand'\n"


def compare(folder: Path, files: Mapping[str, str] = FILES) -> list[Change]:
    return Made(folder, LIST).compare(files)


def update(folder: Path, files: Mapping[str, str] = FILES) -> list[Change]:
    return Made(folder, LIST).update(files)


def contents(folder: Path) -> dict[str, str]:
    files = (path for path in folder.rglob("*") if path.is_file() and path.name != LIST)
    return {path.relative_to(folder).as_posix(): path.read_text() for path in files}


def write(folder: Path, files: Mapping[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def test_update_writes_and_there_is_then_no_difference(tmp_path: Path) -> None:
    target = tmp_path / "generated"
    assert [change.name for change in update(target)] == sorted(FILES)
    assert contents(target) == FILES
    assert compare(target) == []
    assert update(target) == []


def test_the_list_is_one_that_sha256sum_reads(tmp_path: Path) -> None:
    update(tmp_path)
    digests = {name: sha256(text.encode()).hexdigest() for name, text in FILES.items()}
    lines = [f"{digests[name]}  {name}\n" for name in sorted(FILES)]
    assert (tmp_path / LIST).read_text() == "".join(lines)


def test_every_difference_is_named(tmp_path: Path) -> None:
    update(tmp_path, {**FILES, "old.py": "gone = True\n", "a.py": "x = 1\ny = 3\n"})
    (tmp_path / "LEDGER.md").unlink()
    before = contents(tmp_path)
    missing, different, listed, surplus = (c.describe() for c in compare(tmp_path))
    assert missing.startswith("missing: LEDGER.md\n")
    assert different.startswith("different: a.py\n")
    assert "-y = 3\n+y = 2\n" in different
    assert listed.startswith(f"different: {LIST}\n")
    assert surplus.startswith("surplus: old.py\n")
    assert "-gone = True" in surplus
    assert contents(tmp_path) == before
    assert [c.name for c in update(tmp_path) if c.is_removal] == ["old.py"]
    assert contents(tmp_path) == FILES


def test_line_ends_and_encodings_are_differences(tmp_path: Path) -> None:
    update(tmp_path)
    text = FILES["a.py"].encode()
    for wrong in (text.replace(b"\n", b"\r\n"), text + b"\xff"):
        (tmp_path / "a.py").write_bytes(wrong)
        assert [change.name for change in compare(tmp_path)] == ["a.py"]


@pytest.mark.parametrize(
    "name",
    [
        "notes.txt",
        "helper.py",
        "my_variant.py",
        "backup/before_tuning.py",
        "certificates/other.json",
        "measured/TABLES.md",
        "ledger.json",
        "compiled/native.so",
        "__pycache__/a.pyc",
        ".git/config",
    ],
)
@pytest.mark.parametrize("text", [EDITED, FILES["a.py"]], ids=["foreign", "a copy"])
def test_what_was_not_made_is_left_alone(tmp_path: Path, name: str, text: str) -> None:
    update(tmp_path)
    write(tmp_path, {name: text})
    assert compare(tmp_path) == []
    update(tmp_path, {})
    assert contents(tmp_path) == {name: text}


@pytest.mark.parametrize("name", FILES)
def test_what_was_edited_is_not_removed(tmp_path: Path, name: str) -> None:
    update(tmp_path)
    write(tmp_path, {name: EDITED})
    update(tmp_path, {})
    assert contents(tmp_path) == {name: EDITED}


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("is_listed", [True, False])
def test_what_was_edited_or_is_foreign_is_shown_and_not_replaced(
    tmp_path: Path, name: str, is_listed: bool
) -> None:
    if is_listed:
        update(tmp_path)
    write(tmp_path, {name: EDITED})
    before = contents(tmp_path)
    shown = {change.name: change.describe() for change in compare(tmp_path)}
    assert shown[name].startswith(f"different: {name} (edited, or not made by mechproof)\n")
    with pytest.raises(ForeignFileError, match=rf"{name}: .* move it away or delete it"):
        update(tmp_path, {**FILES, "new.py": "1\n"})
    assert contents(tmp_path) == before
    (tmp_path / name).write_text("\n")  # nothing to lose
    update(tmp_path)
    assert contents(tmp_path) == FILES


def test_all_that_is_in_the_way_is_named(tmp_path: Path) -> None:
    write(tmp_path, {"a.py": EDITED, "LEDGER.md/notes.txt": EDITED})
    with pytest.raises(ForeignFileError, match=r"LEDGER\.md, .*a\.py: "):
        update(tmp_path)


def test_a_tree_without_a_list_that_is_as_it_should_be_is_taken_over(tmp_path: Path) -> None:
    write(tmp_path, FILES)
    assert [change.name for change in compare(tmp_path)] == [LIST]
    assert update(tmp_path) == []
    assert compare(tmp_path) == []


@pytest.mark.parametrize(
    "line", ["", "a.py", f"{64 * '0'}  ../a.py", f"{64 * '0'}  /a.py", f"{64 * '0'}  a\\b", "\xff"]
)
def test_what_is_no_list_is_refused(tmp_path: Path, line: str) -> None:
    update(tmp_path)
    (tmp_path / LIST).write_text(f"{line}\n", encoding="latin-1")
    for act in (compare, update):
        with pytest.raises(ForeignFileError, match=f"{LIST}: is not a list"):
            act(tmp_path)


def test_a_folder_whose_files_are_removed_goes_with_them(tmp_path: Path) -> None:
    update(tmp_path)
    update(tmp_path, {name: text for name, text in FILES.items() if "/" not in name})
    assert not (tmp_path / "forms").exists()


def test_one_file_of_a_folder_is_replaced_and_the_others_stay_listed(tmp_path: Path) -> None:
    update(tmp_path)
    made, page = Made(tmp_path, LIST), {"a.py": "x = 2\n"}
    assert [change.name for change in made.update(page, and_remove=False)] == ["a.py"]
    assert contents(tmp_path) == {**FILES, **page}
    assert compare(tmp_path, {**FILES, **page}) == []


def test_interrupted_write_leaves_the_old_files_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    update(tmp_path)
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
    assert compare(tmp_path) == []


# One replacement for the list, one for each file, one for the list again.
@pytest.mark.parametrize("number", range(len(FILES) + 2))
def test_interrupted_placing_leaves_each_file_old_or_new(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    update(tmp_path)
    replace, calls = os.replace, []

    def fail(source: Path, target: Path) -> None:
        calls.append(target)
        if len(calls) == number + 1:
            raise KeyboardInterrupt
        replace(source, target)

    changed = {name: text + "# new\n" for name, text in FILES.items()}
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", fail)
        with pytest.raises(KeyboardInterrupt):
            update(tmp_path, changed)
    present = contents(tmp_path)
    assert set(present) == set(FILES)
    assert all(text in (FILES[name], changed[name]) for name, text in present.items())
    # The remains do not block a third version, and they are cleaned up.
    update(tmp_path, {name: text + "# newest\n" for name, text in FILES.items()})
    update(tmp_path, {})
    assert contents(tmp_path) == {}


def test_what_a_killed_run_was_writing_goes_with_the_next(tmp_path: Path) -> None:
    update(tmp_path)
    write(tmp_path, {f"{STAGED}/files/a.py": "half"})
    update(tmp_path, {**FILES, "a.py": "x = 3\n"})
    assert not (tmp_path / STAGED).exists()


def update_often(folder: Path, number: int) -> None:
    for turn in range(20):
        update(folder, {name: f"{text}# {number} {turn}\n" for name, text in FILES.items()})


def test_concurrent_updates_leave_one_of_them_whole(tmp_path: Path) -> None:
    start = multiprocessing.get_context("fork").Process
    runs = [start(target=update_often, args=(tmp_path, number)) for number in range(2)]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
    assert [run.exitcode for run in runs] == [0, 0]
    (ending,) = {text.splitlines()[-1] for text in contents(tmp_path).values()}
    assert ending in ("# 0 19", "# 1 19")
    done = subprocess.run(["sha256sum", "--check", "--quiet", LIST], cwd=tmp_path)
    assert done.returncode == 0
    assert {path.name for path in tmp_path.iterdir()} == {
        *(name.partition("/")[0] for name in FILES),
        LIST,
    }
