"""Series of all functions known to kernels: values and slopes, and no series across a seam."""

from __future__ import annotations

import pytest
import sympy as sp
from flint import arb, arb_series
from sympy import Rational
from sympy.codegen.cfunctions import expm1, log1p

from mechproof.arithmetic.exact_series import ORDER, expand_at_zero
from mechproof.arithmetic.series import BITS, TaylorExpression, is_finite, list_terms, working
from mechproof.programs.lowering import FUNCTIONS

X, K = sp.symbols("x k", real=True)
TERMS = 5
# Functions that occur in programs only.
INNER = {"ProductRest", "QuotientRest", "SumRest", "SmallTangent", "SmallArctan"}
INNER |= {"TangentQuotient", "ArctanQuotient", "Single", "WholeTurnsOff", "hypot"}
SMOOTH = [
    *(f(X) for f in (sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.exp, sp.log, sp.cbrt)),
    *(f(X) for f in (sp.sec, sp.csc, sp.cot, sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech, sp.csch)),
    *(f(X) for f in (sp.asinh, sp.atanh, sp.sinc, expm1, log1p, sp.sqrt)),
    *(sp.acosh(2 + X), sp.atan2(X, K - 1), X**K, K**X, X**X, (X - 1) ** 5, X ** Rational(-7, 3)),
    *(X**-2, sp.sqrt(X) ** 3, sp.sinc(X - K), sp.sinc(40 * X)),
]
# The values of functions with steps or corners at x = 9/16 and k = 1/4.
STEPS = {
    sp.sign(X - 1): -1,
    sp.floor(3 * X): 1,
    sp.ceiling(3 * X): 2,
    sp.Heaviside(X - K): 1,
    sp.Mod(X, K): X - Rational(1, 2),
    sp.Mod(-X, 2): 2 - X,
    sp.frac(5 * X): 5 * X - 2,
    sp.Max(X, K): X,
    sp.Min(X, K, 2): Rational(1, 4),
    sp.Abs(X - 1): 1 - X,
    sp.Piecewise((X, (X > 0) & (X < 1)), (0, True)): X,
}
PLACE = Rational(9, 16)


def expand(expression: sp.Expr, place: arb, k: object = Rational(1, 4)) -> list[arb]:
    with working(TERMS, BITS):
        series = TaylorExpression(expression, X, {}, {K: k}).expand(arb_series([place, 1]))
        return list_terms(series)


@pytest.mark.parametrize("expression", [*SMOOTH, *STEPS], ids=str)
def test_values_and_slopes_are_those_of_sympy(expression: sp.Expr) -> None:
    at = sp.sympify(STEPS.get(expression, expression)).subs(K, Rational(1, 4))
    found, whole = expand(expression, arb(9) / 16), expand(expression, arb(9 / 16, 1e-4))
    for order in range(TERMS):
        slope = sp.diff(at, X, order).doit().subs(X, PLACE) / sp.factorial(order)
        with working(1, BITS):
            # Up to an absolute rounding error, and no wider.
            right = arb(str(sp.N(slope, 40, maxn=1000)))
            assert abs(found[order] - right) < 1e-25 * (1 + abs(right))
            assert whole[order].contains(found[order])


@pytest.mark.parametrize("expression", STEPS, ids=str)
def test_there_is_none_across_a_seam(expression: sp.Expr) -> None:
    assert not is_finite(expand(expression, arb(9 / 16, 10)))


def test_every_function_of_kernels_has_a_series() -> None:
    tried = {type(node).__name__ for e in (*SMOOTH, *STEPS) for node in sp.preorder_traversal(e)}
    assert set(FUNCTIONS) - INNER <= tried


@pytest.mark.parametrize(
    "expression",
    [*(f(X - 2) for f in (sp.log, sp.sqrt, sp.cbrt, sp.csc, sp.cot)),
     *(sp.acosh(X), sp.sec(X), 1 / (X - 2), (X - 2) ** K)],
    ids=str,
)  # fmt: skip
@pytest.mark.parametrize("factor", [1, K, sp.floor(X / 8)])
def test_what_is_undefined_somewhere_has_none(expression: sp.Expr, factor: sp.Expr) -> None:
    """Nor has its product with a factor that is zero."""
    exponent = Rational(1, 4)
    value = factor * sp.cos(expression.subs(K, exponent))
    assert not expand(value, arb(2, 1.25), 0)[0].is_finite()


@pytest.mark.parametrize("place", [arb(0), arb(0, 1e-9), arb(0.25, 0.25), arb(-3, 1e-9)])
def test_the_sinc_is_enclosed_near_zero(place: arb) -> None:
    found = expand(sp.sinc(X), place)
    with working(TERMS, BITS):
        for inner in (place.lower(), place.mid(), place.upper()):
            assert all(
                term.overlaps(right) for term, right in zip(found, expand_sinc(inner), strict=True)
            )
    assert found[1].rad() < 0.2


def expand_sinc(place: arb) -> list[arb]:
    """Return the Taylor terms of sinc at a point, from sixty terms of its series."""
    powers = sp.series(sp.sin(X), X, 0, 60).removeO() / X
    return list_terms(TaylorExpression(sp.expand(powers), X, {}, {}).expand(arb_series([place, 1])))


@pytest.mark.parametrize(
    "expression",
    [*(f(X) for f in (sp.sec, sp.sinh, sp.cosh, sp.tanh, sp.sech, sp.sinc, sp.asinh, sp.atanh)),
     *(expm1(X), log1p(X), sp.cbrt(1 + X), (1 + X) ** X, (1 - X) ** -3, sp.sinc(sp.tan(X)))],
    ids=str,
)  # fmt: skip
def test_exact_terms_at_zero_are_those_of_sympy(expression: sp.Expr) -> None:
    found = expand_at_zero(expression, X)
    assert found is not None
    assert len(found) == ORDER
    plain = expression.replace(sp.sinc, lambda a: sp.sin(a) / a)
    powers = sp.series(plain, X, 0, TERMS).removeO()
    assert [*found[:TERMS]] == [powers.coeff(X, order) for order in range(TERMS)]


@pytest.mark.parametrize(
    "expression",
    [*(sp.csc(X), sp.cot(X), sp.coth(X), sp.acosh(X), sp.sinc(1 + X), sp.cbrt(X), sp.cbrt(2 + X)),
     *(sp.floor(X), sp.sign(X), sp.sinh(1 + X), X**X, sp.Min(X, 0))],
    ids=str,
)  # fmt: skip
def test_there_are_no_exact_terms_where_they_are_not_rational(expression: sp.Expr) -> None:
    assert expand_at_zero(expression, X) is None
