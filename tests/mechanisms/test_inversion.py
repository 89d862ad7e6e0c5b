"""The inverse of a rising function, to the last bit."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from mechproof.kernel_support.arrays import as_floats
from mechproof.mechanisms import CylindricalPair, EllipticPlanetary, OvalPlanetary, ToothThickness
from mechproof.mechanisms.inversion import follow_kind, invert

Array = Any
FUNCTIONS: dict[str, tuple[Callable[[Array], Array], float, float]] = {
    "line": (lambda x: 2 * x, -1e300, 1e300),
    "cube": (lambda x: x**3, -1e100, 1e100),
    "step": (lambda x: np.tanh((x - 0.7) * 1e18), -1.0, 1.0),
    "flat": (lambda x: np.tanh(x), -1e3, 1e3),
    "root": (lambda x: np.sign(x) * np.sqrt(np.abs(x)), -1.0, 1.0),
    "exponential": (np.exp, -700.0, 700.0),
}
TARGETS = np.array([0.3, -0.3, 0.999, 1e-9, -1e-300, 0.0, 5e-324])


def solve(name: str, targets: Array) -> tuple[Array, int]:
    function, low, high = FUNCTIONS[name]
    calls = 0

    def count(x: Array) -> Array:
        nonlocal calls
        calls += 1
        return function(x)

    ends = np.full(targets.shape, low), np.full(targets.shape, high)
    return invert(count, targets, *ends, failure="no x for y"), calls


@pytest.mark.parametrize("name", FUNCTIONS)
def test_between_neighbours(name: str) -> None:
    function = FUNCTIONS[name][0]
    targets = TARGETS[TARGETS > 0] if name == "exponential" else TARGETS
    targets = targets[targets > 1e-200] if name == "exponential" else targets
    found, calls = solve(name, targets)
    miss = np.abs(function(found) - targets)
    for beside in (np.nextafter(found, -np.inf), np.nextafter(found, np.inf)):
        assert (miss <= np.abs(function(beside) - targets)).all()
    below = function(np.nextafter(found, -np.inf)) <= targets
    above = function(np.nextafter(found, np.inf)) >= targets
    assert (below & above).all()
    # Two ends, 64 halvings and one step more.
    assert calls <= 67


def test_it_is_faster_than_bisection_where_the_function_is_smooth() -> None:
    assert solve("line", np.array([0.3, 0.4]))[1] <= 67
    targets, ones = np.linspace(0.1, 0.9, 50), np.ones(50)
    calls = []
    invert(lambda x: calls.append(x.size) or np.sin(x), targets, 0 * ones, 1.5 * ones, failure="")
    assert sum(calls) <= 20 * 50


def test_shapes_and_no_points() -> None:
    wanted = np.array([[1.0, 2.0]])
    found = invert(lambda x: x, wanted, wanted - 1, wanted + 1, failure="")
    assert found.tolist() == [[1.0, 2.0]]
    none = np.empty((0, 3))
    assert invert(lambda x: x, none, none, none, failure="").shape == (0, 3)
    assert invert(lambda x: x, np.float64(2), 1.0, 3.0, failure="") == 2.0  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [7.0, -7.0, np.nan])
def test_what_the_ends_do_not_enclose_is_named(value: float) -> None:
    with pytest.raises(ArithmeticError, match=r"no x for y = array\(\[ *-?(7\.|nan)\]\)"):
        solve("step", np.array([0.5, value]))


def test_a_function_that_is_nan_inside_is_no_silent_answer() -> None:
    ends = np.zeros(2), np.ones(2)
    with pytest.raises(ArithmeticError, match=r"no x for y = array\(\[0\.3, 0\.7\]\)"):
        invert(
            lambda x: np.where((x > 0) & (x < 1), np.nan, x),
            np.array([0.3, 0.7]),
            *ends,
            failure="no x for y",
        )


INVERSES = {
    "elliptic": EllipticPlanetary(66, 16, 0.4).carrier_angle,
    "oval": OvalPlanetary(CylindricalPair(20, 30), 0.1).carrier_angle,
    "thickness": ToothThickness.published().thickness_change,
}


class Series(np.lib.mixins.NDArrayOperatorsMixin):
    """Values with an index that ufuncs keep, like a pandas series."""

    def __init__(self, values: Array, index: list[str]) -> None:
        self.values, self.index = np.asarray(values), index
        self.dtype, self.shape = self.values.dtype, self.values.shape

    def __array__(self, dtype: Any = None, copy: Any = None) -> Array:
        return np.asarray(self.values, dtype)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Series:
        plain = [i.values if isinstance(i, Series) else i for i in inputs]
        return Series(getattr(ufunc, method)(*plain, **options), self.index)

    def astype(self, dtype: Any) -> Series:
        return Series(self.values.astype(dtype), self.index)


@pytest.mark.parametrize("name", INVERSES)
def test_mask_and_index_are_kept(name: str) -> None:
    inverse, values = INVERSES[name], np.array([0.1, 0.2, -0.1])
    plain = inverse(values)
    masked = inverse(np.ma.masked_array(values, [False, True, False]))
    assert isinstance(masked, np.ma.MaskedArray)
    assert masked.mask.tolist() == [False, True, False]
    assert masked.compressed().tolist() == plain[[0, 2]].tolist()
    assert inverse(np.ma.masked) is np.ma.masked
    indexed = inverse(Series(values, ["a", "b", "c"]))
    assert isinstance(indexed, Series)
    assert indexed.index == ["a", "b", "c"]
    assert indexed.values.tolist() == plain.tolist()
    whole = inverse(Series(np.array([0, 0]), ["a", "b"]))
    assert whole.values.tolist() == [0.0, 0.0]


@pytest.mark.parametrize("name", INVERSES)
def test_what_is_not_finite_is_nan_in_any_kind(name: str) -> None:
    bad = np.array([np.nan, np.inf, -np.inf])
    assert np.isnan(INVERSES[name](bad)).all()
    assert np.isnan(INVERSES[name](Series(bad, ["a", "b", "c"])).values).all()


def test_the_sign_of_zero_is_kept() -> None:
    (given,) = as_floats("x", Series(np.array([-0.0, 0.0]), ["a", "b"]))
    kept = follow_kind(given, np.array([-0.0, 0.0]))
    assert np.signbit(kept.values).tolist() == [True, False]
