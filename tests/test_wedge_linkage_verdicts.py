"""The verdict of every row of the paper."""

from __future__ import annotations

import dataclasses
from functools import cache

import pytest
import sympy as sp

from mechproof.derivations import wedge_linkage as paper
from mechproof.derivations.wedge_linkage import PAPER
from mechproof.proof import balls
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality


@cache
def judgement(number: str) -> Judgement:
    return judge(next(row for row in PAPER.rows if row.number == number), PAPER)


def test_no_error_rests_on_a_rebuilt_or_reconstructed_reading() -> None:
    charged = (Verdict.REFUTED, Verdict.ILL_FORMED)
    assert not [row.number for row in PAPER.rows if judgement(row.number).verdict in charged]


def test_what_rests_on_the_reconstructions_is_marked() -> None:
    numbers = ("boundary II", "boundary III", "boundary IV", "largest spread", "crossing")
    assert all("calibrated" in judgement(number).marks for number in numbers)
    for number in ("crossing", "deviation at -40"):
        assert "fitted" in judgement(number).marks


WRONG = {
    "(3)": paper.l_DE * (paper.cos(paper.alpha_DE - paper.phi3) - paper.cos(paper.alpha_DE)),
    "(10)": paper.l_LM * (paper.sin(paper.phi7 + paper.alpha_LM) + paper.sin(paper.alpha_LM)),
    "(8)": paper.print_7.subs(paper.R, paper.l_KL * paper.cosine_of_sigma),
    "(1)": paper.print_1.subs(paper.l_CD, paper.l_AB),
    "sensitivity of varphi3 to x1": -paper.lever_slopes[paper.x1],
}


@pytest.mark.parametrize("number", WRONG)
def test_a_slightly_wrong_formula_is_refuted(number: str) -> None:
    row = next(row for row in PAPER.rows if row.number == number)
    assert isinstance(row.says, Equality)
    wrong = dataclasses.replace(row.says, printed=WRONG[number])
    assert decide(wrong, Domain.of(PAPER, row.on)).verdict is Verdict.REFUTED


def test_the_other_signs_of_iv_are_not_lowest() -> None:
    wrong = {**paper.BOUNDARY_IV, paper.alpha_DE: 1}
    for table in (paper.CALIBRATED, paper.ALTERNATIVE):
        says = paper.above(table, paper.BOUNDARY_IV, wrong, -40)
        assert decide(says, Domain.of(PAPER)).verdict is Verdict.REFUTED


def test_balls_of_an_undefined_arctangent_are_not_finite() -> None:
    y, x = sp.symbols("y x", real=True)
    undefined = sp.atan2(sp.sqrt(y), x)
    assert not balls.evaluate(undefined, {y: -1, x: 1}).is_finite()
    assert balls.evaluate(undefined, {y: 1, x: -1}).is_finite()


def test_evidence_of_exact_numbers_shows_both_sides() -> None:
    says = paper.above(paper.CALIBRATED, paper.BOUNDARY_II, paper.BOUNDARY_IV, -40)
    (evidence,) = decide(says, Domain.of(PAPER)).evidence
    assert "-110.1" in evidence.what
    assert "-134.9" in evidence.what
