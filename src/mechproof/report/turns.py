"""Turns: what is stated of the error of a position in its tenth turn, in radians."""

from __future__ import annotations

import math

import sympy as sp
from markupsafe import Markup

from mechproof.record import Paper, PublishedSizes, Quantity, Toleranced
from mechproof.report.phrases import set_prose

# The turn in which the stated bound of a position is told in radians, and the places tried in it.
TURNS, PLACES = 10, 360


def goes_on(quantity: Quantity) -> bool:
    """Return whether it is a position that goes on turn by turn."""
    running = quantity.arguments[0]
    return quantity.period is not None and quantity.unit == running.unit == "rad"


def tell_turned(quantity: Quantity, paper: Paper) -> Markup:
    """Tell in radians what is stated of a position in its tenth turn, at the published sizes."""
    if quantity.accuracy is None or not goes_on(quantity):
        return Markup()
    scale = quantity.accuracy.scale
    size = scale.written_out() if scale else sp.Abs(quantity.definition)
    for symbol, value in reversed(paper.given.items()):
        size = size.xreplace({symbol: value})
    errors = {
        table.source: quantity.accuracy.ulp * 2.0**-52 * largest
        for table in paper.published
        if (largest := _find_largest(size, quantity, table)) is not None
    }
    if not errors:
        return Markup()
    label = max(errors, key=lambda name: errors[name])
    return set_prose(f"in the tenth turn at most {errors[label]:.1e} rad, at the sizes of {label}")


def _find_largest(size: sp.Expr, quantity: Quantity, table: PublishedSizes) -> float | None:
    """Return the largest value in the tenth turn; None where a size or a function is missing."""
    running, *others = quantity.arguments
    sizes = {a.symbols[0]: table.sizes.get(a.symbols[0], a.default) for a in others}
    if any(value is None or isinstance(value, Toleranced) for value in sizes.values()):
        return None
    exact = {symbol: sp.sympify(given) for symbol, given in sizes.items()}
    value = sp.lambdify(running.symbols[0], size.xreplace(exact), "math")
    turns = (TURNS - 1 + place / PLACES for place in range(1, PLACES + 1))
    try:
        return max(float(value(2 * math.pi * turn)) for turn in turns)
    except (ArithmeticError, NameError, TypeError, ValueError):
        return None
