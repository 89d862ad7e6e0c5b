"""The linkage in the laboratory: its truth and scales, and where each rival fails."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np
import pytest
from ways import find_subject, find_way, run, truth_of

from mechproof.kernels import wedge_linkage as kernels
from mechproof.lab.oracle import Errors, find_errors
from mechproof.lab.ways import Arguments
from mechproof.lab.worst_search import mark_accuracy_domain

CHAIN = ("position", "velocity", "sensitivities")
NOMINAL = (6.25, 49.75, 38.0, 83.0, 2.0, 60.0, 145.0, 4.94, 1.13, 2.155)


# A guide so short that the lever turns past the right angle, and a rod that fits.
SHORT = (6.25, 19.75, 38.0, 20.0, 2.0, 60.0, 145.0, 4.94, 1.13, 2.155)
OVER = np.concatenate([np.linspace(-120, -85, 30), np.linspace(-4, -0.5, 10)])


def errors(quantity: str, way: str, arguments: Arguments) -> Errors:
    return run(f"wedge_linkage.{quantity}", way, arguments)


def working(count: int) -> Arguments:
    """Return points of the working stroke in contact, with sizes varied by up to a percent."""
    rng = np.random.default_rng(9)
    sizes = np.array(NOMINAL) * (1 + 0.01 * rng.uniform(-1, 1, (count, len(NOMINAL))))
    return rng.uniform(-38, -5, count), *sizes.T


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
    """Return the position from turned complex numbers: AD from its parts, KL from its cosine."""
    from_a_to_d = mp.mpc(-(l_ab + l_cd) - x1, -l_bc)
    guide = mp.sqrt(abs(from_a_to_d) ** 2 - (l_ab + l_cd) ** 2)
    turn = from_a_to_d / mp.mpc(-(l_ab + l_cd), -guide)
    run = l_de * (mp.expj(alpha_de) * (turn / abs(turn) - 1)).real
    roller = mp.acos(mp.cos(alpha_kl) - max(run - l_gh, 0) / l_kl) - alpha_kl
    return l_lm * (mp.expj(alpha_lm) * (mp.expj(roller) - 1)).imag


def slope(index: int, point: list[mp.mpf]) -> mp.mpf:
    """Return the central difference in one argument, off by 1e-40 times third derivatives."""
    step = mp.mpf(10) ** -20
    ends = ([*point[:index], point[index] + s, *point[index + 1 :]] for s in (step, -step))
    high, low = (position_by_vectors(*end) for end in ends)
    return (high - low) / (2 * step)


def test_the_truth_is_that_of_turned_vectors() -> None:
    arguments = working(12)
    truth = {name: truth_of(f"wedge_linkage.{name}", arguments) for name in CHAIN}
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
                    # Two doubles resolve 2**-106; the differences are off by some 1e-38.
                    assert gap <= 2.0**-100 * (1 + abs(value)), name


def test_the_scales_are_the_conditioning() -> None:
    arguments = working(4)
    scales = {name: truth_of(f"wedge_linkage.{name}", arguments).scale for name in CHAIN}
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
    """Return |slope| + sum of |p * d slope/d p|, by differences of differences."""
    step, total = mp.mpf(10) ** -12, abs(slope(index, point))
    for j, p in enumerate(point):
        ends = ([*point[:j], p + s, *point[j + 1 :]] for s in (step, -step))
        high, low = (slope(index, end) for end in ends)
        total += abs(p * (high - low) / (2 * step))
    return total


# Where rivals fail


@pytest.mark.slow
def test_the_printed_lever_is_off_by_pi_past_the_right_angle() -> None:
    arguments = OVER, *map(np.array, SHORT[:3])
    exact = truth_of("wedge_linkage.lever_angle", arguments).high
    past = np.abs(exact) > np.pi / 2
    assert 0 < past.sum() < past.size
    off = errors("lever_angle", "printed (1)", arguments).absolute
    assert np.allclose(off[past], np.pi, rtol=1e-9)
    for name in ("(1) with atan2", "kernel"):
        assert np.max(errors("lever_angle", name, arguments).absolute) < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize(
    ("quantity", "rest", "ways"),
    [
        ("lever_angle", (6.25, 49.75, 38.0), ("printed (1)", "(1) with atan2")),
        ("roller_lever_angle", (60.0, 1.13), ("printed (7), (8)", "atan2", "arccosine")),
    ],
)
def test_angles_lose_a_digit_for_each_decade_of_small_motion(
    quantity: str, rest: tuple[float, ...], ways: tuple[str, ...]
) -> None:
    for name in (*ways, "kernel"):
        lost = []
        for exponent in (3, 6, 9, 12):
            moved = np.linspace(1, 2, 20) * 10.0**-exponent
            lost.append(float(np.max(errors(quantity, name, (moved, *map(np.array, rest))).bits)))
        if name == "kernel":
            assert max(lost) < 2
        else:
            # Three decades are 10 bits.
            assert np.all(np.abs(np.diff(lost) - 9.97) < 3), (name, lost)


@pytest.mark.slow
def test_the_hole_at_r_zero() -> None:
    alpha = np.linspace(0.3, 1.3, 40)
    arguments = 60 * np.cos(alpha), np.full(40, 60.0), alpha
    # The computed R is 0 everywhere: the print has no value, and a single condition selects (8).
    printed = find_way("wedge_linkage.roller_lever_angle", "printed (7), (8)").compute
    with np.errstate(all="ignore"):
        assert np.isnan(printed(*arguments)).all()
    off = errors("roller_lever_angle", "(7) or else (8)", arguments).absolute
    assert np.allclose(off, np.pi, rtol=1e-12)
    for name in ("atan2", "arccosine", "kernel"):
        assert np.max(errors("roller_lever_angle", name, arguments).absolute) < 1e-15 * np.pi
    beside = (np.nextafter(arguments[0], 0), *arguments[1:])
    assert np.max(errors("roller_lever_angle", "printed (7), (8)", beside).absolute) < 1e-14


def test_a_nearly_level_roller_lever_loses_two_digits_for_each_decade() -> None:
    """cos(alpha_KL) has an error of one eps, of which alpha_KL**2/2 is left."""
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


def test_the_printed_chain_is_lost_where_the_lever_is() -> None:
    arguments = OVER, *map(np.array, SHORT)
    past = np.abs(kernels.lever_angle(*arguments[:4])) > np.pi / 2
    far = errors("position", "printed chain", arguments).scaled > 1e6
    # Where the rod does not touch link 5', everything is zero.
    assert far[past].any()
    assert not far[~past].any()
    assert np.max(errors("position", "chain with atan2", arguments).scaled) < 100


def test_small_motion_of_the_chain() -> None:
    moved = -np.logspace(-12, -9, 30)
    sizes = (*NOMINAL[:4], 1e-300, *NOMINAL[5:])
    arguments = moved, *map(np.array, sizes)
    for quantity, ways in (
        ("position", ("printed chain", "chain with atan2", "sympy.lambdify, cse")),
        ("velocity", ()),
    ):
        for way in ways:
            assert np.max(errors(quantity, way, arguments).bits) > 25, way
        assert np.max(errors(quantity, "kernel", arguments).bits) < 6


def test_before_contact_only_ours_is_zero() -> None:
    x1 = np.linspace(-0.5, -1e-6, 40)
    arguments = x1, *map(np.array, NOMINAL)
    assert not truth_of("wedge_linkage.position", arguments).high.any()
    assert not find_subject("wedge_linkage.position").kernel(*arguments).any()
    for way in ("printed chain", "chain with atan2"):
        moved = find_way("wedge_linkage.position", way).compute(*arguments)
        # An arctangent minus a direction, both of the order of 1: nearly zero, but not exactly.
        assert np.max(np.abs(moved)) < 1e-12, way


def test_where_the_definition_stays_wide_the_form_decides() -> None:
    """Nothing moves: at x5 = 0, before contact, and where an arm becomes level again."""
    standing = {
        "roller_lever_angle": (0.0, 60.0, 1.13),
        "rod_displacement": (0.75, 83.0, -0.375),
        "position": (-0.5, *NOMINAL),
    }
    for name, row in standing.items():
        truth = truth_of(f"wedge_linkage.{name}", tuple(np.array([v]) for v in row))
        assert truth.decided.all(), name
        assert truth.high.tolist() == truth.low.tolist() == [0.0]
    # Out of reach the definition has no value, whatever the form gives.
    far = tuple(np.array([v]) for v in (200.0, 60.0, 1.13))
    assert truth_of("wedge_linkage.roller_lever_angle", far).undecided == 1


def test_differences_keep_half_of_the_digits() -> None:
    # eps/h times some 100 mm is 1e-10; h**2/6 times the third derivative is less.
    for quantity, way in (
        ("velocity", "central difference"),
        ("sensitivities", "central differences"),
    ):
        assert 1e-12 < np.max(errors(quantity, way, working(6)).absolute) < 1e-5


def test_no_bound_where_the_roller_lever_hardly_follows() -> None:
    """KL is off level by less than the rounding of the rod's run: the slope may be NaN."""
    level = (
        -0.26784079663289784, 1.5279026231293567, 1092.3953956259627, 0.2136745810544649,
        3525.241417347131, 0.003523544605475815, 0.4827637386971511, 10.63721859660619,
        30.03142910895876, 0.7195765535058716, 0.016612580970271865,
    )  # fmt: skip
    arguments = tuple(np.array([v]) for v in level)
    for name in CHAIN:
        assert truth_of(f"wedge_linkage.{name}", arguments).decided.all()
        assert not mark_accuracy_domain(find_subject(f"wedge_linkage.{name}"), arguments).any()


