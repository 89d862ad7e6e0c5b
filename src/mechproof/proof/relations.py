"""Whether an inequality holds: the rungs that tell, cheapest first."""

from __future__ import annotations

import sympy as sp

from mechproof.proof import bisection, inductive_inequalities, newton, taylor
from mechproof.proof.bisection import holds_on_interval
from mechproof.proof.cases import decide_by_pieces, write_pieces
from mechproof.proof.domain import Domain
from mechproof.proof.inductive_inequalities import holds_by_steps
from mechproof.proof.inequalities import show_sign
from mechproof.proof.signs import is_nonzero, is_shown
from mechproof.proof.taylor import holds_near_zero
from mechproof.record.relations import find_slack

SIGN = "sign in positive coordinates"


def prove_relation(relation: sp.Basic, domain: Domain) -> str | None:
    """Return the rung that proves an inequality wherever its sides have values, None for none."""
    if newton.converges(relation, domain):
        return newton.RUNG
    if holds_near_zero(relation, domain):
        return taylor.RUNG
    if holds_on_interval(relation, domain):
        return bisection.RUNG
    if _holds_by_sign(relation, domain):
        return SIGN
    slack = find_slack(relation)
    if slack is None:
        return None
    if holds_by_steps(slack, domain, show_sign):
        return inductive_inequalities.RUNG
    return _hold_by_cases(relation, domain) or show_sign(slack, domain)


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
