"""Type A and B evaluation, coverage intervals, and errors of position."""

import math
import subprocess
import sys
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

from mechproof.measurement import (
    CoverageInterval,
    Estimate,
    TypeA,
    TypeB,
    combine,
    evaluate_position_errors,
    evaluate_type_a,
    position_errors,
    wrap_angle,
)

EPS = np.finfo(float).eps


def test_published_intervals_of_the_elliptic_planetary() -> None:
    published = {-0.93: (0.82, 1.64), -0.98: (1.36, 2.72), -0.89: (1.01, 2.02)}
    for value, (uncertainty, half) in published.items():
        interval = Estimate(value, uncertainty).expand(2)
        assert interval.expanded_uncertainty == half
    # Variant 3 is printed with ± 0.28, which is k = 1.
    assert Estimate(0.68, 0.28).expand(2).expanded_uncertainty == 0.56


# Type A


def exact_type_a(readings: np.ndarray) -> tuple[Fraction, Fraction]:
    values = [Fraction(float(x)) for x in readings]
    mean = sum(values, Fraction(0)) / len(values)
    return mean, sum(((x - mean) ** 2 for x in values), Fraction(0)) / (len(values) - 1)


def relative_error_of_root(value: float, square: Fraction) -> float:
    # value = √square (1 + d): value²/square - 1 = 2d + d².
    return float(abs(Fraction(value) ** 2 / square - 1)) / 2


@pytest.mark.parametrize("count", [2, 3, 10, 1000, 5000])
@pytest.mark.parametrize("offset", [0.0, 1.0, 1e9, -1e15])
def test_large_common_offset_costs_no_digits(offset: float, count: int) -> None:
    scatter = 1e-3 if abs(offset) < 1e10 else 1.0
    readings = offset + np.random.default_rng(count).normal(0, scatter, count)
    mean, variance = exact_type_a(readings)
    result = evaluate_type_a(readings)
    if offset:
        # Half an ulp of the last addition; the correction's own error is far smaller.
        assert abs(Fraction(result.mean) - mean) <= Fraction(float(np.spacing(abs(result.mean))))
    # The sum of squares meets at most 16 + 3 + log2(n/128) < 30 roundings (NumPy adds pairwise
    # in blocks of 128 by eight), every square three more, all halved by the root: below 16 eps.
    assert relative_error_of_root(result.standard_deviation, variance) <= 16 * EPS
    assert result.count == count


def test_textbook_variance_fails_the_same_check() -> None:
    readings = 1e9 + np.random.default_rng(0).normal(0, 1e-3, 1000)
    _, variance = exact_type_a(readings)
    one_pass = np.mean(readings**2) - np.mean(readings) ** 2
    assert relative_error_of_root(math.sqrt(abs(one_pass)), variance) > 0.1


@pytest.mark.parametrize("count", [3, 10, 1000, 9999])
@pytest.mark.parametrize("reading", [0.1, -5.3, 1e9 + 0.1])
def test_identical_readings_have_no_scatter(reading: float, count: int) -> None:
    # NumPy's mean of these readings is off by up to 2 ulp.
    result = evaluate_type_a(np.full(count, reading))
    assert (result.mean, result.standard_deviation) == (reading, 0)


@pytest.mark.parametrize("scale", [1e-200, 1e150, 1e300])
def test_squares_do_not_leave_the_range_of_a_double(scale: float) -> None:
    readings = np.array([1.0, 2.0, 4.0]) * scale
    _, variance = exact_type_a(readings)
    assert relative_error_of_root(evaluate_type_a(readings).standard_deviation, variance) < 4 * EPS


def test_words_of_type_a() -> None:
    result = evaluate_type_a([1, 2, 3, 6])
    assert (result.mean, result.count, result.degrees_of_freedom) == (3.0, 4, 3)
    assert result.standard_deviation == pytest.approx(math.sqrt(14 / 3), rel=4 * EPS)
    assert result.uncertainty == result.standard_deviation / 2
    assert evaluate_type_a([5.0, 5.0]).standard_deviation == 0


def test_nan_reading_propagates() -> None:
    result = evaluate_type_a([1.0, math.nan, 2.0])
    assert math.isnan(result.mean)
    assert math.isnan(result.uncertainty)
    assert result.count == 3
    estimate = combine(result, TypeB(0.1), unit="°")
    assert str(estimate) == "nan(nan)°"
    assert math.isnan(estimate.degrees_of_freedom)
    assert math.isnan(estimate.cover(0.95).upper)


