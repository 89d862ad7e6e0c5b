r"""Exponentials of matrices: e^{\hat\omega\theta}, \exp(At)."""

from __future__ import annotations

import pytest
import sympy as sp
from flint import arb, arb_mat, fmpq

from mechproof.document.checking import check
from mechproof.latex import ReadingError
from mechproof.latex.matrix_exponentials import exponentiate
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

a, b, c, t, w = sp.symbols("a b c t w", real=True)
TURN = sp.Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])
PLANE = sp.Matrix([[0, -1], [1, 0]])
TWIST = sp.zeros(4, 4).as_mutable()
TWIST[:3, :3], TWIST[:3, 3] = TURN, sp.Matrix([a, w, 1])
WORKED_OUT = [
    TURN * t,
    TWIST * t,
    PLANE * t,
    PLANE * t / 2,
    sp.Matrix([[0, 1], [-(w**2), 0]]) * t,
    sp.Matrix([[0, 1], [w**2, 0]]) * t,
    sp.Matrix([[0, 1], [-2, -3]]) * t,
    sp.Matrix([[0, 1], [-5, -2]]) * t,
    sp.Matrix([[a, 1], [0, a]]) * t,
    sp.Matrix([[a, b], [0, c]]),
    sp.Matrix([[0, 1, a], [0, 0, 1], [0, 0, 0]]) * t,
    sp.Matrix([[1, 2, 0], [0, 2, 1], [0, 0, 3]]) * t,
    sp.diag(a, b, c) * t,
    # At the numbers below these turn.
    sp.Matrix([[0, 1], [-b / a, 0]]) * t,
    sp.Matrix([[0, 1], [-c, -a]]) * t,
    sp.zeros(2, 2),
]
ROTATION = r"\begin{pmatrix}\cos t&-\sin t\\\sin t&\cos t\end{pmatrix}"
GENERATOR = r"\begin{pmatrix}0&-1\\1&0\end{pmatrix}"
LETTERS = r"""%% mechproof
%% \omega_1 ; \omega_2 ; \omega_3 : components of the axis [1]
%% \theta : angle [rad]
%% \hat\omega 3x3 : matrix of the axis
%% R 3x3 : rotation
%% C 3x3 : matrix
%% e : Euler's number
%% I 3x3 : unit matrix
%% let I=\begin{pmatrix}1&0&0\\0&1&0\\0&0&1\end{pmatrix}
%% end
"""
AXIS = (
    r"\hat\omega=\begin{bmatrix}0&-\omega_3&\omega_2\\\omega_3&0&-\omega_1\\"
    r"-\omega_2&\omega_1&0\end{bmatrix}"
)
UNIT = r"\omega_1^2+\omega_2^2+\omega_3^2=1"
DEFINED = r"R=e^{\hat\omega\theta}"
RODRIGUES = r"R=I+\hat\omega\sin\theta+\hat\omega^2(1-\cos\theta)"
MISPRINT = RODRIGUES.replace(r"1-\cos", r"1+\cos")


def judge_rows(*prints: str) -> list[tuple[str, str]]:
    text = LETTERS + "\n".join(rf"\begin{{equation}}{x}\end{{equation}}" for x in prints)
    return [(row.outcome, row.reason) for row in check("paper.tex", text).rows]


def judge(latex: str, *values: str) -> Verdict:
    (found,) = judge_pasted(Pasted(latex, values=values)).judgements
    return found.verdict


@pytest.mark.parametrize("matrix", WORKED_OUT, ids=str)
def test_an_exponential_is_that_of_balls(matrix: sp.Matrix) -> None:
    found = exponentiate(matrix)
    assert found is not None
    letters = sorted(matrix.free_symbols, key=str)
    place = {letter: sp.Rational(3 * n + 2, 7) for n, letter in enumerate(letters)}
    numbers = matrix.subs(place).tolist()
    balls = arb_mat([[arb(fmpq(int(x.p), int(x.q))) for x in row] for row in numbers]).exp()
    for row in range(matrix.rows):
        for column in range(matrix.cols):
            value = arb(str(found[row, column].subs(place).evalf(30)))
            assert abs(balls[row, column] - value) < 1e-10


