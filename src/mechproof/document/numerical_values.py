"""Equations between numerical values, Q = Vn/1000: they hold for numbers in the units of letters.

Beside one of quantities, Q = Vn, such an equation has a factor that turns units (ISO 80000-1, 6.3).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.roles import Role, Sign
from mechproof.document.scales import Scales, may_turn_units
from mechproof.document.sides import SLOW
from mechproof.record import Equality, Row

_NOTE = "Compared as numbers in the units of their letters."
_OPEN = "the sides differ by a factor of {} only, which may turn units: in which are they meant?"
_NEAR = "as numbers in the units of their letters the sides differ by a factor of {} only: rounded?"
# Factors of units are products of these, and larger than those of counts.
_PRIMES = (2, 3, 5)
_LEAST = 30
# Relative errors of a factor of three digits that is rounded, and of doubles.
_ROUNDED = sp.Rational(1, 200)
_SMALL = 1e-9


def turn_units(row: Row, sign: Sign, own: sp.Basic | None, known: Known) -> Row | str:
    """State a row as one of numerical values if it is one, or say why it may be.

    `own` is the letter that its chain is about.
    """
    sides = _list_sides(row, sign, known)
    if sides is None or not _may_be_alike(*sides):
        return row
    ratio = sp.cancel(sides[0] / sides[1])
    if ratio.free_symbols or not ratio.is_finite or abs(ratio - 1) < _ROUNDED:
        return row
    scales = Scales(known.symbols)
    letters = sides[0].free_symbols | sides[1].free_symbols | {own}
    found = {}
    if letters <= scales.known.keys():
        pairs = (sides, sides[::-1])
        read = [(value, o) for one, o in pairs for value in scales.list_values(one, own, None)]
        ratios = ((sp.cancel(value / numbers), value, numbers) for value, numbers in read)
        found = {r: (value, numbers) for r, value, numbers in ratios if not r.free_symbols}
    if 1 in found:
        note = f"{row.note} {_NOTE}".strip()
        return replace(row, says=Equality(*found[sp.S.One], "member"), note=note)
    if near := next((one for one in found if abs(one - 1) < _ROUNDED), None):
        return _NEAR.format(sp.N(near, 6))
    return _OPEN.format(max(ratio, 1 / ratio)) if _is_of_units(ratio) else row


def _list_sides(row: Row, sign: Sign, known: Known) -> tuple[sp.Expr, sp.Expr] | None:
    """Return the sides of a print that is compared with another, if numbers may turn its units."""
    if sign.role not in (Role.STEP, Role.REPEATED) or not isinstance(row.says, Equality):
        return None
    first: Mapping[sp.Basic, sp.Expr] = {sign.letter: known.values.get(sign.letter, sign.letter)}
    sides = row.says.printed, row.says.rebuilt
    if sign.role is Role.REPEATED:
        sides = tuple(first.get(side, side) for side in sides)
    one, other = sides
    if not (isinstance(one, sp.Expr) and isinstance(other, sp.Expr)) or other == 0:
        return None
    return (one, other) if may_turn_units(one) or may_turn_units(other) else None


def _may_be_alike(one: sp.Expr, other: sp.Expr) -> bool:
    """Return whether the ratio of sides is the same at two points: only then is it worked out."""
    if one.has(*SLOW) or other.has(*SLOW):
        return False
    letters = sorted(one.free_symbols | other.free_symbols, key=str)
    ratios = []
    for step in (3, 5):
        values = {s: sp.Rational(7 * n + step, 13) for n, s in enumerate(letters)}
        above, below = (side.xreplace(values).evalf() for side in (one, other))
        if not (above.is_number and below.is_number) or below == 0:
            return False
        ratios.append(above / below)
    return bool(abs(ratios[0] - ratios[1]) <= _SMALL * abs(ratios[0]))


def _is_of_units(ratio: sp.Expr) -> bool:
    """Return whether a number may be a factor of units: no large prime, and no count of parts."""
    number = ratio.subs(sp.pi, 1)
    if not number.is_Rational or not (abs(ratio) >= _LEAST or abs(ratio) * _LEAST <= 1):
        return False
    primes = {*sp.primefactors(number.p), *sp.primefactors(number.q)}
    return ratio.is_positive and primes <= {*_PRIMES}
