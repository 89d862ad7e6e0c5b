"""Rewriting ahead of a proof: conditions are dropped, and related factorials share one number."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.core.relational import Relational

from mechproof.record import ValueWhere
from mechproof.record.parts import find_parts, has_parts
from mechproof.record.substitution import write_sums_out

# Work limit: factors written out between two factorials.
_FARTHEST = 20


def take_values(expression: Any) -> Any:
    """Return an expression without the conditions for its parts to have values."""
    if not has_parts(expression, ValueWhere):
        return expression
    if isinstance(expression, Relational):
        return expression.func(*map(take_values, expression.args), evaluate=False)
    return expression.replace(ValueWhere, lambda value, needed: value)


def prepare(expression: Any) -> Any:
    """Return a rewritten expression, equal to the given one wherever both have values."""
    plain = write_sums_out(take_values(expression))
    if has_parts(plain, sp.gamma):
        plain = plain.replace(sp.gamma, _write_gamma)
    shifts = {node: node.args[0].as_coeff_Add() for node in find_parts(plain, sp.factorial)}
    return plain.xreplace(
        {
            node: _extend(rest, int(shift))
            for node, (shift, rest) in shifts.items()
            if shift.is_Integer and abs(shift) <= _FARTHEST and rest != 0
        }
    )


def _write_gamma(argument: sp.Expr) -> sp.Expr:
    """Write gamma(u) by gamma of u's letters, without a minus, plus a number from 0 to 1."""
    shift, rest = argument.as_coeff_Add()
    if argument.is_integer:
        return sp.factorial(argument - 1)
    if rest == 0 or not shift.is_Rational or abs(shift) > _FARTHEST:
        return sp.gamma(argument)
    whole = int(sp.floor(shift))
    base, turned = rest + shift - whole, 1 - rest - shift + whole
    value = sp.gamma(base)
    if rest.could_extract_minus_sign():
        shown = sp.gamma(turned) if shift != whole else -rest * sp.gamma(-rest)
        value = sp.pi / (sp.sin(sp.pi * base) * shown)
    above = sp.prod(base + k for k in range(whole))
    below = sp.prod(base - k for k in range(1, 1 - whole))
    return value * above / below


def _extend(number: sp.Expr, shift: int) -> sp.Expr:
    """Write (n + k)! by n!."""
    above = sp.prod(number + k for k in range(1, shift + 1))
    below = sp.prod(number - k for k in range(-shift))
    return sp.factorial(number) * above / below
