"""Conditions are split for NumPy's kernels and joined again without loss."""

from __future__ import annotations

import pytest

from mechproof.codegen.condition_outputs import join_conditions, split_conditions
from mechproof.codegen.languages import NUMPY_BODY
from mechproof.codegen.syntax import write_program
from mechproof.programs.program import Operation, Program

POSITIVE = (("greater", "a", 0.0), ("is_finite", "a"))
CASES = [
    (POSITIVE, ("_is_positive(a)",)),
    ((("greater_equal", "a", 0.0), ("is_finite", "a")), ("_is_nonnegative(a)",)),
    ((("less", "b", "a"), *POSITIVE), ("b < a", "_is_positive(a)")),
    ((*POSITIVE, ("less", "b", "a")), ("_is_positive(a)", "b < a")),
    ((("greater", "a", 0.0), ("is_finite", "b")), ("a > 0.0", "_is_finite(b)")),
    ((("greater", "a", 1.0), ("is_finite", "a")), ("a > 1.0", "_is_finite(a)")),
    ((("is_finite", "a"), ("greater", "a", 0.0)), ("_is_finite(a)", "a > 0.0")),
    ((("greater", "a", 0.0),), ("a > 0.0",)),
]
OF_TERMS = [
    ((1, 1), ("_every(_is_positive(a), axis=-1)",)),
    ((2, 2), ("_every(_is_positive(a), axis=(-2, -1))",)),
    ((1, 2), ("_every(a > 0.0, axis=-1)", "_every(_is_finite(a), axis=(-2, -1))")),
]


def conjunction(*conditions: tuple[object, ...], axes: tuple[int, ...] = ()) -> Program:
    operations = [Operation(f"_c{i}", c[0], c[1:]) for i, c in enumerate(conditions)]
    names = [step.result for step in operations]
    for i, count in enumerate(axes):
        operations.append(Operation(f"_e{i}", "every", (names[i], count)))
        names[i] = f"_e{i}"
    result = names[0]
    for i, name in enumerate(names[1:]):
        operations.append(Operation(f"_b{i}", "both", (result, name)))
        result = f"_b{i}"
    return Program(("a", "b"), tuple(operations), (result,)).normal_form()


@pytest.mark.parametrize(("conditions", "texts"), CASES)
def test_a_sign_and_being_finite_are_asked_at_once(
    conditions: tuple[tuple[object, ...], ...], texts: tuple[str, ...]
) -> None:
    program = conjunction(*conditions)
    split = split_conditions(program)
    assert write_program(split, NUMPY_BODY).outputs == texts
    assert join_conditions(split) == program


@pytest.mark.parametrize(("axes", "texts"), OF_TERMS)
def test_of_terms_they_are_if_the_axes_are_the_same(
    axes: tuple[int, ...], texts: tuple[str, ...]
) -> None:
    program = conjunction(*POSITIVE, axes=axes)
    split = split_conditions(program)
    assert write_program(split, NUMPY_BODY).outputs == texts
    assert join_conditions(split) == program
