"""Tables of sizes and results -> rows: each result is its formula's value at its line's sizes.

A letter without a known unit may be read in degrees, and sizes in different units as bare numbers
or as lengths, times and so on: the reading with which most lines agree is meant. A number that is
wrong only if its line's sizes are unrounded is left open.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp

from mechproof.document.known import BLOCK, Known
from mechproof.document.numbers.scales import Result, RoundedSize, Scales
from mechproof.document.tasks import Role, Sign, Task
from mechproof.latex import Reader
from mechproof.nomenclature.cells import (
    MATH,
    NOTHING,
    Head,
    Numeral,
    find_formula,
    find_unit,
    finds_decimal_commas,
    is_unit_or_empty,
    read_head,
    read_numeral,
)
from mechproof.proof.verdict import Left, State
from mechproof.record import Equation, Paper
from mechproof.record.unit_notation import Unit
from mechproof.sources.located_text import Files, Place
from mechproof.sources.tabulars import TableCell, Tabular

# Rows that may hold the heads, as heads of groups of columns may come above them.
_HEAD_ROWS = 3
_COMMA = "numbers such as 1,234: is the comma decimal, or does it separate thousands?"
_NONE_AGREES = "few lines agree with the formula: do units or sizes differ from those declared?"
_NEAR = "it differs from the recomputed number, but rounded sizes may explain the difference"
Numbers = Sequence[Mapping[int, Numeral | None]]


@dataclass(frozen=True)
class Grid:
    """The heads of a table by column, and the lines below; a table may lie on its side.

    `unread` are heads with a formula that cannot be read, or that may be words.
    """

    name: str
    heads: Mapping[int, Head]
    lines: Sequence[Sequence[TableCell]]
    unread: Sequence[TableCell] = ()


@dataclass(frozen=True)
class _Formulas:
    """A column's formulas, the print they are from, and the letters that its definition lacks."""

    values: tuple[sp.Expr, ...]
    first: str
    lacks: str = ""


@dataclass
class _Met:
    """The letters that a table's formulas use, and the columns that may be inputs."""

    used: set[sp.Basic] = field(default_factory=set)
    inputs: list[tuple[sp.Basic, Left]] = field(default_factory=list)


def _describe_lack(letters: str) -> str:
    return f"the formula needs {letters}: found neither in the table nor among the declared sizes"


def find_grid(name: str, table: Tabular, reader: Reader) -> Grid | None:
    """Return a table with two letters in its head or its first column; None for any other table."""
    columns = [*zip(*table.rows, strict=True)]
    heads = [(row, table.rows[n:]) for n, row in enumerate(table.rows[:_HEAD_ROWS], start=1)]
    for row, lines in (*heads, (columns[0], columns[1:])):
        found = {n: head for n, cell in enumerate(row) if (head := read_head(cell.string, reader))}
        if len(found) > 1:
            unread = [c for n, c in enumerate(row) if n not in found and _shows_formula(c, reader)]
            return _take_units(Grid(name, found, lines, unread))
    return None


def find_head_units(tables: Sequence[Tabular], reader: Reader) -> Iterator[tuple[str, str, int]]:
    """Yield the letters in heads, their units, and the place of the table."""
    for table in tables:
        if grid := find_grid("", table, reader):
            for head in grid.heads.values():
                if head.is_letter and head.unit:
                    yield head.printed, head.unit.name, table.offset


def _shows_formula(cell: TableCell, reader: Reader) -> bool:
    """Return whether a head shows a formula."""
    return bool(MATH.search(cell.string)) or find_formula(cell.string, reader) is not None


def _take_units(grid: Grid) -> Grid:
    """Move the units in a line that holds only units to the heads."""
    for number, line in enumerate(grid.lines):
        cells = {n: line[n].string for n in grid.heads}
        units = {n: find_unit(text) for n, text in cells.items()}
        if any(units.values()) and all(map(is_unit_or_empty, cells.values())):
            heads = {n: replace(h, unit=h.unit or units[n]) for n, h in grid.heads.items()}
            lines = [*grid.lines[:number], *grid.lines[number + 1 :]]
            return replace(grid, heads=heads, lines=lines)
    return grid


