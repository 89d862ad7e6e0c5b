"""The digits that formulas of the standard deviation lose on readings far from zero."""

from __future__ import annotations

import numpy as np
import pytest
from ways import EPS, run

from mechproof.lab.ways import Arguments

DEVIATION = "measurement.standard_deviation"


def scattered(offset: float, rows: int = 8) -> Arguments:
    return (np.random.default_rng(4).normal(size=(rows, 12)) + offset,)


@pytest.mark.parametrize(("offset", "digits"), [(1e3, 6), (1e5, 10), (1e7, 14)])
def test_one_pass_loses_twice_the_digits_of_the_offset(offset: float, digits: int) -> None:
    worst = np.max(run(DEVIATION, "one pass", scattered(offset)).scaled)
    # The squared offset over the variance and over the sums' growth, within a digit or two.
    assert abs(np.log10(worst) - digits) < 2
    assert np.max(run(DEVIATION, "evaluate_type_a", scattered(offset)).scaled) <= 16


def test_one_pass_has_nothing_left_beyond_the_root_of_eps() -> None:
    """From an offset of 1/sqrt(eps) onwards, the squares have no digit of the scatter left."""
    for offset in (1 / np.sqrt(EPS), 1e10, 1e15):
        assert np.min(run(DEVIATION, "one pass", scattered(offset)).bits) > 44


def test_two_passes_lose_the_rounding_of_the_mean() -> None:
    """The square of that rounding, (eps*offset)**2, is added to the variance."""
    assert np.max(run(DEVIATION, "np.std", scattered(1e6)).scaled) < 16
    for offset in (1e10, 1e12, 1e14):
        expected = (EPS * offset) ** 2 / EPS
        worst = np.max(run(DEVIATION, "np.std", scattered(offset)).scaled)
        assert expected / 1000 < worst < 10 * expected
        assert np.max(run(DEVIATION, "evaluate_type_a", scattered(offset)).scaled) <= 16


def test_squares_that_underflow_are_lost_by_both() -> None:
    tiny = tuple(row * 1e-200 for row in scattered(0.0))
    for way in ("one pass", "np.std"):
        assert np.min(run(DEVIATION, way, tiny).bits) > 50
    assert np.max(run(DEVIATION, "evaluate_type_a", tiny).scaled) <= 16
