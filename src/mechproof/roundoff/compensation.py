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

import sympy as sp

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
            if _slope(straight, name, products, output) != 0:
                raise ValueError(f"an output depends on the rounding of {name}, its rest apart")
    return replace(straight, held=products)


def _list_rounded(straight: StraightLineProgram, rest: str) -> tuple[str, ...]:
    """List the results that have a rest of a kind, in the order of the rests."""
    found = (str(step.operands[2]) for step in straight.steps if step.kind == rest)
    return tuple(dict.fromkeys(found))


def _slope(
    straight: StraightLineProgram, name: str, products: Sequence[str], output: Operand
) -> sp.Expr:
    """Return the derivative of an output by a rounded value, as its rests and products see it."""
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
    return sp.cancel(sp.together(values[output][1]))


def _differentiate(step: Step, given: list[Pair]) -> Pair:
    """Return value and derivative; those of functions are symbols, their derivatives rational."""
    dummies = [sp.Dummy() for _ in given]
    meaning = dummies[0] if step.kind == CONSTANT else SYMBOLIC[step.kind](*dummies)
    places = dict(zip(dummies, (value for value, _ in given), strict=True))
    total = sum(
        (meaning.diff(d) * slope for d, (_, slope) in zip(dummies, given, strict=True)), sp.S.Zero
    )
    value = meaning
    if not meaning.is_rational_function():
        value = sp.Symbol(f"value {step.result}")
        total = total.xreplace({meaning: value})
    return sp.expand(value.xreplace(places)), total.xreplace(places)
