"""Values of symbols that are given by others: what depends on what, and putting them in."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import partial
from itertools import count, pairwise
from typing import Any

import sympy as sp

Values = Mapping[sp.Basic, sp.Basic]
Moving = Mapping[sp.Basic, tuple[sp.Basic, tuple[sp.Basic, ...]]]
# Functions with kinks or steps, of which SymPy gives a derivative everywhere; of the first two
# there is one where the argument is not zero.
OF_SIGNS = (sp.Abs, sp.sign)
UNSMOOTH = (sp.Max, sp.Min, sp.Piecewise, sp.floor, sp.ceiling, sp.atan2)
# Of angles with whole numbers n, for SymPy 1.14 takes tan(x + pi*(n + 1/2)) for tan(x).
QUOTIENTS: Mapping[Any, Callable[[sp.Expr], sp.Expr]] = {
    sp.tan: lambda angle: sp.sin(angle) / sp.cos(angle),
    sp.cot: lambda angle: sp.cos(angle) / sp.sin(angle),
}


def depends(symbol: sp.Basic, on: Collection[sp.Basic], values: Values) -> bool:
    """Return whether a symbol is one of these, or is given by them."""
    return not list_reached({symbol}, values).isdisjoint(on)


def list_reached(symbols: Collection[sp.Basic], values: Values) -> set[sp.Basic]:
    """Return symbols and those by which they are given."""
    met, new = set[sp.Basic](), set(symbols)
    while new:
        met |= new
        given = (values.get(symbol) for symbol in new)
        new = {s for one in given if one is not None for s in one.free_symbols} - met
    return met


def settle_all(expression: Any, values: Values) -> Any:
    """Put in all values that are given, also those within values."""
    for _ in range(len(values) + 1):
        if not expression.free_symbols & values.keys():
            break
        expression = expression.xreplace(dict(values))
    return expression


def has_counts(value: sp.Basic) -> bool:
    """Tell whether whole numbers are in an expression."""
    return any(symbol.is_integer for symbol in value.free_symbols)


def split_tangents(expression: Any, put_in: Iterable[sp.Basic]) -> Any:
    """Return an expression into which values are put in safely, whole numbers among them."""
    if any(map(has_counts, put_in)):
        for tangent, quotient in QUOTIENTS.items():
            expression = expression.replace(tangent, quotient)
    return expression


def settle(expression: Any, values: Values, changed: Values) -> Any:
    """Put in new values, also where the symbol is hidden in one that is given by it."""
    for _ in range(len(values) + 1):
        hidden = {
            symbol: values[symbol]
            for symbol in expression.free_symbols - changed.keys()
            if symbol in values and depends(symbol, changed.keys(), values)
        }
        if not hidden:
            return split_tangents(expression, changed.values()).xreplace(dict(changed))
        expression = expression.xreplace(hidden)
    raise ValueError(f"symbols are given in a circle: {sorted(map(str, hidden))}")


def list_steps(by: sp.Basic, moving: Moving) -> Iterator[tuple[tuple[sp.Basic, ...], sp.Basic]]:
    """Yield letters that move with another, each with its derivatives and what these are times.

    That is the speed of the letter by which they are, where it moves with the other itself.
    """
    for symbol, (other, rates) in moving.items():
        carrier, speeds = moving.get(other, (None, ()))
        if by in (other, carrier):
            yield (symbol, *rates), sp.S.One if other == by else speeds[0]


def differentiate(value: Any, by: sp.Basic, moving: Moving) -> Any:
    """Return the derivative of a value by a letter, also through the letters that depend on it.

    Raises `ValueError` for a derivative of a higher order than the letters have symbols for.
    """
    total = value.diff(by)
    met = value.free_symbols
    for steps, speed in list_steps(by, moving):
        for one, derivative in pairwise(steps):
            if one in met:
                total += value.diff(one) * derivative * speed
        if steps[-1] in met:
            raise ValueError(f"no symbol is declared for the derivative of {steps[-1]} by {by}")
    # SymPy writes x^(a - 1) as x^a/x, which has no value at zero for any a.
    return total.replace(_is_power_product, partial(sp.powsimp, combine="exp"))


def _is_power_product(node: sp.Basic) -> bool:
    return isinstance(node, sp.Mul) and any(
        isinstance(factor, sp.Pow) and factor.exp.free_symbols for factor in node.args
    )


def is_root(part: sp.Expr) -> bool:
    """Return whether an expression is a root."""
    return isinstance(part, sp.Pow) and bool(part.exp.is_positive and not part.exp.is_integer)


def name_turns(expression: sp.Expr) -> sp.Expr:
    """Let powers of negative numbers be real: SymPy takes (-1)^(n(n+1)/2) for imaginary."""
    powers = (p for p in expression.atoms(sp.Pow) if p.base.is_negative and p.exp.free_symbols)
    return expression.xreplace({power: sp.Dummy("turn", real=True) for power in powers})


def make_running(name: str, inside: Any, *, counts: bool = False) -> sp.Dummy:
    """Return a bound variable that nothing within is, the same one at each reading."""
    met, kind = inside.atoms(sp.Dummy), {"integer": True} if counts else {"real": True}
    numbered = (sp.Dummy(f"{name}_", dummy_index=n, **kind) for n in count())
    return next(dummy for dummy in numbered if dummy not in met)
