"""Conditions: in, a program that tests whether all hold; out, one with an output for each.

Two that bound a value by 0 and infinity become one, which NumPy kernels test at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import count
from types import MappingProxyType

from mechproof.programs.program import TEMPORARY, Operand, Operation, Program

# Kinds that test whether a value is finite and above 0, or not below 0, and their comparisons.
SIGNS: Mapping[str, str] = MappingProxyType(
    {"is_positive": "greater", "is_nonnegative": "greater_equal"}
)
SIGN_OF: Mapping[str, str] = MappingProxyType({low: sign for sign, low in SIGNS.items()})


def split_conditions(program: Program) -> Program:
    """Return the program with an output per condition; a sign and finiteness become one."""
    conditions = _Conditions(program)
    (rest,), parts = program.outputs, []
    while (joined := conditions.made.get(rest)) and joined.kind == "both":
        rest, last = joined.operands
        parts.append(last)
    return conditions.with_outputs(conditions.merge([rest, *reversed(parts)]))


def join_conditions(program: Program) -> Program:
    """Return the program that tests whether all outputs hold: the inverse of splitting."""
    conditions = _Conditions(program)
    first, *others = [part for output in program.outputs for part in conditions.spell_out(output)]
    for other in others:
        first = conditions.add("both", first, other)
    return conditions.with_outputs([first])


class _Conditions:
    def __init__(self, program: Program) -> None:
        self.made: dict[Operand, Operation] = {step.result: step for step in program.operations}
        self._program = program
        self._numbers = count(1)

    def add(self, kind: str, *operands: Operand) -> Operand:
        result = f"{TEMPORARY}condition{next(self._numbers)}"
        self.made[result] = Operation(result, kind, operands)
        return result

    def with_outputs(self, outputs: list[Operand]) -> Program:
        operations = tuple(self.made.values())
        return replace(self._program, operations=operations, outputs=tuple(outputs)).normal_form()

    def merge(self, outputs: list[Operand]) -> list[Operand]:
        merged: list[Operand] = []
        for output in outputs:
            together = self._join_sign(merged[-1], output) if merged else None
            if together is not None:
                merged.pop()
            merged.append(output if together is None else together)
        return merged

    def _join_sign(self, one: Operand, other: Operand) -> Operand | None:
        """Return the condition that replaces two that bound a value by 0 and infinity, or None."""
        (low, around), (high, other_around) = self._unwrap(one), self._unwrap(other)
        if low.kind not in SIGN_OF or low.operands[1] != 0 or around != other_around:
            return None
        if high.kind != "is_finite" or high.operands[0] != low.operands[0]:
            return None
        return self._wrap(self.add(SIGN_OF[low.kind], low.operands[0]), around)

    def spell_out(self, output: Operand) -> list[Operand]:
        step, around = self._unwrap(output)
        if step.kind not in SIGNS:
            return [output]
        (value,) = step.operands
        parts = self.add(SIGNS[step.kind], value, 0.0), self.add("is_finite", value)
        return [self._wrap(part, around) for part in parts]

    def _unwrap(self, output: Operand) -> tuple[Operation, Operand | None]:
        """Return the operation of a condition, and the axes over which every element must hold."""
        step = self.made[output]
        if step.kind == "every":
            return self.made[step.operands[0]], step.operands[1]
        return step, None

    def _wrap(self, condition: Operand, around: Operand | None) -> Operand:
        return condition if around is None else self.add("every", condition, around)
