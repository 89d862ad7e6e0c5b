"""Pasted improper integrals, limits from both sides, and expressions without a value."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A print with a place for its value, the true value, a wrong one, and the conditions stated.
PAIRS = [
    (r"\int_{-1}^1\frac{dx}{\sqrt[3]x}=%s", "0", "1", ()),
    (r"\int_0^3\frac{dx}{\sqrt[3]{x-1}}=%s", r"\frac32(\sqrt[3]4-1)", "3", ()),
    # Known integrals.
    (r"\int_0^{\pi/2}\ln\sin x\,dx=%s", r"-\frac\pi2\ln2", r"-\pi\ln2", ()),
    (r"\int_0^{\pi/2}\ln(a\sin x)\,dx=%s", r"\frac\pi2\ln\frac a2", r"\frac\pi2\ln a", ("a>0",)),
    (r"\int_{-\infty}^\infty\cos x^2\,dx=%s", r"\sqrt{\frac\pi2}", r"\frac12\sqrt{\frac\pi2}", ()),
    (
        r"\int_0^\infty\frac{e^{-ax}-e^{-bx}}x\,dx=%s",
        r"\ln\frac ba",
        r"\ln\frac ab",
        ("a>0", "b>0"),
    ),
    (
        r"\int_0^\infty t^2e^{-st}\cos\omega t\,dt=%s",
        r"\frac{2s(s^2-3\omega^2)}{(s^2+\omega^2)^3}",
        r"\frac{2s(s^2-2\omega^2)}{(s^2+\omega^2)^3}",
        ("s>0",),
    ),
    (
        r"\int_0^\infty e^{-st}\sinh(at)\,dt=%s",
        r"\frac a{s^2-a^2}",
        r"\frac s{s^2-a^2}",
        ("s>|a|",),
    ),
    (
        r"\int_0^\infty\frac{dx}{\cosh ax}=%s",
        r"\frac\pi{2a}",
        r"\frac\pi a",
        ("a>0",),
    ),
    (
        r"\int_0^{\pi/2}\cos^{2n+1}x\,dx=%s",
        r"\frac{4^nn!^2}{(2n+1)!}",
        r"\frac{4^nn!^2}{(2n)!}",
        (r"n\in\mathbb N",),
    ),
    (
        r"\int_0^\infty\frac{\cos ax}{b^2+x^2}\,dx=%s",
        r"\frac\pi{2b}e^{-ab}",
        r"\frac\pi2e^{-ab}",
        (r"a\ge0", "b>0"),
    ),
    (r"\int_0^\infty\frac{x^{a-1}}{1+x}\,dx=%s", r"\frac\pi{\sin\pi a}", r"\sin\pi a", ("0<a<1",)),
    (r"\int_0^\infty\frac{x^3}{e^x-1}\,dx=%s", r"\frac{\pi^4}{15}", r"\frac{\pi^4}{90}", ()),
    (r"\int_0^\infty\frac{x^2}{e^x-1}\,dx=%s", r"2\sum_{n=1}^\infty\frac1{n^3}", "2", ()),
    # From the table: over a half turn and over a whole one.
    (r"\int_0^\pi\ln(1-2a\cos x+a^2)\,dx=%s", "0", r"\pi a", ("-1<a<1",)),
    (r"\int_0^{2\pi}\ln(1-2a\cos x+a^2)\,dx=%s", r"4\pi\ln a", "0", ("a>1",)),
    (
        r"\int_0^\pi\ln(a+b\cos x)\,dx=%s",
        r"\pi\ln\frac{a+\sqrt{a^2-b^2}}2",
        r"\pi\ln a",
        ("a>|b|",),
    ),
    (
        r"\int_0^{2\pi}\frac{\cos nx}{1-2a\cos x+a^2}\,dx=%s",
        r"\frac{2\pi a^n}{1-a^2}",
        r"\frac{\pi a^n}{1-a^2}",
        ("0<a<1", r"n\in\mathbb N"),
    ),
    (
        r"\int_0^{2\pi}\frac{dx}{a+b\cos x+c\sin x}=%s",
        r"\frac{2\pi}{\sqrt{a^2-b^2-c^2}}",
        r"\frac{2\pi}{\sqrt{a^2-b^2+c^2}}",
        ("a>0", "b^2+c^2<a^2"),
    ),
    # With letters as limits, as with 0 and 1.
    (r"\int_a^b\sqrt{(x-a)(b-x)}\,dx=%s", r"\frac\pi8(b-a)^2", r"\frac\pi4(b-a)^2", ("a<b",)),
    (r"\int_a^b\frac{dx}{\sqrt{(x-a)(b-x)}}=%s", r"\pi", r"\frac\pi2", ("a<b",)),
    # Roots of fractions.
    (r"\int_0^1\sqrt{\frac{1-x}{1+x}}\,dx=%s", r"\frac\pi2-1", r"\frac\pi2+1", ()),
    (r"\int_{-1}^1\sqrt{\frac{1+x}{1-x}}\,dx=%s", r"\pi", r"2\pi", ()),
    # By parts, with a fraction in front of the logarithm.
    (
        r"\int_0^1\frac{x\ln x}{(a+x^2)^2}dx=%s",
        r"-\frac1{4a}\ln\frac{1+a}a",
        r"\frac1{4a}\ln\frac{1+a}a",
        ("a>0",),
    ),
    (r"\int_0^1\frac{\ln(1+x)}{(1+x)^2}dx=%s", r"\frac12-\frac12\ln2", r"\frac12\ln2", ()),
    (r"\int_1^2\frac{\ln a\ln x}{x}dx=%s", r"\frac12\ln a\ln^22", r"\ln a\ln^22", ("a>0",)),
    # By error functions and sine integrals, and by the parts of the integrand.
    (r"\int_0^\infty x^2e^{-x^2}dx=%s", r"\frac{\sqrt\pi}4", r"\frac{\sqrt\pi}2", ()),
    (
        r"\int_0^\infty x^4e^{-ax^2}dx=%s",
        r"\frac{3\sqrt\pi}{8a^2\sqrt a}",
        r"\frac{3\sqrt\pi}{4a^2\sqrt a}",
        ("a>0",),
    ),
    (r"\int_0^\infty\frac{\sin x}xdx=%s", r"\frac\pi2", r"\pi", ()),
    (r"\int_{-1}^1\frac{\sin x}xdx=%s", r"2\mathrm{Si}(1)", r"\mathrm{Si}(1)", ()),
    (r"\int_{-a}^a\frac{\sin x}xdx=%s", r"2\int_0^a\frac{\sin x}xdx", "0", ("a>0",)),
    (r"\int_{-\infty}^\infty\frac{\sin x}xdx=%s", r"\pi", r"\frac\pi2", ()),
    (r"\int_0^\infty\frac{\sin ax}xdx=%s", r"\frac\pi2", r"\frac\pi{2a}", ("a>0",)),
    (r"\int_0^\infty\frac{\sin^2x}{x^2}dx=%s", r"\frac\pi2", r"\pi", ()),
    (r"\int_0^1\arcsin^2x\,dx=%s", r"\frac{\pi^2}4-2", r"\frac{\pi^2}4+2", ()),
    (
        r"\int\sqrt{a^2-x^2}\,dx=\frac x2\sqrt{a^2-x^2}%s\frac{a^2}2\arcsin\frac xa+C",
        "+",
        "-",
        ("a>0",),
    ),
    (r"\int_0^\infty\frac{dx}{\sqrt x(1+x)}=%s", r"\pi", r"\frac\pi2", ()),
    # Refuted by giving the letters values and evaluating the integral there.
    (r"\int_0^\infty x^ne^{-ax}dx=%s", r"\frac{n!}{a^{n+1}}", r"\frac{n!}{a^n}", ("a>0",)),
    # Up to poles and across them, where the integral has a value, finite or infinite.
    (r"\int_1^\infty\frac{dx}x=%s", r"\infty", "5", ()),
    (r"\int_{-1}^1\frac{dx}{x^2}=%s", r"\infty", "-2", ()),
    (r"\int_0^{\frac\pi2}\tan x\,dx=%s", r"\infty", "0", ()),
    (r"\int_0^{\frac\pi2}\sec x\,dx=%s", r"\infty", "1", ()),
    (r"\int_{\frac\pi2}^\pi\sec x\,dx=%s", r"-\infty", r"\infty", ()),
    (r"\int_0^{\frac\pi2}\csc x\,dx=%s", r"\infty", "0", ()),
    (r"\int_0^\pi\sec^2x\,dx=%s", r"\infty", "0", ()),
    (r"\int_{\frac\pi4}^{\frac\pi2}\csc^2x\,dx=%s", "1", "-1", ()),
    (r"\int_{\frac\pi4}^{\frac\pi2}\cot x\,dx=%s", r"\frac12\ln2", r"\ln2", ()),
    (r"\int_0^1x^{-p}dx=%s", r"\infty", "1", ("p>1",)),
    (r"\int_{-1}^1\frac{dx}{\sqrt{|x|}}=%s", "4", "2", ()),
    (r"\int_0^2\frac{dx}{(x^2-2)^2}=%s", r"\infty", "1", ()),
    (r"\int_0^3\frac{dx}{\sqrt[3]{(x-1)^2}}=%s", r"3(1+\sqrt[3]2)", r"3(1-\sqrt[3]2)", ()),
    # Double integrals whose integrand has no value at a corner, so that the order can matter.
    (r"\int_0^1\int_0^1\frac{x-y}{(x+y)^3}dy\,dx=%s", r"\frac12", r"-\frac12", ()),
    (r"\int_0^1\int_0^1\frac{x-y}{(x+y)^3}dx\,dy=%s", r"-\frac12", r"\frac12", ()),
    (r"\int_0^1\int_0^1\frac{dx\,dy}{(x+y)^2}=%s", r"\infty", "1", ()),
    (r"\int_0^1\frac{x-a}{(x+a)^3}dx=%s", r"-\frac1{(a+1)^2}", r"\frac1{(a+1)^2}", ("a>0",)),
    # Limits by sines and cosines, and where the two sides differ.
    (r"\lim_{x\to\frac\pi2}\left(\frac\pi2-x\right)\tan x=%s", "1", "-1", ()),
    (r"\lim_{x\to0}x\cot x=%s", "1", "0", ()),
    (r"\lim_{x\to0}\frac{\sec x-1}{x^2}=%s", r"\frac12", "1", ()),
    (r"\lim_{x\to0^+}\frac{|x|}x=%s", "1", "-1", ()),
    (r"\lim_{x\to0}\frac{|x|}x=%s", "1", "-1", ("x>0",)),
    # Sums whose limits are integrals.
    (r"\lim_{n\to\infty}\sum_{k=1}^n\frac1{n+k}=%s", r"\ln2", r"\ln3", ()),
    (r"\lim_{n\to\infty}\left(2+\sum_{k=1}^n\frac1{n+k}\right)=%s", r"2+\ln2", r"2\ln2", ()),
    (r"\lim_{n\to\infty}\left(3+\frac{2^n}{n!}\right)=%s", "3", "4", ()),
    (r"\lim_{n\to\infty}\frac1{n^2}\sum_{k=1}^n(2+k)=%s", r"\frac12", "1", ()),
    (r"\lim_{n\to\infty}\sum_{k=1}^n\left(2+\frac1{2^k}\right)=%s", r"\infty", "2", ()),
    (r"\lim_{n\to\infty}\frac1n\sum_{k=0}^{n-1}\sqrt{\frac kn}=%s", r"\frac23", r"\frac32", ()),
    (r"\lim_{n\to\infty}\sum_{k=1}^n\frac1{n+ak}=%s", r"\frac{\ln(1+a)}a", r"\ln(1+a)", ("a>0",)),
    # Series of powers times sines or cosines, inside the unit circle.
    (
        r"1+2\sum_{k=1}^\infty r^k\cos k\theta=%s",
        r"\frac{1-r^2}{1-2r\cos\theta+r^2}",
        r"\frac{1+r^2}{1-2r\cos\theta+r^2}",
        ("|r|<1",),
    ),
    (
        r"\sum_{k=0}^\infty r^k\sin k\theta=%s",
        r"\frac{r\sin\theta}{1-2r\cos\theta+r^2}",
        r"\frac{\sin\theta}{1-2r\cos\theta+r^2}",
        ("|r|<1",),
    ),
    (
        r"\sum_{k=1}^\infty\frac{r^k}k\cos k\theta=%s",
        r"-\frac12\ln(1-2r\cos\theta+r^2)",
        r"-\ln(1-2r\cos\theta+r^2)",
        ("|r|<1",),
    ),
    (
        r"\sum_{k=1}^\infty\frac{r^k}k\sin k\theta=%s",
        r"\arctan\frac{r\sin\theta}{1-r\cos\theta}",
        r"\arctan\frac{r\sin\theta}{1+r\cos\theta}",
        ("|r|<1",),
    ),
    # Fourier series within a period.
    (r"\sum_{n=1}^\infty\frac{\sin nx}n=%s", r"\frac{\pi-x}2", r"\frac{\pi+x}2", (r"0<x<2\pi",)),
    (r"\sum_{n=1}^\infty\frac{\cos nx}n=-\ln(%s)", r"2\sin\frac x2", r"\sin x", (r"0<x<\pi",)),
    (
        r"\sum_{n=1}^\infty\frac{(-1)^{n+1}}n\sin\left(\frac{n\pi x}l\right)=%s",
        r"\frac{\pi x}{2l}",
        r"\frac{\pi x}l",
        (r"0\le x", "x<l", "l>0"),
    ),
    (
        r"\sum_{n=1}^\infty\frac{(-1)^n}{n^2}\cos nx=%s",
        r"\frac{x^2}4-\frac{\pi^2}{12}",
        r"\frac{x^2}4",
        (r"-\pi\le x\le\pi",),
    ),
    (
        r"\sum_{n=1}^\infty\frac{\sin nx}{n^3}=\frac{\pi^2x}6-\frac{\pi x^2}4+%s",
        r"\frac{x^3}{12}",
        r"\frac{x^3}6",
        (r"0\le x\le2\pi",),
    ),
    (r"\sum_{k=0}^\infty\frac{\sin((2k+1)x)}{2k+1}=%s", r"\frac\pi4", "1", (r"0<x<\pi",)),
    (
        r"\sum_{k=1}^\infty\frac{\cos((2k-1)x)}{(2k-1)^2}=%s",
        r"\frac{\pi^2}8-\frac{\pi x}4",
        r"\frac{\pi^2}8",
        (r"0\le x\le\pi",),
    ),
    (
        r"\sum_{k=1}^\infty\frac{\sin((2k-1)x)}{(2k-1)^3}=%s",
        r"\frac{\pi x(\pi-x)}8",
        r"\frac{\pi x}8",
        (r"0\le x\le\pi",),
    ),
    (
        r"\sum_{k=0}^\infty(-1)^k\frac{\sin((2k+1)x)}{(2k+1)^2}=%s",
        r"\frac{\pi x}4",
        "x",
        (r"-\frac\pi2\le x\le\frac\pi2",),
    ),
    (
        r"\sum_{k=0}^\infty(-1)^k\frac{\cos((2k+1)x)}{2k+1}=%s",
        r"\frac\pi4",
        r"\frac\pi4\cos x",
        (r"-\frac\pi2<x<\frac\pi2",),
    ),
    # Sums that are infinite.
    (r"\sum_{k=1}^\infty\frac1k=%s", r"\infty", "5", ()),
    (r"\sum_{k=1}^\infty\frac{-1}{2k-1}=%s", r"-\infty", r"\infty", ()),
    (r"\sum_{k=1}^\infty k=%s", r"\infty", r"-\frac1{12}", ()),
    (r"\sum_{k=2}^\infty\frac1{k\ln k}=%s", r"\infty", "1", ()),
    (r"\sum_{k=1}^\infty\sin\frac ak=%s", r"\infty", r"-\infty", ("a>0",)),
    (r"\sum_{k=0}^\infty q^k=%s", r"\infty", "1", ("q>1",)),
    (r"\lim_{n\to\infty}\sum_{k=1}^n\frac1k=%s", r"\infty", "1", ()),
    (r"\lim_{x\to a}\frac{|x-a|}{x-a}=%s", "1", "-1", ("x>a",)),
    (r"\lim_{x\to a}\frac{|x-a|}{x-a}=%s", "-1", "1", ("a>x",)),
    (r"\lim_{x\to0}\frac{\sqrt x\sqrt{x-x^2}}{|x|}=%s", "1", "-1", ()),
    (r"\lim_{x\to0}\frac{\sqrt x}{|x|}=%s", r"\infty", "0", ()),
    # Where a base is zero, and where it is positive.
    (r"\sqrt[m]{\sqrt[n]a}=%s", r"\sqrt[mn]a", r"\sqrt[m+n]a", (r"a\ge0", r"m,n\in\mathbb N")),
    (r"(\cosh x+\sinh x)^n=%s", r"\cosh nx+\sinh nx", r"\cosh nx-\sinh nx", (r"n\in\mathbb N",)),
    # Antiderivatives with signs that do not jump, or jump only outside the stated domain.
    (r"\int|x|dx=%s+C", r"\frac{x^2\operatorname{sgn}x}2", r"x^2\operatorname{sgn}x", ()),
    (r"\int2x\,dx=%s+\operatorname{sgn}x+C", "x^2", "x^3", ("x>0",)),
    (r"\int\frac{dx}{1+x^2}=\frac\pi2\operatorname{sgn}x%s\arctan\frac1x+C", "-", "+", ()),
    (r"|a+b|+|a-b|=%s", r"2\max(|a|,|b|)", r"2\min(|a|,|b|)", ()),
]
WITHOUT_LIMIT = [
    r"\lim_{x\to0}\frac{|x|}x=1",
    r"\lim_{x\to0}\frac{\sqrt{x^2}}x=1",
    r"\lim_{x\to0}e^{\frac1x}=0",
    r"\lim_{x\to0}\arctan\frac1x=\frac\pi2",
]
# A print that converges only under an unstated condition, its value, the condition, a wrong value.
NOT_SAID = [
    (r"\int_0^\infty e^{-ax}dx=%s", r"\frac1a", "a > 0", r"\frac2a"),
    (r"\int_0^\infty e^{ax}dx=%s", r"-\frac1a", "a < 0", r"\frac1a"),
    (r"\int_0^1x^a\,dx=%s", r"\frac1{a+1}", "a > -1", r"\frac1a"),
    (r"\int_1^\infty x^{-s}dx=%s", r"\frac1{s-1}", "s > 1", r"\frac1{s+1}"),
    (
        r"\int_0^\infty x^{s-1}e^{-ax}dx=%s",
        r"\frac{\Gamma(s)}{a^s}",
        "a > 0 and s > 0",
        r"\frac{\Gamma(s)}{a^{s+1}}",
    ),
    (r"\int_0^\infty\frac{\ln x}{a^2+x^2}dx=%s", r"\frac{\pi\ln a}{2a}", "a > 0", r"\pi\ln a"),
    (r"\sum_{k=0}^\infty q^k=%s", r"\frac1{1-q}", "q < 1 and q > -1", r"\frac2{1-q}"),
    (r"\sum_{k=1}^\infty\frac{q^k}k=%s", r"-\ln(1-q)", "q < 1 and q > -1", r"\ln(1-q)"),
    (r"\lim_{x\to\infty}e^{-ax}=%s", "0", "a > 0", "1"),
]
# Prints that give a number for something that does not converge, and the conditions stated.
DIVERGENT = [
    (r"\int_{-a}^a\frac{dx}x=0", ("a>0",)),
    (r"\int_0^{2a}\frac{dx}{x-a}=0", ("a<0",)),
    (r"\int_{-1}^1\frac{dx}x=0", ()),
    (r"\int_{-a}^a\frac{dx}{x^2}=-\frac2a", ()),
    (r"\int_{-a}^{2a}\frac{dx}x=\ln2", ()),
    (r"\int_{-a}^a\frac{\cos x}xdx=0", ("a>0",)),
    (r"\int_0^\infty\frac{\cos x}xdx=0", ()),
    (r"\int_2^\infty\frac{dx}{\ln x}=4", ()),
    (r"\int_0^\pi\tan x\,dx=0", ()),
    (r"\int_0^2\frac x{x^2-1}dx=\frac12\ln3", ()),
    (r"\int_0^1\left(\frac1x-\frac1{1-x}\right)dx=0", ()),
    (r"2+\int_0^1\frac{dx}x=5", ()),
    (r"\int_{-\infty}^\infty x\,dx=0", ()),
    (r"\int_{-\infty}^\infty\sin x\,dx=0", ()),
    (r"\int_0^\infty x\cos x\,dx=-1", ()),
    (r"\int_0^\infty\cos(ax+b)dx=0", ("a>0",)),
    (r"\sum_{k=0}^\infty(-1)^k=\frac12", ()),
    (r"\sum_{k=0}^\infty(-2)^k=\frac13", ()),
    (r"\sum_{k=0}^\infty q^k=\frac1{1-q}", ("q<-1",)),
    (r"\sum_{k=1}^\infty(-1)^k\frac k{k+1}=0", ()),
    (r"\lim_{x\to\infty}\sin x=0", ()),
    (r"\lim_{x\to-\infty}x\sin2x=0", ()),
    (r"\lim_{x\to\infty}\left(\cos x+\frac1x\right)=0", ()),
]
# Prints left undecided, since nothing shows that a side is infinite or has no value.
OPEN = [
    (r"\int_0^\infty\frac{\arctan ax-\arctan bx}xdx=\frac\pi2\ln\frac ab", ("a>0",)),
    # Known integrals with letters for which they have no value, or another one; the first takes as
    # long as all the others.
    pytest.param(
        *(r"\int_0^\infty\frac{e^{-ax}-e^{-bx}}x\,dx=\ln\frac ba", ("a>0", r"b\ge0")),
        marks=pytest.mark.thorough,
    ),
    (r"\int_0^\infty\frac{x^{a-1}}{1+x}\,dx=\frac\pi{\sin\pi a}", ("0<a<2",)),
    (r"\int_0^{\pi/2}\ln(a\sin x)\,dx=\frac\pi2\ln\frac a2", ()),
    (r"\int_0^\infty\frac{\ln x}{a^2+x^2}dx=\frac{\pi\ln a}{2a}", ()),
    (r"\int_{-1}^1\int_0^1\frac yxdy\,dx=0", ()),
    (r"\int_0^1x^{-p}dx=\infty", ("p>0",)),
    (r"\int_{-1}^1\frac{dx}x\ne0", ()),
    (r"\int_{-1}^1\frac{dx}x=\int_{-2}^2\frac{dx}x", ()),
    (r"\int_0^a\frac{dx}x=0", ()),
    (r"\int_{-a}^a\frac{\cos x}xdx=0", ()),
    (r"\int_0^1\frac{\sin^2\frac1x}xdx=1", ()),
    (r"\int_0^\infty\cos ax\,dx=0", ()),
    (r"\sum_{k=0}^\infty q^k=\frac1{1-q}", (r"q\le0",)),
    (r"\lim_{n\to\infty}\sin2\pi n=0", ()),
    (r"\lim_{x\to\infty}(\sin^2x+\cos^2x)=1", ()),
    (r"\int_0^1\frac{dx}x-\int_0^1\frac{dx}x=0", ()),
    (r"\lim_{x\to0}\frac1x=\infty", ()),
    (r"\lim_{n\to\infty}\sum_{k=1}^n\frac1{n-k}=0", ()),
    (r"\lim_{n\to\infty}\sum_{k=1}^{2n}\frac1{n+k}=\ln2", ()),
    (r"\lim_{n\to\infty}\sum_{k=1}^n\frac1{n-ak}=-\frac{\ln(1-a)}a", ("a>0",)),
    (r"\lim_{x\to0^-}\sqrt x=0", ()),
    (r"\lim_{x\to0}\frac{\sqrt x\sqrt{x-x^2}}{|x|}=-1", ("x<0",)),
    # An antiderivative does not jump.
    (r"\int2x\,dx=x^2+\operatorname{sgn}x+C", ()),
    (r"\int2x\operatorname{sgn}(x^2-1)dx=x^2\operatorname{sgn}(x^2-1)+C", ()),
    (r"\int\operatorname{sgn}x\,dx=|x|+\operatorname{sgn}x+C", ()),
    (r"\int|\cos x|dx=\sin x\operatorname{sgn}(\cos x)+C", ()),
    (r"\sum_{k=0}^\infty r^k\cos k\theta=\frac{1-r\cos\theta}{1-2r\cos\theta+r^2}", ()),
    # Fourier series beyond the period or at its ends, and series that resemble them.
    (r"\sum_{n=1}^\infty\frac{\sin nx}n=\frac{\pi-x}2", ()),
    (r"\sum_{n=1}^\infty\frac{\sin nx}n=\frac{\pi-x}2", (r"0\le x<2\pi",)),
    (r"\sum_{n=1}^\infty\frac{(-1)^{n+1}\sin nx}n=\frac x2", (r"-\pi\le x\le\pi",)),
    (r"\sum_{n=1}^\infty\frac{(-1)^{n+1}\sin nx}n=\frac x2", (r"0<x<2\pi",)),
    (r"\sum_{n=2}^\infty\frac{\sin nx}n=\frac{\pi-x}2", (r"0<x<2\pi",)),
    (r"\sum_{n=1}^\infty\frac{\sin nx}{n+1}=\frac{\pi-x}2", (r"0<x<2\pi",)),
    (r"\sum_{n=1}^\infty\frac{\sin(nx+a)}n=\frac{\pi-x}2", (r"0<x<2\pi",)),
    (r"\sum_{n=1}^\infty2^n\frac{\sin nx}n=\frac{\pi-x}2", (r"0<x<2\pi",)),
    (r"\sum_{n=1}^\infty\frac{(a-b)\sin nx}{(a-b)n}=\frac{\pi-x}2", (r"0\le x<2\pi",)),
    (r"\sum_{k=0}^\infty(-1)^k\frac{\sin((2k+1)x)}{(2k+1)^2}=\frac{\pi x}4", (r"0\le x\le\pi",)),
    # Sums whose terms are not all shown to have values and to be large enough.
    (r"\sum_{k=0}^\infty\frac1k=\infty", ()),
    (r"\sum_{k=1}^\infty\frac1{k-5}=\infty", ()),
    (r"\sum_{k=1}^\infty\frac1{\sqrt{k-3}}=\infty", ()),
    (r"\sum_{k=1}^\infty\frac1{k\ln k}=\infty", ()),
    (r"\sum_{k=1}^\infty\frac1{k\ln^2(k+1)}=\infty", ()),
    (r"\sum_{k=1}^\infty\frac1{k+a}=\infty", ("a<0",)),
    (r"\sum_{k=1}^\infty\frac ak=\infty", (r"a\ge0",)),
    (r"\sum_{k=1}^\infty k^{-p}=\infty", ("p>0",)),
    (r"\sum_{k=0}^\infty q^k=\infty", (r"q\ge1",)),
    (r"\sum_{k=1}^\infty(-1)^kk=\infty", ()),
    (r"\sum_{k=1}^\infty(k-3)!=\infty", ()),
    # Inside a formula infinity is not a number, even if SymPy claims that the sum has a value.
    (r"\sum_{k=1}^\infty\frac1k=\sum_{k=1}^\infty\frac1{k+1}-1", ()),
    (r"\sum_{k=1}^\infty\frac1k-\sum_{k=1}^\infty\frac1k=0", ()),
    (r"\frac1{\sum_{k=1}^\infty\frac1k}=0", ()),
]


def judge(latex: str, where: tuple[str, ...] = ()) -> Verdict:
    (found,) = judge_pasted(Pasted(latex, where=where)).judgements
    return found.verdict


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "true", "wrong", "where"), PAIRS, ids=[p[0] for p in PAIRS])
def test_a_value_is_proved_and_another_refuted(
    latex: str, true: str, wrong: str, where: tuple[str, ...]
) -> None:
    assert judge(latex % true, where) is Verdict.PROVED
    assert judge(latex % wrong, where) is Verdict.REFUTED


@pytest.mark.parametrize(("latex", "where"), DIVERGENT)
def test_what_does_not_converge_is_no_number(latex: str, where: tuple[str, ...]) -> None:
    (found,) = judge_pasted(Pasted(latex, where=where)).judgements
    assert found.verdict is Verdict.REFUTED
    assert "does not converge" in found.reason


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "true", "needed", "wrong"), NOT_SAID)
def test_where_it_converges_is_told(latex: str, true: str, needed: str, wrong: str) -> None:
    (found,) = judge_pasted(Pasted(latex % true)).judgements
    assert found.verdict is Verdict.UNDECIDED
    assert found.reason == f"both sides agree where {needed}, which is not stated"
    assert judge(latex % true, tuple(needed.split(" and "))) is Verdict.PROVED
    assert judge(latex % wrong) is Verdict.REFUTED


@pytest.mark.parametrize(
    ("latex", "where"),
    [
        (r"\int_0^{\pi/2}\ln(2+\sin x)\,dx=0", ()),
        (r"\int_0^\pi\ln(a+\sin x)\,dx=\pi\ln a-\pi\ln2", ("a>0",)),
    ],
)
def test_a_sum_in_a_logarithm_is_no_product(latex: str, where: tuple[str, ...]) -> None:
    assert judge(latex, where) is Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(
    ("latex", "where"),
    [
        (r"\int_0^\infty\frac{\cos ax}{1+x^2}\,dx=\frac\pi2e^{-a}", ()),
        (r"\int_0^\infty\frac{x\sin ax}{1+x^2}\,dx=\frac\pi2e^{-a}", (r"a\ge0",)),
    ],
)
def test_a_known_integral_has_its_own_value_for_other_letters(
    latex: str, where: tuple[str, ...]
) -> None:
    assert judge(latex, where) is Verdict.REFUTED


@pytest.mark.parametrize("latex", WITHOUT_LIMIT)
def test_a_limit_that_differs_from_side_to_side_is_none(latex: str) -> None:
    assert judge(latex) is Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "where"), OPEN)
def test_what_has_no_value_stays_open(latex: str, where: tuple[str, ...]) -> None:
    assert judge(latex, where) is Verdict.UNDECIDED
