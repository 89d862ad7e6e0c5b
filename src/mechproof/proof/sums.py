"""Canonical form of sums with a symbolic number of terms.

A polynomial in such sums is written as a polynomial in *canonical* sums: Kronecker deltas
carried out, constants in front, unused indices turned into factors n, independent indices
split into products of sums, bound indices renamed in one order. Two canonical sums with
different summands are independent as functions of arbitrarily many terms, so equality of the
polynomials decides equality for every n.
"""

from __future__ import annotations

from itertools import permutations

import sympy as sp

Limit = tuple[sp.Symbol, sp.Expr]


def canonicalise(expression: sp.Basic) -> sp.Basic:
    """Replace every Sum in the expression by its canonical form.

    Raises `NotImplementedError` for a Sum whose lower limit is not 1 or whose upper limit
    depends on another index.
    """
    if not expression.has(sp.Sum):
        return expression
    if isinstance(expression, sp.Sum):
        return _canonical_sum(expression)
    return expression.func(*(canonicalise(argument) for argument in expression.args))


def _canonical_sum(node: sp.Sum) -> sp.Expr:
    limits: list[Limit] = []
    body = _flatten(node, limits)
    terms = sp.Add.make_args(sp.expand(body))
    return sp.Add(*(_canonical_term(term, limits) for term in terms))


def _flatten(node: sp.Expr, limits: list[Limit]) -> sp.Expr:
    """Collect the limits of nested sums under fresh indices; return the innermost summand."""
    if not isinstance(node, sp.Sum):
        return _flatten_inside(node, limits)
    body = node.function
    bound = {limit[0] for limit in node.limits} | {index for index, _ in limits}
    for index, lower, upper in node.limits:
        if lower != 1 or upper.free_symbols & bound:
            raise NotImplementedError(f"a Sum over {index} from {lower} to {upper}")
        fresh = sp.Dummy(index.name, integer=True)
        body = body.subs(index, fresh)
        limits.append((fresh, upper))
    return _flatten(body, limits)


def _flatten_inside(node: sp.Expr, limits: list[Limit]) -> sp.Expr:
    """Draw the inner sums of a summand, products and whole powers of sums included, out of it."""
    if not node.has(sp.Sum):
        return node
    if isinstance(node, sp.Mul):
        return sp.Mul(*(_flatten(argument, limits) for argument in node.args))
    if isinstance(node, sp.Pow) and node.exp.is_Integer and node.exp > 0:
        return sp.Mul(*(_flatten(node.base, limits) for _ in range(int(node.exp))))
    if isinstance(node, sp.Add):
        inner = [canonicalise(argument) for argument in node.args]
        if any(
            argument.has(sp.Sum) and argument.free_symbols & {i for i, _ in limits}
            for argument in inner
        ):
            raise NotImplementedError(f"an inner Sum beside other terms: {node}")
        return sp.Add(*inner)
    raise NotImplementedError(f"a Sum inside {type(node).__name__} inside a Sum")


def _canonical_term(term: sp.Expr, limits: list[Limit]) -> sp.Expr:
    term, limits = _carry_out_deltas(term, limits)
    indices = {index for index, _ in limits}
    factors = sp.Mul.make_args(term)
    outside = [f for f in factors if not f.free_symbols & indices]
    result = sp.Mul(*outside)
    remaining = [f for f in factors if f.free_symbols & indices]
    for index, upper in limits:
        if not any(index in f.free_symbols for f in remaining):
            result *= upper
    for component in _components(remaining, indices):
        used = {i for f in component for i in f.free_symbols & indices}
        result *= _rename(sp.Mul(*component), [lim for lim in limits if lim[0] in used])
    return result


def _carry_out_deltas(term: sp.Expr, limits: list[Limit]) -> tuple[sp.Expr, list[Limit]]:
    limits = list(limits)
    while deltas := sorted(term.atoms(sp.KroneckerDelta), key=sp.default_sort_key):
        delta = deltas[0]
        if delta not in sp.Mul.make_args(term):
            raise NotImplementedError(f"{delta} that is not a factor of {term}")
        first, second = delta.args
        bounds = dict(limits)
        if first not in bounds or second not in bounds or bounds[first] != bounds[second]:
            raise NotImplementedError(f"{delta} between unlike indices")
        term = term.subs(second, first)
        limits = [limit for limit in limits if limit[0] != second]
    return term, limits


def _components(factors: list[sp.Expr], indices: set[sp.Symbol]) -> list[list[sp.Expr]]:
    """Group the factors that share indices."""
    groups: list[tuple[set[sp.Basic], list[sp.Expr]]] = []
    for factor in factors:
        used, members = set(factor.free_symbols & indices), [factor]
        for group in [g for g in groups if g[0] & used]:
            groups.remove(group)
            used |= group[0]
            members += group[1]
        groups.append((used, members))
    return [members for _, members in groups]


def _rename(body: sp.Expr, limits: list[Limit]) -> sp.Expr:
    """Name the indices _1, _2, ... in the order that gives the first expression of all orders."""
    names = [sp.Symbol(f"_{k}", integer=True) for k in range(1, len(limits) + 1)]
    candidates = []
    for order in permutations(limits):
        renamed = body.subs(dict(zip((i for i, _ in order), names, strict=True)), simultaneous=True)
        bounds = [(n, 1, u) for n, (_, u) in zip(names, order, strict=True)]
        candidates.append(sp.Sum(renamed, *bounds))
    return min(candidates, key=sp.srepr)
