"""Coefficients of affine maps as named steps."""

from __future__ import annotations

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step, entries, map_entries


def name_coefficients(evaluation: Evaluation) -> Evaluation:
    """Name each coefficient of entries affine in a common set of inputs as a step C_ij.

    The coefficients have the shape of the other inputs, so a pose is computed once for all points.
    """
    rows = entries(evaluation.output)
    linear = _affine_inputs(evaluation.inputs, rows)
    steps: list[Step] = []
    named = []
    for i, row in enumerate(rows, start=1):
        rest = row.xreplace(dict.fromkeys(linear, sp.S.Zero))
        for j, variable in enumerate(linear, start=1):
            coefficient = sp.diff(row, variable)
            # A lone function or symbol stays in place: a name would only hide it.
            if isinstance(coefficient, sp.Add | sp.Mul):
                coefficient = evaluation.add_step(f"C{i}{j}", coefficient, steps)
            rest += coefficient * variable
        named.append(rest)
    output = iter(named)
    return evaluation.rearrange(
        (*evaluation.steps, *steps),
        map_entries(lambda _: next(output), evaluation.output),
    )


def _affine_inputs(inputs: frozenset[sp.Basic], rows: tuple[sp.Expr, ...]) -> list[sp.Symbol]:
    """Return the inputs in which all rows are jointly affine, in the order of their names."""
    candidates = sorted((s for s in inputs if isinstance(s, sp.Symbol)), key=str)
    slopes = {s: [sp.diff(row, s) for row in rows] for s in candidates}
    flat = [s for s in candidates if not any(d.has(s) for d in slopes[s])]
    joint = [s for s in flat if not any(d.has(other) for d in slopes[s] for other in flat)]
    # An input whose coefficients are all numbers has none to name.
    return [s for s in joint if not all(d.is_number for d in slopes[s])]
