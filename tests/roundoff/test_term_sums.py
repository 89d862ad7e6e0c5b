"""Bounds of sums over sets hold for any size and order; sums without a bound are refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from certified import GROUP, claims, subject_of, subjects
from derived import paper_of
from flint import arb

import mechproof.kernels.compiled.track_wheel as compiled_kernels
from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.cover import Box
from mechproof.kernels import track_wheel
from mechproof.programs.kernel import Kernel, list_functions
from mechproof.record import Accuracy, Chart, Quantity, Scale
from mechproof.roundoff.certificate import describe_bound, holds
from mechproof.roundoff.compiled_kernels import WAY
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.regions import ChartRegion, list_regions
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, run
from mechproof.roundoff.steps import IN_NUMPY, WAY as NUMPY
from mechproof.roundoff.term_sums import SEARCHED, drop_rest, run_loop, take_sum
from mechproof.roundoff.worst import draw, measure

pytestmark = pytest.mark.xdist_group(GROUP)
SUMS = {"error_sum": "sum of squares", "error_sum_thermal": "solved for the total"}
WAYS = {NUMPY: track_wheel, WAY: compiled_kernels}
# After a term of 1, the square of this number is less than half an ulp and is rounded away.
TINY = 0.999999 * 2.0**-26.5
SIZES = (1, 2, 3, 7, 8, 9, 64, 129, 1000)


@pytest.fixture(params=SUMS)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(params=WAYS)
def subject(name: str, request: pytest.FixtureRequest) -> ComputedStage:
    return subjects()[name, SUMS[name], request.param]


@pytest.fixture(scope="module")
def plain() -> ComputedStage:
    return subjects()["error_sum", SUMS["error_sum"], NUMPY]


def list_boxes(subject: ComputedStage) -> list[tuple[ChartRegion, Box]]:
    regions = (region for chart in subject.form.charts for region in list_regions(chart))
    return [(region, region.box) for region in regions]


def draw_points(subject: ComputedStage, count: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(8)
    drawn = [draw(subject, region, box, count, rng) for region, box in list_boxes(subject)]
    return {name: np.concatenate([points[name] for points in drawn]) for name in drawn[0]}


def find_proved(subject: ComputedStage) -> float:
    (proved,) = (c.proved for c in claims() if subject_of(c) is subject)
    return proved


def list_elements(points: dict[str, np.ndarray], name: str) -> np.ndarray:
    return np.stack([points[f"{name}[{i}]"] for i in range(SEARCHED)], axis=-1)


def test_the_kernels_compute_what_is_bounded(subject: ComputedStage) -> None:
    points = draw_points(subject, 500)
    assert subject.total is not None
    kernel = getattr(WAYS[subject.way], subject.kernel.name)
    families = ("tolerances", "sensitivities", "scatters")
    others = [points[n] for n in subject.kernel.code.arguments if n not in families]
    found = kernel(*(list_elements(points, n) for n in families), *others)
    assert np.array_equal(found, subject.compute(points)[0])


def test_no_drawn_set_is_off_by_more(subject: ComputedStage) -> None:
    errors = measure(subject, draw_points(subject, 1000))
    assert np.all(errors >= 0)
    assert 0.5 < errors.max() <= find_proved(subject) + subject.more


def find_errors(subject: ComputedStage, arrays: dict[str, Any], given: dict[str, float]) -> float:
    """Return the error of a kernel on one set of any size, in eps of its scale."""
    kernel = getattr(WAYS[subject.way], subject.kernel.name)
    found = float(
        kernel(*(arrays[n] for n in ("tolerances", "sensitivities", "scatters")), **given)
    )
    return weigh(subject, found, arrays, given)


def weigh(
    subject: ComputedStage, found: float, arrays: dict[str, Any], given: dict[str, float]
) -> float:
    assert subject.total is not None
    loop = subject.total.loop
    with working_precision(300):
        balls = {n: [arb(float(x)) for x in column] for n, column in arrays.items()}
        taken = [np.array(balls[n]) for n in loop.parameters]
        numbers = {n: arb(value) for n, value in given.items()}
        exact = run_loop(loop, IN_BALLS, drop_rest, *taken)
        (off,) = subject.weigh([found], {**numbers, loop.name: exact}, IN_BALLS)
        return float(off)


def list_sets(size: int) -> list[dict[str, np.ndarray]]:
    """List sets of tiny and huge elements, equal and spread, with zeros and with both signs."""
    rng = np.random.default_rng(size)
    sets = []
    for spread in (0.0, 1.0, 30.0, 160.0):
        first, other, third = np.exp2(rng.uniform(-spread, spread, (3, size)))
        signs = rng.choice((-1.0, 1.0), size)
        sets += [{"tolerances": first, "sensitivities": signs * other, "scatters": third}]
    alike = np.ones(size)
    hidden = np.where(np.arange(size), TINY, 1.0)
    with_zeros = np.where(np.arange(size) % 3, 0.0, 1.1)
    sets += [
        {"tolerances": column, "sensitivities": alike, "scatters": alike}
        for column in (hidden, hidden[::-1].copy(), with_zeros, 1 / 3 * alike)
    ]
    return sets


@pytest.mark.parametrize("size", SIZES)
def test_sets_of_any_size_are_off_by_no_more(subject: ComputedStage, size: int) -> None:
    proved = find_proved(subject)
    given = {"total_scatter": 1.1}
    if subject.kernel.name == "error_sum_thermal":
        given |= {"thermal_share": 0.7, "thermal_scatter": 1.3}
    for arrays in list_sets(size):
        off = find_errors(subject, arrays, given)
        assert 0 <= off <= proved + subject.each * (size - 1)


def test_in_another_order_what_each_term_adds_is_reached(plain: ComputedStage) -> None:
    """Terms are rounded away one after another, so a smaller error for each would be wrong."""
    assert plain.total is not None
    size = 4000
    ones = np.ones(size)
    columns = {"tolerances": np.where(np.arange(size), TINY, 1.0), "sensitivities": ones}
    arrays = {**columns, "scatters": ones}
    loop = plain.total.loop
    rounded = run_loop(loop, IN_DOUBLES, drop_rest, *(arrays[n] for n in loop.parameters))
    given = {"total_scatter": 1.0}
    (found,) = run(plain.straight, {**given, loop.name: rounded}, IN_DOUBLES)
    off = weigh(plain, float(found), arrays, given)
    proved, each = find_proved(plain), plain.each
    assert proved + 0.99 * each * (size - 1) < off <= proved + each * (size - 1)


def test_what_each_term_adds_is_part_of_a_claim(plain: ComputedStage) -> None:
    (claim,) = (c for c in claims() if subject_of(c) is plain)
    assert holds(plain, claim)
    assert claim.found > claim.proved
    assert describe_bound(claim) == f"{claim.proved:g} + 0.25*(n - 1)"
    for each in (0.0, 0.2, 0.5):
        assert not holds(plain, replace(claim, each=each))
    assert plain.total is not None
    fewer = replace(plain, total=replace(plain.total, degree=0.4))
    assert not holds(fewer, claim)
    assert not holds(fewer, replace(claim, each=fewer.each, program=fewer.digest))


def test_terms_that_are_off_by_less_are_exceeded(plain: ComputedStage) -> None:
    (claim,) = (c for c in claims() if subject_of(c) is plain)
    first, *rest = plain.straight.steps
    assert first.kind == "approximate"
    exact = replace(
        plain, straight=replace(plain.straight, steps=(replace(first, ulps=0.0), *rest))
    )
    ((region, box),) = list_boxes(exact)
    assert exact.bound(region, np.array([box]))[0] + exact.more < claim.found


def kernel_of(name: str, **changes: Any) -> tuple[Kernel, Quantity]:
    paper = paper_of("track_wheel")
    (quantity,) = (q for q in paper.quantities if q.name == name)
    changed = replace(quantity, **changes)
    listed = tuple(changed if q is quantity else q for q in paper.quantities)
    kernels = list_functions(replace(paper, quantities=listed))
    return next(k for k in kernels if k.name == name), changed


def test_what_is_less_than_the_value_is_no_scale_of_sums() -> None:
    paper = paper_of("track_wheel")
    (quantity,) = (q for q in paper.quantities if q.name == "error_sum")
    for factor, is_finite in ((2, True), (sp.S.Half, False)):
        accuracy = Accuracy(7, Scale("a multiple", factor * quantity.definition))
        kernel, _ = kernel_of("error_sum", accuracy=accuracy)
        for stage in list_computed_stages(kernel, paper):
            ((region, box),) = list_boxes(stage)
            assert np.isfinite(stage.bound(region, np.array([box]))) == is_finite


def test_sums_whose_terms_may_cancel_are_refused() -> None:
    kernel, _ = kernel_of("error_sum_correlated")
    with pytest.raises(ValueError, match="two indices: leave out the charts"):
        take_sum(kernel, IN_NUMPY, keeps_rests=False)


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (lambda total: sp.sqrt(total) + 1, "not a power of at most 1 of a sum"),
        (lambda total: total**2, "not a power of at most 1 of a sum"),
        (lambda total: sp.sqrt(total) * sp.exp(-total), "not a power of at most 1 of a sum"),
    ],
)
def test_what_is_no_power_of_the_sum_is_refused(change: Any, why: str) -> None:
    _, quantity = kernel_of("error_sum")
    (total,) = quantity.definition.atoms(sp.Sum)
    refuse(change(total), why)


def test_terms_of_either_sign_are_refused() -> None:
    _, quantity = kernel_of("error_sum")
    (total,) = quantity.definition.atoms(sp.Sum)
    (factor, *_) = sorted(total.function.atoms(sp.Indexed), key=str)
    refuse(sp.Sum(total.function * factor, *total.limits), "terms of either sign")


def refuse(value: sp.Expr, why: str) -> None:
    paper = paper_of("track_wheel")
    _, quantity = kernel_of("error_sum")
    (form,) = quantity.forms
    scatter = quantity.arguments[-1].symbols[0]
    assert isinstance(scatter, sp.Symbol)
    chart = Chart("", {scatter: scatter}, {scatter: sp.Interval(0, sp.oo)})
    other = replace(form, expression=value / scatter, charts=(chart,))
    kernel, _ = kernel_of("error_sum", definition=value / scatter, forms=(other,))
    with pytest.raises(ValueError, match=why):
        list(list_computed_stages(kernel, paper))
