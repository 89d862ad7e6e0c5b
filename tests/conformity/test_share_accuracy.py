"""Shares of rightly and wrongly accepted and rejected parts against rigorous ball integrals."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from cases import BAR, HARD, INF, NAMES, Find, four, random_case, random_sets
from enclosures import relative_errors
from flint import arb, ctx

from mechproof.conformity import Normal, Uniform, shares
from mechproof.conformity.quadrature import law_masses


@pytest.mark.parametrize("name", HARD)
def test_every_share_is_relatively_accurate(name: str, find: Find) -> None:
    case = HARD[name]
    assert max(relative_errors(four(case.shares(find)), case)) < BAR


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
    """Tails that have lost their digits cancel; no window without an end is integrated."""
    found = find(Normal(mean, 1.0), Normal(0.0, scatter), tolerance, acceptance)
    assert getattr(found, sure) == 1.0
    assert all(0 <= getattr(found, name) < 1e-100 for name in NAMES if name != sure)
