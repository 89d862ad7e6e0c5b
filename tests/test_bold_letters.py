"""Single equations: vectors and matrices recognised by their letters."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

PROVED, REFUTED, DEFINITION = Verdict.PROVED, Verdict.REFUTED, Verdict.DEFINITION
_A, _B, _C = (rf"\mathbf {letter}" for letter in "abc")
_M, _N = r"\mathbf A", r"\mathbf B"
ROWS = [
    (rf"{_A}\times({_B}\times{_C})={_B}({_A}\cdot{_C})-{_C}({_A}\cdot{_B})", PROVED),
    (rf"{_A}\times({_B}\times{_C})={_C}({_A}\cdot{_B})-{_B}({_A}\cdot{_C})", REFUTED),
    (r"\vec a\cdot(\vec b\times\vec c)=\vec c\cdot(\vec a\times\vec b)", PROVED),
    (r"\vec a\cdot(\vec b\times\vec c)=\vec a\cdot(\vec c\times\vec b)", REFUTED),
    (rf"{_A}\times{_A}=0", PROVED),
    (rf"{_A}+\mathbf 0={_A}", PROVED),
    (rf"{_A}+\mathbf 0=2{_A}", REFUTED),
    (rf"({_M}{_N})^T={_N}^T{_M}^T", PROVED),
    (rf"({_M}{_N})^T={_M}^T{_N}^T", REFUTED),
    (rf"({_M}{_N})^{{-1}}={_N}^{{-1}}{_M}^{{-1}}", PROVED),
    (rf"\det({_M}{_N})=\det{_M}\det{_N}", PROVED),
    (rf"{_M}{_N}={_N}{_M}", REFUTED),
    (rf"{_M}\mathbf x\cdot\mathbf y=\mathbf x\cdot{_M}^T\mathbf y", PROVED),
    # A letter that is alone on one side and absent from the other is being defined.
    (r"\mathbf v=\boldsymbol\omega\times\mathbf r", DEFINITION),
    (r"\mathbf F=m\mathbf a", DEFINITION),
    (r"\vec r_{AB}+\vec r_{BC}=\vec r_{AC}", DEFINITION),
    (rf"{_A}=2{_A}", REFUTED),
    # Letters that depend on time appear together with their derivatives.
    (rf"\frac d{{dt}}({_A}\cdot{_B})=\dot{{{_A}}}\cdot{_B}+{_A}\cdot\dot{{{_B}}}", PROVED),
    (rf"\frac d{{dt}}({_A}\cdot{_B})=\dot{{{_A}}}\cdot\dot{{{_B}}}", REFUTED),
    (rf"\frac d{{dt}}({_A}\times{_B})=\dot{{{_A}}}\times{_B}+{_A}\times\dot{{{_B}}}", PROVED),
    (rf"\frac d{{dt}}({_A}\times{_B})=\dot{{{_A}}}\times{_B}+\dot{{{_B}}}\times{_A}", REFUTED),
    (rf"\frac d{{dt}}({_A}\cdot{_C})=\dot{{{_A}}}\cdot{_C}", PROVED),
    (r"\frac d{dt}|\vec r|=\frac{\vec r\cdot\dot{\vec r}}{|\vec r|}", PROVED),
    (r"\frac d{dt}|\vec r|=|\dot{\vec r}|", REFUTED),
    (r"\frac d{dt}(m\vec r\times\dot{\vec r})=m\vec r\times\ddot{\vec r}", PROVED),
    (r"\frac d{dt}(m\vec r\times\dot{\vec r})=m\dot{\vec r}\times\ddot{\vec r}", REFUTED),
    (r"\frac d{dt}(x\vec r)=\dot x\vec r+x\dot{\vec r}", PROVED),
    (
        r"\frac d{dt}(\vec r_1\cdot\vec s)=\dot{\vec r}_1\cdot\vec s+\vec r_1\cdot\dot{\vec s}",
        PROVED,
    ),
    (
        r"\frac d{dt}(\vec r_1\cdot\vec s)=\dot{\vec r}_1\cdot\vec s-\vec r_1\cdot\dot{\vec s}",
        REFUTED,
    ),
    (rf"\frac d{{dt}}({_M}\mathbf x)=\dot{{{_M}}}\mathbf x+{_M}\dot{{\mathbf x}}", PROVED),
    (rf"\frac d{{dt}}({_M}^{{-1}})=-\dot{{{_M}}}", REFUTED),
    (r"\vec r\cdot\dot{\vec r}=0", REFUTED),
]
REFUSED = [
    (rf"{_A}+1={_A}", "do not fit"),
    (r"\vec F\cdot\vec s=Fs\cos\alpha", "its length"),
    (r"\mathbf d\cdot\mathbf d=d^2", "its length"),
    (rf"{_A}\cdot{_B}=a_xb_x+a_yb_y+a_zb_z", "a component of it"),
    (r"\mathbf r\cdot\mathbf r=x^2+y^2+z^2", "its components"),
    (r"(\mathbf{AB})^{-1}=\mathbf B^{-1}\mathbf A^{-1}", "a product"),
    (r"\mathbf I\mathbf A=\mathbf A", "unit vector or matrix"),
    (r"\vec e_x\cdot\vec e_y=0", "unit vector or matrix"),
    (r"\hat{\mathbf n}\cdot\hat{\mathbf n}=1", "unit vector or matrix"),
    (rf"{_A}\cdot{_B}={_B}\times{_A}", "differ in size"),
    (rf"\frac d{{dt}}({_A}\cdot{_B})=\dot{{{_A}}}\cdot{_B}", r"\\mathbf b may depend on t"),
    (r"\frac d{dt}(x\vec r)=x\dot{\vec r}", "x may depend on t"),
    (r"\frac d{dx}(x\vec r)=x\dot{\vec r}", "next to a derivative by x"),
    (r"\int_0^T\dot{\vec r}\,dt=T\dot{\vec r}", "that is not evaluated"),
    (r"\mathbf x=\begin{pmatrix}1\\2\end{pmatrix}", "differ in size"),
    ("[A][B]=[B][A]", r"print it bold, \\mathbf A"),
    ("(A-I)(A+I)^{-1}=(A+I)^{-1}(A-I)", "may be a matrix"),
]


@pytest.mark.parametrize(("latex", "verdict"), ROWS)
def test_vectors_and_matrices_are_compared_entry_by_entry(latex: str, verdict: Verdict) -> None:
    (judgement,) = judge_pasted(Pasted(latex)).judgements
    assert judgement.verdict is verdict


@pytest.mark.parametrize(("latex", "words"), REFUSED)
def test_what_may_be_a_part_of_a_vector_is_asked(latex: str, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        judge_pasted(Pasted(latex))


def test_a_letter_in_square_brackets_may_be_said_to_be_a_number() -> None:
    (judgement,) = judge_pasted(Pasted("[A][B]=[B][A]", names=("A", "B"))).judgements
    assert judgement.verdict is PROVED


def test_a_letter_that_is_bold_only_is_told_as_that() -> None:
    assert {*judge_pasted(Pasted(r"\mathbf d\times\mathbf d=0")).taken} == {r"\mathbf d"}


def test_a_named_letter_is_a_number() -> None:
    names = (r"\mathbf a", r"\mathbf b")
    (judgement,) = judge_pasted(Pasted(rf"{_A}{_B}={_B}{_A}", names=names)).judgements
    assert judgement.verdict is PROVED
    (judgement,) = judge_pasted(
        Pasted(r"\mathbf I+\mathbf I=2I", names=(r"\mathbf{I}",))
    ).judgements
    assert judgement.verdict is REFUTED
