"""Compiled kernels: stand-ins for their elementary functions, and these functions in doubles.

A tangent is computed in two parts, both scaled by one factor that depends on the angle alone. The
factor does not affect results that depend only on the parts' quotient, so the parts are modelled
as the tangent and 1.
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
# Marks a result whose error is proved for the function as a whole.
PROVED = float("inf")
PARTS = ("tangent_above", "tangent_below")


def _expand(
    inputs: str, *steps: tuple[str, str, str], proved: str = "", **errors: float
) -> Expansion:
    """Return an expansion into steps, each a result, a kind and operands, one letter each.

    `errors` maps results to their errors in eps, or to `PROVED`.
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
    """Return `tangent_quotient` with the two parts of the tangent as single, modelled steps."""
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
    """Return the result computed in the same way as a part of a tangent; ValueError if none is."""
    part = build(kind, DOUBLE).program
    meant = _describe(part)[str(part.outputs[0])]
    for result, found in _describe(program).items():
        if found == meant:
            return result
    raise ValueError(f"{kind} is not a part of {program.inputs} -> {program.outputs}")


def _describe(program: Program) -> dict[str, str]:
    """Return, for each result, the text of its computation from the inputs."""
    texts: dict[Operand, str] = {name: name for name in program.inputs}
    for step in program.operations:
        given = ", ".join(texts.get(o, repr(o)) for o in step.operands)
        texts[step.result] = f"{step.kind}({given})"
    return {step.result: texts[step.result] for step in program.operations}


@cache
def list_expansions() -> Mapping[str, Expansion]:
    """Return the expansions of the functions that compiled kernels call."""
    for kind in PARTS:
        # The proof of the tangent covers its parts only if they are found in it.
        find_part(build("tan", DOUBLE).program, kind)
    return MappingProxyType(
        {
            **{k: _expand("y", ("q", k, "y"), proved=k, q=PROVED) for k in ("sin", "cos")},
            # The quotient of its two parts, exact at first, is rounded in a separate step.
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
            # Without the power of two that scales the sides: it changes no rounding.
            "hypot": _expand("ab", ("s", "square", "b"), ("w", "fma", "aas"), ("q", "sqrt", "w")),
            "tangent_quotient": _expand_tangent_quotient(),
            **{kind: _expand_part(kind) for kind in PARTS},
        }
    )


def _compute(kind: str, *values: Any) -> Any:
    program = build(kind, DOUBLE).program
    return run(program, dict(zip(program.inputs, values, strict=True)), IN_DOUBLES)[0]


# The operations of compiled kernels, in doubles.
COMPILED = IN_DOUBLES.but(**{kind: partial(_compute, kind) for kind in BODIES})
