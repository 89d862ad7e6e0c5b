"""The planetary mechanism: parameters, extremes, inverse."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from mechproof import EllipticPlanetary
from mechproof.kernels import elliptic_planetary as kernels

EPS = float(np.finfo(float).eps)
ECCENTRICITIES = (0.0, 0.28, 0.475, 0.9, 0.99, 0.999999, 1 - 1e-12)


@pytest.mark.parametrize(
    ("parameters", "error", "message"),
    [
        ((-1.0, 16.0, 0.1), ValueError, "R1 = -1.0: must satisfy 0 < R1 < oo"),
        ((66.0, 66.0, 0.1), ValueError, "R2 = 66.0: must satisfy R2 < R1, R1 = 66.0"),
        ((66.0, 0.0, 0.1), ValueError, "R2 = 0.0"),
        ((66.0, 16.0, 1.0), ValueError, "e = 1.0: must satisfy 0 <= e < 1"),
        ((66.0, 16.0, -0.1), ValueError, "e = -0.1"),
        ((66.0, math.nan, 0.1), ValueError, "R2 = nan: must be finite"),
        ((math.inf, 16.0, 0.1), ValueError, "R1 = inf: must be finite"),
        ((10**400, 16.0, 0.1), ValueError, r"R1 = 10+ \.\.\. 0+: must be finite"),
        (("66", 16.0, 0.1), TypeError, "R1 = '66': must be a real number, not str"),
    ],
)
def test_bad_parameters_are_named(
    parameters: tuple[Any, ...], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        EllipticPlanetary(*parameters)


def test_published_variants() -> None:
    table = [(66, 16, 0.28), (66, 16, 0.475), (80, 30, 0.28), (80, 30, 0.475)]
    assert [dataclasses.astuple(EllipticPlanetary.published(n)) for n in (1, 2, 3, 4)] == table
    for bad in (0, 5):
        with pytest.raises(ValueError, match=f"variant = {bad}"):
            EllipticPlanetary.published(bad)
    with pytest.raises(TypeError, match=r"variant = 1.0: must be an integer"):
        EllipticPlanetary.published(1.0)  # type: ignore[arg-type]


def test_repr_rebuilds_the_mechanism_and_it_is_frozen() -> None:
    single: Any = np.float32(0.5)
    mechanism = EllipticPlanetary(66, 16, single)
    assert repr(mechanism) == "EllipticPlanetary(R1=66.0, R2=16.0, e=0.5)"
    with pytest.raises(dataclasses.FrozenInstanceError):
        mechanism.e = 0.1  # type: ignore[misc]


def test_methods_are_the_kernels() -> None:
    mechanism, phi = EllipticPlanetary.published(2), np.linspace(-3, 3, 7)
    for name in ("ratio", "position", "acceleration"):
        expected = getattr(kernels, name)(phi, 66, 16, 0.475)
        assert np.array_equal(getattr(mechanism, name)(phi), expected)


@pytest.mark.parametrize("e", ECCENTRICITIES)
def test_extremes_are_attained_and_not_passed(e: float) -> None:
    mechanism = EllipticPlanetary(66, 16, e)
    extremes = mechanism.extremes()
    sampled = mechanism.ratio(np.linspace(0, 3 * extremes.period, 20001))
    # The ratio is accurate to 16 eps; where its slope vanishes, rounding phi adds nothing.
    margin = 20 * EPS
    assert sampled.max() <= extremes.maximum * (1 + margin)
    assert sampled.min() >= extremes.minimum * (1 - margin)
    assert mechanism.ratio(extremes.at_maximum) == pytest.approx(extremes.maximum, rel=margin)
    # x = pi is hit to within an ulp, and the ratio is flat there.
    assert mechanism.ratio(extremes.at_minimum) == pytest.approx(extremes.minimum, rel=margin)


def angles() -> np.ndarray:
    random = np.random.default_rng(3)
    ladder = 10.0 ** np.arange(-290, 7, 8)
    turns = np.pi * 16 / 66 * np.array([1, 2, 3, 101, 100_000])
    near = np.concatenate([np.nextafter(turns, 0), turns, np.nextafter(turns, np.inf)])
    wide = [random.uniform(-30, 30, 300), random.uniform(-1e6, 1e6, 300)]
    return np.concatenate([[0.0], ladder, -ladder, near, -near, *wide])


@pytest.mark.parametrize("e", ECCENTRICITIES)
def test_round_trips(e: float) -> None:
    mechanism = EllipticPlanetary(66, 16, e)
    # The bounds hold where eps*x <= (1 - e)/4; targets are the larger angles.
    far = (1 - e) / (4 * EPS) * 16 / 66
    phi1 = angles()[np.abs(angles()) <= far]
    phi3 = mechanism.position(phi1)
    # 40 eps: twice the bound of the position, 17 on |value| and on |phi1*ratio|, and 4 for the
    # last bracket; |phi3/ratio| is the condition number of the inverse.
    allowed = 40 * EPS * (np.abs(phi1) + np.abs(phi3 / mechanism.ratio(phi1)))
    assert np.all(np.abs(mechanism.carrier_angle(phi3) - phi1) <= allowed)
    targets = phi1
    found = mechanism.carrier_angle(targets)
    # Two spacings of subnormals of the carrier angle, which cannot be told apart.
    finest = 2 * 5e-324 * mechanism.ratio(found)
    allowed = 40 * EPS * (np.abs(targets) + np.abs(found * mechanism.ratio(found))) + finest
    assert np.all(np.abs(mechanism.position(found) - targets) <= allowed)


def test_inverse_against_high_precision() -> None:
    mechanism = EllipticPlanetary.published(2)
    with mp.workdps(40):
        k, e = mp.mpf(66) / 16, mp.mpf(0.475)

        def position(phi: mp.mpf) -> mp.mpf:
            return (1 + k) * phi + 2 * mp.atan2(e * mp.sin(k * phi), 1 - e * mp.cos(k * phi))

        for target in (1e-8, 0.5, 3.0, 25.0, 1000.0):
            found = mechanism.carrier_angle(target)
            exact = mp.findroot(lambda phi, t=target: position(phi) - mp.mpf(t), mp.mpf(found))
            bound = 40 * EPS * (abs(found) + target / mechanism.ratio(found))
            assert abs(exact - mp.mpf(float(found))) <= bound


def test_inverse_of_special_values_shapes_and_types() -> None:
    mechanism = EllipticPlanetary.published(1)
    special = mechanism.carrier_angle([np.nan, np.inf, -np.inf, 0.0, -0.0])
    assert np.isnan(special[:3]).all()
    assert np.signbit(special[3:]).tolist() == [False, True]
    assert not special[3:].any()
    assert mechanism.carrier_angle(np.ones((2, 0, 3))).shape == (2, 0, 3)
    assert isinstance(mechanism.carrier_angle(1.0), np.float64)
    assert isinstance(mechanism.carrier_angle(np.float32(1.0)), np.float32)
    with pytest.raises(TypeError, match="phi3: expected real numbers"):
        mechanism.carrier_angle(1j)


def test_inverse_that_fails_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(EllipticPlanetary, "position", lambda self, phi1: np.abs(phi1) + 1e6)
    with pytest.raises(ArithmeticError, match=r"no carrier angle found for phi3 = array\(\[?2"):
        EllipticPlanetary.published(1).carrier_angle(2.0)
