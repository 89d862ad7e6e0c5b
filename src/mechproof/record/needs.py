"""What parts of an expression need to have values: roots, logarithms, integrals, ...

Denominators are no matter here: a statement is judged where none of them is zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

from mechproof.record.expressions import NthDerivative, ValueWhere
from mechproof.record.parts import find_parts
from mechproof.record.relations import Slack

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
