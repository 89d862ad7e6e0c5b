"""Domain: in, the sets and relations of a paper; out, the conditions on a kernel's arguments."""

from __future__ import annotations

import sympy as sp

from mechproof.programs.evaluation import input_symbols, trace_inputs
from mechproof.record import Paper, Quantity, Variable


def domain_relations(quantity: Quantity, paper: Paper) -> tuple[sp.Basic, ...]:
    """Collect the relations on the arguments alone: from variables, the paper and the quantity."""
    inputs = {s for argument in quantity.arguments for s in argument.symbols}
    narrower = quantity.on.within if quantity.on else {}
    relations: list[sp.Basic] = []
    for variable in paper.variables:
        if variable.symbol in inputs:
            item = _element(variable, quantity)
            relations += set_relations(item, narrower.get(variable.symbol, variable.within))
    stated = paper.list_relations(quantity.on)
    relations += [r for r in stated if input_symbols(r) <= inputs]
    return tuple(dict.fromkeys(relations))


def checked_relations(quantity: Quantity, paper: Paper) -> tuple[sp.Basic, ...]:
    """Return the relations a kernel checks: those without sums.

    To check a sum would cost as much as the formula; the root it is under gives NaN.
    """
    return tuple(r for r in domain_relations(quantity, paper) if not r.has(sp.Sum))


def can_be_left(quantity: Quantity, paper: Paper, checked: tuple[sp.Basic, ...]) -> bool:
    """Return whether some relation on the arguments, directly or by given symbols, is unchecked."""
    inputs = {s for argument in quantity.arguments for s in argument.symbols}
    stated = paper.list_relations(quantity.on)
    others = (r for r in stated if trace_inputs(r, paper.given) <= inputs)
    return any(r not in checked for r in (*domain_relations(quantity, paper), *others))


def set_relations(item: sp.Expr, values: sp.Set) -> list[sp.Basic]:
    """Return relations for `item` being in an interval, a finite set or Naturals; not infinite.

    Raises ValueError for any other set.
    """
    if values == sp.S.Reals:
        return []
    if values == sp.S.Naturals:
        # Unevaluated, because a symbol declared an integer is its own floor.
        whole = sp.Eq(item, sp.floor(item, evaluate=False), evaluate=False)
        return [*set_relations(item, sp.Interval(1, sp.oo)), whole]
    if isinstance(values, sp.FiniteSet):
        return [sp.Or(*(sp.Eq(item, value) for value in values.args))]
    if not isinstance(values, sp.Interval):
        known = "Interval, FiniteSet, Naturals or Reals"
        raise ValueError(f"{item}: no relations for the set {values}; use {known}")
    low = sp.Lt if values.left_open else sp.Le
    high = sp.Lt if values.right_open else sp.Le
    return [
        low(values.start, item, evaluate=False),
        high(item, values.end, evaluate=False),
    ]


def _element(variable: Variable, quantity: Quantity) -> sp.Expr:
    """Return the variable's symbol, or an element of an indexed base as the quantity indexes it."""
    if not isinstance(variable.symbol, sp.IndexedBase):
        return variable.symbol
    items = [i for i in quantity.definition.atoms(sp.Indexed) if i.base == variable.symbol]
    return min(items, key=sp.default_sort_key)
