"""Products are fused with the sums that they enter, and nothing else changes."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.programs.fused_products import fuse_products
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import Operand, Operation, Program, unfuse

SUMS = {
    "a*b + c": (("_1", "multiply", "ab"), ("_2", "add", ("_1", "c"))),
    "a*b - c": (("_1", "multiply", "ab"), ("_2", "subtract", ("_1", "c"))),
    "c - a*b": (("_1", "multiply", "ab"), ("_2", "subtract", ("c", "_1"))),
    "c + a**2": (("_1", "square", "a"), ("_2", "add", ("c", "_1"))),
    "a*b - b*c": (
        ("_1", "multiply", "ab"),
        ("_2", "multiply", "bc"),
        ("_3", "subtract", ("_1", "_2")),
    ),
    "1 - a*b": (("_1", "multiply", "ab"), ("_2", "subtract", (1, "_1"))),
    "a*b - 1": (("_1", "multiply", "ab"), ("_2", "subtract", ("_1", 1))),
}


def write(*steps: tuple[str, str, tuple[Operand, ...] | str]) -> Program:
    operations = tuple(Operation(name, kind, tuple(given)) for name, kind, given in steps)
    return Program(tuple("abc"), operations, (operations[-1].result,)).normal_form()


def find_value(program: Program) -> sp.Expr:
    values: dict[Operand, sp.Expr] = {name: sp.Symbol(name) for name in program.inputs}
    for step in program.operations:
        given = [values.get(o, sp.sympify(o)) for o in step.operands]
        values[step.result] = SYMBOLIC[step.kind](*given)
    return values[program.outputs[0]]


@pytest.mark.parametrize("text", SUMS)
def test_a_fused_sum_has_the_same_value(text: str) -> None:
    program = write(*SUMS[text])
    fused = fuse_products(program)
    assert [step.kind for step in fused.operations].count("fma") == 1
    assert sp.expand(find_value(fused) - find_value(program)) == 0
    assert sp.expand(find_value(fused) - sp.sympify(text)) == 0
    assert sp.expand(find_value(unfuse(fused)) - sp.sympify(text)) == 0


def test_of_two_products_the_first_is_fused() -> None:
    fused = fuse_products(write(*SUMS["a*b - b*c"]))
    assert fused.operations[-1].operands[:2] == ("a", "b")


def test_a_product_with_a_name_is_left_as_it_is() -> None:
    """Its rounded value may be used elsewhere, too."""
    program = write(("p", "multiply", "ab"), ("_1", "add", ("p", "c")))
    assert fuse_products(program) == program


def test_other_operations_are_left_as_they_are() -> None:
    program = write(("_1", "multiply", "ab"), ("_2", "divide", ("_1", "c")))
    assert fuse_products(program) == program
