"""The transcription of a paper -> the letters and the prints that its derivation takes from it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import sympy as sp

from mechproof.document.block import read_block
from mechproof.document.displays import Printed, find_displays
from mechproof.document.sources import read_source
from mechproof.document.symbols import declare
from mechproof.record import Claim, Datum, Equation, Notation, Row, Variable

R = TypeVar("R", bound=Row)


class Transcription:
    r"""What a paper prints, from a LaTeX file: its letters in a block, its rows as displays.

    Displays are named as `mechproof check` names them: by their numbers, their tags (`\tag*` is
    a name without brackets) or their labels.
    """

    def __init__(self, file: Path) -> None:
        """Read the file.

        Raises `DocumentError`, `BlockError`, and `ValueError` for two displays of one name.
        """
        self.file = file
        source = read_source(str(file))
        declared = declare(read_block(source.lines, source.files), assume=True)
        self.variables: tuple[Variable, ...] = declared.variables
        self.where: tuple[sp.Basic, ...] = declared.where
        self.notation: Notation = declared.notation
        self.prints: Mapping[str, str] = self._name(find_displays(source.text, cut=False))

    def _name(self, displays: Iterable[Printed]) -> dict[str, str]:
        prints: dict[str, str] = {}
        for display in displays:
            for name in (display.name, *display.labels):
                if name in prints:
                    raise ValueError(f"{self.file}: two displays are called {name}")
                prints[name] = display.latex.string
        return prints

    def symbols(self, names: str) -> tuple[Any, ...]:
        """Return the symbols of letters by their names, separated by blanks.

        Raises `ValueError` for one that the block does not declare.
        """
        known: dict[str, sp.Basic] = {str(v.symbol): v.symbol for v in self.variables}
        if missing := [name for name in names.split() if name not in known]:
            raise ValueError(f"{self.file}: its block declares no {', '.join(missing)}")
        return tuple(known[name] for name in names.split())

    def give(self, values: Mapping[sp.Basic, Any]) -> tuple[Variable, ...]:
        """Return the variables of the letters, with what some of them are given by.

        Raises `ValueError` for a symbol that is no letter of the block.
        """
        letters = {v.symbol for v in self.variables}
        if unknown := [str(symbol) for symbol in values if symbol not in letters]:
            raise ValueError(f"{self.file}: its block declares no {', '.join(unknown)}")
        return tuple(replace(v, given=values.get(v.symbol)) for v in self.variables)

    def equation(self, number: str, **says: Any) -> Equation:
        """Return a numbered equation; `says` are further fields of `mechproof.record.Row`."""
        return self._make(Equation, number, says)

    def claim(self, number: str, **says: Any) -> Claim:
        """Return any other statement, in the same way."""
        return self._make(Claim, number, says)

    def datum(self, number: str, **says: Any) -> Datum:
        """Return a datum, in the same way."""
        return self._make(Datum, number, says)

    def _make(self, kind: type[R], number: str, says: dict[str, Any]) -> R:
        if number not in self.prints:
            raise ValueError(f"{self.file}: it has no display {number}")
        return kind(number, self.prints[number], **says)
