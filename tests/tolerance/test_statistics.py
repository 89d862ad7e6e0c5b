"""Contributions, root-sum-square and Monte Carlo ranges."""

import math
from typing import Any

import numpy as np
import pytest

from mechproof import conformity, laws, tolerance
from mechproof.tolerance import (
    Law,
    Normal,
    Size,
    Uniform,
    contributions,
    monte_carlo_range,
    root_sum_square,
)


def linear(x: Any, a: Any, b: Any, c: Any = 0.0) -> Any:
    """Return x*a - 2*b, exact because the coefficients are powers of two."""
    return x * a - 2 * b + 0 * c


LINEAR = {"a": Size(4, 0.5, -0.25), "b": Size(1, 0.25, 0), "c": Size(8, 1, -1)}


@pytest.mark.parametrize("shape", [(), (0,), (1,), (2, 3)])
def test_results_have_the_shape_of_the_inputs(shape: tuple[int, ...]) -> None:
    inputs = np.ones(shape)
    firsts = contributions(linear, inputs, LINEAR)
    rng = np.random.default_rng(0)
    result = monte_carlo_range(linear, inputs, LINEAR, laws=Size.uniform, rng=rng, count=10)
    ends = (*root_sum_square(firsts), result.lower, result.upper)
    for value in (*ends, firsts.nominal, firsts.middle, result.mean, result.undefined):
        assert np.shape(value) == shape
        assert isinstance(value, np.generic if shape == () else np.ndarray)
    assert firsts.effects.shape == (*shape, 3)


# First order


def test_difference_quotients_are_exact_for_a_linear_function() -> None:
    result = contributions(linear, [-1.0, 2.0], LINEAR)
    assert result.sensitivities.tolist() == [[-1, -2, 0], [2, -2, 0]]
    assert result.effects.tolist() == [[-0.75, -0.5, 0], [1.5, -0.5, 0]]
    assert result.ranking == (("a", 1.5), ("b", 0.5), ("c", 0.0))
    # The middles lie 0.125, 0.125 and 0 above the nominal sizes.
    assert result.middle.tolist() == [-6 - 0.375, 6 + 0.0]


def test_given_sensitivities_replace_the_quotients() -> None:
    sizes = {"a": Size(2, 0.5, -0.5), "b": Size(3)}

    def cube(x: Any, a: Any, b: Any) -> Any:
        return x * a**3 + b

    quotient = contributions(cube, [1.0, 2.0], sizes).sensitivities[:, 0]
    exact = contributions(cube, [1.0, 2.0], sizes, sensitivities={"a": [12.0, 24.0]})
    assert exact.sensitivities[:, 0].tolist() == [12, 24]
    # T²/24 times the third derivative is the only error for a cube.
    assert (quotient - exact.sensitivities[:, 0]).tolist() == [6 / 24, 12 / 24]
    assert contributions(cube, [1.0], sizes, sensitivities={"a": 5}).effects.tolist() == [[5]]


def test_ranking_puts_nan_first() -> None:
    def partly(x: Any, a: Any, b: Any) -> Any:
        return np.where(b == 1, x * a, np.nan)

    sizes = {"a": Size(1, 1, -1), "b": Size(1, 1, -1)}
    (first, effect), second = contributions(partly, [1.0], sizes).ranking
    assert first == "b"
    assert math.isnan(effect)
    assert second == ("a", 2.0)


def test_root_sum_square() -> None:
    sizes = {"a": Size(0, 3, -3), "b": Size(0, 6, -2)}
    lower, upper = root_sum_square(contributions(lambda x, a, b: x + a + b, 1.0, sizes))
    # Effects 6 and 8 about 1 + 2.
    assert (lower, upper) == (-2, 8)


# Monte Carlo. For normal output of deviation s, the standard error of the sample quantile q is
# s √(q(1-q)/n)/φ(z). All such bounds below are 6 standard errors: false alarms 2e-9 each (the seed
# is fixed, so a pass stays a pass).


