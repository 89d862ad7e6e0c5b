r"""Equations between numerical values, Q = Vn/1000: they hold for numbers in their letters' units.

Compared with an equation between quantities, Q = Vn, such an equation has an extra factor that
converts units (ISO 80000-1, 6.3). A number with a unit in an inequality, `F<5\,\mathrm{kN}`, is
converted to the unit of the other side: angles count as radians, and a letter without a declared
unit leaves it open.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.numbers.scales import Scales, may_turn_units
from mechproof.document.row_sides import SLOW
from mechproof.document.tasks import Role, Sign
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.values import find_ratio
from mechproof.record import FREQUENCY, NUMBER, Equality, Holds, Row
from mechproof.record.unit_notation import UNITS, Unit, read_unit, weigh
from mechproof.statement_domains.dimension_inference import DimensionError, infer

_NOTE = "Compared as numbers in the units of their letters."
OPEN = "the sides differ only by a factor of {}, which may convert units: which units are meant?"
_NEAR = "the sides differ only by a factor of {:.6g}, which rounding explains"
_AGAIN = (Role.REPEATED, Role.DERIVATIVE)
_ROLES = (Role.STEP, Role.CONSTRAINT, *_AGAIN)
# Factors between units are products of these primes, and larger than counts of parts.
_PRIMES = (2, 3, 5)
_LEAST = 30
# Fewest digits of a factor that may be rounded, and the relative error of doubles.
_DIGITS = 3
_SMALL = 1e-9
_BARE = "it has a unit, {}, but none is declared for {}"
_MISFIT = "the unit {} has dimension {}, the other side has {}"
_MIXED = "it is not known what {} {} is in the units of the other side's letters"
_TURNED = "turns, or radians? neither the unit {} nor the other side says which"
_ZERO = "{} and the other side have different zero points"


def turn_units(row: Row, sign: Sign, known: Known) -> Row | str:
    """State a row between numerical values as such, or return why it may be one."""
    own = sign.own or sign.letter
    sides = _list_sides(row, sign, known)
    settled = [known.settle(side) for side in sides]
    is_slow = any(is_matrix(side) or side.has(*SLOW) for side in settled)
    if own is None or not settled or is_slow:
        return row
    ratio = find_ratio(*settled)
    if ratio is None or abs(ratio - 1) < _SMALL:
        return row
    ratios = [ratio]
    for one, other in _Numbers(known, Scales(known.symbols)).list_pairs(sides, own):
        found = find_ratio(one, other)
        if found is not None and abs(found - 1) < _SMALL:
            note = f"{row.note} {_NOTE}".strip()
            return replace(row, says=Equality(one, other, "member"), note=note)
        ratios += [found] if found is not None else []
    if near := next((one for one in ratios if _is_rounded(one, [*sides, *settled])), None):
        return _NEAR.format(near)
    exact = sp.cancel(settled[0] / settled[1])
    return OPEN.format(max(exact, 1 / exact)) if is_of_units(exact) else row


def _list_sides(row: Row, sign: Sign, known: Known) -> list[sp.Expr]:
    """Return the sides of a comparison of prints, with a letter replaced by its first print."""
    if sign.role not in _ROLES or not isinstance(row.says, Equality):
        return []
    sides = [*row.says.sides]
    if sign.role in _AGAIN:
        first = known.values.get(sign.letter, sign.letter)
        sides = [first if side == sign.letter else side for side in sides]
    are_numbers = all(isinstance(one, sp.Expr) and one != 0 for one in sides)
    are_numbers &= not any(one.has(sp.MatrixExpr) for one in sides)
    return sides if are_numbers else []


@dataclass(frozen=True)
class _Numbers:
    """Turns sides into numbers in the units of their letters, if all these are known."""

    known: Known
    scales: Scales

    def list_pairs(
        self, sides: Sequence[sp.Expr], own: sp.Basic
    ) -> Iterator[tuple[sp.Expr, sp.Expr]]:
        """Yield the sides as they stand, both converted, then only the side of quantities."""
        stand = [self._put_in(side) for side in sides]
        turned = [self._turn(side, own) for side in sides]
        pairs = [stand, turned]
        quantity = _find_quantity(sides)
        if quantity is not None:
            pairs.append([turned[quantity], stand[1 - quantity]])
        for one, other in pairs:
            if one is not None and other is not None:
                yield one, other

    def _turn(self, side: sp.Expr, own: sp.Basic) -> sp.Expr | None:
        """Return a side as a number in a letter's unit; None if the side itself converts units."""
        value = None if _turns_units(side) else self.scales.turn(side, own)
        return None if value is None else self._put_in(value)

    def _put_in(self, value: sp.Expr) -> sp.Expr:
        """Put in letters' definitions as numbers: converted from quantities, or as they stand."""
        values = self.known.values
        given = [s for s in value.free_symbols if isinstance(values.get(s), sp.Expr)]
        numbers = {s: self._turn(values[s], s) for s in given}
        return value.xreplace(
            {s: self._put_in(values[s]) if one is None else one for s, one in numbers.items()}
        )


