"""Where each rival of a kernel fails, read from tables: branches, digits, bounds of approximations.

Every loss is one that the kernel does not have at the same points.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from ways import EPS, bound_of, compare, draw_set, find_subject, find_way, run, sum_up, truth_of

from mechproof.lab.bounds import bound_over
from mechproof.lab.subject import find_subjects
from mechproof.lab.ways import Arguments
from mechproof.lab.within import mark_within

ELLIPTIC, OVAL = "elliptic_planetary.position", "oval_planetary.position"
CYLINDRICAL = "oval_planetary.position_cylindrical"
HEIGHT, THICKNESS = "tooth_thickness.height_change", "tooth_thickness.thickness_change"
DEVIATION = "measurement.standard_deviation"
WHEEL = (3.0, 50.0, np.pi / 9)


def at(running: Any, *sizes: float) -> Arguments:
    return np.asarray(running, float), *map(np.array, sizes)


def sweep(turns: float, count: int, *sizes: float) -> Arguments:
    return at(np.linspace(0, turns * 2 * np.pi, count), *sizes)


def quarter_turns(r4: float = 1, r5: float = 1) -> np.ndarray:
    return (2 * np.arange(300) + 1) * np.pi / 2 * r5 / r4


# Branches

SPUR, OVALS, CYLINDERS = (66.0, 16.0, 0.475), (0.8, 0.8, 0.0), (32.0, 18.0, 0.2)
# Quantity, arguments, and of each way how many points are off by whole periods, at least and most.
# At how many odd half turns the rounded quotient and NumPy's tangent disagree depends on the last
# bit of the tangent: 29 of 66 where this was written.
BRANCHES: tuple[tuple[str, Arguments, dict[str, tuple[int, int]]], ...] = (
    (
        ELLIPTIC,
        sweep(16, 3301, *SPUR),
        {
            "tan/arctan": (3275, 3275),
            "printed (12)": (3275, 3275),
            "tan/arctan + floor": (10, 66),
            "tan/arctan + unwrap": (0, 0),
            "x + 2 atan2, no cancellation": (0, 0),
        },
    ),
    (ELLIPTIC, sweep(16, 161, *SPUR), {"tan/arctan + unwrap": (101, 161)}),
    (OVAL, at(quarter_turns(), 0.2, 0.2, 0.4), {"tan/arctan + floor": (5, 300)}),
    (OVAL, at(quarter_turns(), 0.9, 0.2, 0.4), {"tan/arctan + floor": (5, 300)}),
    (OVAL, sweep(4, 2001, *OVALS), {"tan/arctan + unwrap": (0, 0)}),
    (OVAL, sweep(4, 21, *OVALS), {"tan/arctan + unwrap": (11, 21)}),
    (CYLINDRICAL, at(quarter_turns(80, 30), 80.0, 30.0, 0.2), {"tan/arctan + floor": (5, 300)}),
    (CYLINDRICAL, at(quarter_turns(80, 30), 80.0, 30.0, 0.9), {"tan/arctan + floor": (5, 300)}),
    (CYLINDRICAL, sweep(16, 3301, *CYLINDERS), {"tan/arctan + unwrap": (0, 0)}),
    (CYLINDRICAL, sweep(16, 61, *CYLINDERS), {"tan/arctan + unwrap": (41, 61)}),
)


@pytest.mark.parametrize(("quantity", "arguments", "ways"), BRANCHES)
def test_points_off_by_whole_periods(
    quantity: str, arguments: Arguments, ways: dict[str, tuple[int, int]]
) -> None:
    assert sum_up(quantity, "kernel", arguments).wrong_branch == 0
    for name, (least, most) in ways.items():
        assert least <= sum_up(quantity, name, arguments).wrong_branch <= most, name


# Digits


@dataclass(frozen=True)
class Loss:
    """Ways that lose so many bits more from one place of a ladder to the next."""

    quantity: str
    ladder: tuple[Arguments, ...]
    bits: float
    within: float
    ways: tuple[str, ...]


def approach_one(*exponents: int, start: float, before: tuple[float, ...] = ()) -> Iterator[Any]:
    """From one to three times the width of the peak, as e goes to one."""
    for exponent in exponents:
        e = 1 - 10.0**-exponent
        yield np.linspace(1, 3, 40) * (1 - e) * start, *map(np.array, before), np.array(e)


def shrink(*exponents: int, sizes: tuple[float, ...]) -> tuple[Arguments, ...]:
    return tuple(at(np.linspace(1, 2, 20) * 10.0**-exponent, *sizes) for exponent in exponents)


SPURS = tuple(approach_one(2, 4, 6, 8, start=16 / 66, before=(66.0, 16.0)))
PEAKS = tuple(approach_one(2, 4, 6, start=0.5, before=(32.0, 18.0)))
MOUNTED = tuple((*a, np.array(0.0)) for a in approach_one(2, 4, 6, start=0.5, before=(0.2,)))
# 1 - e cos x keeps eps of 1 where it is 1 - e, its square twice as few digits; two decades of
# 1 - e are 6.6 bits. Of a difference of two lengths three decades of the motion are 10 bits.
LOSSES = {
    "position, 1 - e": Loss(
        ELLIPTIC, SPURS, 6.64, 1.9, ("x + 2 atan2, 1 - e cos x",),
    ),
    "cylindrical position": Loss(CYLINDRICAL, PEAKS, 6.6, 2, ("atan2, 1 - e cos x",)),
    "cylindrical ratio": Loss(
        "oval_planetary.ratio_cylindrical", PEAKS, 13.3, 2, ("printed (4), (10)",)
    ),
    "cylindrical acceleration": Loss(
        "oval_planetary.acceleration_cylindrical", PEAKS, 13.3, 2, ("1 + e**2 - 2 e cos x",)
    ),
    "ratio": Loss(
        "oval_planetary.ratio", MOUNTED, 13.3, 2, ("printed (3)-(6), (10)", "double angles")
    ),
    "acceleration": Loss("oval_planetary.acceleration", MOUNTED, 13.3, 2, ("double angles",)),
    "height": Loss(
        HEIGHT, shrink(3, 6, 9, 12, sizes=WHEEL), 9.97, 3, ("difference of two distances",)
    ),
    "thickness": Loss(
        THICKNESS, shrink(3, 6, 9, 12, sizes=WHEEL), 9.97, 3, ("difference of two chords",)
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", LOSSES)
def test_digits_go_step_by_step(name: str) -> None:
    row = LOSSES[name]
    for way in (*row.ways, "kernel"):
        lost = [float(np.max(run(row.quantity, way, place).bits)) for place in row.ladder]
        if way in row.ways:
            assert np.all(np.abs(np.diff(lost) - row.bits) < row.within), (way, lost)
        else:
            assert max(lost) < 4, (way, lost)


@pytest.mark.parametrize("way", ["x + 2 atan2, no cancellation", "tan-half, by hand"])
def test_the_bracket_keeps_the_digits(way: str) -> None:
    assert max(np.max(run(ELLIPTIC, way, place).bits) for place in SPURS) < 4


# Ways with a set on which they lose so many eps of the scale; the kernel keeps its bound there.
LOST = (
    (OVAL, "one atan2, unsplit", "Eq(e1, e2)", 1e6),
    (OVAL, "leads by atan2, 1 - e cos 2 phi", "Eq(mount, pi*m/2)", 1e9),
    (CYLINDRICAL, "atan2, no cancellation", "Eq(x, 2*pi*m)", 1e6),
    ("elliptic_planetary.ratio", "printed (8)", "Eq(x, 2*pi*m_turns)", 1e6),
    ("elliptic_planetary.ratio", "half-angle sine", "Eq(x, 2*pi*m_turns)", 1e6),
    ("elliptic_planetary.acceleration", "1 + e**2 - 2 e cos x", "Eq(e, 1)", 1e6),
    ("elliptic_planetary.acceleration", "half-angle sine", "Eq(x, 2*pi*m_turns)", 1e6),
    ("oval_planetary.ratio_cylindrical", "half-angle sine", "Eq(x, 2*pi*m)", 1e6),
    (HEIGHT, "difference of two distances", "Eq(tilt, 0)", 1e6),
    (THICKNESS, "difference of two chords", "Eq(tilt, 0)", 1e6),
    ("track_wheel.radius", "printed (16)", "through the pole", 1e3),
    ("track_wheel.track", "printed (16)", "edges of the domain", 1e3),
    ("track_wheel.planar_error", "printed (17)", "tiny", 1e6),
    ("track_wheel.spatial_error", "printed (18)", "tiny", 1e6),
)


@pytest.mark.parametrize(("quantity", "way", "name", "eps"), LOST)
def test_digits_are_lost_on_a_set(quantity: str, way: str, name: str, eps: float) -> None:
    arguments = draw_set(quantity, name, 0.1)
    held = mark_within(find_subject(quantity), arguments) & truth_of(quantity, arguments).decided
    lost, kept = (compare(quantity, w, arguments).scaled[held] for w in (way, "kernel"))
    assert np.max(lost) > eps
    assert np.max(kept) <= bound_of(quantity)


def test_a_direct_turn_loses_half_the_digits() -> None:
    """1 - cos beside sin: worst where the square of the angle is eps."""
    points, lost = np.random.default_rng(3).uniform(-50, 50, (60, 3)), []
    for size in (1e-3, 1e-6, 1e-9, 1e-12):
        turn = np.full((60, 3), [size, -size, size])
        arguments = points, turn, np.zeros((60, 3))
        name = "track_wheel.displacement"
        lost.append(np.max(run(name, "direct (K^T - I)*p + t", arguments).bits))
        assert np.max(run(name, "kernel", arguments).bits) < 4
    assert max(lost) > 20
    assert lost[0] < lost[1] < 30


def test_below_the_rounding_of_the_angle_nothing_is_left() -> None:
    tilts = np.array([1e-17, -1e-30, 1e-300])
    for quantity, way in (
        (HEIGHT, "difference of two distances"),
        (THICKNESS, "difference of two chords"),
    ):
        assert np.all(run(quantity, way, at(tilts, *WHEEL)).bits > 50)


def test_one_minus_cosine_loses_half_the_digits() -> None:
    """Its rounding, eps of one, stands beside a first order as small as the tilt.

    The loss is worst at 1e-8: below, cos(tilt) is one, and 1 - cos(tilt) is 0 exactly.
    """
    tilts = np.geomspace(1e-12, 1e-3, 30)
    lost = run(HEIGHT, "sympy.lambdify, cse", at(tilts, *WHEEL)).bits
    assert 20 < np.max(lost) < 30
    assert 1e-9 < tilts[np.argmax(lost)] < 1e-7
    assert np.max(run(HEIGHT, "kernel", at(tilts, *WHEEL)).bits) < 4


def test_leads_cancel_where_the_output_rests() -> None:
    """Equal ovals side by side: the leads of the pairs are each others' opposites."""
    arguments = at(np.linspace(0.1, 1.4, 50), 0.475, 0.475, np.pi / 2 + 1e-9)
    assert sum_up(OVAL, "leads by atan2, 1 - e cos 2 phi", arguments).worst_bits > 20


