"""The planetary mechanism with oval wheels: parameters, kinds of motion, inverse."""

from __future__ import annotations

import dataclasses
import math
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mechproof import CylindricalPair, OvalPair, OvalPlanetary
from mechproof.kernels import oval_planetary as kernels

EPS = float(np.finfo(float).eps)
FIFTH = Fraction(1, 5)


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: OvalPair(1), ValueError, r"e = 1: must satisfy 0 <= e < 1"),
        (lambda: OvalPair("-0.1"), ValueError, r"e = '-0.1'"),
        (lambda: OvalPair("one fifth"), ValueError, r"e = 'one fifth': must be a finite number"),
        (lambda: OvalPair(math.nan), ValueError, r"e = nan: must be finite"),
        (lambda: OvalPair(Decimal("inf")), ValueError, r"e = Decimal\('Infinity'\): must be a"),
        (lambda: OvalPair(True), TypeError, r"e = True"),
        (lambda: OvalPair(0.2, [1.0]), TypeError, r"mount = \[1.0\]"),  # type: ignore[arg-type]
        (lambda: CylindricalPair(0, 20), ValueError, "R4 = 0: must satisfy 0 < R4 < oo"),
        (lambda: CylindricalPair(30, -1.0), ValueError, "R5 = -1.0: must satisfy 0 < R5 < oo"),
        (lambda: CylindricalPair(30, 2j), TypeError, r"R5 = 2j"),  # type: ignore[arg-type]
        (lambda: OvalPlanetary(OvalPair(0.2), 1.0), ValueError, r"e2 = 1.0: must satisfy 0 <= e2"),
        (lambda: OvalPlanetary(None, 0.2), TypeError, r"pair = None: must be an OvalPair"),  # type: ignore[arg-type]
        (lambda: OvalPlanetary.published(5), ValueError, r"variant = 5: must be 1 to 4"),
        (lambda: OvalPlanetary.published(1.0), TypeError, r"variant = 1.0"),  # type: ignore[arg-type]
        (lambda: OvalPlanetary.published(3).classify(-1), ValueError, r"eta = -1: must not be neg"),
    ],
)
def test_bad_parameters_are_named(make: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        make()


def test_exact_parameters_are_checked_exactly() -> None:
    """Both would round to doubles outside the domain, 1 and infinity."""
    nearly_one, large = 1 - Fraction(1, 10**30), 10**400
    assert OvalPair(nearly_one).e == nearly_one
    assert 2 * large == CylindricalPair(large, 2 * large).R5
    with pytest.raises(ValueError, match=r"e = Fraction\(10+1, 10+\): must satisfy 0 <= e < 1"):
        OvalPair(1 + Fraction(1, 10**30))


def test_published_variants_are_exact() -> None:
    assert OvalPlanetary.published(1) == OvalPlanetary(OvalPair("0.2"), Decimal("0.2"))
    assert OvalPlanetary.published(2) == OvalPlanetary(CylindricalPair(25, 25), FIFTH)
    assert OvalPlanetary.published(3) == OvalPlanetary(CylindricalPair(30, 20), FIFTH)
    assert OvalPlanetary.published(4) == OvalPlanetary(CylindricalPair(32, 18), FIFTH)
    with pytest.raises(dataclasses.FrozenInstanceError):
        OvalPlanetary.published(1).e2 = 0.3  # type: ignore[misc]


def test_methods_are_the_kernels() -> None:
    phi = np.linspace(-3, 3, 7)
    ovals, cylinders = OvalPlanetary(OvalPair(0.1, 0.4), "0.2"), OvalPlanetary.published(4)
    for name in ("ratio", "position", "acceleration"):
        expected = getattr(kernels, name)(phi, 0.1, 0.2, 0.4)
        assert np.array_equal(getattr(ovals, name)(phi), expected)
        expected = getattr(kernels, f"{name}_cylindrical")(phi, 32, 18, 0.2)
        assert np.array_equal(getattr(cylinders, name)(phi), expected)


# Kind, drift/pi, amplitude and dwell points of the four variants, by hand from the theorems.
PUBLISHED = {
    1: ("reciprocating", 0, math.asin(5 / 13), 2),
    2: ("reciprocating", 0, math.asin(0.2), 2),
    3: ("intermittent", -1, math.asin(0.2), 1),
    4: ("one-way", -14 / 9, math.asin(0.2), 0),
}


@pytest.mark.parametrize("variant", PUBLISHED)
def test_motion_of_the_published_variants(variant: int) -> None:
    mechanism = OvalPlanetary.published(variant)
    motion = mechanism.classify()
    kind, drift, amplitude, rests = PUBLISHED[variant]
    assert motion.kind == kind
    assert len(motion.rests) == rests
    # Half a dozen operations on numbers of order one.
    assert motion.drift == pytest.approx(drift * math.pi, abs=8 * EPS)
    assert motion.amplitude == pytest.approx(amplitude, rel=8 * EPS)
    for start, end in motion.rests:
        assert start == end
        # The angle is rounded to an eps, the ratio and its slope are of order one.
        assert abs(mechanism.ratio(start)) <= 20 * EPS


KINDS = {
    "equal ovals side by side": (OvalPlanetary(OvalPair(0.4, math.pi / 2), 0.4), 1e-12, "rest"),
    "circles": (OvalPlanetary(OvalPair(0), 0), None, "rest"),
    "equal cylinders": (OvalPlanetary(CylindricalPair(5, 5), 0), None, "rest"),
    "any other mount": (OvalPlanetary(OvalPair(0.4, 1.5), 0.4), 1e-3, "reciprocating"),
    "upper limit": (OvalPlanetary(CylindricalPair(3, 2), FIFTH), None, "intermittent"),
    "lower limit": (OvalPlanetary(CylindricalPair(2, 3), FIFTH), None, "intermittent"),
    "below the limit": (
        OvalPlanetary(CylindricalPair(3, 2), FIFTH + Fraction(1, 10**30)), None, "pilgrim-step",
    ),
    "beyond the limit": (
        OvalPlanetary(CylindricalPair(3, 2), FIFTH - Fraction(1, 10**30)), None, "one-way",
    ),
    "as floats, coarse": (OvalPlanetary(CylindricalPair(30, 20), 0.2), 1e-9, "intermittent"),
    "uniform": (OvalPlanetary(CylindricalPair(3, 2), 0), None, "one-way"),
    "drift within eta": (OvalPlanetary(CylindricalPair(1.0001, 1.0), 0.2), 0.01, "reciprocating"),
    "drift beyond eta": (OvalPlanetary(CylindricalPair(1.0001, 1.0), 0.2), 1e-6, "pilgrim-step"),
}  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_kinds_of_motion(name: str) -> None:
    mechanism, eta, kind = KINDS[name]
    assert mechanism.classify(eta).kind == kind


def test_floats_need_a_stated_limit() -> None:
    for mechanism in (
        OvalPlanetary(CylindricalPair(30, 20), 0.2),
        OvalPlanetary(OvalPair("0.2", 0.1), "0.2"),
    ):
        with pytest.raises(ValueError, match="eta = None: must be given"):
            mechanism.classify()


MECHANISMS = (
    *(OvalPlanetary.published(n) for n in PUBLISHED),
    OvalPlanetary(OvalPair(0.3, 0.7), 0.6),
    OvalPlanetary(OvalPair(0.8, -1.3), 0.9),
    OvalPlanetary(OvalPair(0.4, math.pi / 2), 0.4),
    OvalPlanetary(CylindricalPair(20, 30), "0.2"),
    OvalPlanetary(CylindricalPair(20, 30), "0.3"),
)


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
@pytest.mark.parametrize("eta", [1e-9, 0.01, 0.4, 30.0])
def test_figures_of_the_motion_against_samples(mechanism: OvalPlanetary, eta: float) -> None:
    motion = mechanism.classify(eta)
    phi = np.linspace(0, motion.period, 40001)
    ratio, deviation = mechanism.ratio(phi), mechanism.position(phi) - motion.drift * phi / math.tau
    # 1e-6: a parabola of curvature below 1e4 missed by half a step of 1e-4.
    assert ratio.min() == pytest.approx(motion.minimum, abs=1e-6 * (1 + abs(motion.minimum)))
    assert ratio.max() == pytest.approx(motion.maximum, abs=1e-6)
    assert np.ptp(deviation) / 2 == pytest.approx(motion.amplitude, abs=1e-6)
    assert deviation[-1] == pytest.approx(deviation[0], abs=1e-12)
    at_rest = np.zeros(phi.size, bool)
    for start, end in motion.rests:
        shift = np.mod(phi - start, motion.period)
        at_rest |= shift <= end - start
    differs = at_rest != (np.abs(ratio) <= eta)
    # Only within rounding of an end of an interval.
    assert np.all(np.abs(np.abs(ratio[differs]) - eta) <= 1e-9)


def test_rests_at_the_very_extremes() -> None:
    random = np.random.default_rng(11)
    for _ in range(300):
        r4, r5 = random.uniform(1, 3, 2)
        mechanism = OvalPlanetary(CylindricalPair(r4, r5), random.uniform(0, 1))
        motion = mechanism.classify(0.0)
        for extreme in (abs(motion.minimum), abs(motion.maximum)):
            for eta in (math.nextafter(extreme, 0), extreme, math.nextafter(extreme, 9e9)):
                rests = mechanism.classify(eta).rests
                assert all(end >= start for start, end in rests)


def test_width_of_the_dwell() -> None:
    ((start, end),) = OvalPlanetary.published(3).classify("0.01").rests
    tangent = math.sqrt(0.01 * 1.2**2 / (4 * 0.2 - 0.01 * 0.8**2))
    assert end - start == pytest.approx(2 * math.atan(tangent) / 1.5, rel=8 * EPS)


INVERTIBLE = {
    "intermittent": OvalPlanetary.published(3),
    "one-way": OvalPlanetary.published(4),
    "intermittent at zero": OvalPlanetary(CylindricalPair(20, 30), FIFTH),
    "with the carrier": OvalPlanetary(CylindricalPair(20, 30), 0.1),
    "uniform": OvalPlanetary(CylindricalPair(20, 30), 0),
    "steep": OvalPlanetary(CylindricalPair(1, 3000), 0.99),
}


@pytest.mark.parametrize("name", INVERTIBLE)
def test_round_trips(name: str) -> None:
    mechanism = INVERTIBLE[name]
    random = np.random.default_rng(7)
    targets = np.array([1e-300, 1e-20, 1e-8, 0.3, *random.uniform(-30, 30, 200), 1e5])
    found = mechanism.carrier_angle(targets)
    pair: Any = mechanism.pair
    k = float(pair.R4 / pair.R5)
    # Twice the bound of the position, 12 eps of its terms and of |phi1|*(k + 1 - ratio), and the
    # last bracket of 4 eps.
    ratio = np.abs(mechanism.ratio(found))
    scale = np.abs(targets) + np.abs(found) * (2 * abs(1 - k) + k + np.abs(1 - ratio))
    assert np.all(np.abs(mechanism.position(found) - targets) <= 24 * EPS * scale + 1e-323)


def test_inverse_of_special_values_shapes_and_types() -> None:
    mechanism = OvalPlanetary.published(4)
    special = mechanism.carrier_angle([np.nan, np.inf, -np.inf, 0.0])
    assert np.isnan(special[:3]).all()
    assert special[3] == 0
    assert mechanism.carrier_angle(np.ones((2, 0, 3))).shape == (2, 0, 3)
    assert isinstance(mechanism.carrier_angle(1.0), np.float64)
    assert isinstance(mechanism.carrier_angle(np.float32(1.0)), np.float32)
    # Variant 4 turns against the carrier.
    assert mechanism.carrier_angle(1.0) < 0


@pytest.mark.parametrize(
    "mechanism",
    [
        OvalPlanetary.published(1),
        OvalPlanetary.published(2),
        OvalPlanetary(OvalPair(0.4, math.pi / 2), 0.4),
        OvalPlanetary(CylindricalPair(5, 5), 0),
        # The double 0.2 is above one fifth: the ratio gets positive by 2e-17.
        OvalPlanetary(CylindricalPair(30, 20), 0.2),
    ],
    ids=repr,
)
def test_what_cannot_be_inverted_says_so(mechanism: OvalPlanetary) -> None:
    with pytest.raises(ValueError, match="does not determine the carrier angle"):
        mechanism.carrier_angle(1.0)


def test_inverse_that_fails_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(OvalPlanetary, "position", lambda self, phi1: np.abs(phi1) + 1e6)
    with pytest.raises(ArithmeticError, match=r"no carrier angle found for phi3 = array\(\[?2"):
        OvalPlanetary.published(4).carrier_angle(2.0)


def test_numpy_integers_are_exact() -> None:
    sizes = CylindricalPair(np.int64(30), np.int64(20))
    assert OvalPlanetary(sizes, "0.2").classify().kind == "intermittent"
