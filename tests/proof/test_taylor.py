"""Bounds near zero are proved by Taylor series, and slightly wrong ones are not."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy import Abs, Integer, Rational, Symbol, exp, log, sin, tan

from mechproof.arithmetic.exact_series import ORDER, expand_at_zero
from mechproof.proof.ladder import decide
from mechproof.proof.single_variable import NEAR_ZERO, holds_near_zero
from mechproof.proof.verdict import Verdict
from mechproof.record import Holds
from mechproof.statement_domains.domain import Domain

x = Symbol("x", real=True)
HALF = Rational(1, 2)
CUBIC = sin(x) - x + x**3 / 6


def near(reach: sp.Expr) -> Domain:
    return Domain({x: sp.Interval(-reach, reach)}, (), {})


def bound(value: sp.Expr, factor: sp.Expr, power: int) -> sp.Basic:
    return sp.Le(Abs(value), factor * Abs(x) ** power)


@pytest.mark.parametrize(
    ("relation", "reach"),
    [
        (bound(CUBIC, Rational(1, 119), 5), HALF),
        (bound(CUBIC, Rational(1, 100), 5), Integer(1)),
        (bound(tan(x) - x - x**3 / 3, Rational(16, 100), 5), HALF),
        (bound(exp(x) - 1 - x, Rational(6, 10), 2), Rational(1, 4)),
        (bound(log(1 + x) - x, Rational(7, 10), 2), HALF / 2),
    ],
)
def test_a_bound_is_proved_by_its_series(relation: sp.Basic, reach: sp.Expr) -> None:
    answer = decide(Holds(relation), near(reach))
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, NEAR_ZERO)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("relation", "reach"),
    [
        # A bound below the first term, a wrong coefficient, a pole in reach.
        (bound(CUBIC, Rational(1, 121), 5), HALF),
        (bound(sin(x) - x + x**3 / Rational(601, 100), Rational(1, 119), 5), HALF),
        (bound(tan(x), Integer(10**6), 1), Rational(8, 5)),
        (bound(log(1 + x) - x, Integer(10**6), 2), Integer(1)),
    ],
)
def test_a_slightly_wrong_bound_is_not(relation: sp.Basic, reach: sp.Expr) -> None:
    assert not holds_near_zero(relation, near(reach))
    assert decide(Holds(relation), near(reach)).verdict is not Verdict.PROVED


def test_a_bound_that_fails_next_to_zero_is_refuted() -> None:
    relation = bound(CUBIC, Integer(1), 6)
    assert not holds_near_zero(relation, near(HALF))
    assert decide(Holds(relation), near(HALF)).verdict is Verdict.REFUTED


def test_no_bound_is_proved_without_ends() -> None:
    assert not holds_near_zero(bound(CUBIC, Integer(1), 5), Domain({x: sp.S.Reals}, (), {}))


@pytest.mark.parametrize("value", [tan(x), exp(sin(x)), sp.sqrt(1 + x) / (2 - x), sp.atan(3 * x)])
def test_the_coefficients_are_those_of_sympy(value: sp.Expr) -> None:
    found = expand_at_zero(value, x)
    assert found is not None
    assert len(found) == ORDER
    expected = sp.Poly(sp.series(value, x, 0, 6).removeO(), x).all_coeffs()[::-1]
    assert found[: len(expected)] == expected


@pytest.mark.parametrize("value", [1 / x, sp.cos(1 + x), log(x), sp.Abs(x), x * sp.pi])
def test_what_has_no_rational_coefficients_has_none(value: sp.Expr) -> None:
    assert expand_at_zero(value, x) is None
