"""Statements of numbers printed next to a formula, or for a letter that has one.

Sizes may be put into a formula: on one side, as a calculation, or to give a number at sizes. A
size that is printed again and differs may be another case, or a misprint.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.example_values import ExampleValues
from mechproof.document.known import Known
from mechproof.document.numbers.conversions import (
    DEGREES,
    NEAR,
    UNFIT,
    counts_in_degrees,
    describe_misfit,
    is_far,
)
from mechproof.document.numbers.letter_sizes import LetterSizes, PrintedSize, read_size, show
from mechproof.document.numbers.numbers_at_sizes import (
    OTHERS,
    SINGLE,
    describe_missing,
    measure_off,
    state_number,
)
from mechproof.document.numbers.numerical_values import OPEN, is_of_units
from mechproof.document.numbers.scales import RoundedSize, agrees, is_near, spread
from mechproof.document.tasks import Role, Sign
from mechproof.latex.values import settle_all
from mechproof.nomenclature.cells import Numeral
from mechproof.record import Equality, PrintedNumber, Row
from mechproof.record.parts import ANGLES
from mechproof.record.unit_notation import Unit, is_share, read_unit
from mechproof.sources.displays import Printed

_DIFFERS = "{} is printed in {}: another case, or a misprint?"
# Signs and words that may say which case a number is for.
_CASE = re.compile(r"\\(?:text|mbox|q?quad)|[(\[|]|(?<![\\{])[,;](?!\s*\Z)|\\\\")
_OTHERS = "the numbers put in give {}, the sizes {}: are other sizes meant?"
_ROUNDED = "the numbers put in give {}, the sizes {}, which rounding may explain"
_UNSHOWN = "the calculation gives {}, but was not shown to be in {}"
# Relative errors allowed for results of rounded numbers, and of whole ones of few digits.
_NEAR, _FAR = 0.01, 0.1

# The claim that a formula gives the calculated number, and a note on the sizes.
PutIn = tuple[Equality, str]


@dataclass(frozen=True)
class StatedNumbers:
    """States what numbers say, using what is known about letters and their sizes."""

    known: Known
    sizes: LetterSizes
    examples: ExampleValues

    def state(self, printed: Printed, row: Row, sign: Sign) -> tuple[Row, Sign, bool] | str:
        """State what a number says, if a sign is next to one, or return why that is left open.

        The last item returned is whether the row now states what a number says.
        """
        is_number = sign.role is Role.VALUE and bool(sign.number) and sp.Rational(sign.number) != 0
        if is_number and not sign.value.has(sp.Limit):
            sign = replace(sign, role=Role.NUMBER)
        stated: PrintedNumber | Equality | str | None = None
        if sign.role is Role.NUMBER and sign.number:
            sign = replace(sign, value=self._put_in_example(sign.value, printed))
        note = ""
        is_calculated = sign.role is Role.NUMBER and not sign.number
        if is_calculated:
            found = _state_put_in(sign, printed, self.sizes)
            stated, note = (found, "") if isinstance(found, str) else found
        elif sign.role is Role.NUMBER and sign.formula is not None:
            stated = _state_result(sign, printed, self.sizes)
        elif sign.role is Role.NUMBER or (sign.role is Role.CONSTRAINT and sign.number):
            stated = state_number(self.sizes, sign, printed)
        elif sign.role is Role.SIZE or (sign.role is Role.SOLUTIONS and sign.number):
            if misfit := describe_misfit(sign, self.known.symbols):
                return misfit
            sign, stated = self._compare_size(printed, sign)
            stated = stated or _doubt_size(sign, printed, self.sizes) or None
        claim = row.says if stated is None else stated
        if isinstance(claim, PrintedNumber) and _is_rounded(row, claim, sign):
            return NEAR
        if counts_in_degrees(sign) and not (isinstance(claim, PrintedNumber) and agrees(claim)):
            return DEGREES
        if stated is None or isinstance(stated, str):
            return stated or (row, sign, False)
        is_size = isinstance(stated, PrintedNumber)
        note = self.sizes.describe(sign, printed) if is_size else note
        role = Role.NUMBER if is_size or is_calculated else Role.CONSTRAINT
        row = replace(row, says=stated, note=f"{row.note} {note}".strip())
        return row, replace(sign, role=role), True

    def _compare_size(
        self, printed: Printed, sign: Sign
    ) -> tuple[Sign, PrintedNumber | Equality | str | None]:
        """Compare a size with a number that other prints give its letter, if they give one."""
        said = replace(sign, role=Role.NUMBER)
        formulas = (replace(said, value=one) for one in self._list_formulas(sign.letter, printed))
        judged = [(one, state_number(self.sizes, one, printed)) for one in formulas]
        told = [(one, says) for one, says in judged if isinstance(says, PrintedNumber)]
        for one in sorted(told, key=lambda one: not agrees(one[1])):
            return one
        return next((one for one in judged if str(one[1]).startswith(OTHERS)), (sign, None))

    def _put_in_example(self, value: Any, printed: Printed) -> Any:
        """Put in the values of an equation's worked example for letters without a size."""
        local, sized = self.examples.list_within(printed), self.sizes.list_all()
        return settle_all(value, {s: v for s, v in local.items() if s not in sized})

    def _list_formulas(self, letter: sp.Basic | None, printed: Printed) -> list[sp.Expr]:
        """Return the formulas that other prints give a letter whose size is printed."""
        known = self.known
        local = self.examples.list_within(printed)
        formulas = [known.values[letter]] if letter in known.values else known.arcs.get(letter, [])
        formulas = formulas or [local[letter]] if letter in local else formulas
        found = [x for x in formulas if x.free_symbols - {letter} and not known.is_shown(letter, x)]
        return found + [arc for _, arc in known.list_angles(letter, printed.announced)]


