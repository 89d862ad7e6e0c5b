"""Angles: sines and cosines by tan(x/2), cosines by their distance from one, and low words.

1 - cos x as 2*sin(x/2)**2 is the navigators' versine: its digits do not cancel near zero.

x = (a/b)*c is rounded to a double before its sine is taken, and where the result depends steeply on
the angle, that error, up to eps*|x|, dominates. Two error-free steps recover it. Likewise for the
three roundings of (1 - e1)*(1 - e2) where a result depends on a high power of it: each leaves a
rest that is a double, and the sum of the rests is added before the last rounding.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from functools import partial
from operator import methodcaller

import sympy as sp

from mechproof.arithmetic.polynomials import cancel
from mechproof.programs.evaluation import Evaluation, Step, map_entries
from mechproof.programs.rewrites.factored_sums import Factors, is_negative_sum
from mechproof.programs.rounding_functions import (
    ArctanQuotient,
    ProductRest,
    QuotientRest,
    SmallArctan,
    SmallTangent,
    SumRest,
    TangentQuotient,
)
from mechproof.programs.step_names import suggest_name


def low_word(evaluation: Evaluation) -> Evaluation:
    """Rewrite sin x, cos x -> sin(x + x_low), cos(x + x_low), x_low the rounding error of x.

    For angles c*x, c a number and x a step that is the product of two symbols and possibly a power
    of two, which multiplies exactly. A factor that is a step with a quotient adds its own rest.
    Always legal: x + x_low is the product, however x is rounded.
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


def low_sum(evaluation: Evaluation) -> Evaluation:
    """Rewrite (c + a)*b -> (b*c + x_low) + x for a step x = a*b with a low word.

    The rounding of x does not count then, nor that of a if the low word has its rest. Always legal:
    x + x_low is the product.
    """
    steps: list[Step] = []
    words = {
        frozenset(rest.args[:2]): (rest.args[2], symbol)
        for symbol, value in evaluation.steps
        for rest in value.atoms(ProductRest)
        if rest.args[2].is_Symbol
    }

    def convert(node: sp.Expr) -> sp.Expr:
        for a, b in node.args, reversed(node.args):
            for term in a.args if a.is_Add else ():
                if word := words.get(frozenset({term, b})):
                    x, low = word
                    rest = b * (a - term) + low
                    return x + evaluation.add_step(suggest_name(rest, "rest"), rest, steps)
        return node

    return evaluation.convert_parts(lambda n: n.is_Mul and len(n.args) == 2, convert, steps)


def low_part(angle: sp.Expr, evaluation: Evaluation) -> sp.Expr:
    """Return the sum of an angle's terms that are low words; 0 if there are none."""
    rests = {symbol for symbol, value in evaluation.steps if value.has(ProductRest)}
    return sp.Add(*(term for term in sp.Add.make_args(angle) if term.free_symbols & rests))


