"""Rung: an inequality of two angles whose sum is bounded, such as those of a triangle.

With their sum s and their difference d, a number that is linear in the cosine of d, or of a part of
it, is least at an end of the cosine's range: where the angles are equal, or where one of them is
zero. There it depends on s alone.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy.simplify.fu import TR8

from mechproof.record import Slack
from mechproof.record.parts import CIRCULAR
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

RUNG = "difference of two angles"
_S, _D, _C = (sp.Dummy(name, real=True) for name in "sdc")
# Work limit: operations of a number.
_LARGEST = 60


def holds_at_ends(
    slack: Slack, domain: Domain, show: Callable[[Slack, Domain], str | None]
) -> bool:
    """Return whether a sign is shown for equal angles, and where one of them is zero."""
    value = domain.resolve(slack.value)
    angles = sorted(value.free_symbols, key=str)
    waves = value.atoms(sp.sin, sp.cos)
    if (
        len(angles) != 2
        or value.count_ops() > _LARGEST
        or len(waves) != len(value.atoms(*CIRCULAR))
    ):
        return False
    sets = [domain.set_of(angle) for angle in angles]
    if not all(isinstance(run, sp.Interval) and run.start == 0 for run in sets):
        return False
    bounds = [found for found in map(find_slack, domain.where) if found]
    sums = [one for one in bounds if sp.expand(one.value - sp.pi + sp.Add(*angles)) == 0]
    if not sums or (parts := _write_by_cosine(value, angles)) is None:
        return False
    is_open = all(run.left_open for run in sets)
    inside = Domain({_S: sp.Interval(0, sp.pi, is_open, sums[0].strict)}, (), {})
    ends = zip(parts, (slack.strict, slack.strict and not is_open), strict=True)
    return all(show(Slack(there, strict), inside) for there, strict in ends)


def _write_by_cosine(value: sp.Expr, angles: list[sp.Expr]) -> tuple[sp.Expr, sp.Expr] | None:
    """Return what a number is for equal angles, and where one is zero; None if it is not linear."""
    written = value.subs(dict(zip(angles, ((_S + _D) / 2, (_S - _D) / 2), strict=True)))
    while (other := sp.expand(TR8(sp.expand(written)))) != written:
        written = other
    parts = {abs(sp.diff(wave.args[0], _D)) for wave in written.atoms(sp.sin, sp.cos)} - {0}
    if len(parts) != 1 or not (part := parts.pop()).is_number or part > 1:
        return None
    turned = sp.expand(sp.expand_trig(written.subs(_D, _D / part))).subs(sp.cos(_D), _C)
    if turned.has(_D) or not turned.is_polynomial(_C) or sp.degree(turned, _C) > 1:
        return None
    return turned.subs(_C, 1), turned.subs(_C, sp.cos(part * _S))
