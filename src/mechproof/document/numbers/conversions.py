"""Numbers equated with numbers: conversions of units, and roundings of irrational numbers.

In an equation with a decimal as a factor, c = 1.41 a, the rest is moved to the other side, which
is then the number that was rounded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.numbers.scales import RoundedSize, agrees, is_near
from mechproof.document.tasks import Sign, Task
from mechproof.nomenclature.cells import Numeral
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import FREQUENCY, NUMBER, Equality, PrintedNumber
from mechproof.record.parts import ANGLES, TURNING
from mechproof.record.unit_notation import ONE, REVOLUTIONS, Unit, is_share, read_unit

UNFIT = "the unit after the number is not that of its letters, or their units are not declared"
_TURNED = "turns, or radians? no letter says which of them the calculation uses"
DEGREES = "it holds only in degrees, which the text does not say: print ^\\circ after the angles"
NEAR = "it differs from the recomputed number, but rounding may explain the difference"
_DECIMAL = re.compile(r"\d\s*(?:\.|\{,\})\s*\d")
_OPEN = "the two sides differ, but a decimal may have been rounded"


def convert(sign: Sign, symbols: Symbols) -> PrintedNumber | str:
    """State that a number with a unit is the same in another unit, or in that of a letter.

    Either of the two may be rounded. Returns a reason instead if the units do not fit, or if
    rounding explains a difference.
    """
    own, digits, unit = sign.own, sign.given[0], read_unit(sign.given[1])
    meant = [read_unit(sign.unit)] if sign.unit else [*_list_units(own, unit, symbols)]
    ratios = [unit.scale / one.scale for one in meant if one.dimension == unit.dimension]
    turned = [ratio * turn for ratio in ratios for turn in _list_turns(unit, meant, own, symbols)]
    if turned and own is None and sign.is_calculated:
        return _TURNED
    ratios += turned
    if not ratios or sp.nan in ratios:
        return UNFIT
    value, number = sp.Rational(digits), sp.Rational(sign.number)
    stated = [PrintedNumber(sign.number, value * ratio) for ratio in ratios]
    stated += [PrintedNumber(digits, number / ratio) for ratio in ratios]
    if found := next(filter(agrees, stated), None):
        return found
    x, printed = sp.Dummy(), Numeral(sign.number, sp.S.One)
    size = {x: RoundedSize(value, Numeral(digits, sp.S.One).half_place)}
    return NEAR if any(is_near(x * r, printed, size) for r in ratios) else stated[0]


def _list_units(own: sp.Basic | None, unit: Unit, symbols: Symbols) -> Iterator[Unit]:
    """Yield the units that a number without a unit may have, equated with one in `unit`."""
    dimension = symbols.find_dimension(own) if own is not None else None
    if dimension is not None:
        yield Unit(dimension, symbols.scales[own])
    if unit.dimension == NUMBER:
        yield ONE


def _list_turns(
    unit: Unit, others: Sequence[Unit], own: sp.Basic | None, symbols: Symbols
) -> list[sp.Expr]:
    """Return the extra factors between units if turns are counted: 1/s may be 2 pi rad/s.

    There is none for an angular velocity declared in rad/s, as 1/s then means the same.
    """
    counted = [one.scale == REVOLUTIONS for one in (unit, *others)]
    dimension = symbols.find_dimension(own) if own is not None else None
    is_angular = bool(dimension and dimension.angle) and symbols.scales[own] != REVOLUTIONS
    if not is_angular:
        angles = (bool(one.dimension.angle) for one in (unit, *others))
        counted = [one or angle for one, angle in zip(counted, angles, strict=True)]
    if unit.dimension != FREQUENCY or all(counted) or not any(counted):
        return []
    return [1 / (2 * sp.pi) if counted[0] else 2 * sp.pi]


def describe_misfit(sign: Sign, symbols: Symbols) -> str:
    """Return why the unit printed for a letter does not fit its dimension, or "" if it does."""
    own = symbols.find_dimension(sign.letter) if sign.letter is not None else None
    if not sign.unit or own is None or read_unit(sign.unit).dimension == own:
        return ""
    other = read_unit(sign.unit).dimension
    return f"{sign.letter} has dimension {own} but the unit {sign.unit} has {other}"


def counts_in_degrees(sign: Sign) -> bool:
    """Return whether a number is that of a calculation whose angles are in unmarked degrees."""
    if not sign.number or not isinstance(sign.value, sp.Expr) or sign.value.free_symbols:
        return False
    turned = sign.value.replace(
        lambda part: isinstance(part, TURNING) and part.args[0].is_rational,
        lambda part: part.func(part.args[0] * sp.pi / 180),
    ).replace(lambda part: isinstance(part, ANGLES), lambda part: part * 180 / sp.pi)
    return turned != sign.value and agrees(PrintedNumber(sign.number, turned))


def may_count(number: sp.Expr, unit: Unit) -> bool:
    """Return whether a formula of numbers may count in a unit; degrees count as radians there."""
    is_turned = unit.dimension.is_angle and unit.scale != 1 and not number.is_rational
    return not (is_share(unit) or is_turned)


def differs_by_unit(value: sp.Expr, number: Numeral) -> bool:
    """Return whether a number is a value in a unit 10^3 or 10^6 times as large or small."""
    factors = (sp.Integer(10) ** power for power in (-6, -3, 3, 6))
    return any(is_near(value * factor, number, {}) for factor in factors)


def round_irrational(sign: Sign) -> PrintedNumber | str | None:
    """State that a whole number is a rounded irrational one; None if it is not shown to be.

    Zeros at its end may not be significant. Returns the reason if only they explain the difference.
    """
    number = Numeral(sign.number, sp.S.One)
    if sign.value.is_rational is not False or number.is_decimal or abs(number.value) < 10:
        return None
    stated = PrintedNumber(sign.number, sign.value)
    if stated.half_place == number.half_place and agrees(stated):
        return stated
    return NEAR if is_near(sign.value, number, {}) else None


def judge_factor(task: Task) -> Judgement | str:
    """Judge the only decimal of an equation, a factor, if the sides agree up to a number.

    A wrong rounding is not refuted if other numbers may have been rounded, too: another decimal, or
    one in the definition of a letter.
    """
    number, sides = task.sign.factor, task.sign.sides
    if not (number and isinstance(task.row.says, Equality)):
        return _OPEN
    for one, other in (sides, sides[::-1]):
        factor, rest = one.as_coeff_Mul() if isinstance(one, sp.Expr) else (sp.S.Zero, one)
        if abs(factor) != sp.Rational(number) or not isinstance(other, sp.Expr):
            continue
        value = sp.cancel(task.domain.resolve(other) / task.domain.resolve(rest)) * sp.sign(factor)
        if value.free_symbols or not value.is_finite:
            continue
        found = judge(replace(task.row, says=PrintedNumber(number, value)), task.paper)
        is_alone = len(_DECIMAL.findall(task.row.printed_latex)) == 1
        is_exact = is_alone and not sp.cancel(other / rest).free_symbols
        is_told = found.verdict is Verdict.PROVED or (is_exact and is_far(number, value))
        return found if is_told else f"{_OPEN}: {found.reason}"
    return _OPEN


def is_far(number: str, value: sp.Expr) -> bool:
    """Return whether a number is off by more than its last digit, which may be rounded up."""
    last = 2 * Numeral(number, sp.S.One).half_place
    return bool(abs(abs(value) - abs(sp.Rational(number))) > last)
