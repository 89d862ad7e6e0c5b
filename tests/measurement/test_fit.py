"""Fits to simulated readings with known parameters and scatter."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from mechproof.kernels import elliptic_planetary as elliptic, oval_planetary as oval
from mechproof.measurement import fit

SCATTER = 2e-3


def read(ratio: float, e: float, zeros: tuple[float, float], turns: float, count: int) -> Any:
    """Simulate readings of an elliptical mechanism, with the output reduced to one turn."""
    rng = np.random.default_rng(round(1000 * ratio))
    phi1 = np.sort(rng.uniform(0, 2 * math.pi * turns, count))
    phi3 = elliptic.position(phi1 - zeros[0], ratio, 1.0, e) + zeros[1]
    return phi1, (phi3 + rng.normal(0, SCATTER, count)) % (2 * math.pi)


@pytest.mark.parametrize(
    ("ratio", "e", "zeros", "turns", "count"),
    [
        (3.0, 0.3, (0.1, 0.2), 2, 100),
        (4.125, 0.475, (-0.3, 2.0), 1, 60),
        (2.01, 0.9, (0.2, -1.0), 3, 100),
        (3.0, 0.3, (0.1, 0.2), 20, 90),
    ],
)
def test_parameters_are_found_from_no_start(
    ratio: float, e: float, zeros: tuple[float, float], turns: float, count: int
) -> None:
    found = fit(elliptic.position, *read(ratio, e, zeros, turns, count), ratio=(1.0, 6.0))
    for estimate, true in zip(found.estimates.values(), (ratio, e, *zeros), strict=True):
        # Student's t of 56 degrees of freedom is beyond 6 with probability 2e-7.
        assert abs(estimate.value - true) < 6 * estimate.uncertainty
        assert estimate.uncertainty < 0.01
    assert found.standard_deviation == pytest.approx(SCATTER, rel=0.5)
    assert found.degrees_of_freedom == count - 4


@pytest.mark.slow
def test_the_covariance_is_that_of_repeated_readings() -> None:
    phi1, _ = read(3.0, 0.3, (0.0, 0.0), 2, 40)
    exact, rng = elliptic.position(phi1, 3.0, 1.0, 0.3), np.random.default_rng(5)
    fits = [
        fit(
            elliptic.position,
            phi1,
            exact + rng.normal(0, SCATTER, 40),
            ratio=(2.5, 3.5),
            zeros=False,
        )
        for _ in range(60)
    ]
    spread = np.std([one.values for one in fits], axis=0, ddof=1)
    stated = fit(elliptic.position, phi1, exact, ratio=(2.5, 3.5), zeros=False, uncertainty=SCATTER)
    # The deviation of 60 fits scatters by 1/sqrt(118) = 9 %: allow 5 of these.
    np.testing.assert_allclose(spread, np.sqrt(np.diag(stated.covariance)), rtol=0.46)
    assert stated.estimates["e"].degrees_of_freedom == math.inf


def test_sensitivities_are_the_slopes_of_the_errors() -> None:
    phi1, phi3 = read(3.0, 0.3, (0.1, 0.2), 1, 30)
    found = fit(elliptic.position, phi1, phi3, ratio=(2, 4))
    ratio, e, first, _ = found.values
    step = 1e-6
    moved = [elliptic.position(phi1 - first, ratio + s * step, 1.0, e) for s in (-1, 1)]
    slope = (moved[1] - moved[0]) / (2 * step)
    np.testing.assert_allclose(found.sensitivities[:, 0], slope, rtol=1e-6, atol=1e-6)
    np.testing.assert_array_equal(found.sensitivities[:, 3], 1.0)


def test_of_ovals_one_joint_eccentricity_is_found() -> None:
    phi1, rng = np.linspace(0, 7, 80), np.random.default_rng(2)
    found = fit(oval.position, phi1, oval.position(phi1, 0.3, 0.2) + rng.normal(0, SCATTER, 80))
    joint = found.estimates["e2"]
    assert abs(joint.value - (0.3 + 0.2) / (1 + 0.3 * 0.2)) < 6 * joint.uncertainty
    reading = oval.position_cylindrical(phi1, 30.0, 20.0, 0.2) + rng.normal(0, SCATTER, 80)
    pair = fit(oval.position_cylindrical, phi1, reading, ratio=(0.5, 3)).estimates
    assert abs(pair["R4/R5"].value - 1.5) < 6 * pair["R4/R5"].uncertainty
    assert abs(pair["e2"].value - 0.2) < 6 * pair["e2"].uncertainty


def test_readings_that_fit_two_ratios_are_refused() -> None:
    """With spacing h and the output on any turn, ratios 2*pi/h apart give the same readings."""
    phi1 = 0.9 * np.arange(60)
    phi3 = elliptic.position(phi1, 3.0, 1.0, 0.3)
    with pytest.raises(ValueError, match="do not distinguish R1/R2 = "):
        fit(elliptic.position, phi1, phi3, ratio=(1, 11))
    assert fit(elliptic.position, phi1, phi3, ratio=(1, 6)).values[0] == pytest.approx(3.0)


def test_what_no_mechanism_does_is_refused() -> None:
    phi1 = np.linspace(0, 12, 100)
    noise = np.random.default_rng(4).uniform(0, 2 * math.pi, 100)
    with pytest.raises(ValueError, match="no parameters in these ranges explain it"):
        fit(elliptic.position, phi1, noise, ratio=(1, 4))


def test_zeros_of_a_mechanism_without_eccentricity_are_not_told_apart() -> None:
    phi1 = np.linspace(0, 12, 100)
    with pytest.raises(ValueError, match="do not determine"):
        fit(elliptic.position, phi1, elliptic.position(phi1, 3.0, 1.0, 0.0), ratio=(2, 4))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"position": elliptic.ratio}, "must be one of the kernels"),
        ({"phi1": [0.0, math.nan]}, "must be finite"),
        ({"measured": [0.0]}, "has 1 readings"),
        ({"measured": [0.0, 1.0]}, "for 4 parameters"),
        ({"ratio": (3, 2)}, "ratio"),
        ({"uncertainty": -1.0}, "uncertainty"),
    ],
)
def test_wrong_arguments_are_named(change: dict[str, Any], message: str) -> None:
    given = {"position": elliptic.position, "phi1": [0.0, 1.0], "measured": [0.0, 1.0], **change}
    with pytest.raises(ValueError, match=message):
        fit(**given)


def test_it_prints_in_the_notation_of_the_gum() -> None:
    text = str(fit(elliptic.position, *read(3.0, 0.3, (0.1, 0.2), 2, 100), ratio=(2, 4)))
    assert text.startswith("R1/R2 = 2.999870(60)\ne = ")
    assert "readings scatter by 0.002" in text
