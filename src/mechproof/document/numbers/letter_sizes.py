"""The sizes of letters at which formulas are compared with numbers.

They are the sizes that the block declares, or else those that the paper prints, if it prints no
others for the letter. A number that an equation prints for a letter is a size, or a result that may
have been rounded. Sentences may restate sizes, "with d=20 mm we have instead" after sizes d=16 mm,
or choose one for a letter that a formula gives: "we choose M16 with A=157 mm²".
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.numbers.conversions import may_count
from mechproof.document.numbers.scales import RoundedSize, Scales, may_turn_units
from mechproof.document.tasks import Role, Sign
from mechproof.nomenclature.cells import Head, Numeral, find_unit
from mechproof.nomenclature.inline import Inline, SaidQuantity, find_quantities
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.verdict import Left
from mechproof.record import Dimension, find_last_place
from mechproof.record.unit_notation import Unit, read_unit
from mechproof.sources.displays import Printed
from mechproof.sources.paper_files import Source
from mechproof.statement_domains.dimension_inference import DimensionError, infer

# The word after a formula, which may be its unit.
_NEXT = re.compile(r"(?:\s|~|\\[,; ])*([^\s,;.]+)")
# A second value after a formula: "at $\varphi=0$ and $\pi$".
_SECOND = re.compile(
    r",?\s*(?:and|or)\s+\$(?P<value>(?:[-+\d\s.,/{}^]|\\(?:pi|circ|ang|[dt]?frac)(?![a-z]))+)\$"
)


@dataclass(frozen=True)
class PrintedSize:
    """A size that an equation prints, in the unit of its letter or else in its own unit."""

    size: RoundedSize
    head: Head
    unit: sp.Expr
    name: str
    group: int

    def is_zero(self, group: int) -> bool:
        """Return whether the size is zero and is printed in the display `group`."""
        return self.group == group and self.size.value == 0


def read_size(sign: Sign, printed: Printed, known: Known) -> PrintedSize:
    """Return the size that a sign gives its letter."""
    unit = read_unit(sign.unit) if sign.unit else None
    head = Head(sign.letter, str(sign.letter), unit)
    scales = Scales(known.symbols, [head])
    size = scales.size(head, Numeral(sign.number, sp.S.One))
    scale = scales.known.get(sign.letter, sp.S.One)
    return PrintedSize(size, head, scale, printed.name, printed.group)


def list_numbers(
    printed: Printed, signs: Sequence[Sign], known: Known
) -> Iterator[tuple[sp.Basic, PrintedSize]]:
    """Yield the letters for which an equation prints a number as a result, in printed order.

    The size covers all values that round to the number.
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
    """The sizes of letters; `numeric` holds the displays that print nothing but numbers.

    `numbers` has the printed results of letters that have a formula, `order` the names of the
    equations, `restated` the sizes that sentences give, and `every` all printed sizes of each
    letter.
    """

    known: Known
    printed: Mapping[sp.Basic, PrintedSize]
    numeric: frozenset[int]
    numbers: Mapping[sp.Basic, Sequence[PrintedSize]]
    order: Sequence[str]
    restated: RestatedSizes
    every: Mapping[sp.Basic, Sequence[tuple[Printed, Sign, PrintedSize]]]

    def describe(self, sign: Sign, printed: Printed) -> str:
        """Return a note on the printed and restated sizes at which a number is compared."""
        return self.describe_used(self.known.settle(sign.value).free_symbols, {}, printed)

    def describe_used(
        self, letters: Iterable[sp.Basic], numbers: Mapping[sp.Basic, PrintedSize], printed: Printed
    ) -> str:
        """Return a note on the printed sizes of letters, some of them the results `numbers`."""
        used = {**self.list_used(letters), **{s: numbers[s] for s in letters if s in numbers}}
        sizes = (f"{s} = {_show_exactly(one.size.value)} of {one.name}" for s, one in used.items())
        restated = self.name_restated({*letters} - numbers.keys(), printed)
        anew = f"The text says {restated}." if restated else ""
        return f"At {', '.join(sizes)}. {anew}".strip() if used else anew

    def name_restated(self, letters: Iterable[sp.Basic], printed: Printed) -> str:
        """Name those sizes of letters that a sentence before an equation restates."""
        found = self.restated.list_before(printed)
        return ", ".join(
            f"{s} = {_show_exactly(found[s].value)} in line {found[s].line}"
            for s in sorted(found.keys() & {*letters}, key=str)
        )

    def list_all(self) -> dict[sp.Basic, RoundedSize]:
        """Return the sizes of letters; a declared size takes precedence over a printed one."""
        usual = {s: RoundedSize(value) for s, value in self.known.symbols.usual.items()}
        return {s: one.size for s, one in self.printed.items()} | usual

    def list_at(self, printed: Printed) -> tuple[dict[sp.Basic, sp.Expr], ...]:
        """Return the sizes of letters, and the same with the restatements before an equation."""
        sizes = {s: size.value for s, size in self.list_all().items()}
        return sizes, sizes | {s: x.value for s, x in self.restated.list_before(printed).items()}

    def list_used(self, letters: Iterable[sp.Basic]) -> dict[sp.Basic, PrintedSize]:
        """Return the printed sizes that a formula of these letters is compared at."""
        declared = self.known.symbols.usual
        used = {s: self.printed[s] for s in letters if s in self.printed and s not in declared}
        return dict(sorted(used.items(), key=lambda one: str(one[0])))

    def find_own(self, sign: Sign) -> sp.Basic | None:
        """Return a letter whose unit a number has: its own, or for a sum one of the sum's letters.

        None if the number has a unit and its formula's dimension is known but its letter has no
        unit.
        """
        symbols, dimension, own = self.known.symbols, self.infer(sign.value), sign.own
        if own is not None:
            return None if sign.unit and dimension and own not in symbols.scales else own
        own = None if sign.unit else symbols.find_alike(sign.value.free_symbols)
        return own if dimension == symbols.find_dimension(own) else None

    def infer(self, value: Any) -> Dimension | None:
        """Return the dimension of a value, or None if it mixes some or a letter has none."""
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
        """Return whether a formula may be a number in a unit, as far as dimensions are known."""
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
        """Yield the values that formulas may have as numbers in the printed unit."""
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
        """Return the last results printed before an equation for letters that have a formula."""
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
    """Collect the printed sizes; a letter that is printed with two different sizes has none."""
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
    """Return zeros for letters without a formula that are said to be zero near a print.

    An equation that prints such a letter, or a derivative of it, holds for other values, too.
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
    """Return a number as a decimal if that is exact."""
    return short if sp.Rational(short := show(value)) == value else str(value)


@dataclass(frozen=True)
class Restated:
    """A size that a sentence gives a letter, in the letter's unit, with its place and line."""

    letter: sp.Basic
    value: sp.Expr
    place: int
    line: int


