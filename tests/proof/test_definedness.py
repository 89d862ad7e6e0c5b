"""Conditions under which an expression has a value: which are shown, and which sides share them."""

from __future__ import annotations

import pytest
import sympy as sp
from twins import ACCEPTED, judge

from mechproof.proof.definedness import describe, list_unshown, list_unshown_inside, need_the_same
from mechproof.proof.verdict import Verdict
from mechproof.record import Paper, Variable
from mechproof.statement_domains.domain import Domain

x, y = sp.symbols("x y", real=True)
k = sp.Symbol("k", integer=True, positive=True)
DOMAIN = Domain.of(Paper("p", "c", (Variable(x, "a number"), Variable(y, "another")), ()))
EXPANDED = sp.sqrt(x**2 + 2 * x * y + y**2 - 1)


def list_needs(sides: tuple[sp.Expr, sp.Expr]) -> list[list[tuple[sp.Expr, bool]]]:
    return [list_unshown(side, DOMAIN) for side in sides]


def test_what_is_shown_is_not_listed() -> None:
    assert list_unshown(sp.sqrt(x**2 + 1) + sp.log(2 + sp.cos(x)), DOMAIN) == []
    assert [describe(n) for n in list_unshown(sp.sqrt(x) / sp.log(y), DOMAIN)] == [
        "x >= 0",
        "y > 0",
    ]


@pytest.mark.parametrize(
    ("sides", "alike"),
    [
        ((EXPANDED, sp.sqrt((x + y) ** 2 - 1)), True),
        ((sp.sqrt(x - 1) / sp.sqrt(x - 1), 1 / sp.sqrt(x - 1) * sp.sqrt(x - 1)), True),
        ((sp.sqrt(x) + 1 / sp.sqrt(x), sp.log(x)), True),
        ((EXPANDED, sp.sqrt((x - y) ** 2 - 1)), False),
        ((sp.sqrt(x), sp.log(x)), False),
        ((sp.sqrt(x), sp.sqrt(x) + sp.sqrt(y)), False),
        ((sp.sqrt(x), sp.S.Zero), False),
        # Unknown for a sum, even if both sides are identical.
        ((sp.sqrt(x) + sp.Sum(sp.log(x + k), (k, 1, 3)),) * 2, False),
    ],
)
def test_sides_need_the_same_where_needs_are_proved_equal(
    sides: tuple[sp.Expr, sp.Expr], alike: bool
) -> None:
    assert need_the_same(sides, list_needs(sides), DOMAIN) is alike
    turned = sides[::-1]
    assert need_the_same(turned, list_needs(turned), DOMAIN) is alike


@pytest.mark.parametrize(
    "printed",
    [
        r"\frac{d}{dx}\ln x=\frac1x",
        r"\frac{d}{dx}\sqrt x=\frac1{2\sqrt x}",
        r"\frac{d}{dx}\operatorname{arcosh}x=\frac1{\sqrt{x^2-1}}",
        r"\frac{d}{dx}\ln\tan\frac x2=\frac1{\sin x}",
    ],
)
def test_a_derivative_is_what_it_is_where_the_function_has_values(printed: str) -> None:
    assert judge(printed)[0] is Verdict.PROVED


@pytest.mark.slow
@pytest.mark.parametrize(
    "printed",
    [
        r"\frac{d}{dx}\ln x=\frac{d}{dx}\ln(-x)",
        r"\frac{d}{dx}\ln x=\frac2x",
        r"\ln x^2=2\ln x",
        r"\ln(xy)=\ln x+\ln y",
        r"\int_0^1\sqrt{x-2}\,dx=\int_0^1\sqrt{x-2}\,dx+\ln y-\ln y",
    ],
)
def test_where_one_side_only_is_defined_nothing_is_proved(printed: str) -> None:
    assert judge(printed)[0] not in ACCEPTED


