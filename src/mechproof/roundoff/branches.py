"""Branches: in, steps that choose by the sign of one result; out, the steps for either sign.

Roundings may change that sign, so that either branch may be computed. If both are proved to be the
same function in exact arithmetic, each can be bounded wherever it may be taken. Other choices stay
among the steps, with a jump between the sides where roundings may flip the test.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import sympy as sp

from mechproof.arithmetic.intervals import Mask
from mechproof.arithmetic.polynomials import is_zero
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import CONSTANTS, Operand
from mechproof.roundoff.bound import KINDS
from mechproof.roundoff.interval_monomials import IntervalMonomial
from mechproof.roundoff.steps import CHOICE, CONSTANT, EXACT, Step, StraightLineProgram, keep_needed

TEST = "greater_equal"
# Functions that compiled kernels implement themselves, without a proved error.
UNPROVED = frozenset({"exp", "log"})
_Known = dict[tuple[str, tuple[Any, ...]], sp.Symbol]


@dataclass(frozen=True)
class Branch:
    """Steps taken where the result `tested` is not negative or, if `is_negative`, where it is."""

    straight: StraightLineProgram
    tested: str = ""
    is_negative: bool = False

    @property
    def test(self) -> StraightLineProgram:
        """Return the steps that compute the tested result."""
        return keep_needed(replace(self.straight, outputs=(self.tested,), held=(), scaled=()))

    def find_taken(self, computed: IntervalMonomial) -> Mask:
        """Return where the branch may be taken, by an enclosure of the computed tested result."""
        variables, powers = computed.variables, computed.powers
        if not variables.is_positive(powers):
            return True
        if self.is_negative:
            return ~(computed.span.low >= 0)
        # A result that vanishes with a variable is zero there, not negative.
        return ~((computed.span.high < 0) & variables.never_vanish(powers))


# A stage's branches are listed more than once, and the proof takes a while.
@lru_cache(maxsize=64)
def list_branches(straight: StraightLineProgram) -> tuple[Branch, ...]:
    """List both branches of steps if they are one function; otherwise only the steps themselves."""
    if by := _find_tested(straight):
        branches = tuple(Branch(_resolve(straight, by, sign), by, sign) for sign in (False, True))
        if _are_equal(*branches):
            return branches
    return (Branch(straight),)


def list_bounded_branches(straight: StraightLineProgram) -> tuple[Branch, ...]:
    """List the branches of steps; ValueError for operations whose rounding cannot be bounded."""
    branches = list_branches(straight)
    kinds = {step.kind for branch in branches for step in branch.straight.steps}
    if unknown := sorted(kinds - (KINDS - UNPROVED)):
        raise ValueError(
            f"roundings of {', '.join(unknown)} cannot be bounded: leave out the charts"
        )
    return branches


def _find_tested(straight: StraightLineProgram) -> str:
    """Return the name of the result whose sign decides every choice; empty if there is none."""
    tests = {step.result: step for step in straight.steps if step.kind == TEST}
    choices = (str(step.operands[0]) for step in straight.steps if step.kind == CHOICE)
    tested = {tests[name].operands if name in tests else () for name in choices}
    match [*tested]:
        case [(str(by), 0)]:
            return by
    return ""


def _resolve(straight: StraightLineProgram, by: str, is_negative: bool) -> StraightLineProgram:
    """Return the steps for one sign of a result, which also resolves its absolute value.

    The tested result is kept even if it is not needed.
    """
    names: dict[Operand, Operand] = {}
    steps = []
    for step in straight.steps:
        operands = tuple(names.get(operand, operand) for operand in step.operands)
        if step.kind == CHOICE:
            names[step.result] = operands[2 if is_negative else 1]
        elif step.kind == "absolute" and operands == (by,) and not is_negative:
            names[step.result] = by
        elif step.kind == "absolute" and operands == (by,):
            steps.append(Step(step.result, "negate", (by,), EXACT))
        elif step.kind != TEST:
            steps.append(replace(step, operands=operands))
    outputs = tuple(names.get(output, output) for output in straight.outputs)
    kept = keep_needed(replace(straight, steps=tuple(steps), outputs=(*outputs, by)))
    return replace(kept, outputs=outputs)


def _are_equal(one: Branch, other: Branch) -> bool:
    """Return whether two branches' outputs are proved equal in exact arithmetic."""
    relations: dict[sp.Pow, sp.Expr] = {}
    known: _Known = {}
    sides = [_express(branch.straight, relations, known) for branch in (one, other)]
    try:
        return all(is_zero(a - b, relations) for a, b in zip(*sides, strict=True))
    except sp.PolynomialError:
        # SymPy raises this, for instance, for roots of quotients.
        return False


def _express(
    straight: StraightLineProgram,
    relations: dict[sp.Pow, sp.Expr],
    known: _Known,
) -> list[sp.Expr]:
    """Return the outputs with symbols for roots and functions; add roots' squares to relations."""
    values: dict[Operand, sp.Expr] = {n: sp.Symbol(n) for n in (*straight.inputs, *CONSTANTS)}

    def take(operand: Operand) -> sp.Expr:
        return values[operand] if isinstance(operand, str) else sp.Rational(operand)

    for step in straight.steps:
        # The operand of a constant is the number itself.
        given: tuple[Any, ...] = step.operands
        given = given if step.kind == CONSTANT else tuple(map(take, given))
        meaning = None if step.kind == CONSTANT else SYMBOLIC[step.kind](*given)
        if meaning is not None and meaning.is_rational_function():
            values[step.result] = meaning
            continue
        values[step.result] = symbol = known.setdefault((step.kind, given), sp.Dummy(step.result))
        if meaning is not None and (meaning**2).is_rational_function():
            relations[symbol**2] = meaning**2
    return [take(output) for output in straight.outputs]
