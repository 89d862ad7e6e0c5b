"""Inequalities on parts of a range: beside a number that a letter is not, and within a period."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from mechproof.proof.cases import narrow
from mechproof.record.parts import TURNING, find_free
from mechproof.statement_domains.domain import Domain

# Names the rung that proves a relation on a domain.
Prove = Callable[[sp.Basic, Domain], str | None]


def prove_on_parts(relation: sp.Basic, domain: Domain, prove: Prove) -> str | None:
    """Prove a relation below and above a number that is left out, or within a period."""
    parts = _split_at_hole(relation, domain) or _list_period(relation, domain)
    rungs = [prove(relation, part) for part in parts]
    return None if None in rungs else next(iter(rungs), None)


def _split_at_hole(relation: sp.Basic, domain: Domain) -> list[Domain]:
    for hole in domain.where:
        if isinstance(hole, sp.Ne) and hole.lhs in find_free(relation) and hole.rhs.is_number:
            rest = replace(domain, where=tuple(said for said in domain.where if said != hole))
            parts = (narrow(rest, kind(hole.lhs, hole.rhs)) for kind in (sp.Lt, sp.Gt))
            return [part for part in parts if part is not None]
    return []


def _list_period(relation: sp.Basic, domain: Domain) -> list[Domain]:
    """Return numbers from zero to beyond the period of the only letter, which may be any number."""
    letters = find_free(relation)
    coupled = {letter for said in domain.where for letter in find_free(said)}
    if len(letters) != 1 or letters & coupled:
        return []
    (x,) = letters
    period = find_period(relation, x) if domain.set_of(x) == sp.S.Reals else None
    return [] if period is None else [domain.with_set(x, sp.Interval(0, sp.ceiling(period)))]


def find_period(relation: sp.Basic, x: sp.Symbol) -> sp.Expr | None:
    """Return a number by which a letter may grow without a change, None if none is found."""
    steps = {sp.diff(wave.args[0], x) for wave in relation.atoms(*TURNING)}
    for step in sorted(abs(step) for step in steps if step.is_Rational and step != 0):
        for turn in (sp.pi / step, 2 * sp.pi / step):
            sides = zip(relation.args, relation.subs(x, x + turn).args, strict=True)
            if all(sp.expand(one) == sp.expand(other) for one, other in sides):
                return turn
    return None
