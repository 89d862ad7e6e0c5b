"""The consequences of Table 1 for the wheel with a track, recomputed by the shipped kernels."""

from __future__ import annotations

import numpy as np
import pytest
from derived import judge_all

from mechproof.kernels import track_wheel as kernels

FORM, MOUNTING, ELASTIC, SETTING, WEAR = TABLE = np.array([0.016, 0.05, 0.042, 0.01, 0.021])
SHARE = 0.15
TURNS, NO_SHIFT = (0.00103, 0.00103, 0.0), (0.0, 0.0, 0.0)
RADIUS, AMPLITUDE = 41.5, 3.75

pytestmark = pytest.mark.xdist_group("verdicts track_wheel")


def total(errors, coefficients=1.0):
    return kernels.error_sum_thermal(errors, 1.0, coefficients, 1.0, SHARE, 1.0)


def fall(place, left, coefficients=1.0):
    """Return by how many per cent the total falls when one error is scaled by `left`."""
    changed = TABLE.copy()
    changed[place] *= left
    return 100 * (1 - total(changed, coefficients) / total(TABLE, coefficients))


def coefficients_of_elastic(own, others):
    return np.where(TABLE == ELASTIC, own, others)


def curvature_at(count, angle):
    """Return the radius of curvature of the track by finite differences of its points."""
    step = 1e-4
    before, here, after = (
        kernels.track(angle + k * step, RADIUS, AMPLITUDE, count, 1.0)[:2] for k in (-1, 0, 1)
    )
    first, second = (after - before) / (2 * step), (after - 2 * here + before) / step**2
    return np.hypot(*first) ** 3 / abs(first[0] * second[1] - first[1] * second[0])


def moved(points):
    return kernels.displacement(points, TURNS, NO_SHIFT)


def ring():
    angle = np.linspace(0, 2 * np.pi, 7201)
    return (RADIUS + AMPLITUDE) * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)


FOUND = {
    "Fig. 5, largest possible gain": lambda: {"19.3": fall(2, 0.0)},
    "Consequences, shares of the errors": lambda: dict(
        zip(
            ("5.1", "49.4", "34.9", "2.0", "8.7"),
            100 * TABLE**2 / kernels.error_sum(TABLE, 1.0, 1.0, 1.0) ** 2,
            strict=True,
        )
    ),
    "Consequences, gain by other laws": lambda: {
        "38.0": fall(2, 0.0, coefficients_of_elastic(np.sqrt(3), 1.0)),
        "7.9": fall(2, 0.0, coefficients_of_elastic(1.0, np.sqrt(3))),
    },
    "Consequences, half the mounting error": lambda: {"20.7": fall(1, 0.5)},
    "Consequences, no form error": lambda: {"2.6": fall(0, 0.0)},
    "Consequences, turns alone": lambda: {
        "0.0659": np.abs(moved(ring())[:, 2]).max(),
        "0.00146": kernels.planar_error(moved([0.0, 0.0, 1.0])),
    },
    "Consequences, number of periods": lambda: {
        "8.3": curvature_at(7, 0.0),
        "6.7": curvature_at(8, 0.0),
        "11.0": curvature_at(7, np.pi / 7),
    },
}


@pytest.mark.parametrize("number", FOUND)
def test_the_kernels_find_the_numbers_of_a_consequence(number: str) -> None:
    row = judge_all("track_wheel")[number]
    assert "consequence" in row.marks
    for printed, value in FOUND[number]().items():
        assert printed in row.printed_latex
        decimals = len(printed.partition(".")[2])
        assert f"{value:.{decimals}f}" == printed


def test_the_first_order_is_off_by_no_more_than_its_bound() -> None:
    points = ring()
    linear = np.cross(TURNS, points)
    off = np.linalg.norm(moved(points) - linear, axis=-1).max()
    assert 1e-5 < off < 0.000096
