"""Numbers of formulas at the sizes of letters: what each states, or why it is not judged.

A number that differs from the value at the sizes may have been rounded, or be meant at others.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.document.numbers.conversions import (
    NEAR,
    UNFIT,
    convert,
    differs_by_unit,
    round_irrational,
)
from mechproof.document.numbers.letter_sizes import LetterSizes, PrintedSize, show
from mechproof.document.numbers.scales import RoundedSize, Scales, agrees, is_near
from mechproof.document.tasks import Role, Sign
from mechproof.nomenclature.cells import Head, Numeral
from mechproof.record import NUMBER, Equality, PrintedNumber
from mechproof.record.unit_notation import Unit, read_unit
from mechproof.sources.displays import Printed

# A number of one digit, or with zeros at its end that may not be significant.
_FEW_DIGITS = re.compile(r"-?(?:\d(?:e-?\d+)?|[1-9]\d*0)\Z")
_FEW = "the value at the sizes is {}; a number of so few digits may be rounded, or for other sizes"
SINGLE = "a single value: the text does not say for which sizes, or to how many digits"
OTHERS = "it is not the value at the sizes of"
_ROUNDED = "it agrees with the printed rounded numbers, {}; unrounded ones give {}"
_BARE_NUMBERS = "the numbers have no unit: which units are meant?"
_SAID = "it agrees with {}, but not with its formula, which gives {}"
_RESTATED = "it is not the value at the declared sizes, and the text gives other ones: {}"
_BARE = "it holds for the bare numbers, but not in the units of their letters"


def state_number(
    at: LetterSizes, sign: Sign, printed: Printed
) -> PrintedNumber | Equality | str | None:
    """State a number as a value at sizes or as an equation of letters, or say why not.

    None means that it constrains its letters like any other equation.
    """
    if not sign.number:
        return SINGLE
    if sign.given[1]:
        return convert(sign, at.known.symbols)
    is_constraint = sign.role is Role.CONSTRAINT
    letters = at.known.settle(sign.value).free_symbols
    if is_constraint and not (sign.unit or letters):
        return round_irrational(sign)
    is_sum = _is_sum(sign.value)
    sign = replace(sign, own=at.find_own(sign))
    if (is_constraint or is_sum) and letters - at.list_all().keys():
        stated = _constrain(at, sign)
        if stated or is_constraint:
            return stated
    if is_constraint and not (sign.unit or is_sum) and _FEW_DIGITS.match(sign.number):
        return None
    return _round(at, sign, printed)


def _constrain(at: LetterSizes, sign: Sign) -> Equality | str | None:
    """State a number as an equation of letters whose sizes are not all known."""
    value, number = sign.value, sp.Rational(sign.number)
    scales, dimension = Scales(at.known.symbols), at.infer(sign.value)
    if not sign.unit:
        is_fit = number != 0 and sign.own is not None and _is_sum(value)
        is_fit &= dimension == at.known.symbols.find_dimension(sign.own)
        return Equality(value, number, "member") if is_fit else None
    unit = read_unit(sign.unit)
    if dimension != unit.dimension or not value.free_symbols <= scales.known.keys():
        return UNFIT if sign.role is Role.CONSTRAINT else None
    return Equality(scales.to_si(value) / unit.scale, number, "member")


def _round(at: LetterSizes, sign: Sign, printed: Printed) -> PrintedNumber | Equality | str:
    """State a number as a formula's value at the sizes, or return why it is not judged."""
    formulas = _find_formulas(at, sign)
    if isinstance(formulas, str):
        return _state_rounded(at, sign, printed) or formulas
    if not isinstance(formulas, list):
        return formulas
    value, own, unit = formulas[0], sign.own, read_unit(sign.unit) if sign.unit else None
    if unit and value.free_symbols and not at.fits(value, own, unit):
        return UNFIT
    read = [*at.read(formulas, own, unit)]
    exact, anew = at.list_at(printed)
    stated = [PrintedNumber(sign.number, one.xreplace(exact)) for one in read]
    renewed = [PrintedNumber(sign.number, one.xreplace(anew)) for one in read]
    number = sp.Rational(sign.number)
    nearest = min(stated, key=lambda one: measure_off(one.value, number))
    is_few = bool(_FEW_DIGITS.match(sign.number)) and bool(own or not unit)
    values = [one.value for one in (*stated, *renewed)]
    if value.free_symbols and is_few and number not in values:
        return _FEW.format(show(nearest.value))
    if found := next(filter(agrees, (*stated, *renewed)), None):
        return found
    if value.free_symbols and agrees(PrintedNumber(sign.number, value.xreplace(exact))):
        return _BARE
    has_letters = bool(value.free_symbols | sign.value.free_symbols)
    may_excuse = has_letters or (own and unit)
    excuse = _excuse(at, sign, printed, read, nearest) if may_excuse else ""
    return excuse or _doubt(at, value, unit, printed) or nearest


