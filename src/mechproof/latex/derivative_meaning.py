"""Printed derivatives -> SymPy."""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex import tree
from mechproof.latex.values import (
    OF_SIGNS,
    UNSMOOTH,
    differentiate,
    list_steps,
    make_running,
    settle,
    settle_all,
)
from mechproof.record import DerivativeWhere, NthDerivative, ValueWhere

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning


def give_derivative(meaning: Meaning, node: tree.Derivation) -> Any:
    """Return a derivative, evaluated, defined where the differentiated expression has a value.

    The derivative of one column by another has a row for each entry of the former (numerator
    layout).
    """
    variable, printed = meaning.letter(node.by), meaning.side(node.of)
    columns = variable, printed
    are_columns = all(isinstance(x, sp.MatrixBase) and x.shape[1] == 1 for x in columns)
    if node.is_partial and node.order == 1 and are_columns:
        entries = [[_differentiate(meaning, node, y, x) for x in variable] for y in printed]
        return sp.ImmutableMatrix(entries)
    return _differentiate(meaning, node, printed, variable)


def _differentiate(meaning: Meaning, node: tree.Derivation, printed: Any, variable: Any) -> Any:
    is_given = variable in meaning.values and not node.is_partial
    if is_given and (along := meaning.parameters.get(variable)):
        return _differentiate_along(meaning, node, printed, variable, along)
    if not isinstance(variable, sp.Symbol) or is_given:
        by = meaning.source.latex[node.by.start : node.by.end]
        raise meaning.source.refuse(
            node.by.start, f"a derivative with respect to {by}, which is not a free letter"
        )
    if not isinstance(printed, sp.MatrixBase):
        printed = meaning.take_number(node.of, printed)
    moving = {} if node.is_partial else meaning.moving
    depends_on = {variable, *(s for steps, _ in list_steps(variable, moving) for s in steps)}
    needed = settle(printed, meaning.values, {s: s for s in depends_on - meaning.values.keys()})
    value = needed.replace(ValueWhere, lambda inner, _: inner)
    is_unknown = not node.is_partial or isinstance(value, sp.Symbol)
    is_unknown &= not (node.is_partial and _moves_by_rates(meaning, value, variable))
    if value.free_symbols and not depends_on & value.free_symbols and is_unknown:
        raise meaning.source.refuse(
            node.of.start,
            f"{variable} does not appear in the differentiated expression: does that depend on it?",
            _advise_dependence(meaning, node),
        )
    unsmooth = value.atoms(*UNSMOOTH) - value.atoms(sp.atan2)
    if any(depends_on & part.free_symbols for part in unsmooth):
        raise meaning.source.refuse(
            node.of.start,
            "a derivative of a function with kinks or steps is not read",
            "Choose a side of them, and print the function without them.",
        )
    if isinstance(needed, sp.MatrixBase):
        return needed.applyfunc(lambda x: _give_rate(meaning, node, x, variable, depends_on))
    return _give_rate(meaning, node, needed, variable, depends_on)


def _advise_dependence(meaning: Meaning, node: tree.Derivation) -> str:
    """Return advice on declaring that the differentiated expression depends on the letter."""
    latex = meaning.source.latex[node.start : node.end]
    if latex.endswith("'"):
        return "Print the derivatives of the letters that depend on it: u' next to u."
    letters = [part.text for part in tree.walk(node.of) if isinstance(part, tree.Letter)]
    says = meaning.remedies.depends.format(letters[-1], node.by.text)
    return f"{'' if node.is_partial else f'{says} '}{meaning.remedies.name.format(latex)}"


def _differentiate_along(
    meaning: Meaning, node: tree.Derivation, printed: sp.Expr, variable: sp.Symbol, along: sp.Symbol
) -> sp.Expr:
    """Return the derivative dy/dx of a curve y(t), x(t), defined where x(t) is not stationary."""
    needed, place = (settle_all(part, meaning.values) for part in (printed, variable))
    value = needed.replace(ValueWhere, lambda inner, _: inner)
    unsmooth = [*value.atoms(*UNSMOOTH, *OF_SIGNS), *place.atoms(*UNSMOOTH, *OF_SIGNS)]
    if not (isinstance(node.order, int) and value.has(along)) or unsmooth:
        raise meaning.source.refuse(
            node.start, f"a derivative with respect to {variable} along {along} is not read here"
        )
    for _ in range(node.order):
        value = sp.diff(value, along) / sp.diff(place, along)
    return DerivativeWhere(value, needed)


def _give_rate(
    meaning: Meaning,
    node: tree.Derivation,
    needed: sp.Expr,
    variable: sp.Symbol,
    depends_on: set[sp.Basic],
) -> sp.Expr:
    """Return the derivative of a scalar, defined where the scalar and its moduli have values.

    For the angle of (x, y), that point must not lie on the negative x-axis, where it jumps.
    """
    value = needed.replace(ValueWhere, lambda inner, _: inner)
    turning = {part.args[0] for part in value.atoms(*OF_SIGNS) if depends_on & part.free_symbols}
    for number in sorted(turning, key=sp.default_sort_key):
        needed = ValueWhere(needed, 1 / number)
    moving = {} if node.is_partial else meaning.moving
    if not isinstance(node.order, int):
        return DerivativeWhere(_give_any(meaning, node.order, value, variable, depends_on), needed)
    try:
        for _ in range(node.order):
            value = value.replace(sp.sign, lambda number: number / sp.Abs(number))
            value = differentiate(value, variable, moving)
    except ValueError as error:
        raise meaning.source.refuse(node.start, str(error)) from error
    angles = (one.args for one in needed.atoms(sp.atan2) if depends_on & one.free_symbols)
    ahead = [sp.sqrt(x**2 + y**2) + x for y, x in sorted(angles, key=str)]
    return reduce(ValueWhere, map(sp.log, ahead), DerivativeWhere(value, needed))


def _give_any(
    meaning: Meaning,
    printed: tree.Node,
    value: sp.Expr,
    variable: sp.Symbol,
    depends_on: set[sp.Basic],
) -> sp.Expr:
    """Return a derivative of symbolic order; only the variable may move in its operand."""
    order = meaning.of(printed)
    if not (order.is_integer and order.is_nonnegative) or order.has(variable):
        raise meaning.source.refuse(
            printed.start, "a derivative of an order that is not whole", meaning.remedies.membership
        )
    if depends_on & value.free_symbols != {variable} or value.has(*OF_SIGNS, sp.atan2):
        raise meaning.source.refuse(
            printed.start, f"a derivative of order {order} with other moving letters, |…| or sgn"
        )
    running = make_running(variable.name, value)
    return NthDerivative(value.xreplace({variable: running}), running, variable, order)


def _moves_by_rates(meaning: Meaning, value: sp.Expr, variable: sp.Symbol) -> bool:
    """Return whether only rates of a letter move in a value, as in a kinetic energy."""
    _, rates = meaning.moving.get(variable, (None, ()))
    moving = {step for one, (_, own) in meaning.moving.items() for step in (one, *own)}
    met = moving & settle_all(value, meaning.values).free_symbols
    return bool(met) and met <= {*rates}
