"""Arguments that bring arithmetic of their own: numbers with units, series with an index."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mechproof import EllipticPlanetary, ToothThickness
from mechproof.kernel_support.arrays import as_floats
from mechproof.kernels import elliptic_planetary, track_wheel


class Length(np.lib.mixins.NDArrayOperatorsMixin):
    """Numbers in a unit of length to a power; conversion to an array strips the unit.

    As in the libraries of units, a Python number inside has no dtype.
    """

    def __init__(self, magnitude: Any, unit: float = 1.0, power: int = 1) -> None:
        self.magnitude, self.unit, self.power = magnitude, unit, power

    @property
    def units(self) -> str:
        return f"{self.unit} mm^{self.power}"

    def __getattr__(self, name: str) -> Any:
        if name in ("dtype", "shape", "ndim", "size"):
            return getattr(self.magnitude, name)
        raise AttributeError(name)

    def astype(self, dtype: Any) -> Length:
        return Length(self.magnitude.astype(dtype), self.unit, self.power)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(self.magnitude, dtype)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        powers = [i.power if isinstance(i, Length) else 0 for i in inputs]
        base = [i.magnitude * i.unit if isinstance(i, Length) else i for i in inputs]
        power = powers[0]
        if ufunc in (np.multiply, np.divide):
            power += powers[1] if ufunc is np.multiply else -powers[1]
        result = getattr(ufunc, method)(*base, **options)
        return result if result.dtype == bool else Length(result, 1.0, power)


METRE = 1000.0


@pytest.mark.parametrize("kind", [float, int, np.float64, lambda v: np.array([v]), np.array])
def test_scalars_with_units_are_treated_as_arrays_are(kind: Any) -> None:
    plain = elliptic_planetary.position(1.0, 66.0, 16.0, 0.4)
    found = elliptic_planetary.position(1.0, Length(kind(66)), Length(kind(16), 1.0), 0.4)
    assert isinstance(found, Length)
    assert found.power == 0
    assert np.ravel(found.magnitude)[0] == pytest.approx(plain, rel=1e-15)
    in_metres = elliptic_planetary.position(1.0, Length(kind(66)), Length(0.016, METRE), 0.4)
    # An eps of the converted radius.
    assert np.ravel(in_metres.magnitude)[0] == pytest.approx(plain, rel=1e-14)


def test_a_foreign_scalar_without_numbers_is_refused() -> None:
    class Opaque:
        def __array_ufunc__(self, *arguments: Any, **options: Any) -> Opaque:
            return self

    with pytest.raises(TypeError, match=r"^R1: expected numbers with a dtype, got Opaque"):
        as_floats("R1", Opaque())


@pytest.mark.parametrize("value", [Length(1.0), Length(np.ones(2))])
def test_the_inverses_refuse_units(value: Any) -> None:
    with pytest.raises(TypeError, match=r"^phi3 = .*carries a unit"):
        EllipticPlanetary(66, 16, 0.4).carrier_angle(value)
    with pytest.raises(TypeError, match=r"^dh = .*carries a unit"):
        ToothThickness.published().thickness_change(value)


class Column(np.lib.mixins.NDArrayOperatorsMixin):
    """One axis of values by keys, as a series of pandas: it knows no further axes."""

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
