"""Degrees and pint quantities: results come back in the units of the arguments."""

from __future__ import annotations

import copy
import math
import pickle
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from units import REGISTRY

from mechproof import (
    CylindricalPair,
    EllipticPlanetary,
    OvalPair,
    OvalPlanetary,
    ToothThickness,
    TrackWheel,
    WedgeLinkage,
)
from mechproof.kernels import elliptic_planetary as kernels

EPS = np.finfo(float).eps
ELLIPTIC = EllipticPlanetary.published(2)
OVAL = OvalPlanetary(CylindricalPair(1, 3), "0.1")
MECHANISMS = (ELLIPTIC, OVAL)
TURNS = np.array([-720.0, 0.0, 30.0, 90.0, 1234.5])


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
def test_degrees_are_radians_times_a_factor(mechanism: Any) -> None:
    radians = np.radians(TURNS)
    position = mechanism.position(TURNS, degrees=True)
    assert position == pytest.approx(np.degrees(mechanism.position(radians)), rel=2 * EPS)
    assert np.array_equal(mechanism.ratio(TURNS, degrees=True), mechanism.ratio(radians))
    per_degree = mechanism.acceleration(TURNS, degrees=True)
    assert per_degree == pytest.approx(np.radians(mechanism.acceleration(radians)), rel=2 * EPS)
    assert mechanism.carrier_angle(position, degrees=True) == pytest.approx(TURNS, rel=1e-13)


def test_a_ratio_by_degrees_is_the_slope_of_the_position_in_degrees() -> None:
    """Derivatives by the angle are per degree, as differences show to second order."""
    step = 1e-4
    rise = np.diff(ELLIPTIC.ratio([30.0, 30.0 + step], degrees=True))[0] / step
    assert rise == pytest.approx(ELLIPTIC.acceleration(30.0, degrees=True), rel=1e-4)


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
def test_extremes_occur_at_degrees(mechanism: Any) -> None:
    plain, found = mechanism.extremes(), mechanism.extremes(degrees=True)
    assert type(found) is type(plain)
    assert (found.maximum, found.minimum) == (plain.maximum, plain.minimum)
    assert found.period == math.degrees(plain.period)
    assert mechanism.ratio(found.at_minimum, degrees=True) == pytest.approx(found.minimum)


def test_motions_are_in_degrees() -> None:
    mechanism = OvalPlanetary(CylindricalPair(30, 20), "0.2")
    plain, found = (mechanism.classify("0.01", degrees=d) for d in (False, True))
    assert found.kind == plain.kind
    assert found.rests == tuple((math.degrees(a), math.degrees(b)) for a, b in plain.rests)
    assert (found.period, found.drift) == (math.degrees(plain.period), math.degrees(plain.drift))


def test_motions_in_time_are_in_degrees_and_per_second() -> None:
    carrier = (30.0, 720.0, -90.0, 50.0)
    plain, found = ELLIPTIC.at(*np.radians(carrier)), ELLIPTIC.at(*carrier, degrees=True)
    assert tuple(found) == pytest.approx(tuple(np.degrees(plain)), rel=1e-13)
    assert found.speed_rpm == pytest.approx(plain.speed_rpm, rel=1e-13)
    by_rpm = ELLIPTIC.at(30.0, None, *carrier[2:], speed_rpm=120, degrees=True)
    assert tuple(by_rpm) == pytest.approx(tuple(found), rel=1e-13)
    times = np.linspace(0, 1, 9)
    for phi1 in (lambda t: 90 * t**2, 90 * times**2):
        found = ELLIPTIC.run(times, phi1, degrees=True)
        radians = (lambda t, f=phi1: np.radians(f(t))) if callable(phi1) else np.radians(phi1)
        assert np.array(found) == pytest.approx(np.degrees(ELLIPTIC.run(times, radians)), rel=1e-9)


