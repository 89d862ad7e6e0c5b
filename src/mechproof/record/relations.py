"""Relations: an inequality as a number that is positive, or not negative; where one holds.

Such are also what parts of an expression need to have values: roots, logarithms, integrals.
Denominators are no matter here: a statement is judged where none of them is zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import NamedTuple

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.solvers.inequalities import solve_poly_inequality

from mechproof.record.expressions import NthDerivative, ValueWhere
from mechproof.record.parts import find_parts

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


_NEEDS: Mapping[type[sp.Basic], Callable[[sp.Expr], tuple[Slack, ...]]] = {
    sp.log: lambda x: (Slack(x, True),),
    sp.asin: lambda x: (Slack(1 - x, False), Slack(1 + x, False)),
    sp.acos: lambda x: (Slack(1 - x, False), Slack(1 + x, False)),
    # Below zero it has values between whole numbers, too.
    sp.gamma: lambda x: (Slack(x, True),),
    sp.acosh: lambda x: (Slack(x - 1, False),),
    sp.atanh: lambda x: (Slack(1 - x, True), Slack(1 + x, True)),
}
_TURNING: Mapping[tuple[type[sp.Expr], ...], type[sp.Expr]] = {
    (sp.tan, sp.sec): sp.cos,
    (sp.cot, sp.csc): sp.sin,
}
# They have kinks or steps; denominators of these may be zero on whole intervals.
KINKED = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.floor, sp.ceiling, sp.Heaviside, sp.Piecewise)


def list_partial(expression: sp.Basic) -> tuple[sp.Expr, ...]:
    """List the parts with a value in places only, once each; none in sums, integrals and cases."""
    found: dict[sp.Expr, None] = {}
    seen: set[sp.Basic] = set()

    def visit(node: sp.Basic) -> None:
        if node in seen:
            return
        seen.add(node)
        if not isinstance(node, ExprWithLimits | sp.Limit | sp.Piecewise | NthDerivative):
            for part in node.args:
                visit(part)
        if _is_partial(node):
            found[node] = None

    visit(expression)
    return tuple(found)


def list_divisors(expression: sp.Expr) -> tuple[sp.Expr, ...]:
    """List what an expression divides by; a tangent does by its cosine."""
    found = dict.fromkeys(
        power.base
        for power in find_parts(expression, sp.Pow)
        if power.exp.could_extract_minus_sign()
    )
    for kinds, below in _TURNING.items():
        found |= dict.fromkeys(below(node.args[0]) for node in find_parts(expression, *kinds))
    return tuple(sorted(found, key=sp.default_sort_key))


def _is_partial(node: sp.Basic) -> bool:
    return bool(
        node is sp.I
        or isinstance(node, ExprWithLimits | sp.Limit | ValueWhere)
        or list_needs(node)
        or (isinstance(node, sp.Pow) and node.exp.is_negative and node.base.has(*KINKED))
    )


def list_needs(node: sp.Basic) -> tuple[Slack, ...]:
    """Return what a root, a logarithm or an inverse function needs beyond values of its parts."""
    if isinstance(node, sp.Pow) and not node.exp.is_integer:
        needs: tuple[Slack, ...] = (Slack(node.base, not node.exp.is_positive),)
    else:
        needs = _NEEDS[type(node)](node.args[0]) if type(node) in _NEEDS else ()
    return tuple(
        Slack(number, strict)
        for number, strict in needs
        if not (number.is_positive or (number.is_nonnegative and not strict))
    )
