"""Equations within sentences that a draft proposes: sizes of letters, and what these stand for."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass

import sympy as sp

from mechproof.document.cells import Numeral, name_unit, read_numeral
from mechproof.document.letters import name_symbol
from mechproof.document.sources import Source
from mechproof.document.units import ONE, read_unit

DISPLAY = re.compile(
    r"\$\$.*?\$\$|\\\[.*?\\\]|\\begin\{(?P<name>equation|align|gather|multline|eqnarray|tabular)"
    r"(?P<star>\*?)\}.*?\\end\{(?P=name)(?P=star)\}",
    re.DOTALL,
)
_INLINE = re.compile(r"(?<![\\$])\$(?P<dollar>[^$]{1,120}?)\$|\\\((?P<bracket>.{1,120}?)\\\)")
EQUATION = re.compile(r"\s*(?P<letter>[^=<>]+?)\s*=\s*(?P<value>[^=<>]+?)\s*[.,;]?\s*\Z")
RATE = re.compile(r"\\dot\s*\{?\s*(\\?[A-Za-z]+)\s*\}?")
_INDEXED = re.compile(r"(?P<stem>.+?)_\{?(?P<index>\\?[A-Za-z]+)\}?")
_DIGITS = re.compile(r"\A[-+\d.,{}\s]+")
# Words before what holds at a position, and not always.
_CASE = re.compile(r"\b(?:when(?:ever)?|if|once|until|at)\s+\Z", re.IGNORECASE)
_BEFORE = 20
# Angles are declared in radians.
_MEANT = {"°": "rad"}
_QUANTITY = re.compile(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{([^{}]*)\}|\\ang\s*\{([^{}]*)\}")


@dataclass(frozen=True)
class Inline:
    """What a sentence says of a letter, the line where, and whether words tell of a position.

    `end` is the place in the text behind it.
    """

    letter: str
    value: str
    line: int
    number: Numeral | None
    unit: str = ""
    is_case: bool = False
    end: int = 0

    def write_size(self, unit: str) -> str:
        """Return the size in a unit, nothing for one of another dimension."""
        assert self.number is not None
        own, meant = self.number.unit or ONE, read_unit(unit)
        if own.dimension != meant.dimension:
            return ""
        factor = sp.nsimplify(own.scale / meant.scale)
        if factor == 1:
            return f"{self.number.digits} {unit}".strip()
        return f"{self.number.digits}{_write_factor(factor * self.number.factor)}"


def _write_factor(factor: sp.Expr) -> str:
    above, below = sp.fraction(factor)
    pi, number = above.as_independent(sp.pi)[::-1]
    return rf"\cdot\frac{{{number}{pi if pi != 1 else ''}}}{{{below}}}".replace("pi", r"\pi")


def find_inline(source: Source, letters: Collection[str]) -> Iterator[Inline]:
    """Yield what sentences say that a letter of the equations is."""
    names = {name_symbol(letter): letter for letter in letters}
    text = DISPLAY.sub(lambda match: " " * len(match[0]), source.text.string)
    for match in _INLINE.finditer(text):
        found = EQUATION.match(match["dollar"] or match["bracket"])
        letter = names.get(name_symbol(found["letter"])) if found else None
        if found and (rate := RATE.fullmatch(found["letter"])) and name_symbol(rate[1]) in names:
            letter = found["letter"]
        if found is None or letter is None:
            continue
        value = found["value"]
        plain = _QUANTITY.sub(lambda one: one[3] + r"^\circ" if one[3] else one[1] + one[2], value)
        line = source.files.locate(source.text.offsets[match.start()]).line
        number = read_numeral(plain, decimal_comma="{,}" in plain)
        unit = name_unit(_DIGITS.sub("", plain)) if number and number.unit else ""
        is_case = bool(_CASE.search(text[max(match.start() - _BEFORE, 0) : match.start()]))
        yield Inline(letter, value, line, number, _MEANT.get(unit, unit), is_case, match.end())


def say_of_others(one: Inline, letters: Collection[str]) -> Iterator[tuple[str, str]]:
    r"""Yield other letters and what they stand for if one does: c_\beta as c_\alpha=\cos\alpha."""
    own = _INDEXED.fullmatch(one.letter)
    names = {name_symbol(letter) for letter in letters}
    for letter in letters if own and own["index"] in one.value else ():
        other = _INDEXED.fullmatch(letter)
        is_like = own and other and other["stem"] == own["stem"] and other["index"] != own["index"]
        if own and other and is_like and name_symbol(other["index"]) in names:
            yield letter, one.value.replace(own["index"], other["index"])
