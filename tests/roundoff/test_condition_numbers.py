"""Condition numbers enclose those of all points of a box; exact ones lose nothing to its width."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp

from mechproof.arithmetic.intervals import EPS, Interval, between, careful, exactly
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.condition_numbers import find_condition_numbers
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables
from mechproof.roundoff.regions import express
from mechproof.roundoff.rules import RULES
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import Step, StraightLineProgram

# The value of an operation, and the sides of its operands.
OPERATIONS: dict[str, tuple[Callable[..., float], list[tuple[float, float]]]] = {
    "add": (lambda a, b: a + b, [(0.0, 1.0), (0.5, 2.0)]),
    "subtract": (lambda a, b: a - b, [(1.0, 3.0), (-1.0, 0.5)]),
    "multiply": (lambda a, b: a * b, [(0.5, 2.0), (-3.0, -1.0)]),
    "divide": (lambda a, b: a / b, [(0.5, 2.0), (1.0, 3.0)]),
    "fma": (lambda a, b, c: a * b + c, [(0.5, 2.0), (1.0, 3.0), (0.0, 4.0)]),
    "square": (lambda a: a * a, [(-2.0, -0.5)]),
    "sqrt": (math.sqrt, [(0.5, 2.0)]),
    "absolute": (abs, [(-2.0, 1.0)]),
    "maximum": (max, [(1.0, 2.0), (0.5, 3.0)]),
    "sin": (math.sin, [(0.5, 1.2)]),
    "tan": (math.tan, [(0.1, 1.2)]),
    "arctan": (math.atan, [(0.1, 3.0)]),
    "arctan2": (math.atan2, [(0.1, 0.5), (-3.0, 2.0)]),
}
STEP = 2.0**-20


def enter(sides: list[tuple[float, float]], poles: int = 0) -> BoxVariables:
    spans = [between(np.array([low]), np.array([high])) for low, high in sides]
    return BoxVariables(spans, [low >= 0 for low, _ in sides], poles)


@pytest.mark.parametrize("kind", OPERATIONS)
def test_every_point_of_a_box_has_its_condition_numbers_in_theirs(kind: str) -> None:
    function, sides = OPERATIONS[kind]
    variables = enter(sides, poles=1)
    given = [variables.constant(span) for span in variables.spans]
    exact, find_slopes = RULES[kind](None, *given)
    found = find_condition_numbers(kind, given, exact, find_slopes())
    rng = np.random.default_rng(3)
    for _ in range(300):
        point = [float(rng.uniform(*side)) for side in sides]
        for place, number in enumerate(found):
            moved = list(point)
            moved[place] *= 1 + STEP
            share = (function(*moved) / function(*point) - 1) / STEP
            assert number is not None
            assert number.low - 1e-3 <= share <= number.high + 1e-3


def test_terms_that_cancel_have_no_condition_number() -> None:
    variables = enter([(1.0, 2.0), (1.5, 3.0)])
    given = [variables.constant(span) for span in variables.spans]
    exact, find_slopes = RULES["subtract"](None, *given)
    for number in find_condition_numbers("subtract", given, exact, find_slopes()):
        assert number is not None
        assert not number.is_finite.any()


def bound(straight: StraightLineProgram, sides: list[tuple[float, float]]) -> float:
    variables = enter(sides)
    given = {name: variables.variable(i) for i, name in enumerate(straight.inputs)}
    with careful(moves=False):
        analysis = ErrorAnalysis(straight, variables, given, {}, None)
        return float(np.max(analysis.sum_errors("q", ErrorScale(None, True))))


PRODUCTS = StraightLineProgram(
    ("a", "b", "c"),
    (
        Step("p", "multiply", ("a", "b"), 0.5),
        Step("r", "divide", ("p", "c"), 0.5),
        Step("s", "square", ("r",), 0.5),
        Step("q", "multiply", ("s", "p"), 0.5),
    ),
    ("q",),
)


def test_of_products_a_wide_box_has_the_bound_of_a_point() -> None:
    """The first rounding counts three times, the second twice, and each other one once."""
    for sides in ([(1.5, 1.5)] * 3, [(1.0, 100.0)] * 3):
        assert bound(PRODUCTS, sides) <= 3.5 * (1 + 1e-12)


def test_inputs_come_near_to_the_bound_of_products() -> None:
    """The worst input is so near the bound that it exceeds a bound with one rounding left out."""
    rng = np.random.default_rng(5)
    points = {name: rng.uniform(1.0, 1.1, 20000) for name in PRODUCTS.inputs}
    (found,) = run(PRODUCTS, points, IN_DOUBLES)
    wide = {name: value.astype(np.longdouble) for name, value in points.items()}
    a, b, c = wide.values()
    true = (a * b / c) ** 2 * a * b
    worst = float(np.max(np.abs(found / true - 1))) / EPS
    sides = [(1.0, 1.1)] * 3
    assert worst <= bound(PRODUCTS, sides)
    fewer = tuple(step for step in PRODUCTS.steps if step.result != "p")
    steps = (Step("p", "multiply", ("a", "b"), 0.0), *fewer)
    assert worst > bound(StraightLineProgram(PRODUCTS.inputs, steps, ("q",)), sides)


def test_a_product_with_a_computed_one_is_exact() -> None:
    """1 - b is rounded to 1 for b up to 2**-56; for b up to 2**-40 it may be another number."""
    steps = (
        Step("one", "subtract", (1.0, "b"), 0.5),
        Step("p", "square", ("one",), 0.5),
        Step("q", "multiply", ("a", "p"), 0.5),
    )
    straight = StraightLineProgram(("a", "b"), steps, ("q",))
    assert bound(straight, [(1.0, 2.0), (0.0, 2.0**-56)]) < 0.26
    assert bound(straight, [(1.0, 2.0), (0.0, 2.0**-40)]) > 1


def test_what_is_taken_off_one_leaves_at_most_one() -> None:
    d = sp.Symbol("d", positive=True)
    variables = enter([(0.0, 0.125)])
    span = express(1 - d, variables, {d: variables.variable(0)}).expanded()
    assert (float(span.low[0]), float(span.high[0])) == (pytest.approx(0.875), 1.0)
    third = express(sp.Rational(1, 3) - d, variables, {d: variables.variable(0)}).expanded()
    assert third.high > 1 / 3


def test_what_is_in_two_intervals_is_in_their_intersection() -> None:
    nothing = exactly(math.nan)
    one = Interval(np.array([0.0, 1.0]), np.array([2.0, 3.0]))
    other = Interval(np.array([1.0, -np.inf]), np.array([5.0, 2.0]))
    both = one.intersection(other)
    assert (both.low.tolist(), both.high.tolist()) == ([1.0, 1.0], [2.0, 3.0])
    for found in (one.intersection(nothing), nothing.intersection(one)):
        assert (found.low.tolist(), found.high.tolist()) == ([0.0, 1.0], [2.0, 3.0])


def test_what_stands_for_any_number_is_no_power_of_two() -> None:
    """An unknown factor is represented by 1, but a quotient by it is still rounded."""
    steps = (Step("q", "divide", ("a", "b"), 0.5),)
    sides = [(1.0, 2.0), (1.0, 1.0)]
    assert bound(StraightLineProgram(("a", "b"), steps, ("q",)), sides) == 0
    assert bound(StraightLineProgram(("a", "b"), steps, ("q",), scaled=("b",)), sides) >= 0.5
