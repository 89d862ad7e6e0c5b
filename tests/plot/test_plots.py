"""Drawings of a user's own mechanism: what they draw, refuse, and leave unchanged."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from drawn import cut_off, load_wedge, overlaps, span_of, struck, write_texts
from matplotlib.figure import Figure as Canvas
from weights import first_of

from mechproof import (
    CylindricalPair,
    EllipticPlanetary,
    OvalPair,
    OvalPlanetary,
    ThicknessInspection,
    TrackWheel,
    WedgeLinkage,
    plot,
)
from mechproof.conformity import Normal, Shares
from mechproof.kernels import wedge_linkage
from mechproof.plot.canvas import SMALL
from mechproof.plot.motion_plot import place_wheels
from mechproof.tolerance import Size, certified_range, corner_range, monte_carlo_range
from mechproof.tools.extras import suggest_install

ELLIPTIC = EllipticPlanetary.published(2)
RESTING = OvalPlanetary.published(3)
MOUNTED = OvalPlanetary(OvalPair("0.3", "0.7"), "0.2")
MECHANISMS = (ELLIPTIC, OvalPlanetary.published(1), RESTING, MOUNTED)


def text_of(panel: Any) -> str:
    return "\n".join(t.get_text() for t in write_texts(panel.figure)).replace("\N{MINUS SIGN}", "-")


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
def test_motion_draws_the_kernels(mechanism: Any) -> None:
    panels = plot.motion(mechanism)
    rules = (lambda x: np.degrees(mechanism.position(x)), mechanism.ratio, mechanism.acceleration)
    for panel, rule in zip(panels, rules, strict=True):
        degrees, shown = max((line.get_data() for line in panel.lines), key=lambda d: len(d[0]))
        # Near a zero of the ratio a rounding of the angle moves it by an eps of its slope.
        np.testing.assert_allclose(shown, rule(np.radians(degrees)), rtol=1e-12, atol=1e-12)
        period = np.degrees(mechanism.extremes().period)
        assert (degrees[0], degrees[-1]) == (0.0, pytest.approx(period, rel=1e-15))


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
def test_marked_extremes_are_the_largest_and_smallest_drawn(mechanism: Any) -> None:
    panel = plot.motion(mechanism)[1]
    curve = max((line.get_ydata() for line in panel.lines), key=len)
    marks = [float(line.get_ydata()[0]) for line in panel.lines if len(line.get_xdata()) == 1]
    # The nearest sample misses an extreme by the square of half a step.
    assert marks == pytest.approx([curve.max(), curve.min()], abs=1e-3)
    assert marks[0] >= curve.max() - 1e-12
    assert marks[1] <= curve.min() + 1e-12


@pytest.mark.parametrize("mechanism", MECHANISMS[1:], ids=repr)
def test_extremes_of_oval_wheels_are_where_they_are_said(mechanism: OvalPlanetary) -> None:
    found = mechanism.extremes()
    assert mechanism.ratio(found.at_maximum) == pytest.approx(found.maximum, abs=1e-14)
    assert mechanism.ratio(found.at_minimum) == pytest.approx(found.minimum, abs=1e-14)
    everywhere = mechanism.ratio(np.linspace(0, found.period, 999))
    assert everywhere.min() >= found.minimum - 1e-14
    assert everywhere.max() <= found.maximum + 1e-14
    shifted = mechanism.ratio(found.at_minimum + found.period)
    assert shifted == pytest.approx(found.minimum, abs=1e-13)


def test_rests_are_shaded_inside_the_period_and_told() -> None:
    panels = plot.motion(RESTING, eta="0.01")
    ((start, end),) = RESTING.classify("0.01").rests
    for panel in panels:
        (band,) = panel.patches
        assert span_of(band) == pytest.approx(np.degrees([start, end]))
    assert "intermittent, -180° in a turn" in text_of(panels[0])
    assert "at rest over 10.23° of 120°" in text_of(panels[0])


def test_a_rest_across_the_end_of_the_period_is_shaded_at_both_ends() -> None:
    with_carrier = OvalPlanetary(CylindricalPair(R4=20, R5=30), "0.2")
    bands = plot.motion(with_carrier, eta="0.01")[0].patches
    period = np.degrees(with_carrier.extremes().period)
    edges = sorted(map(span_of, bands))
    assert edges[0][0] == 0.0
    assert edges[-1][1] == pytest.approx(period)


def test_a_constant_ratio_has_no_extremes_to_mark() -> None:
    panel = plot.motion(EllipticPlanetary(66, 16, 0))[1]
    assert all(len(line.get_xdata()) > 1 for line in panel.lines)


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
@pytest.mark.parametrize("angle", [0.0, 0.6, 2.0, -4.3])
def test_wheels_touch_and_roll_as_the_kernels_turn(mechanism: Any, angle: float) -> None:
    fixed, satellite, driver, output = place_wheels(mechanism, angle)
    contacts = fixed.point(angle), output.point(angle)
    span = np.linalg.norm(satellite.axis)
    inward = angle if isinstance(mechanism, EllipticPlanetary) else angle + np.pi
    np.testing.assert_allclose(satellite.point(inward), contacts[0], atol=1e-12 * span)
    np.testing.assert_allclose(driver.point(angle + np.pi), contacts[1], atol=1e-12 * span)
    ray = np.array([np.cos(angle), np.sin(angle)])
    at_b, at_d = (float(contact @ ray) for contact in contacts)
    # Equation (1) of both papers with the distances drawn, signed along A-C.
    ratio = (at_b - at_d) * span / ((at_b - span) * at_d)
    assert ratio == pytest.approx(float(mechanism.ratio(angle)), abs=1e-11)


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=repr)
def test_wheels_in_mesh_do_not_run_into_each_other(mechanism: Any) -> None:
    for angle in (0.3, 1.7, 4.0):
        fixed, satellite, driver, output = place_wheels(mechanism, angle)
        for one, other in ((fixed, satellite), (output, driver)):
            points = other.outline() - one.axis
            reach = one.radius(np.arctan2(points[:, 1], points[:, 0]))
            apart = np.linalg.norm(points, axis=1) - reach
            internal = one is fixed and isinstance(mechanism, EllipticPlanetary)
            # Outside everywhere, or inside the ring; touching up to a rounding.
            assert np.all((-apart if internal else apart) > -1e-9)


def test_pitch_curves_draw_the_wheels_to_scale() -> None:
    panel = plot.pitch_curves(RESTING, 0.6)
    curves = {line.get_label(): line.get_xydata() for line in panel.lines}
    for wheel in place_wheels(RESTING, 0.6):
        np.testing.assert_array_equal(curves[f"wheel {wheel.number}"], wheel.outline())
    assert panel.get_aspect() == 1.0
    assert panel.get_xlabel() == "mm"
    assert plot.pitch_curves(MOUNTED, 0.6).get_xlabel() == "lengths in units of a"


X1 = np.linspace(-40.0, 0.0, 41)
SIZES = WedgeLinkage.published_sizes(1)
CORNERS = corner_range(wedge_linkage.position, X1, SIZES)


def test_tolerance_draws_deviations_from_nominal() -> None:
    scatter = monte_carlo_range(
        wedge_linkage.position,
        X1,
        SIZES,
        laws=Size.uniform,
        rng=np.random.default_rng(1),
        count=500,
    )
    panel = plot.tolerance(X1, CORNERS, scatter=scatter, labels=("x₁, mm", "y₉, mm"))
    shown = {line.get_label(): line.get_ydata() for line in panel.lines}
    upper = shown["all combinations of limits"]
    np.testing.assert_array_equal(upper, CORNERS.upper - CORNERS.nominal)
    ours = shown["range of given probability"]
    np.testing.assert_array_equal(ours, scatter.upper - CORNERS.nominal)
    assert "widest 24.8 at -40" in text_of(panel)


def test_tolerance_draws_certified_bounds_and_leaves_gaps_where_there_are_none() -> None:
    points = np.array([-37.1, -30.0])
    corners = corner_range(wedge_linkage.position, points, SIZES)
    bound = certified_range(load_wedge(), "position", points, SIZES, budget=2)
    panel = plot.tolerance(points, corners, certified=bound)
    (shown,) = [c.get_ydata() for c in panel.lines if c.get_label() == "certified bounds"]
    right = np.where(np.isfinite(bound.upper), bound.upper - corners.nominal, np.nan)
    np.testing.assert_array_equal(shown, right)


def inspect(limit: Any) -> ThicknessInspection:
    gauge = Normal(np.zeros_like(limit), np.asarray(limit) / 3)
    return ThicknessInspection.published(
        true=Normal.from_width(-0.0345, 0.045, 6),
        tip_diameter=Normal.from_width(0, 0.025, 6),
        height=gauge,
        thickness=gauge,
    )


LIMITS = np.linspace(0.0, 0.02, 21)


def test_shares_draw_per_cent_and_simulated_points_with_their_errors() -> None:
    places = np.array([0.001, 0.01])
    exact = inspect(LIMITS).shares()
    counted = inspect(places).simulate(rng=np.random.default_rng(1), count=1000)
    panel = plot.shares(LIMITS, exact, simulated=(places, counted), label="limit, mm")
    shown = {line.get_label(): line.get_ydata() for line in panel.lines}
    for name in ("wrongly_rejected", "wrongly_accepted"):
        np.testing.assert_array_equal(shown[name.replace("_", " ")], 100 * getattr(exact, name))
    points, _, (bars,) = panel.containers[0]
    np.testing.assert_array_equal(points.get_ydata(), 100 * counted.wrongly_rejected)
    segments = np.array(bars.get_segments())
    error = 100 * counted.standard_error.wrongly_rejected[1]
    assert segments[1, 1, 1] - segments[1, 0, 1] == pytest.approx(2 * error)
    # No part was counted at the first place: the bar ends at the one-sided bound.
    first = 100 * counted.upper.wrongly_accepted[0]
    assert counted.wrongly_accepted[0] == 0
    assert np.array(panel.containers[1][2][0].get_segments())[0, 1, 1] == pytest.approx(first)


def test_drawings_go_on_the_axes_that_are_given() -> None:
    mine = list(Canvas().subplots(3))
    assert plot.motion(ELLIPTIC, mine) == mine
    assert plot.pitch_curves(ELLIPTIC, 1.0, mine[0]) is mine[0]
    assert plot.tolerance(X1, CORNERS, mine[1]) is mine[1]
    assert plot.shares(LIMITS, inspect(LIMITS).shares(), mine[2]) is mine[2]


def new_drawings() -> list[Any]:
    return [
        plot.motion(RESTING, eta="0.01")[0],
        plot.pitch_curves(ELLIPTIC, 0.6),
        plot.tolerance(X1, CORNERS),
        plot.shares(LIMITS, inspect(LIMITS).shares()),
    ]


def test_text_is_large_enough_at_the_width_of_a_column() -> None:
    for panel in new_drawings():
        assert min(t.get_fontsize() for t in write_texts(panel.figure)) >= SMALL
        assert panel.figure.get_size_inches()[0] * 25.4 == pytest.approx(85)


@pytest.mark.parametrize("mechanism", first_of(MECHANISMS), ids=repr)
def test_text_does_not_overlap(mechanism: Any) -> None:
    panels = [plot.pitch_curves(mechanism, angle) for angle in (0.0, 0.83, 3.72, 4.13)]
    for panel in (*panels, plot.motion(mechanism)[0]):
        boxes = write_texts(panel.figure)
        assert not overlaps(boxes)
        assert not cut_off(panel.figure, boxes)


def test_text_of_ranges_and_shares_can_be_read() -> None:
    for panel in new_drawings()[2:]:
        boxes = write_texts(panel.figure)
        assert not overlaps(boxes)
        assert not cut_off(panel.figure, boxes)
        assert not struck(panel, boxes)


def test_nothing_global_is_changed() -> None:
    before = dict(mpl.rcParams)
    new_drawings()
    assert dict(mpl.rcParams) == before


def run(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout


@pytest.mark.slow
def test_pyplot_and_sympy_are_not_loaded() -> None:
    code = (
        "import sys\nfrom mechproof import EllipticPlanetary, plot\n"
        "plot.motion(EllipticPlanetary.published(2))\n"
        "print([m for m in ('matplotlib.pyplot', 'sympy', 'scipy') if m in sys.modules])"
    )
    assert run(code).strip() == "[]"


def test_without_matplotlib_the_extra_is_named() -> None:
    code = (
        "import sys\nsys.modules['matplotlib'] = None\n"
        "from mechproof import EllipticPlanetary, plot\n"
        "try:\n    plot.motion(EllipticPlanetary.published(2))\n"
        "except ImportError as error:\n    print(error)"
    )
    assert suggest_install("plot") in run(code)


SHARES = inspect(LIMITS).shares()
REFUSED = {
    "mechanism": lambda: plot.motion(TrackWheel(41.5, 3.75, 6, 20)),
    "axes": lambda: plot.motion(ELLIPTIC, [1, 2, 3]),
    "eta": lambda: plot.motion(ELLIPTIC, eta="0.01"),
    "eta = None": lambda: plot.motion(OvalPlanetary(OvalPair(0.2), 0.2)),
    "phi1": lambda: plot.pitch_curves(ELLIPTIC, np.inf),
    "ax": lambda: plot.pitch_curves(ELLIPTIC, 0.0, "here"),
    "inputs": lambda: plot.tolerance(1.0, CORNERS),
    "corners": lambda: plot.tolerance(X1, SHARES),
    "certified": lambda: plot.tolerance(X1, CORNERS, certified=CORNERS),
    "which": lambda: plot.shares(LIMITS, SHARES, which=("rejected",)),
    "exact": lambda: plot.shares(LIMITS, CORNERS),
    "exact = (21,)": lambda: plot.shares(LIMITS[1:], SHARES),
    "simulated": lambda: plot.shares(LIMITS, SHARES, simulated=SHARES),
    "simulated[1]": lambda: plot.shares(LIMITS, SHARES, simulated=(LIMITS, SHARES)),
}


@pytest.mark.parametrize("name", REFUSED)
def test_bad_arguments_are_named(name: str) -> None:
    with pytest.raises((TypeError, ValueError)) as refused:
        REFUSED[name]()
    assert str(refused.value).startswith(name)


def test_shares_of_one_point_are_drawn() -> None:
    one = Shares(*(np.array([0.25]) for _ in range(4)))
    assert plot.shares([1.0], one, which="rightly_accepted").lines[0].get_ydata() == [25.0]


@pytest.mark.parametrize(
    ("radii", "ticks"),
    [((60, 20), [0, 30, 60, 90, 120]), ((66, 16), [0, 30, 60, 90]), ((99, 9), 5)],
)
def test_degrees_are_ticked_every_thirty(radii: tuple[int, int], ticks: Any) -> None:
    panels = plot.motion(EllipticPlanetary(*radii, 0.3))
    low, high = panels[-1].get_xlim()
    shown = [t for t in panels[-1].get_xticks() if low <= t <= high]
    if isinstance(ticks, int):
        assert set(np.diff(shown)) == {ticks}
    else:
        assert shown == ticks


def test_pitch_curves_at_degrees() -> None:
    found = plot.pitch_curves(ELLIPTIC, 40.0, degrees=True).get_title("left")
    assert found == plot.pitch_curves(ELLIPTIC, np.radians(40.0)).get_title("left")
    assert found.startswith("φ₁ = 40°")
