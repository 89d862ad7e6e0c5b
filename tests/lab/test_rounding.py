"""Balls of programs hold the results of doubles, but not those of another program."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp
from flint import arb

from mechproof.lab.validation import ENCLOSING, decide, enclose_stage
from mechproof.programs.lowering import lower_conditions, lower_steps
from mechproof.programs.operations import KINDS, VIEWS
from mechproof.programs.program import NOTHING, Operation, Program, Stage

a, b, x = sp.symbols("a b x", real=True)
NAMES = ("a", "b", "x")
EPS = float(np.finfo(float).eps)


def stage_of(expression: sp.Expr) -> Stage:
    program = lower_steps({}, frozenset({x}), NAMES, (), (expression,))
    return Stage(None, NAMES, (), NOTHING, program)


def enclose(expression: sp.Expr, *values: float) -> arb:
    (ball,) = enclose_stage(stage_of(expression), dict(zip(NAMES, values, strict=True)))
    return ball


CASES: dict[str, tuple[sp.Expr, Callable[..., float]]] = {
    "product": (a * b * x, lambda a, b, x: a * b * x),
    "cancelling": (a * x - b, lambda a, b, x: a * x - b),
    "functions": (
        sp.sqrt(a) * sp.sin(x) + sp.exp(-b),
        lambda a, b, x: np.sqrt(a) * np.sin(x) + np.exp(-b),
    ),
    "cube": (a / (1 + x) ** 3, lambda a, b, x: a / ((1 + x) * (1 + x) ** 2)),
    "branch": (
        sp.Piecewise((x, x >= 0), (a, True)) - b,
        lambda a, b, x: (x if x >= 0 else a) - b,
    ),
    "floor": (sp.floor(a * x) + b, lambda a, b, x: np.floor(a * x) + b),
}


@pytest.mark.parametrize("name", CASES)
def test_a_ball_holds_the_double_and_little_else(name: str) -> None:
    expression, compute = CASES[name]
    rng = np.random.default_rng(3)
    for values in rng.uniform(0.1, 3, (40, 3)).tolist():
        ball, double = enclose(expression, *values), float(compute(*values))
        assert ball.contains(arb(double))
        # Some ten roundings of values up to 10, with 8 half ulps for each function.
        assert float(ball.rad()) <= 400 * EPS * max(1, abs(double))
        assert not ball.contains(arb(double + 1e-12 * max(1, abs(double))))


def test_another_program_is_told_apart() -> None:
    """A lost bracket changes the value by more than roundings do."""
    ball = enclose(a / (b * x**2), 1.7, 0.9, 2.5)
    assert ball.contains(arb(1.7 / (0.9 * 2.5**2)))
    assert not ball.contains(arb(1.7 / 0.9 * 2.5**2))


def test_an_undecided_branch_gives_both_values() -> None:
    step = sp.Piecewise((a, x * b - 1 > 0), (-a, True))
    third = 1 / 3
    ball = enclose(step, 2.0, 3.0, third)
    assert ball.contains(arb(2))
    assert ball.contains(arb(-2))


def test_conditions_are_true_only_if_certain() -> None:
    program = lower_conditions({}, NAMES, (a < b, x > 0))
    assert decide(program, {"a": 1.0, "b": 2.0, "x": 1.0})
    assert not decide(program, {"a": 1.0, "b": 2.0, "x": 0.0})
    assert not decide(program, {"a": 2.0, "b": 1.0, "x": 1.0})


def test_float32_has_room_for_its_own_roundings() -> None:
    from mechproof.programs.rounding_functions import Single

    wide, narrow = enclose(Single(x) * 3, 0, 0, 0.1), enclose(x * 3, 0, 0, 0.1)
    single = float(np.float32(0.1) * np.float32(3))
    assert wide.contains(arb(single))
    assert not narrow.contains(arb(single))


def test_what_is_prepared_in_float32_stays_float32() -> None:
    prepare = Program(("a",), (Operation("s", "single", ("a",)),), ("s",))
    evaluate = Program(("s",), (Operation("q", "multiply", ("s", 3)),), ("q",))
    (ball,) = enclose_stage(Stage(None, (), ("a",), prepare, evaluate), {"a": 0.1})
    assert ball.contains(arb(float(np.float32(0.1) * np.float32(3))))
    assert not ball.contains(arb(0.30001))


def test_every_operation_of_a_stage_has_a_ball() -> None:
    # These apply to whole arrays.
    special = {*VIEWS, "sum", "every", "quadratic_form", "nonnegative_form"}
    compiled = {"power_of_two", "normal_tail"}
    assert {kind for kind in KINDS if kind not in ENCLOSING} <= special | compiled
