"""Pasted formulas as formula collections print them, each next to one that is slightly wrong."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

TRIANGLE = (r"A+B+C=\pi", "A>0", "B>0", "C>0")
# A print with a place for a part, the true part, a wrong one, and the conditions stated.
PAIRS = [
    (r"\tanh(\ln x)=\frac{x^2-1}{%s}", "x^2+1", "x^2+2", ("x>0",)),
    (r"\cosh(\ln x)=\frac{x^2+1}{%s}", "2x", "x", ("x>0",)),
    (r"\sum_{n=0}^\infty\frac{(-1)^n}{(2n+1)^3}=%s", r"\frac{\pi^3}{32}", r"\frac{\pi^3}{16}", ()),
    # Moduli of quotients, in divisors.
    (
        r"\int\frac{dx}{x^2-a^2}=\frac1{2a}\ln\left|%s\right|+C",
        r"\frac{x-a}{x+a}",
        r"\frac{x+a}{x-a}",
        ("a>0",),
    ),
    (
        r"\int\frac{dx}{x(ax+b)}=-\frac1b\ln\left|%s\right|+C",
        r"\frac{ax+b}x",
        r"\frac{ax-b}x",
        ("a>0", "b>0"),
    ),
    # An exponent above a negative number.
    (r"\int_0^1x^a\ln x\,dx=%s", r"-\frac1{(a+1)^2}", r"\frac1{(a+1)^2}", ("a>-1",)),
    # The angle counted from a quarter turn, and the mean of an integrand and its mirror image.
    (r"\int_0^\pi\frac{dx}{1+\sin x}=%s", "2", r"\pi", ()),
    (r"\int_0^\pi\frac{x\,dx}{1+\sin x}=%s", r"\pi", r"2\pi", ()),
    (
        r"\int_0^\pi\frac{x\,dx}{a^2\cos^2x+b^2\sin^2x}=%s",
        r"\frac{\pi^2}{2ab}",
        r"\frac{\pi^2}{ab}",
        ("a>0", "b>0"),
    ),
    # Over a whole turn: not periodic; a wave with another factor that varies.
    (r"\int_0^{2\pi}e^{2x}\cos2x\,dx=\frac{e^{%s\pi}-1}4", "4", "2", ()),
    (r"\int_0^{2\pi}(\cos x+\sin x)\sin x\,dx=%s", r"\pi", "0", ()),
    # From the table.
    (
        r"\int_0^\infty\frac{x^{p-1}}{1+x^q}\,dx=\frac\pi{%s}",
        r"q\sin\frac{\pi p}q",
        r"p\sin\frac{\pi p}q",
        ("0<p<q",),
    ),
    (
        r"\int_0^\pi\frac{\cos n\theta}{5-4\cos\theta}d\theta=\frac\pi{%s}",
        r"3\cdot2^n",
        r"3\cdot2^{n+1}",
        (r"n\in\mathbb N",),
    ),
    (
        r"\int_0^{2\pi}\frac{\cos nx}{5+3\cos x}dx=\frac\pi2\left(%s\right)^n",
        r"-\frac13",
        r"\frac13",
        (r"n\in\mathbb N",),
    ),
    (
        r"\int_0^\infty\frac{\sin ax}{x(x^2+b^2)}\,dx=\frac\pi{2b^2}(1%se^{-ab})",
        "-",
        "+",
        ("a>0", "b>0"),
    ),
    (r"\int_0^\infty\frac{x^3}{\sinh x}\,dx=%s", r"\frac{\pi^4}8", r"\frac{\pi^4}{16}", ()),
    (r"\int_0^\infty\frac{x^2e^x}{(e^x-1)^2}\,dx=%s", r"\frac{\pi^2}3", r"\frac{\pi^2}6", ()),
    # Tangents that are infinite at an end.
    (r"\int_0^{\pi/2}\frac{dx}{1+\tan^3x}=%s", r"\frac\pi4", r"\frac\pi3", ()),
    (r"\int_0^{\pi/2}\frac{dx}{1+\sqrt{\tan x}}=%s", r"\frac\pi4", r"\frac\pi3", ()),
    # Over whole periods an angle is counted from anywhere, and once instead of n times.
    (r"\int_0^\pi|\cos nx|\,dx=%s", "2", "2n", (r"n\in\mathbb N",)),
    (r"\int_0^{2\pi}|\sin nx|\,dx=%s", "4", "2", (r"n\in\mathbb N",)),
    (r"\int_0^{2\pi}|a\cos x+b\sin x|\,dx=4%s", r"\sqrt{a^2+b^2}", "(|a|+|b|)", ()),
    (
        r"\int_0^{2\pi}\ln(a+b\cos x+c\sin x)\,dx=2\pi\ln\frac{a+\sqrt{%s}}2",
        "a^2-b^2-c^2",
        "a^2-b^2",
        ("a>0", "a^2>b^2+c^2"),
    ),
    # Waves divided by powers.
    (r"\int_0^\infty\frac{\sin^4x}{x^4}\,dx=%s", r"\frac\pi3", r"\frac\pi4", ()),
    (r"\int_0^\infty\frac{\sin^3x}{x^3}\,dx=%s", r"\frac{3\pi}8", r"\frac\pi3", ()),
    (r"\int_0^\infty\frac{\sin x-x\cos x}{x^3}\,dx=%s", r"\frac\pi4", r"\frac\pi2", ()),
    # Limits of powers.
    (r"\lim_{n\to\infty}(a^n+b^n)^{1/n}=%s", "a", "b", ("a>b>0",)),
    (r"\lim_{n\to\infty}\sqrt[n]{2^n+3^n}=%s", "3", "5", ()),
    (
        r"\lim_{x\to0}\left(\frac{a^x+b^x}2\right)^{1/x}=%s",
        r"\sqrt{ab}",
        r"\frac{a+b}2",
        ("a>0", "b>0"),
    ),
    # Derivatives of the direction of a vector.
    (
        r"\frac{\partial}{\partial x}\operatorname{atan2}(y,x)=%s",
        r"-\frac y{x^2+y^2}",
        r"\frac y{x^2+y^2}",
        ("x>0",),
    ),
    (r"\frac d{dt}\operatorname{atan2}(\sin t,\cos t)=%s", "1", "-1", (r"-\pi<t<\pi",)),
    # The angles of a triangle, and exponents that add up.
    (r"\sin A+\sin B+\sin C\le%s", r"\frac{3\sqrt3}2", r"\frac52", TRIANGLE),
    (r"\sin A\sin B\sin C\le%s", r"\frac{3\sqrt3}8", r"\frac58", TRIANGLE),
    (r"\cos A\cos B\cos C\le%s", r"\frac18", r"\frac19", TRIANGLE),
    (r"\cos A+\cos B+\cos C>%s", "1", r"\frac{11}{10}", TRIANGLE),
    (
        r"xy\le\frac{x^p}%s",
        r"p+\frac{y^q}q",
        r"q+\frac{y^q}p",
        ("x>0", "y>0", "p>1", r"\frac1p+\frac1q=1"),
    ),
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
    # Over a whole turn, but not periodic; a wave with another factor that varies.
    (r"\int_0^{2\pi}(x+1)\cos(x+1)\,dx=0", ()),
    (r"\int_0^{2\pi}\frac{3\cos x+4\sin x}{2+\cos x}\,dx=10\pi(1-\frac2{\sqrt3})", ()),
    (r"\lim_{n\to\infty}(-1)^nb^n=0", ("b<1",)),
    (r"\lim_{x\to0}(-2)^x=1", ()),
    (r"\lim_{n\to\infty}\frac1{\ln(2a^n)}=0", ("a>0",)),
    (r"\lim_{n\to\infty}\frac1{\ln(a^n+b^n)}=0", ("a>b>0",)),
    (r"\int_0^{\pi/2}\frac{dx}{1+2\sqrt{\tan x}}=\frac\pi4", ()),
    (r"\cos A+\cos B+\cos C>1", (r"A+B+C=\pi", r"A\ge0", r"B\ge0", r"C\ge0")),
    (r"\sin A+\sin B>\sin(A+B)", (r"A+B\le\pi", r"A\ge0", r"B\ge0")),
    (r"\sin A+\sin B\ge\sin(A-B)+1", (r"A+B\le\pi", "A>0", "B>0")),
    (r"xy<\frac{x^p}p+\frac{y^q}q", ("x>0", "y>0", "p>1", r"\frac1p+\frac1q=1")),
    (r"\lim_{n\to\infty}(a^n+b^n)^{1/n}=a", ("a>0", "b>0")),
    (r"\frac{\partial}{\partial y}\operatorname{atan2}(y,x)=\frac x{x^2+y^2}", ("x<0",)),
    (r"\frac d{dt}\operatorname{atan2}(\sin t,\cos t)=1", ()),
    (r"\pi\cot\pi x=\frac1x+\sum_{n=1}^\infty\frac x{x^2-n^2}", ()),
    (r"\int_0^{\frac\pi2}|\sin nx|\,dx=1+\frac{\sin^2n\pi}n", (r"n\in\mathbb N",)),
    (r"\int_0^\pi|\cos nx|\,dx=2", ("n>1",)),
    (r"\int_0^\pi|a\cos x+b\sin x|^3\,dx=\frac43(a^2+b^2)\sqrt{a^2+b^2}+1", ()),
    (r"\int_0^\pi(a\cos x+b\sin x)\,dx=0", ()),
    (r"\int_0^\infty\frac{\sin^3x}{x^4}\,dx=\frac\pi2", ()),
    (r"\int_0^1x^a\ln x\,dx=-\frac1{(a+1)^2}", ("a>-2",)),
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


@pytest.mark.slow
def test_whole_numbers_that_are_poles_are_named() -> None:
    latex = r"\pi\cot\pi x=\frac1x+\sum_{n=1}^\infty\frac{2x}{x^2-n^2}"
    (found,) = judge_pasted(Pasted(latex)).judgements
    assert found.verdict is Verdict.UNDECIDED
    assert "x is not a whole number" in found.reason
