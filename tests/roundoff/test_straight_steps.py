"""Straight-line steps: scaled, negated, limited and held results count as they should."""

from __future__ import annotations

from contextlib import nullcontext

import numpy as np
import pytest

from mechproof.arithmetic.intervals import Interval, careful
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.compensation import find_scaled
from mechproof.roundoff.elementary_errors import prove
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import BoxVariables
from mechproof.roundoff.steps import Step, StraightLineProgram
from mechproof.roundoff.symmetry import ODD, find_parities


def test_what_is_negated_is_not_compared() -> None:
    for step in (Step("q", "greater", ("y", 1), 0.0), Step("q", "choose", (1, "y", 1), 0.0)):
        with pytest.raises(ValueError, match="odd"):
            find_parities(StraightLineProgram(("y",), (step,), ("q",)), {"y": ODD})


def test_a_scale_that_stays_is_refused() -> None:
    part = Step("t", "copy", (1.0,), 0.0, scaled="y")
    for kind, operands in (("add", ("t", 1)), ("arctan", ("t",)), ("square", ("t",))):
        with pytest.raises(ValueError, match="scaled"):
            find_scaled(StraightLineProgram(("y",), (part, Step("q", kind, operands, 0.5)), ("q",)))
    whole = find_scaled(
        StraightLineProgram(("y",), (part, Step("q", "divide", ("t", "t"), 0.5)), ("q",))
    )
    assert whole.scaled == ("t",)


def test_of_what_is_scaled_no_difference_is_exact() -> None:
    """Doubles this close have an exact difference, but scaled ones are not known to be close."""
    steps = (
        Step("one", "multiply", ("y", 1.0), 0.0, scaled="y"),
        Step("other", "multiply", ("y", 1.0), 0.0, scaled="y"),
        Step("most", "multiply", ("other", 0.75), 0.5),
        Step("left", "subtract", ("one", "most"), 0.5),
        Step("q", "divide", ("left", "one"), 0.5),
    )
    straight = StraightLineProgram(("y",), steps, ("q",))
    errors = []
    for some in (straight, find_scaled(straight)):
        variables = BoxVariables([Interval(np.array([1.0]), np.array([1.0]))], [True])
        evaluation = ErrorAnalysis(some, variables, {"y": variables.variable(0)}, {}, None)
        errors.append(evaluation.list_errors("q", ErrorScale(None, True))["left"])
    assert errors[0] == 0 < errors[1]


def test_an_argument_that_is_limited_may_be_off_by_nothing_held() -> None:
    """The exact argument is legal, but the computed one might not be: all its roundings count."""
    steps = (Step("w", "square", ("y",), 0.5), Step("q", "arctan", ("w",), 1.0, "small_arctan"))
    side = Interval(np.array([0.75]), np.array([0.76]))
    variables = BoxVariables([side], [True])
    for held in ((), ("w",)):
        straight = StraightLineProgram(("y",), steps, ("q",), held)
        refused = pytest.raises(ValueError, match="held values: ") if held else nullcontext()
        with careful(moves=False), refused:
            evaluation = ErrorAnalysis(
                straight, variables, {"y": variables.variable(0)}, {}, None, prove
            )
            assert evaluation.sum_errors("q", ErrorScale(None, True)) < 3
