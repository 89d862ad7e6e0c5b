"""Sizes put into formulas: in, a calculation beside a formula; out, what it is at which sizes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.conversions import UNFIT
from mechproof.document.displays import Printed
from mechproof.document.roles import Sign
from mechproof.document.sizes import SINGLE, Sizes, show, tell_missing
from mechproof.document.units import read_unit
from mechproof.record import Equality

_OTHERS = "the numbers that are put in give {}, the sizes {}: are others meant?"
_ROUNDED = "the numbers that are put in give {}, the sizes {}, which rounding may explain"
# By such a share what rounded numbers give may be off.
_NEAR = 0.01


@dataclass(frozen=True)
class PutIn:
    """What a formula gives is what is calculated, at sizes that are `told`."""

    says: Equality
    told: str


def state_put_in(sign: Sign, own: sp.Basic | None, printed: Printed, sizes: Sizes) -> PutIn | str:
    """State that a calculation is a formula with its sizes put in; another accuses nobody."""
    calculated = [side for side in sign.sides if not side.free_symbols]
    if len(calculated) != 1 or any(isinstance(side, sp.MatrixBase) for side in sign.sides):
        return SINGLE
    given = calculated[0]
    formula = next(side for side in sign.sides if side is not given)
    unit = read_unit(sign.unit) if sign.unit else None
    if unit and not sizes.fits(formula, own, unit):
        return UNFIT
    values = []
    for settled, at, told in _list_settled(formula, sign, printed, sizes):
        for value in (one.xreplace(at) for one in sizes.read([settled], own, unit)):
            if balls.evaluate(value - given, {}).contains(0):
                return PutIn(Equality(value, given, "member"), told)
            values.append(value)
    if not values:
        known = sizes.list_at(printed)[-1]
        return tell_missing(sizes.known.settle(formula).free_symbols - known.keys())
    nearest = min(values, key=lambda value: _measure_off(value, given))
    is_near = _measure_off(nearest, given) <= _NEAR * abs(sp.N(given))
    return (_ROUNDED if is_near else _OTHERS).format(show(given), show(nearest))


def _list_settled(
    formula: sp.Expr, sign: Sign, printed: Printed, sizes: Sizes
) -> Iterator[tuple[sp.Expr, dict[sp.Basic, sp.Expr], str]]:
    """Yield a formula of letters that have sizes, these, and what is told of them.

    First the sizes that are declared or said, then with the numbers of equations before.
    """
    for numbers in ({}, sizes.list_numbers(sign, printed)):
        at = sizes.list_at(printed)[-1] | {s: one.size.value for s, one in numbers.items()}
        settled = (sizes.known.settle(formula), sizes.known.settle(formula, stop=at))
        for one in dict.fromkeys(settled):
            if one.free_symbols <= at.keys():
                yield one, at, sizes.tell_used(one.free_symbols, numbers, printed)


def _measure_off(value: sp.Expr, given: sp.Expr) -> float:
    off = abs(sp.N(value - given))
    return float(off) if off.is_Float else math.inf
