"""Tracing: in, a Python function of values; out, the operations that it performs on them.

Python itself decides precedence, scope and the order of evaluation. A function that asks whether a
value is true is run once for each answer; JAX (Frostig, Johnson and Leary 2018), which traces in
the same way, refuses such functions.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from types import EllipsisType, FunctionType, MappingProxyType
from typing import Any

from mechproof.programs.operations import KINDS, Arithmetic
from mechproof.programs.program import (
    TEMPORARY,
    Operand,
    Operation,
    Program,
    is_unnamed,
)

# The most ways through a function: one with more is no formula.
MOST_WAYS = 64
# Texts that some kinds of operation take as an extra last operand.
Last = Mapping[str, str]


@dataclass(frozen=True)
class RecordedFunction:
    """A recorded function: parameters, decorator, defaults, and a program for each way through."""

    inputs: tuple[str, ...]
    decorator: str
    defaults: tuple[Any, ...]
    ways: tuple[Program, ...]


def _operate(kind: str, *, is_last: bool = False) -> Callable[[Value, Any], Value]:
    """Return an operator's method, which takes its value as the first or as the last operand."""

    def operate(value: Value, other: Any) -> Value:
        return value.apply(kind, *((other, value) if is_last else (value, other)))

    return operate


class Value:
    """A number that a function computes, which records every operation on it."""

    def __init__(self, tape: Tape, operand: Any) -> None:
        self._tape, self.operand = tape, operand

    def apply(self, kind: str, *operands: Any) -> Value:
        """Record an operation and return its result."""
        return self._tape.record(kind, *operands)

    def __neg__(self) -> Value:
        is_number = isinstance(self.operand, int | float)
        return self._tape.value(-self.operand) if is_number else self.apply("negate", self)

    __add__, __radd__ = _operate("add"), _operate("add", is_last=True)
    __sub__, __rsub__ = _operate("subtract"), _operate("subtract", is_last=True)
    __mul__, __rmul__ = _operate("multiply"), _operate("multiply", is_last=True)
    __truediv__, __rtruediv__ = _operate("divide"), _operate("divide", is_last=True)
    __gt__, __lt__ = _operate("greater"), _operate("less")
    __ge__, __le__ = _operate("greater_equal"), _operate("less_equal")
    __and__, __or__ = _operate("both"), _operate("either")

    def __abs__(self) -> Value:
        return self.apply("absolute", self)

    def __eq__(self, other: object) -> Any:
        return self.apply("equal", self, other)

    __hash__ = object.__hash__

    def __pow__(self, other: Any) -> Value:
        return self.apply("square", self) if show(other) == 2 else self.apply("power", self, other)

    def __getitem__(self, key: Any) -> Value:
        view = VIEWS.get(show(key))
        return self.apply(view, self) if view else self.apply("item", self, key)

    def __bool__(self) -> bool:
        return self._tape.decide(self)

    def __iter__(self) -> Iterator[Value]:
        yield self.apply("unpack", self)

    def __enter__(self) -> Value:
        return self.apply("enter", self)

    def __exit__(self, *_: object) -> None:
        self.apply("exit", self)

    def __getattr__(self, name: str) -> Callable[..., Value]:
        return partial(self.apply, name, self)


