"""Compiled kernels: what stands for their elementary functions, and these run in doubles.

A tangent comes in two parts, both off by one factor that depends on the angle alone. It is no
matter to what depends on their quotient: the parts are taken for the tangent and 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.program import Operand, Operation, Program
from mechproof.roundoff.expansions import Expansion
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import EXACT, HALF

WAY = "compiled"
# Whose error is what is proved.
PROVED = float("inf")
PARTS = ("tangent_above", "tangent_below")


def _expand_function(kind: str, name: str) -> Expansion:
    program = Program(("y",), (Operation("q", name, ("y",)),), ("q",))
    return Expansion(program, {"q": PROVED}, {"q": kind})


def _expand_tangent() -> Expansion:
    """Take the tangent for the exact quotient of its two parts, which is rounded."""
    operations = (Operation("w", "tan", ("y",)), Operation("q", "copy", ("w",)))
    program = Program(("y",), operations, ("q",))
    return Expansion(program, {"w": PROVED, "q": HALF}, {"w": "tan"})


def _expand_quotient() -> Expansion:
    operations = (Operation("w", "divide", ("a", "b")), Operation("q", "arctan", ("w",)))
    program = Program(("a", "b"), operations, ("q",))
    return Expansion(program, {"w": EXACT, "q": PROVED}, {"q": "arctan_quotient"})


def _expand_direction() -> Expansion:
    program = Program(("a", "b"), (Operation("q", "arctan2", ("a", "b")),), ("q",))
    return Expansion(program, {"q": PROVED}, {"q": "arctan2"})


def _expand_hypotenuse() -> Expansion:
    """Leave out the power of two by which the sides are scaled: it moves no rounding."""
    operations = (
        Operation("s", "square", ("b",)),
        Operation("w", "fma", ("a", "a", "s")),
        Operation("q", "sqrt", ("w",)),
    )
    return Expansion(Program(("a", "b"), operations, ("q",)))


def _model_part(kind: str, result: str, angle: Operand) -> Operation:
    if kind == "tangent_above":
        return Operation(result, "tan", (angle,))
    return Operation(result, "copy", (1.0,))


def _expand_part(kind: str) -> Expansion:
    program = Program(("y",), (_model_part(kind, "q", "y"),), ("q",))
    is_above = kind == "tangent_above"
    return Expansion(
        program,
        {"q": PROVED} if is_above else {},
        {"q": "tan"} if is_above else {},
        frozenset({"q"}),
    )


def _expand_tangent_quotient() -> Expansion:
    """Take the two parts of the tangent for steps, whatever made them."""
    program = build("tangent_quotient", DOUBLE).program
    angle = program.inputs[0]
    parts = {find_part(program, kind): kind for kind in PARTS}
    operations = tuple(
        _model_part(parts[step.result], step.result, angle) if step.result in parts else step
        for step in program.operations
    )
    above = next(result for result, kind in parts.items() if kind == "tangent_above")
    needed = Program(program.inputs, operations, program.outputs).normal_form()
    return Expansion(needed, {above: PROVED}, {above: "tan"}, frozenset(parts))


def find_part(program: Program, kind: str) -> str:
    """Return the result that is computed as a part of a tangent is; ValueError without one."""
    part = build(kind, DOUBLE).program
    meant = _describe(part)[str(part.outputs[0])]
    for result, found in _describe(program).items():
        if found == meant:
            return result
    raise ValueError(f"{kind} is no part of {program.inputs} -> {program.outputs}")


def _describe(program: Program) -> dict[str, str]:
    """Return how each result is computed of the inputs."""
    texts: dict[Operand, str] = {name: name for name in program.inputs}
    for step in program.operations:
        given = ", ".join(texts.get(o, repr(o)) for o in step.operands)
        texts[step.result] = f"{step.kind}({given})"
    return {step.result: texts[step.result] for step in program.operations}


@cache
def list_expansions() -> Mapping[str, Expansion]:
    """Return the expansions of what compiled kernels call."""
    for kind in PARTS:
        # The proof is about the parts of the tangent.
        find_part(build("tan", DOUBLE).program, kind)
    return MappingProxyType(
        {
            **{kind: _expand_function(kind, kind) for kind in ("sin", "cos")},
            "tan": _expand_tangent(),
            "small_arctan": _expand_function("small_arctan", "arctan"),
            "arctan_quotient": _expand_quotient(),
            "arctan2": _expand_direction(),
            "hypot": _expand_hypotenuse(),
            "tangent_quotient": _expand_tangent_quotient(),
            **{kind: _expand_part(kind) for kind in PARTS},
        }
    )


def _compute(kind: str) -> Callable[..., Any]:
    def compute(*values: Any) -> Any:
        program = build(kind, DOUBLE).program
        return run(program, dict(zip(program.inputs, values, strict=True)), IN_DOUBLES)[0]

    return compute


# Operations of compiled kernels in doubles.
COMPILED = IN_DOUBLES.but(**{kind: _compute(kind) for kind in BODIES})
