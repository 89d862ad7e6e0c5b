"""Quantities that sentences say without a letter: "a bolt with an area of 157 mm²"."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from mechproof.nomenclature.cells import find_unit
from mechproof.nomenclature.inline import DISPLAY
from mechproof.nomenclature.units import Unit
from mechproof.sources.files import Source

_NUMBER = re.compile(r"(?<![\w.,^{}/])(?P<digits>\d+(?:[.,]\d+)?)(?![\w])(?P<behind>.{1,30})", re.S)
# Where the unit behind a number may end: before the word "in", that is no inch.
_ENDS = re.compile(r"(?<! in)(?=[\s.,;:)])|\Z")


@dataclass(frozen=True)
class SaidQuantity:
    """Digits and their unit, where they stand in the text, and in which line."""

    digits: str
    unit: Unit
    text: str
    place: int
    line: int


def find_quantities(source: Source) -> Iterator[SaidQuantity]:
    """Yield the numbers with a unit that stand between displays."""
    text = DISPLAY.sub(lambda match: " " * len(match[0]), source.text.string)
    for match in _NUMBER.finditer(text):
        behind = match["behind"]
        ends = [end.start() for end in _ENDS.finditer(behind)]
        units = ((behind[:end], find_unit(behind[:end])) for end in reversed(ends))
        if found := next(((printed, unit) for printed, unit in units if unit), None):
            line = source.files.locate(source.text.offsets[match.start()]).line
            shown = f"{match['digits']}{found[0]}".replace("$", "").strip()
            digits = match["digits"].replace(",", ".")
            yield SaidQuantity(digits, found[1], " ".join(shown.split()), match.end("digits"), line)
