"""The oracle agrees with independent ones: mpmath, SciPy's laws, rotations and quadrature."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from weights import first_of

from mechproof.lab.oracle import find_errors, find_truth, summarise
from mechproof.lab.sampling.named_sets import REPORT, draw_points
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject, find_subjects

EPS = float(np.finfo(float).eps)


def subject(name: str) -> Subject:
    (found,) = find_subjects((name,))
    return found


def elliptic_points(count: int) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(1)
    e = 1 - 10 ** rng.uniform(-12, -0.1, count)
    return rng.uniform(-1e6, 1e6, count), np.full(count, 80.0), np.full(count, 30.0), e


def test_position_equals_mpmath() -> None:
    points = elliptic_points(40)
    truth = find_truth(subject("elliptic_planetary.position"), points)
    with mp.workdps(60):
        for high, low, *row in zip(truth.high, truth.low, *points, strict=True):
            phi, r1, r2, e = map(mp.mpf, map(float, row))
            x = r1 / r2 * phi
            exact = phi + x + 2 * mp.atan2(e * mp.sin(x), 1 - e * mp.cos(x))
            # Two doubles resolve 2**-106; 60 digits are finer.
            assert abs(mp.mpf(float(high)) + mp.mpf(float(low)) - exact) <= abs(exact) * 2.0**-100


def test_position_equals_the_wrapped_cauchy_law_on_one_turn() -> None:
    from scipy.stats import wrapcauchy

    e, x = map(np.ravel, np.meshgrid([0.1, 0.475, 0.9], np.linspace(0.05, 6.2, 40)))
    # k = 2, so that x is twice the carrier's angle.
    truth = find_truth(
        subject("elliptic_planetary.position"), (x / 2, np.full_like(x, 2.0), np.ones_like(x), e)
    )
    assert not truth.undecided
    # SciPy's cdf uses an arctangent of a quotient: a few eps of 2*pi.
    expected = x / 2 + 2 * np.pi * wrapcauchy.cdf(x, e)
    assert np.max(np.abs(truth.high - expected)) <= 16 * EPS * 2 * np.pi


def test_position_equals_the_integral_of_the_ratio() -> None:
    from scipy.integrate import quad

    for e in (0.2, 0.475, 0.8):
        found = find_truth(
            subject("elliptic_planetary.position"), tuple(map(np.array, ([1.3], 66.0, 16.0, e)))
        )

        def ratio(t: float, e: float = e) -> float:
            return 1 + 66 / 16 * (1 - e**2) / (1 + e**2 - 2 * e * np.cos(66 / 16 * t))

        value, error = quad(ratio, 0, 1.3, epsabs=0, epsrel=1e-13, limit=500)
        assert abs(found.high[0] - value) <= error + 1e-13 * value


def test_rotation_equals_scipy() -> None:
    from scipy.spatial.transform import Rotation

    angles = np.random.default_rng(2).uniform(-np.pi, np.pi, (30, 3))
    truth = find_truth(subject("track_wheel.rotation"), tuple(angles.T))
    theirs = Rotation.from_euler("XYZ", angles).as_matrix().swapaxes(-1, -2)
    # A product of three quaternions and their squares: some 16 roundings on numbers up to 2.
    assert np.max(np.abs(truth.high - theirs)) <= 16 * EPS


def test_shares_equal_quadrature_of_the_outside() -> None:
    """The wrongly accepted share, integrated in another way: over Y outside the limits."""
    from scipy.integrate import quad
    from scipy.special import ndtr

    mean, std, bias, error, low, high = 0.1, 1.0, 0.05, 0.3, -2.0, 2.5
    found = find_truth(
        subject("conformity.wrongly_accepted"),
        tuple(np.array([v]) for v in (mean, std, bias, error, low, high)),
    )

    def accepted(y: float) -> float:
        density = np.exp(-(((y - mean) / std) ** 2) / 2) / std / np.sqrt(2 * np.pi)
        return float(density * (ndtr((high - y - bias) / error) - ndtr((low - y - bias) / error)))

    value = sum(quad(accepted, *ends, epsabs=1e-14)[0] for ends in ((low - 9, low), (high, 12)))
    assert abs(found.high[0] - value) <= 1e-12


def test_a_point_that_cannot_be_decided_is_counted() -> None:
    position = subject("elliptic_planetary.position")
    points = tuple(map(np.array, ([1.0, np.nan, np.inf, 2.0], 66.0, 16.0, 0.475)))
    truth = find_truth(position, points)
    assert truth.undecided == 2
    assert truth.decided.tolist() == [True, False, False, True]
    with np.errstate(invalid="ignore"):
        result = position.kernel(*points)
    summary = summarise(find_errors(result, truth), truth)
    assert (summary.points, summary.undecided) == (4, 2)
    assert np.isfinite(summary.worst_ulp)


def test_tiny_angles_are_decided() -> None:
    points = np.array([[41.5, -3.0, 20.0]]), np.array([[1e-300, 1e-290, -1e-300]]), np.zeros((1, 3))
    truth = find_truth(subject("track_wheel.displacement"), points)
    expected = [1e-290 * 20, -1e-300 * (41.5 + 20), -1e-300 * 3 - 1e-290 * 41.5]
    assert np.allclose(truth.high[0], expected, rtol=1e-9, atol=0)


def test_a_wrong_definition_is_seen() -> None:
    """The comparison with SciPy would notice a transpose, which is far off."""
    angles = np.random.default_rng(2).uniform(-np.pi, np.pi, (5, 3))
    truth = find_truth(subject("track_wheel.rotation"), tuple(angles.T))
    assert np.max(np.abs(truth.high - truth.high.swapaxes(-1, -2))) > 0.1


DECIDED = ("elliptic_planetary.ratio", "oval_planetary.position", "track_wheel.displacement")


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of([*DECIDED, "track_wheel.error_sum_thermal"]))
def test_every_point_of_the_sets_is_decided(name: str) -> None:
    for point_set in list_sets(subject(name), 0.2):
        if not point_set.ordered:
            points = draw_points(point_set, REPORT)
            assert find_truth(subject(name), points).undecided == 0, point_set.name


@pytest.mark.slow
@pytest.mark.parametrize("name", ["track_wheel.radius", "track_wheel.track"])
def test_only_the_pole_itself_is_undecided(name: str) -> None:
    """Where |A| = R the circle passes through the pole, a sum of opposites that is exactly 0."""
    for point_set in list_sets(subject(name), 0.2):
        points = draw_points(point_set, REPORT)
        truth = find_truth(subject(name), points)
        through_the_pole = np.abs(points[2]) == points[1]
        assert np.all(truth.decided | through_the_pole), point_set.name
