"""Monomials, intervals with factors, hold every value, even at zeros and at poles."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechproof.arithmetic.cover import Boxes, are_below, cover_below, cut_again
from mechproof.arithmetic.intervals import ONE, PI, Interval, between, exactly
from mechproof.roundoff.angles import Turn
from mechproof.roundoff.interval_monomials import BoxVariables, IntervalMonomial, MixedBoxesError
from mechproof.roundoff.rules import RULES

SIDES = [(0.0, 1e-3), (0.0, 0.5), (0.7, 0.9), (1.2, 1.3), (1.5, 1.6), (-0.2, 0.3), (-1.3, -1.2)]
FUNCTIONS = {
    "tan": math.tan,
    "sin": math.sin,
    "cos": math.cos,
    "arctan": math.atan,
    "absolute": abs,
}
SLOPES = {
    "tan": lambda x: 1 + math.tan(x) ** 2,
    "sin": math.cos,
    "cos": lambda x: -math.sin(x),
    "arctan": lambda x: 1 / (1 + x * x),
    "absolute": lambda x: math.copysign(1.0, x),
}


def side_between(low: float, high: float) -> Interval:
    return between(np.array([low]), np.array([high]))


def holds(monomial: IntervalMonomial, value: float, inverse: bool = False) -> bool:
    """Return whether a monomial holds a value, or its reciprocal the value's, to a few ulps."""
    one = monomial.variables.constant(ONE)
    span = (one / monomial if inverse else monomial).expanded()
    target = 1 / value if inverse else value
    reach = 4e-16 * abs(target) + 1e-300
    return bool(np.all((span.low <= target + reach) & (target - reach <= span.high)))


def reach_of(span: Interval) -> float:
    return float(np.max(span.high - span.low))


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("kind", FUNCTIONS)
def test_functions_hold_their_values_and_slopes(kind: str, side: tuple[float, float]) -> None:
    variables = BoxVariables([side_between(*side)], [side[0] >= 0], poles=1)
    value, find_slopes = RULES[kind](None, variables.variable(0))
    (slope,) = find_slopes()
    assert slope is not None
    for x in np.linspace(*side, 41):
        steep = kind == "tan" and abs(x) > 0.9
        assert holds(value, FUNCTIONS[kind](x), steep)
        assert holds(slope, SLOPES[kind](x), steep)


@pytest.mark.parametrize("kind", ["tan", "sin", "cos"])
def test_whole_turns_are_taken_off(kind: str) -> None:
    rest = side_between(0.3, 0.301)
    whole = PI * exactly(2000.0) + rest
    variables = BoxVariables([rest, ONE / whole], [True, True], poles=1)
    angle = variables.variable(1, -1)
    turn = Turn(angle.powers, variables.constant(rest), whole)
    near = Interval(np.float64(1 - 2.0**-52), np.float64(1 + 2.0**-52))
    value, _ = RULES[kind](turn, angle.scaled(near))
    for x in np.linspace(0.3, 0.301, 11):
        assert holds(value, FUNCTIONS[kind](x))
    assert reach_of(value.expanded()) < 4e-3


def test_half_a_turn_is_taken_off() -> None:
    """Next to half a turn the tangent of half the angle has a pole in the rest of the angle."""
    rest = side_between(1e-3, 2e-3)
    whole = PI * exactly(2001.0) + rest
    variables = BoxVariables([rest, ONE / whole], [True, True], poles=1)
    angle = variables.variable(1, -1)
    turn = Turn(angle.powers, variables.variable(0), whole, is_half=True)
    near = Interval(np.float64(0.5 - 2.0**-53), np.float64(0.5 + 2.0**-53))
    value, _ = RULES["tan"](turn, angle.scaled(near))
    assert value.powers == (-1, 0, 0)
    assert reach_of(value.span) < 1e-5
    for x in np.linspace(1e-3, 2e-3, 11):
        assert holds(value, -1 / math.tan(x / 2))


def test_a_size_keeps_what_is_never_negative() -> None:
    variables = BoxVariables([side_between(0.0, 0.1), side_between(-0.2, -0.1)], [True, False])
    size = (variables.variable(0) * variables.variable(1)).size()
    assert size.powers == (1, 0)
    assert size.span.low[0] <= 0.1 < 0.2 <= size.span.high[0]


