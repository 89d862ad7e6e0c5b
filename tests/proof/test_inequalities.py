"""Inequalities beyond positive coordinates: true ones are proved, their twins are not."""

from __future__ import annotations

import pytest
import sympy as sp
from twins import check_twins, judge, list_rows

from mechproof.proof.binomial_squares import RUNG as BINOMIAL_SQUARES, holds_by_squares
from mechproof.proof.cases import RUNG as CASES
from mechproof.proof.half_angles import find_sign_in_half_angles, find_sign_there
from mechproof.proof.inequalities import HALF_ANGLES, ORDERS, SIGNS, SQUARES, VALUES
from mechproof.proof.integrand_signs import RUNG as INTEGRANDS
from mechproof.proof.ladder import SIGN
from mechproof.proof.monotonicity import RUNG as MONOTONICITY, holds_by_slope
from mechproof.proof.polynomial_signs import StrictSign
from mechproof.proof.verdict import Verdict
from mechproof.record import Slack
from mechproof.statement_domains.domain import Domain

x, y = sp.symbols("x y", real=True)
PI = sp.pi
NOT_NEGATIVE = r"a\ge0, b\ge0, c\ge0"
TABLES = {
    HALF_ANGLES: (
        (r"\cosh x\ge1", r"\cosh x>1", ""),
        (r"\tanh x<1", r"\tanh x<\frac{999}{1000}", ""),
        (r"\arcsin x\le\frac\pi2", r"\arcsin x<\frac\pi2", r"-1\le x\le1"),
        (r"\sin x+\sin2x\ge0", r"\sin x+\sin2x>0", r"0\le x\le\frac\pi2"),
        (r"\frac{\sin x}{1+\cos x}\le1", r"\frac{\sin x}{1+\cos x}<1", r"0\le x\le\frac\pi2"),
    ),
    INTEGRANDS: (
        (r"\int_0^1x^n\,dx\le1", r"\int_0^1x^n\,dx\le\frac13", r"n\in\mathbb N"),
        (r"|\int_0^x\sin t^2\,dt|\le x", r"|\int_0^x\sin t^2\,dt|\le\frac x2", r"x\ge0"),
        (r"\int_0^x\mathrm e^{t^2}\,dt\ge x", r"\int_0^x\mathrm e^{t^2}\,dt>x", r"x\ge0"),
        (r"\int_0^1\frac{\arctan x}xdx\le1", r"\int_0^1\frac{\arctan x}{x^2}dx\le5", ""),
        (r"\int_a^b\frac{dx}{1+x^2}\le b-a", r"\int_a^b\frac{dx}{1+x^2}\ge b-a", "b>a"),
        (
            r"\int_0^{2\pi}\sqrt{1-k^2\sin^2t}\,dt\le2\pi",
            r"\int_0^{2\pi}\sqrt{1-k^2\sin^2t}\,dt<2\pi",
            r"0\le k\le1",
        ),
    ),
    ORDERS: (
        (
            r"\frac a{b+c}+\frac b{c+a}+\frac c{a+b}\ge\frac32",
            r"\frac a{b+c}+\frac b{c+a}+\frac c{a+b}>\frac32",
            "a>0, b>0, c>0",
        ),
        (
            r"a^3+b^3+c^3+3abc\ge ab^2+a^2b+ac^2+a^2c+bc^2+b^2c",
            r"a^3+b^3+c^3+3abc>ab^2+a^2b+ac^2+a^2c+bc^2+b^2c",
            "a>0, b>0, c>0",
        ),
    ),
    VALUES: (
        (r"\arcsin x\ge x", r"\arcsin x>x", r"0\le x\le1"),
        (r"\arctan x<\arcsin x", r"\arctan x<\frac9{10}\arcsin x", r"0<x<1"),
        (r"E<\arccos e", r"E<\arccos(2e)", r"\cos E>e, 0<E<\pi, 0<e<\frac12"),
        (r"\arccos x\le\frac\pi2-x", r"\arccos x<\frac\pi2-x", r"0\le x\le1"),
        (
            r"\arctan x+\arctan y\ge\frac\pi2",
            r"\arctan x+\arctan y>\frac\pi2",
            r"xy\ge1, x>0, y>0",
        ),
    ),
    SIGN: (
        (
            r"\lfloor x\rfloor\lfloor y\rfloor\le xy",
            r"\lfloor x\rfloor\lfloor y\rfloor<xy",
            r"x\ge0, y\ge0",
        ),
        (r"\frac x{\lfloor x\rfloor}<2", r"\frac x{\lfloor x\rfloor}<\frac{19}{10}", r"x\ge1"),
        (r"\cos E>e", r"\cos E>2e", r"E<\arccos e, 0<E, 0<e<\frac12"),
        (r"\mathrm{e}^x<y", r"\mathrm{e}^x<\frac{9y}{10}", r"x<\ln y"),
        (r"\sin\frac{\pi x}b\ge0", r"\sin\frac{\pi x}b>0", r"0\le x\le b, b>0"),
        (r"\cos\frac{\pi x}{2b}\ge0", r"\cos\frac{\pi x}{2b}>0", r"0\le x\le b, b>0"),
    ),
    CASES: (
        (r"\left||a|-|b|\right|\le|a-b|", r"\left||a|-|b|\right|\ge|a-b|", ""),
        (
            r"\frac{|a+b|}{1+|a+b|}\le\frac{|a|}{1+|a|}+\frac{|b|}{1+|b|}",
            r"\frac{|a+b|}{1+|a+b|}\le\frac{|a|}{1+|a|}+\frac{|b|}{2+|b|}",
            "",
        ),
    ),
    SIGNS: ((r"|a-u|\le|a-b|+|b-c|+|c-u|", r"|a-u|<|a-b|+|b-c|+|c-u|", ""),),
    SQUARES: (
        (r"|\sin x|\le|x|", r"|\sin x|<|x|", ""),
        (r"|\sin2x|\le2|\sin x|", r"|\sin2x|\le\frac{19}{10}|\sin x|", ""),
        (
            r"\sqrt{(a+c)^2+(b+d)^2}\le\sqrt{a^2+b^2}+\sqrt{c^2+d^2}",
            r"\sqrt{(a+c)^2+(b+d)^2}\le\sqrt{a^2+b^2}+\sqrt{c^2-d^2}",
            "",
        ),
        (r"\sqrt{1-k\cos x}\ge\sqrt{1-k}", r"\sqrt{1-k\cos x}>\sqrt{1-k}", r"0\le k\le1"),
    ),
    BINOMIAL_SQUARES: (
        (r"x^4+y^4+z^4\ge x^2yz+xy^2z+xyz^2", r"x^4+y^4+z^4>x^2yz+xy^2z+xyz^2", ""),
        (
            r"(ax+by+cz)^2\le(a^2+b^2+c^2)(x^2+y^2+z^2)",
            r"(ax+by+cz)^2\le(a^2+b^2+c^2)(x^2+y^2-z^2)",
            "",
        ),
        (r"\frac{a+b+c}3\ge\sqrt[3]{abc}", r"\frac{a+b+c}3>\sqrt[3]{abc}", NOT_NEGATIVE),
        (
            r"\frac{a+b+c}3\ge\sqrt[3]{abc}",
            r"\frac{a+b+c}3\ge\frac{10001}{10000}\sqrt[3]{abc}",
            NOT_NEGATIVE,
        ),
        (r"ab\le\frac{a^3}3+\frac{2b^{3/2}}3", r"ab<\frac{a^3}3+\frac{2b^{3/2}}3", r"a\ge0, b\ge0"),
        (r"x^4+y^4+z^4+w^4+1>4xyzw", r"x^4+y^4+z^4+w^4>4xyzw", ""),
        (r"\frac ab+\frac ba\ge2", r"\frac ab+\frac ba>2", "ab>0"),
        (r"\frac ab+\frac ba\le-2", r"\frac ab+\frac ba\ge2", "ab<0"),
        (r"\frac1{x^2}>0", r"\frac1{x^2}>1", ""),
    ),
    MONOTONICITY: (
        (r"\sin x\le x", r"\sin x<x", r"x\ge0"),
        (r"\frac{\sin x}x<1", r"\frac{\sin x}x<\frac{999}{1000}", r"0<x\le\pi"),
        (r"\tan x>x", r"\tan x>x+\frac{x^3}{2}", r"0<x<\frac\pi2"),
        (r"\frac x{1+x}\le\ln(1+x)", r"\frac x{1+x}<\ln(1+x)", "x>-1"),
        (r"\sin x\ge\frac{2x}\pi", r"\sin x\ge\frac{2x}3", r"0\le x\le\frac\pi2"),
        (r"x\mathrm{e}^{-x}\le\frac1{\mathrm{e}}", r"x\mathrm{e}^{-x}<\frac1{\mathrm{e}}", "x>0"),
        (r"\sin x<x", r"\sin x<\frac{999x}{1000}", "x>0"),
        (r"x-\frac{x^3}6<\sin x", r"x-\frac{x^3}7<\sin x", "x>0"),
        (r"\cos x\le1-\frac{x^2}2+\frac{x^4}{24}", r"\cos x<1-\frac{x^2}2+\frac{x^4}{24}", ""),
        (r"\sin x>\frac{2x}\pi", r"\sin x>\frac{7x}{10}", r"0<x<\frac\pi2"),
        (r"\mathrm e^x>x^2", r"\mathrm e^x>2x^2", "x>0"),
        (r"\mathrm e^x>x^{\mathrm e}", r"\mathrm e^x<x^{\mathrm e}", r"x>\mathrm e"),
        (r"\ln x<\sqrt x", r"\ln x<\frac7{10}\sqrt x", "x>0"),
        (r"x^x\ge\mathrm e^{-1/\mathrm e}", r"x^x>\mathrm e^{-1/\mathrm e}", "x>0"),
        (r"x^p\le1+p\cdot(x-1)", r"x^p<1+p\cdot(x-1)", "0<p<1, x>0"),
        (r"(x+y)^p\le x^p+y^p", r"(x+y)^p\ge x^p+y^p", "x>0, y>0, 0<p<1"),
        (
            r"ab\le\frac{a^p}p+\frac{b^q}q",
            r"ab<\frac{a^p}p+\frac{b^q}q",
            r"a>0, b>0, p>1, q=\frac p{p-1}",
        ),
        (
            r"\sqrt{ab}\le\frac{a-b}{\ln a-\ln b}",
            r"\sqrt{2ab}\le\frac{a-b}{\ln a-\ln b}",
            "a>b, b>0",
        ),
        (
            r"\frac{a-b}{\ln a-\ln b}\le\frac{a+b}2",
            r"\frac{a-b}{\ln a-\ln b}\le\frac{a+b}3",
            "a>b, b>0",
        ),
        (
            r"x\ln x+y\ln y\ge(x+y)\ln\frac{x+y}2",
            r"x\ln x+y\ln y>(x+y)\ln\frac{x+y}2",
            "x>0, y>0",
        ),
        (
            r"\ln\left(1+\frac1n\right)>\frac1{n+1}",
            r"\ln\left(1+\frac1n\right)>\frac7{10n}",
            r"n\in\mathbb N",
        ),
        (
            r"\left(1+\frac1n\right)^n<\mathrm e",
            r"\left(1+\frac1n\right)^n<\frac{27}{10}",
            r"n\in\mathbb N",
        ),
        (
            r"\left(1+\frac1n\right)^{n+1}>\mathrm e",
            r"\left(1+\frac1n\right)^n>\mathrm e",
            r"n\in\mathbb N",
        ),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("rung", "printed", "twin", "where"), list_rows(TABLES))
def test_an_inequality_is_proved_and_its_neighbour_not_accepted(
    rung: str, printed: str, twin: str, where: str
) -> None:
    check_twins(rung, printed, twin, where)


@pytest.mark.slow
def test_a_chain_of_bounds_of_a_rate_is_proved() -> None:
    rate, where = r"\frac{\cos\beta}{1-\sin^2\beta\cos^2\varphi}", r"0\le\beta<\frac\pi2"
    for bound in (r"\cos\beta\le" + rate, rate + r"\le\frac1{\cos\beta}"):
        assert judge(bound, where)[0] is Verdict.PROVED
        assert judge(bound.replace(r"\le", "<"), where)[0] is Verdict.REFUTED


@pytest.mark.parametrize(
    ("expression", "values", "sign"),
    [
        (1 + sp.cos(x), sp.S.Reals, StrictSign(1, False)),
        (1 + sp.cos(x), sp.Interval.open(-PI, PI), StrictSign(1, True)),
        (1 + sp.cos(x), sp.Interval.Ropen(0, PI), StrictSign(1, True)),
        (1 + sp.cos(x), sp.Interval(0, PI), StrictSign(1, False)),
        (sp.sin(x), sp.Interval(0, PI), StrictSign(1, False)),
        (sp.sin(x), sp.Interval.open(PI, 2 * PI), StrictSign(-1, True)),
        (sp.sin(x), sp.Interval.open(0, PI + sp.Rational(1, 1000)), None),
        (sp.sin(x / 2), sp.Interval.open(0, 2 * PI), StrictSign(1, True)),
        (2 - sp.exp(x), sp.Interval(-sp.oo, 0), StrictSign(1, True)),
        (1 - sp.exp(x), sp.Interval(-sp.oo, 0), StrictSign(1, False)),
        (sp.atan(x) - PI / 4, sp.Interval(1, sp.oo), StrictSign(1, False)),
        (sp.atan(x) - PI / 4, sp.Interval.open(1, sp.oo), StrictSign(1, True)),
        (PI / 2 - sp.acos(x), sp.Interval(0, 1), StrictSign(1, False)),
    ],
)
def test_signs_are_strict_only_where_no_end_is_zero(
    expression: sp.Expr, values: sp.Interval, sign: StrictSign | None
) -> None:
    assert find_sign_in_half_angles(expression, Domain({x: values}, (), {})) == sign


def test_powers_that_are_not_all_zero_add_up_to_a_positive_number() -> None:
    domain = Domain({x: sp.Interval(0, sp.pi / 2)}, (), {})
    roots = [sp.sqrt(number) for number in (sp.sin(x), sp.cos(x), 1 - sp.cos(x))]
    assert find_sign_there(roots[0] + roots[1], domain) == StrictSign(1, strict=True)
    for number in (roots[0] + roots[2], roots[0] - roots[1]):
        sign = find_sign_there(number, domain)
        assert sign is None or not sign.strict


def test_what_jumps_at_an_end_is_not_what_it_is_inside() -> None:
    a, b = sp.symbols("a b", real=True)
    domain = Domain(dict.fromkeys((a, b), sp.Interval(0, sp.oo)), (), {})
    for value in (sp.sign(a) - sp.Rational(1, 2), sp.Heaviside(a) - 1, sp.sign(a) * sp.cbrt(b) - b):
        assert not holds_by_squares(Slack(value, strict=False), domain)
    root = sp.sign(a * b) * sp.cbrt(sp.Abs(a * b))
    assert holds_by_squares(Slack(a + b + 1 - 3 * root, strict=False), domain)
    assert not holds_by_squares(Slack(a + b + 1 - 4 * root, strict=False), domain)


@pytest.mark.parametrize(
    ("value", "values", "strict"),
    [
        (x - sp.sin(x), sp.S.Reals, False),
        (x - sp.sin(x), sp.Interval(0, sp.oo), True),
        (sp.sqrt((x - 1) ** 2) + x - 1, sp.Interval.open(0, sp.oo), True),
        (sp.exp(-x) - sp.Rational(1, 1000), sp.Interval(0, sp.oo), False),
        (sp.atan(x) - x / (1 + x) - sp.Rational(3, 5), sp.Interval.open(0, sp.oo), False),
        (sp.exp(y * x) - 1, sp.Interval.open(0, sp.oo), True),
        (sp.exp(y**2 * x) - 1, sp.Interval.open(0, sp.oo), True),
        (1 - sp.log(x) ** 2, sp.Interval.open(0, sp.oo), False),
        (sp.log(x) + 1 / x, sp.Interval.open(-1, sp.oo), False),
        # Concave on both sides of a kink.
        (sp.acos(sp.cos(x - sp.Rational(7, 10))) - sp.Rational(1, 10**6), sp.Interval(0, 2), False),
        (sp.acosh(sp.cosh(x)) - sp.Rational(1, 10**6), sp.Interval(-1, 2), False),
    ],
    ids=str,
)
def test_what_is_zero_somewhere_or_falls_below_is_not_shown_by_slopes(
    value: sp.Expr, values: sp.Interval, strict: bool
) -> None:
    assert not holds_by_slope(Slack(value, strict), Domain({x: values}, (), {}))
