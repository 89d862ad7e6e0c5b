"""What a number says that is printed beside a formula, or of a letter that has one.

A size that is printed again and differs may be another case, or a misprint.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.document.example_values import ExampleValues
from mechproof.document.known import Known
from mechproof.document.numbers.conversions import (
    DEGREES,
    NEAR,
    counts_in_degrees,
    is_far,
    tell_misfit,
)
from mechproof.document.numbers.letter_sizes import LetterSizes, PrintedSize, read_size
from mechproof.document.numbers.numbers_at_sizes import OTHERS, state_number
from mechproof.document.numbers.put_in_sizes import may_be_rounded, state_put_in, state_result
from mechproof.document.numbers.scales import agrees, is_near
from mechproof.document.tasks import Role, Sign
from mechproof.latex.values import settle_all
from mechproof.nomenclature.cells import Numeral
from mechproof.record import Equality, PrintedNumber, Row
from mechproof.sources.displays import Printed

_DIFFERS = "{} is printed in {}: another case, or a misprint?"
# What may say for which case a number is.
_CASE = re.compile(r"\\(?:text|mbox|q?quad)|[(\[|]|(?<![\\{])[,;](?!\s*\Z)|\\\\")


@dataclass(frozen=True)
class Stated:
    """A row with its sign, and whether it states what a number says."""

    row: Row
    sign: Sign
    is_stated: bool


@dataclass(frozen=True)
class StatedNumbers:
    """States what numbers say, by what is known of letters and their sizes."""

    known: Known
    sizes: LetterSizes
    examples: ExampleValues

    def state(self, printed: Printed, row: Row, sign: Sign, own: sp.Basic | None) -> Stated | str:
        """State what a number says, if a sign is beside one, or say why that is left open."""
        is_number = sign.role is Role.VALUE and bool(sign.number) and sp.Rational(sign.number) != 0
        if is_number and not sign.value.has(sp.Limit):
            sign = replace(sign, role=Role.NUMBER)
        stated: PrintedNumber | Equality | str | None = None
        if sign.role is Role.NUMBER and sign.number:
            sign = replace(sign, value=self._put_in_example(sign.value, printed))
        note = ""
        is_calculated = sign.role is Role.NUMBER and not sign.number
        if is_calculated:
            found = state_put_in(sign, own, printed, self.sizes)
            stated, note = (found, "") if isinstance(found, str) else (found.says, found.told)
        elif sign.role is Role.NUMBER and sign.formula is not None:
            stated = state_result(sign, own, printed, self.sizes)
        elif sign.role is Role.NUMBER or (sign.role is Role.CONSTRAINT and sign.number):
            stated = state_number(self.sizes, sign, own, printed)
        elif sign.role is Role.SIZE or (sign.role is Role.SOLUTIONS and sign.number):
            if misfit := tell_misfit(sign, self.known.symbols):
                return misfit
            sign, stated = self._compare_size(printed, sign, own)
            stated = stated or _doubt_size(sign, printed, self.sizes) or None
        claim = row.says if stated is None else stated
        if isinstance(claim, PrintedNumber) and _is_rounded(row, claim, sign):
            return NEAR
        if counts_in_degrees(sign) and not (isinstance(claim, PrintedNumber) and agrees(claim)):
            return DEGREES
        if stated is None or isinstance(stated, str):
            return stated or Stated(row, sign, is_stated=False)
        is_size = isinstance(stated, PrintedNumber)
        note = self.sizes.tell(sign, printed) if is_size else note
        role = Role.NUMBER if is_size or is_calculated else Role.CONSTRAINT
        row = replace(row, says=stated, note=f"{row.note} {note}".strip())
        return Stated(row, replace(sign, role=role), is_stated=True)

    def _compare_size(
        self, printed: Printed, sign: Sign, own: sp.Basic | None
    ) -> tuple[Sign, PrintedNumber | Equality | str | None]:
        """Compare a size with what other prints say of its letter, if they say a number."""
        said = replace(sign, role=Role.NUMBER)
        formulas = (replace(said, value=one) for one in self._list_formulas(sign.letter, printed))
        judged = [(one, state_number(self.sizes, one, own, printed)) for one in formulas]
        told = [(one, says) for one, says in judged if isinstance(says, PrintedNumber)]
        for one in sorted(told, key=lambda one: not agrees(one[1])):
            return one
        return next((one for one in judged if str(one[1]).startswith(OTHERS)), (sign, None))

    def _put_in_example(self, value: Any, printed: Printed) -> Any:
        """Put in what letters without a size are in the example that an equation stands in."""
        local, sized = self.examples.list_within(printed), self.sizes.list_all()
        return settle_all(value, {s: v for s, v in local.items() if s not in sized})

    def _list_formulas(self, letter: sp.Basic | None, printed: Printed) -> list[sp.Expr]:
        """Return what other prints say of a letter whose size is printed."""
        known = self.known
        local = self.examples.list_within(printed)
        formulas = [known.values[letter]] if letter in known.values else known.arcs.get(letter, [])
        formulas = formulas or [local[letter]] if letter in local else formulas
        found = [x for x in formulas if x.free_symbols - {letter} and not known.is_shown(letter, x)]
        return found + [arc for _, arc in known.list_angles(letter, printed.announced)]


def _is_rounded(row: Row, claim: PrintedNumber, sign: Sign) -> bool:
    """Return whether rounding explains how far a number is off.

    That of decimals in its calculation, or of an approximation: of a factor, of zeros at its end.
    """
    if r"\approx" in row.printed_latex and not agrees(claim):
        is_factor = not sign.number and not is_far(claim.printed, claim.value)
        return is_factor or is_near(claim.value, Numeral(claim.printed, sp.S.One), {})
    return sign.formula is None and may_be_rounded(claim, sign)


def _doubt_size(sign: Sign, printed: Printed, sizes: LetterSizes) -> str:
    """Say that a letter has another size before, if nothing tells that it may go on to others."""
    letter, moving = sign.letter, sizes.known.symbols.moving
    if letter is None or not sign.number:
        return ""
    if letter in moving or letter in {by for by, _ in moving.values()}:
        return ""
    if _is_case(printed) or letter in sizes.restated.list_before(printed):
        return ""
    own = read_size(sign, printed, sizes.known)
    for before, other, one in sizes.every.get(letter, ()):
        if before.name == printed.name:
            return ""
        is_apart = _is_case(before) or _may_be_other(before, printed)
        if not (is_apart or _agree((other, one), (sign, own))):
            return _DIFFERS.format(before.latex.string.strip(" .,;\n"), before.name)
    return ""


def _is_case(printed: Printed) -> bool:
    return bool(_CASE.search(printed.latex.string))


def _may_be_other(before: Printed, printed: Printed) -> bool:
    """Return whether two prints are of one display, or words between may go on to another case."""
    first, said = before.announced, printed.announced
    is_anew = first.passage != said.passage and (said.is_case or said.is_new)
    is_other = first.is_apart(said) or first.example.number != said.example.number
    return before.group == printed.group or is_anew or is_other


def _agree(one: tuple[Sign, PrintedSize], other: tuple[Sign, PrintedSize]) -> bool:
    """Return whether sizes agree to the places that both have, or nothing tells that they do not.

    Zeros are special positions, and a number with a unit may be one without.
    """
    values, halves = zip(*map(_measure, (one, other)), strict=True)
    if not all(values) or (one[1].head.unit is None) != (other[1].head.unit is None):
        return True
    return bool(sp.Abs(values[0] - values[1]) <= max(halves))


def _measure(read: tuple[Sign, PrintedSize]) -> tuple[sp.Expr, sp.Expr]:
    """Return a size, and half of its last place, in units that all sizes of a letter have."""
    sign, one = read
    number, value = Numeral(sign.number, sp.S.One), one.size.value * one.unit
    return value, sp.Abs(number.half_place * value / number.value) if value else sp.S.Zero
