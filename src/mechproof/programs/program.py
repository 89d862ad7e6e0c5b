"""Programs: single operations in a fixed order, between mathematics and syntax.

What a form computes is decided here: which operation is rounded after which. Proofs, operation
counts and every backend read programs; a printer only spells them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import sympy as sp

from mechproof.programs.operations import VIEWS

# A result, an input or a constant by its name, or a number that is a double.
Operand = str | int | float
# The result of an operation that is used once and has no name of its own.
TEMPORARY = "_"


@dataclass(frozen=True)
class Operation:
    """One operation: the name of its result, its kind in `KINDS`, its operands."""

    result: str
    kind: str
    operands: tuple[Operand, ...]

    def rename(self, names: Mapping[Operand, Operand]) -> Operation:
        """Return the operation with other names for what it takes and what it makes."""
        operands = tuple(names.get(operand, operand) for operand in self.operands)
        return Operation(str(names.get(self.result, self.result)), self.kind, operands)


@dataclass(frozen=True)
class Program:
    """Inputs, operations each of which uses inputs and results before it, and outputs."""

    inputs: tuple[str, ...]
    operations: tuple[Operation, ...]
    outputs: tuple[Operand, ...]

    def normal_form(self) -> Program:
        """Return the program in the order of its text, temporaries numbered in that order.

        Equal programs become equal objects: a temporary stands right before what uses it.
        """
        operations = self._list_as_read()
        unnamed = (step.result for step in operations if is_unnamed(step.result))
        names: dict[Operand, str] = {n: f"{TEMPORARY}{i}" for i, n in enumerate(unnamed, start=1)}
        return replace(self, operations=operations).rename(names)

    def rename(self, names: Mapping[Operand, Operand]) -> Program:
        """Return the program with other names for its inputs, for results and for operands."""
        inputs = tuple(str(names.get(name, name)) for name in self.inputs)
        operations = tuple(step.rename(names) for step in self.operations)
        return Program(inputs, operations, tuple(names.get(o, o) for o in self.outputs))

    def _list_as_read(self) -> tuple[Operation, ...]:
        made = {step.result: step for step in self.operations}
        listed: dict[Operand, Operation] = {}
        named = [result for result in made if not result.startswith(TEMPORARY)]
        # A sum of many terms is nested deeper than Python calls.
        waiting: list[Operand] = [*reversed([*named, *self.outputs])]
        while waiting:
            operand = waiting[-1]
            step = made.get(str(operand)) if operand not in listed else None
            missing = [x for x in step.operands if x in made and x not in listed] if step else []
            waiting += reversed(missing)
            if not missing:
                waiting.pop()
                listed.update({operand: step} if step else {})
        return tuple(listed.values())

    def count_operations(self) -> int:
        """Count the operations that compute; views of arrays do not."""
        return sum(step.kind not in VIEWS for step in spell_out_forms(self).operations)


NOTHING = Program((), (), ())


def is_unnamed(operand: Operand) -> bool:
    """Say whether an operand is the result of an operation that is used here alone."""
    return isinstance(operand, str) and operand.startswith(TEMPORARY)


def unfuse(program: Program) -> Program:
    """Return the program with a product and a sum for each fma, for languages that have none."""
    operations: list[Operation] = []
    for number, step in enumerate(program.operations, start=1):
        if step.kind == "fma":
            one, other, rest = step.operands
            product = f"{TEMPORARY}product{number}"
            operations.append(Operation(product, "multiply", (one, other)))
            step = Operation(step.result, "add", (product, rest))
        operations.append(step)
    return replace(program, operations=tuple(operations)).normal_form()


def spell_out_forms(program: Program) -> Program:
    """Return the program with products and a sum for each quadratic form.

    The terms of one that is never negative have a size: |m[i, j]| <= sqrt(m[i, i]*m[j, j]).
    """
    operations: list[Operation] = []

    def add(kind: str, *operands: Operand) -> str:
        result = f"{TEMPORARY}form{len(operations) + 1}"
        operations.append(Operation(result, kind, operands))
        return result

    for step in program.operations:
        if step.kind in ("quadratic_form", "nonnegative_form"):
            vector, matrix = step.operands
            pair = add("multiply", add("along_first", vector), add("along_last", vector))
            terms = add("multiply", pair, matrix)
            if step.kind == "quadratic_form":
                step = Operation(step.result, "sum", (terms, 2))
            else:
                width = add("sqrt", add("absolute", add("diagonal", matrix)))
                widths = add("sum", add("multiply", add("absolute", vector), width), 1)
                operands = (add("sum", terms, 2), add("square", widths))
                step = Operation(step.result, "nonnegative", operands)
        operations.append(step)
    return replace(program, operations=tuple(operations)).normal_form()


# Constants by names that no input can have.
CONSTANTS: Mapping[str, sp.Basic] = MappingProxyType(
    {"#pi": sp.pi, "#e": sp.E, "#inf": sp.oo, "#nan": sp.nan}
)
