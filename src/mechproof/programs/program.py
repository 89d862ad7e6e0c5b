"""Programs: single operations in a fixed order, between mathematics and syntax.

A program fixes what a form computes: which operation is rounded after which. Proofs, operation
counts and every backend read programs; a printer only spells them. The code of a kernel is what a
backend prints, and what reading the printed source must return.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import sympy as sp

from mechproof.programs.operations import VIEWS

# An operand is the name of a result, an input or a constant, or a number that is a double.
Operand = str | int | float
# Prefix of unnamed results, which are used only once.
TEMPORARY = "_"
# Prefix of the functions that check conditions.
CHECK = "_check_of_"


@dataclass(frozen=True)
class Operation:
    """One operation: the name of its result, its kind in `KINDS`, its operands."""

    result: str
    kind: str
    operands: tuple[Operand, ...]

    def rename(self, names: Mapping[Operand, Operand]) -> Operation:
        """Return the operation with its operands and its result renamed."""
        operands = tuple(names.get(operand, operand) for operand in self.operands)
        return Operation(str(names.get(self.result, self.result)), self.kind, operands)


@dataclass(frozen=True)
class Program:
    """Inputs, operations that each use inputs and earlier results, and outputs."""

    inputs: tuple[str, ...]
    operations: tuple[Operation, ...]
    outputs: tuple[Operand, ...]

    def normal_form(self) -> Program:
        """Return the program in the order of its printed text, temporaries numbered in that order.

        A temporary comes right before the operation that uses it, so equal programs become equal
        objects.
        """
        operations = self._list_as_read()
        unnamed = (step.result for step in operations if is_unnamed(step.result))
        names: dict[Operand, str] = {n: f"{TEMPORARY}{i}" for i, n in enumerate(unnamed, start=1)}
        return replace(self, operations=operations).rename(names)

    def rename(self, names: Mapping[Operand, Operand]) -> Program:
        """Return the program with inputs, results and operands renamed."""
        inputs = tuple(str(names.get(name, name)) for name in self.inputs)
        operations = tuple(step.rename(names) for step in self.operations)
        return Program(inputs, operations, tuple(names.get(o, o) for o in self.outputs))

    def _list_as_read(self) -> tuple[Operation, ...]:
        made = {step.result: step for step in self.operations}
        listed: dict[Operand, Operation] = {}
        named = [result for result in made if not result.startswith(TEMPORARY)]
        # Not recursive: a sum of many terms is nested deeper than Python's limit on recursion.
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
        """Count the operations, without views of arrays, which compute nothing."""
        return sum(step.kind not in VIEWS for step in spell_out_forms(self).operations)


NOTHING = Program((), (), ())


def is_unnamed(operand: Operand) -> bool:
    """Return whether an operand is an unnamed result, which is used only once."""
    return isinstance(operand, str) and operand.startswith(TEMPORARY)


def unfuse(program: Program) -> Program:
    """Return the program with a product and a sum for each fma, for languages without fma."""
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

    The terms of a form that is never negative have a known size:
    |m[i, j]| <= sqrt(m[i, i]*m[j, j]).
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


# Constants, under names that no input can have.
CONSTANTS: Mapping[str, sp.Basic] = MappingProxyType(
    {"#pi": sp.pi, "#e": sp.E, "#inf": sp.oo, "#nan": sp.nan}
)


@dataclass(frozen=True)
class Stage:
    """One form in two programs: one of the parameters alone, and one for the rest, point by point.

    `when` is the condition on the parameters under which the stage is taken. `prepare` takes the
    `parameters`; `evaluate` takes the `running` components and then the outputs of `prepare`. For
    an affine stage, `prepare` outputs a matrix row by row, then a shift, and `evaluate` is None.
    """

    when: Program | None
    running: tuple[str, ...]
    parameters: tuple[str, ...]
    prepare: Program
    evaluate: Program | None

    @property
    def affine(self) -> bool:
        """Return whether the points are mapped by a matrix and a shift."""
        return self.evaluate is None

    @property
    def prepares(self) -> bool:
        """Return whether anything is computed from the parameters alone."""
        return bool(self.prepare.operations) or self.prepare.outputs != self.parameters

    @property
    def programs(self) -> tuple[Program, ...]:
        """Return the programs that the stage consists of."""
        return (self.prepare,) if self.evaluate is None else (self.prepare, self.evaluate)

    def change(self, change: Callable[[Program], Program]) -> Stage:
        """Return the stage with each program changed, except one that is `NOTHING`."""
        prepare = self.prepare if self.prepare is NOTHING else change(self.prepare)
        evaluate = None if self.evaluate is None else change(self.evaluate)
        return replace(self, prepare=prepare, evaluate=evaluate)

    def spell_out(self) -> Stage:
        """Return the stage with a program for the affine map, if it has one."""
        return replace(self, evaluate=self.evaluate or map_affinely(self.running))


@dataclass(frozen=True)
class KernelCode:
    """The programs of a kernel and how its arguments enter them.

    `vectors` are the arguments with components on their last axis, `indexed` those with axes that
    are summed over, and the number of these. `inside` tests whether the parameters are in the
    domain; outside it the `masked` ones become NaN. `shape` is that of the result's last axes.
    """

    name: str
    arguments: tuple[str, ...]
    vectors: tuple[tuple[str, tuple[str, ...]], ...]
    indexed: tuple[tuple[str, int], ...]
    inside: Program | None
    masked: tuple[str, ...]
    stages: tuple[Stage, ...]
    shape: tuple[int, ...]
    quiet: bool

    @property
    def axes(self) -> tuple[int, ...]:
        """Return the number of each argument's last axes that do not broadcast; empty if all do."""
        counts = {name: 1 for name, _ in self.vectors} | dict(self.indexed)
        return tuple(counts.get(name, 0) for name in self.arguments) if counts else ()

    @property
    def terms(self) -> tuple[str, ...]:
        """Return the arguments with axes to sum over whose elements the domain tests."""
        steps = self.inside.operations if self.inside else ()
        asked = {operand for step in steps for operand in step.operands}
        return tuple(name for name, _ in self.indexed if name in asked)

    @property
    def names(self) -> frozenset[str]:
        """Return the names of arguments, their components, inputs of programs and results."""
        programs = [p for stage in self.stages for p in stage.programs]
        programs += [self.inside] if self.inside else []
        parts = [self.arguments, *(names for _, names in self.vectors)]
        parts += [program.inputs for program in programs]
        steps = (step.result for program in programs for step in program.operations)
        return frozenset(name for part in parts for name in part).union(steps)

    def count_operations(self) -> tuple[int, ...]:
        """Return the number of operations of each stage."""
        return tuple(sum(p.count_operations() for p in s.programs) for s in self.stages)


