"""Coordinate sums: in, steps and a chart; out, sums and differences of arguments in coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import sympy as sp

from mechproof.programs.operations import SYMBOLIC
from mechproof.record import Chart
from mechproof.roundoff.steps import EXACT, StraightLineProgram

POLYNOMIAL = ("add", "subtract", "multiply", "square", "negate")


def add_up(
    straight: StraightLineProgram, chart: Chart, names: Mapping[sp.Basic, str]
) -> Mapping[str, sp.Expr]:
    """Return the sums of arguments and numbers, written in coordinates.

    What cancels there, 1 - e for e = 1 - d, does so before balls are put in.
    """
    values = {names[symbol]: value for symbol, value in chart.arguments.items()}
    sums: dict[str, sp.Expr] = {}
    for step in straight.steps:
        given = [values.get(o) if isinstance(o, str) else sp.Rational(o) for o in step.operands]
        if step.kind in POLYNOMIAL and all(value is not None for value in given):
            value = _factor(SYMBOLIC[step.kind](*given))
            if step.kind in ("add", "subtract"):
                sums[step.result] = value
            if step.ulps == EXACT:
                values[step.result] = value
    return sums


@cache
def _factor(value: sp.Expr) -> sp.Expr:
    """Factor a sum; the ways of computing a form have the same ones."""
    return sp.factor(value)
