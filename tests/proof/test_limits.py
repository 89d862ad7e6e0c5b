"""Limits are replaced by their values only where these are shown, on the sides that have values."""

from __future__ import annotations

import pytest
import sympy as sp
from twins import ACCEPTED, judge

from mechproof.proof.limits import settle_limits
from mechproof.proof.verdict import Verdict
from mechproof.statement_domains.domain import Domain

x, a = sp.symbols("x a", real=True)
DOMAIN = Domain({a: sp.Interval.open(0, sp.oo)}, (), {})
TRUE = {
    r"\lim_{x\to0}\sin x": "0",
    r"\lim_{x\to\infty}\frac{\ln x}x": "0",
    r"\lim_{x\to\infty}x\mathrm{e}^{-x}": "0",
    r"\lim_{x\to\infty}\left(1+\frac1x\right)^x": r"\mathrm{e}",
    r"\lim_{x\to\infty}\left(\sqrt{x^2+x}-x\right)": r"\frac12",
    r"\lim_{x\to\infty}x\left(\sqrt{x^2+1}-x\right)": r"\frac12",
    r"\lim_{n\to\infty}\sum_{k=1}^n\frac1{k(k+1)}": "1",
    r"\lim_{n\to\infty}\frac1n\sum_{k=1}^n\left(\frac kn\right)^2": r"\frac13",
    r"\lim_{x\to\infty}\arctan x": r"\frac\pi2",
    r"\lim_{x\to\infty}\frac{\sin x}x": "0",
    r"\lim_{x\to0}x\ln|x|": "0",
    r"\lim_{x\to0^+}x\ln x": "0",
    r"\lim_{x\to0}\frac{\arctan x}x": "1",
    r"\lim_{x\to0}\frac{\arcsin x-x}{x^3}": r"\frac16",
    r"\lim_{x\to\infty}x\left(\frac\pi2-\arctan x\right)": "1",
    r"\lim_{x\to-\infty}x\left(\arctan x+\frac\pi2\right)": "-1",
    r"\lim_{x\to\infty}(\operatorname{arsinh}x-\ln x)": r"\ln2",
    r"\lim_{x\to\infty}(\operatorname{arsinh}(-x)+\ln x)": r"-\ln2",
    r"\lim_{x\to\infty}(\operatorname{arcosh}x-\ln x)": r"\ln2",
    r"\lim_{x\to1^-}\frac{\arccos x}{\sqrt{1-x}}": r"\sqrt2",
    r"\lim_{x\to-1^+}\frac{\pi-\arccos x}{\sqrt{1+x}}": r"\sqrt2",
    r"\lim_{x\to1^-}\frac{\pi-2\arcsin x}{\sqrt{1-x}}": r"2\sqrt2",
    r"\lim_{x\to-1^+}\frac{\pi+2\arcsin x}{\sqrt{1+x}}": r"2\sqrt2",
    r"\lim_{x\to\infty}\left(\frac{x+a}{x-a}\right)^x": r"\mathrm{e}^{2a}",
}


@pytest.mark.parametrize("limit", TRUE)
def test_a_limit_is_proved_and_another_value_refuted(limit: str) -> None:
    assert judge(f"{limit}={TRUE[limit]}")[0] is Verdict.PROVED
    assert judge(rf"{limit}={TRUE[limit]}+\frac1{{100}}")[0] is Verdict.REFUTED


@pytest.mark.parametrize(
    "limit",
    [
        sp.Limit(1 / x, x, 0, "+-"),
        sp.Limit(sp.Abs(x) / x, x, 0, "+-"),
        sp.Limit(sp.sin(x), x, sp.oo),
        sp.Limit(sp.sin(1 / x), x, 0, "+"),
        sp.Limit(sp.exp(x * sp.sin(x)), x, sp.oo),
        # Inside a formula infinity is not a number.
        1 + sp.Limit(x**x, x, sp.oo),
        sp.Limit((a - 1) * x, x, sp.oo),
        # No limit where the function has no values.
        sp.Limit(x * sp.log(x), x, 0, "-"),
        sp.Limit(sp.log(1 - x) - sp.log(2 - x), x, sp.oo),
        sp.Limit((-2) ** (-x), x, sp.oo),
        sp.Limit(sp.sqrt(-1 - x) / x, x, sp.oo),
    ],
)
def test_what_has_no_limit_is_left(limit: sp.Expr) -> None:
    assert settle_limits(limit, DOMAIN) == limit


def test_an_infinite_limit_that_stands_alone_is_told() -> None:
    assert settle_limits(sp.Limit(x**x, x, sp.oo), DOMAIN) == sp.oo
    assert settle_limits(sp.Limit(sp.log(x), x, 0, "+"), DOMAIN) == -sp.oo


def test_one_side_does_not_speak_for_the_other() -> None:
    assert judge(r"\lim_{x\to0}\arctan\frac1x=\frac\pi2")[0] not in ACCEPTED
    assert judge(r"\lim_{x\to0^+}\arctan\frac1x=\frac\pi2")[0] is Verdict.PROVED
    assert judge(r"\lim_{x\to0^-}\arctan\frac1x=-\frac\pi2")[0] is Verdict.PROVED
