"""What a paper is told of its characters: those read as other signs, letters that look like others.

It is said once, at the first of them; no verdict depends on it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from mechproof.latex.characters import find_disguised, find_replaced, name_character
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Files, Place

_Find = Callable[[str], Mapping[str, str]]
# Words within a display.
_WORDS = re.compile(r"\\(?:text[a-z]*|mbox|intertext|mathrm|operatorname\*?)\s*\{[^{}]*\}")


def tell_characters(displays: Sequence[Printed], files: Files) -> Iterator[tuple[Place, str]]:
    """Yield the place of the first character of each kind, and what is said of all of them."""
    if met := _find(find_replaced, displays, files):
        shown = ", ".join(f"{x} (U+{ord(x):04X}) as {sign}" for x, (_, sign) in met.items())
        yield _find_first(met), f"read as other signs: {shown}"
    if met := _find(find_disguised, displays, files):
        shown = ", ".join(f"{name_character(x)} like {sign}" for x, (_, sign) in met.items())
        yield _find_first(met), f"letters that look like others: {shown}"


def _find(find: _Find, displays: Sequence[Printed], files: Files) -> dict[str, tuple[Place, str]]:
    met: dict[str, tuple[Place, str]] = {}
    for printed in displays:
        latex = _WORDS.sub(lambda words: " " * len(words[0]), printed.latex.string)
        for sign, other in find(latex).items():
            met.setdefault(sign, (printed.locate(files, latex.index(sign)), other))
    return met


def _find_first(met: Mapping[str, tuple[Place, str]]) -> Place:
    place, _ = next(iter(met.values()))
    return place
