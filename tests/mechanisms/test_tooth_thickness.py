"""The wheel, its exact change of thickness, and its inspection: exact and simulated shares."""

from __future__ import annotations

import dataclasses
import math
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from mechproof import ThicknessInspection, ToothThickness
from mechproof.conformity import Shares, shares
from mechproof.laws import Law, Normal, TruncatedNormal, Uniform
from mechproof.laws.kinds import move
from mechproof.mechanisms.tooth_thickness_errors import exact_shares, scale_law
from mechproof.mechanisms.tooth_thickness_inspection import IT_120_TO_180

EPS = float(np.finfo(float).eps)
WHEEL = ToothThickness.published()
TOOTH = Normal.from_width(-0.0345, 0.045, 6)
FOUR = ("rightly_accepted", "wrongly_accepted", "rightly_rejected", "wrongly_rejected")


def tip_of(grade: int) -> Normal:
    return Normal.from_width(0.0, IT_120_TO_180[grade], 6)


def inspect(grade: int = 6, gauge: Law | None = None, **changes: Any) -> ThicknessInspection:
    law = Normal.from_width(0.0, 0.004, 4) if gauge is None else gauge
    inspection = ThicknessInspection.published(
        true=TOOTH, tip_diameter=tip_of(grade), height=law, thickness=law
    )
    return dataclasses.replace(inspection, **changes)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((0.0, 50), ValueError, "m = 0.0: must satisfy 0 < m < oo"),
        ((math.nan, 50), ValueError, "m = nan: must be finite"),
        (("3", 50), TypeError, "m = '3': must be a real number"),
        ((3.0, 3), ValueError, "z = 3: must be at least 4"),
        ((3.0, 50.0), TypeError, "z = 50.0: must be an integer"),
        ((3.0, 50, 0.0), ValueError, "alpha = 0.0: must satisfy 0 < alpha < pi/4"),
        ((3.0, 50, 20.0), ValueError, "alpha = 20.0: must satisfy"),
    ],
)
def test_bad_parameters_are_named(
    arguments: tuple[Any, ...], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        ToothThickness(*arguments)


def test_published_wheel_has_the_printed_chord_and_height() -> None:
    assert (WHEEL.m, WHEEL.z, WHEEL.alpha) == (3.0, 50, math.pi / 9)
    # Half a unit of the last printed place.
    assert abs(WHEEL.constant_chord - 4.161) < 5e-4
    assert abs(WHEEL.chord_height - 2.243) < 5e-4


def exact_change(wheel: ToothThickness, dh: float) -> tuple[Any, Any]:
    """Return the change of thickness and its error scale, from the polar involute."""
    m, z, alpha = mp.mpf(wheel.m), wheel.z, mp.mpf(wheel.alpha)
    base, start = m * z * mp.cos(alpha) / 2, mp.pi / (2 * z) + mp.tan(alpha) - alpha
    nominal = m * (mp.mpf(z) / 2 + mp.pi * mp.sin(2 * alpha) / 8)

    def angle(roll: Any) -> Any:
        return start - roll + mp.atan(roll)

    def distance(roll: Any) -> Any:
        return base * mp.sqrt(1 + roll**2) * mp.cos(angle(roll))

    first = alpha + start
    roll = mp.findroot(
        lambda t: distance(t) - (nominal - dh), first - dh / (base * first), tol=1e-90
    )
    tilt = roll - first
    change = (
        2 * base * mp.sqrt(1 + roll**2) * mp.sin(angle(roll)) - mp.pi * m * mp.cos(alpha) ** 2 / 2
    )
    return change, base * abs(tilt) * (1 + first + abs(tilt))


@pytest.mark.parametrize(
    "wheel", [WHEEL, ToothThickness(1.0, 5, 0.3), ToothThickness(2, 1000, 0.5)]
)
def test_exact_change_of_thickness(wheel: ToothThickness) -> None:
    top, bottom = -float(wheel.chord_height), float(wheel.deepest)
    parts = (0.3, 0.03, 1e-4, 1e-8, 1e-20)
    depths = [0.5 * top, 0.9 * bottom, *(p * bottom for p in parts), *(p * top for p in parts)]
    with mp.workdps(60):
        for dh, got in zip(depths, wheel.thickness_change(depths), strict=True):
            change, scale = exact_change(wheel, dh)
            assert abs(change - float(got)) <= 61 * EPS * scale


def test_where_there_is_no_involute_the_change_is_nan() -> None:
    top, bottom = -float(WHEEL.chord_height), float(WHEEL.deepest)
    outside = [top * (1 + 1e-9), bottom * (1 + 1e-9), math.inf, -math.inf, math.nan]
    assert np.isnan(WHEEL.thickness_change(outside)).all()
    assert np.isfinite(WHEEL.thickness_change([top, bottom, 0.0])).all()
    # A pointed tooth ends below its tip circle.
    pointed = ToothThickness(1.0, 8, math.radians(35))
    assert np.isnan(pointed.thickness_change(-float(pointed.chord_height)))
    assert np.isnan(WHEEL.linearisation_bound([2 * bottom, math.nan])).all()


def test_shapes_and_types() -> None:
    assert isinstance(WHEEL.thickness_change(0.01), np.float64)
    assert WHEEL.thickness_change(np.zeros((2, 3))).shape == (2, 3)
    assert WHEEL.thickness_change(np.float32(0.01)).dtype == np.float32
    with pytest.raises(TypeError, match="dh"):
        WHEEL.thickness_change(1j)


def test_linear_model_exceeds_the_exact_change_by_less_than_its_bound() -> None:
    dh = np.array([-2.0, -0.5, -0.063, -0.01, 0.01, 0.063, 0.5, 2.0])
    excess = WHEEL.thickness_change_linear(dh) - WHEEL.thickness_change(dh)
    assert (excess > 0).all()
    assert (excess < WHEEL.linearisation_bound(dh)).all()


def test_larger_tip_makes_the_measured_tooth_thinner() -> None:
    # The gauge stands e/2 higher: the line it measures lies e/2 nearer the tip.
    exact = WHEEL.thickness_change(-0.025 / 2)
    linear = WHEEL.thickness_error(0.025, 0.0)
    assert exact < linear < 0
    assert linear - exact < WHEEL.linearisation_bound(0.025 / 2)


# The inspection -------------------------------------------------------------------------------


def test_influences_by_geometry_and_as_printed() -> None:
    tangent = math.tan(math.pi / 9)
    assert inspect().influences == pytest.approx((-tangent, 2 * tangent), rel=8 * EPS)
    assert inspect(steps_as_printed=True).influences == (0.7284, 0.7284)


@pytest.mark.parametrize("printed", [False, True])
def test_normal_errors_add_up_in_closed_form(printed: bool) -> None:
    inspection = inspect(8, steps_as_printed=printed)
    tip, height = inspection.influences
    spread = math.hypot(tip * 0.063 / 6, height * 0.001, 0.001)
    expected = shares(TOOTH, Normal(0.0, spread), (-0.057, -0.012))
    for name in FOUR:
        # The condition of a share on the spread is below 10.
        assert getattr(inspection.shares(), name) == pytest.approx(
            getattr(expected, name), rel=1e-12
        )


def test_tip_diameter_by_the_geometry_disturbs_half_as_much() -> None:
    nothing = Normal(0.0, 0.0)
    right = [inspect(grade, nothing).producer_risk() for grade in (6, 7, 8)]
    printed = [inspect(g, nothing, steps_as_printed=True).producer_risk() for g in (6, 7, 8)]
    assert right[0] < right[1] < right[2] < printed[1] < printed[2]
    # The proved row "(e), what remains".
    assert 0.001 < right[0] < 0.002
    assert 0.003 < printed[0] < 0.004


def test_wrong_sign_shows_only_with_a_bias() -> None:
    laws = [inspect(tip_diameter=Normal(bias, 0.004)) for bias in (0.01, -0.01, 0.0)]
    plus, minus, none = (inspection.shares().rightly_accepted for inspection in laws)
    # Centred on the field, only the size of the bias counts.
    assert plus == pytest.approx(minus, rel=1e-12)
    assert plus < none
    shifted = dataclasses.replace(inspect(), true=Normal(-0.03, 0.0075))
    up, down = (
        dataclasses.replace(shifted, tip_diameter=Normal(bias, 0.004)).shares().rightly_accepted
        for bias in (0.01, -0.01)
    )
    # The measured tooth becomes thinner, back into the field.
    assert up > down


CASES: dict[str, tuple[Law, Law, Law]] = {
    "normal": (tip_of(7), Normal(0.0, 0.002), Normal(0.001, 0.002)),
    "normal and uniform": (tip_of(7), Uniform(-0.01, 0.01), Uniform(-0.012, 0.01)),
    "uniform": (Uniform(-0.02, 0.02), Uniform(-0.01, 0.01), Uniform(-0.01, 0.012)),
    "truncated": (
        TruncatedNormal(0.0, 0.01, -0.02, 0.02), Normal(0.0, 0.0), Normal(0.0, 0.003)),
}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "printed"), [*((name, False) for name in CASES), ("normal", True)]
)
def test_simulation_agrees_with_the_exact_shares(name: str, printed: bool) -> None:
    tip, height, thickness = CASES[name]
    inspection = inspect(
        tip_diameter=tip, height=height, thickness=thickness, steps_as_printed=printed
    )
    exact = inspection.shares()
    count = 200_000
    simulated = inspection.simulate(rng=np.random.default_rng(33), count=count, chunk=50_000)
    for share in FOUR:
        p = getattr(exact, share)
        # 5 standard errors of the exact share and one part; 20 comparisons, false alarm 1e-4
        # (Bernstein's tail of the binomial with some 200 parts expected at least).
        allowed = 5 * math.sqrt(p * (1 - p) / count) + 1 / count
        assert abs(getattr(simulated, share) - p) < allowed
    assert sum(getattr(exact, share) for share in FOUR) == pytest.approx(1, abs=4e-8)


