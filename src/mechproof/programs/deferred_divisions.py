"""Deferred divisions: in, a program; out, one of the same value with fewer divisions.

A tangent is a quotient of two values, and so is the argument of many an arctangent. Where one loop
computes point after point, a division takes as long as ten products: so only numerators are
computed, and their denominators counted until they cancel, as projective coordinates defer the
divisions in arithmetic on curves.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from mechproof.programs.degrees import DEGREES, NONE, Degree
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program, is_unnamed


@dataclass(frozen=True)
class Fraction:
    """The value that an operand stands for: a numerator over powers of denominators."""

    above: Operand
    below: Degree


def defer_divisions(program: Program) -> Program:
    """Return a program of the same value, whatever the common factor of a tangent's two parts.

    Tangents are replaced by their parts only if their denominators cancel everywhere.
    """
    if any(step.kind == "tan" for step in program.operations):
        program = _Fractions(program).list_cancelled() or program
    return _join_quotients(program)


class _Fractions:
    """Rewrites a program with tangents by their parts, tracking denominators."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._operations: list[Operation] = []
        self._fractions: dict[Operand, Fraction] = {}

    def list_cancelled(self) -> Program | None:
        """Return the rewritten program, or None if some denominator does not cancel."""
        for step in self._program.operations:
            if not self._take(step):
                return None
        results = [self._find(output) for output in self._program.outputs]
        if any(_join([result.below]).powers for result in results):
            return None
        outputs = tuple(self._scale(result, NONE) for result in results)
        return replace(
            self._program, operations=tuple(self._operations), outputs=outputs
        ).normal_form()

    def _find(self, operand: Operand) -> Fraction:
        return self._fractions.get(operand, Fraction(operand, NONE))

    def _add(self, kind: str, *operands: Operand, result: str = "") -> str:
        result = result or f"{TEMPORARY}part{len(self._operations)}"
        self._operations.append(Operation(result, kind, operands))
        return result

    def _name(self, operand: Operand, name: str) -> Operand:
        """Name the last result if it is unnamed, as it is used twice."""
        if not is_unnamed(operand):
            return operand
        self._operations[-1] = replace(self._operations[-1], result=name)
        return name

    def _take(self, step: Operation) -> bool:
        """Add the operations of a step; return False if it would need an undivided value."""
        given = [self._find(operand) for operand in step.operands]
        if step.kind == "tan" and not given[0].below.powers:
            # The denominator is used by more than one value, so it needs a name.
            count = sum(one.kind == "tangent_above" for one in self._operations)
            name = f"tangent_{count + 1}" if is_unnamed(step.result) else step.result
            angle = self._name(given[0].above, f"{name}_angle")
            below = self._add("tangent_below", angle, result=f"{name}_below")
            self._add("tangent_above", angle, result=step.result)
            self._fractions[step.result] = Fraction(step.result, Degree({below: 1}))
            return True
        common = _combine(step.kind, [fraction.below for fraction in given])
        if common is None:
            common = _join(fraction.below for fraction in given)
            if common.powers and step.kind not in ("add", "subtract"):
                return False
            operands = [self._scale(fraction, common) for fraction in given]
        else:
            operands = [fraction.above for fraction in given]
        self._add(step.kind, *operands, result=step.result)
        self._fractions[step.result] = Fraction(step.result, common)
        return True

    def _scale(self, fraction: Fraction, common: Degree) -> Operand:
        """Return the fraction's numerator over `common`, a multiple of its denominator."""
        value = fraction.above
        missing = common / fraction.below
        for name in {**common.powers, **fraction.below.powers}:
            for _ in range(missing.powers.get(name, 0)):
                value = name if value == 1 else self._add("multiply", value, name)
        return value


def _combine(kind: str, degrees: Iterable[Degree]) -> Degree | None:
    """Return the denominators of a result from its operands'; None without a rule, as for sums."""
    try:
        return None if kind in ("add", "subtract") else DEGREES[kind](*degrees)
    except (KeyError, ValueError):
        return None


def _join(degrees: Iterable[Degree]) -> Degree:
    """Return the least common denominator of several denominators and 1."""
    listed = [degree.powers for degree in (*degrees, NONE)]
    highest = {name: max(p.get(name, 0) for p in listed) for p in listed for name in p}
    return Degree({name: power for name, power in highest.items() if power})


def _join_quotients(program: Program) -> Program:
    """Return the program with arctangents of quotients replaced by `arctan_quotient`."""
    made = {step.result: step for step in program.operations}
    operations: list[Operation] = []
    for step in program.operations:
        if step.kind == "arctan":
            step = _take_quotient(step, made, operations)
        operations.append(step)
    return replace(program, operations=tuple(operations)).normal_form()


def _take_quotient(
    step: Operation, made: dict[str, Operation], operations: list[Operation]
) -> Operation:
    """Return the arctangent of (a/b)*c*d as that of a*c*d over b, adding the product's steps."""
    (value,) = step.operands
    factors: list[Operand] = []
    while (found := made.get(str(value))) and found.kind == "multiply" and is_unnamed(value):
        value, factor = found.operands
        factors.insert(0, factor)
    if not found or found.kind != "divide" or not is_unnamed(value):
        return step
    above, below = found.operands
    for number, factor in enumerate(factors):
        result = f"{step.result}above{number}"
        operations.append(Operation(f"{TEMPORARY}{result}", "multiply", (above, factor)))
        above = f"{TEMPORARY}{result}"
    return replace(step, kind="arctan_quotient", operands=(above, below))
