"""The parts of an expression and its free symbols are those that SymPy finds."""

import pytest
import sympy as sp
from sympy.core.cache import clear_cache

from mechproof.record.parts import find_free, find_parts, list_parts, replace_parts

X, Y, N = sp.symbols("x y n")
K = sp.Symbol("k", integer=True)
A = sp.IndexedBase("a")
EXPRESSIONS = (
    sp.Integer(3),
    X + sp.sin(X * Y) ** 2,
    sp.Sum(A[K] * K**2, (K, 1, N)) + K,
    sp.Integral(sp.cos(X), (X, 0, Y)),
    sp.Limit(X / Y, X, 0),
    sp.Derivative(sp.Function("f")(X), X),
    sp.Piecewise((X, Y > 0), (N, True)),
    sp.And(X < Y, sp.Or(N > 0, sp.Eq(Y, 1))),
    sp.ImmutableDenseMatrix([[X, 1], [A[1], Y]]),
    sp.Lambda(X, X + Y),
)


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_they_are_those_of_sympy(expression: sp.Basic) -> None:
    assert find_free(expression) == expression.free_symbols
    for kinds in ((sp.Symbol,), (sp.Indexed, sp.Pow), (sp.Rational,), (sp.Function, sp.Add)):
        assert find_parts(expression, *kinds) == expression.atoms(*kinds)


def test_a_part_that_is_repeated_is_listed_once() -> None:
    nested = X
    for _ in range(40):
        nested = sp.sin(nested) + sp.cos(nested)
    assert len(list_parts(nested)) == 121


def test_a_relation_left_as_it_stands_is_not_decided_by_what_is_put_beside_it() -> None:
    one = 2 + sp.sin(1)
    clear_cache()
    again = 2 + sp.sin(1)
    relation = sp.Lt(again, 3, evaluate=False)
    assert one is not again
    found = replace_parts(sp.Tuple(one, relation, X), {X: sp.S.One})
    assert found.args[1] is relation
