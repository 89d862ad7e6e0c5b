"""Branches: in, steps that choose by the sign of one of them; out, the steps of either sign.

Where a number and its sign are rounded, either branch may be computed. Both are one function of
exact numbers, which is shown here, so that each is bounded wherever it may be taken. Of branches
that differ there is no bound (Goubault and Putot 2013 bound the jump besides).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from mechproof.arithmetic.intervals import Mask
from mechproof.arithmetic.polynomials import is_zero
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import CONSTANTS, Operand
from mechproof.roundoff.interval_monomials import IntervalMonomial
from mechproof.roundoff.steps import EXACT, Step, StraightLineProgram, keep_needed

CHOICE, TESTS = "choose", ("greater_equal",)
_ROOTS = ("sqrt", "hypot")
_RATIONAL = ("add", "subtract", "multiply", "divide", "fma", "negate", "square")


@dataclass(frozen=True)
class Branch:
    """Steps without a choice, taken where a result of theirs is not negative, or where it is."""

    straight: StraightLineProgram
    tested: str = ""
    is_negative: bool = False

    @property
    def test(self) -> StraightLineProgram:
        """Return the steps of the result that decides."""
        return keep_needed(replace(self.straight, outputs=(self.tested,), held=(), scaled=()))

    def find_taken(self, computed: IntervalMonomial) -> Mask:
        """Say where it may be taken, by what the result may be as it is computed."""
        variables, powers = computed.variables, computed.powers
        if not variables.is_positive(powers):
            return True
        if self.is_negative:
            return ~(computed.span.low >= 0)
        # What vanishes with a variable is not negative there.
        return ~((computed.span.high < 0) & variables.never_vanish(powers))


def list_branches(straight: StraightLineProgram) -> tuple[Branch, ...]:
    """List the branches of steps, the steps themselves if they choose nothing.

    Raises ValueError for choices by anything but the sign of one result, and for branches that are
    not shown to be one function.
    """
    if all(step.kind != CHOICE for step in straight.steps):
        return (Branch(straight),)
    tested = {_find_tested(step) for step in straight.steps if step.kind in TESTS}
    if len(tested) != 1:
        raise ValueError(f"chosen by the signs of {', '.join(sorted(tested)) or 'nothing'}")
    (by,) = tested
    branches = tuple(Branch(_resolve(straight, by, sign), by, sign) for sign in (False, True))
    _require_equal(*branches)
    return branches


def _find_tested(step: Step) -> str:
    operand, zero = step.operands
    if not isinstance(operand, str) or zero != 0:
        raise ValueError(f"{step.result}: only a result is compared, with zero")
    return operand


def _resolve(straight: StraightLineProgram, by: str, is_negative: bool) -> StraightLineProgram:
    """Return the steps of a sign: the size of what has it is that itself, or what it is negated."""
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
        elif step.kind not in TESTS:
            steps.append(replace(step, operands=operands))
    outputs = tuple(names.get(output, output) for output in straight.outputs)
    return keep_needed(replace(straight, steps=tuple(steps), outputs=outputs))


def _require_equal(one: Branch, other: Branch) -> None:
    """Require that exact numbers have the same outputs; ValueError if that is not shown."""
    relations: dict[sp.Pow, sp.Expr] = {}
    known: dict[tuple[str, tuple[sp.Expr, ...]], sp.Symbol] = {}
    sides = [_express(branch.straight, relations, known) for branch in (one, other)]
    for above, below in zip(*sides, strict=True):
        if not is_zero(above - below, relations):
            raise ValueError(f"the branches by the sign of {one.tested} are not shown to be equal")


def _express(
    straight: StraightLineProgram,
    relations: dict[sp.Pow, sp.Expr],
    known: dict[tuple[str, tuple[sp.Expr, ...]], sp.Symbol],
) -> list[sp.Expr]:
    """Return the outputs, roots and other functions being symbols, of which squares are known."""
    values: dict[Operand, sp.Expr] = {n: sp.Symbol(n) for n in (*straight.inputs, *CONSTANTS)}

    def take(operand: Operand) -> sp.Expr:
        return values[operand] if isinstance(operand, str) else sp.Rational(operand)

    for step in straight.steps:
        given = tuple(map(take, step.operands))
        if step.kind in _RATIONAL:
            values[step.result] = SYMBOLIC[step.kind](*given)
            continue
        values[step.result] = symbol = known.setdefault((step.kind, given), sp.Dummy(step.result))
        if step.kind in _ROOTS:
            relations[symbol**2] = (
                given[0] if step.kind == "sqrt" else sp.Add(*(g**2 for g in given))
            )
    return [take(output) for output in straight.outputs]
