"""Sizes from requirements on the ratio, and the extremes of its derivatives."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from mechproof import EllipticPlanetary

EPS = float(np.finfo(float).eps)
ECCENTRICITIES = (0.0, 1e-9, 0.1, 0.101, 0.102, 0.28, 0.475, 0.9, 0.999)


def wishes(drive: EllipticPlanetary) -> dict[str, float]:
    """Return the requirements, by their argument names, that a drive exactly meets."""
    found = drive.extremes()
    return {
        "largest_ratio": found.maximum,
        "smallest_ratio": found.minimum,
        "quotient": found.maximum / found.minimum,
        "non_uniformity": (found.maximum - found.minimum) / (1 + drive.radius_ratio),
    }


@pytest.mark.parametrize("e", ECCENTRICITIES)
@pytest.mark.parametrize("radii", [(66.0, 16.0), (50.3, 50.2), (97.1, 1.3)])
def test_a_drive_is_found_again_from_what_it_does(radii: tuple[float, float], e: float) -> None:
    drive = EllipticPlanetary(*radii, e)
    for name, value in wishes(drive).items():
        # At e = 0 rounding may put a wish out of reach.
        if e == 0 and name != "non_uniformity":
            continue
        found = EllipticPlanetary.design(R1=radii[0], R2=radii[1], **{name: value})
        assert radii == (found.R1, found.R2)
        # The wish has 3 eps of its value, more than i - 1 + k; e the same, and 9 eps of its own.
        condition = 2 + max(value, drive.radius_ratio) / drive.radius_ratio
        assert abs(found.e - e) <= 16 * EPS * condition


@pytest.mark.parametrize("e", ECCENTRICITIES[1:])
def test_both_extremes_give_radii_and_eccentricity(e: float) -> None:
    drive = EllipticPlanetary(66, 16, e)
    ends = drive.extremes()
    sizes: dict[str, Any] = {"largest_ratio": ends.maximum, "smallest_ratio": ends.minimum}
    for given in ({}, {"R1": 66}, {"R2": 16}):
        found = EllipticPlanetary.design(**sizes, **given)
        # i - 1 carries 3 eps of i; the root halves it.
        assert found.radius_ratio == pytest.approx(
            66 / 16, rel=8 * EPS / (ends.minimum - 1) + 8 * EPS
        )
        assert found.e == pytest.approx(e, abs=8 * EPS * ends.minimum / (ends.minimum - 1))
        assert [getattr(found, n) for n in given] == list(given.values())


def test_a_wish_of_a_constant_ratio_gives_circles() -> None:
    random = np.random.default_rng(7)
    for k in random.uniform(1.001, 30, 200):
        uniform = 1 + k
        for value in (uniform, np.nextafter(uniform, np.inf)):
            assert EllipticPlanetary.design(largest_ratio=value, k=k).e <= 4 * EPS
        for value in (uniform, np.nextafter(uniform, 1)):
            assert EllipticPlanetary.design(smallest_ratio=value, k=k).e <= 4 * EPS


def test_with_k_alone_the_small_wheel_has_1_mm() -> None:
    assert EllipticPlanetary.design(largest_ratio=5, k=3) == EllipticPlanetary(3, 1, 1 / 7)
    assert EllipticPlanetary.design(largest_ratio=5, k=3, R1=60).R2 == 20
    assert EllipticPlanetary.design(largest_ratio=5, k=3, R2=20).R1 == 60


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        (
            {"largest_ratio": 3.9, "k": 3},
            ValueError,
            r"largest_ratio = 3.9: must be at least 1 \+ k",
        ),
        ({"largest_ratio": math.nan, "k": 3}, ValueError, "largest_ratio = nan: must be finite"),
        ({"smallest_ratio": 4.1, "k": 3}, ValueError, r"must be above 1 and at most 1 \+ k = 4.0"),
        ({"smallest_ratio": 1, "k": 3}, ValueError, r"smallest_ratio = 1.0: must be above 1"),
        ({"quotient": 0.9, "k": 3}, ValueError, "quotient = 0.9: must be at least 1"),
        ({"non_uniformity": -1, "k": 3}, ValueError, "non_uniformity = -1.0: must not be neg"),
        ({"largest_ratio": 1e30, "k": 3}, ValueError, "so near to 1"),
        ({"quotient": 1e200, "k": 3}, ValueError, "so near to 1"),
        ({"non_uniformity": 1e308, "k": 1e5}, ValueError, "so near to 1"),
        ({"largest_ratio": 5, "k": 1}, ValueError, "k = 1: must be above 1"),
        ({"largest_ratio": 5, "k": -3}, ValueError, "k = -3.0: must be positive"),
        ({"largest_ratio": 5, "R1": 3, "R2": 3}, ValueError, "R2 = 3.0: must be below R1 = 3.0"),
        ({"largest_ratio": 5}, TypeError, "give R1 and R2, or k"),
        ({"largest_ratio": 5, "R1": 3}, TypeError, "give R1 and R2, or k"),
        ({"largest_ratio": 5, "R1": 3, "R2": 1, "k": 3}, TypeError, "give R1 and R2, or k"),
        ({"k": 3}, TypeError, "nothing given: give exactly one of largest_ratio"),
        ({"quotient": 2, "largest_ratio": 5, "k": 3}, TypeError, "largest_ratio, quotient given"),
        ({"largest_ratio": 1.5, "smallest_ratio": 1.4}, ValueError, "must be above 3.5.*else R1"),
        ({"largest_ratio": 2, "smallest_ratio": 3}, ValueError, "at least the smallest, 3.0"),
        ({"largest_ratio": 2, "smallest_ratio": 1}, ValueError, "smallest_ratio = 1.0"),
        ({"largest_ratio": 5, "smallest_ratio": 2, "k": 3}, ValueError, "k = 3: follows from"),
        ({"largest_ratio": 5, "smallest_ratio": 2, "R1": 3, "R2": 1}, ValueError, "R2 = 1: foll"),
        ({"largest_ratio": "5", "k": 3}, TypeError, "largest_ratio = '5'"),
        ({"largest_ratio": 5, "k": [3]}, TypeError, "k = "),
    ],
)
def test_what_cannot_be_had_is_said(
    given: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        EllipticPlanetary.design(**given)


@pytest.mark.parametrize("of", ["acceleration", "jerk"])
@pytest.mark.parametrize("e", ECCENTRICITIES[1:-1])
def test_extremes_of_derivatives_are_attained_and_not_passed(e: float, of: Any) -> None:
    drive = EllipticPlanetary(66, 16, e)
    found, curve = drive.extremes(of), getattr(drive, of)
    assert found.period == drive.extremes().period
    x = np.linspace(0, 2 * math.pi, 20001)
    # Uniform in x, and dense near the peak, which is as narrow as 1 - e.
    angles = np.concatenate([x, 2 * np.arctan((1 - e) / (1 + e) * np.tan(x / 2))]) * 16 / 66
    values = curve(angles)
    # 24 eps of the jerk's terms, which are up to twice its peak, and 21 of the closed form.
    size = max(abs(found.maximum), abs(found.minimum))
    assert values.max() <= found.maximum + 80 * EPS * size
    assert values.min() >= found.minimum - 80 * EPS * size
    # Angles are known to 8 eps and the curve is flat there, but not where one peak splits into two.
    near = 1e-9 * size
    assert curve(found.at_maximum) == pytest.approx(found.maximum, abs=near)
    assert curve(found.at_minimum) == pytest.approx(found.minimum, abs=near)
    # 20001 samples of a smooth peak miss it by a few 1e-8 of its size.
    assert values.max() >= found.maximum - 1e-6 * size


def test_extremes_of_nothing_else() -> None:
    with pytest.raises(ValueError, match="of = 'position': must be 'ratio'"):
        EllipticPlanetary.published(1).extremes("position")  # type: ignore[arg-type]
