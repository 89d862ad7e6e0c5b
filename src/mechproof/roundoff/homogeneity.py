"""Homogeneity: factors that nobody knows, of a tangent's two parts, and that no output may have.

Degrees are inferred as the dimensions of physical quantities are (Kennedy 1996): what has none is
the same whatever the factor.
"""

from __future__ import annotations

from dataclasses import replace

from mechproof.programs.degrees import DEGREES, NONE, Degree
from mechproof.programs.program import Operand
from mechproof.roundoff.steps import StraightLineProgram


def find_scaled(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps with what is scaled told; ValueError where an output depends on a scale."""
    known: dict[Operand, Degree] = {}
    for step in straight.steps:
        given = [known.get(operand, NONE) for operand in step.operands]
        if step.scaled:
            known[step.result] = Degree({step.scaled: 1})
        elif any(degree.powers for degree in given):
            try:
                known[step.result] = DEGREES[step.kind](*given)
            except (KeyError, ValueError) as error:
                raise ValueError(f"{step.result}: {step.kind} of what is scaled") from error
    scaled = tuple(str(result) for result, degree in known.items() if degree.powers)
    if any(output in scaled for output in straight.outputs):
        raise ValueError("an output is scaled")
    return replace(straight, scaled=scaled)
