"""Code of a kernel: what a backend prints of it and what reading its source must give back."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace

from mechproof.programs.program import NOTHING, TEMPORARY, Operand, Operation, Program

# How functions of conditions are called.
CHECK = "_check_of_"


@dataclass(frozen=True)
class Stage:
    """One form in two programs: what the parameters alone decide, and the rest, point by point.

    `when` is the condition on the parameters under which the stage is taken. `prepare` takes the
    `parameters` and gives what `evaluate` takes after the `running` components. Of an affine stage
    `prepare` gives a matrix row by row, then a shift; there is nothing left to evaluate.
    """

    when: Program | None
    running: tuple[str, ...]
    parameters: tuple[str, ...]
    prepare: Program
    evaluate: Program | None

    @property
    def affine(self) -> bool:
        """Say whether the points are mapped by a matrix and a shift."""
        return self.evaluate is None

    @property
    def prepares(self) -> bool:
        """Say whether the parameters alone decide anything, but themselves."""
        return bool(self.prepare.operations) or self.prepare.outputs != self.parameters

    @property
    def programs(self) -> tuple[Program, ...]:
        """List what there is to compute."""
        return (self.prepare,) if self.evaluate is None else (self.prepare, self.evaluate)

    def change(self, change: Callable[[Program], Program]) -> Stage:
        """Return the stage with each of its programs changed, but for one that computes nothing."""
        prepare = self.prepare if self.prepare is NOTHING else change(self.prepare)
        evaluate = None if self.evaluate is None else change(self.evaluate)
        return replace(self, prepare=prepare, evaluate=evaluate)

    def spell_out(self) -> Stage:
        """Return the stage with a program in place of an affine map."""
        return replace(self, evaluate=self.evaluate or map_affinely(self.running))


@dataclass(frozen=True)
class KernelCode:
    """The computing parts of a kernel.

    `vectors` are arguments with components on their last axis, `indexed` those with axes that are
    summed over, with their number. `inside` says where the parameters are in the domain; outside
    the `masked` ones become NaN. `shape` is that of the result's last axes.
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
        """Count the last axes of each argument that do not broadcast; empty if all do."""
        counts = {name: 1 for name, _ in self.vectors} | dict(self.indexed)
        return tuple(counts.get(name, 0) for name in self.arguments) if counts else ()

    @property
    def terms(self) -> tuple[str, ...]:
        """List the arguments with terms of a sum that are asked whether they are inside."""
        steps = self.inside.operations if self.inside else ()
        asked = {operand for step in steps for operand in step.operands}
        return tuple(name for name, _ in self.indexed if name in asked)

    @property
    def names(self) -> frozenset[str]:
        """Return the names of arguments, of their components and of what is computed."""
        programs = [p for stage in self.stages for p in stage.programs]
        programs += [self.inside] if self.inside else []
        parts = [self.arguments, *(names for _, names in self.vectors)]
        parts += [program.inputs for program in programs]
        steps = (step.result for program in programs for step in program.operations)
        return frozenset(name for part in parts for name in part).union(steps)

    def count_operations(self) -> tuple[int, ...]:
        """Count the operations of each stage."""
        return tuple(sum(p.count_operations() for p in s.programs) for s in self.stages)


def map_affinely(point: tuple[str, ...]) -> Program:
    """Return the program of M @ p + v, M given row by row, then v."""
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
    """Return what each function is called: like the first of the module that does the same."""
    first: dict[object, str] = {}
    return {
        name: first.setdefault(made, name) for code in codes for name, made in _list_functions(code)
    }


def list_suffixes(code: KernelCode) -> list[str]:
    """List how the functions of stages end, the last one like the kernel."""
    others = [f"_{number}_of_{code.name}" for number in range(1, len(code.stages))]
    return [*others, f"_of_{code.name}"]


def _list_functions(code: KernelCode) -> Iterator[tuple[str, object]]:
    """List the functions of a kernel with all that their text is made of."""
    if code.inside:
        made = code.masked, code.terms, code.inside.operations, code.inside.outputs
        yield f"{CHECK}{code.name}", made
    for stage, suffix in zip(code.stages, list_suffixes(code), strict=True):
        if stage.prepares:
            yield f"_prepare{suffix}", (stage.parameters, stage.prepare)
        if stage.evaluate and not code.indexed:
            yield f"_form{suffix}", (bool(code.shape), stage.evaluate)
