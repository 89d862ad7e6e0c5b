"""Sums of fractions without end, and of waves, and products, each beside a wrong one."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.fraction_sums import _find_digamma
from mechproof.proof.verdict import Verdict

APART = (r"x\notin\mathbb Z",)
# The print with a place for a part, the true part, a wrong one, and what is said.
PAIRS = [
    (r"\sum_{n=1}^\infty\frac1{n^2+1}=\frac{\pi\coth\pi%s1}2", "-", "+", ()),
    (r"\sum_{n=%s}^\infty\frac1{n^2+n+1}=\frac\pi{\sqrt3}\tanh\frac{\pi\sqrt3}2", "0", "1", ()),
    (r"\sum_{n=1}^\infty\frac1{n^4+4}=\frac{\pi\coth\pi}8-\frac1%s", "8", "4", ()),
    (r"\sum_{n=-\infty}^\infty\frac1{n^2+a^2}=\frac\pi a%s(\pi a)", r"\coth", r"\tanh", ("a>0",)),
    (
        r"\sum_{n=1}^\infty\frac1{bn^2+1}=\frac\pi{2\sqrt b}\coth\frac\pi{\sqrt b}-%s",
        r"\frac12",
        "1",
        ("b>0",),
    ),
    (r"\pi\cot\pi x=\frac1x+\sum_{n=1}^\infty\frac{%sx}{x^2-n^2}", "2", "", APART),
    (r"\pi\cot\pi x=\frac1x+\sum_{n=1}^\infty\frac{2x}{x^2%sn^2}", "-", "+", APART),
    (r"\frac\pi{\sin\pi x}=\frac1x+2x\sum_{n=1}^\infty\frac{(-1)^n}{x^2-n^2}%s", "", "+x", APART),
    (r"\tan x=\sum_{n=%s}^\infty\frac{8x}{(2n+1)^2\pi^2-4x^2}", "0", "1", ("0<x<1",)),
    (r"\coth x=\frac1x+\sum_{n=1}^\infty\frac{2x}{x^2+%sn^2\pi^2}", "", "4", (r"x\ne0",)),
    (
        r"\sum_{n=1}^\infty\frac{n\sin nx}{n^2+1}=\frac{\pi\sinh(%s-x)}{2\sinh\pi}",
        *(r"\pi", r"2\pi"),
        ("0<x<2\\pi",),
    ),
    (
        r"\sum_{n=0}^\infty\frac{\cos(2n+1)x}{(2n+1)^2+1}=\frac{\pi\sinh(%s-x)}{4\cosh\frac\pi2}",
        *(r"\frac\pi2", r"\pi"),
        (r"0\le x\le\pi",),
    ),
    (
        r"\sin x=\frac2\pi-\frac4\pi\sum_{n=%s}^\infty\frac{\cos2nx}{4n^2-1}",
        *("1", "0"),
        (r"0\le x\le\pi",),
    ),
    # Anywhere, as both sides repeat themselves.
    (
        r"|\sin x|=\frac2\pi-\frac4\pi\sum_{n=%s}^\infty\frac{\cos2nx}{4n^2-1}",
        *("1", "0"),
        (),
    ),
    (
        r"|\cos x|=\frac2\pi-\frac4\pi\sum_{n=1}^\infty\frac{%s\cos2nx}{4n^2-1}",
        *("(-1)^n", "(-1)^{n+1}"),
        (),
    ),
    # By the digamma function.
    (r"\sum_{n=0}^\infty\frac1{(3n+1)(3n+2)}=\frac\pi{%s\sqrt3}", "3", "2", ()),
    (r"\sum_{n=0}^\infty\frac{(-1)^n}{3n+1}=\frac13\ln2%s\frac\pi{3\sqrt3}", "+", "-", ()),
    (r"\sum_{n=1}^\infty\frac{(-1)^{n+1}}{n(n+1)}=%s\ln2-1", "2", "3", ()),
    (r"\sum_{n=1}^\infty\frac1{n(2n+1)}=%s-2\ln2", "2", "1", ()),
    (r"\sum_{n=1}^\infty\frac1{n^2(n+1)^2}=\frac{\pi^2}3-%s", "3", "2", ()),
    (r"\sum_{n=2}^\infty\frac{(-1)^n}{(n-1)^2n}=\frac{\pi^2}{12}+1-%s\ln2", "2", "3", ()),
    # Waves times binomial coefficients.
    (
        r"\sum_{k=0}^n\binom nk\cos kx=2^n\cos^n\frac x2\cos\frac{nx}%s",
        *("2", "1"),
        (),
    ),
    (r"\sum_{k=%s}^n\binom nk\sin(kx+a)=2^n\cos^n\frac x2\sin(\frac{nx}2+a)", "0", "1", ()),
    (r"\sum_{k=0}^n(-1)^k\binom nk\cos2kx=%s^n\sin^nx\cos(nx+\frac{n\pi}2)", "(-2)", "2", ()),
    # Products.
    (r"\sin x=x\prod_{n=1}^\infty\left(1-\frac{x^2}{n^2%s}\right)", r"\pi^2", r"\pi", ()),
    (r"\sinh x=x\prod_{n=1}^\infty\left(1%s\frac{x^2}{n^2\pi^2}\right)", "+", "-", ()),
    (r"\cos x=\prod_{n=1}^\infty\left(1-\frac{%sx^2}{(2n-1)^2\pi^2}\right)", "4", "2", ()),
    (r"\cosh x=\prod_{n=0}^\infty\left(1+\frac{%sx^2}{(2n+1)^2\pi^2}\right)", "4", "2", ()),
    (r"\prod_{n=1}^\infty\frac{4n^2}{4n^2-1}=\frac\pi%s", "2", "4", ()),
    (r"\prod_{n=%s}^\infty\left(1+\frac1{n^2}\right)=\frac{\sinh\pi}{2\pi}", "2", "1", ()),
    (r"\prod_{n=1}^\infty\frac{n^2}{n^2-x^2}=\frac{\pi x}{%s\pi x}", r"\sin", r"\tan", APART),
]
# A pole, an end or a letter for which a sum has no value, or another one.
NOT_PROVED = [
    (r"\sum_{n=1}^\infty\frac{n\sin nx}{n^2+1}=\frac{\pi\sinh(\pi-x)}{2\sinh\pi}", (r"0\le x<1",)),
    (r"\sum_{n=1}^\infty\frac{\cos nx}{n^2+1}=\frac{\pi\cosh(\pi-x)}{2\sinh\pi}-\frac12", ()),
    (r"\sin x=\frac2\pi-\frac4\pi\sum_{n=1}^\infty\frac{\cos2nx}{4n^2-1}", ()),
    (r"\sum_{n=1}^\infty\frac{\sin nx}n=\frac{\pi-x}2", ()),
    (r"\pi\cot\pi x=\frac1x+\sum_{n=1}^\infty\frac{2x}{x^2-n^2}", ("0<x<2",)),
    (r"\sum_{n=-\infty}^\infty\frac1{n^2-a^2}=-\frac\pi a\cot(\pi a)", ("a>0",)),
    (
        r"\sum_{n=1}^\infty\frac1{bn^2+1}=\frac\pi{2\sqrt b}\coth\frac\pi{\sqrt b}-\frac12",
        (r"b\ge0",),
    ),
    (r"\sum_{n=0}^\infty\frac1{n^2-1}=-\frac34", ()),
    (r"\prod_{n=1}^\infty\frac{n^2}{n^2-a^2}=\frac{\pi a}{\sin\pi a}", ("a>0",)),
    (r"\frac{\sin x}x=\prod_{n=1}^\infty\left(1-\frac{x^2}{n^2\pi^2}\right)", ()),
]


def judge(latex: str, where: tuple[str, ...]) -> set[Verdict]:
    return {found.verdict for found in judge_pasted(Pasted(latex, where=where)).judgements}


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "true", "false", "where"), PAIRS)
def test_a_value_is_proved_and_a_wrong_one_refuted(
    latex: str, true: str, false: str, where: tuple[str, ...]
) -> None:
    assert judge(latex % true, where) == {Verdict.PROVED}
    assert judge(latex % false, where) == {Verdict.REFUTED}


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "where"), NOT_PROVED)
def test_where_there_is_no_such_value_nothing_is_proved(latex: str, where: tuple[str, ...]) -> None:
    assert Verdict.PROVED not in judge(latex, where)


@pytest.mark.parametrize("number", ["1", "5/2", "1/3", "7/4", "5/6", "3/8", "11/12", "29/7"])
def test_the_digamma_function_of_a_fraction(number: str) -> None:
    rational = sp.Rational(number)
    difference = _find_digamma(rational) - sp.digamma(rational) - sp.EulerGamma
    assert abs(difference.n(30)) < 1e-20
