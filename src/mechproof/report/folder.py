"""The folder of a report: files in, a folder that holds them; what is not ours stays untouched."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from mechproof.made import STAGED, ForeignFileError, Made

# Lists the files of the report, so that the next one knows what it may replace.
LIST = "mechproof-report.sha256"


def check_folder(folder: Path) -> None:
    """Raise `ForeignFileError` for what is no folder, or holds other things than a report.

    An empty folder and one that is not there are right.
    """
    if folder.exists() and not folder.is_dir():
        raise ForeignFileError(f"{folder}: is a file, a folder is needed")
    names = {path.name for path in folder.iterdir()} if folder.is_dir() else set()
    # A first report that was killed leaves only what it was about to put in place.
    if LIST not in names and names - {STAGED}:
        raise ForeignFileError(
            f"{folder}: is not empty and holds no report of mechproof; name another folder"
        )
    Made(folder, LIST).read_list()


def write_folder(folder: Path, files: Mapping[str, str]) -> None:
    """Replace the files of the last report by those of this one.

    Raises `ForeignFileError` for a file that is in the way and is not of a report.
    """
    check_folder(folder)
    Made(folder, LIST).update(files)
