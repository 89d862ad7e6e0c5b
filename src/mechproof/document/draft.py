"""A first block of letters, to be confirmed: the letters of a paper and what its words say of them.

Nothing of a draft is used before it stands in the paper.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from mechproof.document.complex_parts import find_unit
from mechproof.document.displays import Printed, find_displays
from mechproof.document.letters import (
    Collected,
    collect_letters,
    is_vector,
    name_symbol,
)
from mechproof.document.rows import Document
from mechproof.document.said import Said, find_said
from mechproof.document.sources import Source

_RATE = re.compile(
    r"\\d?dot\s*(?:\{\s*)?(\\[A-Za-z]+(?:\s*\{\w+\})?|[A-Za-z])([^{}]*(?:\{[^{}]*\})?[^{}]*)\}?(.*)\Z",
    re.DOTALL,
)
# A reference, or a number in brackets.
_REFERENCE = re.compile(r"\\(?:eq|c|C|auto)?ref\s*\{([^{}]*)\}|(\(\d+(?:\.\d+)*[a-z]?\))")
# Characters between a reference and the equation that it is made for.
_NEAR = 400
# Seconds to find out whether a letter is a matrix.
_LIMIT = 10.0
_DEPENDS = re.compile(r"(.+?)\((\\?[A-Za-z]+)\)\Z", re.DOTALL)
# Letters that could be something else where nothing declares them.
_ASKED = {
    "e": r"a letter here, Euler's number elsewhere",
    "d": "a letter here, a differential elsewhere",
    "i": "a letter here, an index or the imaginary unit elsewhere",
}


@dataclass
class _Entry:
    """A letter: its prints, and the letter that it depends on."""

    names: dict[str, None] = field(default_factory=dict)
    running: str = ""


def draft_block(source: Source) -> str:
    """Return a block of letters for a paper; what was found in its words says where."""
    displays = list(find_displays(source.text))
    prints = [printed.latex.string for printed in displays]
    unit = find_unit(prints)
    collected = collect_letters(prints, guess=True, imaginary=unit)
    shapes = Document(replace(source, lines=[], has_block=False)).find_sizes(_LIMIT)
    said = dict(find_said(source))
    lines = [
        line
        for name, entry in _list_entries(collected, shapes).items()
        for line in _write(name, entry, shapes.get(name), said.get(name))
    ]
    if collected.factors:
        lines.append("# A bracket follows each of these: they are taken to multiply it.")
        lines += [f"factor {name}" for name in collected.factors]
    lines += [f"imaginary {unit}"] if unit else []
    lines += [f"function {name} is {meant}" for name, meant in collected.functions.items()]
    lines += _ask_what_follows(source, displays)
    for number, reason in collected.unread.items():
        place = source.files.locate(displays[number].latex.offsets[0])
        lines.append(f"# {displays[number].name}, line {place.line}: its letters are missing here:")
        lines.append(f"#   {' '.join(reason.split())}")
    return "\n".join(["%% mechproof", *(f"%% {line}" for line in lines), "%% end", ""])


def _ask_what_follows(source: Source, displays: Sequence[Printed]) -> Iterator[str]:
    """Yield which equations words before another refer to: it may follow from these."""
    names = {label: one.name for one in displays for label in (*one.labels, one.name)}
    starts = [one.latex.offsets[0] for one in displays]
    met: dict[int, dict[str, int]] = {}
    for match in _REFERENCE.finditer(source.text.string):
        offset = source.text.offsets[match.start()]
        name = names.get(match[1] or match[2], "")
        after = bisect_right(starts, offset)
        before = {one.name for one in displays[:after]}
        if name in before and after < len(starts) and starts[after] - offset < _NEAR:
            met.setdefault(after, {}).setdefault(name, source.files.locate(offset).line)
    for after, found in met.items():
        if len(found) > 1:
            one, others = displays[after].name, ", ".join(found)
            yield f"# line {min(found.values())} refers to {others}. Does {one} follow from them?"
            yield f"# follows {one}: {others}"


def _list_entries(collected: Collected, shapes: Mapping[str, tuple[int, int]]) -> dict[str, _Entry]:
    """Return the letters by the names of their symbols; a derivative says what its letter is of.

    Vectors and matrices are not differentiated: their derivatives are letters of their own.
    """
    entries: dict[str, _Entry] = {}
    for letter in (*collected.letters, *collected.guessed):
        base, running = _split(letter)
        if running and (is_vector(base) or name_symbol(base) in shapes):
            base, running = letter, ""
        entry = entries.setdefault(name_symbol(base), _Entry())
        entry.names[base] = None
        entry.running = entry.running or running
    return entries


def _split(letter: str) -> tuple[str, str]:
    r"""Return a letter and what it is a function of: x and t of \dot x and of x(t)."""
    if rate := _RATE.match(letter):
        return rate[1] + rate[2] + rate[3], "t"
    if depends := _DEPENDS.match(letter):
        return depends[1].strip(), depends[2]
    return letter, ""


def _write(
    name: str, entry: _Entry, size: tuple[int, int] | None, found: Said | None
) -> Iterator[str]:
    first, *alike = entry.names
    if is_vector(first) and not size:
        yield "# A vector or a matrix? Give its size after the name: 3x1"
    if first in _ASKED:
        yield f"# {_ASKED[first]}:"
    if found:
        yield f"# line {found.line} says:"
    running = f"({entry.running})" if entry.running else ""
    others = "".join(f" | {other}" for other in alike)
    shape = f" {size[0]}x{size[1]}" if size else ""
    unit = f" [{found.unit}]" if found and found.unit else ""
    yield f"{first}{running}{others}{shape} : {found.meaning if found else ''}{unit}".rstrip()
