"""Low word of a product of sums: (1 - e1)*(1 - e2) rounded once instead of three times.

Where a function goes with a high power of such a product, its three roundings are most of the
function's error. Each leaves a rest that is a double; their sum is added before the last rounding.
"""

from __future__ import annotations

from operator import methodcaller

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step, map_entries
from mechproof.programs.rounding_functions import ProductRest, SumRest
from mechproof.programs.step_names import suggest_name

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
