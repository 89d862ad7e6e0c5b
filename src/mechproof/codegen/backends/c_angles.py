"""Angles in C: in, a stage; out, what is asked of a block of points before a loop without a branch.

Elementary functions of angles are right up to the format's largest angle. Whether all angles of a
point are below it, is a program of its own: that part of the stage which computes them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from mechproof.codegen.backends.scalar_texts import ScalarStage, list_booleans
from mechproof.codegen.syntax import ProgramText, Syntax, write_program
from mechproof.programs.code import Stage
from mechproof.programs.elementary.function_programs import BODIES
from mechproof.programs.operations import HELPER
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program

LIMITED = frozenset(kind for kind, (_, _, far) in BODIES.items() if far)


@dataclass(frozen=True)
class Angles:
    """The text that says whether all angles are near: of a point, and what is prepared by place."""

    running: tuple[str, ...]
    prepared: tuple[tuple[str, int], ...]
    text: ProgramText
    booleans: frozenset[str]


def find_angles(stage: Stage, largest: float) -> Program | None:
    """Return the program that says whether all angles of a point are near; None without angles."""
    assert stage.evaluate is not None
    program, steps = stage.evaluate, list(stage.evaluate.operations)
    angles = dict.fromkeys(step.operands[0] for step in steps if step.kind in LIMITED)
    result: Operand = True
    for number, angle in enumerate(angles):
        size, near, both = (f"{TEMPORARY}{kind}{number}" for kind in ("size", "near", "both"))
        steps.append(Operation(size, "absolute", (angle,)))
        steps.append(Operation(near, "less_equal", (size, largest)))
        steps.append(Operation(both, "both", (result, near)))
        result = both if number else near
    found = _keep_needed(replace(program, operations=tuple(steps), outputs=(result,)))
    return found if angles else None


def _keep_needed(program: Program) -> Program:
    """Return a program without the operations and inputs that no output needs."""
    needed: set[Operand] = set(program.outputs)
    kept: list[Operation] = []
    for step in reversed(program.operations):
        if step.result in needed:
            needed.update(step.operands)
            kept.insert(0, step)
    inputs = tuple(name for name in program.inputs if name in needed)
    return replace(program, inputs=inputs, operations=tuple(kept)).normal_form()


def ask_first(
    written: ScalarStage, stage: Stage, largest: float, syntax: Syntax
) -> tuple[ScalarStage, Angles | None]:
    """Return a stage whose functions are told if angles may be far, and what is asked of them."""
    program = find_angles(stage, largest)
    if program is None:
        return written, None
    assert stage.evaluate is not None
    told = replace(syntax, last={**syntax.last, **dict.fromkeys(LIMITED, f"{HELPER}exact")})
    places = {n: i for i, n in enumerate(stage.evaluate.inputs[len(stage.running) :])}
    angles = Angles(
        tuple(syntax.name(name) for name in program.inputs if name not in places),
        tuple((syntax.name(name), places[name]) for name in program.inputs if name in places),
        write_program(program, syntax),
        list_booleans(program, syntax),
    )
    return replace(written, evaluate=write_program(stage.evaluate, told)), angles
