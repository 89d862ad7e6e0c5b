"""Equations of a source -> rows to be judged, each with its role; what is not read says why."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import sympy as sp

from mechproof.document.block import Declared, read_block
from mechproof.document.complex_parts import find_unit, is_complex, split_parts
from mechproof.document.displays import Printed, find_displays
from mechproof.document.letters import (
    collect_letters,
    find_shapes,
    group_alike,
    is_vector,
    name_symbol,
)
from mechproof.document.lines import count_signs
from mechproof.document.mentions import is_listed, look_up, refuse_units, refuse_unknown
from mechproof.document.roles import (
    Known,
    Role,
    Sign,
    find_roles,
    give_values,
)
from mechproof.document.scopes import add_scopes
from mechproof.document.sides import have_same_letters, list_related, list_sides
from mechproof.document.size_tables import SizeTables
from mechproof.document.sources import Source
from mechproof.document.special_cases import (
    leave_seams_out,
    list_rates,
    round_at_sizes,
    specialise,
    split_branches,
    state_modulo,
)
from mechproof.document.symbols import declare
from mechproof.document.tabulars import find_tabulars
from mechproof.document.tasks import Task
from mechproof.latex import Reader, ReadingError
from mechproof.latex.expansion import read_row
from mechproof.processes import limit_time
from mechproof.proof.verdict import Left, Place, State
from mechproof.record import (
    Definition,
    Equality,
    Equation,
    Paper,
    PrintedNumber,
    Row,
)

T = TypeVar("T")
_DOUBLE = re.compile(r"\\(?:pm|mp)(?![A-Za-z])|[±∓]")
UNFIT = "numbers, matrices or their shapes do not fit together, or SymPy cannot put values in"
# What SymPy raises where values are put in that do not fit.
_UNFIT = (TypeError, ValueError, AttributeError, NotImplementedError)


class Document:
    """The equations of a paper and what its block declares."""

    def __init__(self, source: Source) -> None:
        """Raise `BlockError`, or `ValueError` for letters that do not go together."""
        self.files = source.files
        self.system = _name_system(source.files.names[0])
        self.printed = list(find_displays(source.text))
        self.tables = list(find_tabulars(source.text))
        self.told: list[tuple[Place, str]] = []
        self.block = read_block(source.lines, source.files)
        self.limit = 0.0
        self.papers: dict[bool, Paper] = {}
        self.taken: tuple[str, ...] = ()
        if not source.has_block:
            self._take_letters()
        refuse_unknown(self.block, self.printed)
        self._declare()

    def _take_letters(self) -> None:
        """Take letters that no block declares as numbers, or as the matrices they are printed."""
        prints = [p.latex.string for p in self.printed]
        self.block.imaginary = find_unit(prints)
        letters = collect_letters(prints, imaginary=self.block.imaginary).letters
        shapes = dict(find_shapes(prints))
        self.taken = tuple(x for x in letters if not is_vector(x) or name_symbol(x) in shapes)
        self.block.letters += [
            Declared(names, shape=shapes.get(name_symbol(names[0])))
            for names in group_alike(self.taken)
        ]

    def _declare(self) -> None:
        self.symbols = add_scopes(declare(self.block), self.block, self.printed)
        self.known = Known(self.symbols)
        give_values(self.block.values, self.known)

    def _parse_all(self) -> list[list[Sign] | Left]:
        """Read all equations once; again where letters are matrices, or such without a value."""
        while True:
            reader = self.symbols.reader()
            read = [self._parse(printed, reader) for printed in self.printed]
            sizes = {str(symbol): shape for symbol, shape in self.known.sizes.items()}
            if self.taken and sizes:
                self.block.letters = [
                    replace(x, shape=sizes.get(name_symbol(x.names[0]), x.shape))
                    for x in self.block.letters
                ]
                self._declare()
                continue
            symbols, entries = self.symbols.show_entries(self.known.values)
            if not entries or self.known.entries:
                return read
            self._declare()
            self.symbols = self.known.symbols = symbols
            self.known.entries = entries

    def find_sizes(self, limit: float) -> dict[str, tuple[int, int]]:
        """Return the sizes of the letters that are printed to be matrices, by their names."""
        self.limit = limit
        self._parse_all()
        return {name_symbol(x.names[0]): x.shape for x in self.block.letters if x.shape}

    def read(self, limit: float) -> list[Task | Left]:
        """Read all equations in their order: first what they define, then what they assert.

        One that takes longer than `limit` seconds is left.
        """
        self.limit = limit
        read = self._parse_all()
        values = self.known.values = {**self.known.values, **self.known.entries}
        real = {symbol: v for symbol, v in values.items() if not is_complex(self.known.settle(v))}
        self.papers = {
            with_units: self.symbols.paper(self.system, real, with_units=with_units)
            for with_units in (True, False)
        }
        again = self.symbols.reader(values)
        tables = SizeTables(self.known, self.files, self.papers[False])
        compared = list(tables.read(self.tables))
        self.told = tables.told
        equations = [
            row
            for printed, found in zip(self.printed, read, strict=True)
            for row in ([found] if isinstance(found, Left) else self._state(printed, found, again))
        ]
        return [*equations, *compared]

    def _parse(self, printed: Printed, reader: Reader) -> list[Sign] | Left:
        if printed.fault:
            return self._leave(printed, State.NOT_READ, printed.fault)
        if reason := look_up(printed, self.block.skipped):
            return self._leave(printed, State.SKIPPED, reason)
        return self._guard(printed, lambda: self._find_roles(printed, reader))

    def _find_roles(self, printed: Printed, reader: Reader) -> list[Sign] | Left:
        latex, branch = printed.latex.string, reader.notation.branch
        read = reader.parse(latex, printed.name, int(branch is None))
        if not any(chain.relations for chain in read.chains):
            return self._leave(printed, State.NOT_JUDGED, "it has no relation sign")
        refuse_units(read)
        double = _DOUBLE.search(latex) if branch is None else None
        follows = is_listed(printed, [*self.block.follows])
        if double is None and not follows:
            return find_roles(printed.name, read, self.known)
        # What has two signs, or follows, defines no letter.
        known = replace(
            self.known, values={**self.known.values}, printed={**self.known.printed}, others={}
        )
        signs = find_roles(printed.name, read, known)
        if double is None:
            return [
                replace(s, role=Role.CONSTRAINT) if s.role is Role.DEFINITION else s for s in signs
            ]
        if any(sign.role in (Role.DEFINITION, Role.REPEATED) for sign in signs):
            raise read.source.refuse(
                double.start(),
                "a double sign in what is said of a letter: both signs, or either?",
                r"Say branch \sigma=\pm1 in the block of letters.",
            )
        return signs

    def _state(
        self, printed: Printed, signs: Sequence[Sign], reader: Reader
    ) -> Sequence[Task | Left]:
        derived = {
            s.letter: self.known.values[s.letter]
            for s in signs
            if s.role is Role.DERIVATIVE and s.letter is not None
        }
        said = [s for s in signs if s.role is not Role.VALUE]
        bare = {s.letter for s in said} | {side for s in said for side in s.sides}
        known = {*derived, *self.known.values}
        defines = tuple(s for s in bare if isinstance(s, sp.Symbol) and s not in known)
        defines += tuple(
            s.letter
            for s in signs
            if s.role is Role.DEFINITION and isinstance(s.letter, sp.MatrixSymbol)
        )
        row = Equation(printed.name, printed.latex.string, derived=derived, defines=defines)

        own = next((s.letter for s in signs if s.letter is not None), None)
        own = own or self._find_alike(signs)

        def prepare() -> list[Task | Left]:
            rows = read_row(row, reader)
            pairs = [*zip(rows, signs, strict=True)]
            judged = count_signs(printed.latex.string[: printed.taken])
            parts = (part for pair in pairs[judged:] for part in split_parts(*pair, self.known))
            return [self._prepare(printed, *part, own) for part in parts]

        found = self._guard(printed, prepare)
        return [found] if isinstance(found, Left) else found

    def _find_alike(self, signs: Sequence[Sign]) -> sp.Basic | None:
        """Return a letter whose unit all letters have of which a first sign says a number."""
        letters: set[sp.Basic] = getattr(signs[0].value, "free_symbols", set()) if signs else set()
        units = {(self.symbols.find_dimension(x), self.symbols.scales.get(x)) for x in letters}
        return min(letters, key=str) if len(units) == 1 and (None, None) not in units else None

    def _guard(self, printed: Printed, act: Callable[[], T]) -> T | Left:
        """Do something with an equation; what it cannot be done with is left."""
        try:
            with limit_time(self.limit):
                return act()
        except ReadingError as error:
            return self._refuse(printed, error)
        except RecursionError:
            return self._leave(printed, State.NOT_READ, "it is nested too deeply to be read")
        except TimeoutError as error:
            return self._leave(printed, State.NOT_JUDGED, str(error))
        except _UNFIT as error:
            _, told, reason = str(error).partition(f"row {printed.name!r}: ")
            # What follows tells authors of modules what to declare.
            known = reason.partition(":")[0] if reason.startswith("nothing is known") else reason
            return self._leave(printed, State.NOT_JUDGED, known if told else UNFIT)

    def _prepare(self, printed: Printed, row: Row, sign: Sign, own: sp.Basic | None) -> Task | Left:
        """Make a task of a row, and one for each other member that it is compared with."""
        task = self._make(printed, row, sign, own)
        if isinstance(task, Left) or sign.role not in (Role.REPEATED, Role.DERIVATIVE):
            return task
        others = []
        if task.is_solution and not isinstance(sign.sides[0], sp.MatrixBase):
            one, other = sign.sides
            value = other if one == sign.letter else one
            self.known.cases.setdefault(sign.letter, []).append((printed.name, value))
        for name, value in self.known.list_others(sign.letter):
            if name == printed.name:
                continue
            sides = [value if side == sign.letter else side for side in sign.sides]
            other = replace(row, says=Equality(sides[0], sides[1], "member"))
            others.append(self._make(printed, other, replace(sign, first=name), own))
        return replace(task, others=tuple(o for o in others if isinstance(o, Task)))

    def _make(self, printed: Printed, row: Row, sign: Sign, own: sp.Basic | None) -> Task | Left:
        """Make a task of a row; `own` is the letter that its chain is about."""
        place = self._locate(printed)
        says = row.says
        if isinstance(says, Definition) and sign.role not in (Role.DEFINITION, Role.SIZE):
            members = (says.symbol, says.printed) if None in sign.sides else sign.sides
            row = replace(row, says=Equality(*members, "member"))
        is_introduced = sign.role is Role.DEFINITION and sign.letter in self.known.values
        if isinstance(says, Equality) and is_introduced:
            row = replace(row, says=Definition(sign.letter, self.known.values[sign.letter]))
        if isinstance(says, PrintedNumber) and sign.role is Role.SIZE:
            values = [side for side in sign.sides if not side.free_symbols]
            row = replace(row, says=Definition(sign.letter, values[0]))
        row = specialise(row, self.known)
        if sign.role is Role.DERIVATIVE:
            row = leave_seams_out(row)
        if sign.role is Role.NUMBER:
            number = round_at_sizes(sign, own, self.known)
            if isinstance(number, str):
                return Left(row.number, place, row.printed_latex, State.NOT_JUDGED, number)
            row = replace(row, says=number)
        row = replace(row, says=split_branches(row.statement, self.known))
        turn = look_up(printed, self.block.modulo)
        if turn and isinstance(row.says, Equality):
            row = replace(
                row, says=state_modulo(row.says, turn, self.known), note=f"Said modulo {turn}."
            )
        sides = list_sides(row, sign, self.known)
        letters = {sign.letter}.union(*(side.free_symbols for side in sides))
        letters |= list_related(row.says)
        is_special = sign.role is Role.CONSTRAINT and sign.letter is not None
        has_units = not (letters & self.symbols.bare or sign.number or is_special)
        paper = self.papers[has_units]
        residual = None
        if len(sides) == 2 and not any(isinstance(s, sp.MatrixBase) for s in sides):
            residual = sides[0] - sides[1]
        block = self.block
        is_claimed = is_listed(printed, [*block.identities, *block.modulo, *block.follows])
        asserts = is_claimed or self._asserts(printed, sign, sides)
        rates = () if residual is None else tuple(list_rates(residual, self.known))
        is_either = self._is_either(printed, sign, sides)
        follows = self._list_named(look_up(printed, self.block.follows) or ())
        group = next((one.group for one in self.printed if one.name == sign.first), None)
        is_case = printed.is_case or group == printed.group
        is_solution = sign.role is Role.REPEATED and is_case and not is_claimed
        return Task(
            row,
            place,
            sign,
            paper,
            asserts,
            is_claimed,
            residual,
            rates,
            is_either,
            is_solution,
            follows=follows,
        )

    def _list_named(self, keys: Sequence[str]) -> tuple[str, ...]:
        """Return the names of equations that are named by their labels."""
        names = {label: one.name for one in self.printed for label in one.labels}
        return tuple(names.get(key, key) for key in keys)

    def _asserts(self, printed: Printed, sign: Sign, sides: Sequence[Any]) -> bool:
        """Return whether the sides are claimed to be equal wherever their letters lie.

        Sides of different letters say something of the letters.
        """
        if None not in sign.sides and not any(side.free_symbols for side in sign.sides):
            return True
        if is_listed(printed, self.block.constraints) or sign.role is Role.CONSTRAINT:
            return False
        if sign.role is Role.RELATION or len(sides) < 2:
            return sign.role is not Role.RELATION
        return have_same_letters(sides)

    def _is_either(self, printed: Printed, sign: Sign, sides: Sequence[Any]) -> bool:
        """Return whether a constraint of two compound sides may be a wrong identity."""
        is_said = is_listed(printed, self.block.constraints)
        is_compound = sign.role is Role.CONSTRAINT and sign.letter is None and len(sides) == 2
        return is_compound and not is_said and have_same_letters(sides)

    def _locate(self, printed: Printed, place: int = 0) -> Place:
        offsets = printed.latex.offsets
        return self.files.locate(offsets[min(place or printed.taken, len(offsets) - 1)])

    def _leave(self, printed: Printed, state: State, reason: str, remedy: str = "") -> Left:
        latex = printed.latex.string
        return Left(printed.name, self._locate(printed), latex, state, reason, remedy)

    def _refuse(self, printed: Printed, error: ReadingError) -> Left:
        place = self._locate(printed, error.place)
        latex, reason = printed.latex.string, error.args[0]
        return Left(printed.name, place, latex, State.NOT_READ, reason, error.remedy)


def _name_system(file: str) -> str:
    """Name a paper as its file: letters, digits and underscores."""
    name = re.sub(r"\W", "_", Path(file).stem).strip("_")
    return name if name.isidentifier() else f"paper_{name}"
