"""What a proof rewrites first: derivatives become their values, factorials those of one number."""

from __future__ import annotations

from typing import Any

import sympy as sp

from mechproof.record import ValueWhere

_FARTHEST = 20


def prepare(expression: Any) -> Any:
    """Return an expression that is equal wherever both have values."""
    if not expression.has(ValueWhere, sp.factorial):
        return expression
    plain = expression.replace(ValueWhere, lambda value, needed: value)
    shifts = {node: node.args[0].as_coeff_Add() for node in plain.atoms(sp.factorial)}
    return plain.xreplace(
        {
            node: _extend(rest, int(shift))
            for node, (shift, rest) in shifts.items()
            if shift.is_Integer and abs(shift) <= _FARTHEST and rest != 0
        }
    )


def _extend(number: sp.Expr, shift: int) -> sp.Expr:
    """Write (n + k)! by n!."""
    above = sp.prod(number + k for k in range(1, shift + 1))
    below = sp.prod(number - k for k in range(-shift))
    return sp.factorial(number) * above / below
