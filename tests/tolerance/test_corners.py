"""Sizes and corner ranges."""

import itertools
import math
import subprocess
import sys
import tracemalloc
from typing import Any

import numpy as np
import pytest

from mechproof.tolerance import Size, corner_range

EPS = np.finfo(float).eps


def linear(x: Any, a: Any, b: Any, c: Any = 0.0) -> Any:
    """Return x*a - 2*b, exact because the coefficients are powers of two."""
    return x * a - 2 * b + 0 * c


LINEAR = {"a": Size(4, 0.5, -0.25), "b": Size(1, 0.25, 0), "c": Size(8, 1, -1)}


def wedge(
    x1: Any,
    *,
    l_ab: Any,
    l_bc: Any,
    l_cd: Any,
    l_de: Any,
    l_gh: Any,
    l_kl: Any,
    l_lm: Any,
    alpha_de: Any,
    alpha_kl: Any,
    alpha_lm: Any,
    **idle: Any,
) -> Any:
    """Return the position by equations (1), (3), (4), (7), (8), (10) of Bazuev et al. 2021."""
    q = np.sqrt(l_bc**4 + x1 * l_bc**2 * (2 * l_cd + 2 * l_ab + x1))
    arm = l_ab + l_cd
    numerator = -(x1 + l_ab) * q + l_cd * (l_bc**2 - q) + l_bc**2 * l_ab
    phi3 = np.arctan(numerator / (l_bc * (arm * (arm + x1) + q)))
    x5 = l_de * (np.cos(alpha_de + phi3) - np.cos(alpha_de))
    r = l_kl * np.cos(alpha_kl) - np.maximum(x5 - l_gh, 0)
    phi7 = np.arctan2(np.sqrt(l_kl**2 - r**2), r) - alpha_kl
    return l_lm * (np.sin(phi7 + alpha_lm) - np.sin(alpha_lm))


# The calibrated set (the digits of three lengths without influence are arbitrary).
WEDGE = {
    "l_ab": Size(6.25),
    "l_bc": Size(49.75, 1.22, -1.22),
    "l_cd": Size(38, 0, -2.06),
    "l_de": Size(83, 0.92, -1.05),
    "l_ef": Size(4, 0.3, -0.3),
    "l_gh": Size(2, 1.03, -0.72),
    "l_ik": Size(21, 0, -0.3),
    "l_kl": Size(60, 0.2, -0.2),
    "l_lm": Size(145, 0.1, -0.1),
    "l_mn": Size(10, 0, -0.17),
    "alpha_de": Size(*np.radians([283.06, 0.62, -1.10])),
    "alpha_kl": Size(*np.radians([65, 0.24, -0.25])),
    "alpha_lm": Size(math.radians(123.48)),
}


# Corners


def brute_force(function: Any, x: float, sizes: dict[str, Size]) -> tuple[float, float]:
    corners = itertools.product(*(size.limits for size in sizes.values()))
    values = [function(x, **dict(zip(sizes, corner, strict=True))) for corner in corners]
    return min(values), max(values)


@pytest.mark.parametrize("chunk", [1, 2, 7, 64, 2**16])
def test_corner_range_is_that_of_all_combinations(chunk: int) -> None:
    inputs = np.linspace(-3, 3, 7)
    result = corner_range(linear, inputs, LINEAR, chunk=chunk)
    expected = np.array([brute_force(linear, x, LINEAR) for x in inputs])
    np.testing.assert_array_equal(np.stack([result.lower, result.upper], axis=-1), expected)
    np.testing.assert_array_equal(result.nominal, linear(inputs, 4, 1))
    np.testing.assert_array_equal(result.spread, expected[:, 1] - expected[:, 0])


@pytest.mark.parametrize("chunk", [1, 7, 2**16])
def test_signs_name_the_combination(chunk: int) -> None:
    result = corner_range(linear, [-1.0, 0.0, 2.0], LINEAR, chunk=chunk)
    assert result.names == ("a", "b", "c")
    assert result.upper_signs.tolist() == [[-1, -1, 0], [0, -1, 0], [1, -1, 0]]
    assert result.lower_signs.tolist() == [[1, 1, 0], [0, 1, 0], [-1, 1, 0]]
    assert result.describe(result.upper_signs[2]) == "+a -b"
    assert (result.combinations, result.influential_combinations) == (8, 4)
    assert result.influential == ("a", "b")
    assert result.extreme_combinations.tolist() == [
        [-1, -1, 0],
        [-1, 1, 0],
        [0, -1, 0],
        [0, 1, 0],
        [1, -1, 0],
        [1, 1, 0],
    ]


