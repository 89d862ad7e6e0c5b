"""Cases: in, an elementary function's program and its decisions; out, its steps without decisions.

The number of quarter turns is known up to whole turns, which change no decision. The reduced angle
becomes an input of its own, `REST`, and so does the absolute value of an argument. This is partial
evaluation (Jones, Gomard and Sestoft 1993) by facts about an angle.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import floor
from types import MappingProxyType
from typing import TypeGuard

from mechproof.programs.program import Operand, Program
from mechproof.roundoff.steps import Step, StraightLineProgram, keep_needed, make_step

# The name of the input for an angle less its quarter turns.
REST = "rest"
# Numbers of quarter turns are multiples of 1/PARTS, at most MOST_ADDED in size, so that doubles add
# and multiply them without rounding.
PARTS, MOST_ADDED = 8, 8


def name_size(name: str) -> str:
    """Return the name of the input for the absolute value of an argument."""
    return f"|{name}|"


@dataclass(frozen=True)
class Whole:
    """A number equal to `each` times an unknown number of whole turns, plus `count`."""

    each: Fraction
    count: Fraction

    def __post_init__(self) -> None:
        parts = [number * PARTS for number in (self.each, self.count)]
        if any(p.denominator != 1 or abs(p) > PARTS * MOST_ADDED for p in parts):
            raise ValueError(f"{self.each} per turn plus {self.count} may be rounded")

    def times(self, factor: float) -> Whole:
        """Return the number times a factor, which need not be whole."""
        return Whole(self.each * Fraction(factor), self.count * Fraction(factor))

    def plus(self, more: float) -> Whole:
        """Return the number with a summand added to its count."""
        return replace(self, count=self.count + Fraction(more))

    def rounded(self, to: Callable[[Fraction], int]) -> Whole:
        """Round to a whole number; an even `each` rounds ties alike, whatever the turns."""
        if self.each.denominator != 1 or (to is round and self.each % 2):
            raise ValueError(f"{self.each} per turn: rounding depends on the number of turns")
        return replace(self, count=Fraction(to(self.count)))


@dataclass(frozen=True)
class Case:
    """The facts a program decides by: the number of quarter turns, which size is the larger.

    `is_larger` means that the first size is, `is_left` that the second argument is negative.
    The larger size is never zero.
    """

    number: Whole | None = None
    is_larger: bool = False
    is_left: bool = False


@dataclass(frozen=True)
class Resolved:
    """Steps without decisions; the factor that counts quarter turns, and the words subtracted."""

    straight: StraightLineProgram
    per: float
    words: tuple[float, ...]


def resolve(program: Program, case: Case) -> Resolved:
    """Return the steps of a program in a case; ValueError for a decision that no rule covers."""
    return _Resolver(program, case).resolve(program)


@dataclass(frozen=True)
class _Signed:
    """A number with the sign of an argument."""

    size: float
    sign: Operand


# What is known of a result: a count of turns, a decision, the words subtracted from an angle, a
# number with an argument's sign, or the operand that holds its value.
_Known = Whole | bool | tuple[float, ...] | _Signed | Operand


def _is_number(value: _Known) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


class _Resolver:
    def __init__(self, program: Program, case: Case) -> None:
        self._inputs, self._case = program.inputs, case
        self._sizes = {name: name_size(name) for name in program.inputs}
        self._steps: list[Step] = []
        self._per: set[float] = set()
        self._words: set[tuple[float, ...]] = set()

    def resolve(self, program: Program) -> Resolved:
        known: dict[Operand, _Known] = {}
        for operation in program.operations:
            given = [known.get(operand, operand) for operand in operation.operands]
            rule = _RULES.get(operation.kind)
            found = rule(self, operation.kind, *given) if rule else None
            if found is None:
                operands = tuple(map(self._take, given))
                self._steps.append(make_step(replace(operation, operands=operands)))
                found = operation.result
            known[operation.result] = found
        outputs = tuple(self._take(known.get(output, output)) for output in program.outputs)
        straight = keep_needed(StraightLineProgram(self._inputs, tuple(self._steps), outputs))
        if len(self._per) > 1 or len(self._words) > 1:
            raise ValueError("an angle is reduced in more than one way")
        return Resolved(straight, max(self._per, default=0.0), max(self._words, default=()))

    def _take(self, value: _Known) -> Operand:
        """Return the operand for a value in the steps; ValueError for a count or a decision."""
        if isinstance(value, tuple):
            self._words.add(value)
            return REST
        if isinstance(value, Whole | bool):
            raise ValueError(f"{value} is a decision, but is used as a number")
        return value.size if isinstance(value, _Signed) else value

    def _decide(self, kind: str, first: _Known, second: _Known) -> bool | None:
        if isinstance(first, Whole) and isinstance(second, Whole):
            return first == second
        # The larger size is never zero (`Case`).
        larger = list(self._sizes.values())[0 if self._case.is_larger else -1]
        is_zero = _is_number(second) and second == 0
        return False if self._take(first) == larger and is_zero else None

    def _compare_sign(self, kind: str, signed: _Known, zero: _Known) -> bool:
        is_last = isinstance(signed, _Signed) and signed.sign == self._inputs[-1]
        if not (is_last and _is_number(zero) and zero == 0):
            raise ValueError(f"{signed} < {zero}: only the last argument is compared with zero")
        return self._case.is_left

    def _compare(self, kind: str, *given: _Known) -> bool:
        # Both are inputs, so no rounding can change how they compare.
        if [*map(self._take, given)] != list(self._sizes.values()):
            raise ValueError(f"{given}: only the sizes of both arguments are compared")
        return self._case.is_larger

    def _compute(self, kind: str, first: _Known, second: _Known) -> _Known | None:
        if isinstance(first, Whole):
            return _COMPUTE[kind](first, second) if _is_number(second) else None
        # Adding to zero is exact and leaves the other operand.
        return self._take(second) if kind == "add" and self._take(first) == 0 else None

    def _round(self, kind: str, value: _Known) -> Whole | None:
        if isinstance(value, Whole):
            return value.rounded(_ROUND[kind])
        made = next((step for step in self._steps if step.result == value), None)
        if made is None or made.kind != "multiply" or kind != "rint":
            return None
        angle, per = made.operands
        if self._case.number is None or isinstance(per, str) or angle != self._inputs[0]:
            return None
        self._per.add(float(per))
        return self._case.number

    def _take_off(
        self, kind: str, number: _Known, word: _Known, rest: _Known
    ) -> tuple[float, ...] | None:
        before = () if rest == self._inputs[0] else rest
        is_chain = isinstance(number, Whole) and number == self._case.number
        if not (is_chain and _is_number(word) and isinstance(before, tuple)):
            return None
        return (*before, float(word))

    def _choose(self, kind: str, condition: _Known, one: _Known, other: _Known) -> Operand:
        if not isinstance(condition, bool):
            raise ValueError(f"{condition} is not decided")
        return self._take(one if condition else other)

    def _take_size(self, kind: str, value: _Known) -> str:
        return self._sizes[str(value)]

    def _take_sign(self, kind: str, size: _Known, sign: _Known) -> _Known:
        # Nothing else depends on the sign of an argument, so only the size is passed on.
        if sign not in self._inputs:
            raise ValueError(f"{sign}: only signs of arguments can be given to results")
        value = self._take(size)
        return value if isinstance(value, str) or not value else _Signed(value, str(sign))


_ROUND: Mapping[str, Callable[[Fraction], int]] = {"rint": round, "floor": floor}
_COMPUTE: Mapping[str, Callable[[Whole, float], Whole]] = {
    "multiply": Whole.times,
    "add": Whole.plus,
}
_RULES: Mapping[str, Callable[..., _Known | None]] = MappingProxyType(
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
