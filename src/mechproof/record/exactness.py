"""The content that a record may have: exact numbers, and texts and names fit for code and files."""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from keyword import iskeyword
from math import isfinite
from numbers import Real
from typing import Any

import sympy as sp

from mechproof.record.parts import has_parts

# Unicode categories that no text of a record may have: invisible characters and those that reorder
# others.
REFUSED = {
    "Cc": "a control character",
    "Cf": "an invisible character or one that changes the writing direction",
    "Cs": "half a character",
    "Zl": "a line separator",
    "Zp": "a paragraph separator",
}
# Blanks that a text may have; comments and docstrings write them as spaces.
BLANKS = "\n\t"


class RecordError(ValueError):
    """A record with contents that make no sense: a fault of the derivation, not of the paper."""


def make_exact(record: object, *names: str) -> None:
    """Turn numbers and matrices of the named fields into SymPy's; refuse any that are not exact."""
    for name in names:
        value = getattr(record, name)
        if isinstance(value, sp.MatrixBase):
            value = sp.ImmutableMatrix(value)
        elif isinstance(value, int | Fraction) and not isinstance(value, bool):
            value = sp.Rational(value)
        if not isinstance(value, sp.Expr | sp.MatrixBase):
            where = f"{type(record).__name__}: {name} = {value!r}"
            raise RecordError(f"{where}: must be a SymPy expression, an integer or a fraction")
        if has_parts(value, sp.Float):
            where = f"{type(record).__name__}: {name} = {value}"
            raise RecordError(f"{where}: has a float; write Rational('0.1')")
        object.__setattr__(record, name, value)


def to_number(where: str, value: Any) -> float:
    """Return a finite plain number, also for one of SymPy's; raises `RecordError` for others."""
    if isinstance(value, Real | sp.Expr):
        try:
            number = value if isinstance(value, int | float) else float(value)
        except TypeError:
            number = float("nan")
        if isfinite(number):
            return number
    raise RecordError(f"{where} = {value!r}: must be a number")


def is_name(name: object) -> bool:
    """Return whether it can name a function, a parameter and a file."""
    if not isinstance(name, str) or unicodedata.normalize("NFKC", name) != name:
        return False
    return name.isidentifier() and not name.startswith("_") and not iskeyword(name)


def check_name(what: str, name: object) -> None:
    """Raise ValueError for a name that cannot be used in code and for a file."""
    if not is_name(name):
        raise ValueError(
            f"{what} = {name!r}: it names code and files, so it must consist of letters, digits "
            "and underscores, begin with a letter and not be a keyword of Python"
        )


def check_texts(record: Any, where: str) -> None:
    """Raise ValueError if a text of a record, at any depth, has a character that is refused."""
    if isinstance(record, str):
        # A text that can be printed has no such character.
        if not record.isprintable():
            _check_text(record, where)
    elif isinstance(record, tuple):
        for item in record:
            check_texts(item, where)
    elif isinstance(record, Mapping):
        for item in record.values():
            check_texts(item, where)
    elif is_dataclass(record):
        for field in fields(record):
            check_texts(getattr(record, field.name), f"{where}, {field.name}")


def _check_text(text: str, where: str) -> None:
    for letter in text:
        kind = REFUSED.get(unicodedata.category(letter))
        if kind and letter not in BLANKS:
            raise ValueError(f"{where}: {text!r} has U+{ord(letter):04X}, {kind}; leave it out")
