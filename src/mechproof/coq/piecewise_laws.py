"""Relations with laws by pieces -> one relation for every choice of pieces, with its conditions."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from sympy.core.relational import Relational

from mechproof.coq.terms import UnwritableError
from mechproof.record.parts import find_parts, replace_parts

# A relation, and the conditions under which its pieces are the ones that hold.
Case = tuple[sp.Basic, tuple[sp.Basic, ...]]


def list_cases(relation: sp.Basic, known: tuple[sp.Basic, ...] = ()) -> Iterator[Case]:
    """Yield the cases of a relation; one whose conditions contradict each other is none.

    A piece holds where its condition does and those of the pieces before it do not; where none
    does, the law has no value. Raises `UnwritableError` for a condition that is no comparison.
    """
    laws = find_parts(relation, sp.Piecewise)
    inner = [law for law in laws if not find_parts(sp.Tuple(*law.args), sp.Piecewise)]
    if not inner:
        yield relation, known
        return
    law = min(inner, key=sp.default_sort_key)
    before: list[sp.Basic] = []
    for value, condition in law.args:
        new = [*before] if condition is sp.true else [*before, _turn(condition)]
        conditions = tuple(dict.fromkeys((*known, *new)))
        if not any(_negate(c) in conditions for c in conditions):
            yield from list_cases(_put(relation, law, value), conditions)
        if condition is sp.true:
            return
        before.append(_negate(_turn(condition)))


def _put(relation: sp.Basic, law: sp.Piecewise, value: sp.Basic) -> sp.Basic:
    """Put a piece for a law in both sides, which may become the same."""
    sides = (replace_parts(side, {law: value}) for side in relation.args)
    return relation.func(*sides, evaluate=False)


def _turn(condition: sp.Basic) -> sp.Basic:
    """Write a condition with the smaller side first, so that equal ones are seen to be so."""
    if not isinstance(condition, Relational) or isinstance(condition, sp.Eq | sp.Ne):
        raise UnwritableError(f"a piece under the condition {condition} is not written")
    if isinstance(condition, sp.Gt | sp.Ge):
        return condition.reversed
    return condition


def _negate(condition: sp.Basic) -> sp.Basic:
    """Return where a condition with the smaller side first is not so, written likewise."""
    kind = sp.Le if isinstance(condition, sp.Lt) else sp.Lt
    return kind(condition.args[1], condition.args[0], evaluate=False)
