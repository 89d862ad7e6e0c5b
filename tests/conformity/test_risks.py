"""Shares of rightly and wrongly accepted and rejected parts against rigorous ball integrals."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, ctx
from scipy.integrate import quad
from scipy.special import ndtr

from mechproof.conformity import (
    Law,
    Normal,
    Shares,
    TruncatedNormal,
    Uniform,
    shares,
)
from mechproof.conformity.quadrature import law_masses
from mechproof.laws.kinds import list_parameters

INF = np.inf
BAR = 1e-12
Find = Callable[..., Shares]
NAMES = ("rightly_accepted", "wrongly_accepted", "rightly_rejected", "wrongly_rejected")


def four(result: Shares) -> list[Any]:
    return [getattr(result, name) for name in NAMES]


@dataclass(frozen=True)
class Case:
    """A normal part (mu, sigma), a normal error (bias, s) and both windows."""

    mu: float
    sigma: float
    bias: float
    s: float
    tolerance: tuple[float, float]
    acceptance: tuple[float, float]

    def shares(self, find: Find = shares) -> Shares:
        laws = Normal(self.mu, self.sigma), Normal(self.bias, self.s)
        return find(*laws, self.tolerance, self.acceptance)


HARD = {
    "plain": Case(0, 1, 0, 0.3, (-3, 3), (-3, 3)),
    "paper, 6 sigma": Case(-10.5, 7.5, 0.3, 1.7, (-33, 12), (-33, 12)),
    "error far below spread": Case(0, 1, 0, 1e-6, (-3, 3), (-3, 3)),
    "guard band of ten errors": Case(0, 1, 0, 1e-6, (-3, 3), (-2.99999, 2.99999)),
    "error far above spread": Case(0, 1, 0, 1e4, (-3, 3), (-3, 3)),
    "spread far below error": Case(0, 1e-3, 0, 1, (1e-2, 2e-2), (1, 2)),
    "limits 15 sigma away": Case(0, 1, 0, 0.1, (-15, 15), (-15, 15)),
    "both windows in the tail": Case(0, 1, 0, 1e-3, (18, 19), (18, 19)),
    "narrow tolerance in the tail": Case(0, 1, 0, 0.3, (20, 20.001), (19, 21)),
    "narrow acceptance": Case(0, 1, 0, 0.3, (-3, 3), (1, 1 + 1e-9)),
    "both windows narrow": Case(0, 1, 0, 0.3, (-1e-9, 1e-9), (-1e-9, 1e-9)),
    "narrow and disjoint": Case(0, 1, 0, 1e-3, (-0.5, 0.5), (0.51, 0.53)),
    "opposite tails": Case(0, 1, 0, 1, (5, 6), (-6, -5)),
    "bias outside": Case(0, 1, 5, 0.3, (-3, 3), (-3, 3)),
    "huge guard band": Case(0, 1, 0, 0.1, (-8, 8), (-6, 6)),
    "one-sided": Case(0, 1, 0, 0.1, (-INF, 3), (-INF, 2)),
    "opposite sides": Case(0, 1, 0.2, 0.5, (-INF, 3), (-2, INF)),
    "limit at the mean": Case(0, 1, 0, 0.5, (0, INF), (0, INF)),
    "limit almost at the mean": Case(0, 1, 1e-3, 1e-3, (1e-3, 2), (0, 2)),
}


def enclose(case: Case, precision: int, sizes: list[Any]) -> list[arb]:
    """Balls around the four shares: rigorous integrals over the true deviation.

    `sizes` (guesses of the shares) only say how small a radius is aimed at.
    """
    with_precision, ctx.prec = ctx.prec, precision
    try:
        return _enclose(case, [arb(float(size)) * 2**-58 for size in sizes])
    finally:
        ctx.prec = with_precision


def _enclose(case: Case, radii: list[arb]) -> list[arb]:
    mu, sigma, bias, s = (arb(v) for v in (case.mu, case.sigma, case.bias, case.s))
    far = 45 * sigma  # beyond lies less than 1e-440
    ends = [mu - far, *(arb(t) for t in case.tolerance if np.isfinite(t)), mu + far]
    ends.sort(key=float)
    root, norm = arb(2).sqrt(), 1 / (sigma * (2 * arb.pi()).sqrt())
    low, high = (None if np.isinf(a) else arb(a) - bias for a in case.acceptance)

    def beyond(z: acb) -> acb:
        return (z / root).erfc() / 2

    def density(y: acb) -> acb:
        return norm * (-(((y - mu) / sigma) ** 2) / 2).exp()

    def under(y: acb) -> acb:
        return y * 0 if low is None else beyond((y - low) / s)

    def over(y: acb) -> acb:
        return y * 0 if high is None else beyond((high - y) / s)

    def accepted(y: acb) -> acb:
        above_low = 1 if low is None else beyond((low - y) / s)
        return density(y) * (above_low - over(y))

    def rejected(y: acb) -> acb:
        return density(y) * (under(y) + over(y))

    def integrate(f: Callable[[acb], acb], conforming: bool, radius: arb) -> arb:
        total = arb(0)
        for start, end in pairwise(ends):
            middle = float((start + end) / 2)
            if (case.tolerance[0] < middle < case.tolerance[1]) == conforming:
                kinks = [k + n * s for k in (low, high) if k is not None for n in (-8, 0, 8)]
                inner = [k for k in (*kinks, mu) if float(start) < float(k) < float(end)]
                for p, q in pairwise(sorted([start, *inner, end], key=float)):
                    total += acb.integral(
                        lambda y, _: f(y),
                        acb(p),
                        acb(q),
                        rel_tol=arb(2) ** -56,
                        abs_tol=radius,
                    ).real
        return total

    kinds = ((accepted, True), (accepted, False), (rejected, False), (rejected, True))
    return [integrate(*kind, radius) for kind, radius in zip(kinds, radii, strict=True)]


def relative_errors(got: list[Any], case: Case) -> list[float]:
    """Errors beside balls whose relative radius is below a thousandth of the bound."""
    for precision in (160, 480, 1500):
        balls = enclose(case, precision, four(case.shares()))
        if all(float(abs(b.mid())) * BAR / 1000 >= float(b.rad()) for b in balls):
            return [
                float(abs((arb(float(g)) - b.mid()) / b.mid()))
                for g, b in zip(got, balls, strict=True)
            ]
    raise AssertionError(f"no narrow ball for {case}")


@pytest.mark.parametrize("name", HARD)
def test_every_share_is_relatively_accurate(name: str, find: Find) -> None:
    case = HARD[name]
    assert max(relative_errors(four(case.shares(find)), case)) < BAR


def random_case(rng: np.random.Generator) -> Case:
    """Scales over ten decades, windows related by guard bands or not at all."""
    s, width = 10 ** rng.uniform(-6, 4), 10 ** rng.uniform(-6, 1.2)
    middle = rng.choice([0, rng.normal(0, 3), rng.normal(0, 8)])
    bias = rng.choice([0, rng.normal(0, s), rng.normal(0, 5)])
    guard = rng.choice([0, width * rng.uniform(-0.4, 1), s * abs(rng.normal())])
    shift = rng.choice([0, rng.normal(0, width), rng.normal(0, s)])
    tolerance = middle - width / 2, middle + width / 2
    acceptance = tolerance[0] + shift - guard, tolerance[1] + shift + guard
    return Case(rng.normal(0, 0.5), 1, bias, s, tolerance, acceptance)


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


def random_sets(seed: int, count: int) -> tuple[Normal, Normal, Any, Any]:
    """Means, widths, windows and guard bands of many scales; limits below 8 sigma."""
    rng = np.random.default_rng(seed)
    true = Normal(rng.normal(0, 0.5, count), np.ones(count))
    s = 10 ** rng.uniform(-2, 1.5, count)
    error = Normal(s * rng.normal(0, 1, count), s)
    middle, half = rng.normal(0, 2, count), 10 ** rng.uniform(-2, 0.6, count)
    guard = np.where(rng.random(count) < 0.3, 0, half * rng.uniform(-0.9, 2, count))
    tolerance = middle - half, middle + half
    return true, error, tolerance, (middle - half - guard, middle + half + guard)


def test_arc_integrals_and_panel_quadrature_agree(find: Find) -> None:
    true, error, tolerance, acceptance = random_sets(1, 300)
    got = four(find(true, error, tolerance, acceptance))
    panels = law_masses(true, error, np.stack(tolerance), np.stack(acceptance))
    for value, other in zip(got, panels, strict=True):
        seen = other > 1e-250
        np.testing.assert_allclose(value[seen], other[seen], rtol=BAR)


def test_shares_add_up_and_mirror(find: Find) -> None:
    true, error, tolerance, acceptance = random_sets(2, 5000)
    got = four(find(true, error, tolerance, acceptance))
    # Four roundings of numbers below 1 and their own errors, each below some ulp.
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
    """Tails that have lost their digits cancel; no window without an end is integrated."""
    found = find(Normal(mean, 1.0), Normal(0.0, scatter), tolerance, acceptance)
    assert getattr(found, sure) == 1.0
    assert all(0 <= getattr(found, name) < 1e-100 for name in NAMES if name != sure)


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
    # One scalar share of four against all four: some 150 times; a busy machine may take a third.
    assert best(one) > 50 * ours


def _seconds(act: Callable[[], object]) -> float:
    start = time.perf_counter()
    act()
    return time.perf_counter() - start
