"""Derivatives of kernels against balls of the definition, at points chosen to hurt.

The balls come from another engine's backward pass, through the definition and not through the
shipped code. The bounds are worst-case bounds, so there is no false alarm to allow for.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import by_jax
import numpy as np
import pytest
import sympy as sp
from flint import arb
from quantities import DERIVATIVES, find_subject
from weights import first_of

import mechproof
from mechproof.arithmetic import slopes
from mechproof.arithmetic.slopes import GradientTape
from mechproof.codegen import form_rows
from mechproof.codegen.form_rows import derivative_rows, read_derivatives_back
from mechproof.codegen.source_reading import SourceError
from mechproof.derivations import elliptic_planetary
from mechproof.derivatives import differentiate, find_derivatives
from mechproof.kernels import elliptic_planetary as kernels, wedge_linkage
from mechproof.kernels.derivatives import wedge_linkage as of_wedge
from mechproof.lab.c_kernels import find_in_c
from mechproof.lab.oracle import count_points, find_truth, list_values
from mechproof.lab.sampling.named_sets import REPORT, PointSet, choose_evenly, draw_points
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject, find_subjects
from mechproof.lab.ways import Arguments, Compute
from mechproof.lab.worst_search import mark_accuracy_domain
from mechproof.programs import reverse_mode
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality, Quantity

GENERATED = Path(__file__).parents[2] / "generated"
EPS = 2.0**-52
# The number of points taken from every set.
POINTS = 2
# Errors below this are beyond the resolution of doubles.
TINY = 1e-320


class Truth:
    """The derivatives of a quantity, and how well each is conditioned, in balls."""

    def __init__(self, subject: Subject) -> None:
        definition, given = subject.quantity.definition, subject.paper.given
        self.symbols = [a.symbols[0] for a in subject.quantity.arguments]
        given = {s: v for s, v in given.items() if s not in self.symbols}
        self.tape = GradientTape(definition, given)
        entries = reverse_mode.chain(definition, self.symbols, given)
        self.entries = [GradientTape(entry, {}) for entry in entries]
        needed = {s for entry in self.entries for s in entry.symbols if s in given}
        self.steps = {s: GradientTape(given[s], given) for s in needed}

    def evaluate(self, values: Mapping[sp.Basic, Any]) -> Iterator[tuple[Any, Any]]:
        """Yield each argument's slope, or both at a kink, in a list, and the conditioning."""
        balls = {s: arb(v) for s, v in values.items()}
        _, found = self.tape.differentiate(balls, self.symbols)
        for symbol, entry in zip(self.symbols, self.entries, strict=True):
            steps = {s: self.steps[s].evaluate(balls) for s in entry.symbols - balls.keys()}
            known, moved = {**balls, **steps}, sorted(entry.symbols, key=str)
            _, second = entry.differentiate(known, moved)
            parts = [abs(known[s] * part) for s in moved for part in second[s]]
            yield found[symbol], abs(found[symbol][0]) + sum(parts, arb(0))


def take(subject: Subject, points: PointSet) -> Arguments:
    drawn = draw_points(points, REPORT)
    total = count_points(subject, drawn)
    chosen = choose_evenly(total, POINTS)
    return tuple(
        a[chosen] if len(a) == total else np.repeat(a[None], len(chosen), 0) for a in drawn
    )


def accuracy_of(quantity: Quantity) -> tuple[float, tuple[sp.Basic, ...]]:
    assert quantity.slopes is not None
    own = quantity.accuracy.within if quantity.accuracy else ()
    return quantity.slopes.ulp, (*own, *quantity.slopes.within)


def list_ways(subject: Subject) -> Iterator[Compute]:
    """Yield the derivatives of NumPy and, where there is a compiler, of C."""
    found = find_derivatives(subject.kernel)
    assert found is not None
    yield found
    in_c = find_in_c(subject.quantity.name, reverse_mode.differentiate(subject.paper))
    yield from [in_c] if in_c else []


def worst_of(subject: Subject) -> tuple[float, int]:
    """Return the largest error, in eps of its scale, and the number of decided derivatives."""
    quantity, truth = subject.quantity, Truth(subject)
    _, within = accuracy_of(quantity)
    assert quantity.accuracy is not None
    bounded = replace(
        subject, quantity=replace(quantity, accuracy=replace(quantity.accuracy, within=within))
    )
    ways = list(list_ways(subject))
    worst, decided = 0.0, 0
    for points in (one for one in list_sets(subject, 0.05) if not one.ordered):
        arguments = take(subject, points)
        held = mark_accuracy_domain(bounded, arguments)
        scales = find_truth(subject, arguments).scale if quantity.accuracy.scale else None
        with np.errstate(all="ignore"):
            computed = [compute(*arguments) for compute in ways]
        for i, values in enumerate(list_values(subject, arguments)):
            entries = truth.evaluate(values) if held[i] else ()
            for j, (found, conditioning) in enumerate(entries):
                (slope, *sides), size = found, abs(values[truth.symbols[j]])
                # Far from zero the running variable scales nothing.
                size = size if j else min(size, 1.0)
                if sides or not slope.is_finite() or slope.rel_accuracy_bits() < 60:
                    continue
                decided += 1
                own = scales[i] / size if scales is not None and size else 0.0
                scale = conditioning + (own if np.isfinite(own) else 0.0)
                for error in (abs(arb(float(got[i, j])) - slope) for got in computed):
                    if not error < TINY:
                        lost = float(error / scale) / EPS if error.is_finite() else np.inf
                        worst = max(worst, lost)
    return worst, decided


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(DERIVATIVES))
def test_derivatives_keep_their_bound(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slopes, "BITS", 400)
    subject = find_subject(name)
    bound, _ = accuracy_of(subject.quantity)
    worst, decided = worst_of(subject)
    assert decided > 10
    assert worst <= bound


