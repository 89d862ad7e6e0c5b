"""Texts of scalar kernels: in, kernels that compute one point; out, their texts for backends."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import prod

from mechproof.codegen.c_names import STORED
from mechproof.codegen.languages import EXACT
from mechproof.codegen.syntax import ProgramText, Syntax, write_program
from mechproof.programs.elementary.fits import enclose
from mechproof.programs.elementary.formats import Format
from mechproof.programs.elementary.function_programs import Function, build
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import COMPARISONS
from mechproof.programs.program import NOTHING, Program, Stage
from mechproof.programs.scalar import (
    ScalarArgument,
    TermLoop,
    join_stage,
    list_arguments,
    list_stages,
    name_domain,
)
from mechproof.record import OnePass

BOOLEAN = frozenset({*COMPARISONS, "both", "either", "is_finite"})


@dataclass(frozen=True)
class ScalarStage:
    """The texts of a form: when it is taken, what is prepared once, and what is run for each point.

    `whole` does both at once, from the inputs `needed`.
    """

    name: str
    when: str
    parameters: tuple[str, ...]
    prepare: ProgramText
    evaluate: ProgramText
    inputs: tuple[str, ...]
    running: tuple[str, ...]
    booleans: frozenset[str]
    needed: tuple[str, ...]
    whole: ProgramText


@dataclass(frozen=True)
class LoopCall:
    """The call of a loop over terms, of one or two axes, whose value a kernel takes."""

    name: str
    arguments: tuple[str, ...]
    axes: int
    boolean: bool
    limited: bool


@dataclass(frozen=True)
class ScalarKernel:
    """The texts of a kernel; `checked` are the components that its domain restricts.

    `members` are kernels that this one calls, each for one of its results; `loops` are the loops
    over terms whose values it takes.
    """

    name: str
    summary: str
    arguments: tuple[ScalarArgument, ...]
    inside: str
    checked: frozenset[str]
    stages: tuple[ScalarStage, ...]
    shape: tuple[int, ...]
    limited: bool
    unit: str
    members: tuple[ScalarKernel, ...] = ()
    loops: tuple[LoopCall, ...] = ()

    @property
    def outs(self) -> tuple[str, ...]:
        """Return the names of the arrays in which results are stored."""
        return tuple(f"{STORED}{m.name}" for m in self.members) or ("out",)

    @property
    def units(self) -> tuple[str, ...]:
        """Return the unit of each result."""
        return tuple(m.unit for m in self.members) or (self.unit,)

    @property
    def count(self) -> int:
        """Return the number of components of a result; 1 for a plain number."""
        return prod(self.shape)

    @property
    def width(self) -> int:
        """Return the number of components of a result; 0 for a plain number, which is no array."""
        return self.count if self.shape else 0

    @property
    def is_plain(self) -> bool:
        """Return whether the kernel computes one number from plain numbers."""
        vectors = any(argument.width for argument in self.arguments)
        return not (self.sums or self.shape or self.members or vectors)

    @property
    def sums(self) -> bool:
        """Return whether any argument has axes that are summed over."""
        return any(a.axes for a in self.arguments)

    @property
    def depends(self) -> bool:
        """Return whether the domain also restricts the point, the first argument."""
        return not self.checked.isdisjoint(self.arguments[0].components)

    @property
    def taken(self) -> frozenset[str]:
        """Return the components that a value or the domain depends on."""
        used = {n for stage in self.stages for n in (*stage.running, *stage.parameters)}
        used |= {n for member in self.members for n in member.taken}
        return frozenset(used) | {n for n in self.names if n in self.checked}

    @property
    def numbers(self) -> tuple[str, ...]:
        """Return the components of arguments without axes that are summed over."""
        return tuple(n for a in self.arguments if not a.axes for n in a.components)

    @property
    def taken_names(self) -> tuple[str, ...]:
        """Return the names of the inputs of a value: numbers, then loops."""
        return (*self.numbers, *(called.name for called in self.loops))

    @property
    def names(self) -> tuple[str, ...]:
        """Return the components of all arguments."""
        return tuple(n for a in self.arguments for n in a.components)

    @property
    def targets(self) -> tuple[str, ...]:
        """Return the names of the arrays that the loop in a compiled module fills."""
        return tuple(f"_out_of_{m.name}" for m in self.members) or ("_out",)

    def index(self, pattern: str) -> tuple[str, ...]:
        """Return the text of each component: plain numbers' names, vectors' places by a pattern."""
        return tuple(
            argument.name + (pattern.format(place) if argument.width else "")
            for argument in self.arguments
            for place in range(len(argument.components))
        )

    @property
    def sizes(self) -> tuple[str, ...]:
        """Return texts for the number of elements of each component in a set of terms."""
        return tuple(
            " * ".join(["_terms"] * a.axes) or "1" for a in self.arguments for _ in a.components
        )


@dataclass(frozen=True)
class FunctionText:
    """The texts of an elementary function; `far` is its value beyond the format's `largest`."""

    kind: str
    meaning: str
    inputs: tuple[str, ...]
    text: ProgramText
    far: ProgramText | None
    booleans: frozenset[str]
    bounds: tuple[tuple[str, float], ...]


