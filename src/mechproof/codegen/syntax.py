"""Syntax: in, a program and a language's table; out, its text. Only brackets are decided here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from mechproof.programs.operations import ATOM, COMPARISON, REDUCTIONS, SIGN, Infix, Level, Pattern
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program


@dataclass(frozen=True)
class Syntax:
    """How a language spells operations.

    `calls` are functions by kind of operation, `last` extra last arguments of such calls. `name`
    spells a paper's name so that it clashes with no name of the language or of generated code.
    """

    infix: Mapping[str, Infix]
    calls: Mapping[str, str]
    last: Mapping[str, str]
    patterns: Mapping[str, Pattern]
    constants: Mapping[str, str]
    number: Callable[[float], str] = repr
    name: Callable[[str], str] = str


@dataclass(frozen=True)
class ProgramText:
    """The text of a program: an assignment for each named result, and the outputs."""

    steps: tuple[tuple[str, str], ...]
    outputs: tuple[str, ...]


def write_program(program: Program, syntax: Syntax) -> ProgramText:
    """Return the text of a program; unnamed results are written where they are used."""
    writer = _Writer(syntax)
    steps = []
    for operation in program.operations:
        text, level = writer.write(operation)
        if operation.result.startswith(TEMPORARY):
            writer.written[operation.result] = text, level
        else:
            steps.append((syntax.name(operation.result), text))
    outputs = (float(o) if isinstance(o, int) else o for o in program.outputs)
    return ProgramText(tuple(steps), tuple(writer.show(output)[0] for output in outputs))


class _Writer:
    def __init__(self, syntax: Syntax) -> None:
        self.written: dict[str, tuple[str, Level]] = {}
        self._syntax = syntax

    def show(self, operand: Operand) -> tuple[str, Level]:
        if isinstance(operand, str):
            if operand in self.written:
                return self.written[operand]
            return self._syntax.constants.get(operand) or self._syntax.name(operand), ATOM
        return self._syntax.number(operand), ATOM if operand >= 0 else SIGN

    def enclose(self, operand: Operand, level: Level) -> str:
        """Return the text of an operand, in brackets if it binds less than `level`."""
        text, own = self.show(operand)
        return text if own >= level else f"({text})"

    def write(self, operation: Operation) -> tuple[str, Level]:
        syntax, kind, operands = self._syntax, operation.kind, operation.operands
        if kind in syntax.infix:
            return self._write_infix(kind, *operands)
        if kind == "copy":
            return self.show(operands[0])
        if kind in syntax.patterns:
            pattern = syntax.patterns[kind]
            return pattern.text.format(*(self.enclose(o, pattern.inner) for o in operands)), (
                pattern.outer
            )
        if kind in REDUCTIONS:
            return self._write_reduction(kind, *operands), ATOM
        arguments = [self.show(operand)[0] for operand in operands]
        arguments += [syntax.last[kind]] if kind in syntax.last else []
        return f"{syntax.calls[kind]}({', '.join(arguments)})", ATOM

    def _write_infix(self, kind: str, one: Operand, other: Operand) -> tuple[str, Level]:
        infix = self._syntax.infix[kind]
        level = infix.level
        # Comparisons do not chain, so both sides must bind more.
        left = level + 1 if level == COMPARISON else level
        # Brackets on the right stay even in sums and products: a + (b + c) is rounded as written.
        return f"{self.enclose(one, left)} {infix.sign} {self.enclose(other, level + 1)}", level

    def _write_reduction(self, kind: str, value: Operand, axes: Operand) -> str:
        assert isinstance(axes, int)
        where = "-1" if axes == 1 else str(tuple(range(-axes, 0)))
        return f"{self._syntax.calls[kind]}({self.show(value)[0]}, axis={where})"
