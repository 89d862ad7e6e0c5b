"""Where a command finds derivations, and where it writes what is generated from them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile

from mechproof.cli.console import fail, refuse
from mechproof.derivation import DerivationError, find_systems, packaged_directory

RULE = (
    "Derivations are those of --derivations DIR (or of ROOT/derivations with --root ROOT), else "
    "those of the folder ./derivations if there is one, else those that come with the package. "
    "What is generated from DIR lies in DIR/../generated."
)


@dataclass(frozen=True)
class Places:
    """A folder of derivations, the folder generated from it, and the options that name them."""

    derivations: Path
    generated: Path
    options: str = ""

    @property
    def is_packaged(self) -> bool:
        """Return whether the derivations are those that come with the package."""
        return self.derivations.resolve() == packaged_directory().resolve()


def find_places(derivations: Path | None, root: Path | None) -> Places:
    """Apply the rule; an option that names no folder is refused."""
    if derivations and root:
        refuse("--derivations and --root: give one of them")
    if root:
        return _check(root / "derivations", f" --root {root}")
    if derivations:
        return _check(derivations, f" --derivations {derivations}")
    here = Path("derivations")
    return _check(here if here.is_dir() else packaged_directory(), "")


def _check(derivations: Path, options: str) -> Places:
    if not derivations.is_dir():
        refuse(f"{options.strip()}: there is no folder {derivations}")
    named = derivations if derivations.name.strip(".") else derivations.resolve()
    return Places(derivations, named.parent / "generated", options)


def read_out(text: str | Path, is_file: bool = False) -> Path:
    """Return the folder or file that --out names, there or not; refuse what cannot be written."""
    if not str(text):
        refuse(f"--out: is empty, a {'file' if is_file else 'folder'} is needed")
    target = Path(text)
    places = target.parents if is_file else (target, *target.parents)
    nearest = next(place for place in places if os.path.lexists(place))
    if not nearest.is_dir():
        refuse(f"--out {target}: {nearest} is no folder")
    try:
        with TemporaryFile(dir=nearest):
            return target
    except OSError as error:
        refuse(f"--out {target}: cannot write to {nearest.absolute()}: {error.strerror}")


def find_location(name: str, directory: Path, sources: Sequence[str] = ()) -> Path:
    """Return the place of a system of a folder, or of a file or a folder named by its path.

    `sources` are the suffixes of papers' own sources, where the command takes them.
    """
    systems = find_systems(directory)
    if name in systems:
        return systems[name]
    path = Path(name)
    if (path.suffix in (".py", *sources) and path.is_file()) or (path / "__init__.py").is_file():
        return path
    known = ", ".join(systems) or "none"
    also = " or FILE.tex" if sources else ""
    refuse(
        f"{name!r} is neither a file FILE.py{also}, nor a folder with an __init__.py, nor one of "
        f"the systems of {directory}: {known}"
    )


def find_locations(names: Iterable[str], places: Places, sources: Sequence[str] = ()) -> list[Path]:
    """Return the places of named papers, of all derivations if none is named."""
    try:
        if names:
            found = dict.fromkeys(names)
            return [find_location(name, places.derivations, sources) for name in found]
        locations = list(find_systems(places.derivations).values())
    except DerivationError as error:
        fail(str(error))
    if not locations:
        refuse(f"there is no derivation in {places.derivations}")
    return locations