def test_normal_sizes_agree_with_root_sum_square() -> None:
    sizes = {"a": Size(0, 3, -3), "b": Size(0, 6, -2)}
    count = 200_000
    result = monte_carlo_range(
        lambda x, a, b: x + a + b,
        [1.0, -4.0],
        sizes,
        laws=lambda size: size.normal(6),
        rng=np.random.default_rng(11),
        count=count,
    )
    ends = root_sum_square(contributions(lambda x, a, b: x + a + b, [1.0, -4.0], sizes))
    s, q = 10 / 6, 0.00135
    bound = 6 * s * math.sqrt(q / count) / (math.exp(-4.5) / math.sqrt(2 * math.pi))
    np.testing.assert_allclose(result.lower, ends.lower, rtol=0, atol=bound)
    np.testing.assert_allclose(result.upper, ends.upper, rtol=0, atol=bound)
    np.testing.assert_allclose(result.mean, [3, -2], rtol=0, atol=6 * s / math.sqrt(count))
    np.testing.assert_allclose(result.standard_deviation, s, rtol=6 / math.sqrt(2 * count))
    assert result.undefined.tolist() == [0, 0]


# In units of half the tolerance, about the middle.
UNIT = Size(0, 1, -1)
LAW_VARIANCES = [
    (UNIT.uniform(), 1 / 3),
    (UNIT.normal(6), 1 / 9),
    (UNIT.normal(2.5), 0.64),
]


def truncated_variance(end: float) -> float:
    if end < 0.01:
        # The first terms of the series, to 1e-8: the closed form cancels.
        return 1 / 3 - 2 * end**2 / 45
    # 1 - 2 a φ(a)/(2 Φ(a) - 1), over a².
    density = math.exp(-(end**2) / 2) / math.sqrt(2 * math.pi)
    return (1 - 2 * end * density / math.erf(end / math.sqrt(2))) / end**2


# From a law that is flat up to rounding to one whose limits are never reached.
MULTIPLES = (1e-100, 1e-9, 1e-5, 1e-4, 1e-3, 2.0, 6.0, 70.0, 1e3)


@pytest.mark.parametrize(
    ("law", "variance"),
    [*LAW_VARIANCES, *((UNIT.truncated_normal(m), truncated_variance(m / 2)) for m in MULTIPLES)],
)
def test_laws_have_their_variance(law: Law, variance: float) -> None:
    count = 100_000
    drawn = law.sample(np.random.default_rng(12), count)
    assert drawn.shape == (count,)
    # Kurtosis is at most 3: the variance's relative standard error is at most √(2/n). Mean and
    # variance are held to 6 standard errors.
    assert abs(drawn.mean()) <= 6 * math.sqrt(variance / count)
    assert abs(drawn.var() / variance - 1) <= 6 * math.sqrt(2 / count)
    if not isinstance(law, Normal):
        assert np.abs(drawn).max() <= 1


def test_normal_law_exceeds_the_limits_and_truncated_does_not() -> None:
    rng = np.random.default_rng(13)
    assert np.abs(UNIT.normal(4).sample(rng, 10_000)).max() > 1
    assert np.abs(UNIT.truncated_normal(4).sample(rng, 10_000)).max() < 1


def test_sizes_lie_about_the_middle_of_their_limits() -> None:
    sizes = {"s": Size(10, 0.5, 0.25), "t": Size(3)}
    result = monte_carlo_range(
        lambda x, s, t: s + 0 * x * t,
        0.0,
        sizes,
        laws={"s": sizes["s"].uniform()},
        rng=np.random.default_rng(14),
        probability=0.5,
    )
    # The quartiles of [10.25, 10.5]; standard error 0.25 √(3/16 / 1e5).
    bound = 6 * 0.25 * math.sqrt(3 / 16 / 1e5)
    assert abs(result.lower - 10.3125) <= bound
    assert abs(result.upper - 10.4375) <= bound


def test_any_source_of_values_is_a_law() -> None:
    """Here readings of the parts themselves are resampled."""

    class Parts:
        def sample(self, rng: np.random.Generator, size: int) -> Any:
            return rng.choice([1.25, 1.5], size)

    result = monte_carlo_range(
        identity, 1.0, ONE, laws={"s": Parts()}, rng=np.random.default_rng(18), count=100
    )
    assert (result.lower, result.upper) == (1.25, 1.5)


def test_the_laws_are_those_of_conformity() -> None:
    assert tolerance.Normal is conformity.Normal is laws.Normal
    assert ONE["s"].normal(6) == laws.Normal.from_width(1.5, 1, 6)
    assert ONE["s"].uniform() == laws.Uniform(1, 2)
    assert ONE["s"].truncated_normal(6) == laws.TruncatedNormal(1.5, 1 / 6, 1, 2)


