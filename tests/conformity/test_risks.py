"""Shares of parts: sums, limits, laws with a simple answer, shapes and costs."""

from __future__ import annotations

import time
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from cases import BAR, Find, four, random_sets
from scipy.integrate import quad
from scipy.special import ndtr

from mechproof.conformity import Law, Normal, TruncatedNormal, Uniform, shares
from mechproof.laws.kinds import list_parameters


def test_shares_add_up_and_mirror(find: Find) -> None:
    true, error, tolerance, acceptance = random_sets(2, 5000)
    got = four(find(true, error, tolerance, acceptance))
    # Four roundings of numbers below 1, and the shares' own errors of a few ulp each.
    np.testing.assert_allclose(np.sum(got, axis=0), 1, rtol=0, atol=2e-14)
    mirrored = find(
        Normal(-true.mean, true.std),
        Normal(-error.mean, error.std),
        (-tolerance[1], -tolerance[0]),
        (-acceptance[1], -acceptance[0]),
    )
    for value, other in zip(got, four(mirrored), strict=True):
        seen = value > 1e-250
        np.testing.assert_allclose(value[seen], other[seen], rtol=BAR)


def test_no_share_among_the_smallest_numbers_is_negative(find: Find) -> None:
    rng = np.random.default_rng(20266)
    s = 10 ** rng.uniform(-2, 1, 4000)
    below, above, least, most = rng.uniform(36, 39, (4, s.size))
    whole = np.hypot(1, s)
    windows = (-below, above), (-least * whole, most * whole)
    for share in four(find(Normal(0, 1), Normal(0, s), *windows)):
        assert np.all(share >= 0)


def test_errorless_gauge_is_the_limit_of_a_good_one(find: Find) -> None:
    simple = find(Normal(0, 1), Normal(0, 0), (-1, 2))
    np.testing.assert_allclose(simple.rightly_accepted, ndtr(2) - ndtr(-1), rtol=1e-14)
    assert (simple.wrongly_accepted, simple.wrongly_rejected) == (0, 0)
    windows = (-1.0, 2.0), (-0.5, 3.0)
    exact = four(find(Normal(0, 1), Normal(0, 0), *windows))
    # Each limit lies at least 0.5 from the other windows' limits: s = 1e-20 changes nothing.
    near = four(find(Normal(0, 1), Normal(0, 1e-20), *windows))
    expected = [
        ndtr(2) - ndtr(-0.5),
        ndtr(-2) - ndtr(-3),
        ndtr(-1) + ndtr(-3),
        ndtr(-0.5) - ndtr(-1),
    ]
    np.testing.assert_allclose(exact, expected, rtol=1e-14)
    np.testing.assert_allclose(near, expected, rtol=1e-14)


@pytest.mark.parametrize("error", [Normal(0.1, 0.4), Normal(0.1, 0), Uniform(-0.6, 0.9)])
@pytest.mark.parametrize("value", [-3.0, -1.0, 0.7, 2.9, 3.0, 4.0])
def test_a_fixed_true_value(value: float, error: Law, find: Find) -> None:
    right, wrong, out, lost = four(find(Normal(value, 0), error, (-3, 3), (-2, 2.5)))
    accepted = error.probability(-2 - value, 2.5 - value)
    conforms = -3 < value < 3
    np.testing.assert_allclose(right if conforms else wrong, accepted, rtol=1e-14)
    beyond = error.outside(-2 - value, 2.5 - value)
    np.testing.assert_allclose(lost if conforms else out, beyond, rtol=1e-14)
    assert accepted + beyond == pytest.approx(1, abs=1e-15)
    assert (wrong, out) == (0, 0) if conforms else (right, lost) == (0, 0)


def test_values_on_a_limit_are_outside(find: Find) -> None:
    assert four(find(Normal(3, 0), Normal(0, 0), (-3, 3), (-4, 4))) == [0, 1, 0, 0]
    assert four(find(Normal(2, 0), Normal(1, 0), (-3, 3))) == [0, 0, 0, 1]


def test_uniform_laws_give_the_areas_of_polygons() -> None:
    # Y on (-4, 4), E on (-1/2, 1/2), limits +-3: each corner triangle has area (1/2)**2 / 2.
    triangle = Fraction(1, 8) / 8
    expected = [Fraction(6, 8) - 2 * triangle, 2 * triangle, Fraction(2, 8) - 2 * triangle]
    got = four(shares(Uniform(-4, 4), Uniform(-0.5, 0.5), (-3, 3)))
    np.testing.assert_allclose(got, [float(e) for e in (*expected, 2 * triangle)], rtol=1e-14)


@pytest.mark.parametrize("acceptance", [(-2, 3), (-2.5, 3.5), (-9, 9), (2.9, 4), (12, 13)])
def test_parts_sorted_before_are_the_conforming_parts_of_a_normal_law(
    acceptance: tuple[float, float],
) -> None:
    tolerance, error = (-2, 3), Normal(0.1, 0.4)
    everything = shares(Normal(0.3, 1), error, tolerance, acceptance)
    kept = shares(TruncatedNormal(0.3, 1, *tolerance), error, tolerance, acceptance)
    conforming = everything.rightly_accepted + everything.wrongly_rejected
    for name in ("rightly_accepted", "wrongly_rejected"):
        expected = getattr(everything, name) / conforming
        np.testing.assert_allclose(getattr(kept, name), expected, rtol=BAR)
    assert (kept.wrongly_accepted, kept.rightly_rejected) == (0, 0)


def test_broadcasting_scalars_and_nan(find: Find) -> None:
    one = find(Normal(0, 1), Normal(0, 0.3), (-3, 3))
    assert all(isinstance(value, np.float64) for value in four(one))
    assert find(Normal(0, np.ones((0, 3))), Normal(0, 1), (-1, 1)).rightly_accepted.shape == (
        0,
        3,
    )
    column, row = np.array([[-4.0], [np.nan]]), np.array([0.3, 0.4, 0.5])
    for true in (Normal(column, 1), Uniform(column, 4)):
        many = find(true, Normal(0, row), (-3, 3))
        single = find(
            type(true)(*(p.flat[0] for p in list_parameters(true))),
            Normal(0, 0.4),
            (-3, 3),
        )
        for values, value in zip(four(many), four(single), strict=True):
            assert values.shape == (2, 3)
            assert np.isnan(values[1]).all()
            assert values[0, 1] == pytest.approx(value, rel=1e-14)


def test_many_sets_are_far_cheaper_than_scalar_quadratures() -> None:
    def one() -> None:
        for start, end in ((-3, 3), (3, 9), (-9, -3)):
            quad(
                lambda y: np.exp(-y * y / 2) * (ndtr((3 - y) / 0.3) - ndtr((-3 - y) / 0.3)),
                start,
                end,
                epsabs=0,
                epsrel=1e-12,
            )

    def best(act: Callable[[], object]) -> float:
        return min(_seconds(act) for _ in range(5))

    count = 20_000
    many = Normal(np.linspace(-0.1, 0.1, count), 1)
    ours = best(lambda: shares(many, Normal(0, 0.3), (-3, 3))) / count
    # One scalar share against all four takes some 150 times as long; a busy machine may show 50.
    assert best(one) > 50 * ours


def _seconds(act: Callable[[], object]) -> float:
    start = time.perf_counter()
    act()
    return time.perf_counter() - start
