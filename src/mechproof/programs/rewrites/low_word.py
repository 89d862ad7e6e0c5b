"""Low words: the rounding error of an angle, and of a product of sums, kept beside it.

x = (a/b)*c is rounded to a double before a sine sees it, and where the sine's user is steep that
error, up to eps*|x|, is most of the result's. Two error-free steps recover it. So are the three
roundings of (1 - e1)*(1 - e2) where a function goes with a high power of it: each leaves a rest
that is a double, and their sum is added before the last rounding.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import methodcaller

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step, map_entries
from mechproof.programs.rounding_functions import ProductRest, QuotientRest, SumRest
from mechproof.programs.step_names import suggest_name


def low_word(evaluation: Evaluation) -> Evaluation:
    """Rewrite sin x, cos x -> sin(x + x_low), cos(x + x_low), x_low the rounding error of x.

    For angles c*x, c a number and x a step that is a product of two symbols, of which a quotient
    of symbols has a rest of its own, and of a power of two, which multiplies without rounding.
    Always legal: x + x_low is the product, whatever x is.
    """
    values = dict(evaluation.steps)
    steps: list[Step] = []
    low: dict[sp.Symbol, sp.Symbol] = {}
    for angle in evaluation.list_angles(sp.sin, sp.cos):
        _, x = angle.as_coeff_Mul()
        if x not in low:
            low[x] = _add_rest(x, values, evaluation, steps)

    def add_low(node: sp.Function) -> sp.Function:
        factor, x = node.args[0].as_coeff_Mul()
        return node.func(factor * x + factor * low[x])

    return evaluation.convert_parts(lambda n: isinstance(n, sp.sin | sp.cos), add_low, steps)


def low_part(angle: sp.Expr, evaluation: Evaluation) -> sp.Expr:
    """Return the terms of an angle that are low words, 0 if there are none."""
    rests = {symbol for symbol, value in evaluation.steps if value.has(ProductRest)}
    return sp.Add(*(term for term in sp.Add.make_args(angle) if term.free_symbols & rests))


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


Pair = tuple[sp.Symbol, sp.Symbol]


def low_product(evaluation: Evaluation) -> Evaluation:
    """Rewrite steps (c + x)*(d + y) -> p + p_low, p_low the rests of p and of its two factors.

    Legal for numbers c and d with |x| <= |c|, |y| <= |d|: then the rests of the factors are
    doubles. Their product is left out, below eps**2*p, so p + p_low is rounded as if once.
    """
    products = {symbol: value for symbol, value in evaluation.steps if _is_product(value)}
    steps: list[Step] = []
    sums = {f: _split_sum(f, evaluation, steps) for p in products.values() for f in p.args}
    split = {
        symbol: _split_product(symbol, [sums[f] for f in value.args], evaluation, steps)
        for symbol, value in products.items()
    }
    named = {factor: high for factor, (high, _) in sums.items()}
    rest = [(s, split.get(s, value.xreplace(named))) for s, value in evaluation.steps]
    output = map_entries(methodcaller("xreplace", named), evaluation.output)
    legal = [
        sp.Le(sp.Abs(term), abs(number))
        for number, term in (factor.as_coeff_Add() for factor in sorted(sums, key=str))
    ]
    return evaluation.rearrange((*rest, *steps), output).oblige(legal)


def _is_product(value: sp.Expr) -> bool:
    return value.is_Mul and len(value.args) == 2 and all(_is_sum(f) for f in value.args)


def _is_sum(factor: sp.Expr) -> bool:
    number, term = factor.as_coeff_Add()
    return bool(number) and term.as_coeff_Mul()[1].is_Symbol


def _split_sum(factor: sp.Expr, evaluation: Evaluation, steps: list[Step]) -> Pair:
    """Add the steps of a rounded sum and of its rest, and return their names."""
    high = evaluation.add_step(suggest_name(factor, "factor"), factor, steps)
    rest = SumRest(*factor.as_coeff_Add(), high)
    return high, evaluation.add_step(f"{high}_low", rest, steps)


def _split_product(
    name: sp.Symbol, factors: list[Pair], evaluation: Evaluation, steps: list[Step]
) -> sp.Expr:
    """Add the steps of a rounded product and of its rest, and return their sum."""
    (a, a_low), (b, b_low) = factors
    high = evaluation.add_step(f"{name}_high", a * b, steps)
    rest = ProductRest(a, b, high) + a_low * b + a * b_low
    return high + evaluation.add_step(f"{name}_low", rest, steps)
