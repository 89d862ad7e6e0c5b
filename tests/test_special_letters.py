"""Single equations: letters that may be none, and letters that have values."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

PROVED, REFUTED = Verdict.PROVED, Verdict.REFUTED

# A print, what is said of its letters, and its verdict.
ROWS = [
    (r"e^x\ge1+x", (), (), PROVED),
    (r"e^x\ge1+x+x^2", (), (), REFUTED),
    (r"\int_0^1e^x\,dx=e-1", (), (), PROVED),
    (r"\frac d{dx}e^{-x^2}=-2xe^{-x^2}", (), (), PROVED),
    (r"\ln e^x=x", (), (), PROVED),
    # An e that has a value, or is named, is what is said.
    (r"e^x=2^x", ("e=2",), (), PROVED),
    (r"\frac{\pi D^2}4-\frac{\pi d^2}4=\frac\pi4(D-d)(D+d)", (), (), PROVED),
    (r"\frac d2+\frac d2=d", (), (), PROVED),
    (r"\frac n{n+1}<1\quad(n\in\mathbb N)", (), (), PROVED),
    (r"|\sin x|\le1,\quad x\in\mathbb{R}", (), (), PROVED),
    (r"|\sin x|<1\quad(x\in\mathbb{R})", (), (), REFUTED),
    (r"\sin(\pi n)=0", (), (r"n\in\mathbb N",), PROVED),
    (r"\int_0^\pi\cos(nx)\,dx=0", (), (r"n\in\mathbb N",), PROVED),
    (r"\int_0^\pi\cos(nx)\,dx=0", (), (r"n\in\mathbb N_0",), REFUTED),
    (r"\cos(m\pi)\cos(n\pi)=(-1)^{m+n}\text{ for }m,n\in\mathbb{N}", (), (), PROVED),
    # What gives a letter has a real value.
    (r"|x|\le R", (r"y=\sqrt{R^2-x^2}",), ("R>0",), PROVED),
    (r"|x|\le R-1", (r"y=\sqrt{R^2-x^2}",), ("R>0",), REFUTED),
    (r"x\ge1", (r"t=\ln(x-1)",), (), PROVED),
    (r"x\ge2", (r"t=\ln(x-1)",), (), REFUTED),
    (r"x\ne0", (r"y=\frac1x",), (), PROVED),
    (r"|x|=x", (r"y=\sqrt x",), (), PROVED),
    (r"|x|=x", (r"y=\sqrt[3]x",), (), REFUTED),
]


@pytest.mark.parametrize(("latex", "values", "where", "verdict"), ROWS)
def test_a_letter_is_what_it_is_taken_for(
    latex: str, values: tuple[str, ...], where: tuple[str, ...], verdict: Verdict
) -> None:
    (judgement,) = judge_pasted(Pasted(latex, values=values, where=where)).judgements
    assert judgement.verdict is verdict


def test_what_an_e_is_taken_for_is_told() -> None:
    assert judge_pasted(Pasted(r"e^x>0")).taken["e"] == "Euler's number"