def test_what_may_turn_or_not_has_a_value_where_it_turns() -> None:
    def compare(root: str, sign: str = "-") -> Verdict:
        turned = (
            rf"\cos({root}t)&\frac1{{{root}}}\sin({root}t)\\{sign}{root}\sin({root}t)&\cos({root}t)"
        )
        matrices = (rf"\begin{{pmatrix}}{x}\end{{pmatrix}}" for x in (r"0&t\\-at&0", turned))
        return judge(r"\exp{}={}".format(*matrices))

    assert compare(r"\sqrt a") is Verdict.PROVED
    assert compare(r"\sqrt a", "") is Verdict.REFUTED
    # Where a is negative, the exponential has another form.
    assert compare(r"\sqrt{|a|}") is Verdict.UNDECIDED


def test_larger_matrices_of_letters_are_not_worked_out() -> None:
    assert exponentiate(sp.Matrix([[a, b, c], [b, a, 1], [1, c, w]]) * t) is None


@pytest.mark.parametrize(
    ("latex", "values"),
    [
        (rf"e^{{{GENERATOR}t}}={ROTATION}", ()),
        (rf"\exp(t{GENERATOR})={ROTATION}", ()),
        (rf"\exp(At)={ROTATION}", (f"A={GENERATOR}",)),
        (
            rf"e^{{At}}e^{{Bt}}=\begin{{pmatrix}}1&t\\0&1\end{{pmatrix}}{ROTATION}",
            (r"A=\begin{pmatrix}0&1\\0&0\end{pmatrix}", f"B={GENERATOR}"),
        ),
    ],
)
def test_the_exponential_of_a_matrix_is_read(latex: str, values: tuple[str, ...]) -> None:
    assert judge(latex, *values) is Verdict.PROVED
    wrong = latex.replace(r"-\sin t\\\sin t", r"\sin t\\\sin t")
    assert judge(wrong, *values) is Verdict.REFUTED


def test_the_exponential_of_a_sum_is_no_product_where_matrices_do_not_commute() -> None:
    values = r"A=\begin{pmatrix}0&1\\0&0\end{pmatrix}", r"B=\begin{pmatrix}0&0\\1&0\end{pmatrix}"
    assert judge(r"\exp(A+B)=\exp(A)\exp(B)", *values) is Verdict.REFUTED


@pytest.mark.parametrize(
    "latex",
    [
        r"e^{\hat\omega\theta}=I+\hat\omega\sin\theta+\hat\omega^2(1-\cos\theta)",
        "e^{At}=I+At",
        r"\exp\left(At\right)=E+At+\frac12A^2t^2",
    ],
)
def test_what_may_be_a_matrix_in_an_exponent_is_asked_for(latex: str) -> None:
    with pytest.raises(ValueError, match="may be a matrix"):
        judge(latex)
    assert judge(latex.replace("I", "1").replace("E", "1")) is Verdict.REFUTED


@pytest.mark.parametrize("base", ["2", "a"])
def test_no_other_number_is_raised_to_a_matrix(base: str) -> None:
    with pytest.raises(ReadingError):
        judge(rf"{base}^{{{GENERATOR}t}}={ROTATION}")


@pytest.mark.slow
def test_rodrigues_follows_from_the_length_of_the_axis() -> None:
    rows = judge_rows(AXIS, UNIT, DEFINED, RODRIGUES)
    assert rows[-1][0] == "PROVED"
    assert "(2)" in rows[-1][1]
    assert judge_rows(AXIS, UNIT, DEFINED, MISPRINT)[-1][0] != "PROVED"


@pytest.mark.slow
def test_a_length_that_is_said_in_words_only_is_asked_for() -> None:
    outcome, reason = judge_rows(AXIS, DEFINED, RODRIGUES)[-1]
    assert outcome == "not judged"
    assert reason.startswith(r"it holds where \omega_{1}^{2}")
    assert judge_rows(AXIS, DEFINED, MISPRINT)[-1][0] == "REFUTED"


@pytest.mark.slow
def test_a_matrix_without_entries_has_no_exponential() -> None:
    outcome, reason = judge_rows(r"e^{C\theta}=\begin{pmatrix}1&0&0\\0&1&0\\0&0&1\end{pmatrix}")[0]
    assert outcome == "not read"
    assert "entries of C" in reason
