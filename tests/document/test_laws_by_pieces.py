"""Piecewise laws, in one display or several: their derivatives, and where the pieces meet."""

from __future__ import annotations

import pytest
from small_papers import outcomes

pytestmark = pytest.mark.usefixtures("judged_here")

CASES = {
    "derivatives by pieces are compared beside the seams": (
        [
            r"s=\begin{cases}a\psi^2&\psi\le1\\a(2\psi-1)&\psi>1\end{cases}",
            r"s'=\begin{cases}2a\psi&\psi<1\\2a&\psi>1\end{cases}",
            r"s''=\begin{cases}0&\psi\ge1\\2a&\psi<1\end{cases}",
            r"s''=\begin{cases}2a&\psi<1\\0&\text{otherwise}\end{cases}",
            r"s''=\begin{cases}2a&\psi<2\\0&\text{otherwise}\end{cases}",
            r"s''=\begin{cases}2a&\psi<1\\a&\psi>1\end{cases}",
        ],
        ["DEFINITION", "PROVED", "PROVED", "PROVED", "REFUTED", "REFUTED"],
    ),
    "a brace before an array opens cases, and a stop ends them": (
        [
            r"s=\left\{\begin{array}{ll}a\psi^2,&\psi\le1\\a(2\psi-1),&\psi>1.\end{array}\right.",
            r"s'=\left\{\begin{array}{ll}2a\psi&\text{if }\psi<1\\2a&\text{otherwise.}\end{array}"
            r"\right.",
            r"s'=\left\{\begin{array}{ll}2a\psi&\psi<1\\a&\psi>1.\end{array}\right.",
            r"s''=\begin{cases}2a,&\psi<1,\\0,&\psi>1.\end{cases}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED"],
    ),
    "conditions in brackets": (
        [
            r"s=\begin{cases}a\psi^2&(\psi\le1)\\"
            r"a(2\psi-1)&\left(\text{if }\psi>1\right)\end{cases}",
            r"s'=\begin{cases}2a\psi&\left(\psi<1\right)\\2a&[\psi>1]\end{cases}",
            r"s'=\begin{cases}2a\psi&\left(\psi<1\right)\\a&[\psi>1]\end{cases}",
            r"s''=\begin{cases}2a&(\psi-2)(\psi+3)<0\\0&(\psi>2)\end{cases}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "REFUTED"],
    ),
    "seams with letters": (
        [
            r"s=\begin{cases}a\psi^2&\psi\le k\\2ak\psi-ak^2&\psi\ge k\end{cases}",
            r"s'=\begin{cases}2a\psi&\psi<k\\2ak&\text{otherwise}\end{cases}",
            r"s''=\begin{cases}2a&\psi<k\\0&\psi>k\end{cases}",
            r"s''=\begin{cases}2a&\psi<k\\2&\psi>k\end{cases}",
            r"s'(k)=2ak",
            r"s'(k)=ak",
            r"s''(k)=0",
        ],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED", "PROVED", "REFUTED", "not read"],
    ),
    "derivatives are compared where their pieces join": (
        [
            r"s=\begin{cases}a\psi^2&0\le\psi\le k\\2ak\psi-ak^2&k\le\psi\le u\end{cases}",
            r"s'=\begin{cases}2a\psi&0\le\psi<k\\2ak&\text{otherwise}\end{cases}",
            r"s'=\begin{cases}2a\psi&0\le\psi\le k\\2ak&k<\psi\le u\end{cases}",
            r"s'=\begin{cases}2a\psi&0\le\psi<k\\2a\psi&k\le\psi\le u\end{cases}",
            r"s''=\begin{cases}2a&0\le\psi\le k\\0&\text{otherwise}\end{cases}",
        ],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED", "PROVED"],
    ),
    "values of a law by pieces": (
        [
            r"s=\begin{cases}a\psi^2&0\le\psi\le k\\2ak\psi-ak^2&k<\psi\le u\end{cases}",
            r"s(0)=0",
            r"s(u)=2aku-ak^2",
            r"s(u)=2aku-2ak^2",
        ],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED"],
    ),
    "a law that jumps has no derivative there": (
        [
            r"s=\begin{cases}a\psi&\psi\le1\\a\psi+h&\psi>1\end{cases}",
            r"s'=a",
            r"s'(1)=a",
            r"s'(2)=a",
        ],
        ["DEFINITION", "PROVED", "not read", "DEFINITION"],
    ),
    "a law in displays of its own, and where its pieces meet": (
        [
            r"s=a\psi^2,\quad 0\le\psi\le k",
            r"s(\psi)=2ak\psi-ak^2\quad\text{for }k<\psi\le u",
            r"s=2aku-ak^2,\quad\psi>u",
            r"s'=2a\psi,\quad 0\le\psi\le k",
            r"s'=2ak,\quad k<\psi\le u",
            r"s''=2a,\quad 0\le\psi<k",
            r"s''=a,\quad 0\le\psi<k",
            r"s(0)=0",
            r"s=a\sin^2\psi,\quad 0\le\psi\le k",
        ],
        [*["DEFINITION"] * 3, *["PROVED"] * 3, "REFUTED", "PROVED", "REFUTED", *["PROVED"] * 3],
    ),
    "a piece that does not begin where the one before it ends, beside its velocity": (
        [
            r"s=a\psi^2,\quad 0\le\psi\le k",
            r"s=2ak\psi+ak^2,\quad k<\psi\le u",
            r"s'=2a\psi,\quad 0\le\psi\le k",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "two values at one place": (
        [r"s=a\psi^2,\quad 0\le\psi\le k", r"s=ak^2+h,\quad k\le\psi\le u"],
        ["DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "a piece on both sides of zero": (
        [
            r"s=a-a\psi^2,\quad|\psi|\le1",
            r"\int_{-1}^1s\,d\psi=\frac43a",
            r"\int_{-1}^1s\,d\psi=\frac23a",
        ],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a law may jump": (
        [r"s=a\psi^2,\quad 0\le\psi\le k", r"s=ak^2+h,\quad k<\psi\le u"],
        ["DEFINITION", "DEFINITION", "not judged"],
    ),
    "a velocity may jump": (
        [
            r"s'=2a\psi,\quad 0\le\psi\le k",
            r"s'=0,\quad k\le\psi\le u",
            r"s''=2a,\quad 0<\psi<k",
            r"s''=a,\quad 0<\psi<k",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED", "not judged"],
    ),
    "ranges that overlap are no pieces of one law": (
        [r"s=a\psi^2,\quad 0\le\psi\le k", r"s=2a\psi,\quad 0\le\psi\le m"],
        ["DEFINITION", "DEFINITION"],
    ),
    "a law with one range, and its mean": (
        [
            r"s=h\psi,\quad 0\le\psi\le k",
            r"m=\int_0^ks\,d\psi=\frac{hk^2}2",
            r"n=\int_0^ks\,d\psi=\frac{hk^2}3",
            r"s'=h,\quad 0\le\psi\le k",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "DEFINITION", "REFUTED", "PROVED"],
    ),
    "pieces whose other letters are matrices": (
        [
            r"s=a\psi,\quad\psi\le k",
            r"s=ak,\quad\psi>k",
            r"RR^T=R^TR",
            r"s'=a,\quad\psi<k",
        ],
        ["DEFINITION", "DEFINITION", "not judged", "PROVED", "PROVED"],
    ),
    "pieces in ranges of an angle that moves": (
        [
            r"x=r\cdot(1-\cos\varphi),\quad 0\le\varphi\le\pi/2",
            r"x=r\cdot(\varphi-\pi/2+1),\quad\pi/2\le\varphi\le\pi",
            r"\dot x=r\dot\varphi\sin\varphi,\quad 0\le\varphi\le\pi/2",
            r"\ddot x=r\ddot\varphi\sin\varphi+r\dot\varphi^2\cos\varphi,\quad 0<\varphi<\pi/2",
            r"\dot x=r\dot\varphi,\quad\pi/2\le\varphi\le\pi",
        ],
        ["DEFINITION", "DEFINITION", *["PROVED"] * 4],
    ),
    "one range of an angle that moves, and a wrong velocity": (
        [
            r"x=r\cdot(1-\cos\varphi),\quad 0\le\varphi\le\pi/2",
            r"\dot x=r\dot\varphi\cos\varphi",
            r"\ddot x=r\ddot\varphi\sin\varphi+r\dot\varphi^2\cos\varphi",
        ],
        ["DEFINITION", "REFUTED", "PROVED"],
    ),
    "a place in a range of an angle, another in one of time": (
        [
            r"x=r\cdot(1-\cos\varphi),\quad 0\le\varphi\le\pi/2",
            r"x=r k,\quad t\ge0",
        ],
        ["DEFINITION", "DEFINITION"],
    ),
    "a derivative between the pieces is that of the one before it": (
        [
            r"s=\frac{a\psi^2}{k},\quad0\le\psi\le k",
            r"s'=\frac{2a\psi}{k}",
            r"s''=\frac{2a}{k^2}",
            r"s=ak,\quad\psi>k",
            r"s'=\frac{2a\psi}{k}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "DEFINITION", "REFUTED", "PROVED"],
    ),
    "a range of a ratio is one of what it grows with": (
        [
            r"u=\frac\psi k",
            r"s=a u^2,\quad0\le u\le1",
            r"s'=\frac{2a u}{k}",
            r"s'=\frac{2a u}{k^2}",
            r"s(k)=a",
            r"s=a,\quad u>1",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED", "PROVED", "DEFINITION", "PROVED"],
    ),
    "of a letter of any sign no range is known": (
        [r"u=\frac\psi m", r"s=a u^2,\quad0\le u\le1", r"s(0)=0", r"s'=\frac{2a u}{m}"],
        ["DEFINITION", "DEFINITION", "not read", "DEFINITION"],
    ),
    "a law in a ratio, with a range of what gives it": (
        [
            r"u=\frac\psi k",
            r"s=a u^2,\quad0\le\psi\le k",
            r"s=a,\quad k\le\psi",
            r"s=a u,\quad k\le\psi",
        ],
        ["DEFINITION", "DEFINITION", "DEFINITION", "not judged", "PROVED"],
    ),
    "the largest and the smallest value of a law": (
        [
            r"s=\begin{cases}a\psi/k&0\le\psi\le k\\a&\psi>k\end{cases}",
            r"\max_\psi s=a",
            r"\max_\psi s=2a",
            r"\min_\psi s=0",
            r"h=\begin{cases}a\sin\frac{\pi\psi}k&0\le\psi\le k\\0&\psi>k\end{cases}",
            r"\max_\psi h=a",
            r"\min_\psi h=0",
            r"\min_\psi h=-a",
        ],
        [
            *("DEFINITION", "PROVED", "REFUTED", "PROVED"),
            *("DEFINITION", "PROVED", "PROVED", "REFUTED"),
        ],
    ),
    "pieces of a law are no contradiction": (
        [r"k=m,\quad m>0", r"k=-m,\quad m<0"],
        ["DEFINITION", "DEFINITION"],
    ),
}
# Additional lines of the block of a case.
SAID = {
    "a derivative between the pieces is that of the one before it": "%% where 0<k\n",
    "a range of a ratio is one of what it grows with": "%% where 0<k\n",
    "a law in a ratio, with a range of what gives it": "%% where 0<k\n",
    "a law in displays of its own, and where its pieces meet": "%% where 0<k<u\n",
    "values of a law by pieces": "%% where 0<k<u\n",
    "a law with one range, and its mean": "%% where 0<k\n",
    "the largest and the smallest value of a law": "%% where 0<k; a>0; \\psi>=0\n",
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_rows_of_laws_have_their_outcome(case: str) -> None:
    equations, expected = CASES[case]
    assert outcomes(*equations, block=SAID.get(case, "")) == expected