def test_without_the_low_word_digits_go_with_the_angle() -> None:
    """The rounded product is off by eps*|x|, which the peak makes eps*|x|/(1 - e2) of."""
    e2 = 0.999999
    for turns in (10, 1000, 100_000):
        phi1 = (turns * np.pi + np.linspace(1, 3, 40) * (1 - e2)) * 18 / 32
        plain, kernel = (
            np.max(run(CYLINDRICAL, name, at(phi1, 32.0, 18.0, e2)).absolute)
            for name in ("atan2, no cancellation", "kernel")
        )
        # A tenth of what the rounding of x may cost, against 4 eps of the larger term.
        assert plain > 0.02 * EPS * turns * np.pi / (1 - e2)
        assert kernel <= 4 * EPS * turns * np.pi * (1 - 18 / 32)


def find_meeting(e1: float, mount: float) -> float:
    """Return the angle at which the long axis of wheel 6 meets the centre line."""
    return float(np.arctan2(-(1 - e1) * np.sin(mount), (1 + e1) * np.cos(mount)))


def test_beside_the_meeting_the_kernel_keeps_what_the_tangent_leaves() -> None:
    e2, mount = 1 - 1e-12, np.pi / 4
    for h in (1e-3, 1e-5, 1e-7):
        phi1 = find_meeting(0.475, mount) + np.linspace(1, 2, 60) * h
        kernel = run(OVAL, "kernel", at(phi1, 0.475, e2, mount))
        assert np.max(kernel.scaled) <= bound_of(OVAL)
        # What the meeting makes of the tangent's last bit, and 4 eps of a value below pi.
        assert np.max(kernel.absolute) < EPS * (13 + 1e-12 / h**2 * 40)


