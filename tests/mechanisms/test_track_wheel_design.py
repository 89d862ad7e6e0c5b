"""Design of the track wheel: largest tilt and offset, worst pose; and the normal error."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from mechproof import TrackWheel

EPS = float(np.finfo(float).eps)
ERRORS = ("planar_error", "spatial_error")
WHEELS = (
    TrackWheel(41.5, 3.75, 8, 20.0),
    TrackWheel(41.5, -3.75, 3, 90.0),
    TrackWheel(1.0, 0.0, 1, 1e-3),
    TrackWheel(2.0, 2.0, 5, 3.0),
)
POSES = ((0.0, 0.0), (1e-9, 0.0), (0.0, 1e-7), (1e-3, 1e-2), (0.3, 5.0), (1.5, 100.0))


def turn(axis: float, tilt: float) -> Any:
    """Return Rodrigues' matrix for a tilt about the horizontal axis at the polar angle `axis`."""
    x, y = math.cos(axis), math.sin(axis)
    cross = np.array([[0, 0, y], [0, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(tilt) * cross + (1 - math.cos(tilt)) * cross @ cross


@pytest.mark.parametrize("wheel", WHEELS)
@pytest.mark.parametrize("name", ERRORS)
def test_no_direction_is_worse_than_the_worst_pose(wheel: TrackWheel, name: str) -> None:
    rng = np.random.default_rng(11)
    points = wheel.track(np.linspace(0, 2 * math.pi, 721))
    axes = 2 if name == "planar_error" else 3
    for tilt, offset in ((0.02, 0.3), (1.2, 4.0), (math.pi / 2, 0.0)):
        pose = wheel.worst_pose(tilt, offset)
        largest = getattr(pose, name)(wheel.radius_extremes().at_maximum)
        found = 0.0
        for axis, way in rng.uniform(0, 2 * math.pi, (60, 2)):
            moved = points @ turn(axis, tilt).T - points
            moved += offset * np.array([math.cos(way), math.sin(way), 0])
            found = max(found, np.linalg.norm(moved[:, :axes], axis=1).max())
        assert found <= largest * (1 + 100 * EPS)
        # A coarse search of directions comes close, so the largest is nearly attained.
        assert found > 0.9 * largest
        everywhere = getattr(pose, name)(np.linspace(0, 7, 4001))
        assert everywhere.max() <= largest * (1 + 100 * EPS)


def exact_largest(wheel: TrackWheel, name: str, tilt: float, offset: float) -> Any:
    """Return the largest error at a crest, from the turned vector at 40 digits."""
    rho, height = mp.mpf(wheel.R) + abs(mp.mpf(wheel.A)), mp.mpf(wheel.H)
    turned = mp.matrix([[mp.cos(tilt), -mp.sin(tilt)], [mp.sin(tilt), mp.cos(tilt)]])
    end = turned * mp.matrix([rho, height])
    inwards, up = rho - end[0] + offset, end[1] - height
    return inwards if name == "planar_error" else mp.hypot(inwards, up)


@pytest.mark.parametrize("wheel", WHEELS)
@pytest.mark.parametrize("name", ERRORS)
@pytest.mark.parametrize(("tilt", "offset"), POSES)
def test_tilt_and_offset_are_found_again(
    wheel: TrackWheel, name: str, tilt: float, offset: float
) -> None:
    with mp.workdps(40):
        error = exact_largest(wheel, name, tilt, offset)
        found = wheel.largest_tilt(**{name: float(error)}, offset=offset)
        # Twenty roundings, and that of the error itself, which the offset may make insensitive.
        again = exact_largest(wheel, name, found, offset)
        assert abs(again - error) <= 20 * EPS * error
        found = wheel.largest_offset(**{name: float(error)}, tilt=tilt)
        again = exact_largest(wheel, name, tilt, found)
        size = wheel.R + abs(wheel.A) + wheel.H
        # The subtracted displacement is good to 9 eps of its size.
        assert abs(again - error) <= 20 * EPS * (error + 2 * math.sin(tilt / 2) * size)


def test_sizes_of_any_scale_are_within_range() -> None:
    wheel = WHEELS[0]
    tilt = wheel.largest_tilt(spatial_error=0.05, offset=0.01)
    for scale in (2.0**400, 2.0**-400):
        other = TrackWheel(wheel.R * scale, wheel.A * scale, wheel.z, wheel.H * scale)
        assert other.largest_tilt(spatial_error=0.05 * scale, offset=0.01 * scale) == tilt


def test_worst_pose_is_tilted_and_offset_by_as_much_as_asked() -> None:
    for wheel in WHEELS:
        pose = wheel.worst_pose(0.3, 1.5)
        # 7 eps of each entry of the matrix.
        assert pose.rotation()[2, 2] == pytest.approx(math.cos(0.3), abs=10 * EPS)
        assert math.hypot(*pose.shift) == pytest.approx(1.5, rel=4 * EPS)
        assert pose.displacement(wheel.radius_extremes().at_maximum)[2] > 0
        assert dataclasses.replace(pose, angles=(0, 0, 0), shift=(0, 0, 0)) == wheel


def exact_normal_error(wheel: TrackWheel, phi: float) -> Any:
    """Return the projection on the normal, from the derivative of (16) at 40 digits."""

    def point(at: Any) -> Any:
        theta = wheel.z * at
        rho = mp.sqrt(mp.mpf(wheel.R) ** 2 - (wheel.A * mp.sin(theta)) ** 2)
        rho += wheel.A * mp.cos(theta)
        return rho * mp.expj(at)

    along = mp.diff(point, phi)
    normal = -1j * along / abs(along)
    x, y, _ = map(mp.mpf, wheel.displacement(phi))
    return mp.re(mp.conj(normal) * mp.mpc(x, y))


@pytest.mark.parametrize("wheel", WHEELS[:3])
def test_error_along_the_normal(wheel: TrackWheel) -> None:
    placed = dataclasses.replace(wheel, angles=(0.01, -0.02, 0.03), shift=(0.1, -0.2, 0.3))
    angles = np.random.default_rng(5).uniform(-7, 7, 40)
    got, size = placed.normal_error(angles), placed.planar_error(angles)
    assert (np.abs(got) <= size * (1 + 8 * EPS)).all()
    with mp.workdps(40):
        for phi, error, scale in zip(angles.tolist(), got, size, strict=True):
            # The slope, of order z, is off by some eps of z*phi and turns the normal by no more.
            margin = 20 * EPS * (1 + wheel.z * abs(phi)) * wheel.z * scale
            assert abs(exact_normal_error(placed, phi) - error) <= margin
    assert isinstance(placed.normal_error(1.0), np.float64)
    degrees = placed.normal_error(np.degrees(angles), degrees=True)
    np.testing.assert_allclose(degrees, got, rtol=0, atol=1e3 * EPS * size.max())


def test_the_normal_at_a_crest_is_radial_and_the_error_there_inwards() -> None:
    for wheel in WHEELS:
        pose, crest = wheel.worst_pose(0.1, 0.2), wheel.radius_extremes().at_maximum
        planar = pose.planar_error(crest)
        # The slope at a crest is a rounding of z*phi.
        assert pose.normal_error(crest) == pytest.approx(-planar, rel=100 * EPS)
    # With |A| = R half of every period lies in the pole.
    assert math.isnan(WHEELS[3].normal_error(math.pi / WHEELS[3].z))


@pytest.mark.parametrize(
    ("method", "given", "error", "message"),
    [
        (
            "largest_tilt",
            {},
            TypeError,
            "nothing given: give exactly one of planar_error, spatial_error",
        ),
        ("largest_tilt", {"planar_error": 1, "spatial_error": 1}, TypeError, "give exactly one of"),
        ("largest_tilt", {"planar_error": "1"}, TypeError, "planar_error = '1': must be a real"),
        (
            "largest_tilt",
            {"planar_error": 0.1, "offset": 0.2},
            ValueError,
            r"planar_error = 0.1: must lie between the offset, 0.2, and 65.4",
        ),
        ("largest_tilt", {"spatial_error": 70}, ValueError, r"spatial_error = 70.*and 69.965"),
        ("largest_tilt", {"spatial_error": 1, "offset": -1}, ValueError, "offset = -1: must not"),
        (
            "largest_offset",
            {"spatial_error": 0.01, "tilt": 1e-3},
            ValueError,
            r"spatial_error = 0.01: must be at least 0.0494.*, that of the tilt alone",
        ),
        (
            "largest_offset",
            {"planar_error": 1, "tilt": 2},
            ValueError,
            "tilt = 2: must lie",
        ),
        ("worst_pose", {"tilt": -0.1}, ValueError, "tilt = -0.1: must lie between 0 and pi/2"),
        ("worst_pose", {"offset": math.nan}, ValueError, "offset = nan: must be finite"),
    ],
)
def test_what_is_out_of_reach_is_named(
    method: str, given: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        getattr(WHEELS[0], method)(**given)


def test_degrees_and_quantities() -> None:
    wheel = WHEELS[0]
    tilt = wheel.largest_tilt(planar_error=0.05)
    assert wheel.largest_tilt(planar_error=0.05, degrees=True) == math.degrees(tilt)
    assert wheel.worst_pose(30, degrees=True) == wheel.worst_pose(math.radians(30))
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    found = wheel.largest_tilt(planar_error=50 * units.um)
    assert found.to("rad").magnitude == pytest.approx(tilt, rel=8 * EPS)
    offset = wheel.largest_offset(spatial_error=50 * units.um)
    assert offset.to("mm").magnitude == pytest.approx(0.05, rel=8 * EPS)
