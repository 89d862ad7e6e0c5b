"""Numbers beside letters: what a formula gives at sizes, or what is said of letters without any.

Sizes are those that the block declares, else those that the paper prints, if it prints no others.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from mechproof.document.conversions import (
    NEAR,
    UNFIT,
    convert,
    differs_by_unit,
    may_count,
    round_irrational,
)
from mechproof.document.known import Known
from mechproof.document.printed_sizes import PrintedSize
from mechproof.document.restated_sizes import RestatedSizes
from mechproof.document.roles import Role, Sign
from mechproof.document.scales import RoundedSize, Scales, agrees, is_near, may_turn_units
from mechproof.domains.dimensions import DimensionError, infer
from mechproof.nomenclature.cells import Head, Numeral
from mechproof.nomenclature.units import Unit, read_unit
from mechproof.record import NUMBER, Dimension, Equality, PrintedNumber
from mechproof.sources.displays import Printed

# One digit, or zeros of which nobody knows whether they are digits.
_FEW_DIGITS = re.compile(r"-?(?:\d(?:e-?\d+)?|[1-9]\d*0)\Z")
_FEW = "the value at the sizes is {}; a number of so few digits may be rounded, or meant for others"
SINGLE = "a single value: nothing says for which sizes, or to how many digits"
OTHERS = "it is not the number at the sizes of"
_ROUNDED = "it agrees with the rounded numbers that are printed, {}; unrounded ones give {}"
_BARE_NUMBERS = "the numbers have no unit: in which are they meant?"
_SAID = "it agrees with {}, but not with its formula, which gives {}"
_RESTATED = "it is not the number at the declared sizes, and the text says other ones: {}"
_BARE = "it holds for the numbers as they stand, but not in the units of their letters"


@dataclass(frozen=True)
class Sizes:
    """The sizes of letters; `numeric` are the displays that print nothing but numbers.

    `numbers` are printed of letters that have a formula, in the `order` of the equations;
    `restated` are sizes that sentences say.
    """

    known: Known
    printed: Mapping[sp.Basic, PrintedSize]
    numeric: frozenset[int]
    numbers: Mapping[sp.Basic, Sequence[PrintedSize]]
    order: Sequence[str]
    restated: RestatedSizes

    def state(
        self, sign: Sign, own: sp.Basic | None, printed: Printed
    ) -> PrintedNumber | Equality | str | None:
        """State what a number says: at sizes, or of letters without; or say why nothing is.

        It counts in the unit of the letter `own`, else in that behind it. None is what says of its
        letters what any equation does.
        """
        if not sign.number:
            return SINGLE
        if sign.given[1]:
            return convert(sign, own, self.known.symbols)
        is_constraint = sign.role is Role.CONSTRAINT
        letters = self.known.settle(sign.value).free_symbols
        if is_constraint and not (sign.unit or letters):
            return round_irrational(sign)
        is_sum = _is_sum(sign.value)
        own = self.find_own(sign, own)
        if (is_constraint or is_sum) and letters - self._list_sizes().keys():
            stated = self._constrain(sign, own)
            if stated or is_constraint:
                return stated
        if is_constraint and not (sign.unit or is_sum) and _FEW_DIGITS.match(sign.number):
            return None
        return self._round(sign, own, printed)

    def tell(self, sign: Sign, printed: Printed) -> str:
        """Say which printed sizes a number is compared at, and which sentences state anew."""
        return self.tell_used(self.known.settle(sign.value).free_symbols, {}, printed)

    def tell_used(
        self,
        letters: Iterable[sp.Basic],
        numbers: Mapping[sp.Basic, PrintedSize],
        printed: Printed,
    ) -> str:
        """Say at which printed sizes letters are taken, of some the `numbers` of equations."""
        used = {**self._list_used(letters), **{s: numbers[s] for s in letters if s in numbers}}
        sizes = (f"{s} = {_show_exactly(one.size.value)} of {one.name}" for s, one in used.items())
        restated = self._name_restated({*letters} - numbers.keys(), printed)
        anew = f"The text says {restated}." if restated else ""
        return f"At {', '.join(sizes)}. {anew}".strip() if used else anew

    def _name_restated(self, letters: Iterable[sp.Basic], printed: Printed) -> str:
        """Name the sizes among those of letters that a sentence before an equation states anew."""
        found = self.restated.list_before(printed)
        return ", ".join(
            f"{s} = {_show_exactly(found[s].value)} in line {found[s].line}"
            for s in sorted(found.keys() & {*letters}, key=str)
        )

    def _list_sizes(self) -> dict[sp.Basic, RoundedSize]:
        usual = {s: RoundedSize(value) for s, value in self.known.symbols.usual.items()}
        return {s: one.size for s, one in self.printed.items()} | usual

    def list_at(self, printed: Printed) -> tuple[dict[sp.Basic, sp.Expr], ...]:
        """Return the sizes of letters, and those with which the text has stated some anew."""
        sizes = {s: size.value for s, size in self._list_sizes().items()}
        return sizes, sizes | {s: x.value for s, x in self.restated.list_before(printed).items()}

    def _list_used(self, letters: Iterable[sp.Basic]) -> dict[sp.Basic, PrintedSize]:
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

    def _constrain(self, sign: Sign, own: sp.Basic | None) -> Equality | str | None:
        """State what a number says of letters whose sizes are not all known."""
        value, number = sign.value, sp.Rational(sign.number)
        scales, dimension = Scales(self.known.symbols), self.infer(sign.value)
        if not sign.unit:
            is_fit = number != 0 and own is not None and _is_sum(value)
            is_fit &= dimension == self.known.symbols.find_dimension(own)
            return Equality(value, number, "member") if is_fit else None
        unit = read_unit(sign.unit)
        if dimension != unit.dimension or not value.free_symbols <= scales.known.keys():
            return UNFIT if sign.role is Role.CONSTRAINT else None
        return Equality(scales.to_si(value) / unit.scale, number, "member")

    def _round(
        self, sign: Sign, own: sp.Basic | None, printed: Printed
    ) -> PrintedNumber | Equality | str:
        """Return what a number says of a formula at the sizes, or why that is not judged."""
        formulas = self._find_formulas(sign)
        if isinstance(formulas, str):
            return self._round_as_said(sign, own, printed) or formulas
        if not isinstance(formulas, list):
            return formulas
        value, unit = formulas[0], read_unit(sign.unit) if sign.unit else None
        if unit and value.free_symbols and not self.fits(value, own, unit):
            return UNFIT
        read = [*self.read(formulas, own, unit)]
        exact, anew = self.list_at(printed)
        stated = [PrintedNumber(sign.number, one.xreplace(exact)) for one in read]
        renewed = [PrintedNumber(sign.number, one.xreplace(anew)) for one in read]
        nearest = min(stated, key=_find_distance)
        is_few = bool(_FEW_DIGITS.match(sign.number)) and bool(own or not unit)
        values = [one.value for one in (*stated, *renewed)]
        if value.free_symbols and is_few and sp.Rational(sign.number) not in values:
            return _FEW.format(show(nearest.value))
        if found := next(filter(agrees, (*stated, *renewed)), None):
            return found
        if value.free_symbols and agrees(PrintedNumber(sign.number, value.xreplace(exact))):
            return _BARE
        has_letters = bool(value.free_symbols | sign.value.free_symbols)
        may_excuse = has_letters or (own and unit)
        excuse = self._excuse(sign, own, printed, read, nearest) if may_excuse else ""
        return excuse or self._doubt(value, unit, printed) or nearest

    def _round_as_said(
        self, sign: Sign, own: sp.Basic | None, printed: Printed
    ) -> PrintedNumber | str:
        """State that a number is that of a formula at sizes that sentences say, if it is."""
        sizes, unit = self.list_at(printed)[-1], read_unit(sign.unit) if sign.unit else None
        settled = (self.known.settle(sign.value), self.known.settle(sign.value, stop=sizes))
        formulas = [x for x in settled if x != sign.letter and x.free_symbols <= sizes.keys()]
        if not formulas or (unit and not self.fits(formulas[0], own, unit)):
            return ""
        values = [one.xreplace(sizes) for one in self.read(formulas, own, unit)]
        stated = [PrintedNumber(sign.number, value) for value in values]
        if _FEW_DIGITS.match(sign.number):
            stated = [one for one in stated if one.value == sp.Rational(sign.number)]
        return next(filter(agrees, stated), "")

    def fits(self, value: sp.Expr, own: sp.Basic | None, unit: Unit) -> bool:
        """Return whether a formula may be counted in a unit; with a letter as far as is known."""
        found = self.infer(value)
        return found == unit.dimension or (
            own is not None and (found is None or may_turn_units(value))
        )

    def _find_formulas(self, sign: Sign) -> list[sp.Expr] | Equality | str:
        """Return the formulas of a number at the sizes, or why there are none.

        That a formula is zero says something of letters whose sizes are not known.
        """
        declared, sizes = self.known.symbols.usual, self._list_sizes()
        value = self.known.settle(sign.value)
        # A letter that has a size, too, may be meant by either.
        formulas = [*dict.fromkeys((value, self.known.settle(sign.value, stop=declared)))]
        missing = value.free_symbols - sizes.keys()
        if not missing:
            return formulas
        formulas = [x for x in formulas if x != sign.letter and x.free_symbols <= sizes.keys()]
        # A further member of its chain may have no other letters.
        others = (self.known.settle(x) for _, x in self.known.others.get(sign.value, ()))
        formulas = formulas or [x for x in others if x.free_symbols <= sizes.keys()]
        if not formulas and sign.letter is None and sp.Rational(sign.number) == 0:
            return Equality(value, sp.S.Zero, "member")
        return formulas or tell_missing(missing)

    def _excuse(
        self,
        sign: Sign,
        own: sp.Basic | None,
        printed: Printed,
        read: Iterable[sp.Expr],
        nearest: PrintedNumber,
    ) -> str:
        """Say what may have been meant by a number that is not the one at the sizes."""
        if names := self._name_restated(self.known.list_used(sign.value), printed):
            return _RESTATED.format(names)
        number, sizes = Numeral(sign.number, sp.S.One), self._list_sizes()
        if any(is_near(one, number, sizes) for one in read):
            return NEAR
        if not sign.value.free_symbols and any(differs_by_unit(one, number) for one in read):
            return _BARE_NUMBERS
        if names := self._name_rounded(sign, own, printed):
            return _ROUNDED.format(names, show(nearest.value))
        names = self._name_said(sign, own, printed)
        return _SAID.format(names, show(nearest.value)) if names else ""

    def _doubt(self, value: sp.Expr, unit: Unit | None, printed: Printed) -> str:
        """Say why a number may not be meant at the sizes that are printed."""
        used = self._list_used(value.free_symbols)
        units = {one.head.unit for one in used.values()}
        if unit is None and len(units) > 1 and self.infer(value) != NUMBER:
            return "it has no unit, and the sizes have several"
        if used and not self._are_beside(used.values(), printed.group):
            names = ", ".join(dict.fromkeys(one.name for one in used.values()))
            return f"{OTHERS} {names}: are these meant, or others?"
        return ""

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

    def _name_rounded(self, sign: Sign, own: sp.Basic | None, printed: Printed) -> str:
        """Return with which numbers before it one agrees, as far as these may have been rounded."""
        last = self.list_numbers(sign, printed)
        rounded = {s: one for s, one in last.items() if not self._is_exact(one)}
        letters = self.known.settle(sign.value, stop=rounded).free_symbols
        used = {s: rounded[s] for s in sorted(letters & rounded.keys(), key=str)}
        given = {s: one.size for s, one in used.items()}
        if not self._is_near_at(sign, own, given, used.values()):
            return ""
        return ", ".join(f"{s} of {one.name}" for s, one in used.items())

    def list_numbers(self, sign: Sign, printed: Printed) -> dict[sp.Basic, PrintedSize]:
        """Return the last numbers of letters that have a formula, before an equation."""
        before = self.order[: self.order.index(printed.name)]
        return {
            s: one
            for s, ones in self.numbers.items()
            for one in ones
            if one.name in before and s not in (sign.letter, *self.known.symbols.usual)
        }

    def _name_said(self, sign: Sign, own: sp.Basic | None, printed: Printed) -> str:
        """Return which letter has a quantity that a sentence says if a number agrees with it."""
        known, scales = self.known, Scales(self.known.symbols)
        letters = known.list_used(sign.value) & known.values.keys() & scales.known.keys()
        for letter in sorted(letters - known.symbols.usual.keys(), key=str):
            for one in self.restated.list_quantities(printed):
                number = Numeral(one.digits, sp.S.One, one.unit)
                size = scales.size(Head(letter, str(letter), None), number)
                is_alike = one.unit.dimension == known.symbols.find_dimension(letter)
                if is_alike and self._is_near_at(sign, own, {letter: size}):
                    return f"{letter} = {one.text} in line {one.line}"
        return ""

    def _is_near_at(
        self,
        sign: Sign,
        own: sp.Basic | None,
        given: Mapping[sp.Basic, RoundedSize],
        numbers: Iterable[PrintedSize] = (),
    ) -> bool:
        """Return whether a number may be that of its formula at sizes of letters with a formula."""
        formula = self.known.settle(sign.value, stop=given)
        letters, sizes = formula.free_symbols, self._list_sizes() | {**given}
        if not (letters & given.keys() and letters <= sizes.keys()):
            return False
        unit, number = read_unit(sign.unit) if sign.unit else None, Numeral(sign.number, sp.S.One)
        read = self.read([formula], own, unit, numbers)
        return any(is_near(one, number, sizes) for one in read)

    def _is_exact(self, one: PrintedSize) -> bool:
        """Return whether the number of a letter is that of its formula, without any rounding."""
        letter, sizes = one.head.symbol, self._list_sizes()
        formula = self.known.settle(letter)
        exact = {s: size.value for s, size in sizes.items()}
        return formula.free_symbols <= sizes.keys() and one.size.value in [
            value.xreplace(exact) for value in self.read([formula], letter, None)
        ]

    def _are_beside(self, used: Iterable[PrintedSize], group: int) -> bool:
        """Return whether nothing but numbers stands between sizes and the display of a number."""
        groups = {group, *(one.group for one in used)}
        return {*range(min(groups) + 1, max(groups))} <= self.numeric


def tell_missing(letters: Iterable[sp.Basic]) -> str:
    """Say which sizes a formula needs that nothing says."""
    return f"it depends on sizes that are not declared: {', '.join(sorted(map(str, letters)))}"


def _find_distance(stated: PrintedNumber) -> float:
    """Return how far a number is from the value that is stated of it."""
    distance = sp.Abs(stated.value - sp.Rational(stated.printed)).evalf()
    return float(distance) if distance.is_Float else math.inf


def show(value: sp.Expr) -> str:
    """Return a number to six digits."""
    number = sp.N(value, 6)
    return f"{float(number):g}" if number.is_real else str(number)


def _show_exactly(value: sp.Expr) -> str:
    """Return a number as a decimal if that is all of it."""
    return short if sp.Rational(short := show(value)) == value else str(value)


def _is_sum(value: Any) -> bool:
    """Return whether a value is a sum of letters, of which each may have a number before it."""
    terms = sp.Add.make_args(value) if isinstance(value, sp.Add) else ()
    return bool(terms) and all(term.as_coeff_Mul()[1] in value.free_symbols for term in terms)
