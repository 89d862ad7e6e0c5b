"""The curves of the papers' figures agree with the kernels, and each claim with its curve."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn import drawn, lines, load_wedge, pictures, span_of

from mechproof import EllipticPlanetary, OvalPlanetary, TrackWheel, WedgeLinkage
from mechproof.kernels import elliptic_planetary, track_wheel, wedge_linkage
from mechproof.kernels.forms.elliptic_planetary import position_printed
from mechproof.tolerance import certified_range, corner_range

# Degrees and per cent are one multiplication away: a few units in the last place.
CLOSE = {"rtol": 1e-14, "atol": 1e-12}


@pytest.mark.parametrize(("panel", "pair"), [(0, (1, 2)), (1, (3, 4))])
def test_position_functions_of_paper_1(panel: int, pair: tuple[int, int]) -> None:
    axes = drawn("elliptic_planetary", "fig-3").axes[panel]
    for number in pair:
        sizes = elliptic_planetary.PUBLISHED[number - 1].sizes
        ((degrees, shown),) = [d.T for d in lines(axes, f"variant {number}")]
        right = np.degrees(elliptic_planetary.position(np.radians(degrees), **sizes))
        np.testing.assert_allclose(shown, right, **CLOSE)


@pytest.mark.parametrize(("panel", "pair"), [(0, (1, 2)), (1, (3, 4))])
def test_what_12_prints_is_drawn_and_cut_where_it_falls_back(
    panel: int, pair: tuple[int, int]
) -> None:
    axes, red = drawn("elliptic_planetary", "fig-3").axes[panel], "#c2301c"
    curves = [
        c.get_xydata().T for c in axes.lines if c.get_color() == red and len(c.get_xdata()) > 9
    ]
    assert len(curves) == len(pair)
    for number, (degrees, shown) in zip(pair, curves, strict=True):
        sizes = elliptic_planetary.PUBLISHED[number - 1].sizes
        printed = np.degrees(position_printed(np.radians(degrees), **sizes))
        known = ~np.isnan(shown)
        np.testing.assert_allclose(shown[known], printed[known], **CLOSE)
        assert not np.any(np.diff(shown) < 0)
        turns = 180 * sizes["R1"] / sizes["R2"] / 360
        assert (~known).sum() == math.floor(turns + 0.5)


@pytest.mark.parametrize("number", [1, 2, 3, 4])
def test_the_marked_lack_of_12_is_that_of_the_theorem(number: int) -> None:
    module, sizes = pictures("elliptic_planetary"), elliptic_planetary.PUBLISHED[number - 1].sizes
    e = sizes["e"]
    right = 180 * (1 - math.sqrt((1 - e) / (1 + e)))
    # A step of the carrier before the end: the square root of an eps is far below the digits shown.
    assert module.lack_at_branch_end(number) == pytest.approx(right, abs=1e-6)
    end = np.radians(module.branch_end(number))
    inside = np.linspace(0, end * (1 - 1e-9), 500)
    lack = elliptic_planetary.position(inside, **sizes) - position_printed(inside, **sizes)
    assert np.all(np.degrees(lack) <= right * (1 + 1e-12))


@pytest.mark.parametrize(("row", "pair"), [(0, (1, 2)), (2, (3, 4))])
def test_rates_of_paper_1(row: int, pair: tuple[int, int]) -> None:
    ratio, acceleration = drawn("elliptic_planetary", "fig-3-rates").axes[row : row + 2]
    for place, number in enumerate(pair):
        mechanism = EllipticPlanetary.published(number)
        for panel, rule in ((ratio, mechanism.ratio), (acceleration, mechanism.acceleration)):
            degrees, shown = panel.lines[place].get_data()
            np.testing.assert_allclose(shown, rule(np.radians(degrees)), rtol=1e-12, atol=1e-12)
        curve, marks = (ratio.lines[place + first].get_ydata() for first in (0, len(pair)))
        assert len(marks) == 2
        # The nearest sample misses an extreme by the square of half a step.
        np.testing.assert_allclose(marks, [curve.min(), curve.max()], rtol=1e-3)
        assert marks[0] <= curve.min() * (1 + 1e-15)
        assert marks[1] >= curve.max() * (1 - 1e-15)


def test_positions_and_rests_of_paper_2() -> None:
    swing, turn, rest = drawn("oval_planetary", "fig-2").axes
    for panel, pair in ((swing, (1, 2)), (turn, (3, 4))):
        for number in pair:
            mechanism = OvalPlanetary.published(number)
            angle, shown = lines(panel, f"variant {number}, ")[0].T
            np.testing.assert_array_equal(shown, mechanism.position(angle))
            motion = mechanism.classify()
            without_drift = shown - motion.drift * angle / (2 * np.pi)
            # Within one of the 1440 steps the swing changes by less than 1e-5 of itself.
            assert np.abs(without_drift).max() == pytest.approx(motion.amplitude, rel=1e-4)
    angle, shown = max((line.get_data() for line in rest.lines), key=lambda data: len(data[0]))
    ratio = OvalPlanetary.published(3).ratio(np.radians(angle))
    np.testing.assert_allclose(shown, ratio, atol=1e-14)
    assert shown.max() <= 0


def test_the_grey_of_paper_2_is_where_the_ratio_is_within_eta() -> None:
    module = pictures("oval_planetary")
    found = module.CLASSIFIED[3]
    ((start, end),) = found.rests
    ratio = OvalPlanetary.published(3).ratio([start, end, (start + end) / 2])
    np.testing.assert_allclose(np.abs(ratio), [0.01, 0.01, 0.0], atol=1e-12)
    bands = np.array(sorted(map(span_of, drawn("oval_planetary", "fig-2").axes[1].patches)))
    turns = found.period * np.arange(3)
    np.testing.assert_allclose(bands, np.stack([start + turns, end + turns], axis=1), rtol=1e-12)


@pytest.mark.parametrize("name", ["wrongly_rejected", "rightly_accepted"])
def test_shares_of_paper_3(name: str) -> None:
    module = pictures("tooth_thickness")
    figure = {"wrongly_rejected": "fig-4", "rightly_accepted": "fig-5"}[name]
    panel = drawn("tooth_thickness", figure).axes[0]
    for as_printed, grade in module.CASES:
        step = "as printed" if as_printed else "corrected"
        ((limits, shown),) = [
            line.get_data()
            for line in panel.lines
            if line.get_label() == f"{module.CURVES[grade]}: tip of IT{grade}, step 5 {step}"
        ]
        exact = module.inspect(limits, grade, as_printed).shares()
        np.testing.assert_allclose(shown, 100 * getattr(exact, name), rtol=1e-14)
    assert np.all(
        np.diff([line.get_ydata()[0] for line in panel.lines if len(line.get_xdata()) > 9])
    )


def test_simulated_points_of_paper_3_are_within_their_errors() -> None:
    module = pictures("tooth_thickness")
    panel = drawn("tooth_thickness", "fig-4").axes[0]
    assert len(panel.containers) == len(module.CASES)
    for (as_printed, grade), container in zip(module.CASES, panel.containers, strict=True):
        points, _, (bars,) = container
        exact = module.inspect(points.get_xdata(), grade, as_printed).shares().wrongly_rejected
        segments = np.array(bars.get_segments())
        errors = (segments[:, 1, 1] - segments[:, 0, 1]) / 2
        # The seed is fixed; one of sixteen normal deviates is beyond 4 once in a thousand runs.
        assert np.all(np.abs(points.get_ydata() - 100 * exact) < 4 * errors)
        binomial = 100 * np.sqrt(exact * (1 - exact) / module.TEETH)
        np.testing.assert_allclose(errors, binomial, rtol=0.35)


def test_crossovers_of_paper_3_are_those_of_the_ledger() -> None:
    module = pictures("tooth_thickness")
    assert module.crossover_um(6, as_printed=True) == pytest.approx(7.36, abs=0.005)
    for as_printed, grade in module.CASES:
        limit = module.crossover_um(grade, as_printed)
        tip, height, thickness = (
            law.std for law in module.inspect(limit, grade, as_printed).errors
        )
        assert float(np.hypot(height, thickness)) == pytest.approx(float(tip), rel=1e-14)


@pytest.mark.parametrize("number", [1, 2])
def test_boundaries_of_paper_4(number: int) -> None:
    module = pictures("wedge_linkage")
    name = "fig-4" if number == 1 else "fig-4-set-2"
    position, order, deviation, spread, turn = drawn("wedge_linkage", name).axes
    sizes = WedgeLinkage.published_sizes(number)
    corners = corner_range(wedge_linkage.position, module.STROKE, sizes)
    nominal, upper, lower = (line.get_ydata() for line in position.lines[:3])
    np.testing.assert_array_equal(nominal, corners.nominal)
    # The range exceeds II by up to 24 um, where another corner takes over, but not III or IV.
    assert np.all((corners.upper - upper >= 0) & (corners.upper - upper < 0.025))
    np.testing.assert_allclose(lower, corners.lower, rtol=0, atol=1e-12)
    widest = spread.lines[0].get_ydata()
    np.testing.assert_allclose(widest, upper - lower, rtol=0, atol=1e-12)
    place, value = spread.lines[1].get_data()
    assert float(value[0]) == widest.max()
    assert float(place[0]) == module.STROKE[np.argmax(widest)]
    (crossing,) = order.lines[2].get_xdata()
    assert -29.45 < crossing < -29.35
    apart = dict(zip(*order.lines[1].get_data(), strict=True))
    assert apart[-40.0] > 0 > apart[-20.0]
    assert deviation.lines[0].get_ydata()[0] == pytest.approx(100 * (upper[0] / nominal[0] - 1))
    places, beyond = turn.lines[1].get_data()
    bound = certified_range(load_wedge(), "position", places[4:6], sizes)
    at = 1e3 * (bound.upper - module.move(number, places[4:6], module.BOUNDARY_II))
    np.testing.assert_allclose(beyond[4:6], at, atol=1e-9)
    assert np.all(beyond > -1e-6)


def test_the_legible_digits_of_paper_4_end_where_the_ledger_says() -> None:
    module = pictures("wedge_linkage")
    assert -4.66 < module.legible_end() < -4.65
    sizes = module.legible_sizes()
    assert (sizes["l_BC"], sizes["l_CD"]) == (19.75, 38.0)
    with np.errstate(invalid="ignore"):
        assert np.isnan(wedge_linkage.position(module.legible_end() - 1e-9, **sizes))


def test_errors_along_the_track_of_paper_5() -> None:
    module = pictures("track_wheel")
    radius, error, largest = drawn("track_wheel", "fig-3").axes
    wheel = TrackWheel.published(z=module.PERIODS, H=module.THICKNESS, shift=(0, 0, 0))
    degrees, shown = radius.lines[0].get_data()
    np.testing.assert_allclose(shown, wheel.radius(np.radians(degrees)), rtol=1e-14)
    for label, rule in (("in the plane", wheel.planar_error), ("in space", wheel.spatial_error)):
        ((degrees, shown),) = [d.T for d in lines(error, label)]
        np.testing.assert_allclose(shown, 1e3 * rule(np.radians(degrees)), rtol=1e-10)
    moved = 1e3 * np.abs(wheel.displacement(np.linspace(0, 2 * np.pi, 721)))
    heights = [bar.get_height() for bar in largest.patches]
    np.testing.assert_allclose(heights[:3], moved.max(axis=0), rtol=1e-14)
    assert heights[2] > heights[3]


def test_totals_of_paper_5_are_those_of_the_ledger() -> None:
    module = pictures("track_wheel")
    errors = module.collect()
    assert 1e3 * float(module.total_random(errors)) == pytest.approx(72.0, abs=0.05)
    assert 1e3 * float(module.total_systematic(errors)) == pytest.approx(83.7, abs=0.05)
    assert 1e3 * float(module.total_printed(0.016, 1.0)) == pytest.approx(178, abs=0.5)
    assert 1e3 * float(module.total_printed(0.016, 1e-3)) == pytest.approx(71, abs=0.5)
    # (6) as printed, all coefficients 1, is a fixed point of its own total in its unit.
    total = float(module.total_printed(0.016, 1.0))
    squares = float(np.sum(errors**2))
    assert total**2 == pytest.approx(squares + 0.15 * total, rel=1e-14)


def test_gain_and_shares_of_paper_5() -> None:
    module = pictures("track_wheel")
    (panel,) = drawn("track_wheel", "fig-5").axes
    left, shown = panel.lines[0].get_data()
    ones = np.ones(5)
    at = module.collect(Delta_delta=np.asarray(left) / 1e3)
    right = track_wheel.error_sum_thermal(at, ones, ones, 1.0, 0.15, 1.0)
    np.testing.assert_allclose(shown, 1e3 * right, rtol=1e-14)
    (panel,) = drawn("track_wheel", "table-1").axes
    widths = [bar.get_width() for bar in panel.patches]
    assert sum(widths) == pytest.approx(100, rel=1e-13)
    assert widths == sorted(widths)
