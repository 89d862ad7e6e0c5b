"""Scalar kernels: in, a paper; out, programs that compute one point at a time.

The programs are those of the NumPy kernels with divisions put off; an affine stage becomes fused
products, and the elementary functions that occur are programs of plain arithmetic themselves.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from mechproof.programs.code import KernelCode, Stage
from mechproof.programs.deferred_divisions import defer_divisions
from mechproof.programs.evaluation import unused_name
from mechproof.programs.kernel import Kernel, list_functions
from mechproof.programs.program import Operand, Program, is_unnamed
from mechproof.record import Paper


@dataclass(frozen=True)
class ScalarArgument:
    """An argument by the names of its components; `width` is 0 if it is no vector.

    `axes` are those that are summed over.
    """

    name: str
    components: tuple[str, ...]
    width: int
    axes: int
    default: float | None
    meaning: str
    unit: str


def list_scalars(paper: Paper) -> tuple[Kernel, ...]:
    """List the shipped kernels with programs that put divisions off."""
    return tuple(put_off_divisions(k) for k in list_functions(paper) if k.is_shipped)


def put_off_divisions(kernel: Kernel) -> Kernel:
    """Return a kernel with programs that compute one point at a time."""
    stages = tuple(stage.change(defer_divisions) for stage in kernel.code.stages)
    adapted = replace(kernel, code=replace(kernel.code, stages=stages))
    components = {c for a in list_arguments(kernel) if a.width for c in a.components}
    return _rename_steps(adapted, components)


def _rename_steps(kernel: Kernel, taken: Collection[str]) -> Kernel:
    """Give steps that are called like a component another name."""
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
    """Name the components of vectors after their argument: a symbol may be one of a step, too."""
    parts = {a.name: a.components for a in arguments}
    return {
        old: new
        for name, components in code.vectors
        for old, new in zip(components, parts[name], strict=True)
        if old != "_"
    }


def name_domain(kernel: Kernel) -> Program | None:
    """Return the program that says where the domain is, components named; None for all."""
    inside = kernel.code.inside
    return inside and inside.rename(rename_components(kernel.code, list_arguments(kernel)))


def list_stages(kernel: Kernel) -> list[tuple[str, Stage]]:
    """List the stages of a kernel by how the names of their functions end, components named."""
    renamed = rename_components(kernel.code, list_arguments(kernel))
    return [_scalar_stage(kernel, number, renamed) for number in range(len(kernel.code.stages))]


def list_conditions(kernel: Kernel) -> list[Program]:
    """List what is asked before a point is computed: the domain, then when each form is taken."""
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
    """Return one program of what a stage prepares and then evaluates."""
    assert stage.evaluate is not None
    inputs = (*stage.running, *stage.parameters)
    before, after = stage.prepare, stage.evaluate
    taken = {*inputs, *(str(step.result) for step in before.operations)}
    names: dict[Operand, Operand] = {}
    given: dict[Operand, Operand] = {}
    for name, value in zip(after.inputs[len(stage.running) :], before.outputs, strict=True):
        # What has no name is used once; what is prepared may be used often.
        if is_unnamed(value) and value not in names:
            names[value] = unused_name(name, taken)
            taken.add(str(names[value]))
        given[name] = names.get(value, value)
    for step in after.operations:
        given[step.result] = unused_name(step.result, taken)
    before, after = before.rename(names), after.rename(given)
    return Program(inputs, before.operations + after.operations, after.outputs).normal_form()
