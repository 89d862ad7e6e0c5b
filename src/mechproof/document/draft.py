"""A first block of letters, to be confirmed: the letters of a paper and what its words say of them.

Nothing of a draft is used before it stands in the paper: words are matched, not understood.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from mechproof.document.displays import find_displays
from mechproof.document.letters import (
    collect_letters,
    find_shapes,
    group_alike,
    is_vector,
    name_symbol,
)
from mechproof.document.sources import Source
from mechproof.document.units import UnitError, read_unit

_ACCENT = re.compile(r"\\d?dot\s*\{?\s*(\\[A-Za-z]+|[A-Za-z])\s*\}?(.*)\Z", re.DOTALL)
_UNIT = r"(?:\s*(?:\[([^\]\[]{1,12})\]|\(in\s+([^)]{1,12})\)|,?\s+in\s+(mm|m|rad|kg|N|s|deg)\b))?"
_VERBS = r"(?:is|are|denotes?|represents?|stands? for|means|being|:|--|---|\u2013|\u2014)"
_SENTENCE = re.compile(
    rf"\$(?P<name>[^$]{{1,30}})\$\s*{_VERBS}\s+(?:the\s+|an?\s+)?(?P<meaning>[^.,;:$\\\n(\[]{{3,60}}?)"
    rf"{_UNIT}(?=[.,;:(\n\\$]|\s+and\s)",
)
_TABLE = re.compile(
    r"^\s*\$(?P<name>[^$&]{1,30})\$\s*&\s*(?P<meaning>[^&$\\\n]{3,60}?)\s*"
    r"(?:&\s*(?:\\si\{)?\$?([^&$\\\n{}]{0,12})\$?\}?\s*)?(?:&[^\n]*)?(?:\\\\|$)",
    re.MULTILINE,
)


@dataclass(frozen=True)
class Said:
    """What words say of a letter, and the line where."""

    meaning: str
    unit: str
    line: int


def draft_block(source: Source) -> str:
    """Return a block of letters for a paper; what was found in its words says where."""
    displays = list(find_displays(source.text))
    prints = [printed.latex.string for printed in displays]
    collected = collect_letters(prints)
    letters, factors = collected.letters, collected.factors
    said = dict(_find_said(source))
    moved = {_find_moved(letter) for letter in letters}
    shapes = dict(find_shapes(prints))
    lines = []
    for letter, *alike in group_alike(letters):
        if _find_moved(letter):
            continue
        others = "".join(f" | {other}" for other in alike)
        found = said.get(name_symbol(letter))
        size = shapes.get(name_symbol(letter))
        shape = f" {size[0]}x{size[1]}" if size else ""
        if is_vector(letter) and not size:
            lines.append("# A vector or a matrix? Say its size behind the name: 3x1")
        running = "(t)" if name_symbol(letter) in moved else ""
        unit = f" [{found.unit}]" if found and found.unit else ""
        if found:
            lines.append(f"# line {found.line} says:")
        lines.append(
            f"{letter}{running}{others}{shape} : {found.meaning if found else ''}{unit}".rstrip()
        )
    if factors:
        lines.append(
            "# A bracket stands behind these. Factors, or functions? Functions are declared"
        )
        lines.append("# with their brackets as one letter, f(x).")
        lines += [f"# factor {name}" for name in factors]
    for number, reason in collected.unread.items():
        place = source.files.locate(displays[number].latex.offsets[0])
        lines.append(f"# {displays[number].name}, line {place.line}: its letters are not listed:")
        lines.append(f"#   {' '.join(reason.split())}")
    return "\n".join(["%% mechproof", *(f"%% {line}" for line in lines), "%% end", ""])


def _find_moved(letter: str) -> str:
    r"""Return the name of the letter of which this one is the derivative: x of \dot x."""
    match = _ACCENT.match(letter)
    return name_symbol(match[1] + match[2]) if match else ""


def _find_said(source: Source) -> Iterator[tuple[str, Said]]:
    """Yield letters with what is said of them last, so that the first of a table wins."""
    string = source.text.string
    for pattern in (_SENTENCE, _TABLE):
        for match in reversed(list(pattern.finditer(string))):
            units = [group for group in match.groups()[2:] if group]
            place = source.files.locate(source.text.offsets[match.start("name")])
            meaning = " ".join(match["meaning"].split()).strip(" ~")
            for name in match["name"].split(","):
                yield name_symbol(name), Said(meaning, _check_unit(units), place.line)


def _check_unit(units: list[str]) -> str:
    try:
        read_unit(units[0].strip()) if units else None
    except UnitError:
        return ""
    return units[0].strip() if units else ""
