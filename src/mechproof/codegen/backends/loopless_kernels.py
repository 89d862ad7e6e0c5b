"""Kernels without their loops over terms: in, folded kernels; out, kernels of the loops' results.

So the loops of many sets of terms can run side by side. A thousand or more sets then take between a
half and a tenth of the time that they take one after another, least if they have few terms; nothing
is gained for up to ten sets, or for two axes of forty terms that differ from set to set.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

from mechproof.codegen.backends.scalar_texts import LoopCall
from mechproof.codegen.languages import EXACT
from mechproof.codegen.syntax import Syntax
from mechproof.programs.evaluation import unused_name
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import Operand, Operation, Program, Stage
from mechproof.programs.scalar import LOOPS, TermLoop, list_arguments, rename_components

# Name of the argument for the set that a term is in; indices of the term follow it.
AT = "_at"


def take_out_loops(kernel: Kernel, names: Collection[str]) -> tuple[Kernel, tuple[Operation, ...]]:
    """Return a kernel that takes the named loops' results as inputs, and the calls of these loops.

    The calls have the names of vectors' components in scalar kernels.
    """
    if not kernel.code.indexed:
        return kernel, ()
    calls: dict[str, Operation] = {}
    code = kernel.code
    inside = _take_out(code.inside, names, calls) if code.inside else None
    stages = tuple(_take_out_of_stage(stage, names, calls) for stage in code.stages)
    renamed = rename_components(code, list_arguments(kernel))
    listed = tuple(call.rename(renamed) for call in calls.values())
    return replace(kernel, code=replace(code, inside=inside, stages=stages)), listed


def _take_out_of_stage(stage: Stage, names: Collection[str], calls: dict[str, Operation]) -> Stage:
    assert stage.evaluate is not None
    evaluate = _take_out(stage.evaluate, names, calls)
    return replace(stage, running=evaluate.inputs, evaluate=evaluate)


def _take_out(program: Program, names: Collection[str], calls: dict[str, Operation]) -> Program:
    """Replace calls by inputs named after their loops, as each loop is called in only one way."""
    found = {step.result: step for step in program.operations if step.kind in names}
    calls |= {step.kind: step for step in found.values()}
    kinds: dict[Operand, str] = {result: step.kind for result, step in found.items()}
    kept = tuple(step for step in program.operations if step.result not in found)
    parted = replace(program, operations=kept).rename(kinds).normal_form()
    used = {o for step in parted.operations for o in step.operands}.union(parted.outputs)
    inputs = (*program.inputs, *kinds.values())
    return replace(parted, inputs=tuple(n for n in dict.fromkeys(inputs) if n in used))


def describe_calls(
    calls: Iterable[Operation], reductions: Iterable[TermLoop], syntax: Syntax
) -> tuple[LoopCall, ...]:
    """Return the data to print of calls of loops."""
    named = {found.name: found for found in reductions}
    return tuple(
        LoopCall(
            call.kind,
            tuple(map(str, call.operands)),
            named[call.kind].axes,
            named[call.kind].kind == "every",
            syntax.last.get(call.kind) == EXACT,
        )
        for call in calls
    )


def name_elements(found: TermLoop) -> TermLoop:
    """Return a loop with inputs of its term renamed that share a name with a loop's argument."""
    used = {step.result for step in found.term.operations}.union(found.term.inputs)
    given: dict[Operand, str] = {
        name: unused_name(f"{name}_term", used) for name in found.parameters
    }
    return replace(found, term=found.term.rename(given))


def mean_term(found: TermLoop) -> Program:
    """Return the program of a compiled function for one term: its elements, then the term."""
    taken = tuple(
        Operation(name, "element", (given, AT, *(f"{AT[0]}{LOOPS[i]}" for i in indices)))
        for name, (given, indices) in zip(found.term.inputs, found.elements, strict=True)
    )
    places = (AT, *(f"{AT[0]}{letter}" for letter in LOOPS))
    term = replace(found.term, operations=(*taken, *found.term.operations))
    return replace(term, inputs=(*places, *found.parameters)).normal_form()
