"""Cache: the verdicts of the rows that have not changed since they were last judged.

A row is judged anew when its record, the domain, a source file of the prover or the version of
Python, SymPy or flint differs. One file for each derivation holds the rows of its last run.
"""

from __future__ import annotations

import json
import os
import sys
import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import flint
import sympy as sp
from sympy.external.gmpy import GROUND_TYPES

from mechproof import record
from mechproof.proof.fingerprint import Fingerprint, NoFingerprintError
from mechproof.proof.verdict import Evidence, Judgement, Verdict
from mechproof.record import Paper, Row

VARIABLE = "MECHPROOF_CACHE"
# Of a row that no rung could read: the reason may be this machine's (memory, depth of recursion).
UNREAD = "none"


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


def prover_sources() -> list[Path]:
    """Return the source files that verdicts come from."""
    here = Path(__file__).parent
    return [*sorted(here.rglob("*.py")), *sorted(Path(record.__file__).parent.glob("*.py"))]


@cache
def _prover(sources: tuple[bytes, ...]) -> str:
    versions = (sys.version, sp.__version__, GROUND_TYPES, flint.__version__)
    digests = [sha256(source).hexdigest() for source in sources]
    return sha256("\n".join([*versions, *digests]).encode()).hexdigest()


def row_keys(paper: Paper, rows: Sequence[Row]) -> list[str]:
    """Return the key of each row of a paper; empty for a row that has none and is not kept."""
    prover = _prover(tuple(path.read_bytes() for path in prover_sources()))
    try:
        domain = Fingerprint()
        start = domain.visit((prover, paper))
    except NoFingerprintError:
        return [""] * len(rows)
    return [_row_key(domain.copy(), start, row) for row in rows]


def _row_key(domain: Fingerprint, start: str, row: Row) -> str:
    try:
        return domain.visit((start, row))
    except NoFingerprintError:
        return ""


class VerdictCache:
    """The judgements of one derivation by the keys of its rows."""

    def __init__(self, location: Path) -> None:
        self.file = cache_folder() / f"{name_place(location)}.json"

    def load(self) -> dict[str, Judgement]:
        """Return what is kept; entries that cannot be read are as good as absent."""
        try:
            entries = json.loads(self.file.read_bytes())
        except (OSError, ValueError):
            return {}
        items = entries.items() if isinstance(entries, dict) else ()
        return {key: found for key, entry in items if (found := read_judgement(entry))}

    def save(self, judgements: Mapping[str, Judgement]) -> None:
        """Keep these instead, in one step; a folder that cannot be written is a warning."""
        kept = {k: asdict(j) for k, j in judgements.items() if k and j.rung != UNREAD}
        written = self.file.with_suffix(f".{os.getpid()}")
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            written.write_text(json.dumps(kept), encoding="utf-8")
            os.replace(written, self.file)
        except OSError as error:
            with suppress(OSError):
                written.unlink()
            warnings.warn(f"verdicts are not kept: {error}", RuntimeWarning, stacklevel=2)


def read_judgement(entry: Any) -> Judgement | None:
    """Read what `asdict` wrote of a judgement; None for anything else."""
    try:
        evidence = tuple(Evidence(**item) for item in entry["evidence"])
        changed = {"verdict": Verdict(entry["verdict"]), "marks": tuple(entry["marks"])}
        changed["singular"] = tuple(entry["singular"])
        return Judgement(**{**entry, **changed, "evidence": evidence})
    except (KeyError, TypeError, ValueError):
        return None
