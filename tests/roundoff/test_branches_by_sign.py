"""Branches by a sign: each is bounded where it may be taken, and both compute one function."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from derived import paper_of

from mechproof.arithmetic.intervals import Interval
from mechproof.programs.kernel import list_functions
from mechproof.roundoff.branches import Branch, list_branches
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.interval_monomials import BoxVariables, IntervalMonomial
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.steps import EXACT, HALF, Step, StraightLineProgram

# u + sqrt(w + u**2), by the reciprocal where that cancels.
STEPS = (
    Step("size", "absolute", ("u",), EXACT),
    Step("square", "square", ("u",), HALF),
    Step("sum", "add", ("w", "square"), HALF),
    Step("root", "sqrt", ("sum",), HALF),
    Step("q", "add", ("size", "root"), HALF),
    Step("test", "greater_equal", ("u", 0), EXACT),
    Step("other", "divide", ("w", "q"), HALF),
    Step("chosen", "choose", ("test", "q", "other"), EXACT),
)
ROOT = StraightLineProgram(("u", "w"), STEPS, ("chosen",))


def change(number: int, **changes: object) -> StraightLineProgram:
    """Return the program with changes to step `number`."""
    steps = [*STEPS]
    steps[number] = replace(steps[number], **changes)  # type: ignore[arg-type]
    return replace(ROOT, steps=tuple(steps))


@cache
def list_stages() -> tuple[ComputedStage, ...]:
    """List the ways to compute the radius of the track."""
    paper = paper_of("track_wheel")
    (kernel,) = (one for one in list_functions(paper) if one.name == "radius")
    return tuple(list_computed_stages(kernel, paper))


def test_steps_without_a_choice_are_one_branch() -> None:
    plain = replace(ROOT, steps=STEPS[:5], outputs=("q",))
    assert list_branches(plain) == (Branch(plain),)


def test_the_size_of_what_is_tested_is_known_in_either_branch() -> None:
    above, below = list_branches(ROOT)
    assert [step.kind for step in above.straight.steps] == ["square", "add", "sqrt", "add"]
    assert above.straight.steps[-1].operands == ("u", "root")
    assert below.straight.steps[0].kind == "negate"
    assert below.straight.outputs == ("other",)


@pytest.mark.parametrize(
    "other",
    [
        change(6, operands=("sum", "q")),
        change(2, kind="subtract"),
        change(7, operands=("test", "q", "root")),
        change(3, kind="divide", operands=("w", "u")),
        change(5, operands=("u", 1)),
        change(5, kind="less"),
    ],
    ids=[
        *("another quotient", "a difference of squares", "another branch", "no root"),
        *("another number", "another test"),
    ],
)
def test_what_is_not_one_function_keeps_its_choice(other: StraightLineProgram) -> None:
    assert list_branches(other) == (Branch(other),)


@pytest.mark.parametrize(
    ("low", "high", "may_vanish", "taken"),
    [
        (0.0, 2.0, False, (True, False)),
        (-2.0, -1.0, False, (False, True)),
        (-1.0, 1.0, False, (True, True)),
        (-2.0, -1.0, True, (True, True)),
        (np.nan, np.nan, False, (True, True)),
    ],
)
def test_a_branch_is_taken_where_it_may_be(
    low: float, high: float, may_vanish: bool, taken: tuple[bool, bool]
) -> None:
    ends = [Interval(np.array([0.0 if may_vanish else 1.0]), np.array([2.0]))]
    variables = BoxVariables(ends, [True])
    tested = IntervalMonomial(variables, Interval(np.array([low]), np.array([high])), (1,))
    found = tuple(bool(np.all(branch.find_taken(tested))) for branch in list_branches(ROOT))
    assert found == taken


def test_a_tested_result_that_no_output_needs_stays() -> None:
    steps = (
        Step("g", "multiply", ("u", "w"), HALF),
        Step("a", "add", ("u", "w"), HALF),
        Step("b", "add", ("w", "u"), HALF),
        Step("test", "greater_equal", ("g", 0), EXACT),
        Step("chosen", "choose", ("test", "a", "b"), EXACT),
    )
    for branch in list_branches(StraightLineProgram(("u", "w"), steps, ("chosen",))):
        assert [step.result for step in branch.test.steps] == ["g"]


def test_what_is_said_never_to_be_zero_decides() -> None:
    ends = [Interval(np.array([0.0]), np.array([2.0]))]
    above, below = list_branches(ROOT)
    for variables, taken in (
        (BoxVariables(ends, [True], nonzero={0}), (False, True)),
        (BoxVariables(ends, [False], nonzero={0}), (True, True)),
    ):
        tested = IntervalMonomial(variables, Interval(np.array([-2.0]), np.array([-1.0])), (1,))
        found = (above.find_taken(tested), below.find_taken(tested))
        assert tuple(map(bool, map(np.all, found))) == taken


def test_an_open_end_leaves_zero_out_and_a_closed_one_does_not() -> None:
    chart = list_stages()[0].form.charts[0]
    closed = {
        **chart.within,
        **{s: sp.Interval(0, sp.oo) for s in chart.within if str(s) == "size"},
    }
    box = np.array([[[0.0, np.inf], [0.5, 0.6], [0.0, np.inf], [3.0, 3.01]]])
    for one, leaves_out in ((chart, True), (replace(chart, within=closed), False)):
        variables, *_ = next(list_regions(one)).enter(box, 0)
        assert bool(np.all(variables.never_vanish((1, 0, 0, 0)))) is leaves_out


def test_both_branches_count_where_the_sign_is_not_known() -> None:
    for stage in list_stages():
        region = next(list_regions(stage.form.charts[0]))
        sides = {"size": (0.0, np.inf), "share": (0.5, 0.51), "count": (0.0, np.inf)}
        near = {**sides, "theta": (np.pi / 2 - 0.01, np.pi / 2 + 0.01)}
        box = np.array([[near[name.name] for name in region.names]])
        alone = [stage._bound(branch, region, box, ())[0] for branch in stage.branches]
        assert stage.bound(region, box)[0] == max(alone)
        # Where the sign is known, only the branch that does not cancel counts.
        far = {**sides, "theta": (3.0, 3.01)}
        box = np.array([[far[name.name] for name in region.names]])
        above, below = (stage._bound(branch, region, box, ())[0] for branch in stage.branches)
        assert stage.bound(region, box)[0] == below < above
