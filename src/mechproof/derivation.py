"""Where papers come from: the derivations of the package, of a folder, or one file of a user."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterator
from pathlib import Path

from mechproof.record import Paper


class DerivationError(RuntimeError):
    """A derivation could not be loaded, or does not bind one `Paper` to the name PAPER."""


def packaged_directory() -> Path:
    """Return the folder of the derivations that come with the package."""
    spec = importlib.util.find_spec("mechproof.derivations")
    if spec is None or not spec.submodule_search_locations:
        raise DerivationError("the package mechproof.derivations is not installed")
    return Path(next(iter(spec.submodule_search_locations)))


def find_systems(directory: Path) -> dict[str, Path]:
    """Return system -> file for every derivation in a folder, in alphabetical order."""
    files = sorted(directory.glob("[!_]*.py"))
    return {file.stem: file for file in files}


def load_paper(file: Path) -> Paper:
    """Run a derivation and return its paper.

    Raises `DerivationError` naming the file and what went wrong.
    """
    spec = importlib.util.spec_from_file_location(f"mechproof_derivation_{file.stem}", file)
    if spec is None or spec.loader is None:
        raise DerivationError(f"{file}: not a Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    try:
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:
        raise DerivationError(f"{file}: {type(error).__name__}: {error}") from error
    paper = getattr(module, "PAPER", None)
    if not isinstance(paper, Paper):
        raise DerivationError(f"{file}: binds no mechproof.record.Paper to the name PAPER")
    return paper


def load_directory(directory: Path) -> Iterator[Paper]:
    """Load every derivation of a folder."""
    for file in find_systems(directory).values():
        yield load_paper(file)
