"""Steps: in, a stage of a kernel; out, its operations in one list, each with its own rounding.

Some operations are first expanded into programs of others.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from mechproof.programs.operations import KINDS, Rounding
from mechproof.programs.program import CONSTANTS, Operand, Operation, Program, Stage
from mechproof.programs.trace import TRACED, trace

HALF = 0.5
EXACT = 0.0
# What rounding took from a product and from a quotient: exact, or up to one rounding.
RESTS = PRODUCT_REST, QUOTIENT_REST = "product_rest", "quotient_rest"
SUM_REST = "sum_rest"
# A number that is no double and is rounded once; its operand is the exact number as text, a
# fraction or the name of a constant.
CONSTANT = "constant"
CHOICE = "choose"
# Functions of our own are expanded, or have a proved bound, before their steps are bounded.
ULPS: Mapping[Rounding, float] = {
    Rounding.EXACT: EXACT,
    Rounding.NEAREST: HALF,
    Rounding.LIBRARY: HALF,
}


# Functions whose results are assumed to be within one ulp, with texts that say so.
FUNCTIONS: Mapping[str, str] = MappingProxyType(
    {
        name: f"np.{name} within 1 ulp"
        for name, row in KINDS.items()
        if row.rounding is Rounding.LIBRARY and hasattr(np, name)
    }
)
# Assumed of every program: an operation's relative error is bounded only in the normal range.
NORMAL = "no result overflows or falls below the normal range"
# Assumed of maps of points: it limits how many roundings a product goes through.
SUMS = "np.matmul by products and their sums in any order"
# Assumed of sums over sets.
TERMS = "np.sum by additions in any order"


@dataclass(frozen=True)
class Expansion:
    """A program in place of one operation; `errors` are those of approximations, in eps.

    `proved` maps results to the functions whose proved error they have; results in `scaled` have an
    unknown factor that depends on the first operand alone.
    """

    program: Program
    errors: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    proved: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    scaled: frozenset[str] = frozenset()


def _write_out(kind: str, *inputs: str) -> Expansion:
    """Return the expansion of a kind into the operations of its meaning."""
    meaning = KINDS[kind].meaning
    assert meaning is not None
    return Expansion(trace(partial(meaning, TRACED), inputs))


def _call(kind: str, *inputs: str) -> Expansion:
    """Return the expansion of a kind into a single other one."""
    return Expansion(Program(inputs, (Operation("q", kind, inputs),), ("q",)))


# Kinds that NumPy kernels compute by NumPy's tan, arctan and arctan2; a test compares every bit.
WAY = "NumPy's functions"
IN_NUMPY: Mapping[str, Expansion] = MappingProxyType(
    {
        "tangent_quotient": _write_out("tangent_quotient", "y", "c", "a", "r", "b"),
        "small_arctan": _write_out("small_arctan", "y"),
        "arctan_quotient": _call("arctan2", "a", "b"),
    }
)


@dataclass(frozen=True)
class Step:
    """An operation whose result is off by at most `ulps` ulps of itself.

    If `proved` names a function, the proved error of that function holds instead. All results with
    the same angle in `scaled` share one unknown factor.
    """

    result: str
    kind: str
    operands: tuple[Operand, ...]
    ulps: float
    proved: str = ""
    scaled: Operand = ""


@dataclass(frozen=True)
class StraightLineProgram:
    """All steps of a stage; inputs are the arguments, outputs are results, inputs or numbers.

    The rounding of a `held` result moves no output, because a low word compensates it. The factors
    of `scaled` results cancel in every output. Both are in the order of the steps, so that equal
    steps are printed alike.
    """

    inputs: tuple[str, ...]
    steps: tuple[Step, ...]
    outputs: tuple[Operand, ...]
    held: tuple[str, ...] = ()
    scaled: tuple[str, ...] = ()

    def rename(self, names: Mapping[Operand, Operand]) -> StraightLineProgram:
        """Return the steps with results and operands renamed."""

        def find(*operands: Operand) -> tuple[Operand, ...]:
            return tuple(names.get(operand, operand) for operand in operands)

        steps = tuple(
            replace(step, result=str(*find(step.result)), operands=find(*step.operands))
            for step in self.steps
        )
        return replace(self, steps=steps, outputs=find(*self.outputs))


def name_constant(number: Fraction) -> str:
    """Return the operand of a constant step for a fraction."""
    return f"{number.numerator}/{number.denominator}"


def keep_needed(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps without those that no output needs."""
    needed: set[Operand] = set(straight.outputs)
    steps: list[Step] = []
    for step in reversed(straight.steps):
        if step.result in needed:
            needed.update(step.operands)
            steps.insert(0, step)
    return replace(straight, steps=tuple(steps))


