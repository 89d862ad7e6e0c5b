r"""True prints are not refuted for the way they are printed; their false twins are.

Decimals are rounded, a bracket with commas stands for a column, a residual has either sign,
matrices without values are judged entry by entry.
"""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from mechproof.latex import read_paper
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import LENGTH, Equation, Paper, Variable

x, y = sp.symbols("x y", real=True)
h, m = sp.symbols("h m", positive=True)
A, B = (sp.MatrixSymbol(name, 3, 3) for name in "AB")
u, v = (sp.MatrixSymbol(name, 3, 1) for name in "uv")
J = sp.MatrixSymbol("J", 2, 2)
p = sp.MatrixSymbol("p", 2, 1)
POSITIVE = sp.Interval.open(0, sp.oo)
VARIABLES = (
    *(Variable(s, "", latex=(str(s),)) for s in (x, y, A, B)),
    *(Variable(s, "", LENGTH, POSITIVE, latex=(str(s),)) for s in (h, m)),
    *(Variable(s, "", LENGTH, latex=(str(s),)) for s in (u, v)),
    *(Variable(s, "", within=POSITIVE, latex=(str(s),)) for s in sp.symbols("l g", positive=True)),
    Variable(J, "", LENGTH, given=sp.ImmutableMatrix([[h, m], [m, -h]]), latex=("J",)),
    Variable(p, "", given=sp.ImmutableMatrix([x, 2 * x]), latex=("p",)),
    Variable(sp.Symbol("q", real=True), "", given=sp.Rational(1, 3), latex=("q",)),
)
TRUE, FALSE = Verdict.PROVED, Verdict.REFUTED


def judge_print(latex: str, **declared: Any) -> list[Verdict]:
    paper = read_paper(Paper("own", "", VARIABLES, (Equation("(1)", latex, **declared),)))
    return [judge(row, paper).verdict for row in paper.rows]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        *((r"\cos 30^\circ=0.866", TRUE), (r"\cos 30^\circ=0.867", FALSE)),
        *((r"\cos 30^o=0.866", TRUE), (r"\frac{360^{o}}5=\frac{2\pi}6", FALSE)),
        *((r"0.79=\frac\pi4", TRUE), (r"0.78=\frac\pi4", FALSE)),
        *((r"\arctan 0.5=26.57^\circ", TRUE), (r"\arctan 0.5=26.56^\circ", FALSE)),
        *((r"\sin(-20^\circ)=-0.34", TRUE), (r"\sin(-20^\circ)=0.34", FALSE)),
        *((r"\frac12=0.5", TRUE), (r"\frac12=0.52", FALSE), ("q=0.333", TRUE), ("q=0.334", FALSE)),
        *((r"\frac13=0", FALSE), ("x=0.5x", FALSE)),
        # Adjacent letters, but two arguments of \frac: not the function lg.
        *((r"\frac lg=l/g", TRUE), (r"\frac lg=g/l", FALSE), (r"\frac hlm=hm/l", TRUE)),
        # Rows and columns.
        (r"2p=(2x, 4x)", TRUE),
        (r"2p=(2x, 2x)", FALSE),
        (r"2p=\begin{pmatrix}2x&4x\end{pmatrix}", FALSE),
        (r"(2x, 4x)^T=2p", TRUE),
        (r"p^Tp=5x^2", TRUE),
        (r"p^T\begin{pmatrix}-2\\1\end{pmatrix}=0", TRUE),
        (r"p^T\begin{pmatrix}2\\1\end{pmatrix}=0", FALSE),
        # Matrices and vectors about which nothing is known.
        *((r"(AB)^T=B^TA^T", TRUE), (r"(AB)^T=A^TB^T", FALSE)),
        *((r"A(u+v)=Au+Av", TRUE), ("AB=BA", FALSE)),
        *((r"u\times v=-v\times u", TRUE), (r"u\times v=v\times u", FALSE)),
        *((r"u\cdot(u\times v)=0", TRUE), (r"u\cdot v=v\cdot v", FALSE)),
        *((r"u\cdot v=u^Tv", TRUE), (r"\det(AB)=|A||B|", TRUE), (r"\det(A+B)=|A|+|B|", FALSE)),
        # The dimension of a determinant.
        *((r"\det J=-h^2-m^2", TRUE), (r"\det J=-h-m", Verdict.ILL_FORMED)),
        (r"u\cdot v=\det(A)h-\det(A)h+v\cdot u", TRUE),
        (r"u\cdot v=|A|h", Verdict.ILL_FORMED),
    ],
)
def test_a_print_is_judged_as_it_is_meant(latex: str, verdict: Verdict) -> None:
    assert judge_print(latex) == [verdict]


@pytest.mark.parametrize(
    ("residual", "verdict"),
    [(x**2 - y, TRUE), (y - x**2, TRUE), (x**2 + y, FALSE), (y - 2 * x**2, FALSE)],
)
def test_a_residual_has_either_sign(residual: sp.Expr, verdict: Verdict) -> None:
    assert judge_print("x^2=y", residual=residual) == [verdict]


def test_a_matrix_of_which_nothing_is_known_agrees_with_nothing() -> None:
    for latex in ("A=B", "A=2B", r"\det A=1", r"u\cdot v=0"):
        with pytest.raises(ValueError, match="nothing is known about"):
            judge_print(latex)
