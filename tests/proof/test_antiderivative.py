"""Derivative, constant and continuity: each of the three can fail, and then nothing is proved."""

import pytest
import sympy as sp

from mechproof.proof.continuity import (
    RUNG,
    decide_by_derivative,
    explain_break,
    find_break,
)
from mechproof.statement_domains.domain import Domain

x, y, u, e = sp.symbols("x y u e", real=True)
k = sp.Symbol("k", real=True)
ECCENTRICITY = {e: sp.Interval.Ropen(0, 1)}
BRANCH = {x: sp.Interval.open(-sp.pi, sp.pi), **ECCENTRICITY}
PAST_THE_POLE = {x: sp.Interval.open(1, sp.oo)}
RATIO = (1 - e**2) / (1 + e**2 - 2 * e * sp.cos(u))
POSITION = sp.Integral(RATIO, (u, 0, x))
GLOBAL = x + 2 * sp.atan2(e * sp.sin(x), 1 - e * sp.cos(x))
PRINCIPAL = 2 * sp.atan((1 + e) / (1 - e) * sp.tan(x / 2))

TRUE = {
    "power": (sp.Integral(u**2, (u, 0, x)), x**3 / 3, {}),
    "arctangent": (sp.Integral(1 / (1 + u**2), (u, 0, x)), sp.atan(x), {}),
    "over all turns": (POSITION, GLOBAL, ECCENTRICITY),
    "first branch": (POSITION, PRINCIPAL, BRANCH),
    "complementary angles": (
        sp.atan(x) + sp.atan(1 / x),
        sp.pi / 2,
        {x: sp.Interval.open(0, sp.oo)},
    ),
    "open finite interval": (sp.atan(x) + sp.atan(1 / x), sp.pi / 2, {x: sp.Interval.open(0, 2)}),
    "closed on the right": (sp.atan(x) + sp.atan(1 / x), sp.pi / 2, {x: sp.Interval.Lopen(0, 1)}),
    "left of zero": (sp.atan(x) + sp.atan(1 / x), -sp.pi / 2, {x: sp.Interval.open(-sp.oo, 0)}),
    "arcsine": (sp.asin(x) + sp.acos(x), sp.pi / 2, {x: sp.Interval(-1, 1)}),
    "logarithm": (
        sp.log(x) + sp.log(y),
        sp.log(x * y),
        {x: sp.Interval.open(0, sp.oo), y: sp.Interval.open(0, sp.oo)},
    ),
}

