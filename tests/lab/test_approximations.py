"""Approximations stay within their bounds, and so do numbers and models that papers print."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pytest
from ways import (
    ELLIPTIC,
    EPS,
    HEIGHT,
    SPUR,
    THICKNESS,
    WHEEL,
    at,
    find_subject,
    find_way,
    run,
    sum_up,
    sweep,
    truth_of,
)

from mechproof.lab.subject import find_subjects
from mechproof.lab.ways import Arguments
from mechproof.lab.worst_search import bound_approximation


@dataclass(frozen=True)
class Bounded:
    """An approximation in a box: its worst error lies between a part of its bound and the bound.

    `part` is the largest ratio of bound to error; `rounding` is what doubles add to the error.
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
        # Rounding of some 70 terms and sums, on values up to 35.
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


BOUNDED = tuple(list_bounded())


def bound_in(row: Bounded) -> float:
    bound = bound_approximation(
        find_subject(row.quantity), find_way(row.quantity, row.way), row.box
    )
    assert bound is not None
    return bound


@pytest.mark.slow
@pytest.mark.parametrize("row", BOUNDED, ids=lambda row: f"{row.quantity}, {row.way}, {row.box}")
def test_approximations_stay_within_their_proved_bounds(row: Bounded) -> None:
    bound, worst = bound_in(row), sum_up(row.quantity, row.way, row.arguments).worst_absolute
    # Neither exceeded nor far too large.
    assert worst <= bound + row.rounding
    assert worst > bound / row.part or bound < row.rounding


def test_every_approximation_is_in_the_table() -> None:
    bounded = {
        (s.name, f.name) for s in find_subjects() for f in s.quantity.rivals if f.bound is not None
    }
    assert {(row.quantity, row.way) for row in BOUNDED} == bounded


def test_a_bound_that_is_too_small_would_be_seen() -> None:
    """The bound for eight terms does not hold for four, nor a fifth of the linear model's bound."""
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
    # The grid may miss a percent of the maximum; rounding at the knots is a few eps of 2*pi.
    assert worst.worst_absolute <= 1.01 * bound + 1e-14


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