def test_sum_of_laws_against_nested_quadrature() -> None:
    """Two uniform errors with one normal: the average over both, by Gauss panels."""
    errors = Normal(0.001, 0.003), Uniform(-0.01, 0.01), Uniform(-0.006, 0.002)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    shift = 0.001 + 0.01 * nodes[:, None] + (-0.002 + 0.004 * nodes[None])
    weight = np.outer(weights, weights) / 4
    each = shares(TOOTH, Normal(shift, 0.003), (-0.057, -0.012))
    got = exact_shares(TOOTH, errors, (-0.057, -0.012))
    for share in FOUR:
        # 60 nodes over 20/3 standard deviations are exact to rounding.
        assert abs(getattr(got, share) - np.sum(weight * getattr(each, share))) < 1e-8


def test_one_error_of_any_law_stays_whole() -> None:
    law = Uniform(-0.01, 0.02)
    got = exact_shares(TOOTH, [law, Normal(0.003, 0.0)], (-0.057, -0.012))
    expected = shares(TOOTH, Uniform(-0.007, 0.023), (-0.057, -0.012))
    for share in FOUR:
        assert getattr(got, share) == pytest.approx(getattr(expected, share), rel=1e-11)


def test_errors_far_from_zero_keep_the_absolute_bound() -> None:
    # A million widths away, where places lose digits to rounding.
    half, far = 2.0**-10, 2.0**10
    others = [Uniform(-2 * half, half), Normal(0.0, half)]
    found = exact_shares(
        TOOTH, [Uniform(far - half, far + half), *others], (-0.057, -0.012), (far - 0.05, far)
    )
    expected = exact_shares(
        TOOTH, [Uniform(-half, half), *others], (-0.057, -0.012), (far - 0.05 - far, 0.0)
    )
    for share in FOUR:
        assert getattr(found, share) == pytest.approx(getattr(expected, share), rel=0, abs=2e-8)


