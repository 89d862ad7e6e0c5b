"""Values that hold in a worked example only, or in a case that sentences mention: for $a=b$.

So do definitions printed in the example of letters that occur elsewhere but are not yet defined.
Values of a case may prove what is printed for it, but refute nothing: the words may mean something
else.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.document.known import Known, Values
from mechproof.document.tasks import Role, Sign
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.nomenclature.inline import Inline
from mechproof.nomenclature.said_relations import read_value
from mechproof.record.unit_notation import ONE
from mechproof.sources.displays import DISPLAY, Printed
from mechproof.sources.paper_files import Source

# Words that introduce a case in the sentence before a formula, or right after a display.
_CASE = re.compile(
    r"(?<!solved )(?<!solve )\b(?:for|if|when|in the case)\b[^.;:]*\Z", re.IGNORECASE
)
_AFTER = re.compile(r"[\s.,;]*(?:if|for|when|provided(?:\s+that)?)\s+\Z")


@contextmanager
def lend_values(known: Known, name: str) -> Iterator[list[Sign]]:
    """Lend the values of the current example, and afterwards keep its new definitions with it.

    The signs of the equation called `name` are to be appended to the yielded list.
    """
    number = known.said.example.number
    own = known.examples.setdefault(number, {})
    lent = {s: v for s, v in _join(own.values()).items() if s not in known.values}
    shown = {s for s, where in known.shown_in.items() if where - {number}}
    before = {*known.values}
    known.values |= lent
    known.printed |= {s: next(n for n in reversed(own) if s in own[n]) for s in lent}
    signs: list[Sign] = []
    try:
        yield signs
    finally:
        new: Values = {}
        for sign in signs if number else ():
            if sign.role is Role.DEFINITION and sign.letter not in {*before, *lent}:
                new |= _take_out(sign.letter, known, before, shown)
            elif sign.letter in lent and _differs(sign, lent[sign.letter]):
                new |= dict.fromkeys(lent.keys() & {*known.symbols.find_rates(sign.letter)})
        for letter in (*lent, *new):
            for kept in (known.values, known.printed, known.others):
                kept.pop(letter, None)
        own[name] = new


def _take_out(
    letter: sp.Basic, known: Known, before: set[sp.Basic], shown: set[sp.Basic]
) -> Values:
    """Return the values of a letter that also occurs elsewhere, and of its derivatives."""
    _, steps = known.symbols.find_steps(letter)
    if not shown & {*steps}:
        return {}
    new = [s for s in known.symbols.find_rates(letter) if s in known.values.keys() - before]
    values = {s: known.values[s] for s in new}
    return {} if any(map(is_matrix, values.values())) else values


def _differs(sign: Sign, value: Any) -> bool:
    """Return whether a letter is printed again in an example with another value.

    A side that has only some of the value's letters may be the same value with numbers put in.
    """
    others = (side for side in sign.sides if side is not None and side != sign.letter)
    others = (side for side in others if not side.free_symbols < value.free_symbols)
    return any(sp.simplify(side - value) != 0 for side in others)


def _join(values: Iterable[Values]) -> Values:
    """Return the values that were said last, without letters that have several."""
    found = {s: value for one in values for s, value in one.items()}
    return {s: value for s, value in found.items() if value is not None}


@dataclass(frozen=True)
class SaidValue:
    """A letter's value according to a sentence of an example, and the sentence's place."""

    example: int
    offset: int
    letter: sp.Basic
    value: sp.Expr


@dataclass(frozen=True)
class ExampleValues:
    """The values that hold in worked examples, including those that sentences state."""

    known: Known
    said: Sequence[SaidValue]
    order: Sequence[str]

    def list_at(self, printed: Printed) -> Values:
        """Return the values that hold at an equation in an example.

        After an example, the values that displays of any example up to the last one gave are
        returned.
        """
        example = printed.announced.example
        numbers = [example.number] if example.number else range(1, example.last + 1)
        offset = printed.offset
        told = [x for x in self.said if x.example == example.number and x.offset < offset]
        told = [x for x in told if all(x.value == y.value for y in told if x.letter == y.letter)]
        before = self.order[: self.order.index(printed.name)]
        shown = (self.known.examples.get(n, {}) for n in numbers)
        given = (one[name] for one in shown for name in before if name in one)
        return _join([*map(self._list_rates, told), *given])

    def list_within(self, printed: Printed) -> Values:
        """Return the values that hold in the example, if an equation is certainly part of one."""
        example = printed.announced.example
        return self.list_at(printed) if example.number and example.is_sure else {}

    def _list_rates(self, said: SaidValue) -> Values:
        """Return the values of a letter and of its derivatives."""
        known = replace(self.known, values={**self.known.values}, printed={})
        known.define(said.letter, said.value, "")
        own = known.symbols.find_rates(said.letter)
        return {s: known.values[s] for s in own if s in known.values}


def collect_values(
    inline: Iterable[Inline], printed: Sequence[Printed], known: Known
) -> ExampleValues:
    """Collect the values that sentences of examples give letters: formulas and unitless numbers."""
    examples = any(one.announced.example.number for one in printed)
    found = (one for one in inline if examples and not one.is_case)
    within = ((one, find_example(one.offset, printed)) for one in found)
    said = (_read(one, number, known) for one, number in within if number)
    order = [one.name for one in printed]
    return ExampleValues(known, [one for one in said if one], order)


def find_example(offset: int, printed: Sequence[Printed]) -> int:
    """Return the number of the example that contains the text at an offset, 0 for none."""
    after = (one for one in printed if one.offset > offset)
    example = next((one.announced.example for one in after), None)
    return example.number if example and example.start <= offset else 0


def _read(one: Inline, number: int, known: Known) -> SaidValue | None:
    """Read a sentence's value of a letter that nothing else gives; None if it is unusable."""
    found = read_value(one.letter, one.value, known.symbols.reader())
    if found is None or found[0] in known.values or known.is_shown(*found):
        return None
    letter, value = found
    moving = known.symbols.moving
    is_number = not (value.free_symbols or one.unit) and value != 0
    is_number &= letter not in moving and letter not in {by for by, _ in moving.values()}
    is_number &= known.symbols.find_dimension(letter) in (None, ONE.dimension)
    is_value = bool(value.free_symbols) or is_number
    return SaidValue(number, one.offset, letter, value) if is_value else None