def test_the_edge_of_contact_is_no_matter_of_rounding() -> None:
    """The run is 9e-18 short of the clearance; in doubles the definition finds a gap of 1e-13."""
    before = (
        0.0028252788543311736, 1210.8334835027838, 11.077635138896323, 2.5615589773828766,
        725.5293266128575, 0.17837839900148017, 3072.6300826144648, 1.545769415188927,
        1.7845259353701597, 3.1415923131913686, 0.42493009595807757,
    )  # fmt: skip
    arguments = tuple(np.array([v]) for v in before)
    assert truth_of("wedge_linkage.velocity", arguments).high.tolist() == [0.0]
    for name in ("velocity", "sensitivities"):
        assert not mark_accuracy_domain(find_subject(f"wedge_linkage.{name}"), arguments).any()


@pytest.mark.parametrize(
    ("name", "sizes"),
    [
        ("lever_angle", (1e200, 1.0, 1.0, 1.0)),
        ("lever_angle", (1e-170, 1e-170, 1e-170, 1e-170)),
        ("roller_lever_angle", (1e160, 1e160, 1.0)),
        ("roller_lever_angle", (1e-160, 1e-160, 0.236)),
    ],
)
def test_no_bound_where_squares_leave_the_doubles(name: str, sizes: tuple[float, ...]) -> None:
    """There the kernel's result is finite and far off, so nothing else warns of it."""
    arguments = tuple(np.array([v]) for v in sizes)
    subject = find_subject(f"wedge_linkage.{name}")
    with np.errstate(all="ignore"):
        found = find_errors(subject.kernel(*arguments), truth_of(subject.name, arguments))
    assert np.isfinite(found.result).all()
    assert subject.quantity.accuracy is not None
    assert found.scaled > subject.quantity.accuracy.ulp
    assert not mark_accuracy_domain(subject, arguments).any()


