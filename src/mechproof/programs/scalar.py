"""Scalar kernels: in, a paper; out, programs that compute one point at a time.

The programs are those of the NumPy kernels with deferred divisions; in an affine stage products are
fused with sums, and the elementary functions that occur are themselves programs of plain
arithmetic. Sums over axes of any length become calls of loops over their terms; the term that a
loop adds up, or tests for every element, is a program of one element of each array.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace

from mechproof.programs.deferred_divisions import defer_divisions
from mechproof.programs.evaluation import unused_name
from mechproof.programs.fused_products import fuse_products
from mechproof.programs.kernel import Kernel, list_functions
from mechproof.programs.operations import KINDS, REDUCTIONS, VIEWS
from mechproof.programs.program import (
    TEMPORARY,
    KernelCode,
    Operand,
    Operation,
    Program,
    Stage,
    is_unnamed,
    spell_out_forms,
)
from mechproof.record import Paper

LOOPS = "ij"
# The kind of operation that computes the rests of additions in a printed sum.
ADDED = "total_rest"


@dataclass(frozen=True)
class TermLoop:
    """A loop over one or two axes: the sum of a term, or whether it is true for every element.

    `elements` are the inputs of the term: a parameter with the indices of its element, none if the
    parameter is a number. `arrays` are the parameters that have axes.
    """

    name: str
    kind: str
    axes: int
    parameters: tuple[str, ...]
    arrays: tuple[str, ...]
    elements: tuple[tuple[str, tuple[int, ...]], ...]
    term: Program


def fold_sums(kernels: Iterable[Kernel]) -> tuple[tuple[Kernel, ...], tuple[TermLoop, ...]]:
    """Return the kernels with calls of loops in place of sums, and the loops, each once.

    Raises NotImplementedError for a sum within the terms of a sum.
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
        """Return the program with operations on elements of arrays replaced by calls of loops."""
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
    """Collects the operations that compute one term of a sum."""

    def __init__(self, program: Program, axes: Mapping[str, int], spread: set[Operand]) -> None:
        self.axes = axes
        self.elements: dict[tuple[str, tuple[int, ...]], str] = {}
        self.operations: list[Operation] = []
        self._made = {step.result: step for step in program.operations}
        self._spread = spread
        self._taken = set(program.inputs) | set(self._made)
        self._known: set[str] = set()

    def take(self, operand: Operand, view: str = "") -> Operand:
        """Add the operations of an operand as seen through a view; return its name in the term."""
        if not isinstance(operand, str) or operand.startswith("#"):
            return operand
        step = self._made.get(operand)
        if step is None:
            count = self.axes.get(operand, 0)
            seen = KINDS[view].indices if view and count else tuple(range(count))
            return self._element(operand, seen)
        if step.kind in VIEWS:
            # A transposed matrix has the same diagonal.
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


@dataclass(frozen=True)
class ScalarArgument:
    """An argument with the names of its components; `width` is 0 if it is no vector.

    `axes` is the number of its axes that are summed over.
    """

    name: str
    components: tuple[str, ...]
    width: int
    axes: int
    default: float | None
    meaning: str
    unit: str


def list_scalars(paper: Paper) -> tuple[Kernel, ...]:
    """List the shipped kernels of a paper, with programs that defer divisions."""
    return tuple(put_off_divisions(k) for k in list_functions(paper) if k.is_shipped)


def adapt_stage(stage: Stage) -> Stage:
    """Return a stage with deferred divisions and, if it is affine, with fused products."""
    deferred = stage.change(defer_divisions)
    return deferred.change(fuse_products) if stage.affine else deferred


def put_off_divisions(kernel: Kernel) -> Kernel:
    """Return a kernel with deferred divisions, for loops that compute one point at a time."""
    stages = tuple(map(adapt_stage, kernel.code.stages))
    adapted = replace(kernel, code=replace(kernel.code, stages=stages))
    components = {c for a in list_arguments(kernel) if a.width for c in a.components}
    return _rename_steps(adapted, components)


