"""One pass: in, kernels of the same arguments; out, one that computes shared values once.

C compilers do not find common subexpressions of functions that may call a library, so the programs
are joined. Every operation keeps its operands, and every result its bits.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import product

from mechproof.programs.evaluation import unused_name
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import (
    NOTHING,
    TEMPORARY,
    KernelCode,
    Operand,
    Operation,
    Program,
    Stage,
    is_unnamed,
)
from mechproof.programs.scalar import list_arguments, list_stages, name_domain

# Name of an unnamed value that several programs share.
SHARED = "shared"


def join_kernels(name: str, kernels: Sequence[Kernel]) -> Kernel:
    """Return the kernel with the outputs of several kernels, each of which returns one number.

    Raises NotImplementedError for kernels with different domains.
    """
    first = kernels[0]
    if wrong := list_unlike_domains(kernels):
        raise NotImplementedError(f"{name}: {wrong} have another domain than {first.name!r}")
    arguments = list_arguments(first)
    # Each kernel chooses its form independently, so any two forms may occur together.
    stages = product(*([stage for _, stage in list_stages(kernel)] for kernel in kernels))
    components = [argument.components for argument in arguments]
    code = KernelCode(
        name=name,
        arguments=first.code.arguments,
        vectors=tuple((a.name, a.components) for a in arguments if a.width),
        indexed=(),
        inside=name_domain(first),
        masked=first.code.masked,
        stages=tuple(_join_stages(several, components) for several in stages),
        shape=(),
        quiet=all(kernel.code.quiet for kernel in kernels),
    )
    return replace(first, name=name, code=code)


def list_unlike_domains(kernels: Sequence[Kernel]) -> list[str]:
    """List the names of kernels whose domain differs from that of the first."""
    first, *others = kernels
    return [kernel.name for kernel in others if name_domain(kernel) != name_domain(first)]


def _join_stages(stages: Sequence[Stage], components: Sequence[tuple[str, ...]]) -> Stage:
    """Join one stage of each kernel, taken where all of them are and no earlier combination is."""
    point, *sizes = components
    running = tuple(n for n in point if any(n in stage.running for stage in stages))
    names = [name for argument in sizes for name in argument]
    parameters = tuple(n for n in names if any(n in stage.parameters for stage in stages))
    before, after = _Values(parameters), _Values((*running, *parameters))
    prepared: dict[Operand, str] = {}
    outputs: list[Operand] = []
    for stage in stages:
        assert stage.evaluate is not None
        taken = stage.evaluate.inputs[len(stage.running) :]
        given: dict[Operand, Operand] = {}
        for value, input_name in zip(before.add(stage.prepare), taken, strict=True):
            if value not in prepared:
                prepared[value] = value if value in parameters else after.name(input_name)
            given[input_name] = prepared[value]
        outputs += after.add(stage.evaluate, given)
    return Stage(
        _join_conditions([stage.when for stage in stages if stage.when]),
        running,
        parameters,
        before.finish(parameters, prepared) if parameters else NOTHING,
        after.finish((*running, *prepared.values()), outputs),
    )


def _join_conditions(conditions: Sequence[Program]) -> Program | None:
    if not conditions:
        return None
    values = _Values(())
    (result, *others) = (o for condition in conditions for o in values.add(condition))
    for other in others:
        result = values.apply("both", (result, other), TEMPORARY)
    inputs = dict.fromkeys(name for condition in conditions for name in condition.inputs)
    return values.finish(tuple(inputs), [result])


class _Values:
    """Collects the operations of several programs, computing each value once."""

    def __init__(self, names: Iterable[str]) -> None:
        self._taken = set(names)
        self._made: dict[str, Operation] = {}
        self._called: dict[str, str] = {}

    def name(self, wanted: str) -> str:
        """Return a name that is not taken, and take it."""
        found = unused_name(wanted, self._taken)
        self._taken.add(found)
        return found

    def add(
        self, program: Program, given: Mapping[Operand, Operand] | None = None
    ) -> list[Operand]:
        """Add a program's new operations and return its outputs; `given` replaces its inputs."""
        values = dict(given or {})
        for step in program.operations:
            operands = tuple(values.get(o, o) for o in step.operands)
            values[step.result] = self.apply(step.kind, operands, step.result)
        return [values.get(output, output) for output in program.outputs]

    def apply(self, kind: str, operands: tuple[Operand, ...], wanted: str) -> Operand:
        """Return the result of an operation, named as wanted if it is new."""
        if kind == "copy":
            return operands[0]
        # As text, because 0 and -0 would be equal keys.
        key = repr((kind, operands))
        if key not in self._made:
            name = f"{TEMPORARY}{len(self._made)}" if is_unnamed(wanted) else self.name(wanted)
            self._made[key] = Operation(name, kind, operands)
        made = self._made[key].result
        if is_unnamed(made) and not is_unnamed(wanted):
            self._called.setdefault(made, wanted)
        return made

    def finish(self, inputs: tuple[str, ...], outputs: Iterable[Operand]) -> Program:
        """Return the program of all operations, naming results that are used more than once."""
        outputs = tuple(outputs)
        used = Counter(o for step in self._made.values() for o in step.operands) + Counter(outputs)
        names: dict[Operand, str] = {
            step.result: self.name(self._called.get(step.result, SHARED))
            for step in self._made.values()
            if is_unnamed(step.result) and used[step.result] > 1
        }
        return Program(inputs, tuple(self._made.values()), outputs).rename(names).normal_form()
