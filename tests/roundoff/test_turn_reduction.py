"""Reduction by whole turns: the error of the reduced angle is bounded, or refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from alterations import change, prove_changed
from flint import arb

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.intervals import EPS, Interval
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.program import Operation
from mechproof.roundoff.elementary_errors import prove
from mechproof.roundoff.reduction import bound_reduction, find_nearest


def test_angles_that_are_not_reduced_have_no_bound() -> None:
    far = np.array([2 * DOUBLE.largest, np.nan])
    assert np.isnan(prove("sin").of_angle(Interval(far, far), Interval(far, far))).all()


def test_no_double_is_nearer_to_a_quarter_turn() -> None:
    """The doubles next to these multiples of pi/2 are no nearer than the least distance found."""
    least = find_nearest(DOUBLE.largest)
    with working_precision(200):
        near = [arb(n) * arb.pi() / 2 for n in (*range(1, 2000), *range(2**25, 2**25 + 2000))]
        rests = [float(abs(arb(float(x)) - x)) for x in near]
    assert 0 < least <= min(rests)


def test_a_reduction_by_fewer_words_is_refused() -> None:
    words = (-1.5707963267948966, -6.123233995736766e-17, 1.4973849048591698e-33)
    per = 0.6366197723675814
    assert 0 < bound_reduction(per, words).far < 0.1
    assert bound_reduction(per, (*words[:2], 0.0)).near > 1e6
    for wrong in (words[:2], (words[0], -words[1], words[2])):
        with pytest.raises(ValueError, match="quarter turn"):
            bound_reduction(per, wrong)
    with pytest.raises(ValueError, match="nearest"):
        bound_reduction(per * (1 + 2.0**-30), words)
    with pytest.raises(ValueError, match="may be rounded"):
        bound_reduction(per, (words[0] + 2.0**-20, *words[1:]))


def test_a_decision_without_a_rule_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def swap(step: Operation) -> Operation:
        return replace(step, kind="rint") if step.kind == "floor" else step

    # Halves of odd numbers are rounded to even ones, which gives another sign.
    with pytest.raises(ValueError, match="rounding depends on the number of turns"):
        prove_changed("cos", change("cos", swap), monkeypatch)


@pytest.mark.parametrize("added", [2 - EPS, 2.0**60])
def test_numbers_of_quarter_turns_that_are_rounded_are_refused(
    added: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unrounded, adding 2 - eps would give the signs of adding 1; large numbers round it away."""

    def add(step: Operation) -> Operation:
        wrong = step.kind == "add" and step.operands[1:] == (1.0,)
        return replace(step, operands=(step.operands[0], added)) if wrong else step

    with pytest.raises(ValueError, match="may be rounded"):
        prove_changed("cos", change("cos", add), monkeypatch)
