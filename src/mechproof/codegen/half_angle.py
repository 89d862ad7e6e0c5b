"""Half-angle rewrites: sines and cosines by tan(x/2), and cosines by their distance from one."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import sympy as sp

from mechproof.codegen.evaluation import Evaluation, Step
from mechproof.codegen.names import suggest_name
from mechproof.codegen.products import Factors


def half_angle_tangent(evaluation: Evaluation) -> Evaluation:
    """Rewrite quotients in sin x, cos x as quotients in t = tan(x/2).

    Numerator and denominator are polynomials in t with factored coefficients. Exact for every x
    but odd multiples of pi, where the limit t -> oo is the value; no double is an odd multiple of
    pi. Each term of an outermost sum is converted by itself.
    """
    for angle in _angles(evaluation, (sp.sin, sp.cos)):
        t = evaluation.new_symbol("t")
        factors = Factors(evaluation)
        factors.steps.append((t, sp.tan(angle / 2)))
        convert = partial(_to_tangent, angle=angle, t=t, factors=factors)
        evaluation = evaluation.transform(convert, factors.steps)
    return evaluation


def _to_tangent(expression: sp.Expr, angle: sp.Expr, t: sp.Symbol, factors: Factors) -> sp.Expr:
    circle = {
        sp.sin(angle): 2 * t / (1 + t**2),
        sp.cos(angle): (1 - t**2) / (1 + t**2),
    }
    if not expression.has(*circle):
        return expression
    inner = expression.xreplace(circle)
    if expression.is_Add or not inner.is_rational_function(t):
        converted = (_to_tangent(a, angle, t, factors) for a in expression.args)
        return expression.func(*converted)
    numerator, denominator = sp.fraction(sp.cancel(inner))
    return factors.by_powers(numerator, t) / factors.by_powers(denominator, t)


def cosine_minus_one(evaluation: Evaluation) -> Evaluation:
    """Rewrite cos x -> 1 + cosm1_x with cosm1_x = -2*sin(x/2)**2, ones cancelled before evaluation.

    Exact for every real x. A sum with a number that cancels is expanded; elsewhere the cosine
    is one step, 1 + cosm1_x.
    """
    angles = _angles(evaluation, (sp.cos,))
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


def _angles(evaluation: Evaluation, functions: tuple[type[sp.Function], ...]) -> list[sp.Expr]:
    expressions = [value for _, value in evaluation.steps] + [evaluation.output]
    found = {node.args[0] for e in expressions for node in e.atoms(*functions)}
    return sorted(found, key=sp.default_sort_key)