def _rename_steps(kernel: Kernel, taken: Collection[str]) -> Kernel:
    """Return the kernel with steps renamed that share a name with a component in `taken`."""
    made = {s.result for stage in kernel.code.stages for p in stage.programs for s in p.operations}
    known = kernel.code.names.union(taken)
    names: dict[Operand, str] = {n: unused_name(n, known) for n in sorted(made.intersection(taken))}
    if not names:
        return kernel
    stages = tuple(stage.change(lambda p: p.rename(names)) for stage in kernel.code.stages)
    return replace(kernel, code=replace(kernel.code, stages=stages))


def list_arguments(kernel: Kernel) -> tuple[ScalarArgument, ...]:
    """List the arguments of a kernel with the names of their components."""
    widths = {name: len(components) for name, components in kernel.code.vectors}
    taken = kernel.code.arguments
    axes = dict(kernel.code.indexed)
    return tuple(
        ScalarArgument(
            a.name,
            tuple(unused_name(f"{a.name}_{i}", taken) for i in range(widths[a.name]))
            if a.name in widths
            else (a.name,),
            widths.get(a.name, 0),
            axes.get(a.name, 0),
            a.default,
            a.meaning,
            a.unit,
        )
        for a in kernel.quantity.arguments
    )


def rename_components(
    code: KernelCode, arguments: tuple[ScalarArgument, ...]
) -> Mapping[Operand, str]:
    """Return names for vectors' components after their argument: steps may have the old names."""
    parts = {a.name: a.components for a in arguments}
    return {
        old: new
        for name, components in code.vectors
        for old, new in zip(components, parts[name], strict=True)
        if old != "_"
    }


def name_domain(kernel: Kernel) -> Program | None:
    """Return the program that tests the domain, with components renamed; None if all is inside."""
    inside = kernel.code.inside
    return inside and inside.rename(rename_components(kernel.code, list_arguments(kernel)))


def list_stages(kernel: Kernel) -> list[tuple[str, Stage]]:
    """List the stages with renamed components, each with the suffix of its functions' names."""
    renamed = rename_components(kernel.code, list_arguments(kernel))
    return [_scalar_stage(kernel, number, renamed) for number in range(len(kernel.code.stages))]


def list_conditions(kernel: Kernel) -> list[Program]:
    """List the conditions tested before a point is computed: the domain, then each form's own."""
    asked = name_domain(kernel), *(stage.when for _, stage in list_stages(kernel))
    return [program for program in asked if program]


def _scalar_stage(kernel: Kernel, number: int, names: Mapping[Operand, str]) -> tuple[str, Stage]:
    stage = kernel.code.stages[number].spell_out().change(lambda p: p.rename(names))
    last = number == len(kernel.code.stages) - 1
    name = f"_of_{kernel.name}" if last else f"_{number + 1}_of_{kernel.name}"
    return name, replace(
        stage,
        when=stage.when and stage.when.rename(names),
        running=tuple(names.get(n, n) for n in stage.running),
        parameters=tuple(names.get(n, n) for n in stage.parameters),
    )


def join_stage(stage: Stage) -> Program:
    """Return one program that prepares and then evaluates a stage."""
    assert stage.evaluate is not None
    inputs = (*stage.running, *stage.parameters)
    before, after = stage.prepare, stage.evaluate
    taken = {*inputs, *(str(step.result) for step in before.operations)}
    names: dict[Operand, Operand] = {}
    given: dict[Operand, Operand] = {}
    for name, value in zip(after.inputs[len(stage.running) :], before.outputs, strict=True):
        # A result without a name may be used only once, but a prepared value may be used often.
        if is_unnamed(value) and value not in names:
            names[value] = unused_name(name, taken)
            taken.add(str(names[value]))
        given[name] = names.get(value, value)
    for step in after.operations:
        given[step.result] = unused_name(step.result, taken)
    before, after = before.rename(names), after.rename(given)
    return Program(inputs, before.operations + after.operations, after.outputs).normal_form()
