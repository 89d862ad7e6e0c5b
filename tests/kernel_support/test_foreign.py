"""Arguments with arithmetic of their own: indices, masks, lazy arrays; units."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import astropy.table
import astropy.units
import numpy as np
import pytest
from calls import CALLS, RADII, SHARED_SHIFT, spread
from units import list_with_units

from mechproof.kernel_support import domains
from mechproof.kernel_support.arrays import as_floats
from mechproof.kernels import elliptic_planetary, track_wheel
from mechproof.kernels.compiled import elliptic_planetary as compiled_kernels


def test_a_foreign_scalar_without_numbers_is_refused() -> None:
    class Opaque:
        def __array_ufunc__(self, *arguments: Any, **options: Any) -> Opaque:
            return self

    with pytest.raises(TypeError, match=r"^R1: expected numbers with a dtype, got Opaque"):
        as_floats("R1", Opaque())


@pytest.mark.parametrize("value", list_with_units([1.0, 2.0]), ids=repr)
def test_units_are_refused(value: Any) -> None:
    """Kernels refuse all units; mechanisms accept pint's."""
    for kernels in (elliptic_planetary, compiled_kernels):
        with pytest.raises(TypeError, match=r"^phi1 = .*carries a unit"):
            kernels.position(value, *RADII, 0.4)


def test_a_result_is_not_written_where_a_unit_would_be_claimed() -> None:
    for kernels in (elliptic_planetary, compiled_kernels):
        with pytest.raises(TypeError, match=r"^out = <Quantity.*carries a unit"):
            kernels.position(spread(7), *RADII, 0.4, out=np.zeros(7) * astropy.units.deg)


def test_a_column_without_a_unit_is_an_array() -> None:
    column = astropy.table.Column(spread(7))
    assert column.unit is None
    found = elliptic_planetary.position(column, *RADII, 0.4)
    assert np.array_equal(found, elliptic_planetary.position(spread(7), *RADII, 0.4))


class Column(np.lib.mixins.NDArrayOperatorsMixin):
    """One axis of values, like a pandas series: no axes can be added."""

    def __init__(self, values: Any) -> None:
        self.values = np.asarray(values, float)
        self.dtype, self.shape, self.ndim = self.values.dtype, self.values.shape, 1

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Column:
        plain = [i.values if isinstance(i, Column) else i for i in inputs]
        return Column(getattr(ufunc, method)(*plain, **options))

    def __getitem__(self, key: Any) -> Any:
        raise KeyError("key of type tuple not found and not a MultiIndex")


def test_a_series_of_components_is_refused_by_name() -> None:
    zero, column = np.zeros(3), Column([1, 2, 3])
    with pytest.raises(TypeError, match=r"^points: expected an array with components.*got Column"):
        track_wheel.displacement(column, zero, zero)
    with pytest.raises(TypeError, match=r"^angles: expected an array with components.*got Column"):
        track_wheel.displacement(zero, column, zero)
    with pytest.raises(TypeError, match=r"^displacement: expected an array with components"):
        track_wheel.planar_error(column)


@pytest.mark.usefixtures("small_blocks")
def test_masks_survive() -> None:
    mask = np.arange(7) % 2 == 0
    masked = np.ma.masked_array(spread(7), mask)
    for e in (0.475, 0.9, np.ma.masked_array(np.full(7, 0.475), mask)):
        result = elliptic_planetary.position(masked, *RADII, e)
        assert np.array_equal(result.mask, mask)
        plain = elliptic_planetary.position(spread(7), *RADII, np.asarray(e))
        np.testing.assert_array_max_ulp(result.data[~mask], plain[~mask], 4)
    points = np.ma.masked_array(spread(7, 3), np.repeat(mask[:, None], 3, axis=1))
    moved = track_wheel.displacement(points, [0.1, 0.2, 0.3], SHARED_SHIFT)
    assert np.array_equal(moved.mask, points.mask)