def test_a_pole_of_any_sign_keeps_it_in_its_size() -> None:
    """|1/x| is |x|/x**2 on both sides of 0."""
    variables = BoxVariables([side_between(-0.1, 0.2)], [False])
    size = variables.variable(0, -1).size()
    assert size.powers == (-2,)
    assert (size.span.low[0], size.span.high[0]) == (0.0, pytest.approx(0.2))


@pytest.mark.parametrize(
    ("y", "x"), [(-0.5, 2.0), (0.1, -2.0), (1e-3, 1e-3), (-3.0, -0.1), (-1.0, 0.0)]
)
def test_the_angle_of_a_point_is_held(y: float, x: float) -> None:
    for reach in (0.0, 1e-6, 1e-4):
        sides = [side_between(value - reach, value + reach) for value in (y, x)]
        variables = BoxVariables(sides, [False, False])
        angle, _ = RULES["arctan2"](None, variables.variable(0), variables.variable(1))
        span = angle.expanded()
        assert span.low[0] <= math.atan2(y, x) <= span.high[0]
        assert reach_of(span) <= 1e-14 + 4 * reach / math.hypot(y, x)


def test_an_angle_on_the_ray_of_half_a_turn_is_not_known() -> None:
    """The angle jumps by a whole turn from one side to the other."""
    variables = BoxVariables([side_between(-1e-9, 1e-9), side_between(-2.0, -1.0)], [False, False])
    angle, _ = RULES["arctan2"](None, variables.variable(0), variables.variable(1))
    assert not np.any(angle.expanded().is_finite)


def test_a_factor_of_both_sides_does_not_turn_a_point() -> None:
    """atan2(d*v, d*w) is atan(v/w) for d > 0 and w > 0, however small d is."""
    for is_positive, ahead in ((True, 0.5), (True, -0.5), (False, 0.5)):
        d = side_between(0.0 if is_positive else -0.1, 0.1)
        variables = BoxVariables([d, side_between(0.2, 0.201)], [is_positive, True])
        factor = variables.variable(0)
        y, x = factor * variables.variable(1), factor.scaled(exactly(ahead))
        angle, find_slopes = RULES["arctan2"](None, y, x)
        assert np.all(angle.expanded().is_finite) == (is_positive and ahead > 0)
        if is_positive and ahead > 0:
            assert holds(angle, math.atan2(0.2005, 0.5))
            square = 0.2005**2 + 0.5**2
            for slope, value in zip(find_slopes(), (0.5 / square, -0.2005 / square), strict=True):
                assert slope is not None
                assert holds(slope * factor, value)
                assert reach_of((slope * factor).expanded()) < 0.02


def test_extremes_hold_every_value_and_no_end_too_many() -> None:
    """The larger of 4/x, which has no finite interval, and a number keeps the factor 1/x."""
    variables = BoxVariables([side_between(0.0, 0.5)], [True])
    pole, three = variables.variable(0, -1).scaled(exactly(4.0)), variables.constant(exactly(3.0))
    larger, _ = RULES["maximum"](None, pole, three)
    assert larger.powers == (-1,)
    for x in (1e-9, 0.25, 0.5):
        assert larger.span.low[0] / x <= max(4 / x, 3) <= larger.span.high[0] / x
    assert larger.span.low[0] == 4.0
    variables = BoxVariables([side_between(0.0, 2.0)], [True])
    smaller, _ = RULES["minimum"](None, variables.variable(0), variables.constant(ONE))
    assert (smaller.span.low[0], smaller.span.high[0]) == (0.0, 1.0)


def test_a_value_next_to_zero_is_one_variable_for_equal_arguments() -> None:
    """Two arguments that are known only by the same box may differ."""
    variables = BoxVariables([side_between(1.5, 1.6)], [True], zeros=3)
    x = variables.variable(0)
    one, again = (RULES["cos"](None, x)[0] for _ in range(2))
    assert np.all((one / again).expanded().is_finite)
    other, _ = RULES["cos"](None, x.scaled(exactly(1.03125)))
    assert not np.any((one / other).expanded().is_finite)
    wide = variables.constant(side_between(1.5, 1.6))
    apart = [RULES["cos"](None, wide)[0] for _ in range(2)]
    assert not np.any((apart[0] / apart[1]).expanded().is_finite)


