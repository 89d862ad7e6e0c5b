"""Spelling: in, how a language spells an operation, and its operands; out, the text."""

from __future__ import annotations

from collections.abc import Iterable

from mechproof.programs.operations import Infix, Pattern, Spelling


def spell(spelling: Spelling | None, operands: Iterable[str]) -> str:
    """Return the text of one operation, of operands that need no brackets."""
    if isinstance(spelling, Infix):
        return f" {spelling.sign} ".join(operands)
    if isinstance(spelling, Pattern):
        return spelling.text.format(*operands)
    return f"{spelling}({', '.join(operands)})"
