"""Elementary functions of compiled kernels: in, a kind of operation; out, its expansion.

Nothing is written down here. The program is that which the backends print; the step that an
approximation stands for is found by its values, and what is made of both is held against the
function.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from types import MappingProxyType
from typing import Any

import mpmath as mp
from flint import arb

from mechproof.codegen.elementary.fits import Rational, Target, enclose
from mechproof.codegen.elementary.formats import DOUBLE
from mechproof.codegen.elementary.functions import Function, build
from mechproof.codegen.program import Operation, Program
from mechproof.proof.balls import working_precision
from mechproof.roundoff.expansions import Expansion

EPS = 2.0**-52
BITS = 400
# Two polynomials that agree at so many points, to so many bits, are one.
POINTS, SAME = 64, -300
# What the words of a part of pi leave of it, and more.
CLOSE = 2.0**-90
Values = dict[str, Any]
TRUTH: Mapping[str, Callable[..., arb]] = MappingProxyType(
    {
        "tan": arb.tan,
        "sin": arb.sin,
        "cos": arb.cos,
        "arctan": arb.atan,
        "small_arctan": arb.atan,
        "tangent_quotient": lambda y, a, b: y.tan() / (a + b * y.tan() ** 2),
    }
)
ARGUMENTS = (1e-9, 0.1, 0.5, 0.57, 0.7, 1.1, 2.0, 3.0, 4.4, 5.0, 6.5, 100.7, -0.3, -2.4, -4.0)
AT: Mapping[str, Callable[..., Any]] = MappingProxyType(
    {
        "add": lambda a, b: a + b,
        "subtract": lambda a, b: a - b,
        "multiply": lambda a, b: a * b,
        "divide": lambda a, b: a / b,
        "fma": lambda a, b, c: a * b + c,
        "negate": lambda a: -a,
        "absolute": abs,
        "copysign": lambda a, b: abs(a) if b >= 0 else -abs(a),
        "rint": lambda a: (a + 0.5).mid().floor(),
        "floor": lambda a: a.mid().floor(),
        "greater": lambda a, b: a > b,
        "less": lambda a, b: a < b,
        "equal": lambda a, b: bool(a == b),
        "within": lambda a, limit: a,
        "choose": lambda condition, a, b: a if condition else b,
    }
)


@cache
def expand(kind: str) -> Expansion | None:
    """Return the program of a function, its approximations marked; None for what is none.

    Raises ValueError where an approximation is no step of it, or it is not the function.
    """
    if kind not in TRUTH:
        return None
    function = build(kind, DOUBLE)
    program, errors = function.program, {}
    for number, (target, fitted) in enumerate(function.fits):
        name = f"approximate{number}"
        program = _mark(program, target, fitted, name)
        errors[name] = enclose(target, fitted) / EPS
    _check_meaning(kind, function, program)
    return Expansion(program, errors)


def _mark(program: Program, target: Target, fitted: Rational, name: str) -> Program:
    """Put what an approximation is off by after the step that has the values of its polynomial."""
    base, step = _find(program, target, fitted)
    with mp.workdps(30):
        limit = float(mp.sqrt(target.last())) * (1 - EPS)
    at = [s.result for s in program.operations].index(step) + 1
    marked = Operation(name, "approximate", (step, base, limit))
    if base in program.inputs:
        # Where an argument is, is proved with what put the function there.
        program = _limit(program, base, limit)
        return _mark(program, target, fitted, name)
    later = [_rename(s, step, name) for s in program.operations[at:]]
    outputs = tuple(name if o == step else o for o in program.outputs)
    return Program(program.inputs, (*program.operations[:at], marked, *later), outputs)


def _limit(program: Program, name: str, limit: float) -> Program:
    """Let an argument be within a limit."""
    inside = Operation("argument", "within", (name, limit))
    later = tuple(_rename(s, name, inside.result) for s in program.operations)
    return Program(program.inputs, (inside, *later), program.outputs)


def _rename(step: Operation, old: str, new: str) -> Operation:
    return replace(step, operands=tuple(new if o == old else o for o in step.operands))


def _find(program: Program, target: Target, fitted: Rational) -> tuple[str, str]:
    """Return the step that a polynomial stands for, and that which it is a polynomial of."""
    with working_precision(BITS):
        for base in _list_bases(program):
            known = set(_evaluate_from(program, base, arb(1) / 3))
            for i in range(POINTS):
                place = arb(i + 1) / (2 * POINTS)
                meant = target.above(fitted, place)
                found = _evaluate_from(program, base, place)
                known &= {n for n, value in found.items() if _is_same(value, meant)}
            for step in program.operations:
                if step.result in known:
                    return base, step.result
    raise ValueError(f"{target.meaning}: no step has the values of its polynomial")


def _is_same(value: Any, meant: arb) -> bool:
    return isinstance(value, arb) and bool(abs(value - meant) < arb(2) ** SAME)


def _list_bases(program: Program) -> Iterator[str]:
    """List what is squared."""
    squares = (s for s in program.operations if s.kind == "multiply")
    found = (s.operands[0] for s in squares if s.operands[0] == s.operands[1])
    return (str(name) for name in dict.fromkeys(found))


def _evaluate_from(program: Program, base: str, value: arb) -> Values:
    """Return what depends on one result alone, at a value of it."""
    values: Values = {base: value}
    for step in program.operations:
        names = [o for o in step.operands if isinstance(o, str)]
        arithmetic = step.kind in ("add", "subtract", "multiply", "divide", "fma", "negate")
        if arithmetic and names and step.result != base and all(n in values for n in names):
            values[step.result] = _apply(step, values)
    return values


def _apply(step: Operation, values: Mapping[str, Any]) -> Any:
    given = [values[o] if isinstance(o, str) else arb(o) for o in step.operands]
    return AT[step.kind](*given)


def _check_meaning(kind: str, function: Function, program: Program) -> None:
    """Hold the program, its approximations exact, against the function in every quarter turn."""
    limit = 1 / 3**0.5 if kind == "small_arctan" else float("inf")
    with working_precision(BITS):
        parameters = [arb(3) / 7, arb(9) / 5][: len(program.inputs) - 1]
        for argument in ARGUMENTS:
            if abs(argument) > limit:
                continue
            given = [arb(argument), *parameters]
            values: Values = dict(zip(program.inputs, given, strict=True))
            for step in program.operations:
                if step.kind == "approximate":
                    values[step.result] = _make_exact(step, function, values)
                else:
                    values[step.result] = _apply(step, values)
            found, true = values[str(program.outputs[0])], TRUTH[kind](*given)
            if not abs(found / true - 1) < CLOSE:
                raise ValueError(f"{kind}: {found} is not its value {true} at {argument}")


def _make_exact(step: Operation, function: Function, values: Mapping[str, Any]) -> arb:
    """Return the step with its approximation taken off."""
    target, fitted = function.fits[int(step.result.removeprefix("approximate"))]
    value, base = (values[str(o)] for o in step.operands[:2])
    found, true = target.sides(fitted, base)
    return value * true / found