def _state_rounded(at: LetterSizes, sign: Sign, printed: Printed) -> PrintedNumber | str:
    """State a number as a formula's value at sizes that sentences give; "" if it is not."""
    sizes, unit = at.list_at(printed)[-1], read_unit(sign.unit) if sign.unit else None
    settled = (at.known.settle(sign.value), at.known.settle(sign.value, stop=sizes))
    formulas = [x for x in settled if x != sign.letter and x.free_symbols <= sizes.keys()]
    if not formulas or (unit and not at.fits(formulas[0], sign.own, unit)):
        return ""
    values = [one.xreplace(sizes) for one in at.read(formulas, sign.own, unit)]
    stated = [PrintedNumber(sign.number, value) for value in values]
    if _FEW_DIGITS.match(sign.number):
        stated = [one for one in stated if one.value == sp.Rational(sign.number)]
    return next(filter(agrees, stated), "")


def _find_formulas(at: LetterSizes, sign: Sign) -> list[sp.Expr] | Equality | str:
    """Return the formulas of a number at the sizes, or why there are none.

    A formula equal to zero constrains letters whose sizes are not known.
    """
    declared, sizes = at.known.symbols.usual, at.list_all()
    value = at.known.settle(sign.value)
    missing = value.free_symbols - sizes.keys()
    if not missing:
        # A letter with a formula and a size may be meant by either.
        return [*dict.fromkeys((value, at.known.settle(sign.value, stop=declared)))]
    formulas = at.known.list_formulas(sign.value, sizes, declared.keys() - {sign.letter})
    if not formulas and sign.letter is None and sp.Rational(sign.number) == 0:
        return Equality(value, sp.S.Zero, "member")
    return formulas or describe_missing(missing)


def _excuse(
    at: LetterSizes, sign: Sign, printed: Printed, read: Sequence[sp.Expr], nearest: PrintedNumber
) -> str:
    """Return what else may have been meant by a number that differs from the value at the sizes."""
    if names := at.name_restated(at.known.list_used(sign.value), printed):
        return _RESTATED.format(names)
    number, sizes = Numeral(sign.number, sp.S.One), at.list_all()
    if any(is_near(one, number, sizes) for one in read):
        return NEAR
    if not sign.value.free_symbols and any(differs_by_unit(one, number) for one in read):
        return _BARE_NUMBERS
    if names := _name_rounded(at, sign, printed):
        return _ROUNDED.format(names, show(nearest.value))
    names = _name_stated(at, sign, printed)
    return _SAID.format(names, show(nearest.value)) if names else ""


def _doubt(at: LetterSizes, value: sp.Expr, unit: Unit | None, printed: Printed) -> str:
    """Return a reason to doubt that a number is meant at the printed sizes, or ""."""
    used = at.list_used(value.free_symbols)
    units = {one.head.unit for one in used.values()}
    if unit is None and len(units) > 1 and at.infer(value) != NUMBER:
        return "it has no unit, and the sizes have several"
    if used and not _are_together(at, used.values(), printed.group):
        names = ", ".join(dict.fromkeys(one.name for one in used.values()))
        return f"{OTHERS} {names}: are these meant, or others?"
    return ""


