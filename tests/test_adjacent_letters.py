"""Single equations: how adjacent letters are read, and derivatives of given letters."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

PROVED, REFUTED, UNDECIDED = Verdict.PROVED, Verdict.REFUTED, Verdict.UNDECIDED

# A print, the values given for its letters, and its verdict.
ROWS = [
    (r"r(1-\cos\varphi)=r-r\cos\varphi", (), PROVED),
    (r"r(1-\cos\varphi)=r+r\cos\varphi", (), REFUTED),
    (r"\dot\varphi(1-\cos\alpha)=\dot\varphi-\dot\varphi\cos\alpha", (), PROVED),
    (r"\hat a(1-\cos\alpha)=\hat a+\hat a\cos\alpha", (), REFUTED),
    (r"\int_0^{2\pi}r^2(1-\cos t)^2\,dt=3\pi r^2", (), PROVED),
    # b cannot be a function of y: it also appears outside the integral.
    (r"\int_{-h/2}^{h/2}b(y+a)^2\,\mathrm dy=\frac{bh^3}{12}+a^2bh", (), PROVED),
    (r"\int_{-h/2}^{h/2}b(y+a)^2\,\mathrm dy=\frac{bh^3}{12}+2a^2bh", (), REFUTED),
    (r"\int_{-R}^R\rho\left(R^2-x^2\right)\mathrm{d}x=\tfrac43\rho R^3", (), PROVED),
    (r"\int_0^1\int_0^1p(x+y)\,dx\,dy=p", (), PROVED),
    (r"b(a\cdot c)-c(a\cdot b)=0", (), PROVED),
    (r"\sin\omega t\cos\omega t=\frac12\sin2\omega t", (), PROVED),
    (r"\sin\omega t\cos\omega t=\frac12\sin\omega t", (), REFUTED),
    (r"\sin\omega_dt\cos\omega_dt=\frac12\sin2\omega_dt", (), PROVED),
    (
        r"\sin\omega_{\mathrm{d}}t\cos\omega_{\mathrm d}t=\frac12\sin\omega_{\mathrm d}t",
        (),
        REFUTED,
    ),
    (r"\cos^2bx+\sin^2bx=1", (), PROVED),
    (r"\sin2p\pi=2\sin p\pi\cos\pi p", (), PROVED),
    (r"\sin2p\pi=\sin p\pi\cos\pi p", (), REFUTED),
    (r"\sin2\pi ft=2\sin\pi ft\cos\pi ft", (), PROVED),
    (r"\int_0^1\sin^2\pi x\,dx=\frac12", (), PROVED),
    (r"\cos\frac{R+r}rt=2\cos^2\frac{R+r}{2r}t-1", (), PROVED),
    (r"\cos\frac{R+r}rt=2\cos^2\frac{R-r}{2r}t-1", (), REFUTED),
    (r"\sin\frac{2\pi}Tt=2\sin\frac{\pi t}T\cos\frac\pi Tt", (), PROVED),
    (r"\frac d{dx}\sin\frac\pi lx=\frac\pi l\cos\frac\pi lx", (), PROVED),
    (r"\sin\frac pq\pi=\sin\frac{p\pi}q", (), PROVED),
    (
        r"\dot x^2+\dot y^2=4(R+r)^2\sin^2\frac{Rt}{2r}",
        (r"x=(R+r)\cos t-r\cos\frac{R+r}rt", r"y=(R+r)\sin t-r\sin\frac{R+r}rt"),
        PROVED,
    ),
    (r"\frac{\mathrm d}{\mathrm dt}\mathrm e^{-\delta t}=-\delta\mathrm e^{-\delta t}", (), PROVED),
    (r"\mathrm e^{-\delta t}\cos t\le\mathrm e^{-\delta t}", (), PROVED),
    # So do letters in a bracket, followed by a variable of integration or differentiation.
    (r"\int_0^1\cos(a+b)x\,dx=\frac{\sin(a+b)}{a+b}", ("a=b",), PROVED),
    (r"\int\sin(a+b)x\,dx=-\frac{\cos(a+b)x}{a+b}+C", (), PROVED),
    (r"\int\sin(a+b)x\,dx=\frac{\cos(a+b)x}{a+b}+C", (), REFUTED),
    # Unless the same function is also printed without that letter.
    (r"\int\sin(a+b)x\,dx=\frac{x^2}2\sin(a+b)+C", (), PROVED),
    (r"\int_0^1\cos(a+b)x\,dx=\frac12\cos(a+b)", (), PROVED),
    (r"\int_0^1\cos(a+b)x\,dx=\frac13\cos(a+b)", (), REFUTED),
    (r"2\sin ax\cos bx=\sin(a+b)x+\sin(a-b)x", (), PROVED),
    (r"2\sin ax\cos bx=\sin(a+b)x-\sin(a-b)x", (), REFUTED),
    (r"\int_0^1\sin(a+b)x\,dx=\frac{1-\cos(a+b)\pi}{a+b}", (), REFUTED),
    (r"\sum_{n=1}^\infty\frac1{n^2+b^2}=\frac{\pi\coth\pi b}{2b}-\frac1{2b^2}", ("b=1",), PROVED),
    # A letter followed by the letter that tends to a limit forms one argument.
    (r"\lim_{x\to0}\frac{\sin2ax}{\tan bx}=\frac{2a}b", (), UNDECIDED),
    (r"\lim_{x\to0}\frac{\sin2ax}{\tan2x}=a", (), PROVED),
    (r"\lim_{x\to0}\frac{1-\cos ax}{x^2}=\frac{a^2}2", (), PROVED),
    (r"\lim_{x\to0}\frac{\sin ax}x=\sin a", (), REFUTED),
    (r"\lim_{x\to\infty}\sin ax=0", (), UNDECIDED),
    # So does a letter followed by the variable of integration, if the differential comes first.
    (r"\int_0^\infty\frac{dx}{1+\sinh^2ax}=\frac1a", ("a=|b|+1",), PROVED),
    (r"\int_0^1\frac{dx}{\cosh^2ax}=\frac1{\cosh^2a}", (), REFUTED),
    (r"\lim_{\Delta x\to0}\frac{(x+\Delta x)^2-x^2}{\Delta x}=2x", (), PROVED),
    (r"\lim_{\Delta x\to0}\frac{(x+\Delta x)^2-x^2}{\Delta x}=x", (), REFUTED),
    ("y'=2x", ("y=x^2",), PROVED),
    ("y'=3x", ("y=x^2",), REFUTED),
    # Euler's number depends on nothing; a bracket containing the letter itself is not its argument.
    ("y'=y(1-y)", (r"y=\frac1{1+e^{-x}}",), PROVED),
    ("y'=y(1+y)", (r"y=\frac1{1+e^{-x}}",), REFUTED),
    ("y''-y=0", ("y=Ae^x+Be^{-x}",), PROVED),
    ("y''+y=0", ("y=Ae^x+Be^{-x}",), REFUTED),
    ("y''+y=0", (r"y=\sin x",), PROVED),
    (r"s'=\cos\varphi", (r"s=\sin\varphi",), PROVED),
    (r"\dot x^2+\dot y^2=r^2", (r"x=r\cos t", r"y=r\sin t"), PROVED),
    (r"\dot x=v", ("x=vt",), PROVED),
    (r"\dot y=2x\dot x", ("y=x^2", r"x=\sin t"), PROVED),
    (r"\ddot x+\omega^2x=0", (r"x=A\cos(\omega t)",), PROVED),
    (r"\ddot x-\omega^2x=0", (r"x=A\cos(\omega t)",), REFUTED),
]
# A print with two readings, the values given, and words of the question asked.
ASKED = [
    ("y'=2z", ("y=x^2+z^2", "x=2"), "by which letter"),
    ("f(x+h)-f=h", (), "the argument of a function"),
    ("v(t)=v_0+a", (), "the argument of a function"),
    ("y=y(x)", (), "the argument of a function"),
    ("s(t+T)=s(t)", (), "the argument of a function"),
    ("M(x)=F(l-x)+M", (), "the argument of a function"),
    (r"\int_0^1f(1-x)\,dx=f", (), "the argument of a function"),
    (r"\int_0^1p(1-x)\,dx=\int_0^1p\,dx", (), "the argument of a function"),
    (r"\int_0^1p\int_0^1p(x+y)\,dx\,dy=1", (), "the argument of a function"),
    (r"\int_0^1p(1+u)\,dx=p", (), "the argument of a function"),
    (r"\int_0^tp(t-s)\,ds=p", (), "the argument of a function"),
    (r"\int_0^l\rho(x)x\,dx=\rho l", (), "the argument of a function"),
    (r"\int p(1-x)\,dx=p", (), "the argument of a function"),
    (r"y(x+\Delta x)=y+\Delta y", (), "the argument of a function"),
    ("x(t+T)=x", (), "the argument of a function"),
    ("P(x+1)-P=2x", (), "the argument of a function"),
    (r"\dot x(1-t)=\dot x", (), "the argument of a function"),
    (r"\dot f(1-\cos\alpha)=\dot f-\dot f\cos\alpha", (), "the argument of a function"),
    ("y(1-x)=y", (), "the argument of a function"),
    (r"r(1-\cos\varphi)=2\sin^2\frac\varphi2", (), "the argument of a function"),
    (r"\cos\alpha x\sin\alpha x=1", (), "belong to the argument"),
    (r"\sin\alpha\pi=0", (), "belong to the argument"),
    (r"\sin\pi xy=1", (), "belong to the argument"),
    (r"\sin\pi x(1-x)=1", (), "the argument of a function"),
    (r"\cos\frac A2x=1", (), "belong to the argument"),
    (r"\cos\frac\alpha lx=1", (), "belong to the argument"),
    (r"\sin\frac xyz=1", (), "belong to the argument"),
    (r"\ln\frac abx=1", (), "belong to the argument"),
    (r"\sin\alpha t=1", (), "belong to the argument"),
    (r"\delta x=\delta y", (), "one quantity, or a product"),
    ("s'=h", (r"s=h\sin\varphi",), "by which letter"),
    (r"\dot x=x", ("x=2s",), "by which letter"),
    ("y'=1", ("y=|x|",), "by which letter"),
    ("y'=2x", ("y=x^2", "x=t^3"), "by which letter"),
    ("y'=0", ("y=a^2",), "by which letter"),
]


@pytest.mark.parametrize(("latex", "values", "verdict"), ROWS)
def test_what_stands_side_by_side_is_read(
    latex: str, values: tuple[str, ...], verdict: Verdict
) -> None:
    (judgement,) = judge_pasted(Pasted(latex, values=values)).judgements
    assert judgement.verdict is verdict


@pytest.mark.parametrize(("latex", "values", "words"), ASKED)
def test_what_may_mean_two_things_is_asked(latex: str, values: tuple[str, ...], words: str) -> None:
    with pytest.raises((ReadingError, ValueError), match=words):
        judge_pasted(Pasted(latex, values=values))


def test_a_derivative_of_a_given_letter_is_told() -> None:
    assert judge_pasted(Pasted("y'>0", values=(r"y=\sqrt x",))).taken["y'"] == "= 1/(2*sqrt(x))"