class Tape:
    """The record of operations on values, for one function after the other."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self._answers: list[bool] = []
        self._known: Iterator[bool] = iter(())

    def value(self, operand: float | str) -> Value:
        """Return the value of a number or a name."""
        return Value(self, operand)

    def values(self, operands: Iterable[float | str]) -> tuple[Value, ...]:
        """Return the values of numbers and names."""
        return tuple(map(self.value, operands))

    def record(self, kind: str, /, *given: Any, **named: Any) -> Value:
        """Record an operation and return its result; keyword operands come last, named."""
        for value in given if kind in KINDS else ():
            if callable(value):
                raise ValueError(f"{show(value)} is decorated by _{kind}")
        operands = (*map(show, given), *((name, show(value)) for name, value in named.items()))
        result = f"{TEMPORARY}{len(self.operations) + 1}"
        self.operations.append(Operation(result, kind, operands))
        return self.value(result)

    def assign(self, target: str | tuple[str, ...], value: Any) -> Any:
        """Name the last result, or unpack it to several names; any other value is copied."""
        kind: str = "copy"
        operands: tuple[Operand, ...] = (show(value),)
        last = self.operations[-1] if self.operations else None
        if last and show(value) == last.result == f"{TEMPORARY}{len(self.operations)}":
            self.operations.pop()
            kind, operands = last.kind, last.operands
        self.operations.append(Operation(str(target), kind, operands))
        return self.value(target) if isinstance(target, str) else self.values(target)

    def decide(self, condition: Value) -> bool:
        """Return whether a value is true: by the next preset answer, or yes if there is none."""
        answer = next(self._known, None)
        if answer is None:
            self._answers.append(answer := True)
        self.record("decide", condition, answer)
        return answer

    def run(
        self,
        function: Callable[..., Any],
        inputs: Iterable[str] = (),
        decorator: str = "",
        defaults: tuple[Any, ...] = (),
    ) -> RecordedFunction:
        """Record every way through a function, first with yes to every decision.

        Raises ValueError for more than `MOST_WAYS`.
        """
        inputs, self._answers = tuple(inputs), []
        ways: list[Program] = []
        while len(ways) < MOST_WAYS:
            self.operations, self._known = [], iter(tuple(self._answers))
            outputs = show(function(*self.values(inputs)))
            ways.append(Program(inputs, tuple(self.operations), (outputs,)))
            while self._answers and not self._answers[-1]:
                self._answers.pop()
            if not self._answers:
                return RecordedFunction(inputs, decorator, defaults, tuple(ways))
            self._answers[-1] = False
        raise ValueError(f"there are more than {MOST_WAYS} ways through it")

    def replay(self, program: Program, last: Last = MappingProxyType({})) -> tuple[Any, ...]:
        """Record a program and return its outputs; `last` has extra last operands by kind."""
        program, made = program.normal_form(), dict[Any, Any]()
        for step in program.operations:
            given = [made.get(operand, operand) for operand in step.operands]
            given += [last[step.kind]] if step.kind in last else []
            value = given[0] if step.kind == "copy" else self.record(step.kind, *given)
            name = step.result
            made[name] = value if is_unnamed(name) else self.assign(name, value)
        return tuple(made.get(output, output) for output in program.outputs)


def show(value: Any) -> Any:
    """Return a value as an operand: a name, a number or a tuple; ValueError for anything else."""
    match value:
        case Value():
            return value.operand
        case tuple() | list():
            return tuple(map(show, value))
        case slice(start=start, stop=stop, step=step):
            return "slice", show(start), show(stop), show(step)
        case FunctionType():
            return value.__name__
        case partial(args=(str() as name, *_)):
            return name
        case None | bool() | EllipsisType():
            return repr(value)
        case int() | float() | str():
            return value
    raise ValueError(f"{value!r} is not a value")


# Indices that view a vector along the first or the last of two axes.
VIEWS = {
    show((..., slice(None), None)): "along_first",
    show((..., None, slice(None))): "along_last",
}


def _record(kind: str, first: Value, *others: Any) -> Value:
    return first.apply(kind, first, *others)


# Every kind is recorded as a single operation, even if its meaning is composed of others.
TRACED = Arithmetic({kind: partial(_record, kind) for kind in KINDS})
# Operations of the machine, for use in traced functions.
Recorded = Callable[..., Value]
fma: Recorded = TRACED["fma"]
multiply_add: Recorded = TRACED["multiply_add"]
maximum: Recorded = TRACED["maximum"]
rint: Recorded = TRACED["rint"]
floor: Recorded = TRACED["floor"]
power_of_two: Recorded = TRACED["power_of_two"]
root: Recorded = TRACED["sqrt"]
choose: Recorded = TRACED["choose"]


def copysign(a: Value | float, b: Value) -> Value:
    """Return |a| with the sign of b."""
    return b.apply("copysign", a, b)


# The most terms of a polynomial that is computed by Horner's rule in a single chain.
CHAIN = 7


def polynomial(z: Value, coefficients: Sequence[float]) -> Value | float:
    """Return the polynomial in z, coefficients lowest power first, by Horner's rule.

    In a long one, pairs of terms are joined first, independently of each other, into a polynomial
    in z**2. One product halves the chain; halving it again and again (Estrin 1960) would take a
    product each time.
    """
    terms: list[Value | float] = list(coefficients)
    if len(terms) > CHAIN:
        pairs = zip(terms[::2], terms[1::2], strict=False)
        joined: list[Value | float] = [multiply_add(z, high, low) for low, high in pairs]
        terms, z = joined + terms[len(terms) - len(terms) % 2 :], z * z
    *others, value = terms
    for term in reversed(others):
        value = multiply_add(z, value, term)
    return value


def trace(function: Callable[..., Value], inputs: tuple[str, ...]) -> Program:
    """Return the program of a function without decisions; results used more than once get names."""
    (program,) = Tape().run(function, inputs).ways
    return _name_repeated(program).normal_form()


def _name_repeated(program: Program) -> Program:
    """Name the results that are used more than once, as a temporary may be used only once."""
    uses = Counter(o for step in program.operations for o in step.operands)
    repeated = [s.result for s in program.operations if uses[s.result] > 1]
    names: dict[Operand, str] = {name: f"v{i}" for i, name in enumerate(repeated, start=1)}
    return program.rename(names)
