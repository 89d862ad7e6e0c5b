"""The linkage in the laboratory: its truth and scales, and where each specimen fails."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import mpmath as mp
import numpy as np
import pytest

from mechproof.kernels import wedge_linkage as kernels
from mechproof.lab.error import Errors, find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.points import REPORT, draw_points, list_sets
from mechproof.lab.search import find_worst, within_bar
from mechproof.lab.specimen import Arguments, Specimen
from mechproof.lab.specimens import wedge_loads as loads
from mechproof.lab.specimens import wedge_points as points
from mechproof.lab.subject import Subject, find_subjects, judge_specimen

EPS = float(np.finfo(float).eps)
SUBJECTS = {s.quantity.name: s for s in find_subjects(("wedge_linkage",))}
CHAIN = ("position", "velocity", "sensitivities")
FRESH = 4711


def form(quantity: str, name: str) -> Specimen:
    return next(s for s in SUBJECTS[quantity].specimens if s.name == name)


def errors(quantity: str, name: str, arguments: Arguments) -> Errors:
    truth = find_truth(SUBJECTS[quantity], arguments)
    assert truth.undecided == 0
    with np.errstate(all="ignore"):
        return find_errors(form(quantity, name).compute(*arguments), truth)


@cache
def drawn(quantity: str, name: str) -> Arguments:
    point_set = next(s for s in list_sets(SUBJECTS[quantity]) if s.name == name)
    return draw_points(point_set, REPORT)


@cache
def thinned(name: str) -> Subject:
    """Keep every sixth point of each set, of the ten sensitivities fewer."""
    subject, step = SUBJECTS[name], 20 if name == "sensitivities" else 6
    sets = (
        replace(s, make=lambda rng, make=s.make: tuple(a[::step] for a in make(rng)))
        for s in list_sets(subject)
    )
    return replace(subject, study=replace(subject.study, sets=tuple(sets)))


@pytest.mark.parametrize("name", SUBJECTS)
def test_every_point_of_the_sets_is_decided_and_keeps_the_bar(name: str) -> None:
    subject = thinned(name)
    for point_set in list_sets(subject):
        arguments = draw_points(point_set, REPORT)
        truth = find_truth(subject, arguments)
        assert truth.undecided == 0, point_set.name
        # At x5 = 0 value and scale are 0, of which the form alone decides the value.
        still = np.reshape(truth.high == 0, (len(truth.decided), -1)).all(axis=1)
        assert (np.isfinite(truth.scale) | still).all(), point_set.name
        scaled = find_errors(subject.kernel(*arguments), truth).scaled
        assert subject.quantity.bar is not None
        assert np.max(scaled[within_bar(subject, arguments) & truth.decided]) <= (
            subject.quantity.bar.ulp
        )


@pytest.mark.parametrize("name", SUBJECTS)
def test_a_fresh_search_stays_within_the_bar(name: str) -> None:
    subject = thinned(name)
    found = find_worst(subject, subject.kernel, rounds=2, seed=FRESH)
    assert subject.quantity.bar is not None
    assert found.scaled <= subject.quantity.bar.ulp


# The truth


def position_by_vectors(
    x1: mp.mpf,
    l_ab: mp.mpf,
    l_bc: mp.mpf,
    l_cd: mp.mpf,
    l_de: mp.mpf,
    l_gh: mp.mpf,
    l_kl: mp.mpf,
    l_lm: mp.mpf,
    alpha_de: mp.mpf,
    alpha_kl: mp.mpf,
    alpha_lm: mp.mpf,
) -> mp.mpf:
    """Turn complex numbers: AD from its parts along and across the guide, KL by its cosine."""
    from_a_to_d = mp.mpc(-(l_ab + l_cd) - x1, -l_bc)
    guide = mp.sqrt(abs(from_a_to_d) ** 2 - (l_ab + l_cd) ** 2)
    turn = from_a_to_d / mp.mpc(-(l_ab + l_cd), -guide)
    run = l_de * (mp.expj(alpha_de) * (turn / abs(turn) - 1)).real
    roller = mp.acos(mp.cos(alpha_kl) - max(run - l_gh, 0) / l_kl) - alpha_kl
    return l_lm * (mp.expj(alpha_lm) * (mp.expj(roller) - 1)).imag


def slope(index: int, point: list[mp.mpf]) -> mp.mpf:
    """Differentiate by one argument: the step of 1e-20 leaves 1e-40 of third derivatives."""
    step = mp.mpf(10) ** -20
    ends = ([*point[:index], point[index] + s, *point[index + 1 :]] for s in (step, -step))
    high, low = (position_by_vectors(*end) for end in ends)
    return (high - low) / (2 * step)


def some_points(count: int) -> Arguments:
    """Return points of the working stroke in contact."""
    drawn_points = drawn("position", "limit combinations")
    return tuple(a[drawn_points[0] < -5][:count] for a in drawn_points)


def test_the_truth_is_that_of_turned_vectors() -> None:
    arguments = some_points(12)
    truth = {name: find_truth(SUBJECTS[name], arguments) for name in CHAIN}
    with mp.workdps(70):
        for i, row in enumerate(np.transpose(arguments)):
            point = [mp.mpf(float(v)) for v in row]
            expected = {
                "position": [position_by_vectors(*point)],
                "velocity": [slope(0, point)],
                "sensitivities": [slope(j, point) for j in range(1, 11)],
            }
            for name, values in expected.items():
                highs, lows = (np.ravel(part[i]) for part in (truth[name].high, truth[name].low))
                for high, low, value in zip(highs, lows, values, strict=True):
                    gap = abs(mp.mpf(float(high)) + mp.mpf(float(low)) - value)
                    # Two doubles hold 2**-106; the differences are off by some 1e-38.
                    assert gap <= 2.0**-100 * (1 + abs(value)), name


def test_the_scales_are_the_conditioning() -> None:
    arguments = some_points(4)
    scales = {name: find_truth(SUBJECTS[name], arguments).scale for name in CHAIN}
    with mp.workdps(70):
        for i, row in enumerate(np.transpose(arguments)):
            point = [mp.mpf(float(v)) for v in row]
            value = position_by_vectors(*point)
            expected = abs(value) + sum(abs(p * slope(j, point)) for j, p in enumerate(point))
            assert scales["position"][i] == pytest.approx(float(expected), rel=1e-8)
            each = [condition_of_slope(j, point) for j in range(11)]
            assert scales["velocity"][i] == pytest.approx(float(each[0]), rel=1e-8)
            norm = mp.norm(each[1:])
            assert scales["sensitivities"][i] == pytest.approx(float(norm), rel=1e-8)


def condition_of_slope(index: int, point: list[mp.mpf]) -> mp.mpf:
    """|slope| + sum of |p * d slope/d p|, by differences of differences."""
    step, total = mp.mpf(10) ** -12, abs(slope(index, point))
    for j, p in enumerate(point):
        ends = ([*point[:j], p + s, *point[j + 1 :]] for s in (step, -step))
        high, low = (slope(index, end) for end in ends)
        total += abs(p * (high - low) / (2 * step))
    return total


# Where specimens fail


def test_the_printed_lever_is_off_by_pi_past_the_right_angle() -> None:
    arguments = drawn("lever_angle", "past the pivot")
    exact = kernels.lever_angle(*arguments)
    past = np.abs(exact) > np.pi / 2
    assert 0 < past.sum() < past.size
    off = errors("lever_angle", "printed (1)", arguments).absolute
    assert np.allclose(off[past], np.pi, rtol=1e-9)
    assert np.all(off[~past] < 1e-12)
    for name in ("(1) with atan2", "kernel"):
        assert np.max(errors("lever_angle", name, arguments).absolute) < 1e-14


@pytest.mark.parametrize(
    ("quantity", "rest", "names"),
    [
        ("lever_angle", (6.25, 49.75, 38.0), ("printed (1)", "(1) with atan2")),
        ("roller_lever_angle", (60.0, 1.13), ("printed (7), (8)", "atan2", "arccosine")),
    ],
)
def test_angles_lose_a_digit_for_each_decade_of_small_motion(
    quantity: str, rest: tuple[float, ...], names: tuple[str, ...]
) -> None:
    for name in (*names, "kernel"):
        lost = []
        for exponent in (3, 6, 9, 12):
            moved = np.linspace(1, 2, 20) * 10.0**-exponent
            bits = errors(quantity, name, (moved, *map(np.array, rest))).bits
            lost.append(float(np.max(bits)))
        if name == "kernel":
            assert max(lost) < 2
        else:
            # Three decades are 10 bits.
            assert np.all(np.abs(np.diff(lost) - 9.97) < 3), (name, lost)


def test_the_hole_at_r_zero() -> None:
    alpha = np.linspace(0.3, 1.3, 40)
    arguments = 60 * np.cos(alpha), np.full(40, 60.0), alpha
    # R = 0 as computed, everywhere: what is printed has no value, a single condition takes (8).
    assert np.isnan(form("roller_lever_angle", "printed (7), (8)").compute(*arguments)).all()
    off = errors("roller_lever_angle", "(7) or else (8)", arguments).absolute
    assert np.allclose(off, np.pi, rtol=1e-12)
    for name in ("atan2", "arccosine", "kernel"):
        assert np.max(errors("roller_lever_angle", name, arguments).absolute) < 1e-15 * np.pi
    beside = (np.nextafter(arguments[0], 0), *arguments[1:])
    assert np.max(errors("roller_lever_angle", "printed (7), (8)", beside).absolute) < 1e-14


def test_a_nearly_level_roller_lever_loses_two_digits_for_each_decade() -> None:
    """cos(alpha_KL) keeps eps of one, of which alpha_KL**2/2 is left."""
    for name in ("arccosine", "atan2", "kernel"):
        lost = []
        for exponent in (1, 3, 5):
            alpha = np.linspace(1, 2, 20) * 10.0**-exponent
            x5 = -60 * np.sin(alpha / 2) ** 2
            found = errors("roller_lever_angle", name, (x5, np.full(20, 60.0), alpha))
            lost.append(float(np.log2(1 + np.max(found.scaled))))
        if name == "kernel":
            assert max(lost) < 1
        else:
            # Two decades are 13.3 bits.
            assert np.all(np.abs(np.diff(lost) - 13.3) < 4), (name, lost)


def test_a_dead_centre_is_overrun_by_rounding() -> None:
    arguments = drawn("roller_lever_angle", "toward dead centres")
    for name in ("printed (7), (8)", "(7) or else (8)", "atan2"):
        result = errors("roller_lever_angle", name, arguments).result
        # R rounds to more than l_KL, and the root is that of a negative number.
        assert np.isnan(result).any(), name
    assert np.max(errors("roller_lever_angle", "arccosine", arguments).scaled) > 1e6
    assert np.max(errors("roller_lever_angle", "kernel", arguments).scaled) < 1


def test_the_printed_chain_is_lost_where_the_lever_is() -> None:
    arguments = drawn("position", "generic")
    past = np.abs(kernels.lever_angle(*arguments[:4])) > np.pi / 2
    far = errors("position", "printed chain", arguments).scaled > 1e6
    assert past.any()
    # Past the right angle; but where the rod stays free of the link 5' all is zero.
    assert not far[~past].any()
    assert far[past].any()
    assert np.max(errors("position", "chain with atan2", arguments).scaled) < 100


def test_small_motion_of_the_chain() -> None:
    arguments = tuple(a[::3] for a in drawn("position", "small motion"))
    for name in ("printed chain", "chain with atan2", "sympy.lambdify, cse"):
        assert np.max(errors("position", name, arguments).scaled) > 1e12, name
    assert np.max(errors("velocity", "product of slopes", arguments).scaled) > 1e12
    for name in ("position", "velocity"):
        assert np.max(errors(name, "kernel", arguments).scaled) < 1


def test_before_contact_only_ours_is_zero() -> None:
    arguments = drawn("position", "generic")
    exact = find_truth(SUBJECTS["position"], arguments).high
    rest = tuple(a[exact == 0] for a in arguments)
    assert rest[0].size > 5
    assert not form("position", "kernel").compute(*rest).any()
    for name in ("printed chain", "chain with atan2"):
        # An arctangent less a direction, both of some unit: not zero, but next to it.
        moved = form("position", name).compute(*rest)
        assert 0 < np.max(np.abs(moved[np.abs(moved) < 1])) < 1e-12, name


def test_where_the_definition_stays_wide_the_form_decides() -> None:
    """Nothing moves: x5 = 0, before contact, and an arm that comes level again."""
    standing = {
        "roller_lever_angle": (0.0, 60.0, 1.13),
        "rod_displacement": (0.75, 83.0, -0.375),
        "position": (-0.5, *points.NOMINAL[0]),
    }
    for name, row in standing.items():
        truth = find_truth(SUBJECTS[name], tuple(np.array([v]) for v in row))
        assert truth.decided.all(), name
        assert truth.high.tolist() == truth.low.tolist() == [0.0]
    # Out of reach the definition has no value, whatever the form would give.
    far = tuple(np.array([v]) for v in (200.0, 60.0, 1.13))
    assert find_truth(SUBJECTS["roller_lever_angle"], far).undecided == 1


def test_differences_keep_half_of_the_digits() -> None:
    arguments = tuple(a[::8] for a in drawn("velocity", "limit combinations"))
    # eps/h of some 100 mm is 1e-10, h**2/6 of the third derivative less.
    for quantity, name in (
        ("velocity", "central difference"),
        ("sensitivities", "central differences"),
    ):
        in_contact = np.asarray(arguments[0]) < -5
        off = errors(quantity, name, tuple(a[in_contact] for a in arguments)).absolute
        assert 1e-12 < np.max(off) < 1e-5


def test_derivatives_are_unsure_only_next_to_the_edge() -> None:
    """Every jump is marked, and what is marked is within 1000 ulps of the edge."""
    arguments = drawn("velocity", "clearance's edge")
    sure = points.off_the_edge(*arguments)
    jumps = errors("velocity", "kernel", arguments).scaled > 1
    assert jumps.any()
    assert not (jumps & sure).any()
    run = points.run_of(arguments[0], np.array(arguments[1:]))
    clearance = arguments[1 + points.L_GH]
    assert np.all(np.abs(run - clearance)[~sure] <= 2000 * np.spacing(clearance[~sure]))


def test_the_search_sees_a_planted_fault() -> None:
    subject = thinned("position")
    assert subject.quantity.bar is not None

    def faulty(x1: np.ndarray, *sizes: np.ndarray) -> np.ndarray:
        y9 = np.asarray(subject.kernel(x1, *sizes))
        return np.where(x1 < -30, y9 * (1 + 1e-12), y9)

    found = find_worst(subject, faulty, rounds=1, seed=FRESH)
    assert found.scaled > 10 * subject.quantity.bar.ulp
    assert found.arguments[0] < -30


# Rows and loads

VERDICTS = {
    ("lever_angle", "printed (1)"): "CONDITIONAL",
    ("lever_angle", "(1) with atan2"): "PROVED",
    ("roller_lever_angle", "printed (7), (8)"): "PROVED",
    ("roller_lever_angle", "atan2"): "PROVED",
    ("roller_lever_angle", "arccosine"): "PROVED",
    ("position", "printed chain"): "PROVED",
    ("position", "chain with atan2"): "PROVED",
    ("position", "kernel"): "PROVED",
    ("velocity", "product of slopes"): "PROVED",
    ("velocity", "sympy.lambdify, cse"): "PROVED",
}


@pytest.mark.parametrize(("quantity", "name"), VERDICTS)
def test_what_a_specimen_equals(quantity: str, name: str) -> None:
    judged = judge_specimen(SUBJECTS[quantity], form(quantity, name))
    assert judged is not None
    assert judged.verdict == VERDICTS[quantity, name]


def test_loads_close() -> None:
    for name, load in loads.POSITION_LOADS:
        for count in (16, 1000):
            arguments = load(count)
            assert np.isfinite(kernels.position(*arguments)).all(), name
    columns = loads.combinations(1024)[1:]
    assert len(np.unique(np.transpose(columns), axis=0)) == 256


@pytest.mark.parametrize("x1", [(0.0, 1.0), (20.0, points.STROKE)])
def test_cells_keep_to_their_sizes(x1: tuple[float, float]) -> None:
    drawn_points = points.in_cell(np.random.default_rng(1), {"x1": x1})
    size = np.abs(drawn_points[0])
    assert (size.min(), size.max()) == x1
    assert np.isfinite(kernels.position(*drawn_points)).all()
