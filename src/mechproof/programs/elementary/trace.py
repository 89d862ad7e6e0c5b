"""Tracing: in, a Python function of values; out, its program, operation by operation.

Arithmetic on a `Value` adds an operation; what is used more than once gets a name.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial

from mechproof.programs.operations import KINDS, Arithmetic
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program


class Value:
    """A number that a program computes."""

    def __init__(self, operations: list[Operation], operand: Operand) -> None:
        self._operations = operations
        self.operand = operand

    def apply(self, kind: str, *operands: Value | float) -> Value:
        """Add an operation and return its result."""
        result = f"{TEMPORARY}{len(self._operations) + 1}"
        used = tuple(o.operand if isinstance(o, Value) else o for o in operands)
        self._operations.append(Operation(result, kind, used))
        return Value(self._operations, result)

    def __add__(self, other: Value | float) -> Value:
        return self.apply("add", self, other)

    def __radd__(self, other: float) -> Value:
        return self.apply("add", other, self)

    def __sub__(self, other: Value | float) -> Value:
        return self.apply("subtract", self, other)

    def __rsub__(self, other: float) -> Value:
        return self.apply("subtract", other, self)

    def __mul__(self, other: Value | float) -> Value:
        return self.apply("multiply", self, other)

    def __rmul__(self, other: float) -> Value:
        return self.apply("multiply", other, self)

    def __truediv__(self, other: Value | float) -> Value:
        return self.apply("divide", self, other)

    def __rtruediv__(self, other: float) -> Value:
        return self.apply("divide", other, self)

    def __neg__(self) -> Value:
        return self.apply("negate", self)

    def __abs__(self) -> Value:
        return self.apply("absolute", self)

    def __gt__(self, other: Value | float) -> Value:
        return self.apply("greater", self, other)

    def __lt__(self, other: Value | float) -> Value:
        return self.apply("less", self, other)

    def __ge__(self, other: Value | float) -> Value:
        return self.apply("greater_equal", self, other)

    def __le__(self, other: Value | float) -> Value:
        return self.apply("less_equal", self, other)

    def equals(self, other: Value | float) -> Value:
        """Return the operation that compares; `==` compares the values of this class."""
        return self.apply("equal", self, other)


def fma(a: Value, b: Value | float, c: Value | float) -> Value:
    """Return a*b + c with one rounding."""
    return a.apply("fma", a, b, c)


def maximum(a: Value, b: Value | float) -> Value:
    """Return the larger number, NaN if one is."""
    return a.apply("maximum", a, b)


def rint(a: Value) -> Value:
    """Return the whole number next to a."""
    return a.apply("rint", a)


def floor(a: Value) -> Value:
    """Return the largest whole number that is not above a."""
    return a.apply("floor", a)


def power_of_two(n: Value) -> Value:
    """Return 2**n for a whole number n, where that is a normal number."""
    return n.apply("power_of_two", n)


def root(a: Value) -> Value:
    """Return the square root of a."""
    return a.apply("sqrt", a)


def choose(condition: Value, a: Value | float, b: Value | float) -> Value:
    """Return a where the condition holds, b elsewhere."""
    return condition.apply("choose", condition, a, b)


def copysign(a: Value | float, b: Value) -> Value:
    """Return |a| with the sign of b."""
    return b.apply("copysign", a, b)


def _record(kind: str, first: Value, *others: Value | float) -> Value:
    return first.apply(kind, first, *others)


# Every kind is one operation, whatever it is put together of.
TRACED = Arithmetic({kind: partial(_record, kind) for kind in KINDS})

# So many terms of a polynomial may wait for each other.
CHAIN = 7


def polynomial(z: Value, coefficients: Sequence[float]) -> Value | float:
    """Return the polynomial in z, coefficients lowest power first, by Horner's rule.

    A long one is put into pairs, which do not wait for each other, in powers of z**2: half the
    steps for one product, where halving on (Estrin 1960) takes a product for each power.
    """
    terms: list[Value | float] = list(coefficients)
    if len(terms) > CHAIN:
        pairs = zip(terms[::2], terms[1::2], strict=False)
        joined: list[Value | float] = [fma(z, high, low) for low, high in pairs]
        terms, z = joined + terms[len(terms) - len(terms) % 2 :], z * z
    *others, value = terms
    for term in reversed(others):
        value = fma(z, value, term)
    return value


def trace(function: Callable[..., Value], inputs: tuple[str, ...]) -> Program:
    """Return the program of a function of values."""
    operations: list[Operation] = []
    result = function(*(Value(operations, name) for name in inputs)).operand
    return _name_repeated(Program(inputs, tuple(operations), (result,))).normal_form()


def _name_repeated(program: Program) -> Program:
    """Name what is used more than once: a temporary stands where it is used, and only there."""
    uses = Counter(o for step in program.operations for o in step.operands)
    repeated = [s.result for s in program.operations if uses[s.result] > 1]
    names: dict[Operand, str] = {name: f"v{i}" for i, name in enumerate(repeated, start=1)}
    operations = tuple(
        Operation(
            names.get(step.result, step.result),
            step.kind,
            tuple(names.get(o, o) for o in step.operands),
        )
        for step in program.operations
    )
    outputs = tuple(names.get(o, o) for o in program.outputs)
    return Program(program.inputs, operations, outputs)
