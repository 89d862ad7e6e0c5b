"""Tailored kernels are within their bounds, and kernels that are not are refused."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from derived import SYSTEMS, paper_of
from flint import arb, arb_series
from numpy.typing import NDArray
from quantities import find_subject
from weights import first_of

from mechproof.arithmetic.balls import evaluate, working_precision
from mechproof.arithmetic.series import BITS, TaylorExpression, list_terms, working
from mechproof.record import Paper, Quantity
from mechproof.statement_domains.domain import Domain
from mechproof.tailoring import tailor
from mechproof.tailoring.build import Built, build
from mechproof.tailoring.enclosure import BreakError, ExceededError, enclose
from mechproof.tailoring.model import Model, Piece, track
from mechproof.tailoring.request import Request, read_request
from mechproof.tailoring.tailored import NUMPY, Tailored, make_kernel

Array = NDArray[np.float64]
LINKAGE = {
    **{"l_AB": 6.25, "l_BC": 49.75, "l_CD": 38.0, "l_DE": 83.0, "l_GH": 2.0, "l_KL": 60.0},
    **{"l_LM": 145.0, "alpha_DE": 4.94, "alpha_KL": 1.134, "alpha_LM": 2.155},
}
CASES = {
    "elliptic_planetary.position": {"R1": 66, "R2": 16, "e": 0.475},
    "oval_planetary.position": {"e1": 0.2, "e2": 0.3},
    "wedge_linkage.position": {"x1": (-40, 0), **LINKAGE},
}
OTHERS = {
    "elliptic, flat": ("elliptic_planetary.position", {"R1": 80, "R2": 30, "e": 0.95}),
    "elliptic, round": ("elliptic_planetary.position", {"R1": 80, "R2": 30, "e": 0}),
    "elliptic, part of a turn": (
        "elliptic_planetary.position",
        {"R1": 66, "R2": 16, "e": 0.475, "phi1": (0.1, 1.2)},
    ),
    "elliptic, to one side": (
        "elliptic_planetary.position",
        {"R1": 66, "R2": 16, "e": 0.475, "phi1": (-1, 50)},
    ),
    "oval, turned": ("oval_planetary.position", {"e1": 0.4, "e2": 0.1, "mount": 0.3}),
    "ratio": ("elliptic_planetary.ratio", {"R1": 66, "R2": 16, "e": 0.475}),
    "beyond rest": ("wedge_linkage.position", {"x1": (-60, 5), **LINKAGE}),
}
RNG = 20240711


@cache
def prepare(name: str, error: float, case: str = "") -> tuple[Request, Built]:
    arguments = OTHERS[case][1] if case else CASES[name]
    request = read_request(name, error, arguments)
    return request, build(request)


def list_points(request: Request, kernel: Tailored) -> Array:
    """Return points chosen to hurt: ends, seams of pieces, also in far periods, and neighbours."""
    rng = np.random.default_rng(RNG)
    low, high = kernel.low, kernel.high
    places = [low, high, 0.0, *kernel.edges, *(-e for e in kernel.edges)]
    repetition = request.repetition()
    near = high
    if repetition is not None:
        period = near = float(repetition.period.mid())
        turns = [0, -1, int(high / period) - 1, int(high / period / 3)]
        offsets = [0.0, period / 2, *kernel.edges, *(-e for e in kernel.edges)]
        places += [turn * period + offset for turn in turns for offset in offsets]
    beside = [np.nextafter(p, to) for p in places for to in (-np.inf, np.inf)]
    drawn = [*rng.uniform(low, high, 20), *rng.uniform(max(low, -near), min(high, near), 60)]
    points = np.array([*places, *beside, *drawn, 1e-8, -1e-300, 5e-324])
    return points[(points >= low) & (points <= high)]


def find_worst(request: Request, kernel: Tailored, more: Array | None = None) -> float:
    """Return the largest error found, as measured by balls."""
    subject = find_subject(request.name)
    first, *others = subject.quantity.arguments
    sizes = {a.symbols[0]: request.values[a.name] for a in others}
    points = np.concatenate([list_points(request, kernel), [] if more is None else more])
    worst = 0.0
    for point, value in zip(points.tolist(), kernel(points).tolist(), strict=True):
        true = evaluate(subject.exact, {**sizes, first.symbols[0]: point}, 256)
        with working_precision(256):
            error = abs(arb(value) - true)
        assert error.is_finite(), point
        worst = max(worst, float(error.upper()))
    return worst


@pytest.mark.slow
@pytest.mark.parametrize("error", first_of((1e-12, 1e-3, 1e-6, 1e-9)))
@pytest.mark.parametrize("name", CASES)
def test_no_point_is_off_by_more_than_the_bound(name: str, error: float) -> None:
    request, built = prepare(name, error)
    kernel = make_kernel(request, built, NUMPY)
    assert find_worst(request, kernel) <= kernel.bound <= error


# Near e = 1 the position changes by half a turn within 1 - e: (1 - e, requested error).
STEEP = [(1e-2, 1.0), (5e-3, 1.0), (1e-3, 0.1), (1e-4, 0.1)]


@pytest.mark.slow
@pytest.mark.parametrize(("gap", "error"), STEEP)
def test_a_steep_turn_is_within_the_bound(gap: float, error: float) -> None:
    sizes = {"R1": 66, "R2": 16, "e": 1 - gap}
    request = read_request("elliptic_planetary.position", error, sizes)
    kernel = make_kernel(request, build(request), NUMPY)
    assert find_worst(request, kernel, np.linspace(-3 * gap, 3 * gap, 301)) <= kernel.bound


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "sizes"),
    first_of(
        [
            ("elliptic_planetary.position", {"R1": 66, "R2": 16, "e": 0.99999}),
            (
                "elliptic_planetary.position",
                {"R1": 66, "R2": 16, "e": 0.999999, "phi1": (0.0, 0.7)},
            ),
            ("elliptic_planetary.position", {"R1": 1e300, "R2": 16, "e": 0.475}),
            ("oval_planetary.position", {"e1": 0.2, "e2": 0.999999}),
            ("oval_planetary.ratio_cylindrical", {"R4": 30, "R5": 20, "e2": 0.999999}),
        ]
    ),
)
def test_what_no_few_polynomials_follow_is_refused(name: str, sizes: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"error = 0\.001: (must be at least|nothing that can be)"):
        build(read_request(name, 1e-3, sizes))


@pytest.mark.thorough
def test_threads_change_no_bound() -> None:
    asked = [{"R1": 66, "R2": 16, "e": 0.3 + 0.05 * i} for i in range(4)]

    def bound(sizes: dict[str, float]) -> float:
        return tailor("elliptic_planetary.position", error=1e-6, **sizes).bound

    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(bound, asked)) == list(map(bound, asked))


@pytest.mark.parametrize("case", first_of(OTHERS))
def test_other_quantities_and_ranges_are_within_their_bounds(case: str) -> None:
    request, built = prepare(OTHERS[case][0], 1e-7, case)
    kernel = make_kernel(request, built, NUMPY)
    assert find_worst(request, kernel) <= kernel.bound <= 1e-7


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_bounds_are_no_wider_than_twice_what_is_found(name: str) -> None:
    # The factor 2 allows for roundings at the ends, a quarter of the bound, that no point meets.
    request, built = prepare(name, 1e-6)
    assert built.bound.error <= 2 * find_worst(request, make_kernel(request, built, NUMPY))


def check(request: Request, model: Model, limit: float) -> None:
    repetition = request.repetition() if model.reduction else None
    definition = request.define(request.quantity.definition)
    with working(1, 512):
        rate = repetition.rate if repetition else arb(0)
    enclose(model, lambda p: definition.expand(p) - rate * p, repetition, limit)


def change_pieces(model: Model) -> Iterator[Model]:
    """Yield models with one coefficient changed, its term at the piece's end by 1e-4."""
    pieces = model.pieces
    ends = [*pieces.edges, model.high]
    for i, piece in enumerate(pieces.pieces):
        reach = abs(ends[0 if pieces.odd else i] - piece.centre)
        for j in range(len(piece.coefficients)):
            numbers = list(piece.coefficients)
            numbers[j] += 1e-4 / reach ** (2 * j + 1 if pieces.odd else j)
            others = list(pieces.pieces)
            others[i] = Piece(piece.centre, tuple(numbers))
            yield replace(model, pieces=replace(pieces, pieces=tuple(others)))


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(CASES))
def test_a_changed_coefficient_is_refused(name: str) -> None:
    request, built = prepare(name, 1e-9)
    check(request, built.model, 1e-9)
    for model in change_pieces(built.model):
        with pytest.raises((ExceededError, BreakError)):
            check(request, model, 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_a_lower_degree_and_a_lower_bound_are_refused(name: str) -> None:
    request, built = prepare(name, 1e-6)
    pieces = built.model.pieces
    shorter = tuple(replace(p, coefficients=p.coefficients[:-1]) for p in pieces.pieces)
    with pytest.raises(ExceededError):
        check(request, replace(built.model, pieces=replace(pieces, pieces=shorter)), 1e-6)
    with pytest.raises(ExceededError):
        check(request, built.model, 0.9 * built.bound.error)


@pytest.mark.slow
def test_a_moved_edge_and_a_moved_centre_are_refused() -> None:
    request, built = prepare("elliptic_planetary.position", 1e-9)
    pieces = built.model.pieces
    (edge,) = pieces.edges
    moved = replace(pieces, edges=(1.1 * edge,))
    with pytest.raises(ExceededError):
        check(request, replace(built.model, pieces=moved), 1e-9)
    near, far = pieces.pieces
    shifted = replace(pieces, pieces=(near, replace(far, centre=far.centre * (1 + 1e-8))))
    with pytest.raises(ExceededError):
        check(request, replace(built.model, pieces=shifted), 1e-9)


@pytest.mark.parametrize("what", ["words", "rate"])
def test_ulps_of_the_reduction_are_seen_at_the_end_of_the_range(what: str) -> None:
    request, built = prepare("elliptic_planetary.position", 1e-9)
    reduction = built.model.reduction
    assert reduction is not None
    first, *rest = reduction.words
    changed = {
        "words": replace(reduction, words=(first * (1 + 2.0**-48), *rest)),
        "rate": replace(reduction, rate=reduction.rate * (1 + 2.0**-48)),
    }
    with pytest.raises(ExceededError):
        check(request, replace(built.model, reduction=changed[what]), 1e-9)


def test_a_range_beyond_that_of_the_bound_is_refused() -> None:
    request, built = prepare("elliptic_planetary.position", 1e-9)
    far = replace(built.model, low=-(2.0**22), high=2.0**22)
    with pytest.raises(ExceededError):
        check(request, far, 1e-9)


def test_a_jump_is_told() -> None:
    request = read_request("wedge_linkage.velocity", 1e-3, {"x1": (-40, 0), **LINKAGE})
    with pytest.raises(ValueError, match=r"jumps or is undefined near -1\.2"):
        build(request)


@pytest.mark.slow
def test_tracked_roundings_hold_what_doubles_do() -> None:
    request, built = prepare("elliptic_planetary.position", 1e-12)
    program = built.model.part()
    low, high = 0.1, 0.10001
    with working(8):
        found = track(program, low, high)
        allowed = float(found.off)
    exact = replace(built.model, reduction=None, low=low, high=high)
    kernel = make_kernel(request, replace(built, model=exact), NUMPY)
    points = np.random.default_rng(RNG).uniform(low, high, 500)
    worst = 0.0
    for point, value in zip(points.tolist(), kernel(points).tolist(), strict=True):
        with working(1, 512):
            true = track(program, point, point).middle.coeffs()[0]
            worst = max(worst, float(abs(arb(value) - true).upper()))
    # Some thirty roundings are bounded at their worst; a tenth of the sum is reached.
    assert allowed / 20 < worst <= allowed


@pytest.mark.parametrize("system", SYSTEMS)
def test_what_is_said_to_repeat_does(system: str) -> None:
    """Sines and cosines of an angle one period later, and the gain, cancel symbolically."""
    paper = paper_of(system)
    for quantity in paper.quantities:
        if quantity.periodicity is not None:
            assert_repeats(paper, quantity)


def assert_repeats(paper: Paper, quantity: Quantity) -> None:
    resolve = Domain.of(paper).resolve
    assert quantity.periodicity is not None
    variable = quantity.arguments[0].symbols[0]
    moving = {v.symbol: v.given for v in paper.variables if v.given and v.given.has(variable)}
    period, gain = quantity.periodicity.period, quantity.periodicity.gain
    value = quantity.definition.subs(moving)

    def differ(by: sp.Expr) -> sp.Expr:
        later = value.subs(variable, variable + by).replace(
            lambda e: isinstance(e, sp.sin | sp.cos), lambda e: e.func(sp.expand(e.args[0]))
        )
        found = sp.expand(later - value - gain * by / period)
        return found if found.has(variable) else sp.expand(resolve(found))

    assert differ(period) == 0
    assert differ(period / 3) != 0


def test_a_definition_has_the_value_and_the_slope_of_its_expression() -> None:
    x, k = sp.symbols("x k", real=True)
    value = sp.atan2(k * sp.sin(x), 1 - k * sp.cos(x)) + sp.sqrt(2 + x) ** 3 / sp.Max(x, k)
    expression = value + sp.Piecewise((x, x < k), (sp.exp(-x), True)) + sp.Abs(-x)
    definition = TaylorExpression(expression, x, {}, {k: 0.25})
    at = {k: sp.Rational(1, 4), x: sp.Rational(3, 4)}
    with working(2, BITS):
        place = sp.diff(expression, x).subs(at).evalf(30)
        series = definition.expand(arb_series_at(0.75))
        found, slope = series.coeffs()
        assert abs(found - arb(str(expression.subs(at).evalf(30)))) < 1e-25
        assert abs(slope - arb(str(place))) < 1e-25


X, K = sp.symbols("x k", real=True)


@pytest.mark.parametrize(
    "expression",
    [sp.atan2(X, 1 - K), sp.Piecewise((X, X < 0), (-X, True)), 1 / (X**2 + 1 - K), sp.Abs(X)],
)
def test_what_is_not_decided_on_a_ball_has_no_derivative(expression: sp.Expr) -> None:
    with working(4, BITS):
        whole = TaylorExpression(expression, X, {}, {K: 1}).expand(arb_series([arb(0, 0.5), 1]))
        assert not any(term.is_finite() for term in list_terms(whole)[1:])


def arb_series_at(point: float) -> object:
    return arb_series([arb(point), arb(1)])
