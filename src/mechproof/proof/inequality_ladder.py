"""Whether an inequality holds: the rungs that tell, cheapest first."""

from __future__ import annotations

from itertools import product

import sympy as sp

from mechproof.proof import bisection, bounds_near_zero, inductive_inequalities, newton
from mechproof.proof.bisection import holds_on_interval
from mechproof.proof.bounds_near_zero import holds_near_zero
from mechproof.proof.cases import decide_by_pieces, write_pieces
from mechproof.proof.floors import leave_fractions
from mechproof.proof.inductive_inequalities import holds_by_steps
from mechproof.proof.inequalities import show_sign
from mechproof.proof.signs import is_nonzero, is_shown
from mechproof.record.relations import find_slack
from mechproof.record.substitution import write_steps
from mechproof.statement_domains.domain import Domain

SIGN = "sign in positive coordinates"
# Of powers of negative numbers to counts: so many are looked at.
_MOST_TURNS = 2


def prove_relation(relation: sp.Basic, domain: Domain) -> str | None:
    """Return the rung that proves an inequality wherever its sides have values, None for none."""
    if (cases := _list_turns(relation)) is not None:
        left = [case for case in cases if case != sp.true]
        rungs = [None if case == sp.false else prove_relation(case, domain) for case in left]
        return None if None in rungs else next(iter(rungs), SIGN)
    slack = find_slack(relation)
    if slack and relation.has(sp.floor, sp.ceiling):
        left, part = leave_fractions(write_steps(slack.value), domain)
        if is_shown(slack._replace(value=left), part):
            return SIGN
    if newton.converges(relation, domain):
        return newton.RUNG
    if holds_near_zero(relation, domain):
        return bounds_near_zero.RUNG
    if holds_on_interval(relation, domain):
        return bisection.RUNG
    if _holds_by_sign(relation, domain):
        return SIGN
    if slack is None:
        return None
    if holds_by_steps(slack, domain, show_sign):
        return inductive_inequalities.RUNG
    return _hold_by_cases(relation, domain) or show_sign(slack, domain)


def _list_turns(relation: sp.Basic) -> list[sp.Basic] | None:
    """Write powers of negative numbers to counts, (-2)^n, as 2^n and as its opposite.

    Whichever sign each has, one of the relations returned says the same; None without such powers.
    """
    powers = [p for p in relation.atoms(sp.Pow) if p.base.is_negative and p.exp.free_symbols]
    if not 0 < len(powers) <= _MOST_TURNS or not all(p.exp.is_integer for p in powers):
        return None
    signs = product((1, -1), repeat=len(powers))
    sizes = [(-p.base) ** p.exp for p in powers]
    return [
        relation.xreplace(
            {p: sign * size for p, sign, size in zip(powers, one, sizes, strict=True)}
        )
        for one in signs
    ]


def _hold_by_cases(relation: sp.Basic, domain: Domain) -> str | None:
    """Prove an inequality for each sign of what stands in moduli."""
    slack = find_slack(relation)
    if slack is None or (written := write_pieces(slack.value)) == slack.value:
        return None

    def prove(value: sp.Expr, zero: sp.Expr, part: Domain) -> str | None:
        if value.has(sp.Piecewise):
            return decide_by_pieces((value, zero), part, prove)
        return SIGN if is_shown(slack._replace(value=value), part) else None

    return prove(written, sp.S.Zero, domain)


def _holds_by_sign(relation: sp.Basic, domain: Domain) -> bool:
    if isinstance(relation, sp.Unequality):
        return is_nonzero(relation.lhs - relation.rhs, domain)
    slack = find_slack(relation)
    return slack is not None and is_shown(slack, domain)
