"""Laws, simulated shares, conformance probability, and the errors that bad input gets."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from cases import INF, four
from scipy import stats
from scipy.integrate import quad

from mechproof.conformity import (
    Law,
    Normal,
    TruncatedNormal,
    Uniform,
    conformance_probability,
    shares,
    simulate_shares,
)

LAWS: dict[str, tuple[Law, Any]] = {
    "normal": (Normal(1, 2), stats.norm(1, 2)),
    "multiple": (Normal.from_width(1, 12, 6), stats.norm(1, 2)),
    "rectangular": (Uniform.from_width(1, 4), stats.uniform(-1, 4)),
    "truncated": (TruncatedNormal(1, 2, -1, 6), stats.truncnorm(-1, 2.5, 1, 2)),
    "truncated tail": (TruncatedNormal(0, 1, 8, INF), stats.truncnorm(8, INF)),
    "truncated far below": (TruncatedNormal(0, 1, -30, -29), stats.truncnorm(-30, -29)),
}


@pytest.mark.parametrize("name", LAWS)
def test_laws_match_scipy_and_their_samples(name: str) -> None:
    law, reference = LAWS[name]
    x = np.append(reference.ppf(np.linspace(0.01, 0.99, 21)), [-50, 50, np.nan])
    np.testing.assert_allclose(law.pdf(x), reference.pdf(x), rtol=1e-11, atol=1e-300)
    np.testing.assert_allclose(law.cdf(x), reference.cdf(x), rtol=1e-11, atol=1e-300)
    values = law.sample(np.random.default_rng(5), 20000)
    # False alarm with probability 1e-6 per law.
    assert stats.kstest(values, reference.cdf).pvalue > 1e-6


@pytest.mark.parametrize("width", [1e-4, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("start", [-3.0, -1e-13, 0.0, 0.5, 5.0])
def test_a_narrow_window_is_sampled_all_over(start: float, width: float) -> None:
    """The tails' masses hardly differ there; the density varies by less than 6e-4 across it."""
    law = TruncatedNormal(0, 1, start, start + width)
    values = law.sample(np.random.default_rng(6), 20000)
    assert (law.lower <= values).all()
    assert (values <= law.upper).all()
    # False alarm with probability 1e-6 per law.
    assert stats.kstest(values, stats.uniform(start, width).cdf).pvalue > 1e-6


def test_samples_of_several_parameter_sets_are_their_own() -> None:
    law = TruncatedNormal([0.0, 5.0, 0.0], [1.0, 1.0, 1e9], [[-1.0], [8.0]], [[1.0], [9.0]])
    values = law.sample(np.random.default_rng(7), (1000, 2, 3))
    for at in np.ndindex(2, 3):
        ends = [
            (end[at[0], 0] - law.mean[at[1]]) / law.std[at[1]] for end in (law.lower, law.upper)
        ]
        reference = stats.truncnorm(*ends, law.mean[at[1]], law.std[at[1]])
        # False alarm with probability 1e-6 per law.
        assert stats.kstest(values[:, *at], reference.cdf).pvalue > 1e-6


@pytest.mark.parametrize(
    ("true", "error"),
    [
        (Normal(0.2, 1), Normal(0.1, 0.3)),
        (Uniform(-4, 4), Normal(0, 0.3)),
        (Normal(0, 1), Uniform(-0.5, 0.7)),
        (TruncatedNormal(0, 1, -3.5, 2), TruncatedNormal(0, 0.3, -0.6, 0.6)),
    ],
)
def test_simulation_agrees_within_its_standard_errors(true: Law, error: Law) -> None:
    windows = (-2, 1.5), (-1.9, 1.6)
    exact = shares(true, error, *windows)
    found = simulate_shares(
        true, error, *windows, rng=np.random.default_rng(11), count=200_000, chunk=30_000
    )
    # Six standard errors, 16 comparisons: false alarm below 1e-7 (normal limit of the counts).
    for value, mean, deviation in zip(
        four(exact), four(found), four(found.standard_error), strict=True
    ):
        assert abs(mean - value) < 6 * deviation
    assert sum(four(found)) == pytest.approx(1, abs=1e-15)


def test_errors_add_up_and_parameters_broadcast_in_a_simulation() -> None:
    bias, spread = np.array([0.1, 0.2, np.nan]), np.array([[1.0], [2.0]])
    parts = [Normal(0, 0.3), Normal(bias, 0.4)]
    found = simulate_shares(
        Normal(0, spread), parts, (-2, 2), rng=np.random.default_rng(3), count=50_000
    )
    exact = shares(Normal(0, spread), Normal(bias, 0.5), (-2, 2))
    for value, mean, deviation in zip(
        four(exact), four(found), four(found.standard_error), strict=True
    ):
        assert mean.shape == (2, 3)
        assert np.isnan(mean[:, 2]).all()
        # Six standard errors, 16 comparisons: false alarm below 1e-7.
        assert (np.abs(mean - value) < 6 * deviation)[:, :2].all()