@pytest.mark.parametrize("chunk", [1, 100, 1000, 2**16])
def test_scatter_does_not_depend_on_the_chunk(chunk: int) -> None:
    def run(size: int) -> Any:
        rng = np.random.default_rng(15)
        calls: list[tuple[int, int]] = []
        result = monte_carlo_range(
            linear,
            [1.0, 2.0, 3.0],
            LINEAR,
            laws=Size.uniform,
            rng=rng,
            count=500,
            chunk=size,
            progress=lambda *done: calls.append(done),
        )
        assert calls[-1] == (1500, 1500)
        return result.lower, result.upper

    np.testing.assert_array_equal(run(chunk), run(10**6))


def test_standard_deviation_is_that_of_a_sample() -> None:
    rng = np.random.default_rng(17)
    result = monte_carlo_range(linear, 1.0, LINEAR, laws=Size.uniform, rng=rng, count=2)
    # Of two values a distance d apart: d/√2; the quantiles cut 0.00135 d off at both ends.
    distance = (result.upper - result.lower) / 0.9973
    assert result.standard_deviation == pytest.approx(distance / math.sqrt(2), rel=1e-12)


def test_undefined_samples_are_counted() -> None:
    def half(x: Any, s: Any) -> Any:
        return np.where(s > x, s, np.nan)

    result = monte_carlo_range(
        half,
        [-2.0, 0.0],
        {"s": Size(0, 1, -1)},
        laws=Size.uniform,
        rng=np.random.default_rng(16),
        count=1000,
    )
    # Half of 1000; 6 standard errors are 95.
    assert result.undefined[0] == 0
    assert abs(result.undefined[1] - 500) <= 95
    assert np.isfinite(result.lower[0])
    for value in (result.lower, result.upper, result.mean, result.standard_deviation):
        assert np.isnan(value[1])


def test_without_a_tolerance_the_range_is_one_value() -> None:
    sizes = {"a": Size(4), "b": Size(1)}
    ends = root_sum_square(contributions(linear, [1.0, 2.0], sizes))
    assert ends.lower.tolist() == ends.upper.tolist() == [2, 6]


# Errors

RNG = np.random.default_rng(0)
ONE = {"s": Size(1, 1, 0)}


class Pair:
    """A law that draws two values, whatever the requested size."""

    def __repr__(self) -> str:
        return "a pair"

    def sample(self, rng: np.random.Generator, size: int) -> Any:
        return rng.random(2)


def identity(x: Any, s: Any) -> Any:
    return x * s


def scatter(**changes: Any) -> Any:
    settings: dict[str, Any] = {"laws": Size.uniform, "rng": RNG, "count": 10} | changes
    return monte_carlo_range(identity, 1.0, ONE, **settings)


BAD_CALLS = [
    (
        lambda: contributions(identity, 1.0, ONE, sensitivities={"t": 1}),
        ValueError,
        r"sensitivities = \['t'\]: must be given for .*\['s'\]",
    ),
    (
        lambda: contributions(identity, [1.0, 2.0], ONE, sensitivities={"s": [1, 2, 3]}),
        ValueError,
        r"sensitivities\['s'\] = .*: has shape \(3,\)",
    ),
    (lambda: ONE["s"].normal(0), ValueError, "multiple = 0: must be positive"),
    (lambda: ONE["s"].normal(math.inf), ValueError, "multiple = inf: must be finite"),
    (lambda: ONE["s"].truncated_normal(-1), ValueError, "multiple = -1: must be positive"),
    (lambda: Size(3).uniform(), ValueError, r"\(lower, upper\) = .*must be below"),
    (lambda: scatter(rng=1), TypeError, "rng = 1"),
    (
        lambda: scatter(laws={"t": Uniform(0, 1)}),
        ValueError,
        r"laws = \['t'\]: must be given for .*\['s'\]",
    ),
    (lambda: scatter(laws=6), TypeError, "laws = 6: must map names of sizes to laws"),
    (lambda: scatter(laws=Uniform(0, 1)), TypeError, "laws = Uniform.*a function of a Size"),
    (lambda: scatter(laws={"s": 6}), TypeError, r"laws\['s'\] = 6: must be a law"),
    (lambda: scatter(laws={"s": Normal([0, 1], 1)}), ValueError, r"laws\['s'\] = .*one number"),
    (lambda: scatter(laws={"s": Pair()}), ValueError, r"laws\['s'\] = a pair: gave shape \(2,\)"),
    (lambda: scatter(count=1), ValueError, "count = 1"),
]


@pytest.mark.parametrize(("call", "error", "message"), BAD_CALLS)
def test_bad_input_is_named(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()
