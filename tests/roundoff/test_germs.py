"""Germs: balls with their factors hold every value, at zero and at poles too."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from flint import arb

from mechproof.proof.balls import working_precision
from mechproof.roundoff.angles import Turn
from mechproof.roundoff.cover import cover_below, lower_bound
from mechproof.roundoff.germs import Frame, Germ, ball_between, raise_ball
from mechproof.roundoff.rules import RULES

SIDES = [(0.0, 1e-3), (0.0, 0.5), (0.7, 0.9), (1.2, 1.3), (1.5, 1.6), (-0.2, 0.3), (-1.3, -1.2)]
ONE = {"tan": math.tan, "sin": math.sin, "cos": math.cos, "arctan": math.atan, "absolute": abs}
SLOPES = {
    "tan": lambda x: 1 + math.tan(x) ** 2,
    "sin": math.cos,
    "cos": lambda x: -math.sin(x),
    "arctan": lambda x: 1 / (1 + x * x),
    "absolute": lambda x: math.copysign(1.0, x),
}


def holds(germ: Germ, value: float, inverse: bool = False) -> bool:
    """Say whether a germ has a value, or its reciprocal, to a few of the double's own ulps."""
    one = germ.frame.constant(arb(1))
    ball = (one / germ if inverse else germ).expanded()
    target = 1 / value if inverse else value
    return bool(ball.overlaps(arb(target, 4e-16 * abs(target) + 1e-300)))


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("kind", ONE)
def test_functions_hold_their_values_and_slopes(kind: str, side: tuple[float, float]) -> None:
    with working_precision(64):
        frame = Frame([ball_between(*side)], [side[0] >= 0], poles=1)
        value, (slope,) = RULES[kind]([frame.variable(0)], None)
        assert slope is not None
        for x in np.linspace(*side, 41):
            steep = kind == "tan" and abs(x) > 0.9
            assert holds(value, ONE[kind](x), steep)
            assert holds(slope, SLOPES[kind](x), steep)


@pytest.mark.parametrize("kind", ["tan", "sin", "cos"])
def test_whole_turns_are_taken_off(kind: str) -> None:
    with working_precision(64):
        rest = ball_between(0.3, 0.301)
        whole = 2 * arb.pi() * 1000 + rest
        frame = Frame([rest, 1 / whole], [True, True], poles=1)
        angle = frame.variable(1, -1)
        turn = Turn(angle.powers, rest, whole)
        value, _ = RULES[kind]([angle.scaled(arb(1, 2.0**-52))], turn)
        for x in np.linspace(0.3, 0.301, 11):
            assert holds(value, ONE[kind](x))
        assert value.expanded().rad() < 2e-3


def test_what_vanishes_alike_has_a_finite_quotient() -> None:
    with working_precision(64):
        frame = Frame([ball_between(0.0, 0.1)], [True])
        x = frame.variable(0)
        sine, _ = RULES["sin"]([x], None)
        quotient = ((sine + x) / x).expanded()
        assert quotient.overlaps(arb(2))
        assert quotient.rad() < 2e-3


@pytest.mark.parametrize("power", [-2, -1, 1, 2, 3])
@pytest.mark.parametrize("side", [(0.5, 2.0), (-2.0, -0.5)])
def test_powers_hold_and_are_narrow(power: int, side: tuple[float, float]) -> None:
    with working_precision(64):
        ball = raise_ball(ball_between(*side), power)
        values = [x**power for x in np.linspace(*side, 21)]
        assert all(ball.overlaps(arb(v, 1e-15)) for v in values)
        assert 2 * float(ball.rad()) <= 1.0001 * (max(values) - min(values))


def edge(limit: float) -> Callable[[tuple[tuple[float, float], ...]], float]:
    """Make the bound x + y at the far corner of a box, endless for a box that is not small."""

    def bound(box: tuple[tuple[float, float], ...]) -> float:
        (_, x), (_, y) = box
        return x + y if x - box[0][0] < limit else math.inf

    return bound


def test_a_cover_comes_down_to_the_largest_value() -> None:
    found = lower_bound([(edge(0.3), ((0.0, 1.0), (0.0, 1.0)))], 100)
    assert found.bound == 2.0
    count, stays_open = cover_below(edge(0.3), ((0.0, 1.0), (0.0, 1.0)), 2.0, 1000)
    assert count >= 4
    assert stays_open is None


def test_a_cover_names_a_box_that_stays_open() -> None:
    _, stays_open = cover_below(edge(0.3), ((0.0, 1.0), (0.0, 1.0)), 1.9, 1000)
    assert stays_open is not None
    assert sum(high for _, high in stays_open) > 1.9