def _find_quantity(sides: Sequence[sp.Expr]) -> int | None:
    """Return which side is of quantities: the other converts units, or has the larger factor."""
    turning = [_turns_units(side) for side in sides]
    if any(turning):
        return None if all(turning) else turning.index(False)
    factors = (abs(side.subs(sp.pi, 1).as_coeff_Mul()[0]) for side in sides)
    one, other = (max(factor, 1 / factor) for factor in factors)
    return None if one == other else [one, other].index(min(one, other))


def _turns_units(formula: sp.Expr) -> bool:
    """Return whether a formula's number may convert units: 60, 1000 or 3.6, but not 16 or 384."""
    numbers = formula.atoms(sp.Rational)
    return any(one.q % 5 == 0 or (one.p and one.p % 10 == 0) for one in numbers)


def _is_rounded(ratio: float, sides: Sequence[sp.Expr]) -> bool:
    """Return whether a ratio is explained by rounding a number of at least `_DIGITS` digits."""
    read = {one for side in sides for one in side.atoms(sp.Rational) if not _is_decimal(one)}
    for number in {abs(n) for one in read for n in (one.p, one.q)}:
        digits = str(number).rstrip("0")
        half = 10 ** (len(str(number)) - len(digits)) / 2
        if len(digits) >= _DIGITS and abs(ratio - 1) <= half / number + _SMALL:
            return True
    return False


def _is_decimal(number: sp.Rational) -> bool:
    """Return whether a number has decimals; their rounding is judged elsewhere."""
    return number.q > 1 and {*sp.primefactors(number.q)} <= {2, 5}


def is_of_units(ratio: sp.Expr) -> bool:
    """Return whether a number may be a factor of units: of small primes, and no count of parts."""
    number = ratio.subs(sp.pi, 1)
    if (
        not number.is_Rational
        or not number
        or not (abs(ratio) >= _LEAST or abs(ratio) * _LEAST <= 1)
    ):
        return False
    primes = {*sp.primefactors(number.p), *sp.primefactors(number.q)}
    return ratio.is_positive and primes <= {*_PRIMES}


class _LimitError(ValueError):
    """A number that is not known in the unit of the other side."""


def state_limit(row: Row, sign: Sign, known: Known) -> Row | str:
    """State an inequality with both sides in one unit, or return why it is not judged."""
    if not (any(sign.units) and isinstance(row.says, Holds)):
        return row
    one, other = sign.limited
    unit, second = sign.units
    try:
        if second:
            meant = read_unit(unit) if unit else _find_unit(one, other, second, known)
            other = _turn(other, second, meant)
        else:
            one = _turn(one, unit, _find_unit(other, one, unit, known))
    except _LimitError as error:
        return str(error)
    return replace(row, says=Holds(row.says.relation.func(one, other, evaluate=False)))


def _find_unit(side: sp.Expr, number: sp.Expr, unit: str, known: Known) -> Unit:
    """Return the unit of a formula evaluated with numbers in its letters' units.

    Raises `_LimitError`, about `number`, if that unit is not known.
    """
    settled = known.settle(side)
    formula = settled if settled.free_symbols else side
    letters = (side + formula).free_symbols
    found = {s: known.symbols.find_dimension(s) for s in letters}
    told = {s: dimension for s, dimension in found.items() if dimension is not None}
    if bare := sorted(str(s) for s in letters - told.keys()):
        raise _LimitError(_BARE.format(unit, ", ".join(bare)))
    scale, own = _find_scale(formula, known), _find_scale(side, known)
    try:
        dimension = infer(formula, told) or NUMBER
        if formula.free_symbols & {v.symbol for v in UNITS}:
            return Unit(dimension, 1 / weigh(dimension))
    except DimensionError:
        scale = None
    if scale is None or (scale != own and may_turn_units(formula)):
        raise _LimitError(_MIXED.format(number, unit))
    # Angles are radians in all formulas.
    return Unit(dimension, sp.S.One if dimension.is_angle else scale)


def _turn(number: sp.Expr, unit: str, meant: Unit) -> sp.Expr:
    """Return a number converted to another unit; raises `_LimitError` if it cannot be."""
    own = read_unit(unit)
    if own.dimension != meant.dimension:
        raise _LimitError(_MISFIT.format(unit, own.dimension, meant.dimension))
    if own.scale == meant.scale:
        return number
    if sp.nan in (own.scale, meant.scale):
        raise _LimitError(_ZERO.format(unit))
    if own.dimension == FREQUENCY and own.dimension.angle != meant.dimension.angle:
        raise _LimitError(_TURNED.format(unit))
    return number * own.scale / meant.scale


def _find_scale(formula: sp.Expr, known: Known) -> sp.Expr | None:
    """Return a formula's unit in SI units; None if its letters' units do not factor out."""
    names = {s: sp.Dummy(str(s), positive=True) for s in formula.free_symbols}
    plain, turned = (x.xreplace(names) for x in (formula, Scales(known.symbols).to_si(formula)))
    ratio = sp.simplify(turned / plain)
    return ratio if ratio.is_number else None