def map_affinely(point: tuple[str, ...]) -> Program:
    """Return the program of M @ p + v, with the inputs p, M row by row, then v."""
    count = len(point)
    rows = tuple(f"m{i}{j}" for i in range(count) for j in range(count))
    shift = tuple(f"v{i}" for i in range(count))
    operations: list[Operation] = []
    outputs = []
    for i in range(count):
        result: Operand = shift[i]
        for j in reversed(range(count)):
            name = f"{TEMPORARY}{len(operations) + 1}"
            operations.append(Operation(name, "fma", (rows[i * count + j], point[j], result)))
            result = name
        outputs.append(result)
    inputs = (*point, *rows, *shift)
    return Program(inputs, tuple(operations), tuple(outputs)).normal_form()


def name_functions(codes: Iterable[KernelCode]) -> dict[str, str]:
    """Return the name to call for each function: that of the first equal one in the module."""
    first: dict[object, str] = {}
    return {
        name: first.setdefault(made, name) for code in codes for name, made in _list_functions(code)
    }


def list_suffixes(code: KernelCode) -> list[str]:
    """List the suffixes of the stages' functions; the last stage has that of the kernel."""
    others = [f"_{number}_of_{code.name}" for number in range(1, len(code.stages))]
    return [*others, f"_of_{code.name}"]


def _list_functions(code: KernelCode) -> Iterator[tuple[str, object]]:
    """Yield the names of a kernel's functions, each with all that determines its text."""
    if code.inside:
        made = code.masked, code.terms, code.inside.operations, code.inside.outputs
        yield f"{CHECK}{code.name}", made
    for stage, suffix in zip(code.stages, list_suffixes(code), strict=True):
        if stage.prepares:
            yield f"_prepare{suffix}", (stage.parameters, stage.prepare)
        if stage.evaluate and not code.indexed:
            yield f"_form{suffix}", (bool(code.shape), stage.evaluate)
