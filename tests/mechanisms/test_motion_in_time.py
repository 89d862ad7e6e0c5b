"""The motion of the output in time, by the chain rule, against derivatives of 40 digits."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from mechproof import CylindricalPair, EllipticPlanetary, OvalPair, OvalPlanetary
from mechproof.mechanisms.motion import Drive

EPS = float(np.finfo(float).eps)
Exact = Callable[[mp.mpf], mp.mpf]


def lead(e: float, x: mp.mpf) -> mp.mpf:
    return mp.atan2(e * mp.sin(x), 1 - e * mp.cos(x))


def through_ovals(phi: mp.mpf) -> mp.mpf:
    turned = phi + lead(0.3, 2 * phi)
    start = lead(0.2, mp.mpf(0.4) * 2)
    return phi - turned - lead(0.2, 2 * (turned + mp.mpf(0.4))) + start


DRIVES: dict[str, tuple[Drive, Exact]] = {
    "elliptic": (
        EllipticPlanetary(66, 16, 0.475),
        lambda phi: phi + mp.mpf(66) / 16 * phi + 2 * lead(0.475, mp.mpf(66) / 16 * phi),
    ),
    "cylindrical": (
        OvalPlanetary(CylindricalPair(30.0, 20.0), 0.2),
        lambda phi: phi - mp.mpf(1.5) * phi - lead(0.2, 3 * phi),
    ),
    "ovals": (OvalPlanetary(OvalPair(0.3, 0.4), 0.2), through_ovals),
}


@pytest.mark.parametrize("name", DRIVES)
@pytest.mark.parametrize("carrier", [(0.3, 12.5, 0.0, 0.0), (-2.0, 3.0, -40.0, 700.0)])
def test_the_chain_rule(name: str, carrier: tuple[float, ...]) -> None:
    drive, position = DRIVES[name]
    phi, w, a, j = carrier
    with mp.workdps(40):

        def moved(t: mp.mpf) -> mp.mpf:
            return position(mp.mpf(phi) + w * t + mp.mpf(a) / 2 * t**2 + mp.mpf(j) / 6 * t**3)

        exact = [float(mp.diff(moved, 0, order)) for order in range(4)]
    found = drive.at(phi, w, a, j)
    # 30 eps of a kernel, of terms that are no larger than ten times the values of its peak.
    sizes = [1 + abs(phi), abs(w), abs(a) + w**2, abs(j) + 3 * abs(a * w) + abs(w) ** 3]
    for value, wanted, size in zip(found, exact, sizes, strict=True):
        assert abs(value - wanted) <= 64 * EPS * 40 * size
    in_rpm = drive.at(phi, acceleration=a, jerk=j, speed_rpm=w * 60 / math.tau)
    assert np.allclose(in_rpm, found, rtol=16 * EPS, atol=0)
    assert found.speed_rpm == pytest.approx(found.speed * 60 / math.tau)


def test_shapes_nan_and_what_is_refused() -> None:
    drive = EllipticPlanetary.published(2)
    found = drive.at(np.zeros((3, 1)), [1.0, np.nan])
    assert [part.shape for part in found] == [(3, 2)] * 4
    assert np.isnan(found.speed[:, 1]).all()
    assert not np.isnan(found.angle).any()
    with pytest.raises(TypeError, match="give exactly one of speed and speed_rpm"):
        drive.at(0.0)
    with pytest.raises(TypeError, match="give exactly one of speed and speed_rpm"):
        drive.at(0.0, 1.0, speed_rpm=2.0)
    with pytest.raises(TypeError, match="speed = '1'"):
        drive.at(0.0, "1")  # type: ignore[arg-type]


def start_up(t: Any) -> Any:
    """Return the angle of a carrier that runs up to 12 rad/s, with a ripple."""
    return 12 * (t - np.tanh(t)) + 0.02 * np.sin(20 * t)


def test_a_function_and_its_samples_give_the_motion() -> None:
    drive = EllipticPlanetary.published(1)
    t = np.linspace(0.3, 2, 1201)
    tanh, c, s = np.tanh(t), np.cos(20 * t), np.sin(20 * t)
    slope = 1 - tanh**2
    exact = drive.at(
        start_up(t),
        12 * tanh**2 + 0.4 * c,
        24 * tanh * slope - 8 * s,
        24 * slope * (1 - 3 * tanh**2) - 160 * c,
    )
    # A spline of the fifth degree through samples h apart, each ripple of 222 samples: its third
    # derivative is off by some (20 h)**3, 2e-5, and more at the ends.
    for phi1, errors in ((start_up, (0, 1e-9, 1e-8, 1e-6)), (start_up(t), (0, 1e-8, 1e-6, 1e-4))):
        inner = slice(None) if callable(phi1) else slice(20, -20)
        for value, wanted, error in zip(drive.run(t, phi1), exact, errors, strict=True):
            size = np.abs(wanted).max()
            assert np.abs(value - wanted)[inner].max() <= error * size


def test_a_function_has_no_derivative_where_it_has_a_corner_or_is_nan() -> None:
    drive = EllipticPlanetary.published(1)
    t = np.array([-1.0, -1e-3, 0.0, 0.5, 2.0])
    corner = drive.run(t, lambda t: np.abs(t))
    assert np.isnan(corner.speed).tolist() == [False, False, True, False, False]
    assert not np.isnan(corner.angle).any()
    stops = drive.run(t, lambda t: np.where(t < 1, t, np.nan))
    assert np.isnan(stops.jerk).tolist() == [False, False, False, False, True]
    exact = drive.at(0.5, 1.0)
    assert [float(part[3]) for part in stops] == pytest.approx(list(exact), rel=1e-6)
    steady = drive.run(3.0, lambda t: 5 * t)
    assert list(steady) == pytest.approx(list(drive.at(15.0, 5.0)), rel=1e-9)
    assert drive.run(np.empty(0), start_up).jerk.shape == (0,)


@pytest.mark.parametrize(
    ("t", "phi1", "message"),
    [
        (np.arange(5.0), np.arange(5.0), "t = .*: must be 6 or more on one axis"),
        (np.arange(6.0), np.arange(7.0), "phi1 = .*: must be as many as the times, 6"),
        (np.arange(6.0)[::-1], np.arange(6.0), "t = .*: must be finite and increase"),
        ([0, 1, 1, 2, 3, 4], np.arange(6.0), "t = .*: must be finite and increase"),
        (np.arange(6.0), [0, 1, 2, np.nan, 4, 5], "phi1 = .*: must be finite"),
        (np.arange(6.0), lambda t: 1.0, r"phi1\(t\) = .*: must have the shape \(6,\) of t"),
    ],
)
def test_what_is_no_motion_is_refused(t: Any, phi1: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        EllipticPlanetary.published(1).run(t, phi1)
