"""Half-angle rewrites: sines and cosines by tan(x/2), and cosines by their distance from one.

1 - cos x as 2*sin(x/2)**2 is the versine of navigators: its digits do not cancel near zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import sympy as sp

from mechproof.arithmetic.polynomials import cancel
from mechproof.programs.evaluation import Evaluation, Step
from mechproof.programs.rewrites.factored_sums import Factors, is_negative_sum
from mechproof.programs.rewrites.low_word import low_part
from mechproof.programs.rounding_functions import SmallArctan, SmallTangent, TangentQuotient
from mechproof.programs.step_names import suggest_name


def half_angle_tangent(evaluation: Evaluation) -> Evaluation:
    """Rewrite quotients in sin x, cos x as quotients in t = tan(x/2).

    Numerator and denominator are polynomials in t with factored coefficients. Exact for every x
    but odd multiples of pi, where the limit t -> oo is the value; no double is an odd multiple of
    pi. Each term of an outermost sum is converted by itself.

    An angle with a low word has t = opposite/adjacent by the tangent of a sum, and the
    polynomials are homogeneous in both: adjacent may vanish, and neither cancels where it counts.
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
    """Add the steps of tan(angle/2) and return its two sides, t and 1 without a low word."""
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
    """Rewrite atan(c*t/(a + b*t**2)) -> SmallArctan(c*TangentQuotient(y, a, b)) for t = tan y.

    Legal for a, b > 0 and c**2 <= 4*a*b/3: the argument of atan stays within +-1/sqrt(3),
    as a + b*t**2 >= 2*sqrt(a*b)*|t|.
    """
    tangents = {s: v.args[0] for s, v in evaluation.steps if isinstance(v, sp.tan)}
    legal: list[sp.Basic] = []

    def convert(argument: sp.Expr) -> sp.Expr:
        above, below = sp.fraction(argument)
        for t, y in tangents.items():
            c, (a, none, b) = above / t, (below.coeff(t, power) for power in range(3))
            if not none and not c.has(t) and sp.expand(a + b * t**2 - below) == 0:
                legal.extend([a > 0, b > 0, sp.Le(c**2, 4 * a * b / 3)])
                return SmallArctan(c * TangentQuotient(y, a, b))
        return sp.atan(argument)

    return evaluation.transform(lambda e: e.replace(sp.atan, convert)).oblige(legal)


def cosine_minus_one(evaluation: Evaluation) -> Evaluation:
    """Rewrite cos x -> 1 + cosm1_x with cosm1_x = -2*sin(x/2)**2, ones cancelled before evaluation.

    Exact for every real x. A sum with a number that cancels is expanded; elsewhere the cosine
    is one step, 1 + cosm1_x.
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