def _is_rounded(row: Row, claim: PrintedNumber, sign: Sign) -> bool:
    """Return whether rounding explains how far a number is off.

    It may be rounding of decimals in its calculation or, in an approximation, of a factor or of
    zeros at the end of the number.
    """
    if r"\approx" in row.printed_latex and not agrees(claim):
        is_factor = not sign.number and not is_far(claim.printed, claim.value)
        return is_factor or is_near(claim.value, Numeral(claim.printed, sp.S.One), {})
    return sign.formula is None and _may_be_rounded(claim, sign)


def _doubt_size(sign: Sign, printed: Printed, sizes: LetterSizes) -> str:
    """Return the reason that a letter had another size before, if no words introduce a new case."""
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
    """Return whether two prints share a display, or words between may introduce another case."""
    first, said = before.announced, printed.announced
    is_anew = first.passage != said.passage and (said.is_case or said.is_new)
    is_other = first.is_apart(said) or first.example.number != said.example.number
    return before.group == printed.group or is_anew or is_other


def _agree(one: tuple[Sign, PrintedSize], other: tuple[Sign, PrintedSize]) -> bool:
    """Return whether sizes agree to the places that both have, or need not be compared.

    Zeros are special positions, and a number without a unit is not compared with one that has a
    unit.
    """
    values, halves = zip(*map(_measure, (one, other)), strict=True)
    if not all(values) or (one[1].head.unit is None) != (other[1].head.unit is None):
        return True
    return bool(sp.Abs(values[0] - values[1]) <= max(halves))


def _measure(read: tuple[Sign, PrintedSize]) -> tuple[sp.Expr, sp.Expr]:
    """Return a size and half of its last place, in a unit common to all sizes of its letter."""
    sign, one = read
    number, value = Numeral(sign.number, sp.S.One), one.size.value * one.unit
    return value, sp.Abs(number.half_place * value / number.value) if value else sp.S.Zero


def _state_put_in(sign: Sign, printed: Printed, sizes: LetterSizes) -> PutIn | str:
    """State that a calculation is a formula with its sizes put in; otherwise leave it open."""
    calculated = [side for side in sign.sides if not side.free_symbols]
    if len(calculated) > 1 and sign.is_calculated:
        return _compare(*sign.sides, sign.span)
    if len(calculated) != 1 or any(isinstance(side, sp.MatrixBase) for side in sign.sides):
        return SINGLE
    given = calculated[0]
    formula = next(side for side in sign.sides if side is not given)
    unit = read_unit(sign.unit) if sign.unit else None
    if unit and not sizes.fits(formula, sign.own, unit):
        return UNFIT
    values = []
    for settled, at, told in _list_settled(formula, sign, printed, sizes):
        for value in (one.xreplace(at) for one in _read(settled, formula, sign.own, unit, sizes)):
            off = balls.evaluate(value - given, {})
            if off.is_finite() and off.contains(0):
                return Equality(value, given, "member"), told
            values += [value] if off.is_finite() else []
    if not values:
        known = sizes.list_at(printed)[-1]
        return describe_missing(sizes.known.settle(formula).free_symbols - known.keys())
    nearest = min(values, key=lambda value: measure_off(value, given))
    told = _ROUNDED if _is_near(nearest, given, _NEAR) else _OTHERS
    return told.format(show(given), show(nearest))


def _compare(one: sp.Expr, other: sp.Expr, span: tuple[float, float] | None) -> PutIn | str:
    """State that two calculations are equal, unless rounded numbers may explain a difference."""
    off = balls.evaluate(one - other, {})
    is_rounded = span is not None and span[0] <= 0 <= span[1]
    if not off.contains(0) and (is_rounded or _is_near(one, other, _FAR)):
        return NEAR
    ratio = sp.cancel(one / other) if other != 0 else sp.S.Zero
    if is_of_units(ratio):
        return OPEN.format(max(ratio, 1 / ratio))
    return Equality(one, other, "member"), ""