@pytest.mark.parametrize("chunk", [1, 2, 2**16])
def test_of_equal_values_the_first_combination_counts(chunk: int) -> None:
    sizes = {"a": Size(0, 1, 0), "b": Size(0, 1, 0)}
    largest = corner_range(lambda x, a, b: x * np.maximum(a, b), [1.0, -1.0], sizes, chunk=chunk)
    assert largest.upper.tolist() == [1, 0]
    assert largest.lower.tolist() == [0, -1]
    assert largest.upper_signs.tolist() == [[1, 0], [-1, -1]]
    assert largest.lower_signs.tolist() == [[-1, -1], [1, 0]]
    smallest = corner_range(lambda x, a, b: x * np.minimum(a, b), [1.0, -1.0], sizes, chunk=chunk)
    assert smallest.upper_signs.tolist() == [[1, 1], [0, 0]]
    assert smallest.lower_signs.tolist() == [[0, 0], [1, 1]]


def test_signs_reproduce_the_range_of_the_wedge() -> None:
    inputs = np.linspace(-40, 0, 81)
    result = corner_range(wedge, inputs, WEDGE)
    for value, signs in ((result.lower, result.lower_signs), (result.upper, result.upper_signs)):
        # Sizes of sign 0 are at their lower limits, as documented.
        at = {
            name: np.where(signs[:, j] > 0, *reversed(WEDGE[name].limits))
            for j, name in enumerate(result.names)
        }
        fixed = {name: size.nominal for name, size in WEDGE.items() if not size.tolerance}
        # Another layout of the arrays may change the last bits of NumPy's functions, whose
        # 20 or so roundings act on numbers up to 145 with condition below 10.
        np.testing.assert_allclose(wedge(inputs, **at, **fixed), value, rtol=0, atol=2e4 * EPS)


def test_wedge_has_256_combinations_of_influence_and_three_boundaries() -> None:
    result = corner_range(wedge, np.linspace(-40, -2, 381), WEDGE)
    assert (result.combinations, result.influential_combinations) == (2048, 256)
    assert set(result.names) - set(result.influential) == {"l_ef", "l_ik", "l_mn"}
    boundary = "{}l_bc {}l_cd {}l_de {}l_gh {}l_kl {}l_lm {}alpha_de {}alpha_kl".format
    assert {result.describe(row) for row in result.upper_signs} == {
        boundary(*"+--++-++"),
        boundary(*"+--++-+-"),
    }
    assert {result.describe(row) for row in result.lower_signs} == {
        boundary(*"-++--+--"),
        boundary(*"-++--+-+"),
    }


def test_wedge_spread_is_largest_at_the_end_of_the_stroke() -> None:
    inputs = np.linspace(-40, 0, 401)
    result = corner_range(wedge, inputs, WEDGE)
    assert inputs[np.argmax(result.spread)] == -40
    assert round(result.spread[0], 1) == 24.8
    assert round(100 * (result.upper[0] / result.nominal[0] - 1), 1) == -10.6
    assert round(100 * (result.lower[0] / result.nominal[0] - 1), 1) == 9.5


def test_corner_range_is_no_bound_where_the_dependence_turns_inside() -> None:
    result = corner_range(lambda x, s: x * s**2, 1.0, {"s": Size(0, 1, -1)})
    assert result.lower == result.upper == 1
    assert result.nominal == 0 < result.lower


def test_nan_in_a_corner_is_counted_and_no_range_claimed() -> None:
    sizes = {"a": Size(1, 1, -1), "b": Size(1, 2, -2), "c": Size(0, 1, -1)}

    def root(x: Any, a: Any, b: Any, c: Any) -> Any:
        with np.errstate(invalid="ignore"):
            return x + np.sqrt(a + b) + 0 * c

    for chunk in (1, 3, 2**16):
        result = corner_range(root, [0.0, np.nan, 1.0], sizes, chunk=chunk)
        assert result.undefined.tolist() == [2, 8, 2]
        assert np.isnan(result.lower).all()
        assert np.isnan(result.upper).all()
        # Only a = 0, b = -1 has no root.
        assert result.describe(result.lower_signs[0]) == "-a -b"
        assert result.describe(result.upper_signs[2]) == "-a -b"
        assert np.isfinite(result.nominal[0])


