"""Values by pieces: where pieces end, and whether those that meet there have one value."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp
from sympy.core.relational import Relational

_ORDERS = (sp.Lt, sp.Le, sp.Gt, sp.Ge)


def list_ends(*values: Any) -> list[Relational]:
    """Return the inequalities at which pieces end, each once."""
    pieces = {piece for value in values for piece in value.atoms(sp.Piecewise)}
    found = {
        r.canonical for piece in pieces for _, said in piece.args for r in said.atoms(*_ORDERS)
    }
    return sorted(found, key=str)


def find_end(end: Relational, by: sp.Basic) -> sp.Expr | None:
    """Return where a piece ends along a letter, None where the end is not linear in it."""
    return find_zero(end.lhs - end.rhs, by)


def find_zero(difference: sp.Expr, by: sp.Basic) -> sp.Expr | None:
    """Return where what is linear in a letter is zero, None where it is not linear."""
    difference = sp.expand(difference)
    slope = difference.coeff(by)
    rest = difference - slope * by
    return None if slope == 0 or rest.has(by) else -rest / slope


def has_value(value: Any, by: sp.Basic, point: sp.Expr) -> bool:
    """Return whether a value has one at a point where pieces may end, as far as is seen.

    It has none where the pieces that meet differ, nor where none holds.
    """
    for piece in value.atoms(sp.Piecewise):
        near = [inside for inside, said in piece.args if any(_ends(said, by, point))]
        near += [inside for inside, said in piece.args if said == sp.true and len(near) == 1]
        there = [inside.xreplace({by: point}) for inside in near]
        is_left_out = all(said.xreplace({by: point}) == sp.false for _, said in piece.args)
        if is_left_out or any(sp.simplify(one - there[0]) != 0 for one in there):
            return False
    return True


def list_outer_ends(value: Any, by: sp.Basic) -> Iterator[Relational]:
    """Yield the ends along a letter beyond which no piece lies, if each end belongs to two else."""
    for piece in value.atoms(sp.Piecewise):
        if any(said == sp.true for _, said in piece.args):
            continue
        ends = {r: (find_end(r, by), is_lower(r, by)) for r in list_ends(piece)}
        met = set(ends.values())
        outer = [r for r, (point, low) in ends.items() if (point, not low) not in met]
        if len({ends[r][1] for r in outer}) == len(outer) and all(p is not None for p, _ in met):
            yield from outer


def is_lower(end: Relational, by: sp.Basic) -> bool:
    """Return whether a letter is seen to be larger than an end, else it is taken to be smaller."""
    return bool(sp.expand(end.gts - end.lts).coeff(by).is_positive)


def _ends(said: sp.Basic, by: sp.Basic, point: sp.Expr) -> Iterator[bool]:
    for end in said.atoms(*_ORDERS):
        found = find_end(end, by)
        yield found is not None and sp.expand(found - point) == 0
