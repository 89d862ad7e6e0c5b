"""Chords of the tooth: where the direct formulas lose digits, and what the linear models miss."""

from __future__ import annotations

from functools import cache

import mpmath as mp
import numpy as np
import pytest

from mechproof.lab.bounds import bound_over
from mechproof.lab.error import Errors, find_errors
from mechproof.lab.oracle import find_truth
from mechproof.lab.points import REPORT, draw_points, list_sets
from mechproof.lab.search import find_worst
from mechproof.lab.specimen import Arguments, Specimen
from mechproof.lab.subject import Subject, find_subjects, judge_specimen

SYSTEM = "tooth_thickness"
WHEEL = tuple(map(np.array, (3.0, 50.0, np.pi / 9)))


@cache
def subject(name: str) -> Subject:
    (found,) = find_subjects((f"{SYSTEM}.{name}",))
    return found


def form(quantity: str, name: str) -> Specimen:
    return next(s for s in subject(quantity).specimens if s.name == name)


def run(quantity: str, name: str, arguments: Arguments) -> Errors:
    truth = find_truth(subject(quantity), arguments)
    assert truth.undecided == 0
    with np.errstate(all="ignore"):
        return find_errors(form(quantity, name).compute(*arguments), truth)


def test_the_oracle_equals_mpmath_on_the_polar_involute() -> None:
    tilts = np.array([-0.3, -1e-8, 1e-100, 0.02, 0.2])
    heights, chords = (
        find_truth(subject(n), (tilts, *WHEEL)) for n in ("height_change", "thickness_change")
    )
    with mp.workdps(140):
        m, z, alpha = (mp.mpf(float(v)) for v in WHEEL)
        base, start = m * z * mp.cos(alpha) / 2, mp.pi / (2 * z) + mp.tan(alpha) - alpha

        def place(tilt: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
            roll = alpha + tilt + start
            radius, angle = base * mp.sqrt(1 + roll**2), start - roll + mp.atan(roll)
            return radius * mp.cos(angle), 2 * radius * mp.sin(angle)

        for i, tilt in enumerate(tilts):
            (first, chord), (distance, other) = place(mp.mpf(0)), place(mp.mpf(float(tilt)))
            for truth, exact in ((heights, first - distance), (chords, other - chord)):
                found = mp.mpf(float(truth.high[i])) + mp.mpf(float(truth.low[i]))
                assert abs(found - exact) <= abs(exact) * mp.mpf(2) ** -65


@pytest.mark.parametrize("name", [s.quantity.name for s in find_subjects((SYSTEM,))])
def test_ours_keeps_the_bar_on_every_set(name: str) -> None:
    bar = subject(name).quantity.bar
    assert bar is not None
    for point_set in list_sets(subject(name)):
        points = tuple(a[::3] for a in draw_points(point_set, REPORT))
        assert np.max(run(name, "kernel", points).scaled) <= bar.ulp, point_set.name


@pytest.mark.parametrize("name", ["height_change", "thickness_change", "linearisation_bound"])
def test_a_fresh_search_stays_within_the_bar(name: str) -> None:
    found = find_worst(subject(name), subject(name).kernel, rounds=2, seed=4711)
    bar = subject(name).quantity.bar
    assert bar is not None
    assert 0.3 < found.scaled <= bar.ulp


@pytest.mark.parametrize(
    ("quantity", "direct"),
    [
        ("height_change", "difference of two distances"),
        ("thickness_change", "difference of two chords"),
    ],
)
def test_a_difference_loses_what_the_tilt_is_small(quantity: str, direct: str) -> None:
    """Two numbers near 70 mm are subtracted: three decades of the tilt are ten bits."""
    lost = []
    for size in (1e-3, 1e-6, 1e-9, 1e-12):
        at = (np.linspace(1, 2, 20) * size, *WHEEL)
        lost.append(np.max(run(quantity, direct, at).bits))
        assert np.max(run(quantity, "kernel", at).bits) < 4
    assert np.all(np.abs(np.diff(lost) - 9.97) < 3), lost
    gone = run(quantity, direct, (np.array([1e-17, -1e-30, 1e-300]), *WHEEL))
    # Below the rounding of the angle nothing is left.
    assert np.all(gone.bits > 50)


def test_one_minus_cosine_loses_half_the_digits() -> None:
    """Its rounding, eps of one, stands beside a first order as small as the tilt.

    The loss is worst at 1e-8: below, cos(tilt) is one, and 1 - cos(tilt) is 0 exactly.
    """
    tilts = np.geomspace(1e-12, 1e-3, 30)
    lost = run("height_change", "sympy.lambdify, cse", (tilts, *WHEEL)).bits
    assert 20 < np.max(lost) < 30
    assert 1e-9 < tilts[np.argmax(lost)] < 1e-7
    assert np.max(run("height_change", "kernel", (tilts, *WHEEL)).bits) < 4


MODELS = (
    ("height_change", "first order in the tilt"),
    ("thickness_change", "first order in the tilt"),
    ("thickness_change", "2 tan(alpha) times the height"),
)


@pytest.mark.parametrize(("quantity", "name"), MODELS)
@pytest.mark.parametrize("largest", [1e-4, 1e-2, 0.5])
def test_linear_models_stay_within_their_proved_bounds(
    quantity: str, name: str, largest: float
) -> None:
    judged = judge_specimen(subject(quantity), form(quantity, name))
    assert judged is not None
    assert judged.verdict == "PROVED"
    box = {"tilt": (0.0, largest), "m": (0.0, 3.0), "z": (4.0, 50.0), "alpha": (0.0, 0.7)}
    bound = bound_over(subject(quantity), form(quantity, name), box)
    assert bound is not None
    alpha, sign = map(np.ravel, np.meshgrid([1e-6, 0.1, 0.35, 0.7], [-1.0, 1.0]))
    at = (sign * largest, np.full(8, 3.0), np.full(8, 50.0), alpha)
    worst = np.max(run(quantity, name, at).absolute)
    # Neither exceeded nor a hundred times too large.
    assert bound / 100 < worst <= bound


def test_a_bound_that_is_too_small_would_be_seen() -> None:
    """A fifth of the bound does not hold."""
    specimen = form("height_change", "first order in the tilt")
    box = {"tilt": (0.0, 0.1), "m": (0.0, 3.0), "z": (4.0, 50.0), "alpha": (0.0, 0.7)}
    bound = bound_over(subject("height_change"), specimen, box)
    assert bound is not None
    at = (np.array([-0.1]), np.array(3.0), np.array(50.0), np.array(1e-6))
    assert run("height_change", specimen.name, at).absolute[0] > bound / 5


def test_the_second_order_is_what_the_model_misses() -> None:
    lost = [
        run("thickness_change", "2 tan(alpha) times the height", (np.array([t]), *WHEEL))
        for t in (1e-4, 1e-3, 1e-2)
    ]
    growth = np.diff([np.log10(e.absolute[0]) for e in lost])
    assert np.all(np.abs(growth - 2) < 0.05)


@pytest.mark.parametrize(
    ("quantity", "name", "decimals"),
    [("constant_chord", "1.387 m", 5e-4), ("chord_height", "0.7476 m", 5e-5)],
)
def test_printed_numbers_are_for_twenty_degrees(quantity: str, name: str, decimals: float) -> None:
    modules = np.geomspace(0.1, 50, 12)
    right = run(quantity, name, (modules, np.full(12, np.pi / 9)))
    assert np.all(right.absolute <= decimals * modules)
    # A quarter of a degree more shows in the last decimal, and five degrees in the first.
    near = run(quantity, name, (modules, np.full(12, np.pi / 9 + 0.005)))
    assert np.all(near.absolute > decimals * modules)
    far = run(quantity, name, (modules, np.full(12, np.pi * 25 / 180)))
    assert np.all(far.absolute > 50 * decimals * modules)


def test_the_printed_error_is_off_in_sign_and_factor() -> None:
    at = (np.array([0.025, 0.0]), np.array([0.0, 0.01]), np.full(2, np.pi / 9))
    errors = run("thickness_error", "printed", at)
    exact = find_truth(subject("thickness_error"), at).high
    # -2.0013 times the effect of the tip; the gauge's height within a thousandth.
    assert errors.absolute[0] == pytest.approx(3.0013 * abs(exact[0]), rel=1e-3)
    assert errors.absolute[1] < 1e-3 * abs(exact[1])
    judged = judge_specimen(subject("thickness_error"), form("thickness_error", "printed"))
    assert judged is not None
    assert judged.verdict == "REFUTED"
