"""Cache: JSON in the user's cache folder, each entry under its key.

A key is the digest of everything that an entry rests on: an entry that rests on something else has
another key and is made anew, as are entries that are missing, damaged or written by another
version. The files that a derivation is made from are noted while it is loaded.
"""

from __future__ import annotations

import json
import os
import sys
import sysconfig
import time
import warnings
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib.metadata import distributions, version
from importlib.util import source_from_cache
from pathlib import Path
from types import ModuleType
from typing import Any

from mechproof.tools.files import write_whole

VARIABLE = "MECHPROOF_CACHE"
# The most keys without a value that a file holds; older ones are of old sources.
MOST_KEYS = 1000
HERE = Path(__file__).resolve().parents[1]
STANDARD = Path(sysconfig.get_paths()["stdlib"])
INSTALLED = {"site-packages", "dist-packages"}
# Modules of libraries or of the package, by name; cached, because there are thousands.
_libraries: dict[str, ModuleType] = {}
# Prefixes of the names of modules of the package and of derivations.
OWN = ("mechproof", "_mechproof")
# Folders of papers and of the code generated from them, which concern no other paper.
PAPERS = ("derivations", "kernels")
_noted: set[str] | None = None


def cache_folder() -> Path:
    """Return MECHPROOF_CACHE, or `mechproof` in the user's cache folder.

    For a user without a home it is a folder that cannot be written.
    """
    if named := os.environ.get(VARIABLE):
        return Path(named)
    try:
        home = Path.home()
    except RuntimeError:
        home = Path(os.devnull)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or home / "AppData/Local", "mechproof")
    if sys.platform == "darwin":
        return home / "Library/Caches/mechproof"
    return Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache", "mechproof")


def name_place(location: Path) -> str:
    """Return the name under which a derivation is cached, different for every place."""
    name = sha256(str(location.resolve()).encode("utf-8", "surrogateescape")).hexdigest()
    return f"{location.stem}-{name[:16]}"


def make_key(sources: Iterable[Path], packages: Iterable[str], *parts: str) -> str:
    """Return the digest of files, of the versions of Python and of packages, and of other texts."""
    digests = [sha256(source.read_bytes()).hexdigest() for source in sources]
    everything = [sys.version, *map(version, packages), *digests, *parts]
    return sha256("\n".join(everything).encode()).hexdigest()


@dataclass(frozen=True)
class Store:
    """A file in the cache folder, by its path there."""

    name: str

    @property
    def file(self) -> Path:
        """Return the path of the file, which need not exist yet."""
        return cache_folder() / self.name

    def read(self) -> dict[str, Any]:
        """Return the entries by key; none if the file is missing or damaged."""
        try:
            entries = json.loads(self.file.read_bytes())
        except (OSError, ValueError):
            return {}
        return entries if isinstance(entries, dict) else {}

    def write(self, entries: Mapping[str, Any]) -> None:
        """Replace all entries in one step; a folder that cannot be written gives a warning."""
        try:
            write_whole(self.file, json.dumps(entries))
        except OSError as error:
            # The warning is raised from this one place, so that all failures show it only once.
            said = f"nothing is cached in {cache_folder()}: {error.strerror}"
            warnings.warn(said, RuntimeWarning, stacklevel=1)

    def add(self, keys: Iterable[str]) -> None:
        """Add keys without a value: those of things that have passed a check."""
        self.write(dict.fromkeys(list({**self.read(), **dict.fromkeys(keys)})[-MOST_KEYS:]))


def _note(event: str, arguments: tuple[object, ...]) -> None:
    if event == "open" and _noted is not None and isinstance(arguments[0], str | bytes):
        _noted.add(os.fsdecode(arguments[0]))


# An audit hook cannot be removed; while nothing is noted it does nothing.
sys.addaudithook(_note)


@contextmanager
def note_reads() -> Iterator[dict[str, str]]:
    """Note files opened in the block, and those loaded by its end: path -> digest, filled then.

    It stays empty if one of them was written in the meantime, as it is unknown which text was read.
    """
    global _noted
    _noted, read, start = set(), dict[str, str](), time.time_ns()
    try:
        yield read
    finally:
        opened, _noted = _noted, None
    files = {path for path in map(_find_source, opened) if _is_own(path)} | _find_helpers()
    if all(path.stat().st_mtime_ns < start for path in files):
        read.update(digest_files(files))


def _find_source(name: str) -> Path:
    """Return the source whose bytecode is read, or the file itself."""
    return Path(source_from_cache(name) if name.endswith(".pyc") else name).resolve()


def _find_helpers() -> set[Path]:
    """Return the files of loaded modules that belong neither to a library nor to the package.

    A derivation may use these without opening them, if another one loaded them before.
    """
    others = {n: m for n, m in list(sys.modules.items()) if _libraries.get(n) is not m}
    files = {name: getattr(module, "__file__", None) for name, module in others.items()}
    for name, file in files.items():
        if file and (name.startswith(OWN) or _is_library(file)):
            _libraries[name] = others[name]
    own = {f for n, f in files.items() if f and _libraries.get(n) is not others[n]}
    return {file for file in (Path(one).resolve() for one in own) if _is_own(file)}


def _is_own(file: Path) -> bool:
    return file.is_file() and (file.is_relative_to(HERE) or not _is_library(str(file)))


def _is_library(name: str) -> bool:
    """Return whether a file changes only with the version of an installed package."""
    file = Path(name)
    return file.is_relative_to(STANDARD) or not INSTALLED.isdisjoint(file.parts)


def digest_files(paths: Iterable[Path]) -> dict[str, str]:
    """Return the digest of each file by its path; "" if it does not exist."""
    return {str(path): _digest(path) for path in sorted(paths)}


def _digest(path: Path) -> str:
    return sha256(path.read_bytes()).hexdigest() if path.exists() else ""


def are_unchanged(digests: Mapping[str, str]) -> bool:
    """Return whether all files still have their digests."""
    try:
        return digest_files(map(Path, digests)) == digests
    except OSError:
        return False


def list_program() -> list[Path]:
    """Return the files of the package, without papers and the code generated from them."""
    files = (path for path in HERE.rglob("*") if path.suffix != ".pyc" and path.is_file())
    return [path for path in files if path.relative_to(HERE).parts[0] not in PAPERS]


@cache
def digest_program() -> str:
    """Return the digest of the package, of Python and of all installed packages."""
    installed = sorted({f"{d.name} {d.version}" for d in distributions()})
    parts = [sys.version, *installed, *digest_files(list_program()).values()]
    return sha256("\n".join(parts).encode()).hexdigest()