def flatten_stage(stage: Stage, expansions: Mapping[str, Expansion]) -> StraightLineProgram:
    """Return the steps of a stage: those that prepare, then those that evaluate, all expanded.

    Numbers that are no doubles are rounded first, once each.
    """
    return round_constants(_flatten(stage, expansions))


def round_constants(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps preceded by one rounding step for each number that is no double."""
    operands = (*(o for step in straight.steps for o in step.operands), *straight.outputs)
    names: dict[Operand, str] = {o: f"rounded {o}" for o in operands if not is_double(o)}
    rounded = [Step(name, CONSTANT, (o,), HALF) for o, name in names.items()]
    renamed = straight.rename(names)
    return replace(renamed, steps=(*rounded, *renamed.steps))


def is_double(operand: Operand) -> bool:
    """Return whether an operand needs no rounding: a double, a result or an input."""
    if isinstance(operand, str):
        return operand not in CONSTANTS or not CONSTANTS[operand].is_finite
    return float(operand) == operand


def _flatten(stage: Stage, expansions: Mapping[str, Expansion]) -> StraightLineProgram:
    inputs = (*stage.running, *(p for p in stage.parameters if p not in stage.running))
    known: dict[Operand, Operand] = {name: name for name in inputs}
    steps: list[Step] = []
    given: Sequence[Operand] = stage.prepare.outputs
    if stage.prepare.operations or stage.prepare.outputs:
        given = _append(steps, stage.prepare, known, "prepared.", expansions)
    if stage.evaluate is None:
        return StraightLineProgram(inputs, tuple(steps), tuple(given))
    passed = zip(stage.evaluate.inputs[len(stage.running) :], given, strict=True)
    inside: dict[Operand, Operand] = {name: name for name in stage.running}
    inside.update(passed)
    outputs = _append(steps, stage.evaluate, inside, "", expansions)
    return StraightLineProgram(inputs, tuple(steps), outputs)


def _append(
    steps: list[Step],
    program: Program,
    known: Mapping[Operand, Operand],
    prefix: str,
    expansions: Mapping[str, Expansion],
) -> tuple[Operand, ...]:
    names = dict(known)
    names |= {step.result: f"{prefix}{step.result}" for step in program.operations}
    renamed = program.rename(names)
    for operation in renamed.operations:
        steps.extend(_expand(operation, expansions))
    return renamed.outputs


def _expand(operation: Operation, expansions: Mapping[str, Expansion]) -> Iterator[Step]:
    if operation.kind not in expansions:
        yield make_step(operation)
        return
    expansion = expansions[operation.kind]
    program, result = expansion.program, operation.result
    names: dict[Operand, Operand] = dict(zip(program.inputs, operation.operands, strict=False))
    names |= {inner.result: f"{result}.{inner.result}" for inner in program.operations}
    names[program.outputs[0]] = result
    for inner in program.operations:
        made = make_step(inner.rename(names))
        yield replace(
            made,
            ulps=expansion.errors.get(inner.result, made.ulps),
            proved=expansion.proved.get(inner.result, ""),
            scaled=operation.operands[0] if inner.result in expansion.scaled else "",
        )


def make_step(operation: Operation) -> Step:
    """Return an operation as a step with the bound on its rounding error."""
    kind, operands = operation.kind, operation.operands
    if _scales_by_power(kind, operands):
        return Step(operation.result, kind, operands, EXACT)
    # A loop over terms has no kind of its own: it is a function of its kernel.
    rounding = KINDS[kind].rounding if kind in KINDS else Rounding.LIBRARY
    ulps = 1.0 if kind in FUNCTIONS else ULPS[rounding]
    return Step(operation.result, kind, operands, ulps)


def _scales_by_power(kind: str, operands: Sequence[Operand]) -> bool:
    """Return whether the operation multiplies or divides by a power of two."""
    return any(_is_power(f) for f in list_factors(kind, operands) if not isinstance(f, str))


def list_factors(kind: str, operands: Sequence[Any]) -> Sequence[Any]:
    """Return the operands that are factors or divisors of the result; none for other kinds."""
    return {"multiply": operands, "square": operands, "divide": operands[1:]}.get(kind, ())


def _is_power(number: float) -> bool:
    return is_double(number) and math.frexp(abs(number))[0] == HALF
