"""Divisors that SymPy cancels while a print is read: a quotient of zeros has no value."""

from __future__ import annotations

from contextlib import suppress

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# Each is true for free letters and has no value at the given one.
GIVEN = [
    (r"\frac{a-b}{a-b}=1", "a=b"),
    (r"\frac{(a+b)(a-b)}{a-b}=a+b", "a=b"),
    (r"\frac1x-\frac1x=0", "x=0"),
    (r"\frac{x^2}x=x", "x=0"),
    (r"0\cdot\frac1x=0", "x=0"),
    (r"1^{1/x}=1", "x=0"),
    ("x^0=1", "x=0"),
    (r"\frac xx\ge1", "x=0"),
    (r"\frac{x-1}{x-1}=1", "x=1"),
    (r"\tan x-\tan x=0", r"x=\frac\pi2"),
    (r"\frac{\sin x}{\sin x}=1", r"x=\pi"),
]
# These have no value anywhere, on an interval, or at a whole number.
NEVER = [
    (r"\frac{\sin^2x+\cos^2x-1}{\sin^2x+\cos^2x-1}=1", ""),
    (r"\frac{|x|-x}{|x|-x}=1", ""),
    (r"\frac{\sqrt{x^2}-x}{\sqrt{x^2}-x}=1", "x>0"),
    (r"\frac{\lfloor x\rfloor}{\lfloor x\rfloor}=1", ""),
    (r"\frac{x-1}{x-1}=1", r"x\ge1, x\le1"),
    (r"\frac{x-y}{x-y}=1", r"x\le y, y\le x"),
    (r"x=1\Rightarrow\frac{x-1}{x-1}=1", ""),
    (r"\frac{1+(-1)^n}{1+(-1)^n}=1", ""),
    (r"\frac{n-7}{n-7}=1", ""),
    (r"\frac{(n^2-49)x}{n^2-49}=x", ""),
]
# The same under a binding operator, and for a matrix without an inverse.
NEVER += [
    (rf"{binding}\frac{{\sin^2x+\cos^2x-1}}{{\sin^2x+\cos^2x-1}}{rest}", "")
    for binding, rest in [
        (r"\lim_{x\to0}", "=1"),
        (r"\int_0^1", r"\,dx=1"),
        (r"\frac d{dx}", "=0"),
    ]
]
NEVER += [(r"\frac{\int_0^1x\,dx-\frac12}{\int_0^1x\,dx-\frac12}=1", "")]
_DIAGONAL = r"\begin{pmatrix}x&0\\0&1\end{pmatrix}"
_UNITY = r"\begin{pmatrix}1&0\\0&1\end{pmatrix}"
GIVEN += [
    (r"\int_0^1\frac xx\,dt=1", "x=0"),
    (rf"{_DIAGONAL}{_DIAGONAL}^{{-1}}={_UNITY}", "x=0"),
]
# For whole numbers n: SymPy 1.14 evaluates the first two tangents to 0, the third to \tan x.
TANGENTS = [
    (r"\tan\left(n\pi+\frac\pi2\right)=0", ""),
    (r"\lim_{x\to n\pi+\frac\pi2}\tan x=0", ""),
    (r"\tan\left(n\pi+\frac\pi2+x\right)=\tan x", ""),
    (r"\tan x=0", r"x=n\pi+\frac\pi2"),
    (r"\left.\tan x\right|_{x=n\pi+\frac\pi2}=0", ""),
    (r"\sum_{k=1}^n\tan\left(k\pi+\frac\pi2\right)=0", ""),
    (r"\cot\left(n\pi\right)-\cot\left(n\pi\right)=0", ""),
]
# A sum keeps the conditions of divisors cancelled in its terms, however the division is written.
SUMS = [r"\sum_{n=1}^5\frac{n-3}{n-3}=5", r"\sum_{n=1}^5(n-3)(n-3)^{-1}=5"]


def judge(latex: str, value: str = "", where: str = "") -> Verdict:
    stated = tuple(filter(None, where.split(", ")))
    natural = ("n",) if "n-" in latex or "^n" in latex or "n^" in latex else ()
    values = (value,) if value else ()
    pasted = Pasted(latex, values=values, where=stated, natural=natural)
    (judgement,) = judge_pasted(pasted).judgements
    return judgement.verdict


@pytest.mark.parametrize(("latex", "value"), GIVEN)
def test_a_letter_that_makes_a_cancelled_divisor_zero_leaves_no_value(
    latex: str, value: str
) -> None:
    assert judge(latex) is Verdict.PROVED
    assert judge(latex, value) is Verdict.UNDECIDED


