"""Low word of an angle: the rounding error of a product, kept beside the product.

x = (a/b)*c is rounded to a double before a sine sees it, and where the sine's user is steep that
error, up to eps*|x|, is most of the result's. Two error-free steps recover it.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step
from mechproof.programs.rounding_functions import ProductRest, QuotientRest


def low_word(evaluation: Evaluation) -> Evaluation:
    """Rewrite sin x, cos x -> sin(x + x_low), cos(x + x_low), x_low the rounding error of x.

    For angles c*x, c a number and x a step that is a product of two symbols, of which a quotient
    of symbols has a rest of its own, and of a power of two, which multiplies without rounding.
    Always legal: x + x_low is the product, whatever x is.
    """
    values = dict(evaluation.steps)
    steps: list[Step] = []
    low: dict[sp.Symbol, sp.Symbol] = {}
    for angle in sorted(_angles(evaluation), key=sp.default_sort_key):
        _, x = angle.as_coeff_Mul()
        if x not in low:
            low[x] = _add_rest(x, values, evaluation, steps)

    def add_low(node: sp.Function) -> sp.Function:
        factor, x = node.args[0].as_coeff_Mul()
        return node.func(factor * x + factor * low[x])

    return evaluation.transform(
        lambda e: e.replace(lambda node: isinstance(node, sp.sin | sp.cos), add_low), steps
    )


def low_part(angle: sp.Expr, evaluation: Evaluation) -> sp.Expr:
    """Return the terms of an angle that are low words, 0 if there are none."""
    rests = {symbol for symbol, value in evaluation.steps if value.has(ProductRest)}
    return sp.Add(*(term for term in sp.Add.make_args(angle) if term.free_symbols & rests))


def _angles(evaluation: Evaluation) -> set[sp.Expr]:
    return {node.args[0] for e in evaluation.expressions() for node in e.atoms(sp.sin, sp.cos)}


def _add_rest(
    x: sp.Expr, values: Mapping[sp.Symbol, sp.Expr], evaluation: Evaluation, steps: list[Step]
) -> sp.Symbol:
    """Add the steps of the low word of x and return its name."""
    number, product = values.get(x, sp.S.Zero).as_coeff_Mul()
    if not (product.is_Mul and len(product.args) == 2 and all(a.is_Symbol for a in product.args)):
        raise ValueError(f"low_word: the angle {x} is not a step that multiplies two symbols")
    if not (number > 0 and sp.log(number, 2).is_integer):
        raise ValueError(f"low_word: the angle {x} has a factor {number}, not a power of two")
    one, other = product.args
    rest = ProductRest(one, other, x / number)
    for factor, partner in ((one, other), (other, one)):
        above, below = sp.fraction(values.get(factor, factor))
        if below != 1:
            factor_rest = QuotientRest(above, below, factor)
            rest += evaluation.add_step(f"{factor}_low", factor_rest, steps) * partner
    return evaluation.add_step(f"{x}_low", number * rest, steps)
