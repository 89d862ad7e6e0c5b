"""Texts and names of records: what may stand in generated code, on pages and in names of files."""

from __future__ import annotations

import unicodedata
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from keyword import iskeyword
from typing import Any

# Categories of Unicode that no text of a record has: what is not seen, or turns what is.
REFUSED = {
    "Cc": "a control character",
    "Cf": "an invisible character or one that turns the direction of writing",
    "Cs": "half a character",
    "Zl": "a line separator",
    "Zp": "a paragraph separator",
}
# Blanks that a text may have; a comment or a docstring writes them as one.
BLANKS = "\n\t"


def is_name(name: object) -> bool:
    """Return whether it can name a function, a parameter and a file."""
    if not isinstance(name, str) or unicodedata.normalize("NFKC", name) != name:
        return False
    return name.isidentifier() and not name.startswith("_") and not iskeyword(name)


def check_name(what: str, name: object) -> None:
    """Raise ValueError for what cannot name code and a file."""
    if not is_name(name):
        raise ValueError(
            f"{what} = {name!r}: it names code and files, so it must be of letters, digits and "
            "underscores, begin with a letter and be no keyword of Python"
        )


def check_texts(record: Any, where: str) -> None:
    """Raise ValueError for a text of a record, at any depth, with a character that is refused."""
    if isinstance(record, str):
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
