"""Definitions: the formula of a quantity and what its letters are given by, for its page."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from markupsafe import Markup

from mechproof.codegen.docstrings import find_given
from mechproof.proof.comparison_latex import write_latex, write_letter
from mechproof.record import Paper, Quantity
from mechproof.report.formulas import write_block, write_lines


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