def test_infinite_values_are_values() -> None:
    result = corner_range(lambda x, s: x / s, 1.0, {"s": Size(1, 0, -0.5)})
    assert (result.lower, result.upper) == (1, 2)
    everywhere = corner_range(lambda x, s: -np.inf * (x + s), 1.0, {"s": Size(1, 1, 0)})
    assert (everywhere.lower, everywhere.upper, everywhere.undefined) == (-np.inf, -np.inf, 0)


@pytest.mark.parametrize("shape", [(), (0,), (1,), (2, 3)])
def test_results_have_the_shape_of_the_inputs(shape: tuple[int, ...]) -> None:
    result = corner_range(linear, np.ones(shape), LINEAR)
    for value in (result.lower, result.upper, result.nominal, result.undefined):
        assert np.shape(value) == shape
        assert isinstance(value, np.generic if shape == () else np.ndarray)
    assert result.lower_signs.shape == result.upper_signs.shape == (*shape, 3)


def test_without_a_tolerance_the_range_is_one_value() -> None:
    sizes = {"a": Size(4), "b": Size(1)}
    result = corner_range(linear, [1.0, 2.0], sizes)
    assert result.lower.tolist() == result.upper.tolist() == [2, 6]
    assert (result.combinations, result.upper_signs.shape) == (1, (2, 0))


def test_function_without_dependence_on_sizes() -> None:
    result = corner_range(lambda x, s: x, [1.0, 2.0], {"s": Size(0, 1, -1)})
    assert result.lower.tolist() == result.upper.tolist() == [1, 2]
    assert result.influential == ()


def test_memory_does_not_grow_with_the_combinations() -> None:
    def peak(count: int) -> int:
        sizes = {f"s{j}": Size(1, 0.1, -0.1) for j in range(count)}
        tracemalloc.start()
        corner_range(lambda x, **s: x * sum(s.values()), np.ones(100), sizes, chunk=2**12)
        _, highest = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return highest

    # One call holds the sizes' columns, and the product, the sum and NaN marks of a chunk.
    # Keeping 2^14 combinations at 100 inputs would take 13 MB.
    assert peak(14) < 16 * 8 * 2**12
    assert peak(14) < 1.5 * peak(11)


def test_progress_counts_every_value() -> None:
    calls: list[tuple[int, int]] = []
    corner_range(
        linear,
        np.ones(50),
        LINEAR,
        chunk=32,
        progress=lambda done, total: calls.append((done, total)),
    )
    done, totals = zip(*calls, strict=True)
    assert set(totals) == {400}
    assert done[-1] == 400
    assert (np.diff((0, *done)) > 0).all()
    assert max(np.diff((0, *done))) <= 32


# Errors

ONE = {"s": Size(1, 1, 0)}


def identity(x: Any, s: Any) -> Any:
    return x * s


BAD_CALLS = [
    (lambda: Size(math.nan), ValueError, "nominal = nan"),
    (lambda: Size(1, math.inf), ValueError, "upper = inf"),
    (lambda: Size(1, 1, -math.inf), ValueError, "lower = -inf"),
    (lambda: Size(1, -1, 1), ValueError, "upper = -1, lower = 1"),
    (lambda: Size(1, 0.5, 0.5), ValueError, "upper = 0.5, lower = 0.5"),
    (lambda: Size(1e20, 1, -1), ValueError, "at nominal = 1e"),
    (
        lambda: corner_range(identity, 1.0, {f"s{j}": Size(1, 1) for j in range(40)}),
        ValueError,
        r"sizes = \['s0', .*: must be at most 24 with a tolerance, not 1,099,511,627,776 "
        "combinations; fix .*`contributions`.*`monte_carlo_range` or `certified_range`",
    ),
    (lambda: corner_range(lambda x, s: x * s * 1j, 1.0, ONE), TypeError, "complex128"),
    (
        lambda: corner_range(lambda x, s: np.ones(5), [1.0, 2.0], ONE),
        ValueError,
        r"function returned shape \(5,\).*\(2, 2\)",
    ),
]


@pytest.mark.parametrize(("call", "error", "message"), BAD_CALLS)
def test_bad_input_is_named(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()


def test_import_is_cheap() -> None:
    code = "import sys, mechproof.tolerance; sys.exit('scipy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
