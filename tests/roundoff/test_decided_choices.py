"""Choices between unequal values have their side's error, and the jump where the test may turn."""

from __future__ import annotations

import numpy as np
import pytest

from mechproof.arithmetic.cover import Boxes, as_boxes, cover_below, divide
from mechproof.arithmetic.intervals import EPS, UNIT, Array, Interval, careful
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables
from mechproof.roundoff.steps import EXACT, HALF, Step, StraightLineProgram

Side = tuple[float, float]
SQUARE = Step("square", "square", ("x",), HALF)
CHOSEN = Step("chosen", "choose", ("test", "square", "x"), EXACT)


def bound(steps: tuple[Step, ...], side: Side, output: str = "chosen") -> float:
    """Bound the absolute error of an output, in eps, for x on a side."""
    variables = BoxVariables([Interval(*(np.array([end]) for end in side))], [side[0] >= 0])
    straight = StraightLineProgram(("x",), steps, (output,))
    with careful(moves=True):
        analysis = ErrorAnalysis(straight, variables, {"x": variables.variable(0)}, {}, None)
        one = variables.constant(Interval(np.array([1.0]), np.array([1.0])))
        return float(np.max(analysis.sum_errors(output, ErrorScale(one, False))))


def choose(kind: str, than: float) -> tuple[Step, ...]:
    """Return the steps of x**2 where a comparison of the square holds, x elsewhere."""
    return (SQUARE, Step("test", kind, ("square", than), EXACT), CHOSEN)


@pytest.mark.parametrize("kind", ["greater", "greater_equal", "less", "less_equal"])
@pytest.mark.parametrize("side", [(1.25, 1.5), (2.5, 3.0)])
def test_a_decided_choice_has_the_error_of_its_side(kind: str, side: Side) -> None:
    holds = (side[0] > 2) == kind.startswith("greater")
    own = bound((SQUARE,), side, "square")
    assert own > 0
    assert bound(choose(kind, 4), side) == (pytest.approx(own) if holds else 0)


@pytest.mark.parametrize("kind", ["greater", "greater_equal", "less", "less_equal"])
@pytest.mark.parametrize("side", [(1.5, 2.5), (2.0, 2.0)])
def test_an_undecided_choice_has_the_jump_as_well(kind: str, side: Side) -> None:
    """At 2 the square is 4 and x is 2; a test that only rounding could turn is also undecided."""
    assert bound(choose(kind, 4), side) >= 2 / EPS * (1 - EPS)


def test_a_jump_between_exact_numbers_counts() -> None:
    """Neither side has an error of its own: choosing the wrong one is the only error."""
    steps = (
        SQUARE,
        Step("test", "less", ("square", 4), EXACT),
        Step("step", "choose", ("test", 0.0, 1.0), EXACT),
        Step("scaled", "multiply", ("step", "x"), EXACT),
    )
    assert bound(steps, (1.5, 2.5), "scaled") >= 1.5 / EPS
    assert bound(steps, (1.5, 1.75), "scaled") == 0


def test_without_roundings_a_choice_is_what_either_side_is() -> None:
    exact = tuple(Step(s.result, s.kind, s.operands, EXACT) for s in choose("less", 4))
    variables = BoxVariables([Interval(np.array([1.5]), np.array([2.5]))], [True])
    straight = StraightLineProgram(("x",), exact, ("chosen",))
    with careful(moves=True):
        analysis = ErrorAnalysis(straight, variables, {"x": variables.variable(0)}, {}, None)
    span = analysis.value("chosen").expanded()
    assert span.low <= 1.5
    assert span.high >= 6.25
    assert bound(exact, (1.5, 2.5)) == 0


# (1 + x)*3 from the rounded sum and its rest, whether right or wrong.
SUM = Step("sum", "add", (1.0, "x"), HALF)


def add_rest(operands: tuple[float | str, ...], kind: str = "add") -> tuple[Step, ...]:
    return (
        SUM,
        Step("rest", "sum_rest", operands, EXACT),
        Step("high", "multiply", ("sum", 3.0), EXACT),
        Step("low", "multiply", ("rest", 3.0), EXACT),
        Step("chosen", kind, ("high", "low"), EXACT),
    )


def test_the_rest_of_a_sum_takes_up_its_rounding() -> None:
    side = (0.25, 0.375)
    alone = bound((SUM, Step("chosen", "multiply", ("sum", 3.0), EXACT)), side)
    assert alone >= 3 * UNIT / EPS
    assert bound(add_rest((1.0, "x", "sum")), side) < 1e-12
    assert bound(add_rest((1.0, "x", "sum"), "subtract"), side) > alone


def test_narrow_sides_are_not_cut_before_others() -> None:
    """Only the wide side is cut at first: two cuts of each of twelve sides give 4**12 boxes."""
    box = ((-1.0, 1.0), *((n, n * 1.01) for n in range(1, 12)))
    first = divide(as_boxes(box), len(box))
    assert len(first) == 4
    assert np.all(first[:, 1:] == as_boxes(box)[:, 1:])

    def height(boxes: Boxes) -> Array:
        lengths: Array = (boxes[:, :, 1] - boxes[:, :, 0]).max(axis=1)
        return lengths

    cover = cover_below(height, box, 0.05, 10**5, len(box))
    assert cover.open is None
    assert cover.worst[0][0] <= 0.05


def test_adding_nothing_keeps_what_vanishes() -> None:
    """0*y + x is x, and zero keeps no pole: 0*y/x is 0."""
    sides = [Interval(np.array([0.0]), np.array([1.0]))] * 2
    variables = BoxVariables(sides, [True, True])
    x, y = variables.variable(0), variables.variable(1)
    nothing = y.scaled(Interval(np.array([0.0]), np.array([0.0])))
    for total in (nothing + x, x + nothing, x - nothing):
        assert total.powers == x.powers
    span = (nothing / x).expanded()
    assert span.low == span.high == 0
    assert not np.isfinite((y / x).expanded().high)
