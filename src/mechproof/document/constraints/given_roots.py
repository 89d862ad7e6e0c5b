"""Roots whose values follow from constraints, such as the length of a unit vector."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from mechproof.record.parts import find_roots


def put_in_roots(
    residual: sp.Expr, given: Mapping[str, sp.Expr]
) -> tuple[sp.Expr, dict[str, sp.Expr]]:
    """Replace roots in a residual by the numbers that constraints give them.

    Returns the residual and, by name, the constraints used; the numbers hold wherever these do.
    """
    values: dict[sp.Expr, sp.Expr] = {}
    used: dict[str, sp.Expr] = {}
    for base in list_radicands([residual]):
        for name, other in given.items():
            number = _find_number(base, other)
            if number is not None and number.is_positive:
                powers = (p for p in residual.atoms(sp.Pow) if p.base == base)
                values |= {power: number**power.exp for power in powers}
                used[name] = other
                break
    return residual.xreplace(values), used


def list_radicands(values: Iterable[sp.Expr]) -> list[sp.Expr]:
    """Return the distinct radicands that contain letters."""
    found = {root.base for value in values for root in find_roots(value)}
    return sorted((base for base in found if base.free_symbols), key=sp.default_sort_key)


def _find_number(base: sp.Expr, constraint: sp.Expr) -> sp.Expr | None:
    """Return the number that an expression equals where a constraint holds, None if not seen."""
    root, name = sp.sqrt(base), sp.Dummy()
    if constraint.has(root):
        slope = sp.diff(constraint.xreplace({root: name}), name)
        length = sp.expand(root - constraint / slope) if slope.is_number and slope != 0 else root
        return length**2 if length.is_positive and length.is_number else None
    letters = sorted(base.free_symbols, key=str)
    if constraint.free_symbols != {*letters}:
        return None
    above = sp.numer(sp.together(constraint))
    if not (base.is_polynomial(*letters) and above.is_polynomial(*letters)):
        return None
    one, other = (sp.Poly(side, *letters).LC() for side in (base, above))
    rest = sp.expand(base - one / other * above)
    return rest if rest.is_number else None