def test_what_the_meeting_costs() -> None:
    """The floor: a rounded tangent, on the flank of the peak, is off by eps/(1 - e2) of W."""
    name = "oval_planetary.ratio"
    for exponent in (3, 6, 9, 12):
        e2, mount = 1 - 10.0**-exponent, np.pi / 4
        width = np.linspace(0.3, 3, 60) * (1 - e2)
        arguments = at(find_meeting(0.2, mount) + width, 0.2, e2, mount)
        errors, truth = run(name, "kernel", arguments), truth_of(name, arguments)
        relative = errors.absolute / np.maximum(1, np.abs(1 - truth.high)) / EPS
        assert 0.05 < relative.max() * (1 - e2) < 8
        assert np.max(errors.scaled) <= bound_of(name)


def test_far_from_the_meeting_the_ratio_is_of_its_largest_term() -> None:
    """At e2 = 1 - 1e-12 as well: the scale exceeds 1 and W only where the axes meet."""
    phi1 = np.linspace(-3, 3, 200)
    for e2, mount in ((0.999999, 1.2), (1 - 1e-12, 1.2), (1 - 1e-12, np.pi / 2)):
        truth = truth_of("oval_planetary.ratio", at(phi1, 0.475, e2, mount))
        largest = np.maximum(1, np.abs(1 - truth.high))
        far = np.abs(np.sin(phi1 - find_meeting(0.475, mount))) > 0.1
        assert truth.scale is not None
        assert np.all(truth.scale[far] <= largest[far] * 1.001)


