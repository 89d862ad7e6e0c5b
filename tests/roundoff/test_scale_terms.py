"""Terms of a scale: errors assigned to them add up to no less, and claims about scales hold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from certified import GROUP

from mechproof.arithmetic.intervals import Array
from mechproof.programs.kernel import list_functions
from mechproof.record import Accuracy, Argument, Chart, Form, Paper, Quantity, Scale, Variable
from mechproof.roundoff.certificate import cover_all
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.condition_numbers import spread
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.steps import HALF

pytestmark = pytest.mark.xdist_group(GROUP)
a, b = sp.symbols("a b", positive=True)
angle = sp.Symbol("angle", real=True)
UNIT = sp.Interval(0, 1)


def add_up(errors: Array, terms: Array) -> float:
    return float(errors.sum() / terms.sum())


def test_errors_put_to_terms_add_up_to_no_less() -> None:
    """Terms are drawn at random, however unlike, and each error is a share of one of them."""
    rng = np.random.default_rng(1)
    for _ in range(200):
        terms = 10.0 ** rng.uniform(-8, 0, 3)
        errors = rng.uniform(0, 1, 5) * terms[rng.integers(0, 3, 5)]
        shares = [
            [np.array([inf]), *(e / terms)[:, np.newaxis]] for e in errors for inf in [np.inf]
        ]
        assert add_up(errors, terms) <= spread(shares, 3)[0]


def test_terms_that_vanish_together_need_no_quotient() -> None:
    """Two errors, each half of its own term, give one half; one error on both terms gives less."""
    unknown, half = np.array([np.inf]), np.array([0.5])
    assert spread([[half, unknown], [unknown, half]], 2)[0] == pytest.approx(0.5)
    assert spread([[half, half]], 2)[0] == pytest.approx(0.25)
    assert spread([[half, unknown], [half, unknown]], 2)[0] == pytest.approx(1.0)
    assert not np.isfinite(spread([[unknown, unknown]], 2)[0])


def test_one_term_too_many_is_seen() -> None:
    """Errors assigned to a term that the scale does not have exceed the bound."""
    terms = np.array([1.0, 1e-9])
    errors = np.array([0.5, 0.5]) * terms[0]
    honest = [[np.array([0.5]), np.array([0.5 / terms[1]])]] * 2
    forged = [[np.array([0.5]), np.array([0.5])]] * 2
    assert add_up(errors, terms) <= spread(honest, 2)[0]
    assert add_up(errors, terms) > spread(forged, 2)[0]


def write_subjects(
    value: sp.Expr, scale: sp.Expr, chart: Chart, symbols: Sequence[sp.Symbol]
) -> list[ComputedStage]:
    form = Form("as it is", value, charts=(chart,))
    arguments = tuple(Argument(str(s), (s,), str(s)) for s in symbols)
    accuracy = Accuracy(9, Scale("its terms", scale))
    quantity = Quantity("f", "Compute f.", arguments, value, (form,), "here", accuracy=accuracy)
    paper = Paper(
        "own",
        "A paper",
        variables=tuple(Variable(s, str(s)) for s in symbols),
        rows=(),
        quantities=(quantity,),
    )
    return [s for kernel in list_functions(paper) for s in list_computed_stages(kernel, paper)]


def is_shown(subject: ComputedStage, bound: float) -> bool:
    return all(cover.open is None for _, cover in cover_all(subject, bound, 2000))


SIZES = a**2 + 2 * b**2 + sp.Abs(a**2 - b**2)


def write_squares(scale: sp.Expr) -> list[ComputedStage]:
    chart = Chart("", {a: a, b: b}, dict.fromkeys((a, b), sp.Interval(0, 1)))
    return write_subjects(a**2 - b**2, scale, chart, (a, b))


def test_a_corner_where_all_terms_vanish_is_bounded() -> None:
    """There neither a nor b is a share of the other: boxes at 0 never bound their quotient."""
    for subject in write_squares(SIZES):
        assert is_shown(subject, 0.6)


def test_a_kernel_with_a_rounding_more_is_above_the_bound() -> None:
    """A square with ten times the rounding error exceeds the bound shown for one rounding."""
    for subject in write_squares(SIZES):
        steps = tuple(
            replace(s, ulps=10 * HALF) if s.kind == "square" else s for s in subject.straight.steps
        )
        worse = replace(subject, straight=replace(subject.straight, steps=steps))
        assert not is_shown(worse, 0.6)


@pytest.mark.slow
def test_a_scale_without_a_term_has_no_bound() -> None:
    """Without a**2 in the scale, its error is compared with nothing at b = 0 and a = b."""
    for subject in write_squares(2 * b**2 + sp.Abs(a**2 - b**2) + b**3):
        assert subject.scale is not None
        assert subject.scale.terms
        assert not is_shown(subject, 0.6)


def test_a_function_that_vanishes_cancels_beside_itself() -> None:
    """At a quarter turn the error of a cosine vanishes like the cosine, but not like its square."""
    chart = Chart("", {a: a, angle: angle}, {a: sp.Interval(0, 1), angle: sp.Interval(1, 2)})
    value = sp.cos(angle) - a
    for scale, bounded in (
        (sp.Abs(sp.cos(angle)) + a + sp.Abs(value), True),
        (sp.cos(angle) ** 2 + a**2 + a**3, False),
    ):
        (first, *_) = write_subjects(value, scale, chart, (angle, a))
        assert is_shown(first, 1.6) == bounded


@pytest.mark.slow
def test_what_a_maximum_is_at_least_bounds_a_difference() -> None:
    chart = Chart("", {a: a, b: b}, dict.fromkeys((a, b), sp.Interval(0, 1)))
    for subject in write_subjects(a - b * b, sp.Max(a, b * b), chart, (a, b)):
        assert is_shown(subject, 1.01)
        assert not is_shown(subject, 0.99)
    for subject in write_subjects(a - b * b, sp.Max(a, b**3), chart, (a, b)):
        assert not is_shown(subject, 4.0)


# The value times a sum that is no less than 1, times a maximum, and as a term.
VALUE = angle * a**2 * b / (1 + b) ** 3
AT_LEAST = [
    VALUE * (1 + sp.Abs(angle)),
    a**2 * sp.Max(sp.Abs(angle * b / (1 + b)), angle) / (1 + b) ** 2,
    a**2 / (1 + b) * (2 * sp.Max(sp.Abs(angle * b), a) + sp.Abs(angle)) / (2 * (b + 1) ** 2),
    3 * (sp.Abs(-a * b * angle) * sp.Abs(a) / (1 + b) ** 3 + 1),
]
# Half of the value, a sum and a maximum that may be negative, and another quantity's size.
NOT_AT_LEAST = [
    VALUE * (1 + sp.Abs(angle)) / 2,
    VALUE * (1 + angle),
    a**2 * sp.Max(angle * b / (1 + b), -1) / (1 + b) ** 2,
    sp.Max(sp.Abs(VALUE - b**4), a),
]


@pytest.mark.parametrize("scale", [*AT_LEAST, *NOT_AT_LEAST], ids=str)
def test_a_scale_is_seen_to_be_no_less_than_the_value(scale: sp.Expr) -> None:
    chart = Chart("", {s: s for s in (a, b, angle)}, dict.fromkeys((a, b, angle), UNIT))
    for subject in write_subjects(VALUE, scale, chart, (a, b, angle)):
        assert subject.scale is not None
        assert subject.scale.is_at_least == (scale in AT_LEAST)


def bound_whole(subject: ComputedStage) -> float:
    region = next(list_regions(subject.form.charts[0]))
    return float(subject.bound(region, np.array([region.box]))[0])


def test_beside_a_scale_that_is_no_less_boxes_may_be_wide() -> None:
    """Whatever quotients over a box say, each rounding counts once as half an eps of the value."""
    chart = Chart("", {s: 1 + s for s in (a, b, angle)}, dict.fromkeys((a, b, angle), UNIT))
    for subject in write_subjects(VALUE, AT_LEAST[0], chart, (a, b, angle)):
        assert subject.scale is not None
        # The rounding of 1 + b three times, for its cube, and one each of six products.
        assert 4.5 <= bound_whole(subject) <= 4.51
        unseen = replace(subject.scale, is_at_least=False)
        assert bound_whole(replace(subject, scale=unseen)) > 20
        *others, last = subject.straight.steps
        steps = (*others, replace(last, ulps=2 * HALF))
        worse = replace(subject, straight=replace(subject.straight, steps=steps))
        assert bound_whole(worse) >= 4.99