def write_scalar(kernel: Kernel, syntax: Syntax, loops: tuple[LoopCall, ...] = ()) -> ScalarKernel:
    """Return the texts of a kernel in a language; `loops` are those whose values it takes."""
    code = kernel.code
    arguments = list_arguments(kernel)
    inside = name_domain(kernel) or NOTHING
    used = {o for step in inside.operations for o in step.operands}
    return ScalarKernel(
        kernel.name,
        kernel.quantity.summary,
        tuple(
            replace(a, name=syntax.name(a.name), components=_spell(a.components, syntax))
            for a in arguments
        ),
        "".join(write_program(inside, syntax).outputs),
        frozenset(syntax.name(n) for a in arguments for n in a.components if n in used),
        tuple(_write_stage(name, stage, syntax) for name, stage in list_stages(kernel)),
        code.shape,
        any(is_limited(p, syntax) for s in code.stages for p in s.programs),
        kernel.quantity.unit,
        loops=loops,
    )


def _spell(names: Iterable[str], syntax: Syntax) -> tuple[str, ...]:
    return tuple(map(syntax.name, names))


def join_scalars(together: OnePass, kernels: Sequence[ScalarKernel]) -> ScalarKernel:
    """Return the texts of a kernel that computes several in one pass.

    Raises NotImplementedError for kernels with sums or with results that have components.
    """
    named = {kernel.name: kernel for kernel in kernels}
    members = tuple(named[name] for name in together.quantities)
    if wrong := [member.name for member in members if member.shape or member.sums]:
        raise NotImplementedError(f"{together.name}: {wrong} are not computed in one pass")
    *first, last = together.quantities
    return replace(
        members[0],
        name=together.name,
        summary=f"Compute {', '.join(first)} and {last} in one pass.",
        inside="",
        checked=frozenset(),
        stages=(),
        limited=any(member.limited for member in members),
        members=members,
    )


def _write_stage(name: str, stage: Stage, syntax: Syntax) -> ScalarStage:
    assert stage.evaluate is not None
    when = write_program(stage.when, syntax).outputs[0] if stage.when else ""
    return ScalarStage(
        name,
        when,
        _spell(stage.parameters, syntax),
        write_program(stage.prepare, syntax),
        write_program(stage.evaluate, syntax),
        _spell(stage.evaluate.inputs, syntax),
        _spell(stage.running, syntax),
        list_booleans(stage.prepare, syntax) | list_booleans(stage.evaluate, syntax),
        _spell((*stage.running, *stage.parameters), syntax),
        write_program(join_stage(stage), syntax),
    )


def list_booleans(program: Program, syntax: Syntax) -> frozenset[str]:
    """Return the names of results that are true or false."""
    return frozenset(
        syntax.name(step.result) for step in program.operations if step.kind in BOOLEAN
    )


def is_limited(program: Program, syntax: Syntax) -> bool:
    """Return whether a program calls functions that are valid only up to the largest angle."""
    return any(syntax.last.get(step.kind) == EXACT for step in program.operations)


def extend_syntax(
    syntax: Syntax, reductions: Iterable[TermLoop], prefix: str, count: str = ""
) -> Syntax:
    """Return a language with calls of the loops over terms; `count` is an extra last argument."""
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
    """The texts of a loop over terms."""

    loop: TermLoop
    text: ProgramText
    booleans: frozenset[str]
    limited: bool


def write_reduction(found: TermLoop, syntax: Syntax) -> ReductionText:
    """Return the texts of a loop over terms in a language."""
    spelled = replace(
        found,
        parameters=_spell(found.parameters, syntax),
        arrays=_spell(found.arrays, syntax),
        elements=tuple((syntax.name(name), indices) for name, indices in found.elements),
        term=replace(found.term, inputs=_spell(found.term.inputs, syntax)),
    )
    return ReductionText(
        spelled,
        write_program(found.term, syntax),
        list_booleans(found.term, syntax),
        is_limited(found.term, syntax),
    )


def write_elementary(kind: str, form: Format, syntax: Syntax, far: Syntax) -> FunctionText:
    """Return an elementary function's texts; `far` spells functions of the language's library."""
    function: Function = build(kind, form)
    return FunctionText(
        kind,
        function.meaning,
        _spell(function.program.inputs, syntax),
        write_program(function.parted, syntax),
        write_program(function.far, far) if function.far else None,
        list_booleans(function.program, syntax),
        tuple((t.meaning, enclose(t, fitted) / form.eps) for t, fitted in function.fits),
    )
