"""Sizes that sentences state anew: "with d=20 mm we have instead" behind sizes d=16 mm.

A sentence may also choose one for a letter that a formula gives: "we choose M16 with A=157 mm²".
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from mechproof.document.numbers.scales import Scales
from mechproof.nomenclature.cells import Head, Numeral, find_unit
from mechproof.nomenclature.inline import Inline, SaidQuantity, find_inline, find_quantities
from mechproof.nomenclature.symbols import Symbols
from mechproof.record.unit_notation import Unit
from mechproof.sources.displays import Printed
from mechproof.sources.paper_files import Source

# The word behind a formula, which may be its unit.
_NEXT = re.compile(r"(?:\s|~|\\[,; ])*([^\s,;.]+)")


@dataclass(frozen=True)
class Restated:
    """A size that a sentence says of a letter, in its unit, and at which place and line."""

    letter: sp.Basic
    value: sp.Expr
    place: int
    line: int


class RestatedSizes:
    """What sentences say of the sizes of letters, in the order of the text."""

    def __init__(self, source: Source, symbols: Symbols) -> None:
        """Find the sentences; of a sum or a formula nothing is taken."""
        self.usual = symbols.usual
        self.order = {offset: place for place, offset in enumerate(source.text.offsets)}
        letters = {name: v.symbol for v in symbols.variables for name in v.latex}
        self.found = [*_find(source, letters, symbols)]
        self.quantities = [*find_quantities(source)]

    def list_before(self, printed: Printed) -> dict[sp.Basic, Restated]:
        """Return the sizes that hold at an equation and are not those of the block."""
        place = self._find_place(printed)
        last = {one.letter: one for one in self.found if one.place < place}
        return {
            s: one
            for s, one in last.items()
            if s not in self.usual or not _is_same(one.value, self.usual[s])
        }

    def list_quantities(self, printed: Printed) -> list[SaidQuantity]:
        """Return what sentences before an equation say without a letter, the last first."""
        place = self._find_place(printed)
        return [one for one in reversed(self.quantities) if one.place < place]

    def list_zeros(self, before: Printed | None, printed: Printed) -> set[sp.Basic]:
        """Return the letters that are said to be zero between two equations."""
        first, last = self._find_place(before) if before else -1, self._find_place(printed)
        return {one.letter for one in self.found if first < one.place < last and one.value == 0}

    def _find_place(self, printed: Printed) -> int:
        return self.order.get(printed.latex.offsets[printed.taken], -1)


def _find(source: Source, letters: Mapping[str, sp.Basic], symbols: Symbols) -> Iterator[Restated]:
    for one in find_inline(source, letters):
        letter = letters.get(one.letter)
        if letter is None or one.number is None:
            continue
        unit = one.number.unit or _find_behind(one, source, letter, symbols)
        number = Numeral(one.number.digits, one.number.factor, unit)
        size = Scales(symbols).size(Head(letter, one.letter, None), number)
        # Degrees of temperature have no scale.
        if size.value.is_finite:
            yield Restated(letter, size.value, one.end, one.line)


def _find_behind(one: Inline, source: Source, letter: sp.Basic, symbols: Symbols) -> Unit | None:
    """Return the unit in the words behind a formula, if it is one of the letter's dimension."""
    word = _NEXT.match(source.text.string, one.end)
    unit = find_unit(word[1]) if word and word[1] != "in" else None
    return unit if unit and unit.dimension == symbols.find_dimension(letter) else None


def _is_same(one: sp.Expr, other: sp.Expr) -> bool:
    """Return whether sizes are the same, or one is the other rounded, as radians are."""
    return bool(sp.Abs(one - other) <= sp.Abs(other) / 1000)