def test_dwells_are_in_degrees() -> None:
    radians, degrees = (
        OvalPlanetary.find_dwells(width, band=band, teeth=(18, 21), degrees=d)
        for width, band, d in ((math.radians(20), math.radians(0.1), False), (20, 0.1, True))
    )
    assert str(radians) == str(degrees)
    assert str(radians.candidates[0]) == str(degrees.candidates[0])
    for name in ("width", "step"):
        plain, found = ([getattr(row, name) for row in d.candidates] for d in (radians, degrees))
        assert found == pytest.approx(np.degrees(plain))
    drive = OvalPlanetary.of_dwell(degrees.candidates[0])
    assert drive == OvalPlanetary.of_dwell(radians.candidates[0])
    interval = drive.longest_dwell(band=math.radians(0.1))
    assert drive.longest_dwell(band=0.1, degrees=True) == pytest.approx(np.degrees(interval))


def test_motions_and_dwells_in_quantities() -> None:
    q = REGISTRY.Quantity
    found = ELLIPTIC.at(q(30, "degree"), q(120, "rpm"), q(1, "turn/s**2"))
    plain = ELLIPTIC.at(30, 720, 360, degrees=True)
    assert [str(value.units) for value in found[:3]] == [
        "degree",
        "degree / second",
        "degree / second ** 2",
    ]
    assert tuple(value.magnitude for value in found) == pytest.approx(tuple(plain), rel=1e-12)
    assert found.speed_rpm.to("rpm").magnitude == pytest.approx(plain.speed_rpm)
    times = np.linspace(0, 1, 9)
    moved = ELLIPTIC.run(q(1e3 * times, "ms"), q(times**2 / 4, "turn"))
    again = ELLIPTIC.run(times, 90 * times**2, degrees=True)
    assert moved.speed.to("degree/s").magnitude == pytest.approx(again.speed)
    drive = OvalPlanetary(CylindricalPair(30, 20), "0.2")
    ends = drive.longest_dwell(band=q(0.1, "degree"))
    plain_ends = drive.longest_dwell(band=0.1, degrees=True)
    assert [end.to("degree").magnitude for end in ends] == pytest.approx(plain_ends)


def test_parameters_in_degrees() -> None:
    assert ToothThickness(3, 50, 20, degrees=True).alpha == math.radians(20)
    assert ToothThickness(3, 50, degrees=True) == ToothThickness(3, 50)
    wheel = TrackWheel(41.5, 3.75, 6, 20, angles=(1, 2, 3), degrees=True)
    assert wheel.angles == pytest.approx(np.radians([1, 2, 3]), rel=EPS)
    sizes = vars(WedgeLinkage.published(1))
    degrees = {n: math.degrees(v) if n.startswith("alpha") else v for n, v in sizes.items()}
    assert vars(WedgeLinkage(**degrees, degrees=True)) == pytest.approx(sizes, rel=2 * EPS)
    assert OvalPair("0.3", "90", degrees=True).mount == math.pi / 2
    assert OvalPair("0.3", degrees=True).mount == Fraction(0)


def test_a_mechanism_made_in_degrees_keeps_radians() -> None:
    wheel = TrackWheel(41.5, 3.75, 6, 20, angles=(1, 2, 3), degrees=True)
    assert "degrees" not in repr(wheel)
    assert pickle.loads(pickle.dumps(wheel)) == copy.copy(wheel) == wheel


def test_the_kind_of_numbers_is_kept() -> None:
    single = np.array([30, 60], np.float32)
    assert ELLIPTIC.position(single, degrees=True).dtype == np.float32
    whole = ELLIPTIC.position(np.array([30, 60], np.int8), degrees=True)
    assert whole.dtype == np.float64
    assert np.array_equal(whole, ELLIPTIC.position([30.0, 60.0], degrees=True))
    masked = np.ma.masked_array([30.0, 60.0], mask=[True, False])
    assert ELLIPTIC.position(masked, degrees=True).mask.tolist() == [True, False]
    assert isinstance(ELLIPTIC.position(30, degrees=True), np.float64)