# Combination and coverage


def test_welch_satterthwaite() -> None:
    # Parts 3 and 4 with 9 and 16 degrees of freedom: 5, with 625/(81/9 + 256/16) = 25.
    estimate = combine(TypeA(1.0, 3 * math.sqrt(10), 10), TypeB(4.0, 16))
    assert estimate.uncertainty == pytest.approx(5, rel=4 * EPS)
    assert estimate.degrees_of_freedom == pytest.approx(25, rel=32 * EPS)


def test_degrees_of_freedom_at_the_limits() -> None:
    readings = TypeA(0.0, 1.0, 4)
    assert combine(readings).degrees_of_freedom == pytest.approx(3, rel=8 * EPS)
    assert combine(TypeA(0.0, 0.0, 4), TypeB(1.0)).degrees_of_freedom == math.inf
    assert combine(TypeA(0.0, 0.0, 4), TypeB(0.0)).degrees_of_freedom == 3
    assert combine(TypeA(0.0, 1e-200, 4), TypeB(1e-200)).uncertainty > 0


def test_type_b_laws() -> None:
    step = 2 * math.pi / 4096
    assert TypeB.from_resolution(step).uncertainty == step / math.sqrt(12)
    assert TypeB.rectangular(step / 2).uncertainty == pytest.approx(
        TypeB.from_resolution(step).uncertainty, rel=4 * EPS
    )


def coverage_of_student(k: float, freedom: int) -> arb:
    """Return P(|t| < k) as a ball: the regularised incomplete beta function."""
    square = arb(k) ** 2
    half = arb(1) / 2
    return (square / (square + freedom)).beta_lower(half, arb(freedom) / 2, 1)


@pytest.mark.parametrize("probability", [1e-3, 0.5, 0.6827, 0.95, 0.9973, 1 - 1e-9])
@pytest.mark.parametrize("freedom", [1, 2, 3, 9, 191, 10**6])
def test_coverage_factor_against_balls(probability: float, freedom: int) -> None:
    k = Estimate(0.0, 1.0, freedom).cover(probability).k
    # The interval that 1e-12 allows brackets the exact quantile.
    with ctx.workprec(200):
        assert coverage_of_student(k * (1 - 1e-12), freedom) < probability
        assert coverage_of_student(k * (1 + 1e-12), freedom) > probability


def test_coverage_factor_without_limit_of_freedom() -> None:
    k = Estimate(0.0, 1.0).cover(0.95).k
    with ctx.workprec(200):
        assert (arb(k * (1 - 1e-12)) / arb(2).sqrt()).erf() < 0.95
        assert (arb(k * (1 + 1e-12)) / arb(2).sqrt()).erf() > 0.95


def test_interval_ends() -> None:
    interval = Estimate(1.0, 0.25, unit="mm").expand(2)
    assert interval == CoverageInterval(1.0, 0.5, 2, unit="mm")
    assert (interval.lower, interval.upper) == (0.5, 1.5)


# Positions


class Geared:
    """A mechanism that turns its output at a constant ratio."""

    def __init__(self, ratio: float) -> None:
        self.ratio = ratio

    def position(self, phi1: Any) -> Any:
        return self.ratio * np.asarray(phi1)


def wrapping_error(angle: float, wrapped: float) -> float:
    turns = round(angle / (2 * math.pi))
    # At half turns the nearest turn in doubles may be off by one; both signs are right there.
    exact = [arb(angle) - 2 * n * arb.pi() for n in (turns - 1, turns, turns + 1)]
    return min(float(abs(arb(wrapped) / x - 1).upper()) for x in exact)


def test_whole_turns_of_the_double_miss_the_bar() -> None:
    angle = 100 * math.pi + 1e-9
    with ctx.workprec(400):
        assert wrapping_error(angle, math.remainder(angle, 2 * math.pi)) > 1e-7


def test_wrapped_angle_against_balls() -> None:
    rng = np.random.default_rng(2)
    near_turns = np.arange(-50, 50) * 2 * np.pi + rng.normal(0, 1e-9, 100)
    near_half_turns = (np.arange(-50, 50) + 0.5) * 2 * np.pi + rng.normal(0, 1e-9, 100)
    small = 10.0 ** rng.uniform(-300, 0, 100)
    angles = np.concatenate([near_turns, near_half_turns, small, rng.uniform(-1e6, 1e6, 200)])
    with ctx.workprec(400):
        for angle, wrapped in zip(angles, wrap_angle(angles), strict=True):
            assert wrapping_error(float(angle), float(wrapped)) <= 12 * EPS
            assert abs(wrapped) <= np.pi