# Summands and integrands that have values on one domain and, on a wider one, do not.
INSIDE = [
    (r"\int_0^a\sqrt x\sqrt x\,dx=\frac{a^2}2", "a>0", ""),
    (r"\int_0^a(\sqrt{1-x})^2\,dx=a-\frac{a^2}2", "0<a<1", "a>0"),
    (r"\int_0^h(\sqrt{r^2-x^2})^2\,dx=r^2h-\frac{h^3}3", "0<h<r", "h>0, r>0"),
    (r"\int_1^2\frac{\ln x}{\ln x}\,dx=1", "x>0", None),
    (r"\int_0^1(\sqrt{2-x}-\sqrt{2-x})\,dx=0", "", None),
    (r"\sum_{k=1}^n(\sqrt k)^2=\frac{n(n+1)}2", "", None),
    (r"\sum_{k=1}^n(\sqrt{n-k})^2=\frac{n(n-1)}2", "", None),
    (r"\int_0^1(\sqrt x)^2\,dx<1", "", None),
    (r"\int_1^0(\sqrt x)^2\,dx=-\frac12", "", None),
]
NOT_INSIDE = [
    (r"\int_{-\infty}^\infty(\sqrt{-x})^2\mathrm e^{-x^2}\,dx=0", ""),
    (r"\int_{-\infty}^0(\sqrt{-x-5})^2\mathrm e^x\,dx=-4", ""),
    (r"\int_0^2\frac{\sqrt{1-x}}{\sqrt{1-x}}\,dx=2", ""),
    (r"\int_0^2\frac{\arcsin3x}{\arcsin3x}\,dx=2", ""),
    (r"\int_0^2(\sqrt{1-x}-\sqrt{1-x})\,dx=0", ""),
    (r"\sum_{k=1}^n(\sqrt{1000-k})^2=1000n-\frac{n(n+1)}2", ""),
    (r"\sum_{k=1}^n\sin(\arcsin\frac k{1000})=\frac{n(n+1)}{2000}", ""),
    (r"\int_0^2(\sqrt{1-x})^2\,dx<1", ""),
]


@pytest.mark.slow
@pytest.mark.parametrize(("printed", "where", "wider"), INSIDE)
def test_what_runs_has_values_where_it_runs(printed: str, where: str, wider: str | None) -> None:
    assert judge(printed, where)[0] is Verdict.PROVED
    if wider is not None:
        assert judge(printed, wider)[0] not in ACCEPTED


@pytest.mark.slow
@pytest.mark.parametrize(("printed", "where"), NOT_INSIDE)
def test_what_runs_without_values_proves_nothing(printed: str, where: str) -> None:
    assert judge(printed, where)[0] not in ACCEPTED


def test_what_is_needed_up_to_infinity_is_shown() -> None:
    assert list_unshown_inside(sp.Integral(sp.sqrt(-y) * sp.exp(y), (y, -sp.oo, 0)), DOMAIN) == []
    assert list_unshown_inside(sp.Integral(sp.sqrt(y) * sp.exp(y), (y, -sp.oo, 0)), DOMAIN)


def test_what_is_not_shown_is_told_with_where_it_runs() -> None:
    inner = sp.Sum(sp.Integral(sp.sqrt(y - k), (y, 0, k)), (k, 1, 4))
    (told,) = list_unshown_inside(inner, DOMAIN)
    assert told.describe() == "-k + y >= 0 for y from 0 to k and k from 1 to 4"


@pytest.mark.parametrize("place", ["x", "x+2", r"x-\frac34", "x-y", "x-y^2"])
def test_a_logarithm_that_cancels_is_missed_at_its_zero(place: str) -> None:
    half = rf"\mathrm{{e}}^{{\frac{{\ln({place})}}2}}"
    assert judge(rf"{half}=\sqrt{{{place}}}")[0] is Verdict.UNDECIDED
    assert judge(rf"{half}=\sqrt{{{place}}}", f"{place}>0")[0] is Verdict.PROVED


@pytest.mark.parametrize("place", ["x", "x-4", "x-y"])
def test_sides_that_both_lack_a_value_at_an_edge_are_equal(place: str) -> None:
    assert judge(rf"\frac1{{\sqrt{{{place}}}}}=\frac{{\sqrt{{{place}}}}}{{{place}}}")[0] in ACCEPTED
    assert judge(rf"\ln\left(({place})^2\right)=2\ln|{place}|")[0] is Verdict.PROVED


@pytest.mark.parametrize(("where", "verdict"), [("l>0", Verdict.PROVED), ("l<0", Verdict.REFUTED)])
def test_sides_that_both_have_a_value_at_an_edge_are_compared(where: str, verdict: Verdict) -> None:
    assert judge(r"\sqrt{l^2-r^2}=l\sqrt{1-r^2/l^2}", where)[0] is verdict
