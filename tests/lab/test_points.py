"""Point sets made from singular sets: exact roots, both sides, the domain, and errors found."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy as sp
from weights import first_of

from mechproof.derivations.elliptic_planetary import PAPER
from mechproof.derivations.elliptic_planetary.mechanics import R1, R2, e, phi1, x
from mechproof.kernel_support.order import step_ulps
from mechproof.lab.oracle import find_errors, find_truth
from mechproof.lab.sampling.draws import draw_mixed
from mechproof.lab.sampling.named_sets import REPORT, TUNE, draw_points
from mechproof.lab.sampling.singular_points import list_point_sets
from mechproof.lab.sampling.stated_sizes import Facts
from mechproof.lab.sampling.usual_sizes import draw_cell, make_workload
from mechproof.lab.sampling.zero_sets import ZeroSet, find_roots
from mechproof.lab.subject import find_subjects
from mechproof.lab.ways import Arguments, Array
from mechproof.record import Argument, PublishedSizes, Singular, Toleranced
from mechproof.statement_domains.domain import Domain

turns = sp.Symbol("m_turns", integer=True)
DOMAIN = Domain.of(PAPER)
PEAK = Singular(sp.Eq(x, 2 * sp.pi * turns), "the ratio is steep")
FLAT = Singular(sp.Eq(e, 1), "the ellipse is flat")
PUBLISHED = PublishedSizes(
    "Table 1",
    {
        R1: Toleranced(sp.Integer(66), sp.Rational(1, 10), sp.Rational(-1, 5)),
        R2: sp.Integer(16),
        e: sp.Rational(19, 40),
    },
)
ARGUMENTS = (
    Argument("phi1", (phi1,), "", usual=(0.0, 10.0, 1e3, 1e6)),
    Argument("R1", (R1,), ""),
    Argument("R2", (R2,), ""),
    Argument("e", (e,), "", usual=(0.0, 0.5, 0.9, 1 - 1e-12)),
)
FACTS = Facts(ARGUMENTS, DOMAIN, (PEAK, FLAT), (PUBLISHED,))
SETS = {point_set.name: point_set for point_set in list_point_sets(FACTS)}


def place_of(equation: sp.Equality) -> ZeroSet:
    gap = DOMAIN.resolve(equation)
    return ZeroSet(gap.lhs - gap.rhs, "")


def roots_by_mpmath(place: ZeroSet, symbol: sp.Symbol, values: dict[sp.Symbol, Array], at: Array):
    """Yield every root of `at`, refined to 60 digits by the secant method."""
    names = [s for s in values if s != symbol]
    function = sp.lambdify([symbol, *names], place.gap, "mpmath")
    with mpmath.workdps(60):
        for index, start in enumerate(at):
            given = [mpmath.mpf(float(values[s][index])) for s in names]
            near = mpmath.mpf(float(start))
            yield mpmath.findroot(lambda v, g=given: function(v, *g), (near, near * (1 + 1e-15)))


@pytest.mark.parametrize("symbol", [phi1, R1, R2])
def test_a_linear_root_is_the_nearest_double(symbol: sp.Symbol) -> None:
    rng = np.random.default_rng(1)
    values = {phi1: rng.uniform(1, 1e6, 40), R1: rng.uniform(50, 90, 40)}
    values |= {R2: rng.uniform(10, 40, 40), turns: rng.integers(1, 10**6, 40).astype(float)}
    place = place_of(PEAK.equation)
    found = find_roots(place, symbol, values, (-np.inf, np.inf), lambda at: at > 0)
    assert_nearest(found, roots_by_mpmath(place, symbol, values, found))


def test_a_root_of_a_transcendental_equation_is_the_nearest_double() -> None:
    rng = np.random.default_rng(2)
    place = place_of(sp.Eq((1 - e) * sp.sin(phi1) + (1 + e) * sp.cos(phi1), sp.Rational(1, 3)))
    values = {phi1: rng.uniform(-40, 40, 40), e: rng.uniform(0, 0.9, 40)}
    found = find_roots(place, phi1, values, (-np.inf, np.inf), np.isfinite)
    assert np.isfinite(found).all()
    assert_nearest(found, roots_by_mpmath(place, phi1, values, found))


def assert_nearest(found: Array, exact) -> None:  # type: ignore[no-untyped-def]
    for double, root in zip(found, exact, strict=True):
        # Neither neighbour is nearer to the root.
        for neighbour in step_ulps(np.full(2, double), np.array([-1, 1])):
            assert abs(mpmath.mpf(double) - root) <= abs(mpmath.mpf(float(neighbour)) - root)


def test_there_is_no_root_where_there_is_none() -> None:
    place = place_of(sp.Eq(sp.cos(phi1), 2))
    found = find_roots(place, phi1, {phi1: np.array([1.0])}, (-np.inf, np.inf), np.isfinite)
    assert np.isnan(found).all()


def peak_set() -> Arguments:
    return draw_points(SETS["1: the ratio is steep"], REPORT)


def test_points_lie_on_both_sides_and_at_all_distances() -> None:
    phi, r1, r2, _ = peak_set()
    whole = np.rint(phi * r1 / r2 / (2 * np.pi))
    away = phi[whole != 0] / (whole * 2 * np.pi * r2 / r1)[whole != 0] - 1
    for side in (away, -away):
        assert np.sum((side > 1e-4) & (side < 0.3)) > 5
        assert np.sum((side > 1e-12) & (side < 1e-6)) > 5
    # The root is rounded once, and the quotient here four times: half an ulp each.
    assert np.sum(np.abs(away) < 2.5 * np.finfo(float).eps) > 20


@pytest.mark.slow
@pytest.mark.parametrize("name", SETS)
def test_points_lie_in_the_domain(name: str) -> None:
    phi, r1, r2, eccentricity = draw_points(SETS[name], REPORT)
    assert len(phi) >= 100
    assert np.isfinite([phi, r1, r2, eccentricity]).all()
    assert ((r2 > 0) & (r2 < r1) & (eccentricity >= 0) & (eccentricity < 1)).all()


def test_edges_of_the_domain_are_approached() -> None:
    _, r1, r2, eccentricity = draw_points(SETS["3: edges of the domain"], REPORT)
    assert np.min(r1 / r2 - 1) < 1e-14
    assert np.min(1 - eccentricity) < 1e-14
    assert np.min(eccentricity) == 0


def test_limits_and_their_combinations_are_drawn() -> None:
    _, r1, _, _ = draw_points(SETS["generic"], REPORT)
    assert {66.0, 66.1, 65.8} <= set(r1.tolist())


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(SETS, 3))
def test_a_seed_makes_the_same_points_again_and_another_others(name: str) -> None:
    first, again, other = (draw_points(SETS[name], seed) for seed in (REPORT, REPORT, TUNE))
    assert all(np.array_equal(a, b) for a, b in zip(first, again, strict=True))
    assert not np.array_equal(first[0], other[0])


def test_a_domain_that_is_hardly_met_is_an_error() -> None:
    narrow = Domain(DOMAIN.within, (*DOMAIN.where, R1 > 10**9 * R2), {})
    with pytest.raises(ValueError, match="generic: only 0 points lie in the domain"):
        draw_points(list_point_sets(Facts(ARGUMENTS, narrow))[0], REPORT)


def test_an_equation_of_other_symbols_is_an_error() -> None:
    stray = Singular(sp.Eq(phi1, sp.Symbol("q")))
    with pytest.raises(ValueError, match="singular set"):
        list_point_sets(Facts(ARGUMENTS, DOMAIN, (stray,)))


def worst_of_the_print(row: Singular) -> float:
    """Return the worst error of equation (8) as printed near this one singular set."""
    subject = find_subjects(("elliptic_planetary.ratio",))[0]
    calm = tuple(replace(a, usual=(0.0, 0.9)) if a.name == "e" else a for a in ARGUMENTS)
    points = draw_points(list_point_sets(Facts(calm, DOMAIN, (row,), (PUBLISHED,)))[1], REPORT)
    kept = np.abs(points[0] * points[1] / points[2]) < 1e3
    points = tuple(column[kept & (points[3] < 0.999)] for column in points)
    printed = next(w for w in subject.ways if w.key == "printed")
    errors = find_errors(printed.compute(*points), find_truth(subject, points))
    return float(np.nanmax(errors.ulp))


def test_a_wrong_singular_set_finds_much_less() -> None:
    """1 + e**2 - 2 e cos x cancels near whole turns of x, not near half turns."""
    right = worst_of_the_print(PEAK)
    wrong = worst_of_the_print(Singular(sp.Eq(x, sp.pi + 2 * sp.pi * turns)))
    assert right > 30 * wrong


def test_points_of_a_cell_have_its_sizes() -> None:
    cell = {"phi1": (10.0, 1e3), "e": (0.5, 0.9)}
    phi, r1, r2, eccentricity = draw_cell(FACTS, np.random.default_rng(3), cell)
    assert len(phi) >= 50
    assert ((np.abs(phi) >= 10) & (np.abs(phi) <= 1e3) & (r2 < r1)).all()
    assert ((eccentricity >= 0.5) & (eccentricity <= 0.9)).all()


def test_a_workload_rises_through_periods_at_published_sizes() -> None:
    phi, *sizes = make_workload(FACTS, 1000, ("phi1",))
    assert sizes == [66.0, 16.0, 0.475]
    assert phi[0] == 0
    # Two roundings.
    assert phi[-1] == pytest.approx(16 * 2 * np.pi * 16 / 66, rel=1e-15)
    _, r1, _, _ = make_workload(FACTS, 100, ("R1", "R2"))
    assert ((r1 >= 65.8) & (r1 <= 66.1)).all()


def test_all_ways_of_drawing_are_mixed() -> None:
    drawn = draw_mixed(FACTS, np.random.default_rng(4), 400)
    published = np.isin(drawn[R1], [66.0, 65.8, 66.1])
    assert 0.2 < published.mean() < 0.8
    assert drawn[R1].min() < 6.6
    assert drawn[R1].max() > 660
