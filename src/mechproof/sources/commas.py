"""Commas and points between digits: decimal ones, and those that part thousands, 1{,}000."""

from __future__ import annotations

import re

from mechproof.sources.displays import find_displays
from mechproof.sources.located_text import LocatedText

_COMMA = re.compile(r"(?<=\d)\{,\}(?=\d)")
_NUMBER = re.compile(r"(?<![\d.])\d+(?:\{,\}\d+)+")
_THOUSANDS = re.compile(r"[1-9]\d{0,2}(?:\{,\}\d{3})+")
# With this package a comma is decimal where no blank follows; in indices it parts numbers.
_ICOMMA = re.compile(r"\\usepackage\s*(?:\[[^\]]*\])?\s*\{[^{}]*\bicomma\b[^{}]*\}")
_DECIMAL = re.compile(r"_\{[^{}]*\}|\\(?:\w*ref|label|tag|cite)\*?\{[^{}]*\}|(?<=\d),(?=\d)")
_WORDS = re.compile(r"\\(?:text|mbox|\w*ref|label|tag)\w*\*?\s*\{[^{}]*\}")
# A point may part thousands, too: 1.500.
_PARTING = re.compile(r"(?<=\d)\.(?=\d{3}(?!\d))")
_POINT = re.compile(r"\d\.(?!\d{3}(?!\d))\d")


def mark_decimals(text: LocatedText) -> LocatedText:
    """Return a text with 3{,}5 for 3,5, if it says so of its commas."""
    if not _ICOMMA.search(text.string):
        return text
    return text.replace(_DECIMAL, lambda match: "{,}" if match[0] == "," else match[0])


def join_thousands(text: LocatedText) -> LocatedText:
    """Return a text without what parts thousands: commas, or points beside decimal commas."""
    numbers = _NUMBER.findall(text.string)
    if not numbers:
        return text
    prints = (_WORDS.sub(" ", one.latex.string) for one in find_displays(text))
    has_points = any(map(_POINT.search, prints))
    if not all(map(_THOUSANDS.fullmatch, numbers)):
        # Beside decimal commas points part thousands.
        return text if has_points else text.replace(_PARTING, lambda match: "")
    return text.replace(_COMMA, lambda match: "") if has_points else text
