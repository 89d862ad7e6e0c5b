"""Comparison: boxed programs -> the bounds on their rounding errors that other tools find.

Each tool is run if it is installed, on the same steps with the same conventions, and only by its
command. All tools need names of the steps, the spelling of an operation, and a call.
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterable, Sequence
from subprocess import CompletedProcess
from typing import Any

from mechproof.programs.operations import Infix, Pattern, Spelling
from mechproof.roundoff.boxed import BoxedProgram

# Time limit of a call, in seconds.
LIMIT = 600.0


def name_all(program: BoxedProgram) -> dict[str, str]:
    """Return a name for each input and step."""
    results = (*program.straight.inputs, *(step.result for step in program.straight.steps))
    return {name: f"v{number}" for number, name in enumerate(results)}


def spell(spelling: Spelling | None, operands: Iterable[str]) -> str:
    """Return the text of one operation on operands that need no brackets."""
    if isinstance(spelling, Infix):
        return f" {spelling.sign} ".join(operands)
    if isinstance(spelling, Pattern):
        return spelling.text.format(*operands)
    return f"{spelling}({', '.join(operands)})"


def call(command: Sequence[str], **given: Any) -> CompletedProcess[str] | None:
    """Return the finished call of a tool, or None if it takes too long."""
    try:
        return subprocess.run(
            command, capture_output=True, text=True, timeout=LIMIT, check=False, **given
        )
    except subprocess.TimeoutExpired:
        return None
