"""Signs of expressions in positive coordinates: of quotients of polynomials, by half angles."""

from __future__ import annotations

import sympy as sp

from mechproof.proof.coordinates import (
    Coordinates,
    free_tangents,
    list_angles,
    name_absolute_values,
    name_positive,
    write_by_cosines,
    write_by_half_angles,
)
from mechproof.proof.polynomial_signs import StrictSign, sign_of_quotient
from mechproof.record.parts import replace_parts


def find_sign_in(coordinates: Coordinates, expression: sp.Expr) -> StrictSign | None:
    """Return the sign of an expression whose letters the coordinates replace, if it shows."""
    expression = name_positive(expression, coordinates)
    changed = free_tangents(expression)
    # Gaps are chained, as in R3 < R2 < R1, so replacements may contain letters to be replaced.
    for _ in range(3):
        changed = replace_parts(changed, coordinates.replacement)
        if not changed.free_symbols & coordinates.replacement.keys():
            break
    radicands = {p.base for p in expression.atoms(sp.Pow) if not p.exp.is_integer}
    if any(_may_hide_sign(base, coordinates) for base in radicands):
        return None
    changed = name_absolute_values(changed, coordinates)
    sign = _sign_by_half_angles(changed, coordinates)
    return sign if sign else sign_of_quotient(write_by_cosines(changed)[0], coordinates)


def _may_hide_sign(radicand: sp.Expr, coordinates: Coordinates) -> bool:
    """Return whether a factor of a radicand may be negative where another one is zero.

    SymPy takes the other factor out of the root, as if the rest had a root there, too.
    """
    factors = sp.Mul.make_args(radicand.xreplace(coordinates.replacement))
    may_vanish = any(factor in coordinates.nonnegative for factor in factors)
    return may_vanish and not all(factor.is_nonnegative for factor in factors)


def _sign_by_half_angles(expression: sp.Expr, coordinates: Coordinates) -> StrictSign | None:
    """Return the sign by half-angle tangents; they miss the half turn, which is checked apart."""
    sign = sign_of_quotient(write_by_half_angles(expression), coordinates)
    if sign is None or not sign.strict:
        return sign
    for angle in list_angles(expression):
        there = expression.subs({sp.sin(angle): 0, sp.cos(angle): -1, sp.tan(angle): 0})
        if there.has(sp.nan, sp.zoo):
            continue
        at_half_turn = _sign_by_half_angles(there, coordinates)
        if at_half_turn is None or not at_half_turn.strict:
            return StrictSign(sign.direction, False)
    return sign
