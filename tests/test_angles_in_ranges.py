"""Angles that a sine, a cosine or a tangent gives, in a range that is said."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Judgement

pytestmark = pytest.mark.usefixtures("judged_here")


def judge(latex: str, *where: str) -> Judgement:
    (judgement,) = judge_pasted(Pasted(latex, where=where)).judgements
    return judgement


# What is said of an angle makes it an inverse sine, cosine or tangent.
CRANK = (r"l\sin\psi=r\sin\varphi", "l>r>0")
KEPLER = (r"\tan\frac\nu2=\sqrt{\frac{1+e}{1-e}}\tan\frac E2", r"0\le e<1", r"-\pi<E<\pi")
ANOMALY = r"\nu=\arcsin\frac{\sqrt{1-e^2}\sin E}{1%se\cos E}"
INVERTED = [
    (r"\sqrt{l^2-r^2\sin^2\varphi}=%sl\cos\psi", "", "-", (*CRANK, r"|\psi|<\frac\pi2")),
    (r"\sin^2\beta=1-%s", "x^2", "x", (r"\cos\beta=x", r"0\le\beta\le\pi")),
    (r"\cos\nu=\frac{\cos E%se}{1-e\cos E}", "-", "+", (*KEPLER, r"-\pi<\nu<\pi")),
    (ANOMALY, "-", "+", (*KEPLER, r"-\frac\pi2<\nu<\frac\pi2")),
]


@pytest.mark.parametrize(("latex", "true", "wrong", "where"), INVERTED)
def test_a_function_in_a_range_gives_a_letter(
    latex: str, true: str, wrong: str, where: tuple[str, ...]
) -> None:
    assert judge(latex % true, *where).verdict == "PROVED"
    assert judge(latex % wrong, *where).verdict == "REFUTED"


def test_a_function_in_a_wider_range_does_not() -> None:
    assert judge(ANOMALY % "-", *KEPLER, r"-\pi<\nu<\pi").verdict == "REFUTED"
    for said in ((), (r"-\pi<\psi<\pi",), (r"0<\psi<2",)):
        with pytest.raises(ValueError, match="it cannot be solved for a letter"):
            judge(r"\sqrt{l^2-r^2\sin^2\varphi}=l\cos\psi", *CRANK, *said)
