"""Shares of rightly and wrongly accepted and rejected parts against rigorous ball integrals."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest
from cases import BAR, HARD, INF, NAMES, Find, four, random_case, random_sets
from enclosures import relative_errors
from flint import arb, ctx

from mechproof.conformity import Normal, TruncatedNormal, Uniform, conformance_probability, shares
from mechproof.conformity.risks import law_masses


@pytest.mark.slow
@pytest.mark.parametrize("name", HARD)
def test_every_share_is_relatively_accurate(name: str, find: Find) -> None:
    case = HARD[name]
    assert max(relative_errors(four(case.shares(find)), case)) < BAR


@pytest.mark.slow
def test_random_sets_are_relatively_accurate_where_no_share_underflows(find: Find) -> None:
    rng = np.random.default_rng(7)
    cases = [
        case for case in (random_case(rng) for _ in range(60)) if min(four(case.shares())) > 1e-100
    ]
    assert len(cases) > 30
    assert max(max(relative_errors(four(case.shares(find)), case)) for case in cases) < BAR


def test_the_comparison_rejects_a_cancelling_formula() -> None:
    case = HARD["limits 15 sigma away"]
    got = four(case.shares())
    got[1] = 1 - got[0] - got[2] - got[3]
    assert relative_errors(got, case)[1] > BAR


@pytest.mark.slow
def test_arc_integrals_and_panel_quadrature_agree(find: Find) -> None:
    true, error, tolerance, acceptance = random_sets(1, 300)
    got = four(find(true, error, tolerance, acceptance))
    panels = law_masses(true, error, np.stack(tolerance), np.stack(acceptance))
    for value, other in zip(got, panels, strict=True):
        seen = other > 1e-250
        np.testing.assert_allclose(value[seen], other[seen], rtol=BAR)


@pytest.mark.parametrize("s", [0.01, 0.3, 2.0])
@pytest.mark.parametrize("limit", [1.0, 3.0, 8.0])
def test_uniform_part_with_a_normal_error(s: float, limit: float) -> None:
    # One-sided acceptance below 0: the tail of a normal law, integrated from limit to limit + 1.
    got = shares(Uniform(limit, limit + 1), Normal(0, s), (-INF, limit), (-INF, 0))

    def tail_moment(z: arb) -> arb:
        root = arb(2).sqrt()
        return (-z * z / 2).exp() / (root * arb.pi().sqrt()) - z * (z / root).erfc() / 2

    ctx.prec = 300
    size = arb(s) * (tail_moment(limit / arb(s)) - tail_moment((limit + 1) / arb(s)))
    ctx.prec = 53
    expected = float(size)
    if expected > 1e-290:
        # The exponent z**2 / 2 is rounded: z**2 / 2 ulp, at most 350 (8e-14).
        np.testing.assert_allclose(got.wrongly_accepted, expected, rtol=BAR)
    else:
        assert got.wrongly_accepted < 1e-290


@pytest.mark.parametrize(
    ("mean", "scatter", "tolerance", "acceptance", "sure"),
    [
        (28.0, 0.2, (-10.0, 1.0), (-10.5, INF), "wrongly_accepted"),
        (37.75, 0.1, (-INF, 0.0), (-INF, 0.0), "rightly_rejected"),
        (-37.75, 0.1, (0.0, INF), (0.0, INF), "rightly_rejected"),
    ],
)
def test_endless_windows_among_the_smallest_numbers(
    find: Find, mean: float, scatter: float, tolerance: Any, acceptance: Any, sure: str
) -> None:
    """Tails that have lost their digits cancel; windows without an end are not integrated."""
    found = find(Normal(mean, 1.0), Normal(0.0, scatter), tolerance, acceptance)
    assert getattr(found, sure) == 1.0
    assert all(0 <= getattr(found, name) < 1e-100 for name in NAMES if name != sure)


# Multiples of this stay exact when added to 1e8.
GRID = 2.0**-26


def on_grid(rng: np.random.Generator, low: float, high: float) -> float:
    """Return an even multiple of `GRID`, so that half of it is also a multiple."""
    return float(np.round(1e-3 * rng.uniform(low, high) / GRID / 2) * GRID * 2)


def random_law(rng: np.random.Generator, kind: type, at: float) -> Any:
    """Draw a law of this kind near `at`, about 1e-3 wide."""
    mean, half = at + on_grid(rng, -1, 1), on_grid(rng, 0.2, 1)
    places = {Normal: (mean, half), Uniform: (mean - half, mean + half)}
    return kind(*places.get(kind, (mean, half, mean - half, mean + half / 2)))


@pytest.mark.slow
@pytest.mark.parametrize("kinds", [*product((Normal, Uniform, TruncatedNormal), repeat=2)])
@pytest.mark.parametrize(("place", "bias"), [(1e3, 0.0), (1e8, 0.0), (0.0, 1e8), (1e8, -(2.0**26))])
def test_a_common_offset_costs_no_digits(
    find: Find, kinds: tuple[type, type], place: float, bias: float
) -> None:
    rng = np.random.default_rng([int(place), int(abs(bias))])
    for _ in range(5):
        half, guard = on_grid(rng, 0.5, 1), on_grid(rng, 0, 0.3)
        state = rng.bit_generator.state
        found = []
        for y, e in ((0.0, 0.0), (place, bias)):
            rng.bit_generator.state = state
            laws = random_law(rng, kinds[0], y), random_law(rng, kinds[1], e)
            accepted = y + e - half + guard, y + e + half - guard
            found.append(four(find(*laws, (y - half, y + half), accepted)))
        np.testing.assert_allclose(found[1], found[0], rtol=BAR)


def area(low: Fraction, high: Fraction, window: Any, inside: Any) -> Fraction:
    """Integrate, over y from low to high, the length of `inside` - y within `window`."""

    def part(y: Fraction) -> Fraction:
        start, end = max(window[0], inside[0] - y), min(window[1], inside[1] - y)
        return max(end - start, Fraction(0))

    cuts = sorted({low, high, *(c for i in inside for w in window if low < (c := i - w) < high)})
    # Between the cuts the length is linear in y.
    return sum(((part(a) + part(b)) * (b - a) / 2 for a, b in pairwise(cuts)), Fraction(0))


@pytest.mark.parametrize(("place", "bias"), [(0.0, 0.0), (1e3, 0.0), (1e8, 777.0), (1e-3, -1e8)])
def test_rectangular_laws_at_any_place_against_areas(find: Find, place: float, bias: float) -> None:
    rng = np.random.default_rng(5)
    for _ in range(20):
        shape = rng.uniform(0.5, 1, 6) * 1e-3
        y, e = (place - shape[0], place + shape[1]), (bias - shape[2], bias + shape[3])
        tolerance = place - shape[4], place + shape[5]
        accepted = place + bias - shape[5], place + bias + shape[4]
        found = four(find(Uniform(*y), Uniform(*e), tolerance, accepted))
        y_, e_, t_, a_ = (tuple(map(Fraction, pair)) for pair in (y, e, tolerance, accepted))
        unit = (y_[1] - y_[0]) * (e_[1] - e_[0])
        both = area(max(y_[0], t_[0]), min(y_[1], t_[1]), e_, a_) / unit
        good = (min(y_[1], t_[1]) - max(y_[0], t_[0])) / (y_[1] - y_[0])
        taken = area(*y_, e_, a_) / unit
        exact = both, taken - both, 1 - good - taken + both, good - both
        np.testing.assert_allclose(found, [float(share) for share in exact], rtol=BAR)


@pytest.mark.parametrize("place", [1e3, 1e8])
def test_conformance_probabilities_keep_their_digits_at_any_place(place: float) -> None:
    measured, half = 3 * GRID, 1024 * GRID
    found, expected = (
        conformance_probability(
            at + measured, Normal(at, 512 * GRID), Normal(0, 300 * GRID), (at - half, at + half)
        )
        for at in (place, 0.0)
    )
    np.testing.assert_allclose(found, expected, rtol=BAR)
