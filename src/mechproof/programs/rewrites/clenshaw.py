"""Sums of sines by Clenshaw's recurrence (1955), in doubles or in float32."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step
from mechproof.programs.rewrites.factored_sums import is_sum
from mechproof.programs.rounding_functions import Single, WholeTurnsOff
from mechproof.programs.step_names import suggest_name


def clenshaw(evaluation: Evaluation) -> Evaluation:
    """Rewrite sum of c_m*sin(m*x), m = 1..n -> b_1*sin x, b_m = c_m + 2*cos(x)*b_(m+1) - b_(m+2).

    One sine and one cosine instead of n sines. Always legal: sin((m+1)x) + sin((m-1)x) is
    2*cos(x)*sin(m*x). The coefficients are named c_1 to c_n; a sum has at least two sines.
    """
    steps: list[Step] = []

    def convert(total: sp.Add) -> sp.Expr:
        coefficients, rest = _collect(total)
        if len(coefficients) < 2:
            return total
        (x,) = {angle for angle, _ in coefficients}
        named = {m: evaluation.add_step(f"c_{m}", c, steps) for (_, m), c in coefficients.items()}
        twice = evaluation.add_step("twice_cosine", 2 * sp.cos(x), steps)
        first, second = sp.S.Zero, sp.S.Zero
        for m in range(max(named), 0, -1):
            value = named.get(m, sp.S.Zero) + twice * first - second
            name = value if value.is_Symbol else evaluation.add_step(f"b_{m}", value, steps)
            first, second = name, first
        return sp.Add(*rest) + first * sp.sin(x)

    return evaluation.convert_parts(is_sum, convert, steps)


def _collect(
    total: sp.Add,
) -> tuple[Mapping[tuple[sp.Symbol, int], sp.Expr], list[sp.Expr]]:
    """Split a sum into the coefficients of sines, by angle and multiple, and the other terms."""
    coefficients: dict[tuple[sp.Symbol, int], sp.Expr] = {}
    rest = []
    for term in total.args:
        sines = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.sin)]
        multiple, x = sines[0].args[0].as_coeff_Mul() if len(sines) == 1 else (sp.S.Zero, sp.S.Zero)
        if multiple and multiple.is_Integer and x.is_Symbol:
            coefficients[x, int(multiple)] = term / sines[0]
        else:
            rest.append(term)
    return coefficients, rest


def in_single(evaluation: Evaluation) -> Evaluation:
    """Rewrite sin x, cos x -> sin y, cos y, y being x less whole turns, rounded to float32.

    The coefficients of Clenshaw's recurrence are rounded to float32 too, so that all of it is
    computed in float32. Always legal: the rewrite only changes roundings.
    """
    steps: list[Step] = []
    small = {
        x: evaluation.add_step(
            f"single_{suggest_name(x, 'angle')}", Single(WholeTurnsOff(x)), steps
        )
        for x in evaluation.list_angles(sp.sin, sp.cos)
    }

    def convert(expression: sp.Expr) -> sp.Expr:
        return expression.replace(
            lambda node: isinstance(node, sp.sin | sp.cos),
            lambda node: node.func(small[node.args[0]]),
        )

    rounded = [
        (s, Single(value) if str(s).startswith("c_") else convert(value))
        for s, value in evaluation.steps
    ]
    return evaluation.rearrange((*rounded, *steps), convert(evaluation.output))
