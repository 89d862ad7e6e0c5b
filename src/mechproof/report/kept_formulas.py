"""Formulas that a report has written before: MathML by its LaTeX, kept from one run to the next."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from hashlib import sha256
from pathlib import Path

from mechproof.tools.cache import Store, make_key

# What an entry rests on besides its LaTeX: what writes it.
WRITERS = tuple(map(Path(__file__).with_name, ("mathml.py", "breaks.py", "formulas.py")))
PACKAGES = ("latex2mathml", "sympy")
# More entries are of old papers.
MOST_KEPT = 10_000


class KeptFormulas:
    """What was written before, by the digest of its LaTeX and of what writes it."""

    def __init__(self, store: Store) -> None:
        self.store = store
        self.new: dict[str, str] = {}

    @cached_property
    def known(self) -> dict[str, str]:
        """Return what is kept, read once; what is no text is damaged."""
        return {k: text for k, text in self.store.read().items() if isinstance(text, str)}

    @cached_property
    def version(self) -> str:
        """Return the digest of what writes formulas."""
        return make_key(WRITERS, PACKAGES)

    def find(self, latex: str, display: str, write: Callable[[str, str], str]) -> str:
        """Return what is known of a formula, else what writes it returns."""
        key = sha256("\n".join((self.version, display, latex)).encode()).hexdigest()
        if key not in self.known:
            self.new[key] = self.known[key] = write(latex, display)
        return self.known[key]

    def keep(self) -> None:
        """Keep what is new for the next run."""
        if self.new:
            self.store.write(dict(list({**self.store.read(), **self.new}.items())[-MOST_KEPT:]))
            self.new = {}


FORMULAS = KeptFormulas(Store("formulas.json"))