class SizeTables:
    """The tables of a paper, read with what its equations say about its letters."""

    def __init__(self, known: Known, files: Files, paper: Paper) -> None:
        self.known = known
        self.files = files
        self.paper = paper
        self.told: list[tuple[Place, str]] = []

    def read(self, tables: Sequence[Tabular]) -> Iterator[Task | Left]:
        """Yield a row for each result; tables and columns not compared are noted in `told`."""
        reader = self.known.symbols.reader()
        for number, table in enumerate(tables, start=1):
            grid = find_grid(f"table {number}", table, reader)
            found = list(self._read_grid(grid)) if grid else []
            if grid:
                for head in grid.heads.values():
                    self.known.met.update(head.symbol.free_symbols)
            yield from found
            for cell in grid.unread if grid and found else ():
                reason = "is not compared: its head cannot be read"
                self._describe(cell.offset, f"the column {cell.string.strip()} {reason}")
            if not found:
                lacks = "its head has fewer than two letters"
                if grid:
                    lacks = "it shows no numbers of a letter with a formula"
                reason = f"this table is not compared: {lacks}"
                self._describe(table.offset, reason)

    def _read_grid(self, grid: Grid) -> Iterator[Task | Left]:
        texts = [line[n].string for line in grid.lines for n in grid.heads]
        comma = finds_decimal_commas(texts)
        numbers: Numbers = [
            {n: read_numeral(line[n].string, decimal_comma=bool(comma)) for n in grid.heads}
            for line in grid.lines
        ]
        met = _Met()
        for column, head in grid.heads.items():
            is_result = head.symbol in self.known.values or not head.is_letter
            if not is_result or not any(line[column] for line in numbers):
                continue
            if reason := self._refuse(head, grid) or (_COMMA if comma is None else ""):
                name = f"{grid.name}, {head.printed}"
                yield self._leave(name, grid.lines[0][column], reason)
                continue
            yield from self._read_column(grid, column, numbers, met)
        # An input that no equation gives is taken as it stands.
        yield from (row for symbol, row in met.inputs if symbol not in met.used)

    def _refuse(self, head: Head, grid: Grid) -> str:
        """Return why a column is not compared, or "" if it is."""
        symbols = self.known.symbols
        if head.words:
            return (
                f"{head.words!r} appears next to the letter: are its numbers computed, or measured?"
            )
        if sum(other.symbol == head.symbol for other in grid.heads.values()) > 1:
            return "two columns for one letter: which one is computed?"
        for other in grid.heads.values():
            declared = symbols.find_dimension(other.symbol)
            if other.unit is None or declared is None:
                continue
            if other.unit.dimension != declared:
                return f"the unit of {other.printed} differs from that in the block of letters"
            if declared.time and other.unit.dimension.angle != declared.angle:
                return f"the unit of {other.printed}: turns, or radians?"
        return ""

    def _read_column(
        self, grid: Grid, column: int, numbers: Numbers, met: _Met
    ) -> Iterator[Task | Left]:
        """Yield the rows of one letter's results, grouped by the formulas that give them."""
        head, groups = grid.heads[column], dict[_Formulas, list[Result]]()
        missing: dict[str, TableCell] = {}
        for count, (line, found) in enumerate(zip(grid.lines, numbers, strict=True), start=1):
            name, number = f"{grid.name}, line {count}, {head.printed}", found[column]
            if number is None:
                if any(found.values()) and line[column].string.strip(NOTHING):
                    yield self._leave(name, line[column], "no number can be read in this cell")
                continue
            scales = Scales(self.known.symbols, grid.heads.values())
            sizes = {
                h.symbol: scales.size(h, one)
                for n, h in grid.heads.items()
                if n != column and h.is_letter and (one := found[n])
            }
            formulas = self._find_formulas(head.symbol, sizes)
            if not formulas.values:
                missing.setdefault(formulas.lacks, line[column])
                continue
            unit = number.unit or head.unit
            factor = number.factor * scales.convert(self._find_own(head, unit), unit)
            usual = {s: RoundedSize(v) for s, v in self.known.symbols.usual.items()}
            letters = set().union(*(formula.free_symbols for formula in formulas.values))
            met.used |= letters
            used = {s: v for s, v in {**usual, **sizes}.items() if s in letters}
            result = Result(name, line[column].offset, head, number, factor, used)
            groups.setdefault(formulas, []).append(result)
        for formulas, results in groups.items():
            yield from self._compare(formulas, results, grid)
        for lacks, cell in missing.items():
            reason = _describe_lack(lacks)
            if not head.is_letter:
                self._describe(cell.offset, f"the column {head.printed} is not compared: {reason}")
                continue
            row = self._leave(f"{grid.name}, {head.printed}", cell, reason)
            if self.known.printed.get(head.symbol) == BLOCK:
                met.inputs.append((head.symbol, row))
            else:
                yield row

    def _find_formulas(self, symbol: sp.Basic, sizes: Mapping[sp.Basic, RoundedSize]) -> _Formulas:
        """Return the formulas of a letter in the sizes of a line, or the letters it lacks.

        A letter with its own formula may be computed, or be taken from the table, rounded. A later
        print may need fewer letters than the definition.
        """
        usual = self.known.symbols.usual
        have = {*sizes, *usual, *self.known.symbols.branches} - {symbol}
        taken = sizes.keys() - {symbol}
        formulas = self.known.list_formulas(symbol, have, taken)
        found = tuple(one for one in formulas if not isinstance(one, sp.MatrixBase))
        needed = self.known.settle(symbol, stop=taken).free_symbols
        lacks = ", ".join(sorted(map(str, needed - have))) or "other letters"
        first = self.known.printed.get(symbol, "")
        if found:
            return _Formulas(found, first)
        for name, formula in self.known.list_restated(symbol, have, taken):
            return _Formulas((formula,), name, lacks)
        return _Formulas((), first, lacks)

    def _compare(
        self, formulas: _Formulas, results: Sequence[Result], grid: Grid
    ) -> Iterator[Task | Left]:
        """Yield the rows of results, using the reading with which most of them agree."""
        head = results[0].head
        scales = Scales(self.known.symbols, grid.heads.values())
        own = self._find_own(head, results[0].number.unit or head.unit)
        first, *others = (scales.list_readings(formula, own) for formula in formulas.values)
        also = [branch for readings in others for reading in readings for branch in reading]
        readings = [(*reading, *also) for reading in first]
        chosen = [[result.choose(reading) for result in results] for reading in readings]
        best = max(range(len(readings)), key=lambda n: len([*filter(None, chosen[n])]))
        letters = set().union(*(formula.free_symbols for formula in formulas.values))
        are_told = letters <= {one.symbol for one in grid.heads.values()}
        pairs = zip(results, chosen[best], strict=True)
        # Zeros agree in any unit.
        telling = [found for result, found in pairs if result.number.value != 0] or chosen[best]
        agreeing = len([*filter(None, telling)])
        if 2 * agreeing < len(telling) and not (are_told and scales.are_known({*letters, own})):
            name = f"{grid.name}, {head.printed}"
            yield self._leave(name, TableCell(results[0].text, results[0].offset), _NONE_AGREES)
            return
        every = [branch for reading in readings for branch in reading]
        for result, found in zip(results, chosen[best], strict=True):
            if found is None and any(map(result.is_near, every)):
                yield self._leave(result.name, TableCell(result.text, result.offset), _NEAR)
            else:
                yield self._make_task(result, found or readings[best][0], formulas)

    def _find_own(self, head: Head, unit: Unit | None) -> sp.Basic | None:
        """Return the letter whose unit a column has; for a formula, one of letters that share it.

        A formula without such a letter is a number, or counts in the SI unit.
        """
        symbols = self.known.symbols
        own = head.symbol if head.is_letter else symbols.find_alike(head.symbol.free_symbols)
        is_fit = unit is not None and unit.dimension == symbols.find_dimension(own)
        return own if head.is_letter or is_fit else None

    def _make_task(self, result: Result, formula: sp.Expr, formulas: _Formulas) -> Task:
        row = Equation(
            result.name, result.text, says=result.state(formula), read_as=result.describe()
        )
        sign = Sign(Role.NUMBER, None, formulas.first)
        place = self.files.locate(result.offset)
        rests_on = (formulas.first, _describe_lack(formulas.lacks)) if formulas.lacks else ("", "")
        return Task(row, place, sign, self.paper, asserts=True, rests_on=rests_on)

    def _describe(self, offset: int, reason: str) -> None:
        self.told.append((self.files.locate(offset), reason))

    def _leave(self, name: str, cell: TableCell, reason: str) -> Left:
        return Left(name, self.files.locate(cell.offset), cell.string, State.NOT_JUDGED, reason)