def test_at_rest_there_is_nothing_to_lose() -> None:
    """Circles: the value is 0 exactly, so no ball decides a digit; ours is 0 to an eps of 1."""
    phi1 = np.linspace(-7, 7, 30)
    ratio, position = (find_subject(n).kernel for n in ("oval_planetary.ratio", OVAL))
    assert np.abs(ratio(*at(phi1, 0.0, 0.0, 0.3))).max() <= EPS * 8
    assert not np.any(position(*at(phi1, 0.0, 0.0, 0.3)))


def test_the_root_of_a_difference_loses_what_the_share_takes() -> None:
    """1 - 1e-12 of the total: the difference of rounded squares has four digits left."""
    one = np.ones((1, 6))
    whole = np.array([1.2]), np.array([(1 - 1e-12) / 1.7]), np.array([1.2 * 1.7])
    arguments = np.full((1, 6), 0.1), one, one, *whole
    by_hand = run("track_wheel.error_sum_thermal", "difference of squares", arguments)
    ours = run("track_wheel.error_sum_thermal", "kernel", arguments)
    assert ours.scaled[0] <= 9
    assert by_hand.bits[0] > 30


def test_single_precision_keeps_24_bits() -> None:
    assert 25 < sum_up(ELLIPTIC, "kernel, float32", sweep(1, 200, *SPUR)).worst_bits < 40


def test_the_solver_and_the_samples_drift() -> None:
    """The tolerance of 1e-12 is met locally and not kept."""
    rows = (
        (ELLIPTIC, sweep(1, 50, *SPUR)),
        (OVAL, sweep(4, 401, 0.2, 0.2, 0.4)),
        (CYLINDRICAL, sweep(4, 401, *CYLINDERS)),
    )
    for name, arguments in rows:
        drift = sum_up(name, "solve_ivp, DOP853 1e-12", arguments).worst_absolute
        assert 1e-12 < drift < 1e-7, name
    for name, arguments in rows[1:]:
        assert 1e-9 < sum_up(name, "cumulative Simpson", arguments).worst_absolute < 1e-2, name
    coarse = sweep(4, 21, *OVALS)
    assert sum_up(OVAL, "cumulative Simpson", coarse).worst_absolute > 1


# Approximations with proved bounds


@dataclass(frozen=True)
class Bounded:
    """An approximation in a box: its worst error lies between a part of its bound and the bound.

    `rounding` is what doubles add.
    """

    quantity: str
    way: str
    box: dict[str, tuple[float, float]]
    arguments: Arguments
    part: float
    rounding: float = 0.0


