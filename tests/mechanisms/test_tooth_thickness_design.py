"""Inspections backwards: acceptance limits, largest gauge and IT grade for a wanted risk."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.stats import norm

from mechproof import ThicknessInspection, ToothThickness
from mechproof.laws import Law, Normal, TruncatedNormal, Uniform
from mechproof.mechanisms.tooth_thickness_inspection import IT_120_TO_180

TOLERANCE = (-0.057, -0.012)
FIXED = Normal(0.0, 0.0)
TIP = Normal.from_width(0.0, 0.063, 6)
RISKS = ("consumer_risk", "producer_risk")


def inspect(gauge: Law, tip: Law = TIP, **changes: Any) -> ThicknessInspection:
    found = ThicknessInspection.published(
        true=Normal(-0.033, 0.0075), tip_diameter=tip, height=gauge, thickness=gauge
    )
    return dataclasses.replace(found, **changes)


GAUGE = inspect(Normal(0.0, 0.001))


def integrate(inspection: ThicknessInspection, name: str, acceptance: tuple[float, float]) -> float:
    """Return a risk with normal errors, by quadrature over the true deviation."""
    mean, std = float(inspection.true.mean), float(inspection.true.std)  # type: ignore[union-attr]
    spread = math.hypot(*(float(law.std) for law in inspection.errors))  # type: ignore[union-attr]
    (low, high), (least, most) = inspection.tolerance, acceptance

    def accepted(y: float) -> float:
        return float(norm.cdf((most - y) / spread) - norm.cdf((least - y) / spread))

    ends = (low, high) if name == "producer_risk" else None
    places = [mean + k * std for k in (-9, 9)]

    def part(a: float, b: float) -> float:
        def density(y: float) -> float:
            share = accepted(y) if ends is None else 1 - accepted(y)
            return share * float(norm.pdf((y - mean) / std)) / std

        marks = [p for p in (least, most, mean) if a < p < b]
        return float(quad(density, a, b, points=marks or None, epsabs=1e-14, limit=400)[0])

    if ends is not None:
        return part(*ends)
    return part(places[0], float(low)) + part(float(high), places[1])


@pytest.mark.parametrize("name", RISKS)
@pytest.mark.parametrize("risk", [1e-6, 1e-4, 1.1e-3])
def test_acceptance_limits_have_the_risk(name: str, risk: float) -> None:
    low, high = GAUGE.acceptance_limits(**{name: risk})
    assert low - TOLERANCE[0] == pytest.approx(TOLERANCE[1] - high, abs=1e-16)
    # The quadrature is good to some 1e-13.
    assert integrate(GAUGE, name, (low, high)) == pytest.approx(risk, rel=1e-6)
    # Inwards where the risk of simple acceptance is larger for the consumer.
    inwards = low > TOLERANCE[0]
    smaller = risk < getattr(GAUGE, name)()
    assert inwards == (smaller if name == "consumer_risk" else not smaller)


def test_simple_acceptance_has_no_guard_band() -> None:
    for name in RISKS:
        limits = GAUGE.acceptance_limits(**{name: float(getattr(GAUGE, name)())})
        np.testing.assert_allclose(limits, TOLERANCE, rtol=0, atol=1e-15)


def test_a_limit_on_one_side_stays_alone() -> None:
    one = dataclasses.replace(GAUGE, tolerance=(-math.inf, -0.012))
    for name in RISKS:
        low, high = one.acceptance_limits(**{name: 1e-4})
        assert low == -math.inf
        assert getattr(one, name)((low, high)) == pytest.approx(1e-4, rel=1e-9)
    wider = one.scale_gauge(consumer_risk=0.001)
    assert wider.consumer_risk() == pytest.approx(0.001, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "risk"),
    [
        *(("producer_risk", risk) for risk in (0.0063, 0.02, 0.5, 0.99)),
        *(("consumer_risk", risk) for risk in (0.00102, 0.0013, 0.00145)),
    ],
)
def test_the_largest_gauge_has_the_risk_and_no_smaller_one_a_larger(name: str, risk: float) -> None:
    found = GAUGE.scale_gauge(**{name: risk})
    assert integrate(found, name, TOLERANCE) == pytest.approx(risk, rel=1e-6)
    # Both errors grow by one factor, all else stays.
    factor = float(found.thickness.std) / 0.001  # type: ignore[union-attr]
    assert float(found.height.std) == pytest.approx(0.001 * factor)  # type: ignore[union-attr]
    assert dataclasses.replace(found, height=GAUGE.height, thickness=GAUGE.thickness) != found
    assert (found.true, found.tip_diameter) == (GAUGE.true, GAUGE.tip_diameter)
    smaller = Normal(0.0, 0.001 * factor * np.linspace(0, 1 - 1e-6, 400))
    assert (getattr(inspect(smaller), name)() < risk).all()
    larger = Normal(0.0, 0.001 * factor * 1.0001)
    assert getattr(inspect(larger), name)() > risk


@pytest.mark.slow
@pytest.mark.parametrize(
    ("gauge", "tip"),
    [
        (Uniform(-0.003, 0.003), TIP),
        (Uniform(-0.003, 0.003), Uniform(-0.02, 0.02)),
        (TruncatedNormal(0.0, 0.002, -0.003, 0.003), TIP),
    ],
)
def test_gauges_of_other_laws(gauge: Law, tip: Law) -> None:
    inspection = inspect(gauge, tip, height=FIXED)
    for name, risk in (("consumer_risk", 0.0013), ("producer_risk", 0.01)):
        found = inspection.scale_gauge(**{name: risk})
        # The shares are good to 1e-8.
        assert getattr(found, name)() == pytest.approx(risk, abs=2e-8)
        assert type(found.thickness) is type(gauge)
        limits = inspection.acceptance_limits(**{name: risk / 2})
        assert getattr(inspection, name)(limits) == pytest.approx(risk / 2, abs=2e-8)


@pytest.mark.slow
def test_the_consumers_risk_falls_again_and_the_least_gauge_counts() -> None:
    # With a gauge a million times as bad nothing is accepted at all.
    found = GAUGE.scale_gauge(consumer_risk=0.0014)
    wild = inspect(Normal(0.0, 1000.0))
    assert wild.consumer_risk() < 0.0014
    assert float(found.thickness.std) < 0.02  # type: ignore[union-attr]
    with pytest.raises(
        ValueError, match=r"consumer_risk = 0.0\d+: must lie between 0.001.*about"
    ) as e:
        GAUGE.scale_gauge(consumer_risk=0.01)
    largest = float(str(e.value).split("about ")[1].split(",")[0])
    scan = inspect(Normal(0.0, 0.001 * np.geomspace(1, 200, 4000))).consumer_risk()
    assert largest == pytest.approx(scan.max(), rel=1e-4)
    close = GAUGE.scale_gauge(consumer_risk=0.99 * largest)
    assert close.consumer_risk() == pytest.approx(0.99 * largest, rel=1e-9)


def test_the_coarsest_grade_has_the_risk_and_the_next_has_not() -> None:
    grades = [*IT_120_TO_180]
    risks = [
        float(inspect(Normal(0.0, 0.001), Normal.from_width(0, field, 6)).producer_risk())
        for field in IT_120_TO_180.values()
    ]
    assert risks == sorted(risks)
    for grade, risk, following in zip(grades, risks, [*risks[1:], 0.5], strict=True):
        assert GAUGE.tip_grade(multiple=6, producer_risk=risk) == grade
        assert GAUGE.tip_grade(multiple=6, producer_risk=(risk + following) / 2) == grade
    assert GAUGE.tip_grade(multiple=6, consumer_risk=0.5) == grades[-1]


@pytest.mark.parametrize(
    ("inspection", "method", "given", "error", "message"),
    [
        (
            GAUGE,
            "acceptance_limits",
            {},
            TypeError,
            "nothing given: give exactly one of consumer_risk",
        ),
        (
            GAUGE,
            "scale_gauge",
            {"consumer_risk": 0.1, "producer_risk": 0.1},
            TypeError,
            "consumer_risk, producer_risk given: give exactly one of",
        ),
        (GAUGE, "scale_gauge", {"producer_risk": 1.5}, ValueError, "producer_risk = 1.5: must lie"),
        (
            GAUGE,
            "acceptance_limits",
            {"consumer_risk": 0.01},
            ValueError,
            "consumer_risk = 0.01: must be below 0.003.*, the share of teeth that do not conform",
        ),
        (
            GAUGE,
            "acceptance_limits",
            {"producer_risk": 0.9999},
            ValueError,
            "must be below 0.99.*, the share of teeth that conform",
        ),
        (
            GAUGE,
            "scale_gauge",
            {"producer_risk": 1e-3},
            ValueError,
            "must lie between 0.00.*, that of a gauge without error, and 0.99.*, the share",
        ),
        (
            inspect(Normal(0.001, 0.001)),
            "scale_gauge",
            {"producer_risk": 0.1},
            ValueError,
            r"height = Normal.*: must be symmetric about 0",
        ),
        (
            inspect(FIXED),
            "scale_gauge",
            {"producer_risk": 0.1},
            ValueError,
            "thickness = Normal.*: this or height must have an error to scale",
        ),
        (
            inspect(Normal(0.0, [0.001, 0.002])),
            "acceptance_limits",
            {"producer_risk": 0.1},
            ValueError,
            r"producer_risk = array.*: must be of one set",
        ),
        (
            inspect(FIXED, FIXED, true=FIXED),
            "acceptance_limits",
            {"consumer_risk": 0.1},
            ValueError,
            "consumer_risk = 0.1: is not reached",
        ),
        (
            dataclasses.replace(GAUGE, tolerance=([-0.057, -0.05], -0.012)),
            "acceptance_limits",
            {"producer_risk": 0.1},
            ValueError,
            "tolerance = .*: must be one pair of numbers here",
        ),
        (
            GAUGE,
            "tip_grade",
            {"producer_risk": 1e-4, "multiple": 6},
            ValueError,
            "producer_risk = 0.0001: must be at least 0.00.*, that of IT5",
        ),
        (
            dataclasses.replace(GAUGE, wheel=ToothThickness(3, 60)),
            "tip_grade",
            {"producer_risk": 0.1, "multiple": 6},
            ValueError,
            "wheel = .*: must have a tip diameter above 120 and up to 180 mm, not 186.0 mm",
        ),
        (
            GAUGE,
            "tip_grade",
            {"producer_risk": 0.1, "multiple": 0},
            ValueError,
            "multiple = 0: must be positive",
        ),
    ],
)
def test_what_is_out_of_reach_is_named(
    inspection: ThicknessInspection,
    method: str,
    given: dict[str, Any],
    error: type[Exception],
    message: str,
) -> None:
    with pytest.raises(error, match=message):
        getattr(inspection, method)(**given)
