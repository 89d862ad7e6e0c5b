"""Pasted integrals, limits and sums from a textbook, each with a false neighbour."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A print with a place for its value, the true value and a wrong one, and the conditions stated.
PAIRS = [
    (
        r"\int_0^z\frac{dt}{t^2+\frac{(1-e)^2}{(1+e)^2}}=%s",
        (
            r"\frac{1+e}{1-e}\arctan\frac{(1+e)z}{1-e}",
            r"\frac{1+e}{1-e}\arctan\frac{(1-e)z}{1+e}",
        ),
        ("z>0", "0<e<1"),
    ),
    (
        r"\int_0^{2\pi}\frac{d\varphi}{a+b\cos\varphi}=%s",
        (r"\frac{2\pi}{\sqrt{a^2-b^2}}", r"\frac{2\pi}{\sqrt{a^2+b^2}}"),
        ("a>|b|",),
    ),
    (
        r"\int_0^{2\pi}\frac{d\varphi}{a+b\sin\varphi}=%s",
        (r"\frac{2\pi}{\sqrt{a^2-b^2}}", r"\frac{\pi}{\sqrt{a^2-b^2}}"),
        ("|b|<a",),
    ),
    (
        r"\int_0^{\frac\pi2}\frac{d\varphi}{1-k^2\sin^2\varphi}=%s",
        (r"\frac\pi{2\sqrt{1-k^2}}", r"\frac\pi{\sqrt{1-k^2}}"),
        ("0<k<1",),
    ),
    (
        r"\int_0^{2\pi}\frac{d\varphi}{(a+b\cos\varphi)^2}=%s",
        (r"\frac{2\pi a}{(a^2-b^2)^{3/2}}", r"\frac{2\pi b}{(a^2-b^2)^{3/2}}"),
        ("a>|b|",),
    ),
    (r"\int_0^{\frac\pi2}\frac{dx}{1+\tan^nx}=%s", (r"\frac\pi4", r"\frac\pi3"), ()),
    (
        r"\int_0^{\frac\pi2}\frac{\sin^nx}{\sin^nx+\cos^nx}\,dx=%s",
        (r"\frac\pi4", r"\frac\pi2"),
        ("n>0",),
    ),
    (r"\int_{-\infty}^\infty e^{-ax^2}dx=%s", (r"\sqrt{\pi/a}", r"\sqrt{\pi a}"), ("a>0",)),
    (
        r"\frac1{\sqrt{2\pi}s}\int_{-\infty}^\infty e^{-\frac{(x-m)^2}{2s^2}}dx=%s",
        ("1", "s"),
        ("s>0",),
    ),
    (
        r"\int_{-\infty}^\infty e^{-ax^2+bx}dx=%s",
        (r"\sqrt{\frac\pi a}e^{\frac{b^2}{4a}}", r"\sqrt{\frac\pi a}e^{\frac{b^2}{2a}}"),
        ("a>0",),
    ),
    (r"\int_0^1x^n\ln x\,dx=%s", (r"-\frac1{(n+1)^2}", r"-\frac1{n^2+1}"), (r"n\in\mathbb N",)),
    # Gamma functions of half-integers, by induction.
    (
        r"\Gamma\left(n+\frac12\right)=%s\sqrt\pi",
        (r"\frac{(2n)!}{4^nn!}", r"\frac{(2n)!}{2^nn!}"),
        (r"n\in\mathbb N",),
    ),
    (
        r"\Gamma(n)\Gamma\left(n+\frac12\right)=%s\sqrt\pi\,\Gamma(2n)",
        ("2^{1-2n}", "2^{2-2n}"),
        (r"n\in\mathbb N", r"n\ge1"),
    ),
    # Derivatives of any order.
    (
        r"\frac{d^n}{dx^n}\sin ax=%s",
        (r"a^n\sin\left(ax+\frac{n\pi}2\right)", r"a^n\sin\left(ax-\frac{n\pi}2\right)"),
        (),
    ),
    (r"\frac{d^n}{dx^n}(xe^x)=%s", ("(x+n)e^x", "(x+n-1)e^x"), ()),
    (
        r"\frac{d^n}{dx^n}\frac1{ax+b}=%s",
        (r"\frac{(-1)^nn!a^n}{(ax+b)^{n+1}}", r"\frac{(-1)^nn!a^n}{(ax+b)^n}"),
        ("a>0",),
    ),
    (r"\frac{d^n}{dx^n}\ln x=%s", (r"\frac{(-1)^{n-1}(n-1)!}{x^n}", r"\frac{(-1)^nn!}{x^n}"), ()),
    (r"\frac{d^n}{dx^n}x^m=%s", (r"\frac{m!}{(m-n)!}x^{m-n}", r"m!\,x^{m-n}"), (r"n\le m",)),
    (r"\frac{d^n}{dx^n}x^n=%s", ("n!", "(n+1)!"), ()),
    (r"\frac{d^n}{dx^n}x^{n+1}=%s", ("(n+1)!x", "n!x"), ()),
    (r"\frac{d^n}{dx^n}x^3=%s", ("0", "6"), (r"n\ge4",)),
    (r"\frac{d^{2n}}{dx^{2n}}\cos x=%s", (r"(-1)^n\cos x", r"-\cos x"), ()),
    # Floors, step by step within a period.
    (
        r"\lfloor x\rfloor+\left\lfloor x+\frac12\right\rfloor=%s",
        (r"\lfloor2x\rfloor", r"2\lfloor x\rfloor"),
        (),
    ),
    (
        r"\left\lfloor\frac n2\right\rfloor+\left\lceil\frac n2\right\rceil=%s",
        ("n", "n+1"),
        (r"n\in\mathbb N",),
    ),
    (r"\lfloor x\rfloor+\lfloor y\rfloor\le %s", ("x+y", "x+y-1"), ()),
    (r"\lceil x\rceil<%s", ("x+1", r"x+\frac12"), ()),
    # Sequences, for even and for odd n.
    (r"\lim_{n\to\infty}\frac{3n+(-1)^n}{2n-1}=%s", (r"\frac32", "2"), ()),
    (r"\lim_{n\to\infty}\frac{1+(-1)^{2n}}2=%s", ("1", "0"), ()),
    (r"\lim_{n\to\infty}\frac{(-1)^{n(n+1)/2}+n}n=%s", ("1", "0"), ()),
    # By reflecting the interval, by exchanging sine and cosine, and period by period.
    (r"\int_0^\pi\frac{x\sin x}{1+\cos^2x}dx=%s", (r"\frac{\pi^2}4", r"\frac{\pi^2}2"), ()),
    (r"\int_{-1}^1\frac{x^2}{1+e^x}dx=%s", (r"\frac13", r"\frac23"), ()),
    (
        r"\int_0^{\pi/2}\sin^nx\,dx=%s",
        (r"\int_0^{\pi/2}\cos^nx\,dx", r"\int_0^\pi\cos^nx\,dx"),
        (r"n\in\mathbb N",),
    ),
    (r"\int_0^{n\pi}|\sin x|\,dx=%s", ("2n", "n"), (r"n\in\mathbb N",)),
    # Arc lengths whose radicands are squares.
    (
        r"\int_0^\alpha r\sqrt{(t\cos t)^2+(t\sin t)^2}\,dt=%s",
        (r"\frac{r\alpha^2}2", r"r\alpha^2"),
        (r"\alpha>0",),
    ),
    (
        r"\int_0^\alpha\sqrt{(t\cos t)^2+(t\sin t)^2}\,dt=%s",
        (r"-\frac{\alpha^2}2", r"\frac{\alpha^2}2"),
        (r"\alpha<0",),
    ),
    (
        r"\int_0^l\sqrt{1+\sinh^2\frac xa}\,dx=%s",
        (r"a\sinh\frac la", r"a\cosh\frac la"),
        ("a>0", "l>0"),
    ),
    (
        r"\int_0^{2\pi}\sqrt{(R\cos^2t\sin t)^2+(R\sin^2t\cos t)^2}\,dt=%s",
        ("2R", "0"),
        ("R>0",),
    ),
    (
        r"\int_1^2\sqrt{1+\left(\frac x2-\frac1{2x}\right)^2}\,dx=%s",
        (r"\frac34+\frac12\ln2", r"\frac34-\frac12\ln2"),
        (),
    ),
    (r"\int_0^{2\pi}\sqrt{(R\sin t)^2+(R\cos t)^2}\,dt=%s", (r"2\pi|R|", r"2\pi R"), ()),
    (r"\int_0^x\sqrt{1-\sin^2t}\,dt=%s", (r"\sin x", r"\cos x"), (r"0<x<\frac\pi2",)),
    (r"\int_a^b\sqrt{t^2}\,dt=%s", (r"\frac{b^2-a^2}2", r"\frac{b^2-a^2}3"), ("b>a", "a>0")),
    # Sums whose terms change by one factor from n to n + 1.
    (r"a^n-b^n=(a-b)\sum_{k=0}^{n-1}%s", ("a^{n-1-k}b^k", "a^{n-k}b^k"), ()),
    (r"\sum_{k=1}^n2^{n-k}=%s", ("2^n-1", "2^n"), ()),
    (r"\sum_{k=1}^n(-1)^{n-k}k=%s", (r"\frac{2n+1-(-1)^n}4", r"\frac{2n+1}4"), ()),
    # Angles that increase in equal steps.
    (r"\sum_{k=0}^{n-1}\cos\left(x+\frac{2\pi k}n\right)=%s", ("0", r"\cos x"), (r"n\ge2",)),
    (r"\sum_{k=0}^{n-1}\cos^2\left(x+\frac{2\pi k}n\right)=%s", (r"\frac n2", "n"), (r"n\ge3",)),
    (r"\sum_{k=1}^n\sin\frac{2\pi k}n\cos\frac{2\pi k}n=%s", ("0", r"\frac{n-2}n"), ()),
    (r"\sum_{k=1}^n\cos\frac{2k\pi}{2n+1}=%s", (r"-\frac12", r"\frac12"), ()),
    (r"\sum_{k=1}^{n-1}\sin\frac{k\pi}n=%s", (r"\cot\frac\pi{2n}", r"\tan\frac\pi{2n}"), ()),
    (r"\prod_{k=1}^{n-1}2\sin\frac{k\pi}n=%s", ("n", "n-1"), ()),
    (
        r"\prod_{k=0}^{n-1}\sin\left(x+\frac{k\pi}n\right)=%s",
        (r"\frac{\sin nx}{2^{n-1}}", r"\frac{\sin nx}{2^n}"),
        (),
    ),
    # Limits of sequences by their quotients, and of functions that behave like their arguments.
    (r"\lim_{n\to\infty}\frac{n!}{n^n}=%s", ("0", "1"), ()),
    (r"\lim_{n\to\infty}\frac{a^n}{n!}=%s", ("0", "a"), ()),
    # Roots of degree n, by the quotients of radicands.
    (r"\lim_{n\to\infty}\binom{2n}n^{1/n}=%s", ("4", "3"), ()),
    (r"\lim_{n\to\infty}\frac{\sqrt[n]{n!}}n=%s", (r"\frac1e", "1"), ()),
    (r"\lim_{n\to\infty}\sqrt[n]{2^n+3^n}=%s", ("3", "2"), (r"n\in\mathbb N",)),
    (r"\lim_{n\to\infty}\frac{(n+1)!}{n\cdot n!}=%s", ("1", "0"), ()),
    (r"\lim_{n\to\infty}\frac{n!-1}{n!}=%s", ("1", "0"), ()),
    (r"\lim_{x\to0}\frac{\sqrt[3]{1+x}-1}x=%s", (r"\frac13", r"\frac12"), ()),
    (r"\lim_{x\to-1}\frac{1+\sqrt[3]x}{1+x}=%s", (r"\frac13", "1"), ()),
    (r"\lim_{x\to0}\frac{\sqrt[5]{1+x}-\sqrt[3]{1+x}}x=%s", (r"-\frac2{15}", "0"), ()),
    (r"\lim_{x\to\infty}\left(\sqrt[3]{x^3+ax^2}-x\right)=%s", (r"\frac a3", "a"), ()),
    (r"\lim_{x\to0}\frac{1-\sqrt[3]{\cos x}}{x^2}=%s", (r"\frac16", r"\frac13"), ()),
    (r"\lim_{x\to0}\frac{\sqrt[5]{1+x}-\cos x}x=%s", (r"\frac15", "0"), ()),
    (r"\lim_{x\to0}\frac{\sqrt[3]{1+x^2}-\cosh x}{x^2}=%s", (r"-\frac16", r"\frac13"), ()),
    (r"\lim_{x\to0}\frac{e^{x^2}-\cos x}{x^2}=%s", (r"\frac32", r"\frac12"), ()),
    (r"\lim_{n\to\infty}nq^n=%s", ("0", "q"), ("|q|<1", r"n\in\mathbb N")),
    (r"\lim_{n\to\infty}\frac{(-1)^n}n=%s", ("0", "1"), (r"n\in\mathbb N",)),
    (r"\lim_{n\to\infty}\left(1+\frac xn\right)^n=%s", ("e^x", "e^{2x}"), ()),
    (r"\lim_{n\to\infty}n\sin\frac{2\pi}n=%s", (r"2\pi", "0"), (r"n\in\mathbb N",)),
    (r"\lim_{n\to\infty}n\tan\frac\pi n=%s", (r"\pi", "0"), ()),
    (r"\lim_{x\to\infty}x(\ln(x+a)-\ln x)=%s", ("a", "2a+1"), ()),
    (r"\lim_{x\to0}\frac{\sin ax}{\sin bx}=%s", (r"\frac ab", r"\frac ba"), (r"b\ne0",)),
    (r"\lim_{n\to\infty}\sum_{k=0}^nq^k=%s", (r"\frac1{1-q}", r"\frac q{1-q}"), ("|q|<1",)),
    (
        r"\prod_{k=0}^n(1+x^{2^k})=%s",
        (r"\frac{1-x^{2^{n+1}}}{1-x}", r"\frac{1-x^{2^n}}{1-x}"),
        (r"x\ne1",),
    ),
    (r"\sum_{n=1}^\infty\frac1{n\binom{2n}n}=%s", (r"\frac{\pi\sqrt3}9", r"\frac{\pi\sqrt3}6"), ()),
    (
        r"\sum_{n=1}^\infty n^2x^n=%s",
        (r"\frac{x(1+x)}{(1-x)^3}", r"\frac{x(1-x)}{(1-x)^3}"),
        ("-1<x<1",),
    ),
    (
        r"\sum_{n=2}^\infty n(n-1)x^{n-2}=%s",
        (r"\frac2{(1-x)^3}", r"\frac3{(1-x)^3}"),
        ("-1<x<1",),
    ),
    (r"\prod_{n=2}^\infty\left(1-\frac1{n^2}\right)=%s", (r"\frac12", r"\frac13"), ()),
    # By parts, from one whole number to the next.
    (r"\int_0^\infty x^ne^{-x}dx=%s", ("n!", "(n+1)!"), ()),
    (r"\int_0^\infty x^ne^{-ax}dx=%s", (r"\frac{n!}{a^{n+1}}", r"\frac{n!}{a^n}"), ("a>0",)),
    (r"\int_0^1(\ln x)^ndx=%s", ("(-1)^nn!", "n!"), ()),
    (
        r"\int_0^1x^m(1-x)^ndx=%s",
        (r"\frac{m!n!}{(m+n+1)!}", r"\frac{m!n!}{(m+n)!}"),
        (r"m,n\in\mathbb N",),
    ),
    (
        r"\int_0^{2\pi}\cos^{2n}x\,dx=%s",
        (r"2\pi\frac{(2n)!}{4^n(n!)^2}", r"\pi\frac{(2n)!}{4^n(n!)^2}"),
        (),
    ),
    (
        r"\int_0^\infty x^{2n}e^{-x^2}dx=%s",
        (r"\frac{(2n)!}{4^nn!}\frac{\sqrt\pi}2", r"\frac{(2n)!}{2^nn!}\frac{\sqrt\pi}2"),
        (),
    ),
    (
        r"\int_0^\infty\frac{dx}{(1+x^2)^n}=%s",
        (r"\frac\pi2\frac{(2n-2)!}{4^{n-1}((n-1)!)^2}", r"\frac\pi2\frac{(2n)!}{4^n(n!)^2}"),
        (),
    ),
]
FACTORIALS = [
    ("7!!=%s", "105", "5040"),
    ("(2n)!!=%s", "2^nn!", "2^{n+1}n!"),
    ("(2n-1)!!=%s", r"\frac{(2n)!}{2^nn!}", r"\frac{(2n)!}{2^{n-1}n!}"),
    (r"\frac{(2n+1)!}{(2n)!!}=%s", "(2n+1)!!", "(2n-1)!!"),
    (r"\prod_{k=1}^n\frac{2k-1}{2k}=%s", r"\frac{(2n-1)!!}{(2n)!!}", r"\frac{(2n)!!}{(2n+1)!!}"),
]
NOT_PROVED = [
    # The integrand and its mirror image have a constant sum, but neither has an integral.
    (r"\int_0^{\frac\pi2}\left(\frac12+\cot2x\right)dx=\frac\pi4", ()),
    # Floors that agree except at isolated numbers, and floors of different numbers.
    (r"\lfloor x\rfloor+\lfloor-x\rfloor=-1", ()),
    (r"\lfloor x\rfloor<x", ()),
    (r"\lfloor x\rfloor+1\le x+\lfloor y\rfloor-\lfloor z\rfloor", ()),
    (r"\left\lfloor\frac x2\right\rfloor+\left\lceil\frac x2\right\rceil=x", ()),
    # Limits that differ for even and for odd n, or that exist for only one of them.
    (r"\lim_{n\to\infty}(-1)^n=1", ()),
    (r"\lim_{n\to\infty}(-1)^{n(n+1)/2}=1", ()),
    (r"\lim_{n\to\infty}\frac{n(-1)^n}{n+1}=1", ()),
    (r"\lim_{n\to\infty}(1+(-1)^n)n=0", ()),
    # Derivatives at a single point, and where the function has no value.
    (r"\frac{d^n}{dx^n}x^2=2x", (r"x\ge1", r"x\le1")),
    (r"\frac{d^n}{dx^n}\ln x=\frac{(-1)^{n-1}(n-1)!}{x^n}", ("x<0",)),
    (r"\frac{d^n}{dx^n}x^2=0", (r"n\ge m", r"m\in\mathbb N")),
    # A divisor that may be zero, or negative.
    (r"\int_0^{2\pi}\frac{d\varphi}{a+b\cos\varphi}=\frac{2\pi}{\sqrt{a^2-b^2}}", (r"a\ge|b|",)),
    (r"\int_0^{2\pi}\frac{d\varphi}{a+b\cos\varphi}=\frac{2\pi}{\sqrt{a^2-b^2}}", ("|a|>|b|",)),
    (r"a+b\sin\varphi>0", (r"a\ge|b|",)),
    (r"b+a\sin\varphi>0", ("a>|b|",)),
    (r"\int_{-\infty}^\infty e^{-ax^2}dx=\sqrt{\pi/a}", (r"a\ge0",)),
    (r"\int_{-\infty}^\infty e^{-ax^2+bx}dx=\sqrt{\frac\pi a}e^{\frac{b^2}{4a}}", (r"a\ne0",)),
    (r"\int_0^1x^n\ln x\,dx=-\frac1{(n+1)^2}", ()),
    # By parts, from one whole number to the next: no limit at an end, no value for the first
    # number, a pole between the limits.
    (r"\int_{-\infty}^\infty x^ne^{-x}dx=n!", ()),
    (r"\int_0^\infty x^ne^{-ax}dx=\frac{n!}{a^{n+1}}", (r"a\ne0",)),
    (r"\int_0^\infty x^{-n}e^{-x}dx=n!", ()),
    (r"\int_0^1x^{n-2}(1-x)^mdx=\frac{m!(n-2)!}{(m+n-1)!}", ()),
    (r"\int_0^\infty\sin^nx\,dx=\pi\frac{(2n)!}{4^n(n!)^2}", ()),
    (r"\int_{-2}^0\frac{dx}{(1+x)^{2n}}=\frac{2}{1-2n}", (r"n\in\mathbb N",)),
    # Poles that look alike from both ends, or in each period; a supposed factor that is not one.
    (r"\int_{-1}^1\frac{dx}{x^3}=0", ()),
    (r"\int_0^2\frac{dx}{x-1}=0", ()),
    (r"\int_0^\pi\tan x\,dx=0", ()),
    (r"\int_0^{n\pi}\tan x\,dx=0", (r"n\in\mathbb N",)),
    (r"\int_0^n\frac{dx}{x-n}=0", (r"n\in\mathbb N",)),
    (r"\sum_{k=1}^n(n-k)!=n!", ()),
    (r"a^n-b^n=(a+b)\sum_{k=0}^{n-1}a^{n-1-k}b^k", ()),
    # Roots of squares whose base may have either sign, or has no value between the limits.
    (r"\int_a^b\sqrt{t^2}\,dt=\frac{b^2-a^2}2", ("b>a",)),
    (r"\int_0^x\sqrt{1-\sin^2t}\,dt=\sin x", ("x>0",)),
    (r"\int_0^l\sqrt{\cosh^2\frac xa-1}\,dx=a\cosh\frac la-a", ("a>0",)),
    (r"\int_0^l\sqrt{1+\sinh^2\frac xa}\,dx=l\sinh\frac la", ()),
    (r"\int_0^\pi\sqrt{1+\tan^2x}\,dx=0", ()),
    (r"\int_{-1}^1\sqrt{\frac1{t^2}}\,dt=2", ()),
    # Steps that may be a whole turn, or no part of one; terms and sums without a value.
    (r"\sum_{k=0}^{n-1}\cos\frac{2\pi k}n=0", ()),
    (r"\sum_{k=0}^{n-1}\cos^2\left(x+\frac{2\pi k}n\right)=\frac n2", (r"n\ge2",)),
    (r"\sum_{k=0}^{n-1}\cos^3\left(x+\frac{2\pi k}n\right)=0", (r"n\ge3",)),
    (r"\sum_{k=0}^{n-1}\cos\frac{2\pi ak}n=0", (r"n\ge2",)),
    (r"\sum_{k=0}^{n-1}\cos\frac{2\pi mk}n=0", (r"n\ge2", r"m\in\mathbb N")),
    (r"\sum_{k=1}^{n-2}\cos\frac{2\pi k}n=-1-\cos\frac{2\pi}n", ()),
    (r"\sum_{k=0}^{n-1}\frac1{n-1}\cos\frac{2\pi k}n=0", ()),
    (r"\sum_{k=1}^n\tan\frac{k\pi}n=0", ()),
    (r"\sum_{k=0}^{n-1}\cos\frac{2\pi k}{n-2}=1", (r"n\ge2",)),
    (r"\prod_{k=0}^{n-1}\cos\left(x+\frac{k\pi}n\right)=\frac{\cos nx}{2^{n-1}}", ()),
    (r"\prod_{k=1}^{n-1}a\sin\frac{k\pi}n=\frac{na}{2^{n-1}}", ()),
    (r"\prod_{k=1}^{n-2}\sin\frac{k\pi}n=\frac n{2^{n-1}\sin\frac\pi n}", ()),
    # Quotients that tend to 1 or more, or to no limit; terms without a value far out.
    (r"\lim_{n\to\infty}q^n=0", (r"|q|\le1", r"n\in\mathbb N")),
    (r"\lim_{n\to\infty}\frac{3^nn!}{n^n}=0", ()),
    (r"\lim_{n\to\infty}\frac{n!}{a^n}=0", ()),
    (r"\lim_{n\to\infty}(-1)^n=0", (r"n\in\mathbb N",)),
    (r"\lim_{n\to\infty}\ln(a-n)\cdot2^{-n}=0", (r"n\in\mathbb N",)),
    (r"\lim_{n\to\infty}(a-n)!\cdot2^{-n}=0", (r"a,n\in\mathbb N",)),
    (r"\lim_{n\to\infty}\frac{\sqrt{a-n}}{\sqrt{a-n}}\cdot2^{-n}=0", (r"n\in\mathbb N",)),
    (r"\prod_{n=0}^\infty\frac nn=1", ()),
    (r"\int_a^b\frac{dx}x=\ln\left|\frac ba\right|", ("a<0", "b>0")),
    (r"\prod_{k=1}^\infty\frac{2k-1}{2k}=1", ()),
    (r"\lim_{x\to0}\frac{\sin(nx)}{nx}=1", (r"n\ge0", r"n\in\mathbb N")),
    (r"\lim_{x\to0}\frac{\sin(ax)}{ax}=1", ()),
    # A factorial without a value, though it cancels.
    ("(n-2)!-(n-2)!=0", ()),
    ("(n-20)!-(n-20)!=0", ()),
    (r"\frac{(20-n)!}{(20-n)!}=1", ()),
    (r"0\cdot(n-2)!=0", ()),
    ("((n-2)!)^0=1", ()),
    ("(n-1)!-(n-1)!=0", (r"n\ge0",)),
    (r"\frac{(n-k)!}{(n-k)!}=1", ()),
    (r"\sum_{k=1}^n((k-2)!-(k-2)!)=0", ()),
    ("(2n-4)!-(2n-4)!=0", (r"n\in\mathbb N",)),
    ("(20-3n)!-(20-3n)!=0", (r"n\in\mathbb N",)),
    ("(2n-4)!!-(2n-4)!!=0", (r"n\in\mathbb N",)),
    ("(2n-5)!!-(2n-5)!!=0", (r"n\in\mathbb N",)),
    (r"\binom{n-2}k-\binom{n-2}k=0", (r"n,k\in\mathbb N",)),
]
PROVED = [
    (r"\int_0^\infty x^{n-2}e^{-x}dx=(n-2)!", (r"n\ge2",)),
    ("(n-2)!-(n-2)!=0", (r"n\ge2",)),
    (r"\frac{(n-k)!}{(n-k)!}=1", ("k<n",)),
    (r"\frac{(n+2)!}{(n+2)!}=1", ()),
    ("(2n-4)!-(2n-4)!=0", (r"n\in\mathbb N", r"n\ge2")),
]


def judge(latex: str, where: tuple[str, ...] = ()) -> set[Verdict]:
    return {found.verdict for found in judge_pasted(Pasted(latex, where=where)).judgements}


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "values", "where"), PAIRS, ids=[p[0] for p in PAIRS])
def test_a_value_is_proved_and_no_other(
    latex: str, values: tuple[str, str], where: tuple[str, ...]
) -> None:
    true, wrong = values
    assert judge(latex % true, where) == {Verdict.PROVED}
    assert Verdict.PROVED not in judge(latex % wrong, where)


@pytest.mark.parametrize(("latex", "true", "wrong"), FACTORIALS)
def test_factorials_are_read(latex: str, true: str, wrong: str) -> None:
    assert judge(latex % true, (r"n\in\mathbb N",)) == {Verdict.PROVED}
    assert Verdict.PROVED not in judge(latex % wrong, (r"n\in\mathbb N",))


@pytest.mark.parametrize("latex", ["n!!=1", "n!!!=1"])
def test_a_double_factorial_is_that_of_an_even_or_of_an_odd_number(latex: str) -> None:
    with pytest.raises(ReadingError):
        judge(latex)


@pytest.mark.parametrize(("latex", "where"), PROVED)
def test_what_has_a_value_where_it_is_meant_is_proved(latex: str, where: tuple[str, ...]) -> None:
    assert judge(latex, where) == {Verdict.PROVED}


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "where"), NOT_PROVED)
def test_what_is_not_true_everywhere_is_not_proved(latex: str, where: tuple[str, ...]) -> None:
    assert Verdict.PROVED not in judge(latex, where)


@pytest.mark.parametrize("latex", [r"\int_0^1e^{-x^2+\sqrt x}dx=1", r"\int_0^1e^{-x+\sin x}dx=1"])
def test_an_integral_without_an_antiderivative_is_refuted_by_its_number(latex: str) -> None:
    assert judge(latex) == {Verdict.REFUTED}
