"""The standard deviation of readings far from zero: where one pass and two passes lose it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from mechproof.lab.error import Errors, find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.points import REPORT, draw_points, list_sets
from mechproof.lab.specimen import Arguments
from mechproof.lab.subject import Subject, find_subjects
from mechproof.measurement import evaluate_type_a

EPS = float(np.finfo(float).eps)


@cache
def deviation() -> Subject:
    (found,) = find_subjects(("standard_deviation",))
    return found


def run(form: str, arguments: Arguments) -> Errors:
    specimen = next(s for s in deviation().specimens if s.name == form)
    truth = find_truth(deviation(), arguments)
    assert truth.undecided == 0
    with np.errstate(all="ignore"):
        return find_errors(specimen.compute(*arguments), truth)


def scattered(offset: float) -> Arguments:
    return (np.random.default_rng(4).normal(size=(30, 12)) + offset,)


def test_ours_keeps_the_bar_on_every_set() -> None:
    for point_set in list_sets(deviation()):
        points = draw_points(point_set, REPORT)
        assert np.max(run("kernel", points).scaled) <= 16, point_set.name


def test_the_sets_reach_where_nothing_but_the_last_digits_scatters() -> None:
    far = next(s for s in list_sets(deviation()) if s.name.startswith("offset 1e8"))
    (rows,) = draw_points(far, REPORT)
    ratio = np.abs(rows).max(axis=1) / np.ptp(rows, axis=1)
    assert ratio.max() > 1e14
    assert np.abs(rows).max() > 1e14
    # One pass has no digit of any of them, and loses most as the root of a negative number.
    lost = run("one pass", (rows,))
    assert np.all(lost.bits > 50)
    assert np.mean(np.isinf(lost.scaled)) > 0.2


@pytest.mark.parametrize(("offset", "digits"), [(1e3, 6), (1e5, 10), (1e7, 14)])
def test_one_pass_loses_twice_the_digits_of_the_offset(offset: float, digits: int) -> None:
    worst = np.max(run("one pass", scattered(offset)).scaled)
    # The square of the offset, over the variance, over the sums' growth: within a digit or two.
    assert abs(np.log10(worst) - digits) < 2
    assert np.max(run("kernel", scattered(offset)).scaled) <= 16


def test_one_pass_has_nothing_left_beyond_the_root_of_eps() -> None:
    """From an offset of 1/sqrt(eps) on the squares have no digit of the scatter."""
    for offset in (1 / np.sqrt(EPS), 1e10, 1e15):
        assert np.min(run("one pass", scattered(offset)).bits) > 44


def test_two_passes_lose_the_rounding_of_the_mean() -> None:
    """Its square, (eps*offset)**2, is added to the variance."""
    assert np.max(run("np.std", scattered(1e6)).scaled) < 16
    for offset in (1e10, 1e12, 1e14):
        expected = (EPS * offset) ** 2 / EPS
        worst = np.max(run("np.std", scattered(offset)).scaled)
        assert expected / 1000 < worst < 10 * expected
        assert np.max(run("kernel", scattered(offset)).scaled) <= 16


def test_squares_that_underflow_are_lost_by_both() -> None:
    tiny = tuple(row * 1e-200 for row in scattered(0.0))
    assert np.min(run("one pass", tiny).bits) > 50
    assert np.min(run("np.std", tiny).bits) > 50
    assert np.max(run("kernel", tiny).scaled) <= 16


def test_masked_readings_are_refused() -> None:
    """A mask would be dropped by the conversion: what is masked would count as a reading."""
    readings = np.ma.masked_array([1e8, 1e8 + 1, 1e300], mask=[False, False, True])
    with pytest.raises(TypeError, match="masked"):
        evaluate_type_a(readings)
    assert evaluate_type_a(readings.compressed()).standard_deviation == pytest.approx(np.sqrt(0.5))