def list_bounded() -> Iterator[Bounded]:
    turn = sweep(1, 200, *SPUR)
    for terms in (2, 4, 8):
        # Some 70 terms and sums of rounding on values up to 35.
        way, e = f"Fourier series, {terms} terms", {"e": (0.475, 0.475)}
        yield Bounded(ELLIPTIC, way, e, turn, 40, 100 * EPS * 35)
    near, far = np.linspace(0, 7, 300), np.random.default_rng(3).uniform(-1e6, 1e6, 300)
    for terms in (2, 4, 8, 12):
        for e in (0.01, 0.28, 0.475, 0.9):
            yield Bounded(
                ELLIPTIC,
                f"Fourier series, {terms} terms, float32",
                {"e": (e, e)},
                at(np.concatenate([near, far]), 66.0, 16.0, e),
                1000,
            )
    yield Bounded(
        "track_wheel.displacement",
        "first order in the angles",
        {"points": (0.0, 50.0), "angles": (0.0, 1e-3), "shift": (0.0, 1.0)},
        (np.full((1, 3), 50.0), np.full((1, 3), 1e-3), np.zeros((1, 3))),
        10,
    )
    alpha, sign = map(np.ravel, np.meshgrid([1e-6, 0.1, 0.35, 0.7], [-1.0, 1.0]))
    for quantity, way in (
        (HEIGHT, "first order in the tilt"),
        (THICKNESS, "first order in the tilt"),
        (THICKNESS, "2 tan(alpha) times the height"),
    ):
        for largest in (1e-4, 1e-2, 0.5):
            box = {"tilt": (0.0, largest), "m": (0.0, 3.0), "z": (4.0, 50.0), "alpha": (0.0, 0.7)}
            tilts = (sign * largest, np.full(8, 3.0), np.full(8, 50.0), alpha)
            yield Bounded(quantity, way, box, tilts, 100)


SUBJECTS = find_subjects()
BOUNDED = tuple(list_bounded())


def bound_in(row: Bounded) -> float:
    bound = bound_over(find_subject(row.quantity), find_way(row.quantity, row.way), row.box)
    assert bound is not None
    return bound


@pytest.mark.parametrize("row", BOUNDED, ids=lambda row: f"{row.quantity}, {row.way}, {row.box}")
def test_approximations_stay_within_their_proved_bounds(row: Bounded) -> None:
    bound, worst = bound_in(row), sum_up(row.quantity, row.way, row.arguments).worst_absolute
    # Neither exceeded nor far too large.
    assert worst <= bound + row.rounding
    assert worst > bound / row.part or bound < row.rounding


def test_every_approximation_is_in_the_table() -> None:
    bounded = {(s.name, f.name) for s in SUBJECTS for f in s.quantity.rivals if f.bound is not None}
    assert {(row.quantity, row.way) for row in BOUNDED} == bounded


def test_a_bound_that_is_too_small_would_be_seen() -> None:
    """That of eight terms does not hold for four, nor a fifth of that of the linear model."""
    four, eight = (
        r for r in BOUNDED if r.way in ("Fourier series, 4 terms", "Fourier series, 8 terms")
    )
    assert sum_up(four.quantity, four.way, four.arguments).worst_absolute > 3 * bound_in(eight)
    box = {"tilt": (0.0, 0.1), "m": (0.0, 3.0), "z": (4.0, 50.0), "alpha": (0.0, 0.7)}
    linear = Bounded(HEIGHT, "first order in the tilt", box, at([-0.1], 3.0, 50.0, 1e-6), 5)
    worst = sum_up(linear.quantity, linear.way, linear.arguments).worst_absolute
    assert worst > bound_in(linear) / 5


def test_the_second_order_is_what_the_model_misses() -> None:
    lost = [
        run(THICKNESS, "2 tan(alpha) times the height", at([tilt], *WHEEL)).absolute[0]
        for tilt in (1e-4, 1e-3, 1e-2)
    ]
    assert np.all(np.abs(np.diff(np.log10(lost)) - 2) < 0.05)