def _state_result(
    sign: Sign, printed: Printed, sizes: LetterSizes
) -> PrintedNumber | Equality | str | None:
    """State that a number is its calculation's value or, in its unit, the preceding formula's."""
    plain = state_number(sizes, sign, printed)
    if not isinstance(plain, PrintedNumber):
        return plain
    if not sign.unit:
        return NEAR if _may_be_rounded(plain, sign) else plain
    unit, is_right = read_unit(sign.unit), agrees(plain)
    own = sizes.find_own(replace(sign, value=sign.formula))
    sign = replace(sign, own=own)
    if is_share(unit):
        share = PrintedNumber(sign.number, sign.value / unit.scale)
        is_open = is_right and not agrees(share)
        return _UNSHOWN.format(show(sign.value), sign.unit) if is_open else plain
    if not sizes.fits(sign.formula, own, unit):
        return _UNSHOWN.format(show(plain.value), sign.unit) if is_right else plain
    settled = [*_list_settled(sign.formula, sign, printed, sizes)]
    values = [
        one.xreplace(at) for formula, at, _ in settled for one in sizes.read([formula], own, unit)
    ]
    if meant := [value for value in values if agrees(PrintedNumber(sign.number, value))]:
        stand = [formula.xreplace(at) for formula, at, _ in settled]
        return plain if is_right else _doubt_result(plain, sign, meant, stand)
    asked = replace(sign, number="", unit=sign.given[1], sides=(sign.formula, sign.value))
    if not isinstance(_state_put_in(asked, printed, sizes), str):
        # Its numbers are those of the sizes, unrounded.
        if not is_right:
            return plain
        number = sp.Rational(sign.number)
        nearest = min(values, key=lambda value: measure_off(value, number), default=plain.value)
        return PrintedNumber(sign.number, nearest)
    if _may_be_rounded(plain, sign):
        return NEAR
    is_own = own is not None and sizes.known.symbols.scales.get(own) == unit.scale
    is_arc = unit.dimension.is_angle and sign.value.has(*ANGLES)
    if not is_right or sign.given[1] or is_arc or (is_own and not values):
        return plain
    return _UNSHOWN.format(show(plain.value), sign.unit)


def _doubt_result(
    plain: PrintedNumber, sign: Sign, meant: list[sp.Expr], stand: list[sp.Expr]
) -> PrintedNumber | str:
    """Leave a calculation open if it may give a value `meant` at the sizes, or else state it.

    The numbers put in may be rounded, or `stand` in the units of their letters.
    """
    if any(_is_near(value, plain.value, _FAR) for value in meant):
        return NEAR
    is_turned = any(value and is_of_units(sp.cancel(plain.value / value)) for value in meant)
    is_turned |= any(_is_near(value, plain.value, _FAR) for value in stand)
    return _UNSHOWN.format(show(plain.value), sign.unit) if is_turned else plain


def _may_be_rounded(stated: PrintedNumber, sign: Sign) -> bool:
    """Return whether a number may be that of a calculation whose decimals are rounded."""
    if sign.span is None or not sign.value or agrees(stated):
        return False
    low, high = (sp.Rational(end) * stated.value / sign.value for end in sign.span)
    number = Numeral(sign.number, sp.S.One)
    printed = spread(RoundedSize(number.value, number.half_place))
    return bool(balls.to_ball(low).union(balls.to_ball(high)).overlaps(printed))


def _read(
    settled: sp.Expr, formula: sp.Expr, own: sp.Basic | None, unit: Unit | None, sizes: LetterSizes
) -> Iterator[sp.Expr]:
    """Yield possible values of a formula in a unit; without one, in its letter's or the SI unit."""
    yield from sizes.read([settled], own, unit)
    dimension = sizes.infer(formula)
    if unit is None and dimension is not None:
        yield from sizes.read([settled], own, Unit(dimension))


def _list_settled(
    formula: sp.Expr, sign: Sign, printed: Printed, sizes: LetterSizes
) -> Iterator[tuple[sp.Expr, dict[sp.Basic, sp.Expr], str]]:
    """Yield a formula in letters that have sizes, these sizes, and a note on them.

    The first uses declared or restated sizes; the second adds numbers of earlier equations.
    """
    numbered = {s: one for s, one in sizes.list_numbers(sign, printed).items() if s != sign.own}
    for numbers in ({}, numbered):
        at = sizes.list_at(printed)[-1] | {s: one.size.value for s, one in numbers.items()}
        for one in sizes.known.list_formulas(formula, at, at):
            yield one, at, sizes.describe_used(one.free_symbols, numbers, printed)


def _is_near(value: sp.Expr, given: sp.Expr, share: float) -> bool:
    return bool(measure_off(value, given) <= share * abs(sp.N(given)))