def test_parameters_broadcast_and_nan_passes() -> None:
    limit = np.array([0.0, 0.002, 0.01, np.nan])
    gauge = Normal.from_width(0.0, 2 * limit, 4)
    tips = Normal(0.0, np.array([[0.025], [0.04]]) / 6)
    both = inspect(gauge=gauge, tip_diameter=tips).shares()
    assert both.wrongly_rejected.shape == (2, 4)
    assert np.isnan(both.wrongly_rejected[:, 3]).all()
    # Figs. 4 and 5: rising with the limit error, IT7 above IT6.
    assert (np.diff(both.wrongly_rejected[:, :3], axis=1) > 0).all()
    assert (np.diff(both.rightly_accepted[:, :3], axis=1) < 0).all()
    assert (np.diff(both.wrongly_rejected[:, :3], axis=0) > 0).all()
    uneven = inspect(gauge=Uniform(-0.002, 0.002), tip_diameter=tips).shares()
    assert uneven.wrongly_rejected.shape == (2, 1)


def test_guard_band_trades_the_risks() -> None:
    inspection = inspect(7)
    guarded = (-0.055, -0.014)
    assert inspection.consumer_risk(guarded) < inspection.consumer_risk()
    assert inspection.producer_risk(guarded) > inspection.producer_risk()