class RestatedSizes:
    """The sizes that sentences give letters, in the order of the text."""

    def __init__(self, source: Source, inline: Sequence[Inline], symbols: Symbols) -> None:
        """Take the sentences that give sizes; sums and formulas are skipped."""
        self.usual, self.places = symbols.usual, source.places
        letters = symbols.prints
        self.found = [*_find(inline, source, letters, symbols)]
        second = ((one, _SECOND.match(source.text.string, one.end)) for one in inline)
        self.said = [
            (letters.get(one.letter), value, one.end)
            for one, other in second
            for value in (one.value, *((other["value"],) if other else ()))
        ]
        self.quantities = [*find_quantities(source)]

    def list_before(self, printed: Printed) -> dict[sp.Basic, Restated]:
        """Return the sizes in force at an equation that differ from the block's."""
        place = self._find_place(printed)
        last = {one.letter: one for one in self.found if one.place < place}
        return {
            s: one
            for s, one in last.items()
            if s not in self.usual or not _is_same(one.value, self.usual[s])
        }

    def list_quantities(self, printed: Printed) -> list[SaidQuantity]:
        """Return quantities without a letter from sentences before an equation, the last first."""
        place = self._find_place(printed)
        return [one for one in reversed(self.quantities) if one.place < place]

    def list_zeros(self, before: Printed | None, printed: Printed) -> set[sp.Basic]:
        r"""Return the letters that are said to be zero, and nothing else, between two equations.

        "At $\varphi=0$ and $\varphi=\pi$" names two values.
        """
        first, last = self._find_place(before) if before else -1, self._find_place(printed)
        said = {(letter, value) for letter, value, place in self.said if first < place < last}
        times = Counter(letter for letter, _ in said)
        zeros = (one for one in self.found if first < one.place < last and one.value == 0)
        return {one.letter for one in zeros if times[one.letter] == 1}

    def _find_place(self, printed: Printed) -> int:
        return self.places.get(printed.offset, -1)


def _find(
    inline: Iterable[Inline], source: Source, letters: Mapping[str, sp.Basic], symbols: Symbols
) -> Iterator[Restated]:
    for one in inline:
        letter = letters.get(one.letter)
        if letter is None or one.number is None:
            continue
        unit = one.number.unit or _find_unit_after(one, source, letter, symbols)
        number = Numeral(one.number.digits, one.number.factor, unit)
        size = Scales(symbols).size(Head(letter, one.letter, None), number)
        # Degrees of temperature have no scale.
        if size.value.is_finite:
            yield Restated(letter, size.value, one.end, one.line)


def _find_unit_after(
    one: Inline, source: Source, letter: sp.Basic, symbols: Symbols
) -> Unit | None:
    """Return the unit that follows a formula, if it has the letter's dimension."""
    word = _NEXT.match(source.text.string, one.end)
    unit = find_unit(word[1]) if word and word[1] != "in" else None
    return unit if unit and unit.dimension == symbols.find_dimension(letter) else None


def _is_same(one: sp.Expr, other: sp.Expr) -> bool:
    """Return whether sizes are the same, or one is the other rounded, as radians are."""
    return bool(sp.Abs(one - other) <= sp.Abs(other) / 1000)