def test_what_vanishes_alike_has_a_finite_quotient() -> None:
    variables = BoxVariables([side_between(0.0, 0.1)], [True])
    x = variables.variable(0)
    sine, _ = RULES["sin"](None, x)
    quotient = ((sine + x) / x).expanded()
    assert quotient.low[0] <= 2 <= quotient.high[0]
    assert reach_of(quotient) < 4e-3


def test_a_pole_within_a_box_has_no_finite_value() -> None:
    variables = BoxVariables([side_between(1.5, 1.6)], [True], poles=1)
    value, _ = RULES["tan"](None, variables.variable(0))
    assert not value.expanded().is_finite[0]
    assert holds(value, math.tan(1.52), inverse=True)


def test_the_root_of_a_square_is_never_negative() -> None:
    variables = BoxVariables([side_between(-3.0, -2.0)], [False])
    root, _ = RULES["sqrt"](None, variables.variable(0).power(2))
    assert root.expanded().low[0] == pytest.approx(2.0)


def test_boxes_that_differ_are_told_apart() -> None:
    variables = BoxVariables([between(np.array([1.0, -2.0]), np.array([2.0, -1.0]))], [False])
    with pytest.raises(MixedBoxesError) as undecided:
        RULES["maximum"](None, variables.variable(0), variables.constant(exactly(0.0)))
    assert [mask.tolist() for mask in undecided.value.masks][:2] == [[True, False], [False, True]]


@pytest.mark.parametrize("power", [-2, -1, 1, 2, 3])
@pytest.mark.parametrize("side", [(0.5, 2.0), (-2.0, -0.5)])
def test_powers_hold_and_are_narrow(power: int, side: tuple[float, float]) -> None:
    span = side_between(*side).power(power)
    values = [x**power for x in np.linspace(*side, 21)]
    assert all(span.low[0] <= v + 1e-15 and v - 1e-15 <= span.high[0] for v in values)
    assert reach_of(span) <= 1.0001 * (max(values) - min(values))


def edge(boxes: Boxes) -> np.ndarray:
    """Return x + y at the far corner of each box, or infinity for a box 0.2 or wider in x."""
    small = boxes[:, 0, 1] - boxes[:, 0, 0] < 0.2
    return np.where(small, boxes[:, 0, 1] + boxes[:, 1, 1], math.inf)


def test_a_cover_has_all_parts_below_an_aim() -> None:
    found = cover_below(edge, ((0.0, 1.0), (0.0, 1.0)), 2.0, 1000, 2)
    assert found.open is None
    assert found.count > 16
    assert found.worst[0][0] == 2.0
    assert sum((b - a) * (d - c) for _, ((a, b), (c, d)) in found.worst) <= 1


def test_a_cover_names_a_box_that_stays_open() -> None:
    found = cover_below(edge, ((0.0, 1.0), (0.0, 1.0)), 1.9, 1000, 2)
    assert found.open is not None
    assert sum(high for _, high in found.open) > 1.9
    assert found.worst[0][1] == found.open


def test_what_has_no_bound_is_below_no_aim() -> None:
    box = ((0.0, 1.0), (0.0, 1.0))
    assert cover_below(
        lambda boxes: np.full(len(boxes), math.inf), box, math.inf, 1000, len(box)
    ).open


def test_a_cover_stops_when_there_are_enough_parts() -> None:
    assert cover_below(edge, ((0.0, 1.0), (0.0, 1.0)), 2.0, 20, 2).open is not None


def test_a_cover_is_cut_again() -> None:
    box = ((0.0, 1.0), (0.0, 1.0))
    found = cover_below(edge, box, 2.0, 1000, 2)
    parts, left = cut_again(box, 2, found.cuts)
    assert len(parts) == found.count
    assert not len(left)
    assert np.all(are_below(edge(parts), 2.0))
    sides = parts[:, :, 1] - parts[:, :, 0]
    assert np.sum(sides[:, 0] * sides[:, 1]) == 1
    assert len(np.unique(parts, axis=0)) == len(parts)


def test_cuts_of_no_box_are_refused() -> None:
    box = ((0.0, 1.0), (0.0, 1.0))
    found = cover_below(edge, box, 2.0, 1000, 2)
    for wrong in (found.cuts[:-1], np.where(found.cuts == 0, 2, found.cuts).astype(np.int8)):
        with pytest.raises(ValueError, match="parts do not match the cuts"):
            cut_again(box, 2, wrong)
    _, left = cut_again(box, 2, np.append(found.cuts, np.int8(0)))
    assert left.tolist() == [0]
