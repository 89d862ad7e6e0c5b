"""Pasted formulas as formula collections print them, each next to one that is slightly wrong."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A print with a place for a part, the true part, a wrong one, and the conditions stated.
PAIRS = [
    (r"\tanh(\ln x)=\frac{x^2-1}{%s}", "x^2+1", "x^2+2", ("x>0",)),
    (r"\cosh(\ln x)=\frac{x^2+1}{%s}", "2x", "x", ("x>0",)),
    (r"\sum_{n=0}^\infty\frac{(-1)^n}{(2n+1)^3}=%s", r"\frac{\pi^3}{32}", r"\frac{\pi^3}{16}", ()),
    # A cosine series is even; beyond its period it has other values.
    (
        r"\sum_{n=1}^\infty\frac{\cos(2n-1)x}{(2n-1)^2}=\frac{\pi^2}8-\frac\pi4%s",
        "|x|",
        "x",
        (r"-\pi\le x\le\pi",),
    ),
    (
        r"\sum_{n=1}^\infty\frac{\cos nx}{n^2}=\frac{x^2}4-\frac\pi2%s+\frac{\pi^2}6",
        "|x|",
        "x",
        (r"-2\pi\le x\le2\pi",),
    ),
]
# Prints with the conditions stated, under which they are not true everywhere.
WRONG = [
    (
        r"\sum_{n=1}^\infty\frac{\cos(2n-1)x}{(2n-1)^2}=\frac{\pi^2}8-\frac\pi4|x|",
        (r"-\pi\le x\le2\pi",),
    ),
]


def judge(latex: str, where: tuple[str, ...]) -> Verdict:
    (found,) = judge_pasted(Pasted(latex, where=where)).judgements
    return found.verdict


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "true", "wrong", "where"), PAIRS, ids=[p[0] for p in PAIRS])
def test_a_formula_is_proved_and_a_wrong_one_refuted(
    latex: str, true: str, wrong: str, where: tuple[str, ...]
) -> None:
    assert judge(latex % true, where) is Verdict.PROVED
    assert judge(latex % wrong, where) is Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "where"), WRONG)
def test_a_formula_is_not_proved_where_it_fails(latex: str, where: tuple[str, ...]) -> None:
    assert judge(latex, where) is not Verdict.PROVED
