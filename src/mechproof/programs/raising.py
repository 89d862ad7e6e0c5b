"""Raising: in, the code of a kernel; out, the exact expressions it computes, for a proof."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from mechproof.programs.operations import SYMBOLIC, VIEWS
from mechproof.programs.program import (
    CONSTANTS,
    KernelCode,
    Operand,
    Program,
    Stage,
    map_affinely,
    spell_out_forms,
)
from mechproof.record import Quantity

# Functions whose values do not change when whole turns are taken off their argument.
PERIODIC = ("sin", "cos")


class WrittenForm:
    """A form as raised from its emitted source: inputs, steps and outputs."""

    def __init__(self, quantity: Quantity, code: KernelCode, stage: Stage) -> None:
        axes = _Axes(quantity)
        self._inputs = _name_inputs(quantity, code, stage, axes)
        self._steps: dict[sp.Symbol, sp.Expr] = {}
        # Steps with earlier steps inserted, by the steps that are kept: many statements keep the
        # same ones.
        self._inserted: dict[tuple[sp.Symbol, ...], dict[sp.Symbol, sp.Expr]] = {}
        prepared = self._raise(stage.prepare, self._inputs, axes)
        evaluate = stage.evaluate or map_affinely(stage.running)
        given = (*(self._inputs[name] for name in stage.running), *prepared)
        bound = dict(zip(evaluate.inputs, given, strict=True))
        self._outputs = self._raise(evaluate, bound, axes)
        self._shape = code.shape

    def output(self, *kept: sp.Symbol) -> sp.Basic:
        """Return the value with all steps inserted except the kept ones."""
        entries = [self._insert(output, kept) for output in self._outputs]
        if not self._shape:
            return entries[0]
        rows, columns = (*self._shape, 1)[:2]
        return sp.ImmutableDenseMatrix(rows, columns, entries)

    def step(self, name: sp.Symbol, *kept: sp.Symbol) -> sp.Expr:
        """Return a step's value, earlier steps inserted except the kept; ValueError if unknown."""
        found = {str(symbol): value for symbol, value in self._steps.items()}
        if str(name) not in found:
            raise ValueError(f"no step {name} among {', '.join(found)}")
        return self._insert(found[str(name)], kept)

    def _insert(self, expression: sp.Expr, kept: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Replace each step in an expression by its value, or by the kept symbol of that name."""
        named = {str(symbol): symbol for symbol in kept}
        values = self._inserted.setdefault(kept, {})
        for step in expression.free_symbols & self._steps.keys() - values.keys():
            values[step] = named.get(str(step)) or self._insert(self._steps[step], kept)
        return expression.xreplace(values)

    def _raise(
        self, program: Program, known: Mapping[str, sp.Expr], axes: _Axes
    ) -> tuple[sp.Expr, ...]:
        """Return a program's outputs, recording named results as steps; temporaries are inlined."""
        _check_turns(program)
        values: dict[str, sp.Basic] = dict(known)

        def find(operand: Operand) -> sp.Basic:
            if isinstance(operand, str):
                return values.get(operand, CONSTANTS.get(operand))
            return sp.Rational(operand)

        spelled = spell_out_forms(program)
        for operation in spelled.operations:
            if operation.kind in axes.kinds:
                value = axes.apply(operation.kind, find(operation.operands[0]), operation.operands)
            else:
                value = SYMBOLIC[operation.kind](*map(find, operation.operands))
            if operation.result.startswith("_"):
                values[operation.result] = value
            else:
                symbol = sp.Symbol(operation.result, real=True)
                self._steps[symbol] = value
                values[operation.result] = symbol
        return tuple(map(find, spelled.outputs))


class _Axes:
    """The axes of arrays, as the indices of the quantity's sums."""

    kinds = ("sum", *VIEWS)

    def __init__(self, quantity: Quantity) -> None:
        sums = quantity.definition.atoms(sp.Sum)
        limits = max((total.limits for total in sums), key=len, default=())
        self.indices = tuple(index for index, *_ in reversed(limits))
        self._limits = {index: (index, *ends) for index, *ends in limits}

    def apply(self, kind: str, value: sp.Expr, operands: tuple[Operand, ...]) -> sp.Expr:
        """Return the result of an operation on axes for a value indexed by the last of them."""
        first, last = self.indices[0], self.indices[-1]
        if kind == "sum":
            count = int(operands[1])
            used = self.indices[:count] if count == len(self.indices) else self.indices[-count:]
            return sp.Sum(value, *(self._limits[index] for index in reversed(used)))
        if kind == "along_first":
            return value.xreplace({last: first})
        if kind == "transpose":
            return value.xreplace({first: last, last: first})
        if kind == "diagonal":
            return value.xreplace({first: last})
        return value


def _name_inputs(
    quantity: Quantity, code: KernelCode, stage: Stage, axes: _Axes
) -> dict[str, sp.Expr]:
    """Map names in the source to symbols of the quantity, and arrays to their elements."""
    found: dict[str, sp.Expr] = {}
    counts, parts = dict(code.indexed), dict(code.vectors)
    for argument in quantity.arguments:
        symbol = argument.symbols[0]
        if isinstance(symbol, sp.IndexedBase):
            found[argument.name] = symbol[axes.indices[-counts[argument.name] :]]
        elif argument.name in parts:
            found |= dict(zip(parts[argument.name], argument.symbols, strict=True))
        else:
            found[argument.name] = symbol
    return found


def _check_turns(program: Program) -> None:
    """Raise ValueError unless an angle less whole turns is used only by sines and cosines."""
    angles: set[Operand] = set()
    for operation in program.operations:
        uses = angles.intersection(operation.operands)
        if operation.kind == "whole_turns_off" or (uses and operation.kind in ("single", "copy")):
            angles.add(operation.result)
        elif uses and operation.kind not in PERIODIC:
            raise ValueError(f"{operation.kind} of an angle reduced by whole turns")
    if angles.intersection(program.outputs):
        raise ValueError("an angle reduced by whole turns is an output")
