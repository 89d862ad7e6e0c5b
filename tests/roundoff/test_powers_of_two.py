"""Powers of two applied last give the same doubles, and rests of the rounded product."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from mechproof.roundoff.compensation import find_compensated, take_powers_last
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import (
    EXACT,
    HALF,
    PRODUCT_REST,
    QUOTIENT_REST,
    Step,
    StraightLineProgram,
)

# 2*a*b as rounded, and its rest, the rounding error.
DOUBLED = StraightLineProgram(
    ("a", "b"),
    (
        Step("twice", "multiply", (2, "a"), EXACT),
        Step("x", "multiply", ("twice", "b"), HALF),
        Step("half", "divide", ("x", 2), EXACT),
        Step("rest", PRODUCT_REST, ("a", "b", "half"), EXACT),
        Step("more", "multiply", (2, "rest"), EXACT),
        Step("q", "add", ("x", "more"), HALF),
    ),
    ("q",),
)


def test_the_same_doubles_are_computed() -> None:
    rng = np.random.default_rng(2)
    points = {name: rng.normal(size=1000) for name in DOUBLED.inputs}
    moved = take_powers_last(DOUBLED)
    assert moved.steps != DOUBLED.steps
    assert np.array_equal(run(moved, points, IN_DOUBLES), run(DOUBLED, points, IN_DOUBLES))


def test_a_rest_of_a_power_times_a_product_is_its_own() -> None:
    (product,) = find_compensated(DOUBLED).held
    (step,) = (s for s in take_powers_last(DOUBLED).steps if s.result == product)
    assert (step.kind, step.operands) == ("multiply", ("a", "b"))


@pytest.mark.parametrize("factor", [3, 0.75, -2])
def test_another_factor_is_not_taken_last(factor: float) -> None:
    """The rest is then not that of the rounded product, and is refused."""
    first = replace(DOUBLED.steps[0], operands=(factor, "a"), ulps=HALF)
    with pytest.raises(ValueError, match="depends on the rounding of"):
        find_compensated(replace(DOUBLED, steps=(first, *DOUBLED.steps[1:])))


def test_a_rest_with_another_power_is_refused() -> None:
    """A quarter would be right for 4*a*b, but not for 2*a*b."""
    steps = list(DOUBLED.steps)
    steps[2] = Step("half", "divide", ("x", 4), EXACT)
    with pytest.raises(ValueError, match="depends on the rounding of"):
        find_compensated(replace(DOUBLED, steps=tuple(steps)))


def test_a_rounded_factor_without_a_rest_is_refused() -> None:
    """Its rounding moves the product and its rest together, and would not be counted."""
    steps = list(DOUBLED.steps)
    first = Step("sum", "add", ("a", "c"), HALF)
    wrong = [
        replace(s, operands=tuple("sum" if o == "a" else o for o in s.operands)) for s in steps
    ]
    with pytest.raises(ValueError, match="the rounding of its factor sum has no rest"):
        find_compensated(StraightLineProgram(("a", "b", "c"), (first, *wrong), ("q",)))
    # A rest passes on no rounding of what was divided.
    whole = Step("whole", "add", ("a", "c"), HALF)
    divided = Step("sum", "divide", ("whole", "d"), HALF)
    low = Step("low", QUOTIENT_REST, ("whole", "d", "sum"), EXACT)
    part = Step("part", "multiply", ("low", "b"), HALF)
    doubled = Step("both", "multiply", (2, "part"), EXACT)
    more = Step("all", "add", ("q", "both"), HALF)
    steps = [whole, divided, low, *wrong, part, doubled, more]
    with pytest.raises(ValueError, match="the rounding of its factor sum has no rest"):
        find_compensated(StraightLineProgram(("a", "b", "c", "d"), tuple(steps), ("all",)))
    steps[0] = replace(whole, ulps=EXACT)
    assert find_compensated(StraightLineProgram(("a", "b", "c", "d"), tuple(steps), ("all",))).held
    exact = replace(first, ulps=EXACT)
    assert find_compensated(StraightLineProgram(("a", "b", "c"), (exact, *wrong), ("q",))).held


def test_steps_without_such_rests_stay_as_they_are() -> None:
    steps = tuple(step for step in DOUBLED.steps if step.result in ("twice", "x"))
    plain = StraightLineProgram(("a", "b"), steps, ("x",))
    assert take_powers_last(plain) is plain
