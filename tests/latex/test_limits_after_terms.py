r"""Values between limits, `[F]_0^1`, and derivatives of matrices: read, and judged as written."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

PROVED, REFUTED = Verdict.PROVED, Verdict.REFUTED
_TURN = r"\begin{pmatrix}\cos\varphi&-\sin\varphi\\\sin\varphi&\cos\varphi\end{pmatrix}"
ROWS = [
    (r"\left.\frac{x^3}{3}\right|_0^2=\frac83", (PROVED,)),
    (r"\int_0^2x^2\,dx=\left[\frac{x^3}{3}\right]_0^2=\frac73", (PROVED, REFUTED)),
    (r"\int_0^lax\,dx=\left[\frac{ax^2}{2}\right]_0^l=\frac{al^2}2", (PROVED, PROVED)),
    (r"\int_0^lax\,dx=\left[\frac{ax^2}{2}\right]_l^0", (REFUTED,)),
    (r"\left.ax^2\right|_{x=1}^{x=2}=3a", (PROVED,)),
    # Bars after a power or a function that is the whole member.
    (r"x^2|^2_1=3", (PROVED,)),
    (r"x^2|_1^2=-3", (REFUTED,)),
    (r"\ln(x)\Big|^{2}_{1}=\ln2", (PROVED,)),
    (r"\sin^2(x)|_{x=2}=\sin^22", (PROVED,)),
    (r"\sin^2(x)|_{x=2}=\sin2", (REFUTED,)),
    (r"\int_0^1\int_0^1\int_0^1xyz\,dxdydz=\frac18", (PROVED,)),
    (r"\int_0^1\int_0^1\int_0^1xyz\,dxdydz=\frac14", (REFUTED,)),
    (r"a\left[\sin2\varphi\right]_0^{\pi/4}=a", (PROVED,)),
    (r"\int_0^\infty x\mathrm e^{-x}\,dx=\left[-(x+1)\mathrm e^{-x}\right]_0^\infty", (PROVED,)),
    (r"\left[\frac x{x+1}\right]_0^\infty=1", (PROVED,)),
    (r"\left[\frac x{x+1}\right]_0^\infty=2", (REFUTED,)),
    (rf"\frac{{d}}{{d\varphi}}{_TURN}=\begin{{pmatrix}}0&-1\\1&0\end{{pmatrix}}{_TURN}", (PROVED,)),
    (rf"\frac{{d}}{{d\varphi}}{_TURN}=\begin{{pmatrix}}0&1\\1&0\end{{pmatrix}}{_TURN}", (REFUTED,)),
    (r"\frac d{dt}\begin{pmatrix}a\\|t|\end{pmatrix}=\begin{pmatrix}0\\1\end{pmatrix}", (REFUTED,)),
]
REFUSED = [
    (r"\left[ax\right]_0^2=2a", "of which letter"),
    # An undeclared function, or a letter that may be one of another letter.
    (r"\int_0^1x\,dx=[G]_0^1", "of which letter"),
    (r"[y]_0^1=1", "of which letter"),
    (r"1+x^2|_0^1=1", "how far"),
    (r"2\sin(x)|_0^1=1", "how far"),
    (r"\ln x|_1^2=\ln2", "how far"),
    (r"\left[\frac{x-1}{x-1}\right]_1^2=0", "divides by zero"),
    (r"\left[\frac1x\right]_0^1=1", "divides by zero"),
    (r"\frac d{dt}\begin{pmatrix}a\\b\end{pmatrix}=0", "does that depend on it"),
]


@pytest.mark.parametrize(("latex", "verdicts"), ROWS)
def test_what_is_written_is_judged(latex: str, verdicts: tuple[Verdict, ...]) -> None:
    assert tuple(j.verdict for j in judge_pasted(Pasted(latex)).judgements) == verdicts


@pytest.mark.parametrize(("latex", "words"), REFUSED)
def test_what_has_no_value_or_letter_is_refused(latex: str, words: str) -> None:
    with pytest.raises(ReadingError, match=words):
        judge_pasted(Pasted(latex))


def test_limits_are_not_those_of_a_letter_that_others_give() -> None:
    with pytest.raises(ReadingError, match="which other letters define"):
        judge_pasted(Pasted(r"[2y]_0^1=2", values=("y=x^2+x",)))
