"""Error-free arithmetic: the rounding errors of operations, and how kernels use them."""

from __future__ import annotations

import sys
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from calls import RADII, spread

from mechproof.kernel_support import error_free
from mechproof.kernels import elliptic_planetary, oval_planetary

LARGEST = sys.float_info.max
HARD = (1.0, 1 / 3, np.pi, 1 + 2**-52, 2**27 + 1.0, 3e300, LARGEST / 8, 2.0**-960, 66 / 16, 80 / 30)


@pytest.mark.parametrize("a", HARD)
@pytest.mark.parametrize("b", [1.0, 0.1, -np.e, 1 - 2**-53, 7.0, 134217729.0 / 3])
def test_the_rest_of_a_product_is_exact(a: float, b: float) -> None:
    random = np.random.default_rng(33)
    for scale in (1.0, *random.uniform(0.5, 1, 20)):
        one, other = np.float64(a * scale), np.float64(b)
        with np.errstate(over="ignore"):
            product = one * other
        if not np.isfinite(product):
            continue
        with np.errstate(all="raise"):
            rest = error_free.product_rest(one, other, product)
        exact = Fraction(float(one)) * Fraction(float(other)) - Fraction(float(product))
        assert Fraction(float(rest)) == exact


def test_the_rest_of_a_sum_is_exact() -> None:
    random = np.random.default_rng(35)
    for a, b in random.uniform(-1, 1, (200, 2)) * 10 ** random.uniform(-9, 0, (200, 2)):
        small, large = sorted((np.float64(a), np.float64(b)), key=abs)
        total = large + small
        exact = Fraction(float(large)) + Fraction(float(small)) - Fraction(float(total))
        assert Fraction(float(error_free.sum_rest(large, small, total))) == exact
    # The order matters: here the larger comes second.
    assert error_free.sum_rest(1e-20, 1.0, 1.0) != 1e-20


def test_a_product_with_its_low_word_is_rounded_once() -> None:
    random = np.random.default_rng(36)
    naive = []
    for e1, e2 in (
        *random.uniform(0, 1, (200, 2)) ** 3,
        *1 - 10 ** random.uniform(-15, 0, (200, 2)),
    ):
        both, less, *_ = oval_planetary._prepare_of_acceleration(e1, e2, np.float64(0.0))
        one, other = Fraction(float(e1)), Fraction(float(e2))
        for value, exact in ((both, (1 + one) * (1 + other)), (less, (1 - one) * (1 - other))):
            half = Fraction(float(np.spacing(value))) / 2
            assert abs(Fraction(float(value)) - exact) <= half * (1 + Fraction(1, 2**50))
        naive.append(abs(Fraction(float((1 - e1) * (1 - e2))) - exact) > half)
    assert any(naive)


def test_the_rest_of_a_quotient_is_rounded_once() -> None:
    random = np.random.default_rng(34)
    for a, b in 10 ** random.uniform(-3, 3, (200, 2)):
        quotient = np.float64(a) / np.float64(b)
        exact = Fraction(float(a)) / Fraction(float(b)) - Fraction(float(quotient))
        rest = Fraction(float(error_free.quotient_rest(np.float64(a), np.float64(b), quotient)))
        assert abs(rest - exact) <= Fraction(1, 2**53) * abs(exact)


def test_the_small_tangent_keeps_to_one() -> None:
    values = np.array([-1e300, -1.0, -1e-300, 0.0, 1e-9, 2.0, np.nan])
    expected = [-1.0, -1.0, -1e-300, 0.0, 1e-9, 1.0, np.nan]
    assert np.array_equal(error_free.small_tangent(values), expected, equal_nan=True)


@pytest.mark.parametrize("name", ["position", "ratio", "acceleration"])
@pytest.mark.parametrize("e", [0.3, 0.9, 1 - 1e-12])
def test_the_whole_range_of_doubles(name: str, e: float) -> None:
    """No angle overflows on the way, up to where R1/R2*phi1 itself does."""
    kernel = getattr(elliptic_planetary, name)
    with np.errstate(all="raise", under="ignore"):
        for phi in (5e-324, 1e-310, 1e-300, 1e166, 1e200, 1e300, 3e307):
            assert np.isfinite(kernel(phi, *RADII, e))
    if name == "position":
        # The arctangent is at most pi: nothing compared with an angle of 1e300.
        assert abs(kernel(1e300, *RADII, e) / (1e300 * (1 + 4.125)) - 1) <= np.finfo(float).eps


def test_what_the_plain_product_costs() -> None:
    """About half the bound of `position`, in eps of the value, where e <= 12/25, whatever R1/R2."""
    e = np.linspace(0, 0.48, 25)[:, np.newaxis]
    x = np.linspace(1e-6, 40 * np.pi, 20_001)
    turn = x + 2 * np.arctan2(e * np.sin(x), 1 - e * np.cos(x))
    slope = (1 - e**2) / (1 + e**2 - 2 * e * np.cos(x)) - 1
    # A finite R1/R2 adds phi1 to the value and lowers the cost.
    cost = (np.abs(x * slope) / turn).max(axis=1)
    assert (cost <= 1.01 * 2 * e[:, 0] / (1 - e[:, 0]) + 1e-300).all()
    assert cost.max() > 1.84


def test_the_low_word_is_paid_for_only_above_its_threshold(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(*words: Any) -> Any:
        raise AssertionError("low word asked for")

    monkeypatch.setattr(elliptic_planetary, "_product_rest", refuse)
    assert elliptic_planetary.position(spread(2), *RADII, [0.0, 0.48]).shape == (2,)
    for e in (np.nextafter(0.48, 1), [0.1, 0.9]):
        with pytest.raises(AssertionError, match="low word asked for"):
            elliptic_planetary.position(spread(2), *RADII, e)


def random_doubles(count: int) -> np.ndarray:
    random = np.random.default_rng(37)
    return random.uniform(-2, 2, count) * 10.0 ** random.integers(-20, 20, count)


@pytest.mark.parametrize(
    "function",
    [
        lambda a, b: error_free.product_rest(a, b, a * b),
        lambda a, b: error_free.quotient_rest(a, b, a / b),
        lambda a, b: error_free.small_tangent(a),
    ],
)
def test_rests_have_the_same_bits_of_numbers_and_in_arrays(function: Any) -> None:
    a, b = random_doubles(500).reshape(2, -1)
    point = [function(np.float64(x), np.float64(y)) for x, y in zip(a, b, strict=True)]
    assert [function(float(x), float(y)) for x, y in zip(a, b, strict=True)] == point
    assert function(a, b).tolist() == point
    for x, y in ((float(a[0]), b), (a, float(b[0]))):
        wide = np.broadcast_to(x, 250), np.broadcast_to(y, 250)
        assert np.array_equal(function(x, y) + np.zeros(250), function(*wide))
