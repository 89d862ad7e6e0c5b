"""Sums whose terms contain the count, products, and powers of a count: no twin is accepted."""

from __future__ import annotations

import pytest
import sympy as sp
from twins import check_twins, judge, list_rows

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof import endless_sums, induction, telescoping
from mechproof.proof.powers import split_powers
from mechproof.proof.verdict import Verdict
from mechproof.statement_domains.domain import Domain

x = sp.Symbol("x", real=True)
n = sp.Symbol("n", integer=True, positive=True)
k = sp.Symbol("k", integer=True)
DOMAIN = Domain({n: sp.S.Naturals}, (), {})
CHOOSE = sp.factorial(n) / sp.factorial(k) / sp.factorial(n - k)
TABLES = {
    telescoping.RUNG: (
        (r"\sum_{k=0}^n\frac{n!}{k!(n-k)!}=2^n", r"\sum_{k=0}^n\frac{n!}{k!(n-k)!}=2^n+n-1", ""),
        (r"\sum_{k=0}^n\binom nkx^k=(1+x)^n", r"\sum_{k=0}^n\binom nkx^k=(1+x)^{n-1}", ""),
        (
            r"\sum_{k=0}^n(-1)^k\frac{n!}{k!(n-k)!}=0",
            r"\sum_{k=1}^n(-1)^k\frac{n!}{k!(n-k)!}=0",
            "",
        ),
        (
            r"\sum_{k=0}^n\frac{n!}{k!(n-k)!}a^kb^{n-k}=(a+b)^n",
            r"\sum_{k=0}^n\frac{n!}{k!(n-k)!}a^kb^{n-k}=(a-b)^n",
            "",
        ),
        (r"\sum_{k=1}^nk\binom nk=n\cdot2^{n-1}", r"\sum_{k=1}^nk\binom nk=n\cdot2^n-n", ""),
        (r"\sum_{k=0}^nk\binom nk=n\cdot2^{n-1}", r"\sum_{k=0}^nk\binom nk=n\cdot2^{n-1}+n-1", ""),
        (
            r"\sum_{k=0}^nk^2\binom nk=n(n+1)2^{n-2}",
            r"\sum_{k=0}^nk^2\binom nk=n(n+1)2^{n-2}+n-1",
            "",
        ),
        (
            r"\sum_{k=0}^nk^3\binom nk=n^2(n+3)2^{n-3}",
            r"\sum_{k=0}^nk^3\binom nk=n(n+3)2^{n-2}",
            "",
        ),
        (
            r"\sum_{k=0}^n\frac{(-1)^k}{k+1}\binom nk=\frac1{n+1}",
            r"\sum_{k=0}^n\frac{(-1)^k}{k+1}\binom nk=\frac1{2n}",
            "",
        ),
        (r"\sum_{k=0}^n\binom nk^2=\binom{2n}n", r"\sum_{k=0}^n\binom nk^2=\binom{2n}n+n-1", ""),
        (
            r"\sum_{k=0}^nk\binom nk^2=\frac n2\binom{2n}n",
            r"\sum_{k=0}^nk\binom nk^2=\frac12\binom{2n}n",
            "",
        ),
        (
            r"\sum_{k=0}^n\binom{2k}k\binom{2n-2k}{n-k}=4^n",
            r"\sum_{k=0}^n\binom{2k}k\binom{2n-2k}{n-k}=2^{n+1}",
            "",
        ),
        (
            r"\sum_{k=0}^nk(k-1)\binom nk=n(n-1)2^{n-2}",
            r"\sum_{k=0}^nk(k-1)\binom nk=n(n-1)2^{n-2}+\frac{(n-1)(n-2)}{10^{30}}",
            "",
        ),
        (
            r"\sum_{k=2}^nk(k-1)\binom nk=n(n-1)2^{n-2}",
            r"\sum_{k=3}^nk(k-1)\binom nk=n(n-1)2^{n-2}",
            "",
        ),
        (
            r"\sum_{k=0}^n\frac1{k+1}\binom nk=\frac{2^{n+1}-1}{n+1}",
            r"\sum_{k=0}^n\frac1{k+1}\binom nk=\frac{2^{n+1}}{n+1}-\frac12",
            "",
        ),
        (
            r"\sum_{k=0}^n(-1)^kk^2\binom nk=0",
            r"\sum_{k=0}^n(-1)^kk^3\binom nk=0",
            "n>2",
        ),
        (
            r"\sum_{k=0}^r\binom mk\binom n{r-k}=\binom{m+n}r",
            r"\sum_{k=0}^r\binom mk\binom n{r-k}=\binom{m+n}r+\binom r{m+n}",
            "",
        ),
        (
            r"\sum_{k=0}^nk^2\binom nkp^k(1-p)^{n-k}=np(1-p)+n^2p^2",
            r"\sum_{k=0}^nk^2\binom nkp^k(1-p)^{n-k}=n^2p^2",
            "0<p<1",
        ),
    ),
    endless_sums.PARTIAL_SUMS: (
        (r"\sum_{k=1}^\infty\frac1{k(k+1)}=1", r"\sum_{k=1}^\infty\frac1{k(k-2)}=\frac34", ""),
        (r"\sum_{k=0}^\infty q^k=\frac1{1-q}", r"\sum_{k=1}^\infty q^k=\frac1{1-q}", "-1<q, q<1"),
        (
            r"\sum_{k=1}^\infty kq^k=\frac q{(1-q)^2}",
            r"\sum_{k=1}^\infty kq^k=\frac q{1-q}",
            "0<q, q<1",
        ),
        (
            r"\sum_{k=0}^\infty(-1)^kx^{2k}=\frac1{1+x^2}",
            r"\sum_{k=0}^\infty(-1)^k=\frac12",
            "-1<x, x<1",
        ),
        (
            r"\sum_{k=1}^\infty\frac k{(k+1)!}=1",
            r"\sum_{k=1}^\infty\frac{k-2}{(k+1)!}=1",
            "",
        ),
        (
            r"\sum_{k=0}^\infty\arctan\frac1{k^2+k+1}=\frac\pi2",
            r"\sum_{k=0}^\infty\arctan\frac1{k^2+k+1}=\pi",
            "",
        ),
        (
            r"\sum_{k=1}^\infty\arctan\frac2{k^2}=\frac{3\pi}4",
            r"\sum_{k=1}^\infty\arctan\frac2{k^2}=-\frac\pi4",
            "",
        ),
        (
            r"\sum_{k=2}^\infty\ln\left(1-\frac1{k^2}\right)=-\ln2",
            r"\sum_{k=2}^\infty\ln\left(1-\frac1{k^2}\right)=\ln2",
            "",
        ),
    ),
    endless_sums.KNOWN_SERIES: (
        (
            r"\sum_{k=0}^\infty\binom{n+k}kx^k=\frac1{(1-x)^{n+1}}",
            r"\sum_{k=0}^\infty\binom{n+k}kx^k=\frac1{(1-x)^n}",
            "-1<x, x<1",
        ),
        (
            r"\sum_{n=0}^\infty\frac{(2n)!}{4^nn!^2(2n+1)}x^{2n+1}=\arcsin x",
            r"\sum_{n=0}^\infty\frac{(2n)!}{4^nn!^2(2n+1)}x^{2n+1}=\operatorname{arsinh}x",
            "-1<x, x<1",
        ),
        (
            r"\sum_{n=0}^\infty\frac{(-1)^n(2n)!}{4^nn!^2(2n+1)}x^{2n+1}=\operatorname{arsinh}x",
            r"\sum_{n=0}^\infty\frac{(-1)^n(2n)!}{4^nn!^2(2n+1)}x^{2n+1}=\arcsin x",
            r"-1\le x, x\le1",
        ),
        (
            r"\sum_{k=0}^\infty\frac{k^2x^k}{k!}=(x+x^2)\mathrm{e}^x",
            r"\sum_{k=0}^\infty\frac{k^2x^k}{k!}=x^2\mathrm{e}^x",
            "",
        ),
        (
            r"\sum_{k=2}^\infty\frac{k^3-1}{k!}=4\mathrm e+1",
            r"\sum_{k=2}^\infty\frac{k^3-1}{k!}=4\mathrm e",
            "",
        ),
        (
            r"\sum_{n=0}^\infty\frac{x^n}{n!}=\mathrm{e}^x",
            r"\sum_{n=1}^\infty\frac{x^n}{n!}=\mathrm{e}^x",
            "",
        ),
        (
            r"\sum_{n=1}^\infty\frac{x^n}{n!}=\mathrm{e}^x-1",
            r"\sum_{n=1}^\infty\frac{x^n}{(n-1)!}=\mathrm{e}^x",
            "",
        ),
        (
            r"\sum_{n=3}^\infty\frac{x^n}{n!}=\mathrm{e}^x-1-x-\frac{x^2}2",
            r"\sum_{n=3}^\infty\frac{x^n}{n!}=\mathrm{e}^x-1-x-\frac{x^2}3",
            "",
        ),
        (
            r"\sum_{n=0}^\infty\frac{(-1)^nx^{2n}}{(2n)!}=\cos x",
            r"\sum_{n=0}^\infty\frac{(-1)^nx^{2n}}{(2n+1)!}=\cos x",
            "",
        ),
        (
            r"\sum_{n=0}^\infty\frac{(-1)^nx^{2n+1}}{(2n+1)!}=\sin x",
            r"\sum_{n=0}^\infty\frac{x^{2n+1}}{(2n+1)!}=\sin x",
            "",
        ),
        (
            r"\sum_{n=0}^\infty\frac{x^{2n}}{(2n)!}=\cosh x",
            r"\sum_{n=0}^\infty\frac{x^{2n}}{(2n)!}=\sinh x",
            "",
        ),
        (
            r"\sum_{n=1}^\infty\frac{x^n}n=-\ln(1-x)",
            r"\sum_{n=1}^\infty\frac{x^n}n=\ln(1-x)",
            "-1<x, x<1",
        ),
        (r"\sum_{n=1}^\infty\frac{(-1)^{n+1}}n=\ln2", r"\sum_{n=1}^\infty\frac1n=\ln2", ""),
        (
            r"\sum_{n=0}^\infty\frac{(-1)^nx^{2n+1}}{2n+1}=\arctan x",
            r"\sum_{n=0}^\infty\frac{(-1)^nx^{2n+1}}{2n+1}=\arctan x+10^{-20}",
            r"-1\le x, x\le1",
        ),
        (
            r"\sum_{n=0}^\infty(n+1)x^n=\frac1{(1-x)^2}",
            r"\sum_{n=0}^\infty(n+2)x^n=\frac1{(1-x)^2}",
            "-1<x, x<1",
        ),
        (
            r"\sum_{n=1}^\infty\frac1{n^2}=\frac{\pi^2}6",
            r"\sum_{n=1}^\infty\frac1{n^2}=\frac{\pi^2}7",
            "",
        ),
        (
            r"\sum_{n=2}^\infty\frac1{n^4}=\frac{\pi^4}{90}-1",
            r"\sum_{n=2}^\infty\frac1{n^4}=\frac{\pi^4}{90}",
            "",
        ),
        (
            r"\sum_{n=0}^\infty\frac1{(2n+1)^2}=\frac{\pi^2}8",
            r"\sum_{n=0}^\infty\frac{(-1)^n}{(2n+1)^2}=\frac{\pi^2}8",
            "",
        ),
    ),
    induction.RUNG: (
        (
            r"\sum_{k=m}^n\frac1{k(k+1)}=\frac1m-\frac1{n+1}",
            r"\sum_{k=m}^n\frac1{k(k+1)}=\frac1m-\frac1n",
            r"n\ge m",
        ),
        (
            r"\sum_{k=m}^nx^k=\frac{x^m-x^{n+1}}{1-x}",
            r"\sum_{k=m}^nx^k=\frac{x^m-x^n}{1-x}",
            r"n\ge m, x\ne1",
        ),
        (
            r"\sum_{k=r}^n\binom kr=\binom{n+1}{r+1}",
            r"\sum_{k=r}^n\binom kr=\binom{n+1}r",
            r"n\ge r",
        ),
        (
            r"\prod_{k=m}^n\frac{k+1}k=\frac{n+1}m",
            r"\prod_{k=m}^n\frac{k+1}k=\frac nm",
            r"n\ge m",
        ),
        (
            r"\sum_{i=1}^n\sum_{j=1}^ij=\frac{n(n+1)(n+2)}6",
            r"\sum_{i=1}^n\sum_{j=1}^ij=\frac{n(n+1)^2}4",
            "",
        ),
        (
            r"\prod_{k=2}^n\left(1-\frac1{k^2}\right)=\frac{n+1}{2n}",
            r"\prod_{k=2}^n\left(1-\frac1{k^2}\right)=\frac{n+1}{2n^2}",
            "",
        ),
        (
            r"\sum_{k=1}^n(-1)^kk^2=(-1)^n\frac{n(n+1)}2",
            r"\sum_{k=1}^n(-1)^kk^2=\frac{n(n+1)}2",
            "",
        ),
        (
            r"\sum_{k=1}^n\arctan\frac1{1+k+k^2}=\arctan(n+1)-\frac\pi4",
            r"\sum_{k=1}^n\arctan\frac1{1+k+k^2}=\arctan n",
            "",
        ),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("rung", "printed", "twin", "where"), list_rows(TABLES))
def test_a_sum_is_proved_and_its_neighbour_not_accepted(
    rung: str, printed: str, twin: str, where: str
) -> None:
    check_twins(rung, printed, twin, where)


@pytest.mark.parametrize(
    ("term", "first", "value"),
    [
        (CHOOSE, 0, 2**n + 1),
        (CHOOSE, 1, 2**n),
        (CHOOSE, 0, (n - 1) * 2**n),
        (CHOOSE * (-1) ** k, 0, sp.S.One),
        # It contains the factorial of -1 at k = n.
        (sp.factorial(n) / sp.factorial(k) / sp.factorial(n - k - 1), 0, n * 2 ** (n - 1)),
    ],
    ids=["another start", "a term less", "zero at the start", "never", "no factorial"],
)
def test_what_is_not_shown_to_telescope_is_left(term: sp.Expr, first: int, value: sp.Expr) -> None:
    total = sp.Sum(term, (k, first, n))
    assert telescoping.decide_by_telescoping(total, value, DOMAIN) is None


def test_a_sum_from_a_letter_is_told_that_it_has_to_go_up() -> None:
    (judgement,) = judge_pasted(Pasted(r"\sum_{k=m}^nk=\frac{(n+m)(n-m+1)}2")).judgements
    assert judgement.verdict is Verdict.UNDECIDED
    assert judgement.reason == "both sides agree where m <= n, which is not stated"


def test_a_factor_that_is_zero_for_a_count_hides_no_product() -> None:
    product = sp.Product(k, (k, 1, n))
    wrong = 2 * (n - 1) * sp.factorial(n)
    assert induction.decide_by_induction((n - 1) * product, wrong, DOMAIN) is None
    hidden = (x - sp.Abs(x)) * product
    wrong = (x - sp.Abs(x)) * sp.factorial(n) + (n - 1) * (x + sp.Abs(x))
    assert induction.decide_by_induction(hidden, wrong, DOMAIN) is None


def test_powers_are_split_by_their_exponents() -> None:
    y = sp.Symbol("y", real=True)
    assert sp.simplify(split_powers(x ** (n + 1) - x * x**n)) == 0
    assert sp.simplify(split_powers(4**n - (2**n) ** 2)) == 0
    assert sp.simplify(split_powers((-x) ** n - (-1) ** n * x**n)) == 0
    assert sp.simplify(split_powers((-1) ** n - 1)) != 0
    assert sp.simplify(split_powers(x ** (y + 1) - x * x**y)) == 0
    assert sp.simplify(split_powers(x ** (y + 1) - x**y)) != 0
    assert sp.simplify(split_powers(x ** (y / 2 + n) - x**n * x ** (y / 2))) == 0


@pytest.mark.parametrize(
    "power", [(x - sp.Abs(x)) ** (n - 1), sp.sqrt(x**2 + x) ** n, sp.sign(x) * x ** (n - 1)]
)
def test_powers_of_what_is_zero_on_an_interval_or_jumps_are_left(power: sp.Expr) -> None:
    assert split_powers(power) == power


@pytest.mark.parametrize(
    "printed",
    [
        r"\sum_{n=1}^\infty\frac{x^n}n=-\ln(1-x)",
        r"\sum_{n=0}^\infty\frac{x^{2n+1}}{2n+1}=\operatorname{artanh}x",
        r"\sum_{n=1}^\infty\frac{(n-3)x^n}{(n-3)n!}=\mathrm{e}^x-1",
        r"\sum_{n=0}^\infty\frac{n^2-4}{(n-2)(n+2)n!}=\mathrm{e}",
        r"\sum_{n=1}^5\frac{n-3}{n-3}=5",
        r"\sum_{n=1}^5(n-3)(n-3)^{-1}=5",
        r"\sum_{k=1}^n(k-2)\frac a{k-2}=na",
        r"\sum_{n=1}^\infty\frac{n-3}{(n-3)n(n+1)}=1",
        r"\sum_{n=0}^\infty\frac{x^n}{(n-2)!}=x^2\mathrm{e}^x",
    ],
)
def test_sums_that_do_not_converge_or_have_undefined_terms_are_left(printed: str) -> None:
    verdict, _ = judge(printed)
    assert verdict in (Verdict.UNDECIDED, Verdict.REFUTED)


@pytest.mark.parametrize(
    "printed",
    [
        r"\sum_{n=4}^5\frac{n-3}{n-3}=2",
        r"\sum_{k=1}^nk\frac ak=na",
        r"\sum_{n=1}^\infty\frac{2^nn}{2^nn^2(n+1)}=1",
        r"\sum_{k=1}^n\frac{k!}{k!}=n",
    ],
)
def test_what_cancels_in_a_term_may_be_zero_elsewhere(printed: str) -> None:
    assert judge(printed)[0] is Verdict.PROVED
