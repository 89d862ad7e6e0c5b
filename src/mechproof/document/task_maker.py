"""The signs of an equation -> tasks: what is compared, in which paper, and on whose claim."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.document.constraints.solutions import read_signs, state_signs, tie_pair
from mechproof.document.double_signs import split_parts
from mechproof.document.example_values import ExampleValues, SaidCases
from mechproof.document.known import Known
from mechproof.document.mentions import is_listed, is_met_once, look_up
from mechproof.document.numbers.letter_sizes import list_zeros
from mechproof.document.numbers.numerical_values import state_limit, turn_units
from mechproof.document.numbers.stated_numbers import StatedNumbers
from mechproof.document.row_sides import (
    find_units,
    gives_entries,
    has_letters,
    have_same_letters,
    is_solvable,
    list_sides,
    list_stated,
    ties_letters,
    ties_running,
)
from mechproof.document.special_cases import (
    list_rates,
    list_values,
    put_in,
    put_on,
    specialise,
    split_branches,
    state_modulo,
    stay_at_last_piece,
    stay_within_pieces,
)
from mechproof.document.tasks import CONSTRAINING, Role, Sign, Task
from mechproof.latex import Reader
from mechproof.latex.expansion import read_row
from mechproof.nomenclature.block import Block
from mechproof.proof.verdict import Left, State
from mechproof.record import (
    Conjunction,
    Definition,
    Equality,
    Equation,
    Paper,
    PrintedNumber,
    Row,
    Statement,
)
from mechproof.sources.displays import Printed
from mechproof.sources.lines import count_signs
from mechproof.sources.located_text import Files

# Roles of rows that are also compared at values which the nearby text states.
_SPECIAL = (Role.REPEATED, Role.DERIVATIVE, Role.STEP, *CONSTRAINING)


@dataclass(frozen=True)
class TaskMaker:
    """Makes tasks of a paper's equations once all their definitions are known.

    `papers` are the paper with the units of its letters (True), and without (False).
    """

    printed: Sequence[Printed]
    block: Block
    known: Known
    papers: Mapping[bool, Paper]
    files: Files
    numbers: StatedNumbers
    examples: ExampleValues
    cases: SaidCases

    def make(self, printed: Printed, signs: Sequence[Sign], reader: Reader) -> list[Task | Left]:
        """Make the tasks of an equation; `reader` knows the values of all letters."""
        derived = {
            s.letter: self.known.values[s.letter]
            for s in signs
            if s.role is Role.DERIVATIVE and s.letter in self.known.values
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
        has_sign = signs[0].role is Role.SOLUTIONS
        rows = read_row(row, read_signs(reader) if has_sign else reader)
        pairs = [*zip(rows, signs, strict=True)]
        dimensions = self.known.symbols.notation.dimensions
        if has_sign:
            pairs = [(state_signs(one, sign, dimensions), sign) for one, sign in pairs]
        judged = count_signs(printed.latex.string[: printed.taken])
        tied = (one for pair in pairs[judged:] for one in tie_pair(*pair, dimensions))
        parts = (part for one in tied for part in split_parts(*one, self.known))
        held = dict.fromkeys(self.known.held.get(printed.name, ()), sp.S.Zero)
        parts = (
            (put_on(r, held if s.role is Role.CONSTRAINT else {}), replace(s, own=own))
            for r, s in parts
        )
        tasks = ((self._prepare(printed, *part), part) for part in parts)
        zeros = list_zeros(printed, signs, self.printed, self.numbers.sizes)
        values = zeros, self.examples.list_at(printed), self.cases.list_at(printed, signs)
        return [self._add_special(printed, task, *part, *values) for task, part in tasks]

    def _add_special(
        self,
        printed: Printed,
        task: Task | Left,
        row: Row,
        sign: Sign,
        zeros: Mapping[sp.Basic, sp.Expr],
        local: Mapping[sp.Basic, Any],
        told: Mapping[sp.Basic, Any],
    ) -> Task | Left:
        """Add to a task its variants at values that nearby text or a worked example states.

        The values of an example that it may not belong to (`local`) and those of a case (`told`)
        have variants of their own.
        """
        if isinstance(task, Left) or task.residual is None or sign.role not in _SPECIAL:
            return task
        new = {s: v for s, v in zeros.items() if self.known.met[s] and s not in task.at}
        special = {**new, **self.examples.list_within(printed)}
        told = {s: v for s, v in told.items() if s in task.residual.free_symbols}
        made = {
            name: self._make(printed, put_on(row, values), sign, values)
            for name, values in (("special", special), ("local", local), ("case", told))
            if values
        }
        tasks = {n: t for n, t in made.items() if isinstance(t, Task) and has_letters(t.row.says)}
        got = tasks.get
        return replace(task, special=got("special"), local=got("local"), case=got("case"))

    def _prepare(self, printed: Printed, row: Row, sign: Sign) -> Task | Left:
        """Make a task of a row, with one for each other print or chain member to compare with."""
        task = self._make(printed, row, sign)
        if isinstance(task, Task) and sign.role is Role.STEP:
            return replace(task, others=tuple(self._exchange_members(printed, row, sign)))
        if isinstance(task, Left) or sign.role not in (Role.REPEATED, Role.DERIVATIVE):
            return task
        others = []
        first = (sign.letter, self.known.values.get(sign.letter))
        if sign.letter is not None and all(side in first for side in sign.sides):
            # The first print holds again.
            self.known.cases.pop(sign.letter, None)
        elif task.is_solution and sign.letter in self.known.values:
            value = next((side for side in sign.sides if side not in first), sign.sides[1])
            if not (isinstance(value, sp.MatrixBase) or printed.announced.example.number):
                self.known.cases.setdefault(sign.letter, []).append((printed.name, value))
            task = replace(task, anew=self.known.redefine(sign.letter, value, printed.name))
        for name, value in self.known.list_others(sign.letter):
            if name == printed.name:
                continue
            sides = [value if side == sign.letter else side for side in sign.sides]
            other = replace(row, says=Equality(sides[0], sides[1], "member"))
            others.append(self._make(printed, other, replace(sign, first=name)))
        return replace(task, others=tuple(o for o in others if isinstance(o, Task)))

    def _exchange_members(self, printed: Printed, row: Row, sign: Sign) -> Iterator[Task]:
        """Yield a step with a letter of it replaced by another member of that letter's chain."""
        letters = {s for side in sign.sides for s in getattr(side, "free_symbols", ())}
        for letter in sorted(letters & self.known.others.keys(), key=str):
            for name, value in self.known.others[letter]:
                if isinstance(value, sp.MatrixBase) or name.endswith(f" of {printed.name}"):
                    continue
                sides = [side.xreplace({letter: value}) for side in sign.sides]
                other = replace(row, says=Equality(sides[0], sides[1], "member"))
                made = self._make(printed, other, replace(sign, first=name, sides=tuple(sides)))
                if isinstance(made, Task):
                    yield made

    def _make(
        self, printed: Printed, row: Row, sign: Sign, local: Mapping[sp.Basic, Any] | None = None
    ) -> Task | Left:
        """Make a task of a row.

        `local` are values stated for the row, even of letters that other equations define.
        """
        place = printed.locate(self.files)
        if sign.role is Role.VALUE and sign.letter not in {None, *self.known.values}:
            reason = f"nothing else is printed about {sign.letter}"
            return Left(row.number, place, row.printed_latex, State.NOT_JUDGED, reason)
        at = {**list_values(row, self.known), **(local or {})}
        row = stay_at_last_piece(self._restate(row, sign), sign, printed, self.printed, self.known)
        row, sign = self._specialise(row, sign, at)
        number = self.numbers.state(printed, row, sign)
        if isinstance(number, str):
            return Left(row.number, place, row.printed_latex, State.NOT_JUDGED, number)
        row, sign, is_stated = number
        limited = state_limit(row, sign, self.known)
        turned = limited if isinstance(limited, str) else turn_units(limited, sign, self.known)
        if isinstance(turned, str):
            return Left(row.number, place, row.printed_latex, State.NOT_JUDGED, turned)
        row = replace(turned, says=split_branches(turned.statement, self.known))
        turn = look_up(printed, self.block.modulo)
        if turn and isinstance(row.says, Equality):
            row = replace(
                row,
                says=state_modulo(row.says, turn, self.known),
                note=f"Stated modulo {turn}.",
            )
        sides = list_sides(row, sign, self.known)
        units = find_units(row, sign, sides, self.known, self.papers, is_stated)
        paper = self.papers[units.are_known]
        residual = None
        if len(sides) == 2 and not any(isinstance(s, sp.MatrixBase) for s in sides):
            residual = sides[0] - sides[1]
        block = self.block
        is_claimed = is_listed(printed, [*block.identities, *block.modulo, *block.follows])
        is_claimed &= sign.role is not Role.DEFINITION
        asserts = is_claimed or self._asserts(printed, row.says, sign, sides)
        # Sides that are equal in some positions only have different derivatives.
        has_rates = residual is not None and sign.role is not Role.STEP
        rates = tuple(list_rates(residual, at, self.known)) if has_rates else ()
        is_either = self._is_either(printed, sign, sides)
        follows = self._list_named(look_up(printed, self.block.follows) or ())
        words = printed.announced
        is_case = words.is_other if sign.is_tied or sign.role is Role.SOLUTIONS else words.is_case
        is_given = is_listed(printed, block.constraints)
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
            self._may_be_other(printed, sign) and not is_claimed,
            follows=() if sign.role is Role.DEFINITION else follows,
            is_loose=residual is not None and self._is_loose(residual),
            ties_running=residual is not None and ties_running(residual, self.known.symbols.moving),
            is_case=is_case or is_given,
            is_excused=is_case
            or is_given
            or (not is_either and any(is_met_once(s, self.known) for s in list_stated(row.says))),
            said=printed.announced,
            at={letter: self.known.settle(value) for letter, value in at.items()},
            is_given=is_given,
            lacking=units.lacking,
            mixed=None if units.mixed is None else (units.mixed, self.papers[True]),
        )

    def _restate(self, row: Row, sign: Sign) -> Row:
        """State a definition if the sign introduces a letter, or else that the sides are equal."""
        says = row.says
        if isinstance(says, Definition) and sign.role not in (Role.DEFINITION, Role.SIZE):
            members = (says.symbol, says.printed) if None in sign.sides else sign.sides
            row = replace(row, says=Equality(*members, "member"))
        is_introduced = sign.role is Role.DEFINITION and sign.letter in self.known.values
        if isinstance(says, Equality | PrintedNumber | Conjunction) and is_introduced:
            pieces = (side for side in sign.sides if side not in (None, sign.letter))
            value = next(pieces, self.known.values[sign.letter])
            row = replace(row, says=Definition(sign.letter, value))
        if isinstance(says, PrintedNumber) and sign.role is Role.SIZE:
            values = [side for side in sign.sides if not side.free_symbols]
            row = replace(row, says=Definition(sign.letter, values[0]))
        if isinstance(row.says, Definition) and is_met_once(row.says.symbol, self.known):
            note = f"{row.note} No other equation uses {row.says.symbol}.".strip()
            row = replace(row, note=note)
        return row

    def _specialise(
        self, row: Row, sign: Sign, special: Mapping[sp.Basic, sp.Basic]
    ) -> tuple[Row, Sign]:
        """Put in the values that a print's condition states, and restrict it to its pieces."""
        row = specialise(row, special, self.known)
        if sign.role is Role.NUMBER and sign.number and special:
            value = put_in(sign.value, special, self.known)
            sign = replace(sign, value=value, letter=sign.letter if value.free_symbols else None)
        if sign.role in (Role.DERIVATIVE, Role.REPEATED):
            row = stay_within_pieces(row, sign, self.known)
        return row, sign

    def _may_be_other(self, printed: Printed, sign: Sign) -> bool:
        """Return whether a letter that is printed again may be meant for another case."""
        if sign.role is Role.RELATION:
            return self._is_after_words(printed, sign)
        if sign.role not in (Role.REPEATED, Role.DERIVATIVE):
            return False
        first = next((one for one in self.printed if one.name == sign.first), None)
        said = printed.announced
        if first is not None and (
            first.announced.is_apart(said) or said.is_of_other(first.announced)
        ):
            return True
        if sign.letter is None or self.known.is_derived(sign.letter):
            return said.is_special or (said.is_new and said.is_other)
        is_beside = first is not None and first.group == printed.group
        is_later = first is None or first.announced.passage != said.passage
        return is_beside or (is_later and (said.is_case or said.is_new))

    def _is_after_words(self, printed: Printed, sign: Sign) -> bool:
        """Return whether words that say something new follow a definition of a sign's letters."""
        names = {self.known.printed.get(letter) for letter in sign.printed}
        first = (one.announced.scope for one in self.printed if one.name in names)
        return any(scope != printed.announced.scope for scope in first)

    def _is_loose(self, residual: sp.Expr) -> bool:
        """Return whether some letter that no other equation has can make a residual zero."""
        letters = residual.free_symbols
        alone = (s for s in letters if is_met_once(s, self.known, with_rates=False))
        return any(is_solvable(residual, letter) for letter in alone)

    def _list_named(self, keys: Sequence[str]) -> tuple[str, ...]:
        """Return the names of equations that are given by name or label."""
        names = {label: one.name for one in self.printed for label in one.labels}
        return tuple(names.get(key, key) for key in keys)

    def _asserts(
        self, printed: Printed, says: Statement | None, sign: Sign, sides: Sequence[Any]
    ) -> bool:
        """Return whether the sides are claimed to be equal for all values of their letters.

        Sides with different letters constrain these instead.
        """
        if None not in sign.sides and not any(side.free_symbols for side in sign.sides):
            return True
        given = self.known.settle(says.value) if isinstance(says, PrintedNumber) else None
        if given is not None and sign.role is Role.CONSTRAINT and not given.free_symbols:
            return not (printed.announced.is_case or printed.announced.is_new)
        if is_listed(printed, self.block.constraints):
            return False
        if sign.role in CONSTRAINING:
            is_meant = gives_entries(sides, sign.worked_out) and have_same_letters(sides)
            return is_meant and (printed.announced.is_general or not printed.announced.is_case)
        if sign.role is Role.RELATION or len(sides) < 2:
            return sign.role is not Role.RELATION
        by_entry = sign.role is Role.DERIVATIVE and sign.letter is not None
        return not ties_letters(sides, sign.worked_out) and have_same_letters(sides, by_entry)

    def _is_either(self, printed: Printed, sign: Sign, sides: Sequence[Any]) -> bool:
        """Return whether a constraint between two compound sides may be a wrong identity."""
        is_said = is_listed(printed, self.block.constraints)
        is_compound = sign.role is Role.CONSTRAINT and sign.letter is None and len(sides) == 2
        return is_compound and not is_said and have_same_letters(sides)
