"""Running: steps in doubles as they are computed, and without any rounding in balls."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from flint import arb

from mechproof.codegen.program import CONSTANTS, Operand, Program
from mechproof.kernel_support import error_free
from mechproof.kernel_support.polynomials import PI, PI_LOW
from mechproof.proof.balls import to_ball
from mechproof.roundoff.fused import fma
from mechproof.roundoff.steps import CONSTANT, Straight

Values = dict[str, Any]
Table = Mapping[str, Callable[..., Any]]
ENDLESS = MappingProxyType({"#inf": np.inf})


def find_number(operand: Operand) -> Any:
    """Return the number that a constant's operand stands for."""
    return CONSTANTS[operand] if isinstance(operand, str) else operand


def _take_half_turns_off(y: Any) -> Any:
    turns = np.rint(y * (1 / np.pi))
    return (y - turns * PI) - turns * PI_LOW


ARITHMETIC: Table = MappingProxyType(
    {
        "add": lambda a, b: a + b,
        "subtract": lambda a, b: a - b,
        "multiply": lambda a, b: a * b,
        "divide": lambda a, b: a / b,
        "negate": lambda a: -a,
        "square": lambda a: a * a,
        "absolute": abs,
        "copy": lambda a: a,
        "approximate": lambda a: a,
    }
)
IN_DOUBLES: Table = MappingProxyType(
    {
        **ARITHMETIC,
        "number": np.float64,
        CONSTANT: lambda operand: np.float64(float(find_number(operand))),
        "fma": fma,
        "pi_off": _take_half_turns_off,
        "product_rest": error_free.product_rest,
        "quotient_rest": error_free.quotient_rest,
        "small_tangent": error_free.small_tangent,
        **{
            kind: getattr(np, kind)
            for kind in (
                *("rint", "copysign"),
                *("sqrt", "hypot", "tan", "arctan", "sin", "cos", "maximum", "minimum", "floor"),
                *("less", "less_equal", "greater", "greater_equal", "equal"),
            )
        },
        "is_finite": np.isfinite,
        "choose": np.where,
        "both": np.logical_and,
        "either": np.logical_or,
    }
)
IN_BALLS: Table = MappingProxyType(
    {
        **ARITHMETIC,
        "number": arb,
        CONSTANT: lambda operand: to_ball(find_number(operand)),
        "fma": lambda a, b, c: a * b + c,
        "pi_off": lambda a: a,
        "product_rest": lambda a, b, p: a * b - p,
        "quotient_rest": lambda a, b, q: a / b - q,
        "small_tangent": arb.tan,
        "sqrt": arb.sqrt,
        "hypot": lambda a, b: (a**2 + b**2).sqrt(),
        "tan": arb.tan,
        "arctan": arb.atan,
        "sin": arb.sin,
        "cos": arb.cos,
        "maximum": arb.max,
        "minimum": arb.min,
        "floor": arb.floor,
    }
)


def run(straight: Straight | Program, given: Mapping[str, Any], table: Table) -> tuple[Any, ...]:
    """Return the outputs at the values of the inputs; `table` computes each kind, and numbers."""
    values: Values = {**ENDLESS, **given}
    steps = straight.operations if isinstance(straight, Program) else straight.steps

    def look_up(operand: Operand) -> Any:
        return values[operand] if isinstance(operand, str) else table["number"](operand)

    for step in steps:
        operands = step.operands if step.kind == CONSTANT else map(look_up, step.operands)
        values[step.result] = table[step.kind](*operands)
    return tuple(map(look_up, straight.outputs))
