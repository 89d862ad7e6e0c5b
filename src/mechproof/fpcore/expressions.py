"""Expressions: in, a text; out, its nested lists, each with the line on which it begins."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
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