@pytest.mark.parametrize("e", [0.28, 0.9])
def test_the_spline_stays_within_its_estimate(e: float) -> None:
    """5/384 h**4 of the largest fourth derivative of the periodic part, found on a fine grid."""
    x, h = np.linspace(0, 2 * np.pi, 200_001), 2 * np.pi / 1024
    power = np.arange(1, 400)[:, np.newaxis]
    fourth = 2 * np.sum(power**3 * e**power * np.sin(power * x[::200]), axis=0)
    bound = 5 / 384 * h**4 * np.abs(fourth).max()
    worst = sum_up(ELLIPTIC, "cubic spline, 1024 knots", sweep(1, 401, 66.0, 16.0, e))
    # The grid misses a percent of the largest; the knots' rounding is a few eps of 2*pi.
    assert worst.worst_absolute <= 1.01 * bound + 1e-14


# Numbers that papers print


@pytest.mark.parametrize(
    ("quantity", "way", "decimals"),
    [("constant_chord", "1.387 m", 5e-4), ("chord_height", "0.7476 m", 5e-5)],
)
def test_printed_numbers_are_for_twenty_degrees(quantity: str, way: str, decimals: float) -> None:
    modules, name = np.geomspace(0.1, 50, 12), f"tooth_thickness.{quantity}"
    right = run(name, way, (modules, np.full(12, np.pi / 9)))
    assert np.all(right.absolute <= decimals * modules)
    # A quarter of a degree more shows in the last decimal, and five degrees in the first.
    near = run(name, way, (modules, np.full(12, np.pi / 9 + 0.005)))
    assert np.all(near.absolute > decimals * modules)
    far = run(name, way, (modules, np.full(12, np.pi * 25 / 180)))
    assert np.all(far.absolute > 50 * decimals * modules)


def test_the_printed_error_is_off_in_sign_and_factor() -> None:
    name, way = "tooth_thickness.thickness_error", "printed (1), steps 5 and 6"
    arguments = (np.array([0.025, 0.0]), np.array([0.0, 0.01]), np.full(2, np.pi / 9))
    errors, exact = run(name, way, arguments), truth_of(name, arguments).high
    # -2.0013 times the effect of the tip; the gauge's height within a thousandth.
    assert errors.absolute[0] == pytest.approx(3.0013 * abs(exact[0]), rel=1e-3)
    assert errors.absolute[1] < 1e-3 * abs(exact[1])


# Readings far from zero


def scattered(offset: float, rows: int = 30) -> Arguments:
    return (np.random.default_rng(4).normal(size=(rows, 12)) + offset,)


@pytest.mark.parametrize(("offset", "digits"), [(1e3, 6), (1e5, 10), (1e7, 14)])
def test_one_pass_loses_twice_the_digits_of_the_offset(offset: float, digits: int) -> None:
    worst = np.max(run(DEVIATION, "one pass", scattered(offset)).scaled)
    # The square of the offset, over the variance, over the sums' growth: within a digit or two.
    assert abs(np.log10(worst) - digits) < 2
    assert np.max(run(DEVIATION, "evaluate_type_a", scattered(offset)).scaled) <= 16


def test_one_pass_has_nothing_left_beyond_the_root_of_eps() -> None:
    """From an offset of 1/sqrt(eps) on the squares have no digit of the scatter."""
    for offset in (1 / np.sqrt(EPS), 1e10, 1e15):
        assert np.min(run(DEVIATION, "one pass", scattered(offset)).bits) > 44


def test_two_passes_lose_the_rounding_of_the_mean() -> None:
    """Its square, (eps*offset)**2, is added to the variance."""
    assert np.max(run(DEVIATION, "np.std", scattered(1e6)).scaled) < 16
    for offset in (1e10, 1e12, 1e14):
        expected = (EPS * offset) ** 2 / EPS
        worst = np.max(run(DEVIATION, "np.std", scattered(offset)).scaled)
        assert expected / 1000 < worst < 10 * expected
        assert np.max(run(DEVIATION, "evaluate_type_a", scattered(offset)).scaled) <= 16


def test_squares_that_underflow_are_lost_by_both() -> None:
    tiny = tuple(row * 1e-200 for row in scattered(0.0))
    for way in ("one pass", "np.std"):
        assert np.min(run(DEVIATION, way, tiny).bits) > 50
    assert np.max(run(DEVIATION, "evaluate_type_a", tiny).scaled) <= 16
