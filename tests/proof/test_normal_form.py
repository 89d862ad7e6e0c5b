"""The normal form of polynomials with related generators."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.proof.normal_form import reduce_polynomial

c, s, r, x = sp.symbols("c s r x", real=True)
CIRCLE = {s: 1 - c**2}
# The root's square holds the circle's generators.
ROOT = {**CIRCLE, r: 2 + s}


@pytest.mark.parametrize(
    ("polynomial", "squares", "expected"),
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
    ],
)
def test_reduced(polynomial: sp.Expr, squares: dict[sp.Symbol, sp.Expr], expected: sp.Expr) -> None:
    assert sp.expand(reduce_polynomial(polynomial, squares) - expected) == 0


@pytest.mark.parametrize("wrong", [s**2 + c**2 - sp.Rational(999, 1000), s**2 - c**2, s**3 - s])
def test_what_does_not_vanish_does_not(wrong: sp.Expr) -> None:
    assert reduce_polynomial(wrong, CIRCLE) != 0


@pytest.mark.parametrize("node", [1 / x, sp.sin(x), x**r, sp.sqrt(x), sp.Float(0.5)])
def test_what_is_no_polynomial_is_refused(node: sp.Expr) -> None:
    with pytest.raises(sp.PolynomialError, match="no polynomial"):
        reduce_polynomial(node, {})
