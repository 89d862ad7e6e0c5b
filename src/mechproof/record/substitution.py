"""Substitution without capture: a bound symbol is renamed if a free one of its name arrives.

Sums of a few terms, and step functions, are written out here, too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

from mechproof.record.exactness import RecordError
from mechproof.record.parts import find_bound, find_free, find_parts, has_parts, replace_parts

# A sum of more terms than this is not written out.
MOST_TERMS = 64


def substitute(expression: sp.Basic, values: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """Replace free symbols by values, all at once."""
    arriving = {s for value in values.values() for s in find_free(value)} | values.keys()
    return replace_parts(release(expression, arriving), values)


def put_found(expression: Any, found: Mapping[Any, sp.Expr | None]) -> Any:
    """Replace parts by the values found; an infinite value replaces only the whole expression."""
    known = {part: value for part, value in found.items() if value is not None}
    finite = {part: value for part, value in known.items() if not value.is_infinite}
    return known.get(expression, expression.xreplace(finite))


def put_values(
    expression: Any, domain: Any, kinds: tuple[type, ...], find: Callable[[Any, Any], Any]
) -> Any:
    """Replace parts of some kinds, whose letters are bound nowhere, by the values found for them.

    An infinite value replaces only a part that stands alone.
    """
    bound = set(find_bound(expression))
    parts = (part for part in find_parts(expression, *kinds) if not part.free_symbols & bound)
    return put_found(expression, {part: find(part, domain) for part in sorted(parts, key=str)})


def resolve(expression: sp.Basic, given: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """Substitute symbols that are defined by others until only free ones are left."""
    for _ in range(len(given) + 1):
        found = find_free(expression) & given.keys()
        if not found:
            return expression
        expression = substitute(expression, {symbol: given[symbol] for symbol in found})
    raise RecordError(f"symbols are defined in terms of each other: {sorted(map(str, found))}")


def release(expression: sp.Basic, names: set[sp.Basic]) -> sp.Basic:
    """Rename the bound symbols of sums and integrals that are among the names."""
    nodes = find_parts(expression, ExprWithLimits)
    if not any(limit[0] in names for node in nodes for limit in node.limits):
        return expression
    if isinstance(expression, sp.MatrixBase):
        return expression.applyfunc(lambda entry: release(entry, names))
    parts = [release(part, names) for part in expression.args]
    if isinstance(expression, ExprWithLimits):
        parts = _rename(expression.func(*parts), names)
    return expression.func(*parts)


def _rename(node: ExprWithLimits, names: set[sp.Basic]) -> list[sp.Basic]:
    """Return the parts of a node with bound symbols renamed, also in the limits of inner ones."""
    body, limits = node.function, [tuple(limit) for limit in node.limits]
    for place, (bound, *ends) in enumerate(limits):
        if bound in names:
            fresh = sp.Dummy(bound.name, **bound.assumptions0)
            body = body.subs(bound, fresh)
            inner = [(b, *(end.subs(bound, fresh) for end in es)) for b, *es in limits[:place]]
            limits = [*inner, (fresh, *ends), *limits[place + 1 :]]
    return [body, *(sp.Tuple(*limit) for limit in limits)]


def write_steps(expression: sp.Basic) -> sp.Basic:
    """Write functions that jump as floors and pieces."""
    for kind, write in STEPS.items():
        if has_parts(expression, kind):
            expression = expression.replace(kind, write)
    return expression


def _write_step(number: sp.Expr, at_zero: sp.Expr) -> sp.Expr:
    above = sp.Piecewise((1, number > 0), (at_zero, True))
    return sp.Piecewise((0, number < 0), (above, True))


STEPS: Mapping[type[sp.Basic], Callable[..., sp.Expr]] = MappingProxyType(
    {sp.ceiling: lambda number: -sp.floor(-number), sp.Heaviside: _write_step}
)


def write_sums_out(
    expression: sp.Basic, is_meant: Callable[[sp.Sum], bool] = lambda total: True
) -> sp.Basic:
    """Write out the sums with numeric limits and few terms, as far as `is_meant` accepts them.

    A sum that ends before it begins has no value: SymPy would take terms away.
    """

    def is_short(node: sp.Basic) -> bool:
        if not isinstance(node, sp.Sum) or not is_meant(node):
            return False
        counts = [high - low + 1 for _, low, high in node.limits]
        return all(count.is_Integer and 0 <= count <= MOST_TERMS for count in counts)

    return expression.replace(is_short, lambda total: total.doit())
