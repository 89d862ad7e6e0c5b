"""What laws and shares refuse, and when laws are equal."""

from __future__ import annotations

import warnings
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mechproof.conformity import (
    Law,
    Normal,
    TruncatedNormal,
    Uniform,
    conformance_probability,
    shares,
    simulate_shares,
)

ONE = Normal(0, 1)
LAWS: list[Law] = [ONE, Uniform(-1, 1), TruncatedNormal(0, 1, -1, 1)]


def test_fractions_are_real_numbers() -> None:
    assert Normal(Fraction(1, 2), 1) == Normal(0.5, 1)


@pytest.mark.parametrize("limits", [40, (1, 2, 3), None, [1]])
def test_what_is_no_pair_of_limits_is_named(limits: Any, find: Any) -> None:
    message = r"must be a pair \(lower, upper\)"
    with pytest.raises(TypeError, match=r"^tolerance = .*" + message):
        find(ONE, ONE, limits)
    with pytest.raises(TypeError, match=r"^tolerance = .*" + message):
        conformance_probability(0, ONE, ONE, limits)
    if limits is not None:
        with pytest.raises(TypeError, match=r"^acceptance = .*" + message):
            find(ONE, ONE, (-1, 1), limits)


def test_what_is_no_law_is_named(find: Any) -> None:
    wrong: Any = 3
    with pytest.raises(TypeError, match=r"^true = 3: must be a law, Normal or Uniform"):
        find(wrong, ONE, (-1, 1))
    with pytest.raises(TypeError, match=r"^error = 3: must be a law"):
        find(ONE, wrong, (-1, 1))
    with pytest.raises(TypeError, match=r"^error\[1\] = 3: must be a law"):
        simulate_shares(ONE, [ONE, wrong], (-1, 1), rng=np.random.default_rng(1), count=3)
    uniform: Any = Uniform(-1, 1)
    with pytest.raises(TypeError, match=r"^error = Uniform.*must be a law, Normal$"):
        conformance_probability(0, ONE, uniform, (-1, 1))


@pytest.mark.parametrize("width", [1e151, 1e307, 1.7e308])
def test_widths_beyond_the_range_are_refused(width: float) -> None:
    for make, name in (
        (lambda: Normal(0, width), "std"),
        (lambda: Normal(-width, 1), "mean"),
        (lambda: Uniform(-width, width), "lower"),
        (lambda: TruncatedNormal(0, 1, -1, width), "upper"),
        (lambda: shares(ONE, ONE, (-width, 0)), r"tolerance\[0\]"),
    ):
        with pytest.raises(ValueError, match=rf"^{name} = .*between -1e\+150 and 1e\+150"):
            make()


@pytest.mark.slow
@pytest.mark.parametrize("part", [1e150, 1e100, 1e6, 1e-6, 1e-100, 1e-150])
@pytest.mark.parametrize("whole", [1e150, 1.0, 1e-150])
def test_the_shares_add_up_to_one(whole: float, part: float, find: Any) -> None:
    for true in (Normal(0, whole), Uniform(-whole, whole), TruncatedNormal(0, whole, 0, whole)):
        for error in (Normal(0, part), Uniform(0, part), TruncatedNormal(0, part, -part, part)):
            for tolerance in ((-whole, whole), (-part, part), (-np.inf, part)):
                found = find(true, error, tolerance)
                four = np.array(list(vars(found).values()))
                assert (four >= 0).all()
                # The stated accuracy of a share.
                assert abs(four.sum() - 1) <= 1e-12, (true, error, tolerance)


def test_scalars_have_narrow_windows() -> None:
    """Each of these calls once failed in an assignment to a scalar."""
    # erf(0.1/sqrt(2)), and for 1e-9 the density times the width.
    assert ONE.probability(-0.1, 0.1) == pytest.approx(0.07965567455405798, rel=1e-15)
    assert ONE.probability(0, 1e-9) == pytest.approx(1e-9 / np.sqrt(2 * np.pi), rel=1e-15)
    assert type(ONE.probability(-0.1, 0.1)) is np.float64
    law = TruncatedNormal(0, 10, -1, 1)
    assert law.probability(-1, 1) == 1
    assert law.cdf(0) == pytest.approx(0.5, rel=1e-15)
    array = Normal(np.zeros(1), 1).probability(-0.1, 0.1)
    assert ONE.probability(-0.1, 0.1) == array[0]


def test_laws_are_equal_by_value() -> None:
    assert Normal(0, 1) == Normal(0.0, 1.0)
    assert Normal([0, 1], 1) == Normal(np.array([0.0, 1.0]), 1)
    assert Normal(np.nan, 1) == Normal(np.nan, 1)
    assert Uniform(0, 1) == Uniform(0, 1)
    assert TruncatedNormal(0, 1, -1, 1) == TruncatedNormal(0, 1, -1, 1)
    assert len({Normal(0, 1), Normal(-0.0, 1), Normal(np.nan, 1), Normal(np.nan, 1)}) == 2


def test_laws_differ_by_kind_shape_and_value() -> None:
    assert Normal(0, 1) != Uniform(0, 1)
    assert Normal(0, 1) != Normal([0], 1)
    assert Normal([0, 1], 1) != Normal([0, 2], 1)
    assert Normal(0, 1) != (0, 1)
    assert hash(Normal(0, 1)) != hash(Normal([0], 1))


def test_a_law_keeps_its_own_parameters() -> None:
    mean = np.array([0.0, 1.0])
    law = Normal(mean, 1)
    mean[0] = 7
    assert law == Normal([0, 1], 1)


def test_missing_numbers_warn_of_nothing(find: Any) -> None:
    odd = np.array([np.nan, np.inf, -np.inf, 0.0, 1e300])
    unknown = Normal(np.nan, 1), Uniform(np.nan, 1), TruncatedNormal(np.nan, 1, -1, 1)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for law in (*LAWS, *unknown, Normal(0, 0)):
            law.pdf(odd), law.cdf(odd), law.probability(odd, odd[::-1]), law.outside(-1, odd)
        for true in (*LAWS, *unknown):
            for error in (*LAWS, *unknown):
                for tolerance in ((-1, 1), (-np.inf, np.inf), (np.nan, 1)):
                    found = find(true, error, tolerance)
                    missing = any(np.isnan([*vars(law).values()]).any() for law in (true, error))
                    assert np.isnan(found.rightly_accepted) == (
                        missing or tolerance[0] != tolerance[0]
                    )
        conformance_probability(odd[[0, 3]], ONE, Normal(0, 0), (-1, 1))
