"""Relations: an inequality as a number that is positive, or not negative; where one holds."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import sympy as sp
from sympy.solvers.inequalities import solve_poly_inequality

_STRICT = (sp.StrictLessThan, sp.StrictGreaterThan)
_ORDERS = (*_STRICT, sp.LessThan, sp.GreaterThan)


class Slack(NamedTuple):
    """A number that must not be negative; if strict, it must not be zero either.

    A point is in a domain where all slacks of its relations are so. As a function of the point the
    slack is what optimisation calls by this name: by how much a constraint is met.
    """

    value: sp.Expr
    strict: bool


@lru_cache(maxsize=1024)
def find_slack(relation: sp.Basic) -> Slack | None:
    """Return the greater side of an inequality less the smaller; None for any other relation."""
    if not isinstance(relation, _ORDERS):
        return None
    return Slack(relation.gts - relation.lts, is_strict(relation))


def solve(condition: sp.Basic, symbol: sp.Symbol) -> sp.Set:
    """Return where a condition on one symbol holds.

    Of a polynomial SymPy is spared the search for a period, which costs a tenth of loading a paper.
    """
    if isinstance(condition, sp.core.relational.Relational):
        polynomial = (condition.lhs - condition.rhs).as_poly(symbol)
        if polynomial is not None and (polynomial.domain.is_QQ or polynomial.domain.is_ZZ):
            return sp.Union(*solve_poly_inequality(polynomial, condition.rel_op))
    return condition.as_set()


def is_strict(relation: sp.Basic) -> bool:
    """Tell whether an inequality leaves its boundary out."""
    return isinstance(relation, _STRICT)


@lru_cache(maxsize=1024)
def is_comparison(relation: sp.Basic) -> bool:
    """Tell whether a relation compares numbers as they are given, so that no rounding decides it.

    Its sides are numbers, symbols, or absolute values of these.
    """
    parts = relation.atoms(sp.core.relational.Relational)
    return all(_is_given(side) for part in parts for side in part.args)


def _is_given(side: sp.Expr) -> bool:
    inner = side.args[0] if isinstance(side, sp.Abs) else side
    return bool(inner.is_Symbol or inner.is_number or isinstance(inner, sp.Indexed))