def check_bound(name: str, arguments: Arguments) -> None:
    """Check the bound at points of which at least a fifth lie where it is stated."""
    subject = find_subject(f"wedge_linkage.{name}")
    truth = truth_of(subject.name, arguments)
    held = mark_accuracy_domain(subject, arguments) & truth.decided
    assert 5 * held.sum() >= len(held)
    found = find_errors(subject.kernel(*arguments), truth)
    assert subject.quantity.accuracy is not None
    assert np.max(found.scaled[held]) <= subject.quantity.accuracy.ulp


@pytest.mark.slow
@pytest.mark.parametrize("name", ["lever_angle", "roller_lever_angle"])
def test_the_bound_holds_up_to_the_ends_of_its_range(name: str) -> None:
    rng = np.random.default_rng(20261)

    def draw(argument: str) -> Any:
        if argument.startswith("alpha"):
            return rng.uniform(0.05, 3.1, 300)
        sizes = 10.0 ** rng.choice([-50, -25, 0, 25, 50], 300)
        return sizes * rng.choice([-1, 1], 300) if argument.startswith("x") else sizes

    arguments = find_subject(f"wedge_linkage.{name}").quantity.arguments
    check_bound(name, tuple(draw(argument.name) for argument in arguments))


@pytest.mark.parametrize("scale", [5.1e-51, 6.8e47])
@pytest.mark.parametrize("name", CHAIN)
def test_the_chain_keeps_its_bound_at_the_ends_of_its_range(name: str, scale: float) -> None:
    lengths = [scale * column for column in working(6)]
    check_bound(name, (*lengths[:8], *working(6)[8:]))
