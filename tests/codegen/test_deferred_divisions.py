"""Programs for one point at a time: fewer divisions, the same value."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import mpmath as mp
import pytest
from derived import SYSTEMS, paper_of

from mechproof.programs.deferred_divisions import defer_divisions
from mechproof.programs.kernel import list_functions
from mechproof.programs.program import Operand, Operation, Program

DIGITS = 60


@cache
def list_changed() -> list[tuple[str, Program, Program]]:
    """List (kernel name, old, new program) for the shipped programs that deferral changes."""
    kernels = (kernel for system in SYSTEMS for kernel in list_functions(paper_of(system)))
    programs = (
        (kernel.name, program)
        for kernel in kernels
        if kernel.is_shipped
        for stage in kernel.code.stages
        for program in stage.programs
    )
    changed = ((name, program, defer_divisions(program)) for name, program in programs)
    return [(name, program, new) for name, program, new in changed if new != program]


def meanings(scale: int) -> Mapping[str, Callable[..., Any]]:
    return {
        "add": lambda a, b: a + b,
        "subtract": lambda a, b: a - b,
        "multiply": lambda a, b: a * b,
        "divide": lambda a, b: a / b,
        "square": lambda a: a**2,
        "negate": lambda a: -a,
        "fma": lambda a, b, c: a * b + c,
        "copy": lambda a: a,
        "sqrt": mp.sqrt,
        "sin": mp.sin,
        "cos": mp.cos,
        "tan": mp.tan,
        "tangent_above": lambda y: scale * mp.sin(y),
        "tangent_below": lambda y: scale * mp.cos(y),
        "arctan": mp.atan,
        "arctan_quotient": lambda a, b: mp.atan(a / b),
        "small_tangent": mp.tan,
        "product_rest": lambda a, b, p: a * b - p,
        "quotient_rest": lambda a, b, q: a / b - q,
    }


def run(program: Program, scale: int = 1) -> list[Any]:
    """Evaluate a program at fixed inputs, with the two parts of tangents multiplied by `scale`."""
    table = meanings(scale)
    known: dict[Operand, Any] = {
        name: mp.mpf(2 + 3 * i) / 7 for i, name in enumerate(program.inputs)
    }

    def find(operand: Operand) -> Any:
        return known[operand] if isinstance(operand, str) else mp.mpf(operand)

    for step in program.operations:
        known[step.result] = table[step.kind](*map(find, step.operands))
    return [find(output) for output in program.outputs]


def count(program: Program, *kinds: str) -> int:
    return sum(step.kind in kinds for step in program.operations)


@pytest.mark.slow
def test_there_are_programs_to_test() -> None:
    assert len(list_changed()) > 8


@pytest.mark.parametrize("scale", [1, 3])
def test_the_value_stays_whatever_the_scale_of_a_tangent(scale: int) -> None:
    with mp.workdps(DIGITS):
        for name, program, changed in list_changed():
            for one, other in zip(run(changed, scale), run(program), strict=True):
                assert mp.almosteq(one, other, 10 ** (5 - DIGITS)), name


def write(*lines: tuple[Any, ...], inputs: str = "x y z") -> Program:
    """Return a program whose output is the result of its last line."""
    operations = tuple(Operation(result, kind, tuple(given)) for result, kind, *given in lines)
    return Program(tuple(inputs.split()), operations, (operations[-1].result,)).normal_form()


def test_a_tangent_that_does_not_cancel_stays() -> None:
    program = write(("t", "tan", "x"), ("_1", "multiply", "t", "t"), ("_2", "add", "_1", "y"))
    assert defer_divisions(program) == program


def test_a_tangent_over_its_square_cancels() -> None:
    program = write(
        ("_1", "divide", "x", 2),
        ("t", "tan", "_1"),
        ("_2", "square", "t"),
        ("_3", "add", 1, "_2"),
        ("_4", "divide", "t", "_3"),
    )
    changed = defer_divisions(program)
    assert count(program, "divide", "tan") == 3
    assert count(changed, "divide", "tan") == 2
    with mp.workdps(DIGITS):
        assert mp.almosteq(run(changed, 5)[0], run(program)[0], 10 ** (5 - DIGITS))


def test_a_wrong_scale_is_seen() -> None:
    """The comparison above fails for a value that depends on the scale."""
    program = write(("_1", "tangent_above", "x"), ("_2", "multiply", "_1", "y"))
    with mp.workdps(DIGITS):
        assert run(program, 3) != run(program)


def test_what_is_below_a_tangent_without_a_name_is_named() -> None:
    program = write(
        ("_1", "divide", "x", 2),
        ("_2", "tan", "_1"),
        ("_3", "square", "_2"),
        ("_4", "add", 1, "_3"),
        ("_5", "divide", 1, "_4"),
    )
    changed = defer_divisions(program)
    used = [operand for step in changed.operations for operand in step.operands]
    assert all(used.count(name) == 1 for name in used if str(name).startswith("_"))
    with mp.workdps(DIGITS):
        assert mp.almosteq(run(changed, 5)[0], run(program)[0], 10 ** (5 - DIGITS))
