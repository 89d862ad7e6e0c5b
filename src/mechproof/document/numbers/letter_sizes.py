"""The sizes of letters at which formulas are compared with numbers.

They are those that the block declares, else those that the paper prints, if it prints no others.
Numbers that equations print of letters are sizes, or results that may have been rounded.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.numbers.conversions import may_count
from mechproof.document.numbers.restated_sizes import RestatedSizes
from mechproof.document.numbers.scales import RoundedSize, Scales, may_turn_units
from mechproof.document.tasks import Role, Sign
from mechproof.nomenclature.cells import Head, Numeral
from mechproof.proof.verdict import Left
from mechproof.record import Dimension, find_last_place
from mechproof.record.unit_notation import Unit, read_unit
from mechproof.sources.displays import Printed
from mechproof.statement_domains.dimension_inference import DimensionError, infer


@dataclass(frozen=True)
class PrintedSize:
    """A size that an equation prints, in units of its letter; of one without any, in its own."""

    size: RoundedSize
    head: Head
    unit: sp.Expr
    name: str
    group: int

    def is_zero(self, group: int) -> bool:
        """Return whether a display says that the letter is zero."""
        return self.group == group and self.size.value == 0


def read_size(sign: Sign, printed: Printed, known: Known) -> PrintedSize:
    """Return the size that a sign says of its letter."""
    unit = read_unit(sign.unit) if sign.unit else None
    head = Head(sign.letter, str(sign.letter), unit)
    scales = Scales(known.symbols, [head])
    size = scales.size(head, Numeral(sign.number, sp.S.One))
    scale = scales.known.get(sign.letter, sp.S.One)
    return PrintedSize(size, head, scale, printed.name, printed.group)


def list_numbers(
    printed: Printed, signs: Sequence[Sign], known: Known
) -> Iterator[tuple[sp.Basic, PrintedSize]]:
    """Yield the letters that an equation prints a number of, as a result, in the order of print.

    Whatever rounds to the number may be meant.
    """
    letter = None
    for sign in signs:
        letter = sign.letter or letter
        if sign.role is not Role.NUMBER or not sign.number or letter not in known.values:
            continue
        one = read_size(replace(sign, letter=letter), printed, known)
        unit = Scales(known.symbols, [one.head]).convert(letter, one.head.unit)
        size = RoundedSize(one.size.value, unit * find_last_place(sign.number) / 2)
        yield letter, replace(one, size=size)


@dataclass(frozen=True)
class LetterSizes:
    """The sizes of letters; `numeric` are the displays that print nothing but numbers.

    `numbers` are printed of letters that have a formula, in the `order` of the equations;
    `restated` are sizes that sentences say, `every` are all prints of the size of a letter.
    """

    known: Known
    printed: Mapping[sp.Basic, PrintedSize]
    numeric: frozenset[int]
    numbers: Mapping[sp.Basic, Sequence[PrintedSize]]
    order: Sequence[str]
    restated: RestatedSizes
    every: Mapping[sp.Basic, Sequence[tuple[Printed, Sign, PrintedSize]]]

    def tell(self, sign: Sign, printed: Printed) -> str:
        """Say which printed sizes a number is compared at, and which sentences state anew."""
        return self.tell_used(self.known.settle(sign.value).free_symbols, {}, printed)

    def tell_used(
        self, letters: Iterable[sp.Basic], numbers: Mapping[sp.Basic, PrintedSize], printed: Printed
    ) -> str:
        """Say at which printed sizes letters are taken, of some the `numbers` of equations."""
        used = {**self.list_used(letters), **{s: numbers[s] for s in letters if s in numbers}}
        sizes = (f"{s} = {_show_exactly(one.size.value)} of {one.name}" for s, one in used.items())
        restated = self.name_restated({*letters} - numbers.keys(), printed)
        anew = f"The text says {restated}." if restated else ""
        return f"At {', '.join(sizes)}. {anew}".strip() if used else anew

    def name_restated(self, letters: Iterable[sp.Basic], printed: Printed) -> str:
        """Name the sizes among those of letters that a sentence before an equation states anew."""
        found = self.restated.list_before(printed)
        return ", ".join(
            f"{s} = {_show_exactly(found[s].value)} in line {found[s].line}"
            for s in sorted(found.keys() & {*letters}, key=str)
        )

    def list_all(self) -> dict[sp.Basic, RoundedSize]:
        """Return the sizes of letters, those that the block declares before printed ones."""
        usual = {s: RoundedSize(value) for s, value in self.known.symbols.usual.items()}
        return {s: one.size for s, one in self.printed.items()} | usual

    def list_at(self, printed: Printed) -> tuple[dict[sp.Basic, sp.Expr], ...]:
        """Return the sizes of letters, and those with which the text has stated some anew."""
        sizes = {s: size.value for s, size in self.list_all().items()}
        return sizes, sizes | {s: x.value for s, x in self.restated.list_before(printed).items()}

    def list_used(self, letters: Iterable[sp.Basic]) -> dict[sp.Basic, PrintedSize]:
        """Return the printed sizes among those at which a formula of letters is compared."""
        declared = self.known.symbols.usual
        used = {s: self.printed[s] for s in letters if s in self.printed and s not in declared}
        return dict(sorted(used.items(), key=lambda one: str(one[0])))

    def find_own(self, sign: Sign, own: sp.Basic | None) -> sp.Basic | None:
        """Return a letter in whose unit a number counts: its own, or of a sum one of its letters.

        A unit behind the number is enough where the letters have units.
        """
        symbols, dimension = self.known.symbols, self.infer(sign.value)
        if own is not None:
            return None if sign.unit and dimension and own not in symbols.scales else own
        own = None if sign.unit else symbols.find_alike(sign.value.free_symbols)
        return own if dimension == symbols.find_dimension(own) else None

    def infer(self, value: Any) -> Dimension | None:
        """Return the dimension of a value, None where its letters have none or it mixes some."""
        known = {s: self.known.symbols.find_dimension(s) for s in value.free_symbols}
        known |= {
            s: one.head.unit.dimension
            for s, one in self.printed.items()
            if known.get(s) is None and one.head.unit
        }
        told = {s: dimension for s, dimension in known.items() if dimension is not None}
        try:
            return infer(value, told) if value.free_symbols <= told.keys() else None
        except DimensionError:
            return None

    def fits(self, value: sp.Expr, own: sp.Basic | None, unit: Unit) -> bool:
        """Return whether a formula may be counted in a unit; with a letter as far as is known."""
        found = self.infer(value)
        return found == unit.dimension or (
            own is not None and (found is None or may_turn_units(value))
        )

    def read(
        self,
        formulas: Sequence[sp.Expr],
        own: sp.Basic | None,
        unit: Unit | None,
        numbers: Iterable[PrintedSize] = (),
    ) -> Iterator[sp.Expr]:
        """Yield what formulas may give, in the unit behind the number."""
        heads = (one.head for one in (*self.printed.values(), *numbers))
        scales = Scales(self.known.symbols, heads, [own] if unit and own else [])
        if own or unit is None:
            for formula in formulas:
                for reading in scales.list_readings(formula, own, unit):
                    yield from reading
            return
        for formula in formulas:
            is_bare = may_turn_units(formula) if formula.free_symbols else may_count(formula, unit)
            yield from scales.list_values(formula, None, unit)
            if is_bare:
                yield formula

    def list_numbers(self, sign: Sign, printed: Printed) -> dict[sp.Basic, PrintedSize]:
        """Return the last numbers of letters that have a formula, before an equation."""
        before = self.order[: self.order.index(printed.name)]
        return {
            s: one
            for s, ones in self.numbers.items()
            for one in ones
            if one.name in before and s not in (sign.letter, *self.known.symbols.usual)
        }


def collect_sizes(
    equations: Iterable[tuple[Printed, Sequence[Sign] | Left]],
    known: Known,
    restated: RestatedSizes,
) -> LetterSizes:
    """Collect the sizes that are printed; a letter that is printed with two of them has none."""
    read = [(one, [] if isinstance(signs, Left) else signs) for one, signs in equations]
    every: dict[sp.Basic, list[tuple[Printed, Sign, PrintedSize]]] = {}
    numbers: dict[sp.Basic, list[PrintedSize]] = {}
    groups: dict[int, bool] = {}
    for printed, signs in read:
        is_numeric = bool(signs) and bool(signs[-1].number)
        groups[printed.group] = groups.get(printed.group, True) and is_numeric
        for sign in signs:
            if sign.role is Role.SIZE and sign.letter is not None and sign.number:
                size = read_size(sign, printed, known)
                every.setdefault(sign.letter, []).append((printed, sign, size))
        for letter, one in list_numbers(printed, signs, known):
            numbers.setdefault(letter, []).append(one)
    found = {s: [size for *_, size in ones] for s, ones in every.items()}
    sizes = {s: {one.size.value * one.unit for one in ones} for s, ones in found.items()}
    kept = {s: ones[0] for s, ones in found.items() if len(sizes[s]) == 1}
    numeric = frozenset(group for group, is_all in groups.items() if is_all)
    return LetterSizes(
        known, kept, numeric, numbers, [one.name for one, _ in read], restated, every
    )


def list_zeros(
    printed: Printed, signs: Sequence[Sign], equations: Sequence[Printed], sizes: LetterSizes
) -> dict[sp.Basic, sp.Expr]:
    """Return the zeros that letters without a formula are said to be beside a print or before it.

    What prints such a letter, or a derivative of it, is meant for other values, too.
    """
    known = sizes.known
    steps = ((s, known.symbols.find_steps(s)[1]) for one in signs for s in one.printed)
    met = {x for s, own in steps for x in own[: own.index(s) + 1]}
    scope = printed.announced.scope
    others = equations[: equations.index(printed)]
    before = next((x for x in reversed(others) if x.announced.scope != scope), None)
    beside = {s for s, one in sizes.printed.items() if one.is_zero(printed.group)}
    zeros = sizes.restated.list_zeros(before, printed) | beside
    return dict.fromkeys(sorted(zeros - known.values.keys() - met, key=str), sp.S.Zero)


def show(value: sp.Expr) -> str:
    """Return a number to six digits."""
    number = sp.N(value, 6)
    return f"{float(number):g}" if number.is_real else str(number)


def _show_exactly(value: sp.Expr) -> str:
    """Return a number as a decimal if that is all of it."""
    return short if sp.Rational(short := show(value)) == value else str(value)
