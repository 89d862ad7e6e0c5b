"""Cache: JSON that is kept in the user's folder for caches, each entry under its key.

A key is the digest of all that an entry rests on: what rests on something else has another key and
is made anew. So is what is missing, damaged or written by another version.
"""

from __future__ import annotations

import json
import os
import sys
import warnings
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

from mechproof.tools.files import write_whole

VARIABLE = "MECHPROOF_CACHE"
# Keys without a value that a file holds; more are of old sources.
MOST_KEYS = 1000


def cache_folder() -> Path:
    """Return MECHPROOF_CACHE, or `mechproof` in the user's folder for caches.

    A user without a home has none that can be written.
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
    """Return a name for what is kept of a derivation; another place has another."""
    name = sha256(str(location.resolve()).encode("utf-8", "surrogateescape")).hexdigest()
    return f"{location.stem}-{name[:16]}"


def make_key(sources: Iterable[Path], packages: Iterable[str], *parts: str) -> str:
    """Return the digest of files, of the versions of Python and of packages, and of other texts."""
    digests = [sha256(source.read_bytes()).hexdigest() for source in sources]
    everything = [sys.version, *map(version, packages), *digests, *parts]
    return sha256("\n".join(everything).encode()).hexdigest()


@dataclass(frozen=True)
class Store:
    """A file of the folder for caches, by its path in there."""

    name: str

    @property
    def file(self) -> Path:
        """Return where the file is, or will be."""
        return cache_folder() / self.name

    def read(self) -> dict[str, Any]:
        """Return what is kept by its key; nothing if the file is missing or damaged."""
        try:
            entries = json.loads(self.file.read_bytes())
        except (OSError, ValueError):
            return {}
        return entries if isinstance(entries, dict) else {}

    def write(self, entries: Mapping[str, Any]) -> None:
        """Keep these instead, in one step; a folder that cannot be written is a warning."""
        try:
            write_whole(self.file, json.dumps(entries))
        except OSError as error:
            # Told from here, so that it is told once for all that cannot be kept.
            said = f"nothing is kept in {cache_folder()}: {error.strerror}"
            warnings.warn(said, RuntimeWarning, stacklevel=1)

    def add(self, keys: Iterable[str]) -> None:
        """Keep keys without a value, too: those of what has passed a check."""
        self.write(dict.fromkeys(list({**self.read(), **dict.fromkeys(keys)})[-MOST_KEYS:]))