@dataclass(frozen=True)
class SaidCase:
    """A value said of a letter, its place in the text, and the display it follows, if any."""

    letter: sp.Basic
    value: sp.Expr
    place: int
    display: tuple[int, int] | None


class SaidCases:
    """The cases that the words of a paper mention, in their order."""

    def __init__(
        self, source: Source, inline: Iterable[Inline], printed: Sequence[Printed], known: Known
    ) -> None:
        """Take the values that sentences give letters for a case."""
        self.printed, self.known, self.places = printed, known, source.places
        self.displays = [match.span() for match in DISPLAY.finditer(source.text.string)]
        self.text = source.text.string
        self.found = [case for one in inline for case in self._read(one)]

    def _read(self, one: Inline) -> Iterator[SaidCase]:
        place = self.places[one.offset]
        span = next((x for x in reversed(self.displays) if x[1] <= place), None)
        words = self.text[span[1] if span else 0 : place]
        is_after = bool(span and _AFTER.fullmatch(words))
        is_angle = one.number is not None and one.unit in ("", "rad", "deg")
        if not (is_after or _CASE.search(words)) or not (one.number is None or is_angle):
            return
        found = read_value(one.letter, one.value, self.known.symbols.reader())
        if found and found[0] not in {*self.known.values, *found[1].free_symbols}:
            yield SaidCase(*found, place, span if is_after else None)

    def list_at(self, printed: Printed, signs: Sequence[Sign]) -> Values:
        """Return the values that words around an equation give letters, if unique for the letter.

        Zeros before it are found elsewhere. Numbers are left out for letters that the equation
        prints: it does not hold for that case only.
        """
        if printed.announced.is_general:
            return {}
        place, scope = self._find_place(printed), printed.announced.scope
        before = self.printed[: self.printed.index(printed)]
        last = next((x for x in reversed(before) if x.announced.scope != scope), None)
        first = self._find_place(last) if last else -1
        met = {letter for sign in signs for letter in sign.printed}
        said: dict[sp.Basic, set[sp.Expr]] = {}
        for one in self.found:
            is_before = one.display is None and first < one.place < place and one.value != 0
            is_after = one.display is not None and one.display[0] <= place < one.display[1]
            if is_before or is_after:
                said.setdefault(one.letter, set()).add(one.value)
        values = {s: next(iter(ones)) for s, ones in said.items() if len(ones) == 1}
        return {s: v for s, v in values.items() if v.free_symbols or s not in met}

    def _find_place(self, printed: Printed) -> int:
        return self.places.get(printed.offset, -1)
