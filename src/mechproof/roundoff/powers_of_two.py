"""Powers of two: factors that are not rounded, taken after products and quotients.

2*a*b and 2*(a*b) are the same double in the normal range. So what is rounded is the product of a
and b, and a rest of it is seen to be its own.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from mechproof.programs.degrees import DEGREES, Degree
from mechproof.programs.program import Operand
from mechproof.roundoff.steps import (
    EXACT,
    RESTS,
    Step,
    StraightLineProgram,
)

# Sums take their terms as they are.
_PRODUCTS = ("multiply", "divide", "square", *RESTS)


def take_powers_last(straight: StraightLineProgram) -> StraightLineProgram:
    """Return steps in which a rest is of what is rounded, not of a power of two times it."""
    made = {step.result: step for step in straight.steps}
    rests = [made.get(str(step.operands[2])) for step in straight.steps if step.kind in RESTS]
    if not any(product and _find_factor(product) for product in rests):
        return straight
    return _Mover(straight).move()


def _find_factor(step: Step) -> tuple[Operand, int] | None:
    """Return the operand and the exponent of what is multiplied by a power of two."""
    if step.ulps != EXACT or step.kind not in ("multiply", "divide"):
        return None
    first, second = step.operands
    if step.kind == "multiply" and not isinstance(first, str):
        first, second = second, first
    if not isinstance(first, str) or isinstance(second, str) or second < 0:
        return None
    exponent = math.frexp(second)[1] - 1
    return first, exponent if step.kind == "multiply" else -exponent


def _find_exponent(kind: str, exponents: Sequence[int]) -> int | None:
    """Return the exponent of a result by those of its operands; None where it has none."""
    if kind not in _PRODUCTS:
        return None
    given = (Degree({2: exponent} if exponent else {}) for exponent in exponents)
    try:
        found: Degree = DEGREES[kind](*given)
    except ValueError:
        return None
    return found.powers.get(2, 0)


class _Mover:
    def __init__(self, straight: StraightLineProgram) -> None:
        self._straight = straight
        self._steps: list[Step] = []
        # Of results that are others times powers of two.
        self._known: dict[Operand, tuple[Operand, int]] = {}
        self._written: dict[tuple[Operand, int], str] = {}

    def move(self) -> StraightLineProgram:
        for step in self._straight.steps:
            if factor := _find_factor(step):
                base, exponent = self._find(factor[0])
                self._known[step.result] = base, exponent + factor[1]
            else:
                self._take(step)
        outputs = tuple(map(self._write, self._straight.outputs))
        return replace(self._straight, steps=tuple(self._steps), outputs=outputs)

    def _find(self, operand: Operand) -> tuple[Operand, int]:
        return self._known.get(operand, (operand, 0))

    def _take(self, step: Step) -> None:
        found = [self._find(operand) for operand in step.operands]
        exponents = [exponent for _, exponent in found]
        exponent = _find_exponent(step.kind, exponents)
        if exponent is None or not any(exponents):
            self._append(step, [*map(self._write, step.operands)])
            return
        name = f"{step.result} / 2**{exponent}"
        self._append(replace(step, result=name), [base for base, _ in found])
        self._known[step.result] = name, exponent

    def _append(self, step: Step, operands: Sequence[Operand]) -> None:
        self._steps.append(replace(step, operands=tuple(operands)))

    def _write(self, operand: Operand) -> Operand:
        """Return the name of a value, written out."""
        base, exponent = self._find(operand)
        if not exponent:
            return base
        if (base, exponent) not in self._written:
            name = self._written[base, exponent] = f"{base} * 2**{exponent}"
            self._steps.append(Step(name, "multiply", (2.0**exponent, base), EXACT))
        return self._written[base, exponent]
