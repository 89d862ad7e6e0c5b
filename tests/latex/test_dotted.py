r"""Sums and products with dots: which terms they stand for, and what is refused."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.latex.text import write
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict
from mechproof.record import Variable

# A print, and one that is slightly wrong, both for natural numbers n.
ROWS = [
    (r"1+2+\dots+n=\frac{n(n+1)}2", r"1+2+\dots+n=\frac{n(n-1)}2"),
    (r"1+2+\dots+(n-1)+n=\frac{n(n+1)}2", r"1+2+\dots+(n-1)+n=n^2"),
    (r"1+3+5+\ldots+(2n-1)=n^2", r"1+3+5+\ldots+(2n+1)=n^2"),
    (r"2+4+\dots+2n=n(n+1)", r"2+4+\dots+2n=n^2"),
    (r"1+2+4+\dots+2^{n-1}=2^n-1", r"1+2+4+\dots+2^{n-1}=2^n"),
    (
        r"\frac1{1\cdot2}+\frac1{2\cdot3}+\dots+\frac1{n(n+1)}=1-\frac1{n+1}",
        r"\frac1{1\cdot2}+\frac1{2\cdot3}+\dots+\frac1{n(n+1)}=1-\frac1n",
    ),
    (
        r"\frac12+\cos x+\cos2x+\dots+\cos nx=\frac{\sin\left(n+\frac12\right)x}{2\sin\frac x2}",
        r"1+\cos x+\cos2x+\dots+\cos nx=\frac{\sin\left(n+\frac12\right)x}{2\sin\frac x2}",
    ),
    (r"n!=1\cdot2\cdot3\cdots n", r"n!=2\cdot3\cdot4\cdots(n+2)"),
    (r"1\cdot3\cdots(2n-1)=\frac{(2n)!}{2^nn!}", r"1\cdot3\cdots(2n-1)=\frac{(2n)!}{n!}"),
    (r"1^3+2^3+\dots+n^3=(1+2+\dots+n)^2", r"1^3+2^3+\dots+n^3=(1+2+\dots+n)^3"),
]
# Dots that stand for nothing, or for more than one thing.
REFUSED = [
    r"1+\dots+n=1",
    r"1+2+\dots+x=3",
    r"1+1+\dots+1=n",
    r"1+3+\dots+n=1",
    r"1-1+1-\dots+(-1)^n=1",
    r"n+(n-1)+\dots+1=1",
    r"a_1+a_2+\dots+a_n=1",
    r"1+2+\dots+n-1=1",
    r"1+2+\dots+n+1=1",
    r"\sin x=x-\frac{x^3}{3!}+\cdots",
]


@pytest.mark.parametrize(("latex", "wrong"), ROWS)
def test_dots_stand_for_the_terms_that_the_last_one_gives(latex: str, wrong: str) -> None:
    for printed, verdict in ((latex, Verdict.PROVED), (wrong, Verdict.REFUTED)):
        (judgement,) = judge_pasted(Pasted(printed)).judgements
        assert judgement.verdict is verdict


@pytest.mark.parametrize("latex", REFUSED)
def test_dots_that_may_stand_for_anything_are_refused(latex: str) -> None:
    with pytest.raises(ReadingError, match=r"dots|last term"):
        judge_pasted(Pasted(latex))


def test_the_last_term_is_told_as_it_stands() -> None:
    n = Variable(sp.Symbol("n", integer=True, positive=True), "n", latex=("n",))
    (chain,) = Reader((n,), None).parse(r"1+3+\dots+(2n-1)").chains
    assert write(chain.members[0]) == "1 + 3 + ... + (2*n - 1)"
