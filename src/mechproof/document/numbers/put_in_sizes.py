"""Sizes put into formulas: in, a calculation beside a formula; out, what it is at which sizes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.numbers.conversions import NEAR, UNFIT
from mechproof.document.numbers.letter_sizes import LetterSizes, show
from mechproof.document.numbers.numbers_at_sizes import (
    SINGLE,
    measure_off,
    state_number,
    tell_missing,
)
from mechproof.document.numbers.numerical_values import OPEN, is_of_units
from mechproof.document.numbers.scales import RoundedSize, agrees, spread
from mechproof.document.tasks import Sign
from mechproof.nomenclature.cells import Numeral
from mechproof.record import Equality, PrintedNumber
from mechproof.record.parts import ANGLES
from mechproof.record.unit_notation import Unit, is_share, read_unit
from mechproof.sources.displays import Printed

_OTHERS = "the numbers that are put in give {}, the sizes {}: are others meant?"
_ROUNDED = "the numbers that are put in give {}, the sizes {}, which rounding may explain"
_UNSHOWN = "the calculation gives {}, but that this is in {} is not shown"
# By such a share what rounded numbers give may be off, or whole ones of few digits.
_NEAR, _FAR = 0.01, 0.1


@dataclass(frozen=True)
class PutIn:
    """What a formula gives is what is calculated, at sizes that are `told`."""

    says: Equality
    told: str


def state_put_in(
    sign: Sign, own: sp.Basic | None, printed: Printed, sizes: LetterSizes
) -> PutIn | str:
    """State that a calculation is a formula with its sizes put in; another accuses nobody."""
    calculated = [side for side in sign.sides if not side.free_symbols]
    if len(calculated) > 1 and sign.is_calculated:
        return _compare(*sign.sides, sign.span)
    if len(calculated) != 1 or any(isinstance(side, sp.MatrixBase) for side in sign.sides):
        return SINGLE
    given = calculated[0]
    formula = next(side for side in sign.sides if side is not given)
    unit = read_unit(sign.unit) if sign.unit else None
    if unit and not sizes.fits(formula, own, unit):
        return UNFIT
    values = []
    for settled, at, told in _list_settled(formula, sign, own, printed, sizes):
        for value in (one.xreplace(at) for one in _read(settled, formula, own, unit, sizes)):
            off = balls.evaluate(value - given, {})
            if off.is_finite() and off.contains(0):
                return PutIn(Equality(value, given, "member"), told)
            values += [value] if off.is_finite() else []
    if not values:
        known = sizes.list_at(printed)[-1]
        return tell_missing(sizes.known.settle(formula).free_symbols - known.keys())
    nearest = min(values, key=lambda value: measure_off(value, given))
    told = _ROUNDED if _is_near(nearest, given, _NEAR) else _OTHERS
    return told.format(show(given), show(nearest))


def _compare(one: sp.Expr, other: sp.Expr, span: tuple[float, float] | None) -> PutIn | str:
    """State that two calculations give the same, unless numbers of them may be rounded."""
    off = balls.evaluate(one - other, {})
    is_rounded = span is not None and span[0] <= 0 <= span[1]
    if not off.contains(0) and (is_rounded or _is_near(one, other, _FAR)):
        return NEAR
    ratio = sp.cancel(one / other) if other != 0 else sp.S.Zero
    if is_of_units(ratio):
        return OPEN.format(max(ratio, 1 / ratio))
    return PutIn(Equality(one, other, "member"), "")


def state_result(
    sign: Sign, own: sp.Basic | None, printed: Printed, sizes: LetterSizes
) -> PrintedNumber | Equality | str | None:
    """State that a number is what is calculated, and in its unit what the formula before gives."""
    plain = state_number(sizes, sign, own, printed)
    if not isinstance(plain, PrintedNumber):
        return plain
    if not sign.unit:
        return NEAR if may_be_rounded(plain, sign) else plain
    unit, is_right = read_unit(sign.unit), agrees(plain)
    own = sizes.find_own(replace(sign, value=sign.formula), own)
    if is_share(unit):
        share = PrintedNumber(sign.number, sign.value / unit.scale)
        is_open = is_right and not agrees(share)
        return _UNSHOWN.format(show(sign.value), sign.unit) if is_open else plain
    if not sizes.fits(sign.formula, own, unit):
        return _UNSHOWN.format(show(plain.value), sign.unit) if is_right else plain
    settled = [*_list_settled(sign.formula, sign, own, printed, sizes)]
    values = [
        one.xreplace(at) for formula, at, _ in settled for one in sizes.read([formula], own, unit)
    ]
    if meant := [value for value in values if agrees(PrintedNumber(sign.number, value))]:
        stand = [formula.xreplace(at) for formula, at, _ in settled]
        return plain if is_right else _doubt_result(plain, sign, meant, stand)
    asked = replace(sign, number="", unit=sign.given[1], sides=(sign.formula, sign.value))
    if isinstance(state_put_in(asked, own, printed, sizes), PutIn):
        # Its numbers are those of the sizes, unrounded.
        if not is_right:
            return plain
        number = sp.Rational(sign.number)
        nearest = min(values, key=lambda value: measure_off(value, number), default=plain.value)
        return PrintedNumber(sign.number, nearest)
    if may_be_rounded(plain, sign):
        return NEAR
    is_own = own is not None and sizes.known.symbols.scales.get(own) == unit.scale
    is_arc = unit.dimension.is_angle and sign.value.has(*ANGLES)
    if not is_right or sign.given[1] or is_arc or (is_own and not values):
        return plain
    return _UNSHOWN.format(show(plain.value), sign.unit)


def _doubt_result(
    plain: PrintedNumber, sign: Sign, meant: list[sp.Expr], stand: list[sp.Expr]
) -> PrintedNumber | str:
    """State that a calculation gives no number that is `meant` at the sizes, or how it may.

    Numbers that are put in may be rounded, or `stand` in the units of their letters.
    """
    if any(_is_near(value, plain.value, _FAR) for value in meant):
        return NEAR
    is_turned = any(value and is_of_units(sp.cancel(plain.value / value)) for value in meant)
    is_turned |= any(_is_near(value, plain.value, _FAR) for value in stand)
    return _UNSHOWN.format(show(plain.value), sign.unit) if is_turned else plain


def may_be_rounded(stated: PrintedNumber, sign: Sign) -> bool:
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
    """Yield what a formula may give, in a unit; without one in that of its letter, or of SI."""
    yield from sizes.read([settled], own, unit)
    dimension = sizes.infer(formula)
    if unit is None and dimension is not None:
        yield from sizes.read([settled], own, Unit(dimension))


def _list_settled(
    formula: sp.Expr, sign: Sign, own: sp.Basic | None, printed: Printed, sizes: LetterSizes
) -> Iterator[tuple[sp.Expr, dict[sp.Basic, sp.Expr], str]]:
    """Yield a formula of letters that have sizes, these, and what is told of them.

    First the sizes that are declared or said, then with the numbers of equations before.
    """
    numbered = {s: one for s, one in sizes.list_numbers(sign, printed).items() if s != own}
    for numbers in ({}, numbered):
        at = sizes.list_at(printed)[-1] | {s: one.size.value for s, one in numbers.items()}
        for one in sizes.known.list_formulas(formula, at, at):
            yield one, at, sizes.tell_used(one.free_symbols, numbers, printed)


def _is_near(value: sp.Expr, given: sp.Expr, share: float) -> bool:
    return bool(measure_off(value, given) <= share * abs(sp.N(given)))
