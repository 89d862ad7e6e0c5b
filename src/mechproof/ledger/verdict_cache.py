"""Cache: the verdicts of the rows that have not changed since they were last judged.

A row is judged again if its record, the domain, a source file of the prover or the version of
Python, SymPy or flint differs. One file for each derivation holds the rows of its last run. For a
folder, the files of folders with the same name are read as well: what is installed is often also
checked out.

The fingerprint of a record is a key that is equal for equal records only. It follows what SymPy
compares (the class and hashable content of each node), so it is the same in every process; dummies
are numbered in the order in which they are met.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, fields, is_dataclass
from fractions import Fraction
from glob import escape
from hashlib import sha256
from pathlib import Path
from typing import Any

import sympy as sp
from sympy.core.function import UndefinedFunction
from sympy.external.gmpy import GROUND_TYPES

from mechproof.proof.verdict import Judgement
from mechproof.record import Paper
from mechproof.tools.cache import Store, cache_folder, make_key, name_place
from mechproof.tools.json_rows import read_object

# The rung of a row that no rung could read: the reason may be this machine's (memory, depth of
# recursion).
UNREAD = "none"
PACKAGES = ("sympy", "python-flint")
LAYERS = ("record", "latex", "arithmetic", "sources", "statement_domains", "proof")


def prover_sources() -> list[Path]:
    """Return the source files that verdicts depend on."""
    package = Path(__file__).parents[1]
    return [path for name in LAYERS for path in sorted((package / name).rglob("*.py"))]


def make_keys(paper: Paper, sources: Sequence[object]) -> list[str]:
    """Return a key for each row of a paper, or for each source from which rows are stated.

    It is empty for a source that has no key, whose verdicts are not stored.
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
    """The judgements of one derivation by the keys of its rows, or of the sources of these."""

    def __init__(self, location: Path) -> None:
        self.store = Store(f"{name_place(location)}.json")
        self.named_alike = f"{escape(location.stem)}-*.json" if location.is_dir() else ""

    def load(self) -> dict[str, tuple[Judgement, ...]]:
        """Return the stored judgements; unreadable entries count as missing."""
        alike = sorted(cache_folder().glob(self.named_alike)) if self.named_alike else ()
        stores = (*(Store(file.name) for file in alike), self.store)
        entries = [entry for store in stores for entry in store.read().items()]
        return {key: found for key, entry in entries if (found := _read_all(entry))}

    def save(self, judgements: Mapping[str, tuple[Judgement, ...]]) -> None:
        """Replace the stored judgements by these."""
        kept = {k: found for k, found in judgements.items() if all(j.rung != UNREAD for j in found)}
        self.store.write({k: list(map(asdict, found)) for k, found in kept.items() if k})


def _read_all(entry: Any) -> tuple[Judgement, ...]:
    """Return the judgements of one key; () if one of them cannot be read."""
    with suppress(ValueError, TypeError):
        return tuple(read_object(Judgement, row, "a row") for row in entry)
    return ()


class NoFingerprintError(TypeError):
    """A record contains something that two processes cannot compare: code, or a foreign class."""


class Fingerprint:
    """The keys of everything visited so far; shared parts are visited once."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[object, str]] = {}
        self._dummies: dict[int, int] = {}

    def copy(self) -> Fingerprint:
        """Return an independent copy that starts from the current state."""
        other = Fingerprint()
        other._known, other._dummies = dict(self._known), dict(self._dummies)
        return other

    def visit(self, part: Any) -> str:
        """Return the key of a record, an expression, a text, a number, or a collection of these.

        Raises `NoFingerprintError` for anything else.
        """
        if id(part) not in self._known:
            # The part is kept with its key, because its id is unique only while it lives.
            self._known[id(part)] = (part, _digest(*self._encode(part)))
        return self._known[id(part)][1]

    def _encode(self, part: Any) -> tuple[str, ...]:
        for kind, encode in _ENCODERS:
            if isinstance(part, kind):
                return (kind.__name__, *encode(self, part))
        if isinstance(part, _PLAIN):
            return (type(part).__name__, repr(part))
        if is_dataclass(part) and not isinstance(part, type):
            values = ((field.name, getattr(part, field.name)) for field in fields(part))
            return (_name_class(type(part)), *map(self.visit, values))
        raise NoFingerprintError(f"{part!r} of {type(part)}")

    def _number(self, dummy: sp.Dummy) -> tuple[str, ...]:
        place = self._dummies.setdefault(dummy.dummy_index, len(self._dummies))
        assumptions = sorted(dummy.assumptions0.items())
        return (dummy.name, str(place), str(assumptions))

    def _content(self, node: sp.Basic) -> tuple[str, ...]:
        return (self.visit(type(node)), *map(self.visit, node._hashable_content()))

    def _entries(self, matrix: sp.MatrixBase) -> tuple[str, ...]:
        return (str(matrix.shape), *map(self.visit, matrix.flat()))

    def _items(self, mapping: Mapping[Any, Any]) -> tuple[str, ...]:
        return tuple(sorted(self.visit(tuple(item)) for item in mapping.items()))

    def _members(self, collection: Any) -> tuple[str, ...]:
        keys = map(self.visit, collection)
        return tuple(sorted(keys) if isinstance(collection, frozenset) else keys)


def _describe_class(kind: type) -> tuple[str, ...]:
    if isinstance(kind, UndefinedFunction):
        return (kind.__name__, str(sorted(kind._kwargs.items())))
    return (_name_class(kind),)


def _name_class(kind: type) -> str:
    """Return the name of a class whose code the prover's key and the versions cover."""
    if not f"{kind.__module__}.".startswith(("sympy.", "mechproof.record.")):
        raise NoFingerprintError(f"the class {kind.__module__}.{kind.__qualname__}")
    return f"{kind.__module__}.{kind.__qualname__}"


def _digest(*texts: str) -> str:
    """Return a hash of texts; their lengths keep them apart."""
    joined = "".join(f"{len(text)}:{text}" for text in texts)
    return sha256(joined.encode("utf-8", "surrogatepass")).hexdigest()


_PLAIN = (int, float, str, type(None), Fraction)
# Tried in this order: a dummy is also a node.
_ENCODERS: tuple[tuple[type, Callable[[Fingerprint, Any], tuple[str, ...]]], ...] = (
    (sp.Dummy, Fingerprint._number),
    (sp.MatrixBase, Fingerprint._entries),
    (sp.Basic, Fingerprint._content),
    (type, lambda walk, kind: _describe_class(kind)),
    (Mapping, Fingerprint._items),
    (tuple, Fingerprint._members),
    (frozenset, Fingerprint._members),
    (list, Fingerprint._members),
)
