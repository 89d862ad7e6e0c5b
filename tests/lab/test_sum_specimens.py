"""Sums of errors: the bar where the squares are doubles, and what is lost beyond."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from mechproof.kernels import track_wheel as kernels
from mechproof.lab.error import Errors, find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.points import REPORT, draw_points, list_sets
from mechproof.lab.search import within_bar
from mechproof.lab.specimen import Arguments
from mechproof.lab.subject import Subject, find_subjects

SUMS = ("error_sum", "error_sum_correlated", "error_sum_thermal")
BEYOND = "squares beyond the doubles"


@cache
def subject(name: str) -> Subject:
    (found,) = find_subjects((f"track_wheel.{name}",))
    return found


def run(name: str, form: str, arguments: Arguments) -> Errors:
    specimen = next(s for s in subject(name).specimens if s.name == form)
    truth = find_truth(subject(name), arguments)
    assert truth.undecided == 0
    with np.errstate(all="ignore"):
        return find_errors(specimen.compute(*arguments), truth)


@pytest.mark.parametrize("name", SUMS)
def test_the_bar_holds_where_it_is_stated(name: str) -> None:
    bar = subject(name).quantity.bar
    assert bar is not None
    seen = 0
    for point_set in list_sets(subject(name)):
        points = draw_points(point_set, REPORT)
        held = within_bar(subject(name), points)
        errors = run(name, "kernel", points).scaled[held]
        assert np.all(errors <= bar.ulp), point_set.name
        seen += len(errors)
    assert seen >= 40


@pytest.mark.parametrize("name", SUMS)
def test_beyond_the_squares_the_sum_is_lost_and_not_called_held(name: str) -> None:
    beyond = next(s for s in list_sets(subject(name)) if s.name == BEYOND)
    points = draw_points(beyond, REPORT)
    assert not np.any(within_bar(subject(name), points))
    # Infinite or zero: no digit is left, and nobody could take the result for a small error.
    assert np.min(run(name, "kernel", points).bits) > 50


@pytest.mark.parametrize("size", [1e-50, 1e50])
def test_the_ends_of_the_range_are_kept(size: float) -> None:
    factors = np.full((1, 3), size)
    at = (factors, factors, factors, np.array([1.0]))
    assert run("error_sum", "kernel", at).scaled[0] <= 7
    alike = (factors, factors, factors, np.ones((1, 3, 3)), np.array([1.0]))
    assert run("error_sum_correlated", "kernel", alike).scaled[0] <= 8


def test_just_beyond_the_range_of_doubles_the_square_overflows() -> None:
    with np.errstate(over="ignore", under="ignore"):
        assert kernels.error_sum([1e155, 1.0], 1.0, 1.0, 1.0) == np.inf
        assert kernels.error_sum([1e-170, 1e-170], 1.0, 1.0, 1.0) == 0
    assert kernels.planar_error([1e155, 1.0, 0.0]) == 1e155


def test_the_root_of_a_difference_loses_what_the_share_takes() -> None:
    """1 - 1e-12 of the total: the difference of rounded squares has four digits left."""
    terms = np.full((1, 6), 0.1)
    one = np.ones((1, 6))
    at = (terms, one, one, np.array([1.2]), np.array([(1 - 1e-12) / 1.7]), np.array([1.2 * 1.7]))
    by_hand = run("error_sum_thermal", "squares under the root", at)
    ours = run("error_sum_thermal", "kernel", at)
    assert ours.scaled[0] <= 9
    assert by_hand.bits[0] > 30
