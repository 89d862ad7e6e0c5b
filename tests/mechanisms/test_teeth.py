"""Tooth numbers and modules, and the length of pitch curves."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from mechproof.mechanisms.teeth import (
    Teeth,
    ellipse_perimeter,
    find_nearest_teeth,
    find_oval_teeth,
    find_teeth,
    oval_perimeter,
)

EPS = float(np.finfo(float).eps)
ECCENTRICITIES = (0.0, 1e-9, 0.2, 1 / 3, 0.7, 0.95, 0.999)


@pytest.mark.parametrize("e", ECCENTRICITIES)
def test_perimeters_against_30_digits(e: float) -> None:
    with mp.workdps(30):
        exact = mp.mpf(e)

        def speed(u: mp.mpf) -> mp.mpf:
            spread = 1 - exact * mp.cos(u)
            return (1 - exact**2) * mp.hypot(spread, 2 * exact * mp.sin(u)) / spread**2

        narrow = min(1 - exact, mp.mpf(1) / 2)
        oval = 2 * mp.quad(speed, [0, narrow / 4, narrow, min(8 * narrow, 2), mp.pi])
        assert abs(oval_perimeter(25.0, e) - 25 * oval) <= 8 * EPS * 25 * oval
        ellipse = 4 * 25 * mp.ellipe(exact**2)
        assert abs(ellipse_perimeter(25.0, e) - ellipse) <= 4 * EPS * ellipse


def test_perimeters_of_arrays_and_outside() -> None:
    found = oval_perimeter([[1.0], [2.0]], [0.0, 0.2, 1.0])
    assert found.shape == (2, 3)
    assert found[1, :2].tolist() == (2 * found[0, :2]).tolist()
    assert np.isnan(found[:, 2]).all()
    assert np.isnan(ellipse_perimeter([1, -1, 1, math.nan], [-0.1, 0.1, 1.0, 0.1])).all()
    with pytest.raises(ArithmeticError, match="needs more than"):
        oval_perimeter(1.0, 1 - 1e-12)


def test_all_teeth_that_give_radii_exactly() -> None:
    found = find_teeth(66, 16, internal=True)
    assert found == (Teeth(132, 32, 1.0, 66.0, 16.0), Teeth(66, 16, 2.0, 66.0, 16.0))
    assert find_teeth("30.5", 20, modules=("0.5", "1"), teeth=(12, 130)) == (
        Teeth(122, 80, 0.5, 30.5, 20.0),
        Teeth(61, 40, 1.0, 30.5, 20.0),
    )
    assert find_teeth(math.pi, 1) == ()


@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("radii", [(math.pi, 1.0), (66.0, 16.1), (1.0, 1.9), (40.0, 1.0)])
def test_the_nearest_teeth_of_all(radii: tuple[float, float], internal: bool) -> None:
    if internal and radii[0] < radii[1]:
        return
    found = find_nearest_teeth(*radii, internal=internal, teeth=(12, 60))
    ratio = Fraction(radii[0]) / Fraction(radii[1])
    errors = {
        (z1, z2): abs(Fraction(z1, z2) - ratio)
        for z1 in range(12, 61)
        for z2 in range(12, 61)
        if z1 > z2 or not internal
    }
    least = min(errors.values())
    assert errors[found[-1].z1, found[-1].z2] == least
    fewest = min(z1 + z2 for (z1, z2), error in errors.items() if error == least)
    assert found[-1].z1 + found[-1].z2 == fewest
    chosen = [errors[t.z1, t.z2] for t in found]
    assert chosen == sorted(set(chosen), reverse=True)
    axes = -1 if internal else 1
    for teeth in found:
        assert teeth.R1 + axes * teeth.R2 == pytest.approx(radii[0] + axes * radii[1], rel=8 * EPS)
        assert abs(teeth.R1 - teeth.module * teeth.z1 / 2) <= 4 * EPS * teeth.R1


def test_teeth_that_close_a_pitch_curve() -> None:
    found = find_oval_teeth(25, 0.2, teeth=(20, 30))
    for teeth in found:
        assert math.pi * teeth.module * teeth.z == pytest.approx(
            oval_perimeter(25, 0.2), rel=4 * EPS
        )
    assert [t.z for t in found if t.alike] == [22, 26, 30]
    ellipses = find_oval_teeth(25, 0.2, teeth=(20, 30), lobes=1)
    assert [t.z for t in ellipses if t.alike] == [21, 23, 25, 27, 29]


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: find_teeth(0, 1), ValueError, "R1 = 0.0: must be positive"),
        (lambda: find_teeth(1, 2, internal=True), ValueError, "R2 = 2: must be below R1 = 1"),
        (lambda: find_teeth(1, "x"), ValueError, "R2 = 'x'"),
        (lambda: find_teeth(2, 1, modules=(0,)), ValueError, "modules = Fraction"),
        (lambda: find_nearest_teeth(2, 1, teeth=(3, 2)), ValueError, "teeth = "),
        (lambda: find_nearest_teeth(2, 1, teeth=(1.5, 2)), TypeError, "teeth = 1.5"),  # type: ignore[arg-type]
        (lambda: find_oval_teeth(1, 0.1, lobes=3), ValueError, "lobes = 3: must be 1 or 2"),
        (lambda: oval_perimeter("1", 0.1), TypeError, "a = '1'"),  # type: ignore[arg-type]
    ],
)
def test_what_is_refused(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()
