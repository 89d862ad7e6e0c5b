"""Expressions: in, a text; out, its nested lists with their lines, and its numbers, exact."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

_TOKEN = re.compile(r'(?P<skip>\s+|;[^\n]*)|(?P<text>"(?:[^"\\]|\\.)*")|(?P<mark>[()\[\]])'
                    r'|(?P<atom>[^\s()\[\];"]+)')  # fmt: skip
_CLOSING = {"(": ")", "[": "]"}
# Deeper than any formula, and below what Python's own stack holds.
DEEPEST = 150


class FPCoreError(ValueError):
    """A text of FPCore that cannot be read; it says where and why."""


@dataclass(frozen=True)
class Atom:
    """A word, a number or a text in quotes, with its line."""

    text: str
    line: int


@dataclass(frozen=True)
class Group:
    """What stands in brackets, with the line of the opening one."""

    parts: tuple[Atom | Group, ...]
    line: int


Node = Atom | Group


def read_expressions(text: str) -> tuple[Node, ...]:
    """Return the expressions of a text; `FPCoreError` for brackets that do not match."""
    waiting: list[tuple[str, int, list[Node]]] = [("", 1, [])]
    for mark, line in _list_tokens(text):
        if mark in _CLOSING:
            if len(waiting) > DEEPEST:
                raise FPCoreError(f"line {line}: nested more than {DEEPEST} deep")
            waiting.append((mark, line, []))
        elif mark in _CLOSING.values():
            opening, start, parts = waiting.pop()
            if not waiting or _CLOSING.get(opening) != mark:
                raise FPCoreError(f"line {line}: {mark} closes nothing")
            waiting[-1][2].append(Group(tuple(parts), start))
        else:
            waiting[-1][2].append(Atom(mark, line))
    if len(waiting) > 1:
        opening, line, _ = waiting[-1]
        raise FPCoreError(f"line {line}: {opening} is not closed")
    return tuple(waiting[0][2])


def _list_tokens(text: str) -> Iterator[tuple[str, int]]:
    place, line = 0, 1
    while place < len(text):
        found = _TOKEN.match(text, place)
        if found is None:
            raise FPCoreError(f"line {line}: a text in quotes is not closed")
        if found.lastgroup != "skip":
            yield found.group(), line
        line += found.group().count("\n")
        place = found.end()


def read_file(path: Path) -> str:
    """Return the text of a file; `FPCoreError` for one that is no text."""
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise FPCoreError(f"it is no text in UTF-8: {error.reason}") from error


_DECIMAL = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d{1,4})?", re.IGNORECASE)
_FRACTION = re.compile(r"[+-]?\d+/0*[1-9]\d*")
_HEXADECIMAL = re.compile(r"([+-]?)0x([0-9a-f]+)(?:\.([0-9a-f]+))?(?:p([+-]?\d{1,4}))?", re.I)


def read_number(text: str) -> Fraction | None:
    """Return the value of a number, None for what is none."""
    if _DECIMAL.fullmatch(text) or _FRACTION.fullmatch(text):
        return Fraction(text)
    if found := _HEXADECIMAL.fullmatch(text):
        sign, whole, part, power = found.groups()
        digits = int(whole + (part or ""), 16) * Fraction(2) ** (
            int(power or 0) - 4 * len(part or "")
        )
        return -digits if sign == "-" else digits
    return None
