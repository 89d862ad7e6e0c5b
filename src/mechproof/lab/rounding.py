"""Rounding: a program in balls, each operation with the error that doubles may make in it.

What the ball of a result does not hold, no order of roundings can have given: the source that was
run is not the program. The arithmetic of IEEE 754 is rounded to nearest; of NumPy's functions
every loop is taken to stay within `LOOPS` ulps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from flint import arb

from mechproof.codegen.code import Stage
from mechproof.codegen.program import VIEWS, Operand, Operation, Program, spell_out_forms
from mechproof.lab.ways import Array
from mechproof.proof.balls import working_precision

BITS = 192
# Half an ulp of a double and of a float32, relative.
UNIT, SINGLE_UNIT = 2.0**-53, 2.0**-24
SMALLEST = 2.0**-1074
LOOPS = 4
ROUNDED = (
    "add", "subtract", "multiply", "divide", "fma", "square", "sqrt", "quotient_rest", "single",
)  # fmt: skip
EXACT = (
    "negate", "absolute", "copysign", "maximum", "floor", "rint", "sign", "copy", "product_rest",
    "sum_rest", "nonnegative",
)  # fmt: skip
# As the doubles that a kernel takes them for.
CONSTANTS: Mapping[str, arb] = MappingProxyType(
    {"#pi": arb(np.pi), "#e": arb(np.e), "#inf": arb("inf"), "#nan": arb("nan")}
)
COMPARISONS: Mapping[str, Callable[[arb, arb], bool]] = MappingProxyType(
    {
        "less": lambda a, b: a < b,
        "less_equal": lambda a, b: a <= b,
        "greater": lambda a, b: a > b,
        "greater_equal": lambda a, b: a >= b,
        "equal": lambda a, b: a == b,
    }
)
OPPOSITE = MappingProxyType(
    {
        "less": "greater_equal",
        "less_equal": "greater",
        "greater": "less_equal",
        "greater_equal": "less",
    }
)


def _tangent_quotient(y: arb, a: arb, b: arb) -> arb:
    t = y.tan()
    return t / (a + b * t * t) if t.is_finite() else arb("nan")


FUNCTIONS: Mapping[str, Callable[..., arb]] = MappingProxyType(
    {
        "add": lambda a, b: a + b,
        "subtract": lambda a, b: a - b,
        "multiply": lambda a, b: a * b,
        "divide": lambda a, b: a / b,
        "fma": lambda a, b, c: a * b + c,
        "negate": lambda a: -a,
        "square": lambda a: a * a,
        "power": lambda a, b: a**b,
        "sqrt": lambda a: a.sqrt(),
        "sin": lambda a: a.sin(),
        "cos": lambda a: a.cos(),
        "tan": lambda a: a.tan(),
        "arcsin": lambda a: a.asin(),
        "arccos": lambda a: a.acos(),
        "arctan": lambda a: a.atan(),
        "arctan2": lambda a, b: arb.atan2(a, b),
        "exp": lambda a: a.exp(),
        "log": lambda a: a.log(),
        "hypot": lambda a, b: (a * a + b * b).sqrt(),
        "absolute": abs,
        "maximum": lambda a, b: a.max(b),
        "floor": lambda a: a.floor(),
        "rint": lambda a: (a + arb(0.5)).floor(),
        "copysign": lambda a, b: abs(a) * b.sgn(),
        "sign": lambda a: a.sgn(),
        "copy": lambda a: a,
        "single": lambda a: a,
        "product_rest": lambda a, b, p: a * b - p,
        "sum_rest": lambda a, b, s: a + b - s,
        "quotient_rest": lambda a, b, q: a / b - q,
        "small_tangent": lambda a: a.tan(),
        "tangent_quotient": _tangent_quotient,
        "small_arctan": lambda a: a.atan(),
        "nonnegative": lambda total, size: total.union(arb(0)) if total < 0 else total,
        "tangent_above": lambda y: y.sin(),
        "tangent_below": lambda y: y.cos(),
        "arctan_quotient": lambda a, b: (a / b).atan(),
    }
)


def enclose_stage(stage: Stage, inputs: Mapping[str, float | Array]) -> list[arb]:
    """Return balls that hold whatever doubles the stage computes of its inputs.

    `inputs` are numbers, or arrays where an axis is summed over. An undecided branch gives both.
    """
    with working_precision(BITS):
        known = {name: _as_balls(value) for name, value in inputs.items()}
        prepared = _run(stage.prepare, known)
        if stage.evaluate is None:
            return _map_affinely(prepared, [known[name] for name in stage.running])
        given = (*(known[name] for name in stage.running), *prepared)
        return _run(stage.evaluate, dict(zip(stage.evaluate.inputs, given, strict=True)))


def decide(condition: Program, inputs: Mapping[str, float | Array]) -> bool:
    """Return whether a condition on the inputs is certainly true."""
    with working_precision(BITS):
        known = {name: _as_balls(value) for name, value in inputs.items()}
        (result,) = _run(condition, known)
        return result is True


def _as_balls(value: float | Array) -> Any:
    return np.frompyfunc(lambda v: arb(float(v)), 1, 1)(np.asarray(value, float))


def _run(program: Program, known: Mapping[str, Any]) -> list[Any]:
    values: dict[str, Any] = {**known, **CONSTANTS}
    single: set[str] = set()

    def find(operand: Operand) -> Any:
        return values[operand] if isinstance(operand, str) else arb(operand)

    program = spell_out_forms(program)
    for step in program.operations:
        named = [operand for operand in step.operands if isinstance(operand, str)]
        if step.kind == "single" or (named and single.issuperset(named)):
            single.add(step.result)
        values[step.result] = _operate(step, find, step.result in single)
    return [find(output) for output in program.outputs]


def _operate(step: Operation, find: Callable[[Operand], Any], single: bool) -> Any:
    kind, operands = step.kind, step.operands
    if kind in VIEWS:
        return _view(kind, find(operands[0]))
    if kind == "sum":
        return _sum(find(operands[0]))
    if kind == "whole_turns_off":
        return np.frompyfunc(_take_turns_off, 1, 1)(find(operands[0]))
    values = tuple(map(find, operands))
    if kind in COMPARISONS:
        return np.frompyfunc(lambda a, b: _compare(kind, a, b), 2, 1)(*values)
    if kind == "both":
        return np.frompyfunc(lambda a, b: a and b, 2, 1)(*values)
    if kind == "either":
        return np.frompyfunc(lambda a, b: a or b, 2, 1)(*values)
    if kind == "choose":
        return np.frompyfunc(_choose, 3, 1)(*values)
    exact = np.frompyfunc(FUNCTIONS[kind], len(values), 1)(*values)
    unit = SINGLE_UNIT if single else UNIT
    loss = 0.0 if kind in EXACT else unit if kind in ROUNDED else 2 * LOOPS * unit
    if kind == "tangent_quotient":
        return np.frompyfunc(lambda q, y, a, b: _spread_quotient(q, a, b, loss), 4, 1)(
            exact, *values
        )
    return np.frompyfunc(lambda ball: _spread(ball, loss), 1, 1)(exact)


def _spread(ball: arb, relative: float) -> arb:
    """Return the ball with room for a relative error, and for one below the least double."""
    if not relative:
        return ball
    return (
        ball + arb(0, float(abs(ball).upper()) * relative + SMALLEST) if ball.is_finite() else ball
    )


def _spread_quotient(quotient: arb, a: arb, b: arb, relative: float) -> arb:
    """Return room for an error of the largest value of t/(a + b*t**2), as the support states."""
    largest = float((1 / (2 * (a * b).sqrt())).upper()) * float(
        (1 + (b / a).max(a / b).sqrt()).upper()
    )
    return quotient + arb(0, largest * relative) if quotient.is_finite() else arb(0, largest)


def _compare(kind: str, a: arb, b: arb) -> bool | None:
    if COMPARISONS[kind](a, b):
        return True
    opposite = OPPOSITE.get(kind)
    return False if opposite is None or COMPARISONS[opposite](a, b) else None


def _choose(condition: bool | None, one: arb, other: arb) -> arb:
    return one.union(other) if condition is None else one if condition else other


def _take_turns_off(x: arb) -> arb:
    """Return x less the turns that the double next to it loses, with the rounding of both."""
    if not x.is_finite():
        return x
    turns = round(float(x.mid()) / (2 * np.pi))
    return x - 2 * arb.pi() * turns + arb(0, 4 * UNIT * float(abs(x).upper()))


def _view(kind: str, array: Any) -> Any:
    views: dict[str, Callable[[Any], Any]] = {
        "along_first": lambda a: a[:, np.newaxis],
        "along_last": lambda a: a[np.newaxis, :],
        "transpose": np.transpose,
        "diagonal": np.diagonal,
    }
    return views[kind](array)


def _sum(array: Any) -> Any:
    terms = np.asarray(array, object).ravel()
    total = sum(terms, start=arb(0))
    size = sum((float(abs(t).upper()) for t in terms), start=0.0)
    return total + arb(0, size * UNIT * len(terms))


def _map_affinely(entries: list[Any], point: list[Any]) -> list[Any]:
    """Return M @ p + v with the error of sums and products in any order."""
    count = len(point)
    rows = [entries[i * count : (i + 1) * count] for i in range(count)]
    found = []
    for row, shift in zip(rows, entries[-count:], strict=True):
        terms = [m * p for m, p in zip(row, point, strict=True)] + [shift]
        size = sum((float(abs(t).upper()) for t in terms), start=0.0)
        found.append(sum(terms, start=arb(0)) + arb(0, 2 * (count + 1) * UNIT * size))
    return found
