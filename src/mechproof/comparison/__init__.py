"""Comparison: in, boxed programs; out, what other programs bound their rounding errors by.

Each is run where it is installed, on the same steps with the same conventions; nothing of them is
called but their commands. What every tool takes are names of the steps, the spelling of an
operation, and a call.
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterable, Sequence
from subprocess import CompletedProcess
from typing import Any

from mechproof.programs.operations import Infix, Pattern, Spelling
from mechproof.roundoff.boxed import BoxedProgram

# Seconds for a call.
LIMIT = 600.0


def name_all(program: BoxedProgram) -> dict[str, str]:
    """Return a name for each input and step."""
    results = (*program.straight.inputs, *(step.result for step in program.straight.steps))
    return {name: f"v{number}" for number, name in enumerate(results)}


def spell(spelling: Spelling | None, operands: Iterable[str]) -> str:
    """Return the text of one operation, of operands that need no brackets."""
    if isinstance(spelling, Infix):
        return f" {spelling.sign} ".join(operands)
    if isinstance(spelling, Pattern):
        return spelling.text.format(*operands)
    return f"{spelling}({', '.join(operands)})"


def call(command: Sequence[str], **given: Any) -> CompletedProcess[str] | None:
    """Return what a tool says; None where it takes too long."""
    try:
        return subprocess.run(
            command, capture_output=True, text=True, timeout=LIMIT, check=False, **given
        )
    except subprocess.TimeoutExpired:
        return None
