"""Branches: in, a program that computes both and chooses; out, one that machines can differentiate.

The derivative of a branch that is not taken is multiplied by zero, which gives NaN if it is NaN or
infinite, as for a root of a negative number. So the operands of a branch are also chosen before it
(JAX's "double where"): no derivative passes back through there, and values are the same.
"""

from __future__ import annotations

from dataclasses import replace

from mechproof.programs.evaluation import unused_name
from mechproof.programs.program import Operand, Operation, Program, is_unnamed


def block_branches(program: Program) -> Program:
    """Return the program with NaN for the operands of each branch where it is not taken."""
    for step in program.operations:
        if step.kind == "choose":
            program = _block(program, step.result)
    return program.normal_form()


def _block(program: Program, result: str) -> Program:
    (place,) = (i for i, step in enumerate(program.operations) if step.result == result)
    choice = program.operations[place]
    condition, one, other = choice.operands
    taken = {*program.inputs, *(step.result for step in program.operations)}
    blocked = _block_branch(program, choice, one, (condition, "", "#nan"), taken)
    blocked += _block_branch(program, choice, other, (condition, "#nan", ""), taken)
    if not blocked:
        return program
    own = {step.result for step in blocked}
    before = [step for step in program.operations[:place] if step.result not in own]
    operations = [*before, *blocked, *program.operations[place:]]
    if is_unnamed(condition):
        # A result without a name may be used only once, so this one needs a name.
        names: dict[Operand, str] = {condition: unused_name("holds", taken)}
        operations = [step.rename(names) for step in operations]
    return replace(program, operations=tuple(operations))


def _block_branch(
    program: Program,
    choice: Operation,
    branch: Operand,
    chosen: tuple[Operand, ...],
    taken: set[str],
) -> list[Operation]:
    """List the steps that put a branch's operands in the empty place of `chosen`, then its own."""
    own = _list_own(program, choice, branch)
    made = {step.result for step in own}
    steps, names = [], dict[Operand, str]()
    for value in dict.fromkeys(operand for step in own for operand in step.operands):
        if isinstance(value, str) and value not in made and not value.startswith("#"):
            names[value] = unused_name(value, taken)
            taken.add(names[value])
            operands = tuple(o or value for o in chosen)
            steps.append(Operation(names[value], "choose", operands))
    return [*steps, *(step.rename(names) for step in own)]


def _list_own(program: Program, choice: Operation, branch: Operand) -> list[Operation]:
    """List the steps whose results only one branch uses; none if an output is among them."""
    own: list[Operation] = []
    made: set[str] = set()
    for step in reversed(program.operations):
        users = [other for other in program.operations if step.result in other.operands]
        is_end = step.result == branch and choice.operands.count(branch) == 1
        if users and all(u.result in made or (u is choice and is_end) for u in users):
            own.insert(0, step)
            made.add(step.result)
    return [] if made.intersection(map(str, program.outputs)) else own
