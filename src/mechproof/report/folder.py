"""The folder of a report: files in, a folder that holds them; what is not ours stays untouched."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path, PurePosixPath

from mechproof.files import write_whole

# Names the files of the report, so that the next one knows what it may replace.
LIST = "mechproof-report.json"


class FolderError(RuntimeError):
    """The folder holds what is not of a report."""


def check_folder(folder: Path) -> None:
    """Raise `FolderError` for a place that is no folder, or that holds other things than a report.

    An empty folder and one that is not there are right.
    """
    if folder.exists() and not folder.is_dir():
        raise FolderError(f"{folder}: is a file, a folder is needed")
    if folder.is_dir() and any(folder.iterdir()):
        read_list(folder)


def write_folder(folder: Path, files: Mapping[str, str]) -> None:
    """Replace the files of the last report by those of this one.

    Raises `FolderError` for a file that is in the way and is not of a report.
    """
    check_folder(folder)
    old = read_list(folder) if (folder / LIST).exists() else frozenset()
    foreign = [name for name in files if name not in old and (folder / name).exists()]
    if foreign:
        raise FolderError(f"{folder / foreign[0]}: is in the way, and no report made it")
    # What is not finished is a report, too.
    _write_list(folder, old | files.keys())
    for name, text in files.items():
        write_whole(folder / name, text)
    for name in sorted(old - files.keys()):
        _remove(folder, name)
    _write_list(folder, files)


def read_list(folder: Path) -> frozenset[str]:
    """Return the names of the files of the report in a folder; `FolderError` if there is none."""
    refusal = f"{folder}: is not empty and holds no report of mechproof; name another folder"
    try:
        names = json.loads((folder / LIST).read_text(encoding="utf-8"))["files"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise FolderError(refusal) from error
    if not (isinstance(names, list) and all(map(_lies_inside, names))):
        raise FolderError(refusal)
    return frozenset(names)


def _lies_inside(name: object) -> bool:
    if not isinstance(name, str) or "\\" in name:
        return False
    path = PurePosixPath(name)
    return not path.is_absolute() and ".." not in path.parts and bool(path.parts)


def _write_list(folder: Path, names: Iterable[str]) -> None:
    text = json.dumps({"files": sorted(names)}, ensure_ascii=False, indent=0)
    write_whole(folder / LIST, f"{text}\n")


def _remove(folder: Path, name: str) -> None:
    file = folder / name
    file.unlink(missing_ok=True)
    with suppress(OSError):
        if file.parent != folder:
            file.parent.rmdir()