def test_no_part_counted_gives_a_bound_and_no_standard_error() -> None:
    found = simulate_shares(
        Normal(0, 1), Normal(0, 0.1), (-30, 30), rng=np.random.default_rng(0), count=1000
    )
    assert found.wrongly_accepted == 0
    assert np.isnan(found.standard_error.wrongly_accepted)
    assert found.upper.wrongly_accepted == pytest.approx(1 - 0.05 ** (1 / 1000), rel=1e-9)
    assert found.lower.wrongly_accepted == 0
    assert found.lower.rightly_accepted == pytest.approx(0.05 ** (1 / 1000), rel=1e-9)
    assert found.upper.rightly_accepted == 1


def test_simulation_and_shares_keep_memory_bounded() -> None:
    tracemalloc.start()
    try:
        simulate_shares(
            Normal(0, 1),
            Normal(0, 1),
            (-1, 1),
            rng=np.random.default_rng(0),
            count=1_000_000,
            chunk=10_000,
        )
        # Some ten arrays of a chunk of 10,000 doubles; a million at once would need 8 MB each.
        assert tracemalloc.get_traced_memory()[1] < 3_000_000
    finally:
        tracemalloc.stop()


def test_conformance_probability_integrates_to_the_shares() -> None:
    true, error, windows = Normal(0.1, 1), Normal(0.05, 0.4), ((-2, 1.5), (-1.8, 1.2))
    law = stats.norm(0.15, np.hypot(1, 0.4))
    exact = shares(true, error, *windows)
    for index, share in enumerate((exact.rightly_accepted, exact.wrongly_accepted)):
        total, _ = quad(
            lambda m, i=index: law.pdf(m) * conformance_probability(m, true, error, windows[0])[i],
            *windows[1],
            epsabs=0,
            epsrel=1e-12,
        )
        assert total == pytest.approx(share, rel=1e-11)


def test_conformance_probability_of_a_fixed_value() -> None:
    probability, outside = conformance_probability(
        [0.0, 5.0, np.nan], Normal(1, 0), Normal(0, 1), (0, 2)
    )
    np.testing.assert_array_equal(probability, [1, 1, np.nan])
    np.testing.assert_array_equal(outside, [0, 0, np.nan])
    assert conformance_probability(2.0, Normal(1, 1), Normal(0, 0), (0, 2)) == (0, 1)


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda: Normal(0, -1), r"std = -1: must not be negative"),
        (lambda: Normal(INF, 1), r"mean = inf: must be finite"),
        (lambda: Normal.from_width(0, 45, 0), r"multiple = 0: must be positive"),
        (lambda: Normal.from_width(0, -45, 6), r"width = -45: must not be negative"),
        (lambda: Uniform(1, 1), r"lower.*below the upper"),
        (lambda: Uniform(0, INF), r"upper.*must be finite"),
        (lambda: TruncatedNormal(0, 0, -1, 1), r"std = 0: must be positive"),
        (lambda: TruncatedNormal(0, 1, 2, 1), r"lower.*below the upper"),
        (lambda: TruncatedNormal(0, 1, 50, 60), r"no mass between them"),
        (lambda: shares(Normal(0, 1), Normal(0, 1), (3, -3)), r"tolerance.*\(3, -3\)"),
        (lambda: shares(Normal(0, 1), Normal(0, 1), (-3, 3), (2, 2)), r"acceptance.*\(2, 2\)"),
        (
            lambda: simulate_shares(
                Normal(0, 1), Normal(0, 1), (-3, 3), rng=np.random.default_rng(), count=0
            ),
            r"count = 0: must be at least 1",
        ),
    ],
)
def test_bad_input_is_named(act: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        act()


@pytest.mark.parametrize(
    "law", [Normal(0, 1), Normal(0, 0), Uniform(-1, 1), TruncatedNormal(0, 1, -2, 3)], ids=repr
)
def test_every_value_is_outside_reversed_limits(law: Law) -> None:
    lower, upper = np.array([1.0, 0.0, 0.5, np.inf, 2.0]), np.array([-1.0, 0.0, -0.1, -np.inf, 2.0])
    assert law.probability(lower, upper).tolist() == [0.0] * 5
    # A sum of two rounded tails.
    np.testing.assert_allclose(law.outside(lower, upper), 1.0, rtol=4e-16)
    assert (law.outside(lower, upper) <= 1).all()
    assert np.isnan(law.outside(np.nan, -1.0))


def test_a_size_that_repeats_values_is_refused() -> None:
    rng = np.random.default_rng(1)
    for law in (Normal([0, 0], 1), Uniform([0, 0], 1), TruncatedNormal([0, 0], 1, -1, 1)):
        assert law.sample(rng).shape == law.sample(rng, 2).shape == (2,)
        for size in (1, (2, 1), ()):
            with pytest.raises(ValueError, match=r"^size = .*shape of the parameters, \(2,\)"):
                law.sample(rng, size)
