"""The errors of functions in formulas."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from numpy.typing import NDArray

from mechproof.kernel_support.functions import arctan_quotient, tangent_quotient

EPS = float(np.finfo(float).eps)
Y = np.concatenate([np.linspace(-9, 9, 37), 10.0 ** np.arange(-300, 7, 17), [np.pi / 2, 3e7]])


@pytest.mark.parametrize("r", [0.0, 1e-17, 0.125])
@pytest.mark.parametrize(("a", "b"), [(1.0, 1.0), (0.5, 1.5), (1.5, 0.5), (1e-3, 1.0)])
def test_the_quotient_is_off_by_a_few_eps_of_its_largest_value(
    a: float, r: float, b: float
) -> None:
    found = tangent_quotient(Y, *map(np.float64, (0.7, a, r, b)))
    assert [tangent_quotient(float(y), 0.7, a, r, b) for y in Y] == found.tolist()
    with mp.workdps(60):
        for y, value in zip(Y, found, strict=True):
            t = mp.tan(mp.mpf(float(y)))
            true = mp.mpf(0.7) * t / (mp.mpf(a) + mp.mpf(r) + mp.mpf(b) * t**2)
            # Relative to itself near its zero at 0, elsewhere to the largest value 1/(2*sqrt(a*b)).
            scale = abs(true) if abs(y) < 0.1 else 1 / (2 * mp.sqrt(mp.mpf(a) * mp.mpf(b)))
            steep = 1 + mp.sqrt(max(a, b) / mp.mpf(min(a, b)))
            assert abs(float(value) - true) <= 4 * EPS * scale * steep


def test_the_arctangent_of_a_quotient_is_within_an_ulp() -> None:
    joined, divided = [], []
    for b in np.random.default_rng(3).uniform(0.1, 9, 50):
        found = arctan_quotient(Y, b)
        assert [arctan_quotient(float(y), float(b)) for y in Y] == found.tolist()
        joined += count_ulps(found, b)
        divided += count_ulps(np.arctan(Y / b), b)
    assert type(arctan_quotient(1.0, 2.0)) is float
    assert max(joined) <= 1 < max(divided)


def count_ulps(found: NDArray[np.float64], b: float) -> list[float]:
    """Return how far values are off the arctangents of Y/b, in their ulps."""
    with mp.workdps(60):
        true = [mp.atan(mp.mpf(float(y)) / mp.mpf(float(b))) for y in Y]
        pairs = zip(map(float, found), true, strict=True)
        return [float(abs(v - t) / np.spacing(abs(float(t)))) for v, t in pairs]