def test_quantities_are_given_back_in_their_units() -> None:
    q = REGISTRY.Quantity
    mechanism = EllipticPlanetary(q(6.6, "cm"), q(16, "mm"), q(47.5, "percent"))
    assert vars(mechanism) == pytest.approx(vars(ELLIPTIC))
    for unit in ("degree", "radian", "turn"):
        angle = q(np.array([0.1, 0.2]), unit)
        wanted = kernels.position(angle.to("radian").magnitude, 66, 16, 0.475)
        found = ELLIPTIC.position(angle)
        assert found.units == angle.units
        assert found.to("radian").magnitude == pytest.approx(wanted, rel=4 * EPS)
        assert ELLIPTIC.carrier_angle(found).to(unit).magnitude == pytest.approx([0.1, 0.2])
    assert ELLIPTIC.ratio(q(90, "degree")).units == REGISTRY.dimensionless
    slope = ELLIPTIC.acceleration(q(90, "degree"))
    assert str(slope.units) == "1 / degree"
    assert slope.magnitude == pytest.approx(ELLIPTIC.acceleration(90, degrees=True))


def test_lengths_are_given_back_as_lengths() -> None:
    q = REGISTRY.Quantity
    wheel = TrackWheel(q(41.5, "mm"), q(0.375, "cm"), 6, q(20, "mm"), angles=q([1, 2, 3], "mrad"))
    plain = TrackWheel(41.5, 3.75, 6, 20, angles=(1e-3, 2e-3, 3e-3))
    for name in ("radius", "track", "displacement", "planar_error", "spatial_error"):
        found = getattr(wheel, name)(q(30.0, "degree"))
        assert found.units == REGISTRY.mm
        assert found.magnitude == pytest.approx(getattr(plain, name)(math.pi / 6), rel=1e-12)
    wedge = WedgeLinkage.published(1)
    moved = q(-3.71, "cm")
    assert wedge.position(moved).to("mm").magnitude == pytest.approx(wedge.position(-37.1))
    assert wedge.sensitivities(moved)["alpha_KL"].units == REGISTRY.mm / REGISTRY.radian
    tooth = ToothThickness(q(3, "mm"), 50, q(20, "degree"))
    assert tooth.thickness_change(q(10, "um")).to("mm").magnitude == pytest.approx(
        tooth.thickness_change(0.01)
    )


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda q: EllipticPlanetary(q(66, "degree"), 16, 0.4), r"^R1 = .*must be a length \(mm\)"),
        (lambda q: EllipticPlanetary(66, 16, q(0.4, "mm")), "^e = .*must be a pure number"),
        (lambda q: ELLIPTIC.position(q(1, "mm")), r"^phi1 = .*must be an angle \(rad\)"),
        (lambda q: WedgeLinkage.published(1).position(q(1, "s")), "^x1 = .*must be a length"),
        (lambda q: ELLIPTIC.at(1.0, q(1, "mm/s")), "^speed = .*must be an angular speed"),
        (lambda q: ELLIPTIC.run(q([0, 1], "mm"), [0, 1]), "^t = .*must be a time"),
        (lambda q: OVAL.find_dwells(q(1, "mm"), eta=0.1), "^width = .*must be an angle"),
    ],
)
def test_another_dimension_is_refused(call: Any, message: str) -> None:
    with pytest.raises(TypeError, match=message):
        call(REGISTRY.Quantity)


def test_two_ways_to_say_the_unit_are_refused() -> None:
    with pytest.raises(ValueError, match=r"^phi1 = .*leave out degrees"):
        ELLIPTIC.position(REGISTRY.Quantity(1, "degree"), degrees=True)


def test_kernels_take_no_quantities() -> None:
    with pytest.raises(TypeError, match=r"^phi1.*unit"):
        kernels.position(REGISTRY.Quantity(1.0, "radian"), 66, 16, 0.475)
