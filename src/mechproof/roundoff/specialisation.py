"""Cases: in, the program of an elementary function and what it decides; out, its plain steps.

A whole number of quarter turns is known but for whole turns, which change no decision. What is left
of the angle is an input of its own, `REST`, and so is the size of an argument. That is partial
evaluation (Jones, Gomard and Sestoft 1993) by facts about an angle.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import floor
from types import MappingProxyType

from mechproof.programs.program import Operand, Operation, Program
from mechproof.roundoff.steps import Step, StraightLineProgram, keep_needed, make_step

# An angle less its quarter turns.
REST = "rest"
# Numbers of quarter turns have so many parts, and no more is added: doubles without a rounding.
PARTS, MOST_ADDED = 8, 8


def name_size(name: str) -> str:
    """Name the absolute value of an argument, which is an input, too."""
    return f"|{name}|"


@dataclass(frozen=True)
class Whole:
    """A number: so many for each whole turn, whatever their number, and a count."""

    each: Fraction
    count: Fraction

    def __post_init__(self) -> None:
        parts = [number * PARTS for number in (self.each, self.count)]
        if any(p.denominator != 1 or abs(p) > PARTS * MOST_ADDED for p in parts):
            raise ValueError(f"{self.each} for each turn and {self.count} may be rounded")

    def times(self, factor: float) -> Whole:
        """Return a multiple, whole or not."""
        return Whole(self.each * Fraction(factor), self.count * Fraction(factor))

    def plus(self, more: float) -> Whole:
        """Return the number and so many."""
        return replace(self, count=self.count + Fraction(more))

    def rounded(self, to: Callable[[Fraction], int]) -> Whole:
        """Round to a whole number; an even number for each turn keeps what a half is rounded to."""
        if self.each.denominator != 1 or (to is round and self.each % 2):
            raise ValueError(f"{self.each} for each turn decides what rounding does")
        return replace(self, count=Fraction(to(self.count)))


@dataclass(frozen=True)
class Case:
    """What a program decides: the number of quarter turns, whether one size is the larger.

    Also whether the second argument is negative. No larger size is zero.
    """

    number: Whole | None = None
    is_larger: bool = False
    is_behind: bool = False


@dataclass(frozen=True)
class Resolved:
    """Steps without decisions; how the number is found and which words are taken off by it."""

    straight: StraightLineProgram
    per: float
    words: tuple[float, ...]


def resolve(program: Program, case: Case) -> Resolved:
    """Return the steps of a program in a case; ValueError for what no rule decides."""
    return _Resolver(program, case).resolve()


class _Resolver:
    def __init__(self, program: Program, case: Case) -> None:
        self._program, self._case = program, case
        self._facts: dict[str, Whole | bool] = {}
        # Of what is the angle less the number times words, these words.
        self._chains: dict[str, tuple[float, ...]] = {}
        self._names: dict[Operand, Operand] = {}
        self._steps: list[Step] = []
        self._sizes = {name: name_size(name) for name in program.inputs}
        # What has the sign of an argument, and no other size than a number.
        self._signs: dict[str, Operand] = {}
        self._per: set[float] = set()
        self._words: set[tuple[float, ...]] = set()

    def resolve(self) -> Resolved:
        for operation in self._program.operations:
            rule = _RULES.get(operation.kind)
            if not (rule and rule(self, operation)):
                self._append(operation)
        outputs = tuple(self._find(o) for o in self._program.outputs)
        straight = keep_needed(
            StraightLineProgram(self._program.inputs, tuple(self._steps), outputs)
        )
        if len(self._per) > 1 or len(self._words) > 1:
            raise ValueError("an angle is reduced in more than one way")
        return Resolved(straight, max(self._per, default=0.0), max(self._words, default=()))

    def _find(self, operand: Operand) -> Operand:
        if isinstance(operand, str) and (words := self._chains.get(operand)):
            self._words.add(words)
            return REST
        if operand in self._facts:
            raise ValueError(f"{operand} is computed with, but is a decision")
        return self._names.get(operand, operand)

    def _append(self, operation: Operation) -> None:
        operands = tuple(self._find(o) for o in operation.operands)
        self._steps.append(make_step(replace(operation, operands=operands)))

    def _decide(self, operation: Operation) -> bool:
        first, second = (self._facts.get(str(o)) for o in (*operation.operands, "")[:2])
        if isinstance(first, Whole) and isinstance(second, Whole):
            self._facts[operation.result] = first == second
            return True
        # No larger size is zero (`Case`).
        if self._find(operation.operands[0]) == self._find_larger() and operation.operands[1] == 0:
            self._facts[operation.result] = False
            return True
        return False

    def _find_larger(self) -> Operand:
        return list(self._sizes.values())[0 if self._case.is_larger else -1]

    def _compare_sign(self, operation: Operation) -> bool:
        signed, zero = operation.operands
        if self._signs.get(str(signed)) != self._program.inputs[-1] or zero != 0:
            raise ValueError(f"{operation}: only the last argument is compared with zero")
        self._facts[operation.result] = self._case.is_behind
        return True

    def _compare(self, operation: Operation) -> bool:
        # Both are doubles that were given: no rounding has a part in this.
        if [self._find(o) for o in operation.operands] != list(self._sizes.values()):
            raise ValueError(f"{operation}: only the sizes of both arguments are compared")
        self._facts[operation.result] = self._case.is_larger
        return True

    def _compute(self, operation: Operation) -> bool:
        first, second = operation.operands
        whole = self._facts.get(str(first))
        if whole is None and operation.kind == "add" and self._find(first) == 0:
            # The sum is exact, and what is added alone.
            self._names[operation.result] = self._find(second)
            return True
        if not isinstance(whole, Whole) or isinstance(second, str):
            return False
        self._facts[operation.result] = _COMPUTE[operation.kind](whole, second)
        return True

    def _round(self, operation: Operation) -> bool:
        (operand,) = operation.operands
        known = self._facts.get(str(operand))
        if isinstance(known, Whole):
            self._facts[operation.result] = known.rounded(_ROUND[operation.kind])
            return True
        made = next(s for s in self._steps if s.result == operand)
        angle, per = made.operands
        if self._case.number is None or made.kind != "multiply" or isinstance(per, str):
            return False
        if angle != self._program.inputs[0] or operation.kind != "rint":
            return False
        self._per.add(float(per))
        self._facts[operation.result] = self._case.number
        return True

    def _take_off(self, operation: Operation) -> bool:
        number, word, rest = operation.operands
        known = self._facts.get(str(number))
        if known is None or known != self._case.number or isinstance(word, str):
            return False
        if rest != self._program.inputs[0] and rest not in self._chains:
            return False
        before = self._chains.get(str(rest), ())
        self._chains[operation.result] = (*before, float(word))
        return True

    def _choose(self, operation: Operation) -> bool:
        condition, one, other = operation.operands
        self._names[operation.result] = self._find(one if self._facts[str(condition)] else other)
        return True

    def _take_size(self, operation: Operation) -> bool:
        (operand,) = operation.operands
        self._names[operation.result] = self._sizes[str(operand)]
        return True

    def _take_sign(self, operation: Operation) -> bool:
        # Of the sign of an argument nothing else depends: what is left is the size of the result.
        size, sign = operation.operands
        if sign not in self._program.inputs:
            raise ValueError(f"{operation}: only signs of arguments are put on results")
        self._names[operation.result] = self._find(size)
        if not isinstance(size, str) and size:
            self._signs[operation.result] = sign
        return True


_ROUND: Mapping[str, Callable[[Fraction], int]] = {"rint": round, "floor": floor}
_COMPUTE: Mapping[str, Callable[[Whole, float], Whole]] = {
    "multiply": Whole.times,
    "add": Whole.plus,
}
_RULES: Mapping[str, Callable[[_Resolver, Operation], bool]] = MappingProxyType(
    {
        "rint": _Resolver._round,
        "floor": _Resolver._round,
        "equal": _Resolver._decide,
        "greater": _Resolver._compare,
        "less": _Resolver._compare_sign,
        "multiply": _Resolver._compute,
        "add": _Resolver._compute,
        "fma": _Resolver._take_off,
        "choose": _Resolver._choose,
        "absolute": _Resolver._take_size,
        "copysign": _Resolver._take_sign,
    }
)
