"""Pasted inequalities: of vectors, for whole numbers, and under stated linear relations."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

TRIANGLE = ("a<b+c", "b<c+a", "c<a+b")
COUNT = (r"n\in\mathbb N",)
SIZES = ("p>0", "q>0", "r>0", "s>0")
PROVED = [
    # Products, factor by factor, or by a condition on the product of some factors.
    (r"\frac{pqrs\sin x}{r+s}\cdot(1-k^2)>0", (*SIZES, r"0<x<\pi/2", "0<k<1")),
    (r"\frac{pqrs\sin x}{r+s}\cdot(1-k^2)\ge0", (*SIZES, r"(1-k^2)\sin x\ge0")),
    (r"\frac{pqrs\sin x}{r+s}\cdot(1-k^2)\ge0", (*SIZES, r"\frac{(k^2-1)qr\sin x}{p+s}\le0")),
    # Numbers stated to be unequal.
    ("x^2+y^2>2xy", (r"x\ne y",)),
    ("(x-y)^2(y-z)^2>0", (r"x\ne y", r"y\ne z")),
    # Cauchy and Schwarz, and the sides of a triangle.
    (r"|\mathbf a\cdot\mathbf b|\le|\mathbf a||\mathbf b|", ()),
    (r"|\mathbf a\times\mathbf b|\le|\mathbf a||\mathbf b|", ()),
    (r"|\mathbf a+\mathbf b|\le|\mathbf a|+|\mathbf b|", ()),
    (r"\big||\mathbf a|-|\mathbf b|\big|\le|\mathbf a-\mathbf b|", ()),
    (
        r"|a_1b_1+a_2b_2+a_3b_3|\le\sqrt{a_1^2+a_2^2+a_3^2}\sqrt{b_1^2+b_2^2+b_3^2}",
        (),
    ),
    # Powers of negative numbers, of either sign.
    (r"(-2)^n\le2^n", COUNT),
    ("(-2)^n<3^n", COUNT),
    (r"\cos n\pi\le1", COUNT),
    (r"(-1)^n+(-1)^m\le2", (r"m,n\in\mathbb N",)),
    # A factorial and a power with the exponent n.
    (r"n!\le\left(\frac{n+1}2\right)^n", ()),
    (r"n!<\left(\frac{n+1}2\right)^n", (r"n\ge2",)),
    # Moduli, by their signs and by the mean value theorem.
    (r"|x+y+z|\le|x|+|y|+|z|", ()),
    (r"|a_1+a_2+a_3|\le|a_1|+|a_2|+|a_3|", ()),
    (r"|x-w|\le|x-y|+|y-z|+|z-w|", ()),
    (r"|x|-|y|\le|x-y|", ()),
    (r"|\cos x-\cos y|\le|x-y|", ()),
    (r"|\sin2x-\sin2y|\le2|x-y|", ()),
    (r"|e^{-x}-e^{-y}|\le|x-y|", (r"x\ge0", r"y\ge0")),
    (r"|\sqrt x-\sqrt y|\le\frac12|x-y|", (r"x\ge1", r"y\ge1")),
    # Moduli, maxima and minima with roots, case by case.
    (r"|\sqrt a-\sqrt b|\le\sqrt{|a-b|}", (r"a\ge0", r"b\ge0")),
    (r"\min(x,y)\le\sqrt{xy}", (r"x\ge0", r"y\ge0")),
    (r"\max(|x|,|y|)\le\sqrt{x^2+y^2}", ()),
    (r"\sqrt{x^2+y^2}\le\sqrt2\max(|x|,|y|)", ()),
    # Angles, by their tangents.
    (r"\arctan\frac{e\sin x}{1-e\cos x}\le\arcsin e", (r"0\le e<1",)),
    (r"\arctan x<\arcsin x", ("0<x<1",)),
    # By the slack in the stated relations.
    ("a^2+b^2+c^2<2(ab+bc+ca)", TRIANGLE),
    (r"(a+b-c)(b+c-a)(c+a-b)\le abc", TRIANGLE),
    (r"\frac a{b+c}+\frac b{c+a}+\frac c{a+b}<2", TRIANGLE),
    (r"\frac{x-a}x<\ln\frac xa", ("x>a>0",)),
    (r"\sqrt{l^2-r^2}>l-r", ("l>r>0",)),
    (r"\sqrt x-\sqrt a<\frac{x-a}{2\sqrt a}", ("x>a>0",)),
    # Integrals and infinite sums, by their values.
    (r"\int_0^\infty1000e^{-10^6(x-300)^2}dx>1", ()),
    (r"\int_0^1\frac{dx}{\sqrt x}\le2", ()),
    (r"\sum_{n=1}^\infty\frac1{n^2}<2", ()),
    # Zeros at ends and between them, of any order.
    pytest.param(
        r"\left(\frac{\sin x}x\right)^3>\cos x", (r"0<x<\frac\pi2",), marks=pytest.mark.slow
    ),
    (r"\sin x>\frac{x(\pi-x)}\pi", (r"0<x<\pi",)),
    (r"\sin x\le\frac4{\pi^2}x(\pi-x)", (r"0\le x\le\pi",)),
    (r"\cos x\le1-\frac{4x^2}{\pi^2}", (r"|x|\le\frac\pi2",)),
    # By slopes: of an arc that nothing multiplies, of a quotient, of logarithms, of a cube root.
    pytest.param(r"\frac x{\sqrt{1+x^2}}\le\arctan x", (r"x\ge0",), marks=pytest.mark.slow),
    pytest.param(r"\frac{\arctan x}x>\frac3{1+2\sqrt{1+x^2}}", ("x>0",), marks=pytest.mark.slow),
    (r"\arctan x\le\frac\pi2-\frac1x+\frac1{3x^3}", ("x>0",)),
    (r"\frac{3\sin x}{2+\cos x}<x", ("x>0",)),
    (r"a^ab^b\ge\left(\frac{a+b}2\right)^{a+b}", ("a>0", "b>0")),
    (r"\sqrt[3]{x+1}\le1+\frac x3", ("x>-1",)),
    # Beside a number that is left out, and within a period.
    (r"\frac{\sinh x}x\ge1", (r"x\ne0",)),
    (r"\frac{x-1}{\ln x}<\frac{x+1}2", ("x>0", r"x\ne1")),
    pytest.param(r"\left|\frac{\sin x}x\right|<1", (r"x\ne0",), marks=pytest.mark.slow),
    (r"\frac{\sin x}x\ge1-\frac{x^2}6", (r"x\ne0",)),
    # By Taylor series, within a power of the distance from zero.
    (r"|\sin x-x|\le\frac{x^3}5", ("0<x<1",)),
    (r"|\sin x-x|\le\frac{x^2|x|}5", ("-1<x<1",)),
    (r"\cos(\sin x)>\sin(\cos x)", ()),
    (r"\sin^2x+\cos(\cos x)>\frac12", ()),
    # Of whole numbers.
    (r"\lceil x\rceil-\lfloor x\rfloor\le1", ()),
    (r"\lfloor x+y\rfloor\le\lfloor x\rfloor+\lfloor y\rfloor+1", ()),
    # Of partial sums and products, by their limits.
    (r"\sum_{k=1}^n\frac1{k^2}<2-\frac1{n+1}", ()),
    (r"\sum_{k=1}^n\frac1{k^2}<\frac{\pi^2}6", ()),
    (r"\sum_{k=1}^n\frac1{k^3}<\frac54", ()),
    (r"\sum_{k=0}^n\frac1{k!}<3", ()),
    (r"\sum_{k=0}^nx^k<\frac1{1-x}", ("0<x<1",)),
    (r"\prod_{k=1}^n\left(1+\frac1{k^2}\right)<4", ()),
    (r"\sum_{k=1}^n\frac1{n+k}\ge\frac12", ()),
    # By the values of integrals with letters.
    (r"\int_0^x\sin t\,dt\ge0", ()),
    (r"\int_0^\infty e^{-ax}\,dx\ge1", ("0<a<1",)),
    (r"\int_0^ax\,dx\le a^2", ()),
]
NOT_PROVED = [
    (r"\frac{pqrs\sin x}{r-s}\cdot(1-k^2)>0", (*SIZES, r"0<x<\pi/2", "0<k<1")),
    (r"\frac{pqrs\sin x}{r+s}\cdot(1-k)\ge0", (*SIZES, r"(1-k^2)\sin x\ge0")),
    (r"\frac{pqrs\sin x}{r+s}\cdot(1-k^2)>0", (*SIZES, r"(1-k^2)\sin x\ge0")),
    (r"\frac{pqrs\sin x}{r+s}\cdot(1-k^2)\ge0", (*SIZES, r"\frac{(k^2-1)qr\sin x}{p-s}\le0")),
    # Other numbers are stated to be unequal, or that is not enough.
    ("x^2+y^2>2xy", (r"x\ne-y",)),
    ("x^2+y^2>2xy", (r"x\ne0",)),
    ("x^2+y^2>2xy+10^{-9}", (r"x\ne y",)),
    ("(x-y)^2(x-z)^2>0", (r"x\ne y", r"y\ne z")),
    (r"|\mathbf a\cdot\mathbf b|<|\mathbf a||\mathbf b|", ()),
    (r"|\mathbf a+\mathbf b|<|\mathbf a|+|\mathbf b|", ()),
    (r"|\mathbf a+\mathbf b|\le|\mathbf a|", ()),
    (r"|\mathbf a-\mathbf b|\le|\mathbf a|-|\mathbf b|", ()),
    ("(-2)^n<2^n", COUNT),
    (r"(-3)^n\le2^n", COUNT),
    (r"(-1)^n\ge1", COUNT),
    (r"(-1)^n\ge2", COUNT),
    (r"n!<\left(\frac{n+1}2\right)^n", ()),
    (r"n!\le\left(\frac n2\right)^n", ()),
    # Moduli that are too small, too steep, or equal.
    (r"|x+y+z|\le|x|+|y|+\frac{99}{100}|z|", ()),
    (r"|x+y+z|<|x|+|y|+|z|", ()),
    (r"|x-w|\le|x-y|+|y-z|", ()),
    (r"|\cos x-\cos y|\le\frac{99}{100}|x-y|", ()),
    (r"|\cos x-\cos y|<|x-y|", ()),
    (r"|e^{-x}-e^{-y}|\le|x-y|", ()),
    (r"|\sqrt x-\sqrt y|\le\frac12|x-y|", (r"x\ge0", r"y\ge0")),
    (r"|\operatorname{sgn}x-\operatorname{sgn}y|\le|x-y|", ()),
    (r"|\lfloor x\rfloor-\lfloor y\rfloor|\le|x-y|", ()),
    (r"|\sqrt a-\sqrt b|\le\frac12\sqrt{|a-b|}", (r"a\ge0", r"b\ge0")),
    (r"\min(x,y)<\sqrt{xy}", (r"x\ge0", r"y\ge0")),
    (r"\max(|x|,|y|)<\sqrt{x^2+y^2}", ()),
    (r"\sqrt{x^2+y^2}\le\frac75\max(|x|,|y|)", ()),
    (r"\arctan\frac{e\sin x}{1-e\cos x}\le\frac9{10}\arcsin e", (r"0\le e<1",)),
    (r"\arctan\frac{e\sin x}{1-e\cos x}<\arcsin e", (r"0\le e<1",)),
    (r"\arctan x<\arcsin x", (r"0\le x<1",)),
    # One relation too few, or a bound that is too low.
    ("a^2+b^2+c^2<2(ab+bc+ca)", ("a>0", *TRIANGLE[:2])),
    ("a^2+b^2+c^2<2(ab+bc+ca)", ("a>0", "b>0", "c>0")),
    (r"\frac a{b+c}+\frac b{c+a}+\frac c{a+b}<\frac53", TRIANGLE),
    (r"a^2+b^2+c^2\le ab+bc+ca", TRIANGLE),
    (r"\frac{x-a}a<\ln\frac xa", ("x>a>0",)),
    (r"\frac{x-a}x<\ln\frac xa", (r"x\ge a>0",)),
    (r"\sqrt{l^2-r^2}>l-r", (r"l\ge r>0",)),
    ("x^2<y^2", ("x<y",)),
    # A narrow peak; a bound that is attained; no value at all.
    (r"\int_0^\infty1000e^{-10^6(x-300)^2}dx<1", ()),
    (r"\int_0^1\frac{dx}{\sqrt x}<2", ()),
    (r"\sum_{n=1}^\infty\frac1{n^2}<\frac{164}{100}", ()),
    (r"\int_0^1\frac{dx}x<2", ()),
    (r"\int_0^x\sin t\,dt>0", ()),
    (r"\int_0^\infty e^{-ax}\,dx\ge1", ("a>0",)),
    (r"\left(\frac{\sin x}x\right)^3>\cos x+\frac{x^4}{10}", (r"0<x<\frac\pi2",)),
    (r"\sin x>\frac{x(\pi-x)}\pi", (r"0\le x<\pi",)),
    (r"\sin x>\frac{x(\pi-x)}\pi", (r"0<x\le\pi",)),
    (r"\sin x<\frac4{\pi^2}x(\pi-x)", (r"0<x<\pi",)),
    (r"\sin x\le\frac{39}{10\pi^2}x(\pi-x)", (r"0\le x\le\pi",)),
    (r"\cos x\le1-\frac{4x^2}{\pi^2}", (r"|x|\le2",)),
    (r"\frac x{\sqrt{1+x^2}}<\arctan x", (r"x\ge0",)),
    (r"\frac x{\sqrt{1+x^2}}\le\arctan x", ()),
    (r"\frac{\arctan x}x>\frac3{1+\frac{19}{10}\sqrt{1+x^2}}", ("x>0",)),
    (r"\arctan x\le\frac\pi2-\frac1x+\frac1{4x^3}", ("x>0",)),
    (r"\frac{3\sin x}{2+\cos x}<\frac{99}{100}x", ("x>0",)),
    (r"a^ab^b>\left(\frac{a+b}2\right)^{a+b}", ("a>0", "b>0")),
    (r"\sqrt[3]{x+1}\le1+\frac x4", ("x>-1",)),
    (r"\frac{\sinh x}x>1+\frac{x^2}6+\frac{x^4}{119}", (r"x\ne0",)),
    (r"\frac{x-1}{\ln x}<\frac{x+1}2-\frac{(x-1)^2}9", ("x>0", r"x\ne1")),
    (r"\left|\frac{\sin x}x\right|<1", ()),
    (r"\frac{\sin x}x\ge\frac1x", (r"x\ne0",)),
    (r"\frac{x-1}{|x-1|}>0", (r"x\ne1",)),
    (r"\frac{x-1}{|x-1|}<0", (r"x\ne1",)),
    # An odd power of a negative number; no point that is tried is so near zero.
    (r"|\sin x-x|\le\frac{x^3}5", ("-10^{-9}<x<1",)),
    (r"|\cos x-1+\frac{x^2}2|\le\frac{x^3}2", (r"-10^{-12}<x<\frac1{100}",)),
    (r"\cos(\sin x)>\sin(\cos x)+\frac15", ()),
    (r"\cos(\sin x)+\frac x{100}>\sin(\cos x)", ()),
    (r"\lceil x\rceil-\lfloor x\rfloor<1", ()),
    (r"\lfloor x+y\rfloor\le\lfloor x\rfloor+\lfloor y\rfloor", ()),
    (r"\lfloor x\rfloor\ge\frac x2-\frac12", ()),
    (r"\sum_{k=1}^n\frac1{k^2}<2-\frac2{n+1}", ()),
    (r"\sum_{k=1}^n\frac1{k^2}<\frac{164}{100}", ()),
    (r"\sum_{k=1}^n\frac1{k^3}<\frac{12}{10}", ()),
    (r"\sum_{k=0}^n\frac1{k!}<\frac{2718}{1000}", ()),
    (r"\sum_{k=0}^nx^k<\frac1{1-x}", (r"0\le x<1",)),
    (r"\prod_{k=1}^n\left(1+\frac1{k^2}\right)<\frac{36}{10}", ()),
    (r"\sum_{k=1}^n\frac1k<100", ()),
    (r"\sum_{k=1}^n\frac1{n+k}>\frac12", ()),
    (r"\sum_{k=1}^n\frac{(-1)^k}k\ge-\ln2", ()),
    # Integrands that have no integral.
    (r"\int_0^1\frac ax\,dx\ge0", ("a>0",)),
]


def judge(latex: str, where: tuple[str, ...]) -> set[Verdict]:
    return {found.verdict for found in judge_pasted(Pasted(latex, where=where)).judgements}


@pytest.mark.parametrize(("latex", "where"), PROVED)
def test_an_inequality_is_proved(latex: str, where: tuple[str, ...]) -> None:
    assert judge(latex, where) == {Verdict.PROVED}


@pytest.mark.parametrize(("latex", "where"), NOT_PROVED)
def test_what_fails_somewhere_is_not_proved(latex: str, where: tuple[str, ...]) -> None:
    assert Verdict.PROVED not in judge(latex, where)
