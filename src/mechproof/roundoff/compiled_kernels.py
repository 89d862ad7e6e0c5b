"""Compiled kernels: what stands for their elementary functions, and these run in doubles.

A tangent comes in two parts, both off by one factor that depends on the angle alone. It is no
matter to what depends on their quotient: the parts are taken for the tangent and 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, partial
from types import MappingProxyType
from typing import Any

from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.program import Operand, Operation, Program
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import EXACT, HALF, Expansion

WAY = "compiled"
# Stands for an error that is proved of the function as a whole.
PROVED = float("inf")
PARTS = ("tangent_above", "tangent_below")


def _expand(
    inputs: str, *steps: tuple[str, str, str], proved: str = "", **errors: float
) -> Expansion:
    """Return an expansion into steps, each a result, a kind and operands of one letter.

    `errors` are those of the results in eps, or `PROVED`.
    """
    operations = tuple(Operation(result, kind, tuple(given)) for result, kind, given in steps)
    known = {result: proved for result, off in errors.items() if off == PROVED}
    return Expansion(Program(tuple(inputs), operations, ("q",)), errors, known)


def _model_part(kind: str, result: str, angle: Operand) -> Operation:
    if kind == "tangent_above":
        return Operation(result, "tan", (angle,))
    return Operation(result, "copy", (1.0,))


def _expand_part(kind: str) -> Expansion:
    program = Program(("y",), (_model_part(kind, "q", "y"),), ("q",))
    known = {"q": "tan"} if kind == "tangent_above" else {}
    return Expansion(program, dict.fromkeys(known, PROVED), known, frozenset({"q"}))


def _expand_tangent_quotient() -> Expansion:
    """Take the two parts of the tangent as single steps, whatever computes them."""
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
    """Return the result that is computed as this part of a tangent is; ValueError without one."""
    part = build(kind, DOUBLE).program
    meant = _describe(part)[str(part.outputs[0])]
    for result, found in _describe(program).items():
        if found == meant:
            return result
    raise ValueError(f"{kind} is no part of {program.inputs} -> {program.outputs}")


def _describe(program: Program) -> dict[str, str]:
    """Describe how each result is computed from the inputs."""
    texts: dict[Operand, str] = {name: name for name in program.inputs}
    for step in program.operations:
        given = ", ".join(texts.get(o, repr(o)) for o in step.operands)
        texts[step.result] = f"{step.kind}({given})"
    return {step.result: texts[step.result] for step in program.operations}


@cache
def list_expansions() -> Mapping[str, Expansion]:
    """Return the expansions of what compiled kernels call."""
    for kind in PARTS:
        # What is proved of the tangent is proved of its parts, so these must be found in it.
        find_part(build("tan", DOUBLE).program, kind)
    return MappingProxyType(
        {
            **{k: _expand("y", ("q", k, "y"), proved=k, q=PROVED) for k in ("sin", "cos")},
            # The quotient of its two parts, exact at first, is rounded in a step of its own.
            "tan": _expand(
                "y", ("w", "tan", "y"), ("q", "copy", "w"), proved="tan", w=PROVED, q=HALF
            ),
            "small_arctan": _expand("y", ("q", "arctan", "y"), proved="small_arctan", q=PROVED),
            "arctan_quotient": _expand(
                *("ab", ("w", "divide", "ab"), ("q", "arctan", "w")),
                proved="arctan_quotient",
                w=EXACT,
                q=PROVED,
            ),
            "arctan2": _expand("ab", ("q", "arctan2", "ab"), proved="arctan2", q=PROVED),
            # Without the power of two by which the sides are scaled: it changes no rounding.
            "hypot": _expand("ab", ("s", "square", "b"), ("w", "fma", "aas"), ("q", "sqrt", "w")),
            "tangent_quotient": _expand_tangent_quotient(),
            **{kind: _expand_part(kind) for kind in PARTS},
        }
    )


def _compute(kind: str, *values: Any) -> Any:
    program = build(kind, DOUBLE).program
    return run(program, dict(zip(program.inputs, values, strict=True)), IN_DOUBLES)[0]


# Operations of compiled kernels in doubles.
COMPILED = IN_DOUBLES.but(**{kind: partial(_compute, kind) for kind in BODIES})
