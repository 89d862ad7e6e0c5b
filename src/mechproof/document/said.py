r"""What the words of a paper say of its letters: their meaning, unit and size, matched by layout.

A sentence ("$r$ is the radius"), an item of a list that begins or ends with a letter, the first
columns of a table. Words are matched, not understood.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from mechproof.document.letters import name_symbol
from mechproof.document.sources import Source
from mechproof.document.units import UnitError, read_unit

_NAME = r"\$(?P<name>[^$&|\n]{1,30}?)\s*=?\s*\$"
_UNIT = r"(?:\s*(?:\[([^\]\[]{1,12})\]|\(in\s+([^)]{1,12})\)|,?\s+in\s+(mm|m|rad|kg|N|s|deg)\b))?"
_VERBS = r"(?:is|are|denotes?|represents?|stands? for|means|being|:|--|---|\u2013|\u2014)"
_ARTICLE = r"(?:the\s+|an?\s+)?"
_BULLET = r"^[ \t]*(?:[-*+]|\\item|\d+\.)[ \t]+"
_PATTERNS = (
    re.compile(
        rf"{_NAME}\s*{_VERBS}\s+{_ARTICLE}(?P<meaning>[^.,;:$\\\n(\[]{{3,60}}?)"
        rf"{_UNIT}(?=[.,;:(\n\\$]|\s+and\s)"
    ),
    re.compile(
        rf"(?:\b(?:[Ll]et|and|[Hh]ere|[Ww]here|[Ww]ith)|,)\s+{_NAME}\s+(?:be\s+)?the\s+(?P<meaning>[^.,;:$\\\n(\[]{{3,60}}?)"
        rf"{_UNIT}(?=[.,;:(\n\\$]|\s+and\s)"
    ),
    re.compile(
        rf"{_BULLET}{_NAME}[ \t]*[:,]?[ \t]*(?P<meaning>[^\W\d_][^.,;:$\\\n(\[]{{2,60}}?)"
        rf"{_UNIT}[ \t]*(?=[.,;:(\n\\]|\Z)",
        re.MULTILINE,
    ),
    # A line of its own, between breaks: whatever the verb of its language is.
    re.compile(
        rf"^[ \t]*{_NAME}[ \t]+(?P<meaning>[^\W\d_][^.,;:$\\\n(\[]{{2,60}}?)"
        rf"{_UNIT}[ \t]*[.,;]?[ \t]*(?=\\newline|\\\\)",
        re.MULTILINE,
    ),
    re.compile(
        rf"{_BULLET}(?P<meaning>[^\W\d_][^.,;:$\\\n(\[]{{2,60}}?)[ \t]*[:,]?[ \t]+{_NAME}"
        rf"{_UNIT}[ \t]*[.,;]?[ \t]*$",
        re.MULTILINE,
    ),
    re.compile(
        r"^\s*\$(?P<name>[^$&]{1,30})\$\s*&\s*(?P<meaning>[^&$\\\n]{3,60}?)\s*"
        r"(?:&\s*(?:\\si\{)?\$?([^&$\\\n{}]{0,12})\$?\}?\s*)?(?:&[^\n]*)?(?:\\\\|$)",
        re.MULTILINE,
    ),
    re.compile(
        rf"^[ \t]*\|[ \t]*{_NAME}[ \t]*\|[ \t]*(?P<meaning>[^|$\\\n(\[]{{3,60}}?)[ \t]*"
        r"(?:\[([^\]\[]{1,12})\]|\([^)|]*\))?[ \t]*\|"
        r"(?:[ \t]*\[?([^|$\\\n\[\]]{1,12})\]?[ \t]*\|)?",
        re.MULTILINE,
    ),
)
_INLINE = re.compile(r"\\([()])")


@dataclass(frozen=True)
class Said:
    """What words say of a letter, and the line where."""

    meaning: str
    unit: str
    line: int


def find_said(source: Source) -> Iterator[tuple[str, Said]]:
    """Yield letters with what is said of them last, so that the first of a table wins."""
    string = _INLINE.sub(lambda match: " $" if match[1] == "(" else "$ ", source.text.string)
    for pattern in _PATTERNS:
        for match in reversed(list(pattern.finditer(string))):
            named = {*match.groupdict().values()}
            units = [group for group in match.groups() if group and group not in named]
            place = source.files.locate(source.text.offsets[match.start("name")])
            meaning = " ".join(match["meaning"].split()).strip(" ~*_")
            for name in match["name"].split(","):
                yield name_symbol(name), Said(meaning, _check_unit(units), place.line)


def _check_unit(units: list[str]) -> str:
    try:
        read_unit(units[0].strip()) if units else None
    except UnitError:
        return ""
    return units[0].strip() if units else ""
