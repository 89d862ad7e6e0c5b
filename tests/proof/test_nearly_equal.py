r"""Approximations between formulas, \sin\theta\approx\theta: never proved, never refuted."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

BEYOND = "after all printed terms"
DIFFERS = "so a printed term differs"
# An approximation, with what its difference begins, and where.
SERIES = [
    (r"\sin x\approx x", "-x**3/6", BEYOND),
    (r"\sin x\approx 2x", "-x", DIFFERS),
    (r"\cos x\approx1-\frac{x^2}2", "x**4/24", BEYOND),
    (r"\cos x\approx1-x^2", "x**2/2", DIFFERS),
    (r"\cos x\approx1", "-x**2/2", BEYOND),
    (r"a\tan x\simeq ax", "a*x**3/3", BEYOND),
    (r"\frac{1}{1-x}\approx1+x", "x**2", BEYOND),
    (r"\frac{1}{1-x}\approx1-x", "2*x", DIFFERS),
    (r"(1+x)^2\approx1+2x", "x**2", BEYOND),
]
WITHOUT = [r"|x|\approx x", r"\frac1x\approx1-x", r"x\approx\sin x", r"a\approx b+c"]
LETTERS = "%% mechproof\n%% \\theta : angle [rad]\n%% y ; z : numbers\n%% end\n"


def judge(latex: str) -> tuple[Verdict, str]:
    (found,) = judge_pasted(Pasted(latex)).judgements
    return found.verdict, found.reason


@pytest.mark.parametrize(("latex", "begins", "said"), SERIES)
def test_the_order_of_what_is_left_out_is_told(latex: str, begins: str, said: str) -> None:
    verdict, reason = judge(latex)
    assert verdict is Verdict.UNDECIDED
    assert reason.endswith(f"left - right begins with {begins}, {said}")


@pytest.mark.parametrize("latex", WITHOUT)
def test_nothing_more_is_said_of_what_begins_no_series(latex: str) -> None:
    assert judge(latex) == (
        Verdict.UNDECIDED,
        "an approximation: it does not say how close the two sides are meant to be",
    )


def test_a_letter_that_is_nearly_a_number_is_given_by_it() -> None:
    assert judge(r"F\approx1")[0] is Verdict.DEFINITION


def test_what_is_nearly_a_number_only_somewhere_ends_no_run() -> None:
    text = LETTERS + r"$$\cos\theta\approx1$$ $$y=\cos\theta$$"
    assert [row.outcome for row in check("paper.tex", text).rows] == ["not judged", "DEFINITION"]


def test_an_approximation_defines_nothing_and_leaves_its_chain_judged() -> None:
    prints = r"y=\sin\theta\approx\theta", r"y=\theta", r"z\approx\theta", r"z=\theta^2"
    text = LETTERS + "".join(f"$${x}$$" for x in prints)
    outcomes = [row.outcome for row in check("paper.tex", text).rows]
    assert outcomes == ["DEFINITION", "not judged", "REFUTED", "not judged", "DEFINITION"]
