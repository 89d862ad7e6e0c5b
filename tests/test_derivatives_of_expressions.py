"""Derivatives of expressions equal SymPy's, down to the form in which they are written."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.record.parts import differentiate

X, Y = sp.symbols("x y", real=True)


@pytest.mark.parametrize(
    "expression",
    [
        sp.Integer(3),
        Y**2,
        X * Y * sp.sin(X * Y) ** 2,
        sp.sqrt(1 - X**2) / (1 + X * sp.cos(Y)) ** 3,
        X**Y + Y**X,
        sp.atan2(X, Y) * sp.exp(-X),
        sp.Abs(X) + sp.Max(X, Y),
        sp.Piecewise((X**2, X > 0), (Y, True)),
        sp.Integral(sp.cos(X * Y), (Y, 0, X)),
    ],
    ids=str,
)
def test_derivatives_are_written_as_by_sympy(expression: sp.Expr) -> None:
    found, expected = differentiate(expression, X), sp.diff(expression, X)
    assert (found, str(found)) == (expected, str(expected))
