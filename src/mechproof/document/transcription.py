"""The transcription of a paper -> the letters and prints that its derivation uses."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import sympy as sp

from mechproof.latex import Reader
from mechproof.nomenclature.block import read_block
from mechproof.nomenclature.declarations import declare
from mechproof.record import Claim, Correction, Datum, Equation, Notation, Row, Statement, Variable
from mechproof.sources.displays import Printed, find_displays
from mechproof.sources.paper_files import read_source

R = TypeVar("R", bound=Row)
# A group, so that `split` keeps the commands.
_COMMAND = re.compile(r"(\\[a-zA-Z]+)")


class Transcription:
    r"""A paper's transcription in a LaTeX file: its letters in a block, its rows as displays.

    Displays are named as `mechproof check` names them: by their numbers, their tags (`\tag*` is
    a name without brackets) or their labels. A display cites the sentences that its row judges,
    `\cite{S6,S48}`.
    """

    def __init__(self, file: Path) -> None:
        """Read the file.

        Raises `DocumentError`, `BlockError`, and `ValueError` for two displays with the same name.
        """
        self.file = file
        source = read_source(str(file))
        block = read_block(source.lines, source.files)
        declared = declare(block, assume=True)
        block.refuse_faults()
        self.variables: tuple[Variable, ...] = declared.variables
        self.where: tuple[sp.Basic, ...] = declared.where
        self.notation: Notation = declared.notation
        self._displays = self._name(find_displays(source.text, cut=False))

    def _name(self, displays: Iterable[Printed]) -> dict[str, Printed]:
        named: dict[str, Printed] = {}
        for display in displays:
            for name in (display.name, *display.labels):
                if name in named:
                    raise ValueError(f"{self.file}: two displays are called {name}")
                named[name] = display
        return named

    def reader(
        self, variables: Sequence[Variable] = (), notation: Notation | None = None
    ) -> Callable[[str], tuple[Any, ...]]:
        """Return a function from a display's name to its members, in given letters or the file's.

        The function raises what `find` and `mechproof.latex` raise.
        """
        members = Reader(variables or self.variables, notation or self.notation).members
        return lambda number: members(self.equation(number))

    def find(self, number: str) -> str:
        """Return the LaTeX of a display by its name.

        Raises `ValueError` if the file has no such display.
        """
        return self._find(number).latex.string

    def symbols(self, names: str) -> tuple[Any, ...]:
        """Return the symbols of letters given by their names, separated by blanks.

        Raises `ValueError` for a letter that the block does not declare.
        """
        known: dict[str, sp.Basic] = {str(v.symbol): v.symbol for v in self.variables}
        if missing := [name for name in names.split() if name not in known]:
            raise ValueError(f"{self.file}: its block does not declare {', '.join(missing)}")
        return tuple(known[name] for name in names.split())

    def give(self, values: Mapping[sp.Basic, Any]) -> tuple[Variable, ...]:
        """Return the variables of all letters, some with the values that they are given by.

        Raises `ValueError` for a symbol that is not a letter of the block.
        """
        letters = {v.symbol for v in self.variables}
        if unknown := [str(symbol) for symbol in values if symbol not in letters]:
            raise ValueError(f"{self.file}: its block does not declare {', '.join(unknown)}")
        return tuple(replace(v, given=values.get(v.symbol)) for v in self.variables)

    def equation(self, number: str, says: Statement | None = None, **more: Any) -> Equation:
        """Return a numbered equation; `more` are other fields of `mechproof.record.Row`."""
        return self._make(Equation, number, says, more)

    def claim(self, number: str, says: Statement | None = None, **more: Any) -> Claim:
        """Return any other statement; arguments as for `equation`."""
        return self._make(Claim, number, says, more)

    def datum(self, number: str, says: Statement | None = None, **more: Any) -> Datum:
        """Return a datum; arguments as for `equation`."""
        return self._make(Datum, number, says, more)

    def mend(self, number: str, old: str, new: str, says: Statement | None = None) -> Correction:
        """Return a display as it should be printed, with each occurrence of a part replaced.

        Letters in the names of commands are not replaced. Raises `ValueError` if the part does not
        occur or the replacement changes nothing.
        """
        printed = self.find(number)
        pieces = [printed] if "\\" in old else _COMMAND.split(printed)
        mended = "".join(p if _COMMAND.fullmatch(p) else p.replace(old, new) for p in pieces)
        if not old or mended == printed:
            raise ValueError(f"{self.file}: {new!r} for {old!r} does not change display {number}")
        return Correction(mended, says)

    def _make(self, kind: type[R], number: str, says: Statement | None, more: dict[str, Any]) -> R:
        display = self._find(number)
        return kind(number, display.latex.string, says, **{"cites": display.cites, **more})

    def _find(self, number: str) -> Printed:
        if number not in self._displays:
            raise ValueError(f"{self.file}: it has no display {number}")
        return self._displays[number]
