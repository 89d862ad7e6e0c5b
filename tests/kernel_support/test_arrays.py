"""Functions of numbers and arrays that kernels call."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mechproof.kernel_support import arrays


@pytest.mark.parametrize("kind", [float, np.float64])
def test_functions_of_numbers_are_those_of_arrays(kind: Any) -> None:
    values = (-np.inf, -2.5, -1.0, -0.0, 0.0, 1.0, 2.5, np.inf, np.nan)
    for a in map(kind, values):
        assert np.array_equal(arrays.floor(a), np.floor(a), equal_nan=True)
        for b in map(kind, values):
            given, expected = arrays.maximum(a, b), np.maximum(a, b)
            assert np.array_equal(given, expected, equal_nan=True)
            assert np.signbit(given) == np.signbit(expected) or np.isnan(expected)
            given, expected = arrays.choose_where(a < b, a, b), np.where(a < b, a, b)
            assert np.array_equal(given, expected, equal_nan=True)


def test_every_condition_is_asked() -> None:
    for shape, axis in (((3,), -1), ((2, 3), -1), ((3, 3), (-2, -1)), ((2, 3, 3), (-2, -1))):
        condition = np.ones(shape, bool)
        assert arrays.every(condition, axis) is True
        condition[(-1,) * len(shape)] = False
        assert np.array_equal(arrays.every(condition, axis), np.all(condition, axis=axis))
    assert arrays.every(np.ones(0, bool), -1)


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
