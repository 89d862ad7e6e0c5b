"""Sums over axes of any length: in, kernels; out, the same with calls of loops over their terms.

What a loop adds, or finds true of every element, is a program of one element of each array.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from mechproof.programs.code import KernelCode
from mechproof.programs.evaluation import unused_name
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import KINDS, REDUCTIONS, VIEWS
from mechproof.programs.program import (
    TEMPORARY,
    Operand,
    Operation,
    Program,
    spell_out_forms,
)

LOOPS = "ij"
# The operations that a printed sum is made of.
ADDED = "total_rest"


@dataclass(frozen=True)
class TermLoop:
    """A loop over one axis or two: the sum of a term, or whether it is true of every element.

    `elements` are what the term takes: a parameter and the indices of its element, none if the
    parameter is a number. `arrays` are the parameters with axes.
    """

    name: str
    kind: str
    axes: int
    parameters: tuple[str, ...]
    arrays: tuple[str, ...]
    elements: tuple[tuple[str, tuple[int, ...]], ...]
    term: Program


def fold_sums(kernels: Iterable[Kernel]) -> tuple[tuple[Kernel, ...], tuple[TermLoop, ...]]:
    """Return kernels that call loops over terms, and the loops, each once.

    Raises NotImplementedError for sums in the terms of sums.
    """
    kernels = tuple(kernels)
    folder = _Folder({name for kernel in kernels for name in kernel.code.names})
    folded = tuple(map(folder.fold, kernels))
    return folded, tuple(folder.reductions)


class _Folder:
    def __init__(self, taken: set[str]) -> None:
        self.reductions: list[TermLoop] = []
        self._taken = taken

    def fold(self, kernel: Kernel) -> Kernel:
        if not kernel.code.indexed:
            return kernel
        return replace(kernel, code=self._fold_code(kernel.code))

    def _fold_code(self, code: KernelCode) -> KernelCode:
        axes = dict(code.indexed)
        stages = []
        for stage in code.stages:
            assert stage.evaluate is not None
            folded = self._fold_program(stage.evaluate, axes)
            used = {operand for step in folded.operations for operand in step.operands}
            running = tuple(n for n in stage.running if n in used)
            stages.append(replace(stage, running=running, evaluate=replace(folded, inputs=running)))
        inside = self._fold_program(code.inside, axes) if code.inside else None
        return replace(code, inside=inside, stages=tuple(stages))

    def _fold_program(self, given: Program, axes: Mapping[str, int]) -> Program:
        """Replace the operations on elements by calls."""
        program = spell_out_forms(given)
        spread: set[Operand] = set(axes)
        kept: list[Operation] = []
        for step in program.operations:
            if step.kind in REDUCTIONS:
                kept.append(self._call(step, _Term(program, axes, spread)))
            elif spread.intersection(step.operands):
                spread.add(step.result)
            else:
                kept.append(step)
        return replace(program, operations=tuple(kept)).normal_form()

    def _call(self, step: Operation, term: _Term) -> Operation:
        value, count = step.operands
        result = term.take(value)
        used = tuple(dict.fromkeys(name for name, _ in term.elements))
        found = TermLoop(
            "",
            step.kind,
            int(count),
            used,
            tuple(n for n in used if n in term.axes),
            tuple(term.elements),
            Program(tuple(term.elements.values()), tuple(term.operations), (result,)).normal_form(),
        )
        return Operation(step.result, self._name(found), used)

    def _name(self, found: TermLoop) -> str:
        for known in self.reductions:
            if replace(known, name="") == found:
                return known.name
        name = unused_name(f"{found.kind}_{len(self.reductions) + 1}", self._taken)
        self.reductions.append(replace(found, name=name))
        return name


class _Term:
    """Collects what one term is computed of."""

    def __init__(self, program: Program, axes: Mapping[str, int], spread: set[Operand]) -> None:
        self.axes = axes
        self.elements: dict[tuple[str, tuple[int, ...]], str] = {}
        self.operations: list[Operation] = []
        self._made = {step.result: step for step in program.operations}
        self._spread = spread
        self._taken = set(program.inputs) | set(self._made)
        self._known: set[str] = set()

    def take(self, operand: Operand, view: str = "") -> Operand:
        """Add the operations of an operand, seen by a view; return its name in the term."""
        if not isinstance(operand, str) or operand.startswith("#"):
            return operand
        step = self._made.get(operand)
        if step is None:
            count = self.axes.get(operand, 0)
            seen = KINDS[view].indices if view and count else tuple(range(count))
            return self._element(operand, seen)
        if step.kind in VIEWS:
            # What is transposed has the diagonal that it had.
            return self.take(step.operands[0], view if view == "diagonal" else step.kind)
        if operand not in self._spread and not operand.startswith(TEMPORARY):
            return self._element(operand, ())
        if step.kind in REDUCTIONS:
            raise NotImplementedError(f"no operation for a sum in the terms of a sum: {step}")
        result = operand + view
        if result not in self._known:
            self._known.add(result)
            operands = tuple(self.take(used, view) for used in step.operands)
            self.operations.append(replace(step, result=result, operands=operands))
        return result

    def _element(self, name: str, indices: tuple[int, ...]) -> str:
        key = name, indices
        if key not in self.elements:
            suggestion = f"{name}_{''.join(LOOPS[i] for i in indices)}" if indices else name
            taken = self._taken if indices else set[str]()
            self.elements[key] = unused_name(suggestion, taken | set(self.elements.values()))
        return self.elements[key]
