"""Regenerate: in, papers; out, the files of the generated package, compared or written."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from mechproof.codegen.backends.numba import render_compiled, render_elementary
from mechproof.codegen.backends.numpy import render_init, render_modules
from mechproof.record import Paper

# What was generated, and may be replaced and removed: these, and modules with the line STAMP.
PAGES = ("LEDGER.md", "ledger.json", "measured/TABLES.md")
CERTIFICATES = "certificates/*.json"
STAMP = re.compile("^Regenerate with `mechproof regenerate`", re.MULTILINE)


class ForeignFileError(RuntimeError):
    """A file that was not generated lies where one is to be written."""


def render_package(papers: Iterable[Paper], *, is_own: bool = False) -> dict[str, str]:
    """Render every file of the generated package, by its name relative to the package.

    Papers without forms have no module. `is_own` says that it is `mechproof.kernels`, where the
    compiled kernels of all packages find the elementary functions.
    """
    files = {
        name: text
        for paper in papers
        for render in (render_modules, render_compiled)
        for name, text in render(paper).items()
    }
    return {
        "__init__.py": render_init("Generated kernels: one module per system."),
        "forms/__init__.py": render_init("Other forms of the kernels: one module per system."),
        "compiled/__init__.py": render_init("Compiled kernels: one module per system."),
        **({"compiled/elementary.py": render_elementary()} if is_own else {}),
        **dict(sorted(files.items())),
    }


@dataclass(frozen=True)
class Change:
    """A file of ours that is not what it should be: its text, and the text it should have."""

    name: str
    present: str | None
    wanted: str | None

    @property
    def is_removal(self) -> bool:
        """Return whether the file is surplus."""
        return self.wanted is None

    def describe(self) -> str:
        """Return what is wrong and a unified diff from the file to what it should be."""
        what = "missing" if self.present is None else "surplus" if self.is_removal else "different"
        lines = difflib.unified_diff(
            (self.present or "").splitlines(keepends=True),
            (self.wanted or "").splitlines(keepends=True),
            fromfile=f"{self.name} (present)",
            tofile=f"{self.name} (regenerated)",
        )
        return f"{what}: {self.name}\n{''.join(lines)}"


def compare_files(directory: Path, files: Mapping[str, str]) -> list[Change]:
    """Return the missing, surplus and different files, in the order of their names.

    Surplus is only what was generated: a page, a certificate, or a module with the stamp. Raises
    `ForeignFileError` if a name is taken by a file that was not.
    """
    present = _read_own_files(directory, files)
    return [
        Change(name, present.get(name), files.get(name))
        for name in sorted(present.keys() | files.keys())
        if present.get(name) != files.get(name)
    ]


def update_files(directory: Path, changes: Iterable[Change]) -> None:
    """Make the changes; an interrupted write leaves the old files whole."""
    changes = list(changes)
    _write_files(directory, {c.name: c.wanted for c in changes if c.wanted is not None})
    for change in changes:
        if change.is_removal:
            (directory / change.name).unlink()
            _remove_empty_folders(directory, change.name)


def _remove_empty_folders(directory: Path, name: str) -> None:
    for folder in Path(name).parents[:-1]:
        with suppress(OSError):
            (directory / folder).rmdir()


def _read_own_files(directory: Path, wanted: Iterable[str]) -> dict[str, str]:
    """Read what was generated, and what lies where something is to be."""
    modules = (path.relative_to(directory).as_posix() for path in directory.rglob("*.py"))
    certificates = {path.relative_to(directory).as_posix() for path in directory.glob(CERTIFICATES)}
    names = sorted({*modules, *PAGES, *certificates, *wanted})
    texts = {name: _read(directory / name) for name in names if (directory / name).is_file()}
    own = {
        name
        for name, text in texts.items()
        if name in {*PAGES, *certificates} or STAMP.search(text)
    }
    if taken := sorted(n for n in wanted if n in texts and n not in own and texts[n].strip()):
        raise ForeignFileError(
            f"{directory / taken[0]}: is to be generated, but lies there without the line "
            "that generated modules have; move it away or delete it"
        )
    return {name: text for name, text in texts.items() if name in own or name in wanted}


def _read(file: Path) -> str:
    # Bytes, because a line end or an encoding that is not ours is a difference to show, too.
    return file.read_bytes().decode("utf-8", "backslashreplace")


def _write_files(directory: Path, files: Mapping[str, str]) -> None:
    """Write all texts beside their targets first, then put each in place in one step."""
    directory.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix=".regenerate-", dir=directory) as folder:
        for name, text in files.items():
            staged = Path(folder, name)
            staged.parent.mkdir(parents=True, exist_ok=True)
            staged.write_text(text, encoding="utf-8", newline="\n")
        for name in files:
            target = directory / name
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(Path(folder, name), target)
