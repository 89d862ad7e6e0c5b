"""Definitions: the formula of a quantity and what its letters are given by, for its page.

And turns: what is stated of the error of a position in its tenth turn, in radians.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import sympy as sp
from markupsafe import Markup

from mechproof.codegen.docstrings import find_given
from mechproof.proof.comparison_latex import write_latex, write_letter
from mechproof.record import Paper, PublishedSizes, Quantity, Toleranced
from mechproof.report.formulas import write_block, write_lines
from mechproof.report.phrases import set_prose


def write_definition(quantity: Quantity, paper: Paper) -> Markup:
    """Write the formula behind the letter that it gives, or the name of the function."""
    definition, given = quantity.definition, paper.given
    printed = {v.symbol for v in paper.variables if v.latex}
    names = [s for s, value in given.items() if value == definition and s in printed]
    if definition in given:
        names = [definition] if definition in printed else names
        definition = given[definition]
    arguments = ",".join(
        write_letter(symbol, paper.variables, [quantity.definition])
        for a in quantity.arguments
        for symbol in a.symbols
    )
    name = quantity.name.replace("_", r"\_")
    left = write_latex(names[0], paper.variables) if names else rf"\mathrm{{{name}}}({arguments})"
    return write_lines(f"{left}={write_latex(_take_in(definition), paper.variables)}")


def _take_in(formula: sp.Basic) -> sp.Basic:
    """Take exponentials that stand before integrals into them, where they may cancel."""
    return formula.replace(
        lambda part: part.is_Mul and any(isinstance(f, sp.Integral) for f in part.args), _join
    )


def _join(product: sp.Mul) -> sp.Expr:
    factors = product.args
    (integral,) = (f for f in factors if isinstance(f, sp.Integral))
    taken = sp.Mul(*(f for f in factors if isinstance(f, sp.exp)))
    others = sp.Mul(*(f for f in factors if not isinstance(f, sp.exp | sp.Integral)))
    joined = sp.powsimp(taken * integral.function, combine="exp")
    return others * sp.Integral(joined, *integral.limits)


def write_given(quantity: Quantity, paper: Paper) -> Iterator[Markup]:
    """Write the symbols that the formula needs and that others give."""
    for symbol in find_given(quantity.definition, quantity, paper):
        sides = (write_latex(side, paper.variables) for side in (symbol, paper.given[symbol]))
        yield write_block(" = ".join(sides))


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