def _add_rest(
    x: sp.Expr, values: Mapping[sp.Symbol, sp.Expr], evaluation: Evaluation, steps: list[Step]
) -> sp.Symbol:
    """Add the steps of the low word of x; return its symbol, ValueError if x has none."""
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
    """Rewrite steps (c + x)*(d + y) -> p + p_low, p_low being the rests of p and of its factors.

    Legal for numbers c and d with |x| <= |c|, |y| <= |d|: then the rests of the factors are
    doubles. Their product, below eps**2*p, is omitted, so p + p_low is as good as rounded once.
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
    """Add the steps of a rounded sum and of its rest; return their symbols."""
    high = evaluation.add_step(suggest_name(factor, "factor"), factor, steps)
    rest = SumRest(*factor.as_coeff_Add(), high)
    return high, evaluation.add_step(f"{high}_low", rest, steps)


def _split_product(
    name: sp.Symbol, factors: list[Pair], evaluation: Evaluation, steps: list[Step]
) -> sp.Expr:
    """Add the steps of a rounded product and of its rest; return their sum."""
    (a, a_low), (b, b_low) = factors
    high = evaluation.add_step(f"{name}_high", a * b, steps)
    rest = ProductRest(a, b, high) + a_low * b + a * b_low
    return high + evaluation.add_step(f"{name}_low", rest, steps)


def half_angle_tangent(evaluation: Evaluation) -> Evaluation:
    """Rewrite quotients in sin x, cos x as quotients in t = tan(x/2).

    Numerator and denominator are polynomials in t with factored coefficients. Exact for every x
    except odd multiples of pi, where the value is the limit t -> oo; no double is an odd multiple
    of pi. Each term of an outermost sum is converted separately.

    For an angle with a low word, t = opposite/adjacent by the tangent of a sum, and the polynomials
    are homogeneous in both sides: adjacent may vanish, and neither cancels where it matters.
    """
    for angle in evaluation.list_angles(sp.sin, sp.cos):
        factors = Factors(evaluation)
        opposite, adjacent = _halve(angle, evaluation, factors)
        convert = partial(
            _to_tangent, angle=angle, opposite=opposite, adjacent=adjacent, factors=factors
        )
        evaluation = evaluation.transform(convert, factors.steps)
    return evaluation


def _halve(
    angle: sp.Expr, evaluation: Evaluation, factors: Factors
) -> tuple[sp.Symbol, sp.Symbol | sp.Integer]:
    """Add the steps of tan(angle/2); return its two sides, which are t and 1 without a low word."""
    add = partial(evaluation.add_step, steps=factors.steps)
    low = low_part(angle, evaluation)
    t = add("t", sp.tan((angle - low) / 2))
    if not low:
        return t, sp.S.One
    t_low = add("t_low", SmallTangent(low / 2))
    return add("opposite", t + t_low), add("adjacent", 1 - t * t_low)


def _to_tangent(
    expression: sp.Expr,
    angle: sp.Expr,
    opposite: sp.Symbol,
    adjacent: sp.Symbol | sp.Integer,
    factors: Factors,
) -> sp.Expr:
    square = opposite**2 + adjacent**2
    circle = {
        sp.sin(angle): 2 * opposite * adjacent / square,
        sp.cos(angle): (adjacent**2 - opposite**2) / square,
    }
    if not expression.has(*circle):
        return expression
    sides = [side for side in (opposite, adjacent) if side.is_Symbol]
    inner = expression.xreplace(circle)
    if expression.is_Add or not inner.is_rational_function(*sides):
        converted = (_to_tangent(a, angle, opposite, adjacent, factors) for a in expression.args)
        return expression.func(*converted)
    above, below = (factors.by_powers(p, *sides) for p in cancel(inner))
    return -above / -below if is_negative_sum(below) else above / below


def small_arc(evaluation: Evaluation) -> Evaluation:
    """Rewrite atan(c*t/(a + b*t**2)) -> SmallArctan(TangentQuotient(y, c, a, r, b)), t = tan y.

    A step a that adds a term to a number has the rest r of its rounding, others 0: it is added
    where the denominator is rounded anyway. Legal for a, b > 0 and c**2 <= 4*a*b/3: the argument
    of atan stays within +-1/sqrt(3), as a + b*t**2 >= 2*sqrt(a*b)*|t|.
    """
    values = dict(evaluation.steps)
    tangents = {s: v.args[0] for s, v in evaluation.steps if isinstance(v, sp.tan)}
    steps: list[Step] = []
    legal: list[sp.Basic] = []

    def convert(argument: sp.Expr) -> sp.Expr:
        above, below = sp.fraction(argument)
        for t, y in tangents.items():
            c, (a, none, b) = above / t, (below.coeff(t, power) for power in range(3))
            if not none and not c.has(t) and sp.expand(a + b * t**2 - below) == 0:
                legal.extend([a > 0, b > 0, sp.Le(c**2, 4 * a * b / 3)])
                number, term = values.get(a, sp.S.Zero).as_coeff_Add()
                rest: sp.Expr = sp.S.Zero
                if number and term:
                    legal.append(sp.Le(sp.Abs(term), abs(number)))
                    rest = evaluation.add_step(f"{a}_low", SumRest(number, term, a), steps)
                angle = _halve_factor(y, values, evaluation, steps)
                return SmallArctan(TangentQuotient(angle, c, a, rest, b))
        return sp.atan(argument)

    return evaluation.transform(lambda e: e.replace(sp.atan, convert), steps).oblige(legal)


def _halve_factor(
    angle: sp.Expr, values: Mapping[sp.Symbol, sp.Expr], evaluation: Evaluation, steps: list[Step]
) -> sp.Expr:
    """Return x/2 as (k/2)*a where x is a step k*a and k another: k/2 may serve for many a."""
    number, x = angle.as_coeff_Mul()
    known = [factor for factor in sp.Mul.make_args(values.get(x, x)) if factor in values]
    if number != sp.S.Half or len(known) != 1:
        return angle
    half = evaluation.add_step(f"half_{known[0]}", known[0] / 2, steps)
    return half * (values[x] / known[0])


def quotient_arc(evaluation: Evaluation) -> Evaluation:
    """Rewrite atan(a/b) -> ArctanQuotient(a, b); legal where b > 0."""
    legal: list[sp.Basic] = []

    def convert(argument: sp.Expr) -> sp.Expr:
        above, below = sp.fraction(argument)
        if below.is_number:
            return sp.atan(argument)
        legal.extend(_state_positive(below, evaluation))
        return ArctanQuotient(above, below)

    return evaluation.transform(lambda e: e.replace(sp.atan, convert)).oblige(legal)


def _state_positive(total: sp.Expr, evaluation: Evaluation) -> list[sp.Basic]:
    """List relations that make a sum positive; for squared sides of a tangent, its coefficients.

    The sides t + u and 1 - t*u do not vanish together: the squares add up to (1 + t**2)(1 + u**2).
    """
    named = {value: symbol for symbol, value in evaluation.steps}
    lows = [symbol for symbol, value in evaluation.steps if isinstance(value, SmallTangent)]
    tangents = [symbol for symbol, value in evaluation.steps if isinstance(value, sp.tan)]
    for t, u in itertools.product(tangents, lows):
        sides = [named[value] for value in (t + u, 1 - t * u) if value in named]
        shares = [total.coeff(side, 2) for side in sides]
        squares = sp.Add(*(c * side**2 for c, side in zip(shares, sides, strict=True)))
        if len(sides) == 2 and sp.expand(total - squares) == 0:
            return [share > 0 for share in shares]
    return [total > 0]


def cosine_minus_one(evaluation: Evaluation) -> Evaluation:
    """Rewrite cos x -> 1 + cosm1_x with cosm1_x = -2*sin(x/2)**2, cancelling ones symbolically.

    Exact for every real x. A sum whose number cancels is expanded; elsewhere the cosine is a
    step, 1 + cosm1_x.
    """
    angles = evaluation.list_angles(sp.cos)
    small = {x: evaluation.new_symbol(f"cosm1_{suggest_name(x, otherwise='x')}") for x in angles}
    cosines = {x: evaluation.new_symbol(f"cos_{suggest_name(x, otherwise='x')}") for x in angles}
    steps: list[Step] = [(small[x], -2 * sp.sin(x / 2) ** 2) for x in angles]
    steps += [(cosines[x], 1 + small[x]) for x in angles]
    return evaluation.transform(lambda e: _cancel_ones(e, small, cosines), steps)


def _cancel_ones(
    expression: sp.Expr, small: Mapping[sp.Expr, sp.Symbol], cosines: Mapping[sp.Expr, sp.Symbol]
) -> sp.Expr:
    if isinstance(expression, sp.cos):
        return cosines[expression.args[0]]
    if not expression.has(sp.cos):
        return expression
    if expression.is_Add and expression.as_coeff_Add()[0]:
        expanded = sp.expand(expression.xreplace({sp.cos(x): 1 + m for x, m in small.items()}))
        if not expanded.as_coeff_Add()[0]:
            return expanded
    return expression.func(*(_cancel_ones(a, small, cosines) for a in expression.args))


def positive_atan2(evaluation: Evaluation) -> Evaluation:
    """Rewrite atan2(y, x) -> atan(y/x); legal where x > 0."""
    found = {node for e in evaluation.expressions() for node in e.atoms(sp.atan2)}
    positive = [sp.Gt(node.args[1], 0) for node in sorted(found, key=sp.default_sort_key)]
    changed = evaluation.transform(lambda e: e.replace(sp.atan2, lambda y, x: sp.atan(y / x)))
    return changed.oblige(positive)
