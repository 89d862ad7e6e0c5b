"""Equations between numerical values, Q = Vn/1000: they hold for numbers in the units of letters.

Beside one of quantities, Q = Vn, such an equation has a factor that turns units (ISO 80000-1, 6.3).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice, product

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.roles import Role, Sign
from mechproof.document.scales import Scales
from mechproof.document.sides import SLOW
from mechproof.record import Equality, Row

_NOTE = "Compared as numbers in the units of their letters."
_OPEN = "the sides differ by a factor of {} only, which may turn units: in which are they meant?"
_NEAR = "as numbers in the units of letters the sides differ by a factor of {:.6g} only: rounded?"
_ROLES = (Role.STEP, Role.REPEATED, Role.CONSTRAINT)
# Factors of units are products of these, and larger than those of counts.
_PRIMES = (2, 3, 5)
_LEAST = 30
# Relative errors of a factor of three digits that is rounded, and of doubles.
_ROUNDED = 1 / 200
_SMALL = 1e-9
# Ways to read the letters of a side that are tried.
_MOST = 16


def turn_units(row: Row, sign: Sign, own: sp.Basic | None, known: Known) -> Row | str:
    """State a row as one of numerical values if it is one, or say why it may be.

    `own` is the letter that its chain is about.
    """
    own = own or sign.letter
    sides = _list_sides(row, sign, known)
    settled = [known.settle(side) for side in sides]
    if own is None or not any(map(_turns_units, settled)) or any(x.has(*SLOW) for x in settled):
        return row
    ratio = _find_ratio(*settled)
    if ratio is None or abs(ratio - 1) < _ROUNDED:
        return row
    ratios = []
    for one, other in product(*(list(_Reading(known).read(side, own)) for side in sides)):
        found = _find_ratio(one, other)
        if found is not None and abs(found - 1) < _SMALL:
            note = f"{row.note} {_NOTE}".strip()
            return replace(row, says=Equality(one, other, "member"), note=note)
        ratios += [found] if found is not None else []
    if near := next((one for one in ratios if abs(one - 1) < _ROUNDED), None):
        return _NEAR.format(near)
    exact = sp.cancel(settled[0] / settled[1])
    return _OPEN.format(max(exact, 1 / exact)) if _is_of_units(exact) else row


def _list_sides(row: Row, sign: Sign, known: Known) -> list[sp.Expr]:
    """Return the sides of a print that is compared with another; of a letter its first print."""
    if sign.role not in _ROLES or not isinstance(row.says, Equality):
        return []
    sides = [row.says.printed, row.says.rebuilt]
    if sign.role is Role.REPEATED:
        first = known.values.get(sign.letter)
        sides = [first if side == sign.letter else side for side in sides]
    are_numbers = all(isinstance(side, sp.Expr) and side != 0 for side in sides)
    return sides if are_numbers else []


@dataclass(frozen=True)
class _Reading:
    """What sides are as numbers in the units of their letters, where all of these are known."""

    known: Known

    def read(self, side: sp.Expr, own: sp.Basic) -> Iterator[sp.Expr]:
        """Yield a side as it stands, and what it is in the unit of a letter, if it turns none."""
        scales = Scales(self.known.symbols)
        values = [side]
        if not _turns_units(side) and side.free_symbols | {own} <= scales.known.keys():
            values = [side, *scales.list_values(side, own, None)]
        for value in dict.fromkeys(values):
            yield from islice(self._put_in(value), _MOST)

    def _put_in(self, value: sp.Expr) -> Iterator[sp.Expr]:
        """Yield a value with the numbers that its letters are by their definitions."""
        given = sorted(value.free_symbols & self.known.values.keys(), key=str)
        numbers = (self._list_numbers(letter) for letter in given)
        for chosen in product(*numbers):
            yield value.xreplace(dict(zip(given, chosen, strict=True)))

    def _list_numbers(self, letter: sp.Basic) -> list[sp.Expr]:
        value = self.known.values[letter]
        found = list(islice(self.read(value, letter), _MOST)) if isinstance(value, sp.Expr) else []
        # As it stands it is one of quantities, unless it turns units itself.
        return found if _turns_units(value) else found[1:] or found


def _find_ratio(one: sp.Expr, other: sp.Expr) -> float | None:
    """Return the ratio of sides if it is the same at two points, as doubles tell."""
    letters = sorted(one.free_symbols | other.free_symbols, key=str)
    ratios = []
    for step in (3, 5):
        values = {s: sp.Rational(7 * n + step, 13) for n, s in enumerate(letters)}
        above, below = (side.xreplace(values).evalf() for side in (one, other))
        if not (above.is_Float and below.is_Float) or below == 0:
            return None
        ratios.append(float(above / below))
    return ratios[0] if abs(ratios[0] - ratios[1]) <= _SMALL * abs(ratios[0]) else None


def _turns_units(formula: sp.Expr) -> bool:
    """Return whether a formula has a number that may turn units, 60, 1000 or 3.6: not 16 or 384."""
    numbers = formula.atoms(sp.Rational)
    return any(one.q % 5 == 0 or (one.p and one.p % 10 == 0) for one in numbers)


def _is_of_units(ratio: sp.Expr) -> bool:
    """Return whether a number may be a factor of units: no large prime, and no count of parts."""
    number = ratio.subs(sp.pi, 1)
    if not number.is_Rational or not (abs(ratio) >= _LEAST or abs(ratio) * _LEAST <= 1):
        return False
    primes = {*sp.primefactors(number.p), *sp.primefactors(number.q)}
    return ratio.is_positive and primes <= {*_PRIMES}
