from __future__ import annotations

import numpy as np
import pytest

from mechproof.kernel_support.order import step_ulps
from mechproof.lab.oracle import ALL_BITS, Truth, find_errors, summarise
from mechproof.lab.sampling.named_sets import draw_ladder


def truth_of(high: object, low: float = 0.0, decided: object = True) -> Truth:
    values = np.asarray(high, float)
    known = np.broadcast_to(np.asarray(decided), values.shape[:1]).copy()
    size = np.abs(values.reshape(len(values), -1)).max(axis=1)
    return Truth(values, np.full_like(values, low), known, size)


def test_one_ulp_is_one_bit() -> None:
    exact = np.array([1.5, -7.25, 1e-300, 1e300])
    errors = find_errors(np.nextafter(exact, np.inf), truth_of(exact))
    assert errors.ulp.tolist() == [1, 1, 1, 1]
    assert errors.bits.tolist() == [1, 1, 1, 1]


def test_the_low_word_counts() -> None:
    errors = find_errors(np.array([1.0]), truth_of([1.0], low=2.0**-54))
    assert errors.ulp[0] == 0.25


def test_lost_results_lose_all_bits() -> None:
    exact = truth_of([1.0, 2.0, 3.0])
    errors = find_errors(np.array([np.nan, np.inf, 3.0]), exact)
    assert errors.bits.tolist() == [ALL_BITS, ALL_BITS, 0]
    summary = summarise(errors, exact)
    assert (summary.nan, summary.infinite, summary.worst_ulp) == (1, 1, np.inf)


def test_wrong_branches_are_counted() -> None:
    exact = truth_of([1.0, 2.0, 3.0])
    errors = find_errors(np.array([1.0, 2.0 + 2 * np.pi, 3.0 - 0.1]), exact)
    assert summarise(errors, exact, 2 * np.pi).wrong_branch == 1
    assert summarise(errors, exact).wrong_branch == 0


def test_an_error_without_a_scale_is_not_excused() -> None:
    exact = Truth(np.zeros(2), np.zeros(2), np.ones(2, bool), np.full(2, np.nan))
    errors = find_errors(np.array([0.0, 1e-16]), exact)
    assert errors.scaled.tolist() == [0, np.inf]
    assert summarise(errors, exact).worst_scaled == np.inf


def test_undecided_points_have_no_error() -> None:
    exact = truth_of([1.0, np.nan], decided=[True, False])
    summary = summarise(find_errors(np.array([1.0, 5.0]), exact), exact)
    assert (summary.undecided, summary.worst_ulp) == (1, 0)
    nothing = truth_of([np.nan], decided=[False])
    assert np.isnan(summarise(find_errors(np.array([5.0]), nothing), nothing).worst_ulp)


def test_vectors_are_measured_by_their_norm() -> None:
    errors = find_errors(np.array([[3.0, 4.0, 1.0]]), truth_of([[3.0, 4.0, 0.0]]))
    assert errors.absolute[0] == 1
    assert errors.ulp[0] == 1 / np.spacing(5.0)


def test_another_shape_is_refused() -> None:
    with pytest.raises(ValueError, match=r"shape \(2,\)"):
        find_errors(np.zeros(2), truth_of([1.0]))


def test_steps_of_ulps_are_those_of_nextafter() -> None:
    values = np.array([1.0, -1.0, 2.0, 0.0, 5e-324, -5e-324, 1e300])
    assert np.array_equal(step_ulps(values, np.ones(7, int)), np.nextafter(values, np.inf))
    assert np.array_equal(step_ulps(values, -np.ones(7, int)), np.nextafter(values, -np.inf))
    assert step_ulps(np.array([5e-324]), np.array([-2]))[0] == -5e-324


def test_steps_of_ulps_warn_of_nothing() -> None:
    with np.errstate(all="raise"):
        assert step_ulps(np.array(1e300), np.array(-3)) == 1e300 - 3 * np.spacing(1e300)


def test_a_ladder_reaches_its_ends() -> None:
    size = np.abs(draw_ladder(np.random.default_rng(0), 300))
    assert size.min() < 1e-298
    assert 1e-2 < size.max() <= 0.1
