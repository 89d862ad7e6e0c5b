"""Numbers at sizes: the values of formulas at printed sizes of their letters, in their units."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.nomenclature.cells import Head, Numeral
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.exact_values import decide_number
from mechproof.proof.verdict import Verdict
from mechproof.record import FREQUENCY, NUMBER, PrintedNumber
from mechproof.record.parts import ANGLES, CIRCULAR
from mechproof.record.unit_notation import REVOLUTIONS, Unit
from mechproof.statement_domains.dimension_inference import DimensionError, infer

_DEGREE = sp.pi / 180
_TURN = 2 * sp.pi
# Revolutions named n are counted; under any other name they are angular velocities.
_COUNTED = re.compile(r"[nN](?![A-Za-z])")
# Numbers from here up convert units, as 60 s or 1000 mm do; smaller ones count parts or halves.
_FACTOR = 10


@dataclass(frozen=True)
class RoundedSize:
    """A size in the unit of its letter, and half of its last place if it is rounded."""

    value: sp.Expr
    half: sp.Expr = sp.S.Zero


@dataclass(frozen=True)
class Result:
    """A number that a formula gives: its name, place, head and unit, and its line's sizes."""

    name: str
    offset: int
    head: Head
    number: Numeral
    factor: sp.Expr
    sizes: Mapping[sp.Basic, RoundedSize]

    @property
    def text(self) -> str:
        """Return the print of the result as an equation."""
        return f"{self.head.printed}={self.number.digits}"

    def describe(self) -> str:
        """Return a description of the number and the sizes at which it is meant."""
        sizes = ", ".join(f"{symbol} = {size.value}" for symbol, size in self.sizes.items())
        return f"{self.head.symbol} = {self.number.digits} at {sizes or 'the declared sizes'}"

    def state(self, formula: sp.Expr) -> PrintedNumber:
        """State that a formula has the printed number as its value."""
        values = {symbol: size.value for symbol, size in self.sizes.items()}
        return PrintedNumber(self.number.digits, formula.xreplace(values) / self.factor)

    def choose(self, reading: Sequence[sp.Expr]) -> sp.Expr | None:
        """Return the branch of a reading that is shown to give the number, or None."""
        return next((f for f in reading if agrees(self.state(f))), None)

    def is_near(self, formula: sp.Expr) -> bool:
        """Return whether the number may be the value at sizes that round to those of the line."""
        return is_near(formula / self.factor, self.number, self.sizes)


def is_near(formula: sp.Expr, number: Numeral, sizes: Mapping[sp.Basic, RoundedSize]) -> bool:
    """Return whether a number may be a formula's value at sizes that round to those given."""
    values = {symbol: spread(size) for symbol, size in sizes.items()}
    found = balls.evaluate(formula, values)
    printed = spread(RoundedSize(sp.Rational(number.digits), number.half_place))
    return not found.is_finite() or bool(found.overlaps(printed))


def agrees(says: PrintedNumber) -> bool:
    """Return whether a number is proved to be the rounded value."""
    return decide_number(says, says.value).verdict is Verdict.PROVED


def has_sixty(formula: sp.Expr) -> bool:
    """Return whether a number of a formula has the factor 15, as 30, 60 and 1/60 have."""
    return any(not (one.p % 15 and one.q % 15) for one in formula.atoms(sp.Rational))


def may_turn_units(formula: sp.Expr) -> bool:
    """Return whether a formula may itself convert units, by a number too large to count parts."""
    numbers = formula.atoms(sp.Number)
    return any(one.is_Float or max(abs(one.p), one.q) >= _FACTOR for one in numbers)


def spread(size: RoundedSize) -> balls.Ball:
    """Return the ball of all values that round to a size."""
    return balls.to_ball(size.value - size.half).union(balls.to_ball(size.value + size.half))