def differentiate_by_jax(name: str) -> Compute:
    """Differentiate the formula of a quantity, or of the first form that is offered instead."""
    try:
        text = mechproof.formula(name).array_api
    except NotImplementedError as refusal:
        name = str(refusal).split("; ")[1].split()[0]
        text = mechproof.formula(name).array_api
    return lambda *points: by_jax.compute(text, name.replace(".", "_"), points, slopes=True)


# Quantities for which derivatives of single steps cancel, as near e = 1, or one is infinite, as
# that of a root of zero where |A| = R.
LOST = {
    *("elliptic_planetary.jerk", "oval_planetary.acceleration", "oval_planetary.jerk"),
    *("oval_planetary.acceleration_cylindrical", "oval_planetary.jerk_cylindrical"),
    *("oval_planetary.position", "oval_planetary.ratio", "track_wheel.radius"),
}
FEW = ("elliptic_planetary.position", "track_wheel.radius", "oval_planetary.ratio")


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", first_of([*FEW, *sorted({*DERIVATIVES} - {*FEW})], count=len(FEW) + 1)
)
def test_jax_differentiates_formulas_within_the_same_bound(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(slopes, "BITS", 400)
    compute = differentiate_by_jax(name)
    monkeypatch.setattr("test_derivatives.list_ways", lambda _: iter([compute]))
    subject = find_subject(name)
    worst, decided = worst_of(subject)
    assert decided > 10
    assert (worst > accuracy_of(subject.quantity)[0]) == (name in LOST)


def test_an_error_of_some_eps_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slopes, "BITS", 400)
    subject = find_subject("elliptic_planetary.largest_ratio")
    compute = find_derivatives(subject.kernel)
    assert compute is not None
    monkeypatch.setattr(
        "test_derivatives.find_derivatives", lambda _: lambda *a: compute(*a) * (1 + 20 * EPS)
    )
    assert worst_of(subject)[0] > 4


def test_every_derivative_that_is_shipped_is_proved() -> None:
    rows = json.loads((GENERATED / "ledger.json").read_text(encoding="utf-8"))["rows"]
    verdicts = {row["id"]: row["verdict"] for row in rows if "derivatives of" in row["number"]}
    shipped = [
        s.name
        for s in find_subjects()
        if s.paper.derivatives
        and s.quantity.slopes is not None
        and reverse_mode.is_exact_scalar(s.quantity)
    ]
    assert sorted(shipped) == sorted(DERIVATIVES)
    assert len(verdicts) >= len(DERIVATIVES)
    assert set(verdicts.values()) == {"PROVED"}


def test_a_wrong_derivative_is_refuted(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = elliptic_planetary.PAPER
    one = next(q for q in whole.quantities if q.name == "largest_ratio")
    paper = replace(whole, quantities=(one,), one_pass=())
    right = reverse_mode._go_back

    def double(*given: Any) -> sp.Basic:
        return right(*given) * 2

    monkeypatch.setattr(reverse_mode, "_go_back", double)
    (row,) = derivative_rows(paper)
    assert judge(row, reverse_mode.differentiate(paper)).verdict is Verdict.REFUTED


def test_a_row_on_derivatives_says_of_what_they_are() -> None:
    whole = elliptic_planetary.PAPER
    one = next(q for q in whole.quantities if q.name == "largest_ratio")
    (row,) = derivative_rows(replace(whole, quantities=(one,), one_pass=()))
    assert isinstance(row.says, Equality)
    of = row.says.differentiated
    assert of is not None
    assert of.expression == one.definition
    assert list(of.by) == [argument.symbols[0] for argument in one.arguments]


def test_derivatives_whose_source_says_something_else_are_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    whole = elliptic_planetary.PAPER
    one = next(q for q in whole.quantities if q.name == "largest_ratio")
    paper = replace(whole, quantities=(one,), one_pass=())
    read_derivatives_back(paper)
    render = form_rows.render_derivatives
    monkeypatch.setattr(
        form_rows,
        "render_derivatives",
        lambda paper: {n: text.replace("1.0 + e", "1.0 - e") for n, text in render(paper).items()},
    )
    with pytest.raises(SourceError):
        read_derivatives_back(paper)


def test_the_chain_of_the_wedge_agrees_with_its_velocity_and_sensitivities() -> None:
    sizes = {name: nominal for name, (nominal, *_) in wedge_linkage.PUBLISHED[0].sizes.items()}
    x1 = np.linspace(-38, -5, 12)
    found = of_wedge.position(x1, **sizes)
    expected = wedge_linkage.sensitivities(x1, **sizes)
    np.testing.assert_allclose(found[:, 0], wedge_linkage.velocity(x1, **sizes), rtol=1e-12)
    np.testing.assert_allclose(found[:, 1:], expected, rtol=1e-11, atol=1e-12)


def test_derivatives_are_found_by_name_and_of_kernels_alone() -> None:
    slopes_of = differentiate(kernels.ratio, {"phi1": [0.0, 0.3], "R1": 66, "R2": 16, "e": 0.475})
    assert slopes_of is not None
    assert list(slopes_of) == ["phi1", "R1", "R2", "e"]
    expected = kernels.acceleration([0.0, 0.3], 66, 16, 0.475)
    np.testing.assert_allclose(slopes_of["phi1"], expected, rtol=1e-14)
    assert differentiate(np.hypot, {}) is None
    assert find_derivatives(wedge_linkage.sensitivities) is None
