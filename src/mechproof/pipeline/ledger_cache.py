"""Ledgers that are cached whole: a paper whose files have not changed is not even loaded.

A ledger is made anew when a file that the derivation opened, a module that it may have loaded, a
file of the package, or the version of any installed package differs. Other inputs of a derivation,
such as the clock or the environment, are not noticed.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path
from typing import Any

from mechproof.derivation import find_file
from mechproof.ledger.costs import LedgerCost
from mechproof.ledger.judged import Ledger, Origin
from mechproof.ledger.ledger_findings import LedgerFinding
from mechproof.ledger.verdict_cache import UNREAD, read_judgement
from mechproof.proof.verdict import Left, State, Verdict
from mechproof.record import Weight
from mechproof.sources.located_text import Place
from mechproof.tools.cache import Store, are_unchanged, digest_program, name_place


class LedgerCache:
    """The last ledger of one derivation, with the digests of its sources.

    It must be created before the derivation is loaded, as it notes the state of the program then.
    """

    def __init__(self, location: Path) -> None:
        self.program = digest_program()
        self.chosen = find_file(location.resolve())
        self.store = Store(f"ledgers/{name_place(location)}.json")

    def load(self) -> Ledger | None:
        """Return the ledger if nothing has changed, or None; an unreadable one counts as absent."""
        kept = self.store.read().get(self.program, {})
        with suppress(ValueError, KeyError, TypeError):
            # If no file of chosen forms existed when the ledger was made, the ledger does not
            # list one.
            is_new = self.chosen.exists() and str(self.chosen) not in kept["read"]
            if not is_new and are_unchanged(kept["read"]):
                return _read(kept["ledger"])
        return None

    def read_sources(self) -> Mapping[str, str]:
        """Return the digests of the cached ledger's sources, or none if they have changed."""
        kept: Mapping[str, str] = self.store.read().get(self.program, {}).get("read", {})
        return kept if are_unchanged(kept) else {}

    def save(self, ledger: Ledger, read: Mapping[str, str]) -> None:
        """Store a ledger without failures; a row that no rung read may be this machine's fault."""
        if ledger.failures or any(row.rung == UNREAD for row in ledger.judgements):
            return
        self.store.write({self.program: {"read": dict(read), "ledger": _write(ledger)}})


def _write(ledger: Ledger) -> dict[str, Any]:
    return {
        "system": ledger.system,
        "citation": ledger.citation,
        "judgements": [asdict(row) for row in ledger.judgements],
        "findings": [asdict(found) for found in ledger.findings],
        "shipped": sorted(ledger.shipped),
        "left": [asdict(row) for row in ledger.left],
        "origin": asdict(ledger.origin),
    }


def _read(kept: dict[str, Any]) -> Ledger:
    """Read a stored ledger; raises ValueError for a row that cannot be read."""
    judgements = [read_judgement(row) for row in kept["judgements"]]
    rows = tuple(row for row in judgements if row is not None)
    if len(rows) < len(judgements):
        raise ValueError("a row cannot be read")
    return Ledger(
        kept["system"],
        kept["citation"],
        rows,
        tuple(_read_finding(found) for found in kept["findings"]),
        frozenset(kept["shipped"]),
        left=tuple(map(_read_left, kept["left"])),
        origin=Origin(**kept["origin"]),
    )


def _read_left(kept: dict[str, Any]) -> Left:
    return Left(**{**kept, "place": Place(**kept["place"]), "state": State(kept["state"])})


def _read_finding(kept: dict[str, Any]) -> LedgerFinding:
    lists = {name: tuple(kept[name]) for name in ("marks", "follows")}
    lists["costs"] = tuple(LedgerCost(**cost) for cost in kept["costs"])
    said = {"verdict": Verdict(kept["verdict"]), "weight": Weight(kept["weight"])}
    place = Place(**kept["place"]) if kept["place"] else None
    return LedgerFinding(**{**kept, **lists, **said, "place": place})
