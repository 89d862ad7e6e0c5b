"""The track wheel: parameters, extremes, errors of position."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

from mechproof import TrackWheel

EPS = float(np.finfo(float).eps)
WHEEL = TrackWheel.published(z=6, H=20.0, shift=(0.01, -0.02, 0.03))
PHI = np.linspace(-7, 7, 141)


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"R": 0.0}, ValueError, "R = 0.0: must satisfy 0 < R < oo"),
        ({"A": 41.6}, ValueError, r"A = 41.6: must satisfy .*\|A\| <= R, R = 41.5"),
        ({"A": -41.6}, ValueError, "A = -41.6"),
        ({"H": -1}, ValueError, "H = -1.0: must satisfy 0 < H < oo"),
        ({"H": math.nan}, ValueError, "H = nan: must be finite"),
        ({"z": 0}, ValueError, "z = 0: must be at least 1"),
        ({"z": 6.0}, TypeError, r"z = 6.0: must be an integer, not float"),
        ({"angles": (0.1, 0.2)}, TypeError, r"angles = \(0.1, 0.2\): must be three real"),
        ({"angles": 0.1}, TypeError, "angles = 0.1: must be three real"),
        ({"shift": (0.1, 0.2, "3")}, TypeError, r"shift\[2\] = '3': must be a real number"),
        ({"shift": (0.1, math.inf, 0.2)}, ValueError, r"shift\[1\] = inf: must be finite"),
    ],
)
def test_bad_parameters_are_named(
    changes: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        dataclasses.replace(WHEEL, **changes)


def test_published_values_and_what_the_caller_gives() -> None:
    assert (WHEEL.R, WHEEL.A, WHEEL.angles) == (41.5, 3.75, (0.00103, 0.00103, 0.0))
    assert (WHEEL.z, WHEEL.H, WHEEL.shift) == (6, 20.0, (0.01, -0.02, 0.03))
    with pytest.raises(TypeError, match="missing"):
        TrackWheel.published(z=6)  # type: ignore[call-arg]


def test_arrays_are_accepted_where_three_numbers_are() -> None:
    shift: Any = np.array([0.01, -0.02, 0.03])
    wheel = dataclasses.replace(WHEEL, shift=shift)
    assert wheel == WHEEL
    assert hash(wheel) == hash(WHEEL)


@pytest.mark.parametrize("amplitude", [3.75, -3.75, 0.0, 41.5])
def test_extremes_of_the_radius(amplitude: float) -> None:
    wheel = dataclasses.replace(WHEEL, A=amplitude)
    extremes = wheel.radius_extremes()
    radius = wheel.radius(PHI)
    # The bound of the radius is 6 eps of it, and its slope vanishes at the extremes.
    margin = 10 * EPS * wheel.R
    assert radius.max() <= extremes.maximum + margin
    assert radius.min() >= extremes.minimum - margin
    assert wheel.radius(extremes.at_maximum) == pytest.approx(extremes.maximum, abs=margin)
    assert wheel.radius(extremes.at_minimum) == pytest.approx(extremes.minimum, abs=margin)
    next_maximum = extremes.at_maximum + extremes.period
    # A turn further the angle is rounded, and the radius is flat there.
    assert wheel.radius(next_maximum) == pytest.approx(extremes.maximum, abs=margin)


def test_track_lies_on_the_shifted_circle() -> None:
    points = dataclasses.replace(WHEEL, z=1).track(PHI)
    distance = np.hypot(points[:, 0] - WHEEL.A, points[:, 1])
    # Each coordinate within 7.5 eps of the radius, and z*phi = phi is not rounded.
    np.testing.assert_allclose(distance, WHEEL.R, rtol=12 * EPS)
    assert (points[:, 2] == WHEEL.H).all()


def test_rotation_is_proper_and_turns_counter_clockwise() -> None:
    turn = WHEEL.rotation()
    # 7 eps per entry, three products and sums of entries below one.
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=45 * EPS)
    quarter = dataclasses.replace(WHEEL, angles=(0, 0, math.pi / 2)).rotation()
    # In a frame turned counter-clockwise about Z0 the old X axis lies along -y.
    np.testing.assert_allclose(quarter @ [1, 0, 0], [0, -1, 0], atol=7 * EPS)


def test_displacement_is_equation_15() -> None:
    points = WHEEL.track(PHI)
    direct = points @ WHEEL.rotation() - (points - np.array(WHEEL.shift))
    # The direct form loses some eps of the coordinates to cancellation.
    np.testing.assert_allclose(WHEEL.displacement(PHI), direct, rtol=0, atol=20 * EPS * 50)
    assert np.array_equal(WHEEL.displacement_of(points), WHEEL.displacement(PHI))


def test_a_part_that_lies_right_is_only_shifted() -> None:
    wheel = dataclasses.replace(WHEEL, angles=(0, 0, 0))
    assert np.array_equal(wheel.displacement(PHI), np.broadcast_to(wheel.shift, (PHI.size, 3)))
    still = dataclasses.replace(wheel, shift=(0, 0, 0))
    assert not still.displacement(PHI).any()


def test_errors_in_the_plane_and_in_space() -> None:
    displacement = WHEEL.displacement(PHI)
    planar, spatial = WHEEL.planar_error(PHI), WHEEL.spatial_error(PHI)
    np.testing.assert_allclose(planar, np.linalg.norm(displacement[:, :2], axis=1), rtol=6 * EPS)
    np.testing.assert_allclose(spatial, np.linalg.norm(displacement, axis=1), rtol=6 * EPS)
    assert (spatial >= planar).all()
    assert isinstance(WHEEL.spatial_error(1.0), np.float64)
