"""Ledgers that are cached whole: a paper whose files have not changed is not even loaded.

A ledger is made anew when a file that the derivation opened, a module that it may have loaded, a
file of the package, or the version of any installed package differs. Other inputs of a derivation,
such as the clock or the environment, are not noticed.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import fields
from pathlib import Path

from mechproof.derivation import find_file
from mechproof.ledger.judged import Ledger
from mechproof.ledger.verdict_cache import UNREAD
from mechproof.tools.cache import Store, are_unchanged, digest_program, name_place
from mechproof.tools.json_rows import as_json, read_object


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
                return read_object(Ledger, kept["ledger"], self.store.name)
        return None

    def read_sources(self) -> Mapping[str, str]:
        """Return the digests of the cached ledger's sources, or none if they have changed."""
        kept: Mapping[str, str] = self.store.read().get(self.program, {}).get("read", {})
        return kept if are_unchanged(kept) else {}

    def save(self, ledger: Ledger, read: Mapping[str, str]) -> None:
        """Store a ledger without failures; a row that no rung read may be this machine's fault."""
        if ledger.failures or any(row.rung == UNREAD for row in ledger.judgements):
            return
        written = {f.name: as_json(getattr(ledger, f.name)) for f in fields(Ledger)}
        self.store.write({self.program: {"read": dict(read), "ledger": written}})