@pytest.mark.parametrize(("latex", "where"), NEVER)
def test_a_quotient_of_zeros_is_not_one(latex: str, where: str) -> None:
    assert judge(latex, where=where) is Verdict.UNDECIDED


@pytest.mark.parametrize(("latex", "value"), TANGENTS)
def test_a_tangent_at_its_pole_has_no_value(latex: str, value: str) -> None:
    pasted = Pasted(latex, values=(value,) if value else (), natural=("n",))
    verdicts = []
    with suppress(ReadingError):
        verdicts = [judgement.verdict for judgement in judge_pasted(pasted).judgements]
    assert {*verdicts} <= {Verdict.UNDECIDED, Verdict.REFUTED}


def test_whole_turns_leave_a_tangent_as_it_is() -> None:
    for latex in (r"\tan(n\pi+x)=\tan x", r"\tan\left(n\pi+\frac\pi2+x\right)=-\cot x"):
        (judgement,) = judge_pasted(Pasted(latex, natural=("n",))).judgements
        assert judgement.verdict is Verdict.PROVED


@pytest.mark.parametrize("latex", SUMS)
def test_a_term_of_a_sum_needs_its_value(latex: str) -> None:
    pasted = Pasted(latex)
    (judgement,) = judge_pasted(pasted).judgements
    assert judgement.verdict is Verdict.UNDECIDED


def test_a_value_where_a_cancelled_divisor_is_zero_is_refused() -> None:
    with pytest.raises(ReadingError, match="divides by zero there"):
        judge_pasted(Pasted(r"\left.\frac xx\right|_{x=0}=1"))


@pytest.mark.parametrize("latex", [r"\frac{x^2-1}{x-1}=x+1", r"\frac{x-\frac34}{x-\frac34}=1"])
def test_single_places_without_a_value_are_left_out(latex: str) -> None:
    assert judge(latex) is Verdict.PROVED


# A zero of a cancelled divisor is no counterexample, though the left side has its step there.
HOLES = [
    (r"\operatorname{sgn}(x)^2=\frac xx", Verdict.PROVED),
    (r"\operatorname{sgn}x=\frac xx", Verdict.REFUTED),
    (r"\operatorname{sgn}(x^2)=\frac{x^2}{|x^2|}", Verdict.PROVED),
    (r"\operatorname{sgn}(x-y)^2=\frac{x-y}{x-y}", Verdict.PROVED),
    (r"\operatorname{sgn}(x-y)=\frac{x-y}{x-y}", Verdict.REFUTED),
    (r"\frac xx=\begin{cases}1&x\ne0\\0&x=0\end{cases}", Verdict.PROVED),
    (r"\frac xx=\begin{cases}1&x\ne1\\0&x=1\end{cases}", Verdict.REFUTED),
    (r"\operatorname{sgn}(x)^2\ge\frac xx", Verdict.PROVED),
    (r"\operatorname{sgn}(x)^2>\frac xx", Verdict.REFUTED),
]


@pytest.mark.parametrize(("latex", "verdict"), HOLES)
def test_a_zero_of_what_is_cancelled_refutes_nothing(latex: str, verdict: Verdict) -> None:
    assert judge(latex) is verdict


def test_a_quotient_of_zeros_differs_from_nothing() -> None:
    assert judge(r"\frac{a-b}{a-b}=2", where="a=b") is Verdict.UNDECIDED


ENDLESS = [
    (r"\lim_{x\to\infty}\mathrm e^x=\infty", Verdict.PROVED),
    (r"\lim_{x\to-\infty}\mathrm e^x=\infty", Verdict.REFUTED),
    (r"\lim_{x\to-\infty}x^3=\infty", Verdict.REFUTED),
    (r"\lim_{x\to0}\frac1{x^2}=\infty", Verdict.PROVED),
    (r"\lim_{x\to0}\frac1{x^2}=1", Verdict.REFUTED),
    # The one-sided limits differ; inside a formula infinity is not a number.
    (r"\lim_{x\to0}\frac1x=\infty", Verdict.UNDECIDED),
    (r"\lim_{x\to\infty}x-\lim_{x\to\infty}x=0", Verdict.UNDECIDED),
    (r"\lim_{x\to\infty}x=1+\lim_{x\to\infty}x", Verdict.UNDECIDED),
]


@pytest.mark.parametrize(("latex", "verdict"), ENDLESS)
def test_infinity_is_no_other_value(latex: str, verdict: Verdict) -> None:
    assert judge(latex) is verdict


def test_a_side_without_a_value_is_told() -> None:
    (judgement,) = judge_pasted(Pasted(r"\frac{x^2-1}{x-1}=x+1", values=("x=1",))).judgements
    assert judgement.verdict is Verdict.UNDECIDED
    assert judgement.reason == "a side has no value for the given letters"