WRONG = {
    "wrong constant": (sp.Integral(u**2, (u, 0, x)), x**3 / 3 + sp.Rational(1, 10**12), {}),
    "wrong derivative": (sp.Integral(u**2, (u, 0, x)), x**3 / 3 + x**9, {}),
    "right derivative, jumps after a turn": (POSITION, PRINCIPAL, ECCENTRICITY),
    "jumps beyond |x| = 22/7 only": (
        2 * sp.atan(sp.sin(x) / (1 + sp.cos(x))),
        x,
        {x: sp.Interval.open(-sp.Rational(22, 7), sp.Rational(22, 7))},
    ),
    "tangent at its pole": (sp.atan(sp.tan(x)), x, {x: sp.Interval.open(-2, 2)}),
    "atan2 across its cut": (sp.atan2(sp.sin(x), sp.cos(x)), x, {}),
    "factor two": (POSITION, x + sp.atan2(e * sp.sin(x), 1 - e * sp.cos(x)), ECCENTRICITY),
    "sine for cosine": (POSITION, x + 2 * sp.atan2(e * sp.cos(x), 1 - e * sp.sin(x)), ECCENTRICITY),
    "complementary angles on both sides of zero": (sp.atan(x) + sp.atan(1 / x), sp.pi / 2, {}),
    "constant taken from the other side of a pole": (
        sp.atan((1 + x) / (1 - x)),
        sp.atan(x) + sp.pi / 4,
        PAST_THE_POLE,
    ),
    "constant taken from beyond an open end": (
        sp.atan(1 / (x - sp.Rational(3, 4))),
        sp.pi / 2 - sp.atan(x - sp.Rational(3, 4)),
        {x: sp.Interval.open(0, sp.Rational(1, 2))},
    ),
    "pole between the limits": (
        sp.Integral(1 / u**2, (u, -1, x)),
        -1 / x - 1,
        {x: sp.Interval.open(0, sp.oo)},
    ),
    "pole inside the range": (
        sp.Integral(1 / (u - 1) ** 2, (u, 0, x)),
        -1 / (x - 1) - 1,
        {x: sp.Interval(0, 2)},
    ),
    "arcsine of a sine": (sp.asin(sp.sin(x)), x, {}),
    "arccosine of a cosine": (sp.acos(sp.cos(x)), x, {x: sp.Interval(-1, 1)}),
    "logarithm of a square": (sp.log(x**2), 2 * sp.log(x), {x: sp.Interval.open(-sp.oo, 0)}),
    "upper limit doubled": (sp.Integral(u, (u, 0, 2 * x)), x**2, {}),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_true_antiderivative_is_proved(name):
    left, right, within = TRUE[name]
    assert decide_by_derivative(left, right, Domain(within, (), {})) == RUNG


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_neighbour_is_not_proved(name):
    left, right, within = WRONG[name]
    assert decide_by_derivative(left, right, Domain(within, (), {})) is None


def test_a_variable_that_a_relation_cuts_is_not_integrated_over():
    left, right = sp.atan((1 + x) / (1 - x)), sp.atan(x) + sp.pi / 4
    assert decide_by_derivative(left, right, Domain({}, (x > 1,), {})) is None


def test_a_relation_of_the_limit_says_nothing_of_the_variable_of_integration():
    integral = sp.Integral(1 / x**2, (x, -1, x))
    assert find_break(integral, x, Domain({}, (x > 1,), {})) == x**-2


def test_the_break_is_named():
    assert "tan(x/2) is not continuous in x" in explain_break(
        PRINCIPAL, Domain(ECCENTRICITY, (), {})
    )
    within = {x: sp.Interval(-3, 3)}
    for part in (sp.Interval(-1, 1), sp.Interval(0, 2)):
        told = explain_break(sp.atan(sp.tan(x**3)), Domain(within, (), {}))
        assert "tan(x**3) was not shown to be continuous in x" in told
        told = explain_break(sp.atan(sp.tan(x)), Domain({x: part}, (), {}))
        assert ("tan(x) is not continuous" in told) == (part.end == 2)
    assert explain_break(GLOBAL, Domain(ECCENTRICITY, (), {})) == ""


BREAKS = {
    "floor": (sp.floor(x), {}),
    "sign": (sp.sign(x), {}),
    "reciprocal": (1 / x, {}),
    "reciprocal that vanishes at half turns": (1 / (1 + sp.cos(x)), {}),
    "tangent at a closed end": (sp.tan(x), {x: sp.Interval.Lopen(-sp.pi / 2, sp.pi / 2)}),
    "logarithm at zero": (sp.log(x), {x: sp.Interval(0, 1)}),
    "root of either sign": (sp.sqrt(x), {}),
    "arcsine beyond one": (sp.asin(x), {x: sp.Interval(0, 2)}),
    "piecewise": (sp.Piecewise((0, x < 0), (1, True)), {}),
    "power with a symbol": (sp.Abs(y) ** x, {}),
}
CONTINUOUS = {
    "reciprocal that does not vanish": (1 / (2 + sp.cos(x)), {}),
    "tangent inside": (sp.tan(x), {x: sp.Interval.open(-sp.pi / 2, sp.pi / 2)}),
    "root at a closed end": (sp.sqrt(x), {x: sp.Interval(0, 1)}),
    "modulus": (sp.Abs(sp.sin(x)) + sp.Max(x, 1), {}),
    "arcsine up to one": (sp.asin(x), {x: sp.Interval(-1, 1)}),
    "does not depend on it": (sp.floor(y), {}),
}


@pytest.mark.parametrize("name", BREAKS)
def test_a_break_is_found(name):
    expression, within = BREAKS[name]
    assert find_break(expression, x, Domain(within, (), {})) is not None


@pytest.mark.parametrize("name", CONTINUOUS)
def test_a_continuous_expression_has_no_break(name):
    expression, within = CONTINUOUS[name]
    assert find_break(expression, x, Domain(within, (), {})) is None
