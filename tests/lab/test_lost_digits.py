"""Tables of places where rivals of a kernel lose digits.

The kernel has none of these losses at the same points.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from ways import (
    CYLINDRICAL,
    ELLIPTIC,
    EPS,
    HEIGHT,
    OVAL,
    SPUR,
    THICKNESS,
    WHEEL,
    at,
    bound_of,
    compare,
    draw_set,
    find_subject,
    run,
    sum_up,
    sweep,
    truth_of,
)

from mechproof.lab.ways import Arguments
from mechproof.lab.worst_search import mark_accuracy_domain


@dataclass(frozen=True)
class Loss:
    """Ways that lose `bits` more, up to `within`, from each place of a ladder to the next."""

    quantity: str
    ladder: tuple[Arguments, ...]
    bits: float
    within: float
    ways: tuple[str, ...]


def approach_one(*exponents: int, start: float, before: tuple[float, ...] = ()) -> Iterator[Any]:
    """Yield angles from one to three times the width of the peak, as e approaches 1."""
    for exponent in exponents:
        e = 1 - 10.0**-exponent
        yield np.linspace(1, 3, 40) * (1 - e) * start, *map(np.array, before), np.array(e)


def shrink(*exponents: int, sizes: tuple[float, ...]) -> tuple[Arguments, ...]:
    return tuple(at(np.linspace(1, 2, 20) * 10.0**-exponent, *sizes) for exponent in exponents)


SPURS = tuple(approach_one(2, 4, 6, 8, start=16 / 66, before=(66.0, 16.0)))
PEAKS = tuple(approach_one(2, 4, 6, start=0.5, before=(32.0, 18.0)))
MOUNTED = tuple((*a, np.array(0.0)) for a in approach_one(2, 4, 6, start=0.5, before=(0.2,)))
# Where 1 - e cos x is 1 - e it has an error of eps, and its square loses twice as many digits; two
# decades of 1 - e are 6.6 bits. In a difference of lengths three decades of motion are 10 bits.
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


@pytest.mark.slow
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


# Ways, and sets on which they lose that many eps of the scale; there the kernel keeps its bound.
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


@pytest.mark.slow
@pytest.mark.parametrize(("quantity", "way", "name", "eps"), LOST)
def test_digits_are_lost_on_a_set(quantity: str, way: str, name: str, eps: float) -> None:
    arguments = draw_set(quantity, name, 0.1)
    held = (
        mark_accuracy_domain(find_subject(quantity), arguments)
        & truth_of(quantity, arguments).decided
    )
    lost, kept = (compare(quantity, w, arguments).scaled[held] for w in (way, "kernel"))
    assert np.max(lost) > eps
    assert np.max(kept) <= bound_of(quantity)


def test_a_direct_turn_loses_half_the_digits() -> None:
    """1 - cos appears next to sin: worst where the square of the angle is eps."""
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
    """Its rounding error of one eps is added to a first-order term as small as the tilt.

    The loss is worst at 1e-8: below, cos(tilt) is rounded to 1, and 1 - cos(tilt) is exactly 0.
    """
    tilts = np.geomspace(1e-12, 1e-3, 30)
    lost = run(HEIGHT, "sympy.lambdify, cse", at(tilts, *WHEEL)).bits
    assert 20 < np.max(lost) < 30
    assert 1e-9 < tilts[np.argmax(lost)] < 1e-7
    assert np.max(run(HEIGHT, "kernel", at(tilts, *WHEEL)).bits) < 4


def test_leads_cancel_where_the_output_rests() -> None:
    """Equal ovals side by side: the leads of the two pairs are opposite to each other."""
    arguments = at(np.linspace(0.1, 1.4, 50), 0.475, 0.475, np.pi / 2 + 1e-9)
    assert sum_up(OVAL, "leads by atan2, 1 - e cos 2 phi", arguments).worst_ulp > 2**20


def test_without_the_low_word_digits_go_with_the_angle() -> None:
    """The rounded product is off by eps*|x|, which the peak amplifies to eps*|x|/(1 - e2)."""
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


def test_the_root_of_a_difference_loses_what_the_share_takes() -> None:
    """The share is 1 - 1e-12 of the total: four digits of the difference of squares are left."""
    one = np.ones((1, 6))
    whole = np.array([1.2]), np.array([(1 - 1e-12) / 1.7]), np.array([1.2 * 1.7])
    arguments = np.full((1, 6), 0.1), one, one, *whole
    by_hand = run("track_wheel.error_sum_thermal", "difference of squares", arguments)
    ours = run("track_wheel.error_sum_thermal", "kernel", arguments)
    assert ours.scaled[0] <= 9
    assert by_hand.bits[0] > 30


def test_single_precision_keeps_24_bits() -> None:
    worst = sum_up(ELLIPTIC, "kernel, float32", sweep(1, 200, *SPUR)).worst_ulp
    assert 2**25 < worst < 2**40
