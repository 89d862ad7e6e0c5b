"""Scalar kernels: in, a paper; out, what backends print that compute one point at a time.

The programs are those of the NumPy kernels with divisions put off; an affine stage becomes fused
products, and the elementary functions that occur are programs of plain arithmetic themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from mechproof.codegen.backends.quotients import put_off_divisions
from mechproof.codegen.backends.sums import ADDED, Reduction
from mechproof.codegen.code import KernelCode, Stage
from mechproof.codegen.elementary.fits import enclose
from mechproof.codegen.elementary.formats import Format
from mechproof.codegen.elementary.functions import BODIES, Function, build
from mechproof.codegen.kernel import Kernel, list_functions
from mechproof.codegen.program import NOTHING, TEMPORARY, Operand, Operation, Program
from mechproof.codegen.reading import EXACT
from mechproof.codegen.syntax import COMPARISONS, Syntax, Text, write_program
from mechproof.record import Paper, Together

BOOLEAN = frozenset({*COMPARISONS, "both", "either", "is_finite"})


@dataclass(frozen=True)
class ScalarStage:
    """A form: when it is taken, what is prepared once and what is evaluated for each point."""

    name: str
    when: str
    parameters: tuple[str, ...]
    prepare: Text
    evaluate: Text
    inputs: tuple[str, ...]
    running: tuple[str, ...]
    booleans: frozenset[str]


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


@dataclass(frozen=True)
class ScalarKernel:
    """What is printed of a kernel; `checked` are the components that the domain is about.

    `members` are kernels that this one calls, each for a result of its own.
    """

    name: str
    summary: str
    arguments: tuple[ScalarArgument, ...]
    inside: str
    checked: frozenset[str]
    stages: tuple[ScalarStage, ...]
    shape: tuple[int, ...]
    limited: bool
    members: tuple[ScalarKernel, ...] = ()

    @property
    def outs(self) -> tuple[str, ...]:
        """Return the names of the arrays that results are stored in."""
        return tuple(f"out_{m.name}" for m in self.members) or ("out",)

    @property
    def count(self) -> int:
        """Return how many numbers a result has."""
        count = 1
        for length in self.shape:
            count *= length
        return count

    @property
    def sums(self) -> bool:
        """Say whether arguments have axes that are summed over."""
        return any(a.axes for a in self.arguments)

    @property
    def depends(self) -> bool:
        """Say whether the domain depends on the point, too."""
        return not self.checked.isdisjoint(self.arguments[0].components)

    @property
    def taken(self) -> frozenset[str]:
        """Return the components that a value or the domain depends on."""
        used = {n for stage in self.stages for n in (*stage.running, *stage.parameters)}
        used |= {n for member in self.members for n in member.taken}
        return frozenset(used) | {n for n in self.names if n in self.checked}

    @property
    def taken_names(self) -> tuple[str, ...]:
        """Return the components that a value or the domain depends on, in their order."""
        return tuple(name for name in self.names if name in self.taken)

    @property
    def names(self) -> tuple[str, ...]:
        """Return the components of all arguments."""
        return tuple(n for a in self.arguments for n in a.components)


@dataclass(frozen=True)
class FunctionText:
    """What is printed of an elementary function; `far` is its value beyond `largest`."""

    kind: str
    meaning: str
    inputs: tuple[str, ...]
    text: Text
    far: Text | None
    booleans: frozenset[str]
    bounds: tuple[tuple[str, float], ...]


def list_scalars(paper: Paper) -> tuple[Kernel, ...]:
    """List the shipped kernels with programs that put divisions off."""
    return tuple(_adapt(k) for k in list_functions(paper) if k.is_shipped)


def _adapt(kernel: Kernel) -> Kernel:
    stages = tuple(map(put_off_stage, kernel.code.stages))
    return replace(kernel, code=replace(kernel.code, stages=stages))


def put_off_stage(stage: Stage) -> Stage:
    """Return a stage with programs that put divisions off."""
    return replace(
        stage,
        prepare=put_off_divisions(stage.prepare),
        evaluate=put_off_divisions(stage.evaluate) if stage.evaluate else None,
    )


def write_scalar(kernel: Kernel, syntax: Syntax) -> ScalarKernel:
    """Write the texts of a kernel in a language."""
    code = kernel.code
    arguments = _list_arguments(kernel)
    renamed = _rename_components(code, arguments)
    inside = _rename(code.inside, renamed) if code.inside else NOTHING
    used = {o for step in inside.operations for o in step.operands}
    return ScalarKernel(
        kernel.name,
        kernel.quantity.summary,
        arguments,
        "".join(write_program(inside, syntax).outputs),
        frozenset(n for a in arguments for n in a.components if n in used),
        tuple(_write_stage(name, stage, syntax) for name, stage in list_stages(kernel)),
        code.shape,
        any(is_limited(p, syntax) for s in code.stages for p in s.programs),
    )


def join_scalars(together: Together, kernels: Sequence[ScalarKernel]) -> ScalarKernel:
    """Return the kernel that computes several in one pass.

    Raises NotImplementedError for sums and for results with components.
    """
    named = {kernel.name: kernel for kernel in kernels}
    members = tuple(named[name] for name in together.quantities)
    if wrong := [member.name for member in members if member.shape or member.sums]:
        raise NotImplementedError(f"{together.name}: {wrong} are not computed in one pass")
    return replace(
        members[0],
        name=together.name,
        summary=f"Compute {_list_words(together.quantities)} in one pass.",
        inside="",
        checked=frozenset(),
        stages=(),
        limited=any(member.limited for member in members),
        members=members,
    )


def _list_words(names: Sequence[str]) -> str:
    return f"{', '.join(names[:-1])} and {names[-1]}"


def _write_stage(name: str, stage: Stage, syntax: Syntax) -> ScalarStage:
    assert stage.evaluate is not None
    when = write_program(stage.when, syntax).outputs[0] if stage.when else ""
    return ScalarStage(
        name,
        when,
        stage.parameters,
        write_program(stage.prepare, syntax),
        write_program(stage.evaluate, syntax),
        stage.evaluate.inputs,
        stage.running,
        list_booleans(stage.prepare) | list_booleans(stage.evaluate),
    )


def list_booleans(program: Program) -> frozenset[str]:
    """List the results that are true or false."""
    return frozenset(step.result for step in program.operations if step.kind in BOOLEAN)


def is_limited(program: Program, syntax: Syntax) -> bool:
    """Say whether a program takes functions that are right up to the largest angle only."""
    return any(syntax.last.get(step.kind) == EXACT for step in program.operations)


def _list_arguments(kernel: Kernel) -> tuple[ScalarArgument, ...]:
    widths = {name: len(components) for name, components in kernel.code.vectors}
    axes = dict(kernel.code.indexed)
    return tuple(
        ScalarArgument(
            a.name,
            tuple(f"{a.name}_{i}" for i in range(widths[a.name]))
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


def _rename_components(
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


def _rename(program: Program, names: Mapping[Operand, str]) -> Program:
    return Program(
        tuple(names.get(n, n) for n in program.inputs),
        tuple(
            replace(step, operands=tuple(names.get(o, o) for o in step.operands))
            for step in program.operations
        ),
        tuple(names.get(o, o) for o in program.outputs),
    )


def list_stages(kernel: Kernel) -> list[tuple[str, Stage]]:
    """List the stages of a kernel by the names of their functions, all components named."""
    renamed = _rename_components(kernel.code, _list_arguments(kernel))
    return [_scalar_stage(kernel, number, renamed) for number in range(len(kernel.code.stages))]


def list_conditions(kernel: Kernel) -> list[Program]:
    """List what is asked before a point is computed: the domain, then when each form is taken."""
    renamed = _rename_components(kernel.code, _list_arguments(kernel))
    inside = [_rename(kernel.code.inside, renamed)] if kernel.code.inside else []
    return inside + [stage.when for _, stage in list_stages(kernel) if stage.when]


def _scalar_stage(kernel: Kernel, number: int, names: Mapping[Operand, str]) -> tuple[str, Stage]:
    stage = kernel.code.stages[number]
    last = number == len(kernel.code.stages) - 1
    name = f"_{kernel.name}" if last else f"_{kernel.name}_{number + 1}"
    running = tuple(names.get(n, n) for n in stage.running)
    scalar = Stage(
        _rename(stage.when, names) if stage.when else None,
        running,
        tuple(names.get(n, n) for n in stage.parameters),
        _rename(stage.prepare, names) if stage.prepare is not NOTHING else NOTHING,
        _rename(stage.evaluate, names) if stage.evaluate else map_affinely(running),
    )
    return name, scalar


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


def list_elementary(kernels: Iterable[Kernel], reductions: Iterable[Reduction]) -> tuple[str, ...]:
    """List the elementary functions that kernels take, in the order of their table."""
    programs = [p for kernel in kernels for stage in kernel.code.stages for p in stage.programs]
    used = {ADDED for reduction in reductions if reduction.kind == "sum"}
    used |= {step.kind for p in programs for step in p.operations}
    used |= {step.kind for reduction in reductions for step in reduction.term.operations}
    return tuple(kind for kind in BODIES if kind in used)


def extend_syntax(
    syntax: Syntax, reductions: Iterable[Reduction], prefix: str, count: str = ""
) -> Syntax:
    """Return a language with the loops over terms; `count` is put after their arguments."""
    for found in reductions:
        last = count or (EXACT if is_limited(found.term, syntax) else "")
        syntax = replace(
            syntax,
            calls={**syntax.calls, found.name: f"{prefix}{found.name}"},
            last={**syntax.last, found.name: last} if last else syntax.last,
        )
    return syntax


@dataclass(frozen=True)
class ReductionText:
    """What is printed of a loop over terms."""

    loop: Reduction
    text: Text
    booleans: frozenset[str]
    limited: bool


def write_reduction(found: Reduction, syntax: Syntax) -> ReductionText:
    """Write the text of a term."""
    return ReductionText(
        found,
        write_program(found.term, syntax),
        list_booleans(found.term),
        is_limited(found.term, syntax),
    )


def write_elementary(kind: str, form: Format, syntax: Syntax, far: Syntax) -> FunctionText:
    """Write an elementary function; `far` spells the functions of the language's own library."""
    function: Function = build(kind, form)
    return FunctionText(
        kind,
        function.meaning,
        function.program.inputs,
        write_program(function.program, syntax),
        write_program(function.far, far) if function.far else None,
        list_booleans(function.program),
        tuple((t.meaning, enclose(t, fitted) / form.eps) for t, fitted in function.fits),
    )
