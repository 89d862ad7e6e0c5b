"""Functions of numbers and arrays that kernels call."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest

from mechproof.kernel_support import arrays, domains, functions


@pytest.mark.parametrize("kind", [float, np.float64])
def test_functions_of_numbers_are_those_of_arrays(kind: Any) -> None:
    values = (-np.inf, -2.5, -1.0, -0.0, 0.0, 1.0, 2.5, np.inf, np.nan)
    edges = (-5e-324, 5e-324, 1 - 2**-53, -1 - 2**-52, 2.0**52 - 0.5, 0.5 - 2.0**52, 1e300, -1e300)
    for a in map(kind, (*values, *edges)):
        assert np.array_equal(functions.floor(a), np.floor(a), equal_nan=True)
        assert np.signbit(functions.floor(a)) == np.signbit(np.floor(a)) or np.isnan(a)
    for a in map(kind, values):
        for b in map(kind, values):
            given, expected = functions.maximum(a, b), np.maximum(a, b)
            assert np.array_equal(given, expected, equal_nan=True)
            assert np.signbit(given) == np.signbit(expected) or np.isnan(expected)
            given, expected = functions.choose_where(a < b, a, b), np.where(a < b, a, b)
            assert np.array_equal(given, expected, equal_nan=True)


LOWER_ENDS = {domains.is_positive: np.greater, domains.is_nonnegative: np.greater_equal}
EDGES = (5e-324, 0.0, -0.0, -5e-324, 3e38, np.inf, -np.inf, np.nan)


@pytest.mark.parametrize("ask", LOWER_ENDS)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("shape", [(1,), (3,), (2, 3)])
def test_signs_are_those_of_all_numbers(
    ask: Callable[[Any], Any], dtype: Any, shape: tuple[int, ...]
) -> None:
    for edge, place in product(EDGES, np.ndindex(shape)):
        values = np.ones(shape, dtype)
        values[place] = edge
        expected = LOWER_ENDS[ask](values, 0.0) & np.isfinite(values)
        for given in (values, np.asfortranarray(values), np.repeat(values, 2, axis=-1)[..., ::2]):
            found = ask(given)
            assert found is True if expected.all() else np.array_equal(found, expected)
        assert np.array_equal(ask(np.ma.array(values)), expected)
        assert bool(ask(values[place])) is bool(ask(float(values[place]))) is expected[place].item()
    assert ask(np.empty(0, dtype)).shape == (0,)


def check(a: Any, b: Any) -> tuple[Any, ...]:
    return domains.is_positive(a), b >= 0.0, b < a


SHAPES: tuple[tuple[int, ...], ...] = ((), (1,), (1, 1), (2,), (2, 1))


@pytest.mark.parametrize("edge", [-1.0, -0.0, 1.0, np.nan])
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("other", SHAPES)
def test_outside_a_domain_all_is_nan(
    edge: float, shape: tuple[int, ...], other: tuple[int, ...]
) -> None:
    """Numbers, arrays of one element and longer arrays all get the same answers."""
    a = np.full(shape, 1.0) if shape else 1.0
    b = np.full(other, 0.5) if other else edge
    if other:
        b[-1] = edge
    inside = (np.asarray(b) >= 0.0) & (np.asarray(b) < a)
    found = domains.nan_outside(check, a, b)
    assert np.array_equal(np.isnan(found[0] + found[1]), ~inside)
    if inside.all():
        assert found[0] is a
        assert found[1] is b


def test_every_condition_is_asked() -> None:
    for shape, axis in (((3,), -1), ((2, 3), -1), ((3, 3), (-2, -1)), ((2, 3, 3), (-2, -1))):
        condition = np.ones(shape, bool)
        assert domains.every(condition, axis) is True
        condition[(-1,) * len(shape)] = False
        assert np.array_equal(domains.every(condition, axis), np.all(condition, axis=axis))
    assert domains.every(np.ones(0, bool), -1)


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (np.array(Fraction(1, 3), dtype=object), r"Fraction\(1, 3\) of dtype object"),
        (np.array("a", dtype=object), "'a' of dtype object"),
        (np.array([None, 1.0]), r"array\(\[None, .*dtype=object\) of dtype object"),
        (np.array(1j), "1j of dtype complex128"),
        (np.ones((9, 9), complex), r"array\(.*\.\.\..*\) of dtype complex128"),
    ],
)
def test_what_is_no_real_number_is_shown(value: Any, shown: str) -> None:
    with pytest.raises(TypeError, match=f"^b: expected real numbers up to float64, got {shown}$"):
        arrays.as_floats("a b", 1.0, value)


@pytest.mark.parametrize(
    ("vectors", "matrices"),
    [
        ((5,), (5, 5)),
        ((4, 5), (5, 5)),
        ((3, 4, 5), (5, 5)),
        ((5,), (4, 5, 5)),
        ((4, 5), (4, 5, 5)),
        ((3, 1, 5), (4, 5, 5)),
        ((1,), (5, 5)),
        ((2, 0), (0, 0)),
    ],
)
@pytest.mark.parametrize("dtype", [float, np.float32])
def test_quadratic_forms_are_sums_of_pairs(
    vectors: tuple[int, ...], matrices: tuple[int, ...], dtype: Any
) -> None:
    rng = np.random.default_rng(6)
    x, m = rng.normal(size=vectors).astype(dtype), rng.normal(size=matrices).astype(dtype)
    found = functions.quadratic_form(x, m)
    size = (abs(x)[..., :, np.newaxis] * abs(x)[..., np.newaxis, :] * abs(m)).sum(axis=(-2, -1))
    wanted = (x[..., :, np.newaxis] * x[..., np.newaxis, :] * m.astype(float)).sum(axis=(-2, -1))
    assert (np.shape(found), found.dtype) == (wanted.shape, dtype)
    # Two products, and four roundings in each of two sums of five.
    assert np.all(abs(found - wanted) <= 5 * np.finfo(dtype).eps * size)


@pytest.mark.parametrize("count", [3, 40, 300])
def test_a_form_that_makes_none_negative_gives_none(count: int) -> None:
    rng = np.random.default_rng(count)
    # Whole numbers, so that the matrix is not rounded; its rank is a third of its size.
    part = rng.integers(-9, 9, (count, count // 3)).astype(float)
    matrix = part @ part.T
    beyond = np.linalg.svd(matrix)[2][-1]
    x = beyond + 1e-9 * rng.normal(size=(50, count)) * np.linspace(0, 1, 50)[:, np.newaxis]
    assert not np.signbit(functions.nonnegative_form(x, matrix)).any()
    below = matrix - 1e-9 * np.abs(matrix).max() * np.eye(count)
    assert functions.nonnegative_form(beyond, below) < 0
    masked = np.ma.masked_array(x, np.arange(50)[:, np.newaxis] % 2 * np.ones(count))
    assert functions.nonnegative_form(masked, matrix).mask.tolist() == [False, True] * 25


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_form_keeps_its_type_beside_nan_and_negative_ones(dtype: Any) -> None:
    matrix = np.array([[1, -2], [-2, 1]], dtype)
    vectors = np.array([[1, 1], [np.nan, 1], [1, -1]], dtype)
    for rows in (vectors, vectors[1:], vectors[2:], vectors[:0]):
        found = functions.nonnegative_form(rows, matrix)
        assert found.dtype == dtype
        np.testing.assert_array_equal(found, [-2, np.nan, 6][3 - len(rows) :])


def test_squares_of_numbers_round_as_those_of_arrays() -> None:
    """Python's x**2 is pow(x, 2), which rounds one in 1200 numbers differently."""
    values = np.random.default_rng(3).uniform(1, 2, 20_000)
    assert [functions.square(x) for x in values.tolist()] == functions.square(values).tolist()


def test_sums_of_foreign_arrays_keep_what_they_are() -> None:
    x = np.ma.masked_array([[1.0, 2.0], [3.0, 4.0]], mask=[[True, True], [False, False]])
    for found in (functions.quadratic_form(x, np.eye(2)), functions.add_up(x**2, axis=-1)):
        assert found.mask.tolist() == [True, False]
        assert found[1] == 25.0
    given = np.asfortranarray(np.arange(6.0).reshape(2, 3))
    assert np.array_equal(functions.add_up(given, axis=-1), np.sum(given, axis=-1))
    assert functions.add_up(given, axis=(-2, -1)) == 15.0
