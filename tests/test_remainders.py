"""Single equations that end in a remainder, O(x^n) or o(x^n)."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# An approximation, a remainder that is true, and one that is not.
PAIRS = [
    (r"\sin x=x-\frac{x^3}6", "O(x^5)", "O(x^6)"),
    (r"\sin x=x-\frac{x^3}6", "o(x^4)", "o(x^5)"),
    (r"\cos x=1-\frac{x^2}2", r"O\left(x^4\right)", r"O\left(x^5\right)"),
    (r"\ln(1+x)=x-\frac{x^2}2", r"O(x^3)\quad(x\to0)", r"O(x^4)\quad(x\to0)"),
    (r"\ln(1+x)=x-\frac{x^2}2", r"\mathcal O(x^3),\ x\to0", r"\mathcal O(x^4),\ x\to0"),
    (r"\frac1{\sin x}=\frac1x", "O(x)", "o(x)"),
    (r"(1+x)^a=1+ax+\frac{a(a-1)}2x^2", "O(x^3)", "x^2+O(x^3)"),
    (
        r"\sqrt{1-\lambda^2\sin^2\varphi}=1-\frac{\lambda^2}2\sin^2\varphi",
        r"O(\lambda^4)",
        r"\lambda^2+O(\lambda^4)",
    ),
    (
        r"\operatorname{inv}\alpha=\frac{\alpha^3}3+\frac{2\alpha^5}{15}",
        r"O(\alpha^7)",
        r"O(\alpha^8)",
    ),
]
# Fractional powers, two sides that differ, oscillation, and letters of which nothing is stated.
NOT_PROVED = [
    (r"1=1+\sqrt x+O(x)", ("x>0",)),
    ("|x|=x+O(x^2)", ()),
    (r"x\sin\frac1x=0+o(x)", ()),
    (r"\ln x=1+O(x)", ()),
    ("y=x+O(x^2)", ()),
]


def judge(latex: str, where: tuple[str, ...] = ()) -> Verdict:
    (found,) = judge_pasted(Pasted(latex, where=where)).judgements
    assert found.printed_latex == latex
    return found.verdict


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "true", "wrong"), PAIRS)
def test_a_remainder_has_its_order(latex: str, true: str, wrong: str) -> None:
    assert judge(f"{latex}+{true}") is Verdict.PROVED
    assert judge(f"{latex}+{wrong}") is Verdict.REFUTED


@pytest.mark.parametrize(("latex", "where"), NOT_PROVED)
def test_a_remainder_that_is_larger_is_not_proved(latex: str, where: tuple[str, ...]) -> None:
    assert judge(latex, where) is not Verdict.PROVED
