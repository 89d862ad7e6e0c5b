"""Inequalities proved by induction over whole numbers: true ones are proved, their twins not."""

from __future__ import annotations

import pytest
import sympy as sp
from twins import ACCEPTED, judge

from mechproof.proof.counts import find_first, let_run
from mechproof.proof.induction import OF_INEQUALITIES, holds_by_steps
from mechproof.proof.inequalities import show_sign
from mechproof.proof.verdict import Verdict
from mechproof.record import Slack
from mechproof.statement_domains.domain import Domain

n = sp.Symbol("n", integer=True, positive=True)
k = sp.Symbol("k", integer=True)
x = sp.Symbol("x", real=True)
DOMAIN = Domain({n: sp.S.Naturals}, (), {})
N = r"n\in\mathbb N"
ROWS = (
    (r"2^n>n", N, r"2^n>n+1", N),
    (r"2^n\ge n+1", N, r"2^n>n+1", N),
    (r"3^n>n^2", N, r"3^n>n^3", N),
    (r"2^n>n^2", N + r", n\ge5", r"2^n>n^2", N + r", n\ge3"),
    (r"n!>2^n", N + r", n\ge4", r"n!>2^n", N + r", n\ge3"),
    (r"n!\ge2^{n-1}", N, r"n!>2^{n-1}", N),
    (r"n!>3^n", N + r", n\ge7", r"n!>3^n", N + r", n\ge6"),
    (r"n^n\ge n!", N, r"n^n>n!", N),
    (r"(1+x)^n\ge1+nx", N + r", x\ge-1", r"(1+x)^n\ge1+nx", N),
    (r"|\sin nx|\le n|\sin x|", N, r"|\sin nx|<n|\sin x|", N),
    (r"\sum_{k=1}^n\frac1{k^2}\le2-\frac1n", N, r"\sum_{k=1}^n\frac1{k^2}\le2-\frac2n", N),
    (r"\sum_{k=1}^n\frac1{\sqrt k}<2\sqrt n", N, r"\sum_{k=1}^n\frac1{\sqrt k}<2\sqrt n-1", N),
    (
        r"2\sqrt{n+1}-2<\sum_{k=1}^n\frac1{\sqrt k}",
        N,
        r"2\sqrt{n+1}-\frac32<\sum_{k=1}^n\frac1{\sqrt k}",
        N,
    ),
    (r"\sum_{k=1}^n\frac1k\le1+\ln n", N, r"\sum_{k=1}^n\frac1k<1+\ln n", N),
    (r"\sum_{k=n+1}^{2n}\frac1k\ge\frac12", N, r"\sum_{k=n+1}^{2n}\frac1k>\frac12", N),
    (r"\binom{2n}n\ge2^n", N, r"\binom{2n}n\ge3^n", N),
)


@pytest.mark.parametrize(("printed", "where", "twin", "there"), ROWS)
def test_an_inequality_is_proved_and_its_neighbour_not_accepted(
    printed: str, where: str, twin: str, there: str
) -> None:
    assert judge(printed, where) == (Verdict.PROVED, OF_INEQUALITIES)
    assert judge(twin, there)[0] not in ACCEPTED


@pytest.mark.parametrize(
    ("value", "strict"),
    [
        (2**n - 8, False),
        (2 - 2**n + n**3, True),
        (1 + 1 / (n - 3), False),
        (sp.Sum(1 / (k - 3), (k, 1, n)) + 10, False),
        ((-1) ** n + n - 1, False),
        ((-2) ** n + 2**n, True),
        (sp.factorial(n - 4) - 1, False),
        (x + sp.sqrt(x + n) + 1, False),
        (x ** (2 * n - 4) + 1 / (x + n) ** 2, False),
    ],
    ids=str,
)
def test_what_fails_at_a_number_or_has_no_value_there_is_not_shown(
    value: sp.Expr, strict: bool
) -> None:
    assert not holds_by_steps(Slack(value, strict), DOMAIN, show_sign)


def test_the_first_number_is_what_is_said_of_it_alone() -> None:
    said = (sp.Ge(2 * n, 9), sp.Gt(n, sp.Rational(7, 2)), sp.Gt(x, n))
    assert find_first(n, Domain({n: sp.S.Naturals}, said, {})) == 4
    assert find_first(n, Domain({n: sp.S.Integers}, said, {})) is None


def test_no_power_of_what_may_be_negative_runs_between_whole_exponents() -> None:
    assert let_run((-2) ** n, n, DOMAIN) is None
    assert let_run(x**n, n, DOMAIN) is None
    assert let_run(sp.floor(n / 2), n, DOMAIN) is None
    assert let_run(2**n, n, DOMAIN) is not None