def _name_rounded(at: LetterSizes, sign: Sign, printed: Printed) -> str:
    """Return the earlier rounded numbers with which a number agrees, if they may be rounded."""
    last = at.list_numbers(sign, printed)
    rounded = {s: one for s, one in last.items() if not _is_exact(at, one)}
    letters = at.known.settle(sign.value, stop=rounded).free_symbols
    used = {s: rounded[s] for s in sorted(letters & rounded.keys(), key=str)}
    given = {s: one.size for s, one in used.items()}
    if not _is_near_at(at, sign, given, used.values()):
        return ""
    return ", ".join(f"{s} of {one.name}" for s, one in used.items())


def _name_stated(at: LetterSizes, sign: Sign, printed: Printed) -> str:
    """Return the letter and the stated quantity with which a number agrees, or ""."""
    known, scales = at.known, Scales(at.known.symbols)
    letters = known.list_used(sign.value) & known.values.keys() & scales.known.keys()
    for letter in sorted(letters - known.symbols.usual.keys(), key=str):
        for one in at.restated.list_quantities(printed):
            number = Numeral(one.digits, sp.S.One, one.unit)
            size = scales.size(Head(letter, str(letter), None), number)
            is_alike = one.unit.dimension == known.symbols.find_dimension(letter)
            if is_alike and _is_near_at(at, sign, {letter: size}):
                return f"{letter} = {one.text} in line {one.line}"
    return ""


def _is_near_at(
    at: LetterSizes,
    sign: Sign,
    given: Mapping[sp.Basic, RoundedSize],
    numbers: Iterable[PrintedSize] = (),
) -> bool:
    """Return whether a number may be its formula's value with these sizes of derived letters."""
    formula = at.known.settle(sign.value, stop=given)
    letters, sizes = formula.free_symbols, at.list_all() | {**given}
    if not (letters & given.keys() and letters <= sizes.keys()):
        return False
    unit, number = read_unit(sign.unit) if sign.unit else None, Numeral(sign.number, sp.S.One)
    read = at.read([formula], sign.own, unit, numbers)
    return any(is_near(one, number, sizes) for one in read)


def _is_exact(at: LetterSizes, one: PrintedSize) -> bool:
    """Return whether the printed number of a letter is its formula's exact value."""
    letter, sizes = one.head.symbol, at.list_all()
    formula = at.known.settle(letter)
    exact = {s: size.value for s, size in sizes.items()}
    return formula.free_symbols <= sizes.keys() and one.size.value in [
        value.xreplace(exact) for value in at.read([formula], letter, None)
    ]


def _are_together(at: LetterSizes, used: Iterable[PrintedSize], group: int) -> bool:
    """Return whether only displays of numbers lie between sizes and the display of a number."""
    groups = {group, *(one.group for one in used)}
    return {*range(min(groups) + 1, max(groups))} <= at.numeric


def describe_missing(letters: Iterable[sp.Basic]) -> str:
    """Return the reason that a formula needs undeclared sizes."""
    return f"it depends on sizes that are not declared: {', '.join(sorted(map(str, letters)))}"


def measure_off(value: sp.Expr, number: sp.Expr) -> float:
    """Return how far a number is from the value stated for it, infinity if that is no number."""
    off = sp.Abs(value - number).evalf()
    return float(off) if off.is_Float else math.inf


def _is_sum(value: Any) -> bool:
    """Return whether a value is a sum of letters, each possibly with a coefficient."""
    terms = sp.Add.make_args(value) if isinstance(value, sp.Add) else ()
    return bool(terms) and all(term.as_coeff_Mul()[1] in value.free_symbols for term in terms)
