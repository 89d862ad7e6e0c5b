"""The file that --json names: refused before anything is judged, and never left as it was."""

from __future__ import annotations

from pathlib import Path

from mechproof.cli.console import fail, refuse
from mechproof.tools.files import write_whole

# What would be lost if an option had its value forgotten.
PAPERS = (".tex", ".md", ".py")


def clear_json(file: Path | None) -> None:
    """Refuse what cannot be the file of --json; remove that of an earlier run, which may fail."""
    if file is None:
        return
    folder = file.absolute().parent
    if file.suffix in PAPERS:
        refuse(f"--json {file}: is a paper by its name, another file is needed")
    if file.is_dir():
        refuse(f"--json {file}: is a folder, a file is needed")
    if not folder.is_dir():
        refuse(f"--json {file}: the folder {folder} does not exist")
    try:
        if file.is_file():
            file.unlink()
    except OSError as error:
        refuse(f"--json {file}: {error.strerror}")


def write_json(file: Path | None, text: str) -> None:
    """Write the file of --json, if one is named."""
    try:
        if file:
            write_whole(file, text)
    except OSError as error:
        fail(f"--json {file}: {error.strerror}")