def test_conformance_probability_of_a_measured_tooth() -> None:
    inspection = inspect()
    inside, outside = inspection.conformance_probability([-0.0345, -0.012, 0.01])
    assert (np.diff(inside) < 0).all()
    np.testing.assert_allclose(inside + outside, 1, rtol=4 * EPS)
    uniform = dataclasses.replace(inspection, height=Uniform(-0.002, 0.002))
    with pytest.raises(TypeError, match=r"height = Uniform.*must be Normal"):
        uniform.conformance_probability(-0.02)


def test_reversed_limits_are_named() -> None:
    with pytest.raises(ValueError, match=r"tolerance \(lower, upper\).*must be below"):
        inspect(tolerance=(0.0, -0.045))


@pytest.mark.parametrize(
    "law",
    [Normal(0.1, 0.2), Uniform(-0.1, 0.3), TruncatedNormal(0.1, 0.2, -0.3, 0.2)],
    ids=["normal", "uniform", "truncated"],
)
@pytest.mark.parametrize("factor", [2.0, -0.5])
def test_scaled_and_shifted_laws(law: Law, factor: float) -> None:
    moved = move(scale_law(law, factor), 0.7)
    low, high = sorted((factor * -0.05 + 0.7, factor * 0.15 + 0.7))
    # Some roundings of the limits against a density of a few units.
    assert moved.probability(low, high) == pytest.approx(law.probability(-0.05, 0.15), rel=1e-13)


def test_a_quadrature_that_does_not_converge_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    def give_up(*arguments: Any, **options: Any) -> Any:
        return SimpleNamespace(status="not_converged")

    monkeypatch.setattr("scipy.integrate.cubature", give_up)
    with pytest.raises(ArithmeticError, match="did not converge"):
        inspect(gauge=Uniform(-0.01, 0.01)).shares()


def test_a_search_that_finds_no_bracket_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    kernels = "mechproof.mechanisms.tooth_thickness.kernels"
    monkeypatch.setattr(f"{kernels}.height_change", lambda tilt, *sizes: -np.abs(tilt) - 7)
    monkeypatch.setattr(ToothThickness, "deepest", 1.0)
    with pytest.raises(ArithmeticError, match=r"no chord found for dh = .*0\.05"):
        WHEEL.thickness_change(0.05)


def test_the_four_shares_are_the_record_of_conformity() -> None:
    assert type(inspect().shares()) is Shares


@pytest.mark.parametrize("depth", [1e-160, 1e-300, 5e-324])
def test_the_smallest_depths_converge(depth: float) -> None:
    gear = ToothThickness.published()
    change = gear.thickness_change(depth)
    assert change == pytest.approx(2 * math.tan(gear.alpha) * depth, rel=1e-12, abs=5e-324)