class Scales:
    """The units of letters, as the block declares them or else as the heads of a table show them.

    A letter without a unit is a plain number.
    """

    def __init__(
        self, symbols: Symbols, heads: Iterable[Head] = (), shown: Iterable[sp.Basic] = ()
    ) -> None:
        """Take the heads of a table, and letters whose numbers are printed with a unit."""
        self.symbols = symbols
        heads = [h for h in heads if h.is_letter]
        units = {h.symbol: h.unit for h in heads if h.unit and h.unit.dimension != NUMBER}
        self.known = {s: unit.scale for s, unit in units.items()} | {**symbols.scales}
        self.shown = {*shown, *(h.symbol for h in heads if h.unit)}
        self.revolving = {s for s, scale in self.known.items() if scale == REVOLUTIONS}
        self.revolving |= {s for s, unit in units.items() if unit.scale == REVOLUTIONS}

    def convert(self, symbol: sp.Basic | None, unit: Unit | None) -> sp.Expr:
        """Return a unit in terms of a letter's unit, or 1 if the letter has none."""
        if unit is None or (symbol not in self.known and unit.dimension != NUMBER):
            return sp.S.One
        return unit.scale / self.known.get(symbol, sp.S.One)

    def size(self, head: Head, number: Numeral) -> RoundedSize:
        """Return the size in a cell."""
        factor = self.convert(head.symbol, number.unit or head.unit)
        half = number.half_place * number.factor * factor if number.is_decimal else sp.S.Zero
        return RoundedSize(number.value * factor, half)

    def are_known(self, letters: Iterable[sp.Basic]) -> bool:
        """Return whether the block or the heads give the units of all letters."""
        return {*letters} <= {*self.known, *self.shown, *self.symbols.branches}

    def to_si(self, formula: sp.Expr, angle: sp.Expr = sp.S.One) -> sp.Expr:
        """Return a formula of numbers in the units of their letters as one in SI units.

        Revolutions count as radians, or as multiples of another `angle`.
        """
        return formula.xreplace({s: s * self._scale(s, angle) for s in self.known})

    def _scale(self, symbol: sp.Basic | None, angle: sp.Expr) -> sp.Expr:
        return self.known.get(symbol, sp.S.One) / (angle if symbol in self.revolving else 1)

    def turn(self, formula: sp.Expr, own: sp.Basic) -> sp.Expr | None:
        """Return a formula of quantities as a number in the unit of a letter.

        Going by their names, all revolutions must be counted, or all be angular velocities;
        otherwise, or if a unit is not known, None is returned.
        """
        letters = {*formula.free_symbols, own}
        revolving = self.revolving & letters
        counted = {bool(_COUNTED.match(str(s))) for s in revolving}
        if not letters <= self.known.keys() or len(counted) > 1:
            return None
        angle = _TURN if counted == {True} else sp.S.One
        value = self.to_si(formula, angle) / self._scale(own, sp.S.One)
        return value * angle if own in revolving else value

    def list_values(
        self, formula: sp.Expr, own: sp.Basic | None, unit: Unit | None
    ) -> list[sp.Expr]:
        """Return the possible values of a formula in a unit, or else in its letter's unit.

        A formula with pi may convert revolutions to radians itself; next to another frequency
        revolutions are not radians either. With sixty as a factor, they may count per minute as
        they stand.
        """
        turns = unit.scale == REVOLUTIONS if unit else own in self.revolving
        has_pi = formula.has(sp.pi)
        letters = {*formula.free_symbols, own}
        counts = self._has_frequency(letters, unit) or self._are_counted(letters)
        angles = [sp.S.One] if has_pi or not counts else []
        if has_pi or counts:
            angles.append(_TURN)
        if (has_pi or counts) and has_sixty(formula):
            angles.append(REVOLUTIONS)
        scale = unit.scale if unit else self._scale(own, sp.S.One)
        values = (self.to_si(formula, a) / scale * (a if turns else 1) for a in angles)
        return list(dict.fromkeys(values))

    def _are_counted(self, letters: Iterable[sp.Basic | None]) -> bool:
        """Return whether there are revolving letters and all count revolutions by their names."""
        revolving = self.revolving.intersection(letters)
        return bool(revolving) and all(_COUNTED.match(str(s)) for s in revolving)

    def _has_frequency(self, letters: Iterable[sp.Basic | None], unit: Unit | None) -> bool:
        """Return whether a letter, or the number's unit, is a frequency without an angle."""
        found = [self.symbols.find_dimension(s) for s in letters if s and s not in self.revolving]
        found += [unit.dimension] if unit and unit.scale != REVOLUTIONS else []
        return any(one == FREQUENCY and not one.angle for one in found if one is not None)

    def list_readings(
        self, formula: sp.Expr, own: sp.Basic | None, unit: Unit | None = None
    ) -> list[tuple[sp.Expr, ...]]:
        """Return the readings of a letter's formula with numbers in the units of their letters.

        Its values are in the unit after its number, or else in the letter's unit; without either,
        they are numbers or in SI units. Each reading has one expression for every choice of the
        branches.
        """
        readings = []
        printed = self.convert(own, unit)
        is_bare = may_turn_units(formula) or not self._fits(formula, own, unit)
        # A letter may count turns per minute, and its number turns per second.
        by_second = unit is not None and unit == Unit(FREQUENCY) and not unit.dimension.angle
        for turned, angle in self._read_degrees(formula, own):
            if is_bare:
                readings.append((turned / angle / printed, angle * printed))
            if is_bare and by_second and own in self.revolving:
                readings.append((turned * REVOLUTIONS / _TURN, angle))
            if self._has_units(turned, own):
                scale = angle * (unit.scale if unit else self._scale(own, sp.S.One))
                values = self.list_values(turned, own, unit)
                readings += ((value / angle, scale) for value in values)
        choices = self.symbols.list_branches(formula.free_symbols)
        turns = self._list_turns(formula, own)
        return [
            tuple(reading.xreplace(c) + turn / scale for c in choices for turn in turns)
            for reading, scale in readings
        ]

    def _fits(self, formula: sp.Expr, own: sp.Basic | None, unit: Unit | None) -> bool:
        """Return whether the formula's dimension is that of the unit, or else of its letter."""
        wanted = unit.dimension if unit else self.symbols.find_dimension(own) if own else None
        letters = formula.free_symbols | ({own} if own and not unit else set())
        if wanted in (None, NUMBER) or not letters <= self.known.keys():
            return False
        told = {s: self.symbols.find_dimension(s) or NUMBER for s in formula.free_symbols}
        try:
            return infer(formula, told) == wanted
        except DimensionError:
            return False

    def _has_units(self, formula: sp.Expr, own: sp.Basic | None) -> bool:
        """Return whether all units are known, or fit if letters without a unit are numbers."""
        letters = {*formula.free_symbols, own} - {None, *self.symbols.branches}
        if letters <= self.known.keys() or own not in self.known:
            return letters <= self.known.keys()
        told = {s: self.symbols.find_dimension(s) or NUMBER for s in letters}
        try:
            return infer(formula, told) == told[own]
        except DimensionError:
            return False

    def _list_turns(self, formula: sp.Expr, own: sp.Basic | None) -> list[sp.Expr]:
        """Return an angle's possible offsets in radians: turns, or half turns by an arctangent."""
        dimension = None if own is None else self.symbols.find_dimension(own)
        if dimension is None or not dimension.is_angle or not formula.has(*ANGLES):
            return [sp.S.Zero]
        step = sp.pi if formula.has(sp.atan) else 2 * sp.pi
        return [sp.S.Zero, *(sign * n * step for n in (1, 2) for sign in (1, -1))]

    def _read_degrees(
        self, formula: sp.Expr, own: sp.Basic | None
    ) -> Iterator[tuple[sp.Expr, sp.Expr]]:
        """Yield a formula with angles in radians, and in degrees if no unit is shown for them.

        The second item is the unit of the angle that the formula gives.
        """
        turning = {s for f in formula.atoms(*CIRCULAR) for s in f.free_symbols}
        angles = {s: s * _DEGREE for s in formula.free_symbols if self._may_turn(s, s in turning)}
        is_angle = self._may_turn(own, formula.has(*ANGLES))
        for values in ({}, angles) if angles else ({},):
            turned = formula.xreplace(values)
            yield turned, sp.S.One
            if is_angle:
                yield turned, _DEGREE

    def _may_turn(self, symbol: sp.Basic | None, is_bare_angle: bool) -> bool:
        """Return whether a letter may be an angle in degrees."""
        if symbol is None or symbol in self.shown:
            return False
        dimension = self.symbols.find_dimension(symbol)
        return is_bare_angle if dimension is None else dimension.is_angle
