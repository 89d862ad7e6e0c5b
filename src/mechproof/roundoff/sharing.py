"""Sharing: steps that compute one number are one step, so that its rounding counts once.

Doubles are rounded alike whatever the order of the terms of a sum or of the factors of a product,
and whatever the sign. It is the value numbering of compilers (Cocke and Schwartz 1970).
"""

from __future__ import annotations

from dataclasses import replace

from mechproof.programs.program import Operand
from mechproof.roundoff.steps import Step, StraightLineProgram

_COMMUTATIVE = ("add", "multiply")
Key = tuple[str, tuple[str, ...]]


def share_equal_steps(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps, each number computed once."""
    names: dict[Operand, Operand] = {}
    known: dict[Key, str] = {}
    steps: list[Step] = []
    for step in straight.steps:
        operands = tuple(names.get(o, o) if isinstance(o, str) else o for o in step.operands)
        key = _name(step, operands)
        if key in known:
            names[step.result] = known[key]
        else:
            known[key] = step.result
            steps.append(replace(step, operands=operands))
    outputs = tuple(names.get(output, output) for output in straight.outputs)
    return replace(straight, steps=tuple(steps), outputs=outputs)


def _name(step: Step, operands: tuple[Operand, ...]) -> Key:
    # By their bits: 0.0 and -0.0 are equal and not one operand.
    texts = tuple(o if isinstance(o, str) else float(o).hex() for o in operands)
    return step.kind, tuple(sorted(texts)) if step.kind in _COMMUTATIVE else texts
