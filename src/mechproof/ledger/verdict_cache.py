"""Cache: the verdicts of the rows that have not changed since they were last judged.

A row is judged anew when its record, the domain, a source file of the prover or the version of
Python, SymPy or flint differs. One file for each derivation holds the rows of its last run. Of a
folder those of its namesakes are read as well: what is installed is often also checked out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from glob import escape
from pathlib import Path
from typing import Any

from sympy.external.gmpy import GROUND_TYPES

from mechproof.ledger.fingerprint import Fingerprint, NoFingerprintError
from mechproof.proof.verdict import Evidence, Judgement, Verdict
from mechproof.record import Paper
from mechproof.sources.located_text import Place
from mechproof.tools.cache import Store, cache_folder, make_key, name_place

# Of a row that no rung could read: the reason may be this machine's (memory, depth of recursion).
UNREAD = "none"
PACKAGES = ("sympy", "python-flint")
# Fields of a judgement that are lists of texts.
LISTED = ("marks", "singular", "cites", "quantities")
LAYERS = ("record", "latex", "arithmetic", "sources", "statement_domains", "proof")


def prover_sources() -> list[Path]:
    """Return the source files that verdicts come from."""
    package = Path(__file__).parents[1]
    return [path for name in LAYERS for path in sorted((package / name).rglob("*.py"))]


def make_keys(paper: Paper, sources: Sequence[object]) -> list[str]:
    """Return a key of each row of a paper, or of what rows are stated from.

    It is empty for what has none and is not kept.
    """
    prover = make_key(prover_sources(), PACKAGES, GROUND_TYPES)
    try:
        domain = Fingerprint()
        start = domain.visit((prover, paper))
    except NoFingerprintError:
        return [""] * len(sources)
    return [_make_key(domain.copy(), start, source) for source in sources]


def _make_key(domain: Fingerprint, start: str, source: object) -> str:
    try:
        return domain.visit((start, source))
    except NoFingerprintError:
        return ""


class VerdictCache:
    """The judgements of one derivation by the keys of its rows, or of what these come from."""

    def __init__(self, location: Path) -> None:
        self.store = Store(f"{name_place(location)}.json")
        self.named_alike = f"{escape(location.stem)}-*.json" if location.is_dir() else ""

    def load(self) -> dict[str, tuple[Judgement, ...]]:
        """Return what is kept; entries that cannot be read are as good as absent."""
        alike = sorted(cache_folder().glob(self.named_alike)) if self.named_alike else ()
        stores = (*(Store(file.name) for file in alike), self.store)
        entries = [entry for store in stores for entry in store.read().items()]
        return {key: found for key, entry in entries if (found := _read_all(entry))}

    def save(self, judgements: Mapping[str, tuple[Judgement, ...]]) -> None:
        """Keep these instead."""
        kept = {k: found for k, found in judgements.items() if all(j.rung != UNREAD for j in found)}
        self.store.write({k: list(map(asdict, found)) for k, found in kept.items() if k})


def _read_all(entry: Any) -> tuple[Judgement, ...]:
    """Read the judgements of one key; none if one of them cannot be read."""
    found = tuple(map(read_judgement, entry)) if isinstance(entry, list) else ()
    read = tuple(judgement for judgement in found if judgement)
    return read if len(read) == len(found) else ()


def read_judgement(entry: Any) -> Judgement | None:
    """Read what `asdict` wrote of a judgement; None for anything else."""
    try:
        evidence = tuple(Evidence(**item) for item in entry["evidence"])
        changed: dict[str, Any] = {"verdict": Verdict(entry["verdict"])}
        changed |= {name: tuple(entry[name]) for name in LISTED}
        changed["place"] = Place(**entry["place"]) if entry["place"] else None
        return Judgement(**{**entry, **changed, "evidence": evidence})
    except (KeyError, TypeError, ValueError):
        return None
