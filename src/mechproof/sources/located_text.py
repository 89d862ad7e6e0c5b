"""Text that knows the file and place of each of its characters."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, chain
from re import Match, Pattern


@dataclass(frozen=True)
class Place:
    """A place in a file; lines and columns are counted from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True)
class LocatedText:
    """Characters, and the place of each in all files read, counted as if they were one text."""

    string: str
    offsets: Sequence[int]

    def __len__(self) -> int:
        return len(self.string)

    def __getitem__(self, part: slice) -> LocatedText:
        return LocatedText(self.string[part], self.offsets[part])

    def __add__(self, other: LocatedText) -> LocatedText:
        return LocatedText(self.string + other.string, (*self.offsets, *other.offsets))

    def strip(self, *, end: str = "") -> LocatedText:
        """Return the text without blanks around it or the characters `end` at its end."""
        kept = self.string.rstrip().rstrip(end + " \t\n") if end else self.string.rstrip()
        # In \right. the point is the bracket.
        kept += "." if kept.endswith(r"\right") and self.string[len(kept) :][:1] == "." else ""
        return self[len(kept) - len(kept.lstrip()) : len(kept)]

    def replace(
        self, pattern: Pattern[str], make: Callable[[Match[str]], str | LocatedText | None]
    ) -> LocatedText:
        """Replace matches by other characters, which are located where their match begins.

        A match is kept if `make` returns None for it; located characters keep their places.
        """
        parts, last = [], 0
        for match in pattern.finditer(self.string):
            made = make(match)
            if made is not None:
                made = self.put(made, match.start()) if isinstance(made, str) else made
                parts += [self[last : match.start()], made]
                last = match.end()
        return join([*parts, self[last:]])

    def put(self, string: str, place: int) -> LocatedText:
        """Return other characters, all located at a place of this text."""
        return LocatedText(string, (self.offsets[place],) * len(string))


def join(parts: Sequence[LocatedText]) -> LocatedText:
    """Return texts joined one after the other."""
    offsets = tuple(chain.from_iterable(part.offsets for part in parts))
    return LocatedText("".join(part.string for part in parts), offsets)


@dataclass
class Files:
    """The files that were read, in the order in which they were met."""

    names: list[str] = field(default_factory=list)
    contents: list[str] = field(default_factory=list)

    def add(self, name: str, content: str) -> LocatedText:
        """Add a file and return its text."""
        start = sum(len(text) + 1 for text in self.contents)
        self.names.append(name)
        self.contents.append(content)
        return LocatedText(content, range(start, start + len(content)))

    def locate(self, offset: int) -> Place:
        """Return the place in a file for an offset of a text."""
        starts = [0, *accumulate(len(text) + 1 for text in self.contents)]
        file = bisect_right(starts, offset) - 1
        before = self.contents[file][: offset - starts[file]]
        line = before.rpartition("\n")[2]
        return Place(self.names[file], before.count("\n") + 1, len(line) + 1)