def test_errors_are_taken_on_the_right_turn() -> None:
    phi1 = np.linspace(0, 60 * np.pi, 500)
    true = np.random.default_rng(3).normal(0.01, 0.1, phi1.size)
    measured = np.mod(Geared(5.125).position(phi1) + true, 2 * np.pi)
    errors = position_errors(Geared(5.125), phi1, measured)
    # Roundings at angles up to 966: four of half an ulp.
    np.testing.assert_allclose(errors, true, atol=2 * np.spacing(1000.0), rtol=0)


def test_errors_broadcast_and_keep_scalars() -> None:
    error = position_errors(Geared(2.0), 1.0, 2.5 - 4 * np.pi)
    assert isinstance(error, np.float64)
    assert error == pytest.approx(0.5, abs=8 * EPS * 4 * np.pi)
    assert position_errors(Geared(2.0), np.zeros(3), np.zeros((2, 1))).shape == (2, 3)
    assert np.isnan(position_errors(Geared(2.0), [0.0, math.nan], 0.0)).tolist() == [False, True]


def test_resolution_enters_as_a_type_b_part() -> None:
    step = 2 * math.pi / 4096
    rng = np.random.default_rng(4)
    phi1 = rng.uniform(0, 50, 100)
    measured = Geared(5.125).position(phi1) + rng.normal(0, 1e-3, 100)
    scatter = evaluate_type_a(position_errors(Geared(5.125), phi1, measured))
    further = TypeB.rectangular(0.003)
    result = evaluate_position_errors(
        Geared(5.125), phi1, measured, resolution=step, type_b=[further]
    )
    assert result == combine(scatter, TypeB(step / math.sqrt(12)), further, unit="rad")
    assert result.degrees_of_freedom > 99
    degrees = result.in_degrees()
    assert (degrees.unit, degrees.value) == ("°", math.degrees(result.value))
    assert degrees.uncertainty == math.degrees(result.uncertainty)
    assert degrees.degrees_of_freedom == result.degrees_of_freedom


def test_measured_nan_propagates_to_the_result() -> None:
    result = evaluate_position_errors(Geared(1.0), [0.0, 1.0], [0.0, math.nan], resolution=0.1)
    assert math.isnan(result.value)


# Errors

BAD_CALLS = [
    (lambda: evaluate_type_a([]), ValueError, r"readings = \[\]: .*not shape \(0,\)"),
    (
        lambda: evaluate_type_a([1.0]),
        ValueError,
        r"= \[1.0\]: .*at least two readings, not shape \(1,\)",
    ),
    (lambda: evaluate_type_a(1.0), ValueError, r"readings = 1.0: .*not shape \(\)"),
    (lambda: evaluate_type_a(np.ones((2, 2))), ValueError, r"must be one-dimensional .*\(2, 2\)"),
    (lambda: evaluate_type_a([1.0, math.inf]), ValueError, r"readings\[1\] = inf"),
    (lambda: Estimate(0, 1).expand(math.nan), ValueError, "k = nan"),
    (lambda: Estimate(0, 1, unit="mm").in_degrees(), ValueError, "unit = 'mm'"),
    (
        lambda: evaluate_position_errors(Geared(1), [0, 0], [-3.0, 3.0], resolution=0),
        ValueError,
        "more than half a turn",
    ),
]


@pytest.mark.parametrize(("call", "error", "message"), BAD_CALLS)
def test_bad_input_is_named(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()


def test_position_of_another_shape_is_named() -> None:
    class Total:
        def position(self, phi1: Any) -> Any:
            return np.sum(phi1)

    with pytest.raises(ValueError, match=r"gave shape \(\) for phi1 of shape \(2,\)"):
        position_errors(Total(), [0.0, 1.0], 0.0)


def test_import_is_cheap() -> None:
    code = "import sys, mechproof.measurement; sys.exit('scipy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_an_angle_that_is_not_finite_is_nan_without_a_warning() -> None:
    with np.errstate(all="raise"):
        assert np.isnan(wrap_angle([np.nan, np.inf, -np.inf])).all()