def test_masks_survive_a_choice_of_branches() -> None:
    masked = np.ma.masked_array([0.3, 9.0], mask=[False, True])
    radius = track_wheel.radius(masked, 41.5, 3.75, 6)
    assert np.array_equal(radius.mask, masked.mask)
    np.testing.assert_array_max_ulp(radius.data[0], track_wheel.radius(0.3, 41.5, 3.75, 6), 4)
    amplitude = np.ma.masked_array([3.75, 1.0], mask=[False, True])
    points = track_wheel.track(0.3, 41.5, amplitude, 6, 20.0)
    assert points.shape == (2, 3)
    assert points.mask[1, :2].all()


@pytest.mark.parametrize("mask", [[0, 1, 0], [1, 1, 1]])
def test_sums_of_masked_terms_are_masked(mask: list[int]) -> None:
    masked = np.ma.masked_array([0.1, 0.2, 0.3], mask)
    matrix = np.ma.masked_array(np.eye(3), np.diag(mask))
    assert track_wheel.error_sum(masked, 1.0, 1.0, 1.1) is np.ma.masked
    assert track_wheel.error_sum_thermal(1.0, 1.0, masked, 1.1, 0.1, 1.0) is np.ma.masked
    assert track_wheel.error_sum_correlated(0.1, masked, 1.0, np.eye(3), 1.0) is np.ma.masked
    assert track_wheel.error_sum_correlated(0.1, 1.0, 1.0, matrix, 1.0) is np.ma.masked
    rows = np.ma.masked_array(np.full((2, 3), 0.1), [[0, 0, 0], mask])
    found = track_wheel.error_sum(rows, 1.0, 1.0, 1.1)
    assert found.mask.tolist() == [False, True]
    assert found[0] == track_wheel.error_sum([0.1] * 3, 1.0, 1.0, 1.1)
    assert masked.mask.tolist() == [bool(m) for m in mask]
    plain = np.ma.masked_array([0.1, 0.2, 0.3])
    assert track_wheel.error_sum(plain, 1.0, 1.0, 1.1) == pytest.approx(0.34, rel=0.01)


def test_a_mask_is_not_written_into_a_plain_array() -> None:
    masked = np.ma.masked_array([0.3, 9.0], mask=[False, True])
    with pytest.raises(TypeError, match="out: expected a masked array"):
        elliptic_planetary.position(masked, *RADII, 0.4, out=np.empty(2))
    out = np.ma.empty(2)
    assert elliptic_planetary.position(masked, *RADII, 0.4, out=out) is out
    assert np.array_equal(out.mask, masked.mask)


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
def test_matrices_and_memory_maps_are_plain_arrays(tmp_path: Any) -> None:
    expected = elliptic_planetary.position(spread(1, 7), *RADII, 0.475)
    mapped = np.memmap(tmp_path / "angles", float, "w+", shape=(1, 7))
    mapped[...] = spread(1, 7)
    for given in (np.matrix(spread(1, 7)), mapped):
        result = elliptic_planetary.position(given, *RADII, 0.475)
        assert type(result) is np.ndarray
        assert np.array_equal(result, expected)


class Lazy(np.lib.mixins.NDArrayOperatorsMixin):
    """An array that records ufuncs and computes nothing until asked."""

    def __init__(self, compute: Callable[[], Any], shape: tuple[int, ...]) -> None:
        self.compute, self.shape, self.dtype = compute, shape, np.dtype(float)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        raise AssertionError("read too early")

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Lazy:
        assert method == "__call__"
        assert not options
        shapes = [i.shape if isinstance(i, Lazy) else np.shape(i) for i in inputs]

        def compute() -> Any:
            return ufunc(*(i.compute() if isinstance(i, Lazy) else i for i in inputs))

        return Lazy(compute, np.broadcast_shapes(*shapes))


@pytest.mark.parametrize("name", ["position", "position with low word"])
def test_lazy_arrays_stay_lazy(name: str) -> None:
    function, (phi, *parameters) = CALLS[name]
    result = function(Lazy(lambda: phi, phi.shape), *parameters)
    assert isinstance(result, Lazy)
    np.testing.assert_array_max_ulp(result.compute(), function(phi, *parameters), 4)


def test_lazy_conditions_stay_unread() -> None:
    assert domains.holds(np.array([True, True]))
    assert not domains.holds(np.array([True, False]))
    assert domains.holds(np.float64(1) > 0)
    assert not domains.holds(operator.gt(Lazy(lambda: 1.0, ()), 0))
