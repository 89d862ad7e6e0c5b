"""Square roots of what is positive, by numbers of which no more is known than their squares.

Roots of quotients and products go by those of their factors: sqrt((1 + e)/(1 - e))*sqrt(1 - e**2)
is 1 + e then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import sympy as sp

from mechproof.arithmetic.polynomials import cancel, factor_list


def name_roots(
    expression: sp.Expr, radicands: Iterable[sp.Expr], is_positive: Callable[[sp.Expr], bool]
) -> tuple[sp.Expr, tuple[sp.Symbol, ...]]:
    """Return an expression with numbers for the roots of these positive radicands, and these."""
    roots: dict[sp.Expr, sp.Symbol] = {}
    values = {radicand: _name_root(radicand, roots, is_positive) for radicand in radicands}
    squares = {root: factor for factor, root in roots.items()}
    named = expression.replace(
        lambda node: node.is_Pow and node.base in values and node.exp.is_Rational,
        lambda node: values[node.base] ** (2 * node.exp),
    )
    named = named.replace(
        lambda node: node.is_Pow and node.base in squares and node.exp.is_Integer,
        lambda node: squares[node.base] ** (node.exp // 2) * node.base ** (node.exp % 2),
    )
    return named, tuple(squares)


def _name_root(
    radicand: sp.Expr, roots: dict[sp.Expr, sp.Symbol], is_positive: Callable[[sp.Expr], bool]
) -> sp.Expr:
    """Return a root as a product of those of its factors, if their signs are known."""

    def name(factor: sp.Expr) -> sp.Symbol:
        return roots.setdefault(factor, sp.Dummy("root", positive=True))

    try:
        (above, numerators), (below, denominators) = map(factor_list, cancel(radicand))
    except sp.PolynomialError:
        return name(radicand)
    powers = [*numerators, *((factor, -n) for factor, n in denominators)]
    turned = [-factor if is_positive(-factor) else factor for factor, _ in powers]
    if len(powers) < 2 or not all(map(is_positive, turned)):
        return name(radicand)
    # The radicand is positive, and so are its factors.
    number = sp.sqrt(abs(above / below))
    return number * sp.Mul(*(name(f) ** n for f, (_, n) in zip(turned, powers, strict=True)))
