"""Whole numbers at which a divisor is zero: what holds for all others may be false there."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# True for counts n and m under the given condition, and not proved without it.
ROWS = [
    (r"\int_0^\pi\cos((m-n)x)\,dx=0", r"m\ne n"),
    (r"\int_0^\pi\cos((m-n)x)\,dx=0", "m>n"),
    (r"\int_0^\pi\cos((n-17)x)\,dx=0", "n>17"),
    (r"\int_0^\pi\sin(mx)\sin(nx)\,dx=0", r"m\ne n"),
    (r"\int_{-\pi}^\pi\cos mx\cos nx\,dx=0", "m>n"),
    (r"\int_0^\pi\sin(nx)\sin x\,dx=0", "n>1"),
    (r"\int_0^{2\pi}\cos((n^2-49)x)\,dx=0", "n<7"),
    (r"\int_0^{2\pi}\sin^2((n-1)x)\,dx=\pi", r"n\ge2"),
    (r"\int_0^1\mathrm e^{(n-1)x}\,dx=\frac{\mathrm e^{n-1}-1}{n-1}", r"n\ge2"),
    (r"\int_0^1n^x\,dx=\frac{n-1}{\ln n}", "n>1"),
    (r"\int x^{n-18}\,dx=\frac{x^{n-17}}{n-17}+C", "n>17"),
    (r"\sum_{k=1}^nm^k=\frac{m^{n+1}-m}{m-1}", "m>1"),
    (r"\frac{4^n-2^{100}}{2^n-2^{50}}=2^n+2^{50}", "n<50"),
    (r"\frac{2^{n+3}-2^{50}}{2^{n+3}-2^{50}}=1", "n<47"),
    (r"\tan\frac{n\pi}{1000}\cos\frac{n\pi}{1000}=\sin\frac{n\pi}{1000}", "n<500"),
    (r"\frac{\sin\frac{n\pi}{500}}{\sin\frac{n\pi}{1000}}=2\cos\frac{n\pi}{1000}", "n<1000"),
]
# True for all counts from 1 onwards, but not for 0.
FROM_ONE = [
    r"\int_0^\pi\cos(nx)\,dx=0",
    r"\int_0^{2\pi}\sin^2(nx)\,dx=\pi",
    r"n\cdot(n-1)!=n!",
    r"\int_0^\pi\sin(nx)\,dx=\frac{1-(-1)^n}n",
]


def judge(latex: str, *where: str) -> Verdict:
    letters = tuple(letter for letter in "mn" if letter in latex.replace(r"\binom", ""))
    (judgement,) = judge_pasted(Pasted(latex, where=where, natural=letters)).judgements
    return judgement.verdict


@pytest.mark.parametrize(("latex", "needed"), ROWS)
def test_a_zero_of_a_divisor_of_counts_must_be_left_out(latex: str, needed: str) -> None:
    assert judge(latex, needed) is Verdict.PROVED
    assert judge(latex) in (Verdict.UNDECIDED, Verdict.REFUTED)


@pytest.mark.parametrize("latex", FROM_ONE)
def test_what_holds_from_one_on_is_not_proved_from_zero_on(latex: str) -> None:
    assert judge(latex) is Verdict.PROVED
    assert judge(latex, r"n\ge0") in (Verdict.UNDECIDED, Verdict.REFUTED)


@pytest.mark.parametrize("steps", [r"\lfloor a\rfloor", r"\lceil a\rceil-7", r"\sgn a"])
def test_a_number_that_jumps_is_no_number_that_runs(steps: str) -> None:
    printed = steps.replace(r"\sgn", r"\operatorname{sgn}")
    latex = rf"\int_0^{{2\pi}}\cos\left(\left({printed}\right)x\right)\,dx=0"
    (judgement,) = judge_pasted(Pasted(latex)).judgements
    assert judgement.verdict is not Verdict.PROVED


def test_a_parameter_that_runs_may_be_divided_by() -> None:
    assert judge(r"\int_0^1\mathrm e^{ax}\,dx=\frac{\mathrm e^a-1}a") is Verdict.PROVED


@pytest.mark.parametrize(
    ("binomial", "value"),
    [(r"\binom25", "0"), (r"\binom n{n-1}", "n"), (r"\binom n2", r"\frac{n(n-1)}2")],
)
def test_a_binomial_over_a_number_is_a_polynomial(binomial: str, value: str) -> None:
    assert judge(f"{binomial}={value}") is Verdict.PROVED
    assert judge(f"{binomial}={value}+1") is Verdict.REFUTED


@pytest.mark.parametrize(
    ("latex", "where", "said"),
    [
        (r"\frac{n!}{(n-1)!}=n", (r"n\ge0",), "1/factorial(n - 1) is zero at n = 0"),
        (r"\frac{n!}{(n-2)!}=n(n-1)", (), "1/factorial(n - 2) is zero at n = 1"),
        (
            r"\begin{pmatrix}a&1\\0&a\end{pmatrix}^n="
            r"\begin{pmatrix}a^n&na^{n-1}\\0&a^n\end{pmatrix}",
            (r"n\ge0",),
            "For the first number, 1/a must have a value.",
        ),
    ],
)
def test_it_is_said_where_a_quotient_is_no_number_or_zero(
    latex: str, where: tuple[str, ...], said: str
) -> None:
    (judgement,) = judge_pasted(Pasted(latex, where=where, natural=("n",))).judgements
    assert judgement.verdict is Verdict.PROVED
    assert said in judgement.reason


@pytest.mark.parametrize("latex", [r"\frac{n!}{(n-1)!}=n", r"\frac{(n+2)!}{n!}=(n+1)(n+2)"])
def test_where_a_quotient_has_a_value_nothing_is_said(latex: str) -> None:
    (judgement,) = judge_pasted(Pasted(latex, natural=("n",))).judgements
    assert judgement.reason == "both sides agree wherever they are defined"
