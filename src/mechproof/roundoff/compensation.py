"""Compensation: which roundings move no output, because a low word takes them up.

With every other operation exact, the outputs do not depend on the rounded product whose rest is
added again, nor on the rounded quotient inside both. That is shown here by derivatives, rational in
the values of the functions; the other roundings are then bounded at whatever these have become.
Error-free transformations (Ogita, Rump and Oishi 2005) are used so by hand; here it is checked that
they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import sympy as sp

from mechproof.arithmetic.polynomials import cancel
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import CONSTANTS, Operand
from mechproof.roundoff.powers_of_two import take_powers_last
from mechproof.roundoff.steps import (
    CONSTANT,
    PRODUCT_REST,
    QUOTIENT_REST,
    RESTS,
    Step,
    StraightLineProgram,
)

Pair = tuple[sp.Expr, sp.Expr]


def find_compensated(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps with what is compensated held; ValueError where a rest is no low word."""
    straight = take_powers_last(straight)
    products = _list_rounded(straight, PRODUCT_REST)
    for name in (*products, *_list_rounded(straight, QUOTIENT_REST)):
        for output in straight.outputs:
            if not _is_still(straight, name, products, output):
                raise ValueError(f"an output depends on the rounding of {name}, its rest apart")
    return replace(straight, held=products)


def _list_rounded(straight: StraightLineProgram, rest: str) -> tuple[str, ...]:
    """List the results that have a rest of a kind, in the order of the rests."""
    found = (str(step.operands[2]) for step in straight.steps if step.kind == rest)
    return tuple(dict.fromkeys(found))


def _is_still(
    straight: StraightLineProgram, name: str, products: Sequence[str], output: Operand
) -> bool:
    """Return whether no rounded value moves an output, as its rests and products see it."""
    symbols = (*straight.inputs, *CONSTANTS)
    values: dict[Operand, Pair] = {n: (sp.Symbol(n), sp.S.Zero) for n in symbols}
    moved = (sp.Symbol(f"rounded {name}"), sp.S.One)
    for step in straight.steps:
        sees = step.kind in RESTS or step.result in products
        given = [
            moved
            if operand == name and sees
            else values[operand]
            if isinstance(operand, str)
            else (sp.nsimplify(operand, rational=True), sp.S.Zero)
            for operand in step.operands
        ]
        if step.result in products:
            # A double whose rounding is a matter of its own.
            values[step.result] = (sp.Symbol(f"rounded {step.result}"), sp.S.Zero)
        else:
            values[step.result] = _differentiate(step, given)
        if step.result == name and name in products:
            values[name] = moved
    return bool(cancel(values[output][1])[0] == 0)


def _differentiate(step: Step, given: list[Pair]) -> Pair:
    """Return value and derivative; those of functions are symbols, their derivatives rational."""
    meaning, arguments, slopes = _find_slopes(step.kind, len(given))
    places = dict(zip(arguments, (value for value, _ in given), strict=True))
    moving = zip(slopes, (slope for _, slope in given), strict=True)
    total = sp.Add(*(part * slope for part, slope in moving if slope != 0))
    value = meaning
    if not meaning.is_rational_function():
        value = sp.Symbol(f"value {step.result}")
        total = total.xreplace({meaning: value})
    return value.xreplace(places), total.xreplace(places)


@cache
def _find_slopes(
    kind: str, count: int
) -> tuple[sp.Expr, tuple[sp.Dummy, ...], tuple[sp.Expr, ...]]:
    """Return the meaning of an operation, in letters for its operands, and its derivatives."""
    letters = tuple(sp.Dummy() for _ in range(count))
    meaning = letters[0] if kind == CONSTANT else SYMBOLIC[kind](*letters)
    return meaning, letters, tuple(meaning.diff(letter) for letter in letters)
