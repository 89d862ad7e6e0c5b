"""Polynomials by flint: normal forms with related generators, factors, quotients."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
import sympy as sp

from mechproof.arithmetic.polynomials import (
    cancel,
    factor,
    factor_list,
    is_zero,
    reduce_polynomial,
    split,
)

c, s, r, x = sp.symbols("c s r x", real=True)
CIRCLE = {s**2: 1 - c**2}
# The square of the root r contains a generator of the circle.
ROOT = {**CIRCLE, r**2: 2 + s}


@pytest.mark.parametrize(
    ("polynomial", "relations", "expected"),
    [
        (sp.Integer(0), {}, 0),
        (sp.Rational(3, 7), {}, sp.Rational(3, 7)),
        ((x + 1) ** 2 / 2, {}, x**2 / 2 + x + sp.Rational(1, 2)),
        (s**2 + c**2 - 1, CIRCLE, 0),
        (s**3, CIRCLE, s - s * c**2),
        (s**2 + c**2 + 1, CIRCLE, 2),
        (r**4, ROOT, 5 + 4 * s - c**2),
        (r**3 * x, ROOT, 2 * r * x + r * s * x),
        (x, {**ROOT}, x),
        (x**7, {x**3: 1 - s}, x - 2 * s * x + s**2 * x),
    ],
)
def test_reduced(polynomial: sp.Expr, relations: dict[sp.Pow, sp.Expr], expected: sp.Expr) -> None:
    assert sp.expand(reduce_polynomial(polynomial, relations) - expected) == 0


@pytest.mark.parametrize("wrong", [s**2 + c**2 - sp.Rational(999, 1000), s**2 - c**2, s**3 - s])
def test_what_does_not_vanish_does_not(wrong: sp.Expr) -> None:
    assert reduce_polynomial(wrong, CIRCLE) != 0


@pytest.mark.parametrize("node", [1 / x, sp.sin(x), x**r, sp.sqrt(x), sp.Float(0.5)])
def test_what_is_no_polynomial_is_refused(node: sp.Expr) -> None:
    with pytest.raises(sp.PolynomialError, match="not a polynomial"):
        reduce_polynomial(node, {})


@pytest.mark.parametrize(
    ("quotient", "relations", "zero"),
    [
        (1 / x - (1 - x) / (x - x**2), {}, True),
        (1 / (x * (x + 1)) - 1 / x + 1 / (x + 1), {}, True),
        (1 / (x * (x + 1)) - 1 / x - 1 / (x + 1), {}, False),
        (c / s - s * c / (1 - c**2), CIRCLE, True),
        (c / s - s / c, CIRCLE, False),
        ((s**2 + c**2 - 1) ** 3 / (1 + x), CIRCLE, True),
        # The denominator is zero by the relation, so nothing is shown.
        (sp.Mul(x, 1 / (s**2 + c**2 - 1), 1 - c**2 - s**2, evaluate=False), CIRCLE, False),
        (x / (s**2 + c**2 - 1) - 2 * x / (2 * s**2 + 2 * c**2 - 2), CIRCLE, False),
    ],
)
def test_quotients_are_zero_only_above(
    quotient: sp.Expr, relations: dict[sp.Pow, sp.Expr], zero: bool
) -> None:
    assert is_zero(quotient, relations) == zero


@pytest.mark.parametrize("node", [sp.sin(x) / c, x**r, 1 / sp.sqrt(x), sp.Float(0.5)])
def test_what_is_no_quotient_is_refused(node: sp.Expr) -> None:
    with pytest.raises(sp.PolynomialError, match="not a polynomial"):
        is_zero(node, {})


@pytest.mark.parametrize(
    "expression",
    [
        1 / x + 1 / c,
        (x**2 - 1) / (x - 1) + c,
        sp.sqrt(x) / (1 + 1 / sp.sqrt(x)) - c / x,
        sp.Rational(3, 4) / (x * c) + x ** sp.Rational(3, 2) / c,
        sp.sin(x) / c + 1,
        sp.Integer(7),
    ],
)
def test_split_is_the_same_quotient(expression: sp.Expr) -> None:
    above, below = split(expression)
    assert sp.simplify(above / below - expression) == 0
    assert not any(p.exp.is_negative for part in (above, below) for p in part.atoms(sp.Pow))


@pytest.mark.parametrize(
    ("polynomial", "powers"),
    [
        ((x - 1) ** 2 * (x + c) / 3, {1, 2}),
        (x**2 - 2 * c * x + c**2, {2}),
        (sp.pi * x**2 - sp.pi, {1}),
        (sp.Integer(-5), set()),
        (6 - 6 * x, {1}),
    ],
)
def test_factors_multiply_to_the_polynomial(polynomial: sp.Expr, powers: set[int]) -> None:
    number, factors = factor_list(polynomial)
    assert sp.expand(number * sp.Mul(*(f**p for f, p in factors)) - polynomial) == 0
    assert {power for _, power in factors} == powers


QUOTIENTS = [
    (x**2 - c**2) / (x - c),
    (c - x) * (1 - x) / (2 * x - 2 * c) + x,
    (1 - sp.sin(x) ** 2) / (3 - 3 * sp.sin(x)),
    sp.Rational(2, 3) * (x - 1) / (4 * c - 4 * r),
    (x + sp.sqrt(1 + x)) / sp.sqrt(1 + x),
    (x * (1 + c) ** sp.Rational(3, 2) - sp.sqrt(1 + c) * r) / (x * sp.sqrt(1 + c) - c * (1 + c)),
    (x - sp.sqrt(x)) / x,
    -1 / (1 - x) - sp.pi / (x - 1),
    sp.Integer(0),
]


@pytest.mark.parametrize("quotient", QUOTIENTS)
def test_quotients_are_cancelled_and_factored_as_by_sympy(quotient: sp.Expr) -> None:
    above, below = cancel(quotient)
    expected = sp.fraction(sp.cancel(quotient))
    assert (above, below) == expected or sp.expand(above / below - expected[0]) == 0
    assert factor(quotient) == sp.factor(sp.cancel(quotient))


@pytest.mark.parametrize(
    "polynomial",
    [
        (c - x) ** 2 * (1 - x) / 6,
        x * (x - r * c) * (r - 1) - c * (x - r * c) * (r - 1),
        (2 * x - 2 * c) * (3 * c - 3 * x) ** 3,
        sp.sin(x) ** 2 - sp.cos(x) ** 2,
        sp.sqrt(x) * (x - 1),
        x**2 - sp.pi**2,
        sp.Integer(12),
        sp.Integer(0),
        sp.Mul(0, x + 1, evaluate=False),
        # The same factor, written with other letters.
        (x + 1) * (x * c + c),
        x * (x * c + x),
        (x - c) * (x * r - c * r),
    ],
)
def test_factors_are_those_of_sympy_in_its_order(polynomial: sp.Expr) -> None:
    assert factor_list(polynomial) == sp.factor_list(polynomial)


def test_a_quotient_has_no_list_of_factors_and_none_is_by_zero() -> None:
    with pytest.raises(sp.PolynomialError):
        factor_list(x / (x + c))
    with pytest.raises(sp.PolynomialError, match="divides by zero"):
        cancel(1 / sp.Add(x * (c + 1), -c * x, -x, evaluate=False))


@pytest.mark.slow
def test_fractions_are_written_whatever_numbers_sympy_computes_with() -> None:
    told = (
        "import sympy as sp; from mechproof.arithmetic.polynomials import cancel;"
        "x = sp.Symbol('x'); print(cancel((x**3 - x) / (2 * x + 2)))"
    )
    for types in ("python", "flint"):
        run = subprocess.run(
            [sys.executable, "-c", told],
            env=os.environ | {"SYMPY_GROUND_TYPES": types},
            capture_output=True,
            text=True,
            check=True,
        )
        assert run.stdout == "(x**2 - x, 2)\n"
