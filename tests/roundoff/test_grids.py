"""Sums and products of doubles that an interval claims to be exact are exact."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from mechproof.arithmetic.intervals import Interval
from mechproof.roundoff.endpoint_rounding import (
    are_doubles,
    find_grid,
    find_grid_of_number,
    find_own_grid,
)

OPERATIONS: dict[str, Callable[[Fraction, Fraction], Fraction]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
}


@pytest.mark.parametrize("kind", OPERATIONS)
def test_what_is_said_to_be_exact_is(kind: str) -> None:
    """No claim fails for intervals a few octaves wide, including doubles of few bits."""
    rng = np.random.default_rng(7)
    said = 0
    for _ in range(3000):
        a, b = (draw(rng) for _ in range(2))
        exact = OPERATIONS[kind](Fraction(a), Fraction(b))
        grids = [
            find_own_grid(around(value)) if rng.random() < 0.5 else find_grid_of_number(value)
            for value in (a, b)
        ]
        result = float(exact)
        if are_doubles(find_grid(kind, grids), Interval(np.float64(result), np.float64(result))):
            said += 1
            assert Fraction(result) == exact
    assert said > 300


def draw(rng: np.random.Generator) -> float:
    bits = int(rng.integers(1, 54))
    return float(np.ldexp(float(rng.integers(1, 2**bits)), int(rng.integers(-6, 6)) - bits))


def around(value: float) -> Interval:
    """Return an interval around `value` whose least size has the value's spacing or less."""
    low = np.float64(value) * np.float64(0.75)
    return Interval(low, np.float64(2 * value))


def test_nothing_is_known_of_what_may_vanish() -> None:
    assert find_own_grid(Interval(np.float64(-1.0), np.float64(1.0))) == -np.inf
    nothing = Interval(np.float64(np.nan), np.float64(np.nan))
    assert not are_doubles(np.float64(0.0), nothing)
    assert find_grid_of_number(0.0) == np.inf
    assert [find_grid_of_number(x) for x in (1.0, 3.0, 12.0, 0.375, -0.5)] == [0, 0, 2, -3, -1]


def test_the_largest_multiple_is_not_taken_for_a_double() -> None:
    """2**53 + 1 is no double, and is rounded to 2**53."""
    top = np.float64(2.0**53)
    assert not are_doubles(np.float64(0.0), Interval(top, top))
    assert are_doubles(np.float64(0.0), Interval(top - 1, top - 1))
