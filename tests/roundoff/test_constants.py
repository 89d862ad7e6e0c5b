"""Constants that are not doubles are rounded where written, which bounds and search both see."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from mechproof.programs.kernel import list_functions
from mechproof.record import Argument, Chart, Form, Paper, Quantity, Variable
from mechproof.roundoff import certificate, worst
from mechproof.roundoff.certificate import cover_all, list_stages, make_claim
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.running import IN_DOUBLES
from mechproof.roundoff.steps import CONSTANT, Step

x = sp.Symbol("x", real=True)
ODD = 2**53 + 1


def write_paper(expression: sp.Expr) -> Paper:
    chart = Chart("0 <= x <= 1", {x: x}, {x: sp.Interval(0, 1)})
    form = Form("as it is", expression, charts=(chart,))
    quantity = Quantity("f", "Compute f.", (Argument("x", (x,), "x"),), expression, (form,), "here")
    return Paper("own", "A paper", variables=(Variable(x, "x"),), rows=(), quantities=(quantity,))


def subjects_of(expression: sp.Expr) -> list[ComputedStage]:
    paper = write_paper(expression)
    return [s for kernel in list_functions(paper) for s in list_computed_stages(kernel, paper)]


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certificate, "MOST", 200)
    monkeypatch.setattr(worst, "CLIMBS", 1)
    monkeypatch.setattr(worst, "ROUNDS", 5)


def is_shown(subject: ComputedStage, bound: float) -> bool:
    return all(cover.open is None for _, cover in cover_all(subject, bound, 200))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("expression", "rounded"),
    [
        (x * ODD, 1),
        (x + ODD, 1),
        (x / ODD, 1),
        (x * 10**30, 1),
        (x * sp.Rational("0.1234567890123456789"), 1),
        (x * sp.Rational(ODD, 2**53), 1),
        (sp.sqrt(ODD) * x, 1),
        (sp.Max(x, ODD), 1),
        (sp.pi * x + 1, 1),
        (sp.E * x + sp.pi, 2),
        (x * (2**60 + 1) + 2**60 + 1, 1),
        (x * 2**60 + 10, 0),
        (x * sp.Rational(1, 10), 0),
    ],
    ids=str,
)
def test_a_constant_that_is_no_double_is_rounded(expression: sp.Expr, rounded: int) -> None:
    for subject in subjects_of(expression):
        constants = [step for step in subject.straight.steps if step.kind == CONSTANT]
        assert len(constants) == rounded
        claim = make_claim(subject)
        assert 0.1 < claim.found <= claim.proved < 2
        assert is_shown(subject, claim.proved)
        assert not is_shown(subject, 1e-9)


@pytest.mark.parametrize(
    ("expression", "least", "most"),
    [(2 * x, 0, 0), (x / 3, 0.49, 0.52), (sp.Max(x, sp.Rational(1, 3)), 0.25, 0.5)],
    ids=str,
)
def test_a_bound_below_an_eps_is_found(expression: sp.Expr, least: float, most: float) -> None:
    for subject in subjects_of(expression):
        assert least <= make_claim(subject).proved <= most


def test_a_search_sees_a_constant_taken_for_exact() -> None:
    def forget(step: Step) -> Step:
        if step.kind == CONSTANT:
            # Replace the constant by its own double: the computed value stays the same.
            (number,) = step.operands
            above, below = float(IN_DOUBLES[CONSTANT](number)).as_integer_ratio()
            return replace(step, operands=(f"{above}/{below}",))
        return replace(step, ulps=0.0) if step.kind == "multiply" else step

    for subject in subjects_of(x * ODD):
        steps = tuple(map(forget, subject.straight.steps))
        wrong = replace(subject, straight=replace(subject.straight, steps=steps))
        with pytest.raises(ArithmeticError, match=r"0\.49.* eps at .* at most 0\.0 are proved"):
            make_claim(wrong)


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (sp.exp(x), "roundings of exp cannot be bounded"),
        ((x + 1) ** sp.Rational(1, 3), "roundings of power cannot be bounded"),
    ],
    ids=str,
)
def test_what_has_no_rule_is_refused_by_name(expression: sp.Expr, message: str) -> None:
    paper = write_paper(expression)
    (kernel,) = list_functions(paper)
    with pytest.raises(ValueError, match=f"own.f: {message}"):
        list_stages(kernel, paper)


@pytest.mark.parametrize("constant", [10**400, sp.Rational(1, 2**1080)], ids=["large", "small"])
def test_a_constant_beyond_the_doubles_is_refused(constant: sp.Expr) -> None:
    with pytest.raises(NotImplementedError, match="beyond the range of doubles"):
        subjects_of(x * constant)
