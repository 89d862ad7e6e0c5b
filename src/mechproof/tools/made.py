"""Folders of made files: a list of their digests says which may be replaced or removed.

The list is in the format of `sha256sum`, so that `sha256sum --check` reads it. While files are
replaced, it has the old and the new digest of each: however a run ends, the next one knows what it
left.
"""

from __future__ import annotations

import difflib
import os
import re
import shutil
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path, PurePosixPath

# Folder for files that are being written, until they are put in place.
STAGED = ".mechproof-staged"
_LINE = re.compile("([0-9a-f]{64})  (.+)")


class ForeignFileError(RuntimeError):
    """Files that were not made, or were edited since, are in the way of files to be written."""


@dataclass(frozen=True)
class Change:
    """A file that is not what it should be: its text, and the text it should have.

    `is_own` says that it is as it was made, so that nothing is lost with it.
    """

    name: str
    present: str | None
    wanted: str | None
    is_own: bool

    @property
    def is_removal(self) -> bool:
        """Return whether the file is surplus."""
        return self.wanted is None

    def describe(self) -> str:
        """Return what is wrong, and a unified diff from the file to what it should be."""
        what = "missing" if self.present is None else "surplus" if self.is_removal else "different"
        edited = "" if self.is_own else " (edited, or not made by mechproof)"
        lines = difflib.unified_diff(
            (self.present or "").splitlines(keepends=True),
            (self.wanted or "").splitlines(keepends=True),
            fromfile=f"{self.name} (present)",
            tofile=f"{self.name} (regenerated)",
        )
        return f"{what}: {self.name}{edited}\n{''.join(lines)}"


@dataclass(frozen=True)
class Made:
    """The made files of a folder, as listed in its file `listed`."""

    folder: Path
    listed: str

    def compare(self, files: Mapping[str, str]) -> list[Change]:
        """Return the missing, surplus and different files, in the order of their names.

        A surplus file was made and has not been edited since. Raises `ForeignFileError` if the list
        is invalid.
        """
        known = self.read_list()
        wanted = {**files, self.listed: _write_list(_list_pairs(files))}
        names = sorted(wanted.keys() | {name for _, name in known})
        changes = (self._compare(name, wanted.get(name), known) for name in names)
        return [change for change in changes if change]

    def _compare(
        self, name: str, wanted: str | None, known: frozenset[tuple[str, str]]
    ) -> Change | None:
        content = _read(self.folder / name)
        present = None if content is None else content.decode("utf-8", "backslashreplace")
        if present == wanted:
            return None
        digest = sha256(content or b"").hexdigest()
        # An empty file holds nothing that could be lost.
        is_own = (digest, name) in known or name == self.listed or not (content or b"").strip()
        return Change(name, present, wanted, is_own) if wanted is not None or is_own else None

    def update(self, files: Mapping[str, str], *, and_remove: bool = True) -> list[Change]:
        """Bring the files to what they should be, and return what was changed.

        Without `and_remove`, other made files stay, and stay listed. An interrupted write leaves
        every file either as it was before or complete. Raises `ForeignFileError`, before anything
        is written, naming the files in the way.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        with _hold(self.folder):
            changes = [c for c in self.compare(files) if and_remove or not c.is_removal]
            self._refuse_foreign(changes)
            known = self.read_list()
            pairs = _list_pairs(files)
            if not and_remove:
                pairs |= {(digest, name) for digest, name in known if name not in files}
            if changes:
                self._write(changes, known | pairs, pairs)
        return [change for change in changes if change.name != self.listed]

    def _refuse_foreign(self, changes: Iterable[Change]) -> None:
        paths = {c.name: self.folder / c.name for c in changes if not c.is_removal}
        edited = [paths[c.name] for c in changes if not c.is_own]
        taken = [path for path in paths.values() if path.exists() and not path.is_file()]
        if foreign := sorted(map(str, {*edited, *taken})):
            raise ForeignFileError(
                f"{', '.join(foreign)}: not overwritten, since not made by mechproof or edited "
                f"since ({self.listed} has no such digest); move it away or delete it"
            )

    def _write(
        self,
        changes: Iterable[Change],
        meanwhile: Iterable[tuple[str, str]],
        pairs: Iterable[tuple[str, str]],
    ) -> None:
        written = {c.name: c.wanted for c in changes if c.wanted is not None}
        lists = {"meanwhile": _write_list(meanwhile), "listed": _write_list(pairs)}
        written.pop(self.listed, None)
        with _stage(self.folder) as staged:
            for part, texts in (("files", written), ("lists", lists)):
                for name, text in texts.items():
                    _write_file(staged / part / name, text)
            for name in written:
                (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            os.replace(staged / "lists" / "meanwhile", self.folder / self.listed)
            for name in written:
                os.replace(staged / "files" / name, self.folder / name)
            for change in changes:
                if change.is_removal:
                    self._remove(change.name)
            os.replace(staged / "lists" / "listed", self.folder / self.listed)

    def _remove(self, name: str) -> None:
        (self.folder / name).unlink(missing_ok=True)
        for above in PurePosixPath(name).parents[:-1]:
            with suppress(OSError):
                (self.folder / above).rmdir()

    def read_list(self) -> frozenset[tuple[str, str]]:
        """Return the pairs (digest, name) of the list, or none if there is no list.

        Raises `ForeignFileError` for a file of that name that is no list.
        """
        content = _read(self.folder / self.listed)
        lines = [] if content is None else content.decode("utf-8", "replace").splitlines()
        found = [_LINE.fullmatch(line) for line in lines]
        pairs = frozenset((match[1], match[2]) for match in found if match)
        if len(pairs) < len(lines) or not all(_lies_inside(name) for _, name in pairs):
            raise ForeignFileError(
                f"{self.folder / self.listed}: is not a list of files made by mechproof; move it "
                "away or delete it"
            )
        return pairs


def _lies_inside(name: str) -> bool:
    path = PurePosixPath(name)
    return "\\" not in name and not path.is_absolute() and ".." not in path.parts


def _list_pairs(files: Mapping[str, str]) -> frozenset[tuple[str, str]]:
    return frozenset((sha256(text.encode()).hexdigest(), name) for name, text in files.items())


def _write_list(pairs: Iterable[tuple[str, str]]) -> str:
    ordered = sorted(pairs, key=lambda pair: (pair[1], pair[0]))
    return "".join(f"{digest}  {name}\n" for digest, name in ordered)


def _read(file: Path) -> bytes | None:
    # Bytes, because a line end or an encoding that is not ours is a difference to show, too.
    return file.read_bytes() if file.is_file() else None


def _write_file(file: Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8", newline="\n")


@contextmanager
def _stage(folder: Path) -> Iterator[Path]:
    """Yield an empty subfolder, removed afterwards; one left by a killed run is removed first."""
    staged = folder / STAGED
    shutil.rmtree(staged, ignore_errors=True)
    try:
        staged.mkdir()
        yield staged
    finally:
        shutil.rmtree(staged, ignore_errors=True)


@contextmanager
def _hold(folder: Path) -> Iterator[None]:
    """Lock a folder, so that one process at a time writes to it; a dead process releases it."""
    try:
        from fcntl import LOCK_EX, flock
    except ImportError:  # Windows opens no folders; there the last one that writes wins.
        yield
        return
    held = os.open(folder, os.O_RDONLY)
    try:
        with suppress(OSError):
            flock(held, LOCK_EX)
        yield
    finally:
        os.close(held)
