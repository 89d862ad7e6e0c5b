"""Fingerprint: a record of statements and domains -> a key that is equal for equal records only.

It follows what SymPy compares (the class and hashable content of each node), so it is the same in
every process; dummies are numbered in the order in which they are met.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from hashlib import sha256
from typing import Any

import sympy as sp
from sympy.core.function import UndefinedFunction


class NoFingerprintError(TypeError):
    """A record holds what two processes cannot compare: code, or a class of a derivation."""


class Fingerprint:
    """The key of what has been visited so far; what is shared is visited once."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[object, str]] = {}
        self._dummies: dict[int, int] = {}

    def copy(self) -> Fingerprint:
        """Return one that goes on from here on its own."""
        other = Fingerprint()
        other._known, other._dummies = dict(self._known), dict(self._dummies)
        return other

    def visit(self, part: Any) -> str:
        """Return the key of a record, an expression, a text, a number, or a collection of these.

        Raises `NoFingerprintError` for anything else.
        """
        if id(part) not in self._known:
            # The part is kept with its key: its id is its own only while it lives.
            self._known[id(part)] = (part, _digest(*self._encode(part)))
        return self._known[id(part)][1]

    def _encode(self, part: Any) -> tuple[str, ...]:
        for kind, encode in _ENCODERS:
            if isinstance(part, kind):
                return (kind.__name__, *encode(self, part))
        if is_dataclass(part) and not isinstance(part, type):
            values = ((field.name, getattr(part, field.name)) for field in fields(part))
            return (_name(type(part)), *map(self.visit, values))
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
        return tuple(map(self.visit, collection))

    def _unordered(self, collection: frozenset[Any]) -> tuple[str, ...]:
        return tuple(sorted(map(self.visit, collection)))


def _describe_class(kind: type) -> tuple[str, ...]:
    if isinstance(kind, UndefinedFunction):
        return (kind.__name__, str(sorted(kind._kwargs.items())))
    return (_name(kind),)


def _name(kind: type) -> str:
    """Name a class whose code the key of the prover and its versions covers."""
    if not f"{kind.__module__}.".startswith(("sympy.", "mechproof.record.")):
        raise NoFingerprintError(f"the class {kind.__module__}.{kind.__qualname__}")
    return f"{kind.__module__}.{kind.__qualname__}"


def _digest(*texts: str) -> str:
    """Hash texts; their lengths keep them apart."""
    joined = "".join(f"{len(text)}:{text}" for text in texts)
    return sha256(joined.encode("utf-8", "surrogatepass")).hexdigest()


def _repr(walk: Fingerprint, value: object) -> tuple[str, ...]:
    return (repr(value),)


# Tried in this order: a dummy is a node, True is an int.
_ENCODERS: tuple[tuple[type, Callable[[Fingerprint, Any], tuple[str, ...]]], ...] = (
    (sp.Dummy, Fingerprint._number),
    (sp.MatrixBase, Fingerprint._entries),
    (sp.Basic, Fingerprint._content),
    (type, lambda walk, kind: _describe_class(kind)),
    (bool, _repr),
    (int, _repr),
    (float, _repr),
    (str, _repr),
    (type(None), _repr),
    (Fraction, _repr),
    (Mapping, Fingerprint._items),
    (tuple, Fingerprint._members),
    (frozenset, Fingerprint._unordered),
    (list, Fingerprint._members),
)
