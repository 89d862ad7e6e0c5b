"""Numbers below their separation bounds are proved zero, and no others are."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.proof.exact_values import SEPARATION, decide_by_separation
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import Domain

ANYWHERE = Domain({}, (), {})
DEGREE = sp.pi / 180
DUST = sp.Rational(1, 10**300)


def cosines(*degrees: int) -> sp.Expr:
    return sp.Mul(*(sp.cos(degree * DEGREE) for degree in degrees))


def tangents(*degrees: int) -> sp.Expr:
    return sp.Mul(*(sp.tan(degree * DEGREE) for degree in degrees))


NESTED = sp.sqrt(34 - 2 * sp.sqrt(17))
K = sp.Dummy("k", integer=True)
SINES = sp.Product(sp.sin(K * sp.pi / 7), (K, 1, 6))
TRUE: dict[str, tuple[sp.Expr, sp.Expr]] = {
    "three cosines": (cosines(20, 40, 80), sp.Rational(1, 8)),
    "three tangents": (tangents(20, 40, 80), sp.sqrt(3)),
    "reciprocal tangents": (tangents(1, 89), sp.S.One),
    "a tangent and a sine": (
        sp.tan(3 * sp.pi / 11) + 4 * sp.sin(2 * sp.pi / 11),
        sp.sqrt(11),
    ),
    "quotients": (1 / sp.sin(10 * DEGREE) - sp.sqrt(3) / sp.cos(10 * DEGREE), sp.Integer(4)),
    "cube roots": (sp.cbrt(2 + sp.sqrt(5)) - sp.cbrt(sp.sqrt(5) - 2), sp.S.One),
    "nested cube roots": (
        sp.cbrt(sp.cbrt(2) - 1),
        (1 - sp.cbrt(2) + sp.cbrt(4)) / sp.cbrt(9),
    ),
    "sum of roots": (sp.sqrt(2) + sp.sqrt(3), sp.sqrt(5 + 2 * sp.sqrt(6))),
    "seventeen corners": (
        sp.cos(2 * sp.pi / 17),
        (
            sp.sqrt(17)
            - 1
            + NESTED
            + 2 * sp.sqrt(17 + 3 * sp.sqrt(17) - NESTED - 2 * sp.sqrt(34 + 2 * sp.sqrt(17)))
        )
        / 16,
    ),
    "a product": (SINES, sp.Rational(7, 64)),
    "a sum of many terms": (
        sp.Sum(sp.sin(sp.pi * K / 7) ** 2, (K, 1, 210)),
        sp.Integer(105),
    ),
}
OTHER: dict[str, tuple[sp.Expr, sp.Expr]] = {
    "pi": (sp.sqrt(sp.pi) * sp.sqrt(2), sp.sqrt(2 * sp.pi + DUST)),
    "an exponential": (sp.exp(sp.Rational(1, 3)), sp.cbrt(3) - DUST),
    "the sine of a number": (sp.sin(1) ** 2, 1 - sp.cos(1) ** 2),
    "a root of what is negative": (sp.cbrt(-8), 1 + sp.sqrt(-3)),
    "a letter": (sp.Symbol("x", real=True), sp.S.Zero),
    "a degree beyond the limit": (sp.cos(sp.pi / 10007), sp.cos(sp.pi / 10007) + DUST),
    "a division by zero": (1 / (sp.sqrt(5 + 2 * sp.sqrt(6)) - sp.sqrt(2) - sp.sqrt(3)), sp.S.One),
}


@pytest.mark.parametrize("name", TRUE)
def test_equal_numbers_are_proved(name: str) -> None:
    assert decide_by_separation(*TRUE[name], ANYWHERE) == SEPARATION
    assert decide(Equality(*TRUE[name]), ANYWHERE).verdict is Verdict.PROVED


@pytest.mark.parametrize("name", TRUE)
def test_numbers_that_differ_by_next_to_nothing_are_not(name: str) -> None:
    left, right = TRUE[name]
    assert decide_by_separation(left, right + DUST, ANYWHERE) is None
    assert decide(Equality(left, right + DUST), ANYWHERE).verdict is not Verdict.PROVED


@pytest.mark.parametrize("name", OTHER)
def test_of_other_numbers_nothing_is_said(name: str) -> None:
    assert decide_by_separation(*OTHER[name], ANYWHERE) is None
