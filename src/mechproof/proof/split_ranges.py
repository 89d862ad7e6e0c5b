"""Statements on parts of a range: beside an excluded number or an edge, and within a period."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.proof.cases import fix, narrow
from mechproof.record.parts import TURNING, find_free
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

# Returns the name of the rung that proves a relation on a domain, or None.
Prove = Callable[[sp.Basic, Domain], str | None]


def prove_on_parts(relation: sp.Basic, domain: Domain, prove: Prove) -> str | None:
    """Prove a relation below and above an excluded number, on an edge and off it, or in a period.

    Return the name of the rung.
    """
    split = (_split_at_hole, _split_at_edge, _list_period)
    parts: list[Domain] = next(filter(None, (one(relation, domain) for one in split)), [])
    rungs = [prove(relation, part) for part in parts]
    return None if None in rungs else next(iter(rungs), None)


def _split_at_hole(relation: sp.Basic, domain: Domain) -> list[Domain]:
    for hole in domain.where:
        if isinstance(hole, sp.Ne) and hole.lhs in find_free(relation) and hole.rhs.is_number:
            rest = replace(domain, where=tuple(said for said in domain.where if said != hole))
            parts = (narrow(rest, kind(hole.lhs, hole.rhs)) for kind in (sp.Lt, sp.Gt))
            return [part for part in parts if part is not None]
    return []


def _split_at_edge(relation: sp.Basic, domain: Domain) -> list[Domain]:
    """Split off the edge x = b of a condition x <= b that ties two letters of one angle."""
    angles = [find_free(wave.args[0]) for wave in relation.atoms(*TURNING)]
    for said in domain.where:
        slack = find_slack(said)
        if slack is None or slack.strict or not any(find_free(said) <= tied for tied in angles):
            continue
        for x in sorted(find_free(said), key=str):
            value = sp.expand(slack.value)
            slope = value.coeff(x)
            others = value - slope * x
            if slope.is_number and slope != 0 and others.free_symbols and not others.has(x):
                rest = replace(domain, where=tuple(one for one in domain.where if one != said))
                inside = replace(rest, where=(*rest.where, sp.Gt(value, 0)))
                return [inside, fix(rest, {x: -others / slope})]
    return []


def _list_period(relation: sp.Basic, domain: Domain) -> list[Domain]:
    """Return the domain on which the only letter runs from 0 to its period, rounded up.

    The list is empty if `list_periods` finds none.
    """
    return [
        part.with_set(x, sp.Interval(0, sp.ceiling(part.set_of(x).end)))
        for part in list_periods(relation.args, domain)[:1]
        for x in find_free(relation)
    ]


def list_periods(sides: Sequence[sp.Expr], domain: Domain) -> list[Domain]:
    """List the domains on which the only letter runs over a period, from 0 and about 0.

    The list is empty unless the letter may be any real number and no condition contains it.
    """
    letters = {letter for side in sides for letter in find_free(side)}
    coupled = {letter for said in domain.where for letter in find_free(said)}
    if len(letters) != 1 or letters & coupled:
        return []
    (x,) = letters
    period = _find_period(sides, x) if domain.set_of(x) == sp.S.Reals else None
    if period is None:
        return []
    runs = sp.Interval(0, period), sp.Interval(-period / 2, period / 2)
    return [domain.with_set(x, run) for run in runs]


def _find_period(sides: Sequence[sp.Expr], x: sp.Symbol) -> sp.Expr | None:
    """Return a number by which x may grow without changing the sides, None if none is found."""
    slopes = (sp.diff(w.args[0], x).as_coeff_Mul() for side in sides for w in side.atoms(*TURNING))
    steps = {abs(step) for step, rest in slopes if step != 0 and rest.is_integer}
    for step in sorted(steps):
        for turn in (sp.pi / step, 2 * sp.pi / step):
            moved = (side.subs(x, x + turn) for side in sides)
            if all(sp.expand(a) == sp.expand(b) for a, b in zip(sides, moved, strict=True)):
                return turn
    return None
