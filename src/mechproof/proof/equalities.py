"""Whether two scalars are equal: the rungs that tell, cheapest first."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.antiderivative import decide_by_derivative
from mechproof.proof.cases import (
    decide_by_pieces,
    decide_by_values,
    decide_from_zero,
    decide_from_zero_base,
    list_poles,
    write_pieces,
)
from mechproof.proof.definedness import list_necessary, list_unshown, narrow_to
from mechproof.proof.floors import decide_by_floors
from mechproof.proof.induction import decide_by_induction, decide_by_quotients
from mechproof.proof.integral_recurrences import decide_by_parts
from mechproof.proof.integrals import decide_by_antiderivative
from mechproof.proof.inverses import ROOT, decide_by_inverse
from mechproof.proof.powers import decide_by_logarithms, split_powers
from mechproof.proof.refutation import are_seen_to_differ
from mechproof.proof.roots_of_squares import take_signs, write_roots
from mechproof.proof.separation import decide_by_separation
from mechproof.proof.telescoping import decide_by_telescoping
from mechproof.proof.vector_angles import decide_by_argument
from mechproof.proof.wave_sums import decide_by_steps
from mechproof.record.parts import ENDLESS, has_parts
from mechproof.record.substitution import write_steps
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare, take_values

IDENTICAL = "identical"


def _decide_by_split_powers(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Prove sides equal whose powers of a base, x^n and x^(n - 1), are written by one of them."""
    difference = left - right
    split = split_powers(difference)
    return None if split == difference else decide_equal(split, sp.S.Zero, domain)


_FIRST = (
    decide_equal,
    _decide_by_split_powers,
    decide_by_argument,
    decide_by_separation,
    decide_by_derivative,
    decide_by_logarithms,
    decide_by_induction,
)
_LAST = (decide_by_quotients, decide_by_inverse, decide_by_telescoping, decide_by_floors)


def prove_equal(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> str | None:
    """Return the rungs that prove sides equal wherever both have values, None for none."""
    printed, rebuilt = (write_steps(take_values(side)) for side in (printed, rebuilt))
    if printed == rebuilt:
        return IDENTICAL
    if has_parts(printed, sp.Piecewise) or has_parts(rebuilt, sp.Piecewise):
        return decide_by_pieces((printed, rebuilt), domain, prove_equal)
    sides = printed, rebuilt = prepare(printed), prepare(rebuilt)
    if found := decide_from_zero(sides, domain, prove_equal):
        return found
    found = next(filter(None, (rung(*sides, domain) for rung in _FIRST)), None)
    is_slow = any(has_parts(side, *ENDLESS) for side in sides)
    if not found and not is_slow and are_seen_to_differ(sides, domain):
        return None
    found = found or decide_by_antiderivative(*sides, domain, prove_equal)
    found = found or decide_by_parts(*sides, domain, prove_equal)
    found = found or decide_by_steps(*sides, domain, prove_equal)
    found = found or decide_by_values(sides, domain, prove_equal)
    found = found or decide_from_zero_base(sides, domain, prove_equal)
    found = found or _prove_by_cases(sides, domain)
    found = found or next(filter(None, (rung(*sides, domain) for rung in _LAST)), None)
    return found or _prove_by_squares(sides, domain)


def prove_where_defined(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> str | None:
    """Prove sides equal where what roots, logarithms and so on of both need is given."""
    sides = take_values(printed), take_values(rebuilt)
    necessary = {need for side in sides for need in list_necessary(domain.resolve(side))}
    unshown = [need for side in sides for need in list_unshown(side, domain)]
    part = narrow_to(domain, [need for need in unshown if need in necessary])
    return prove_equal(*sides, part) if part not in (None, domain) else None


def _prove_by_squares(sides: Sequence[sp.Expr], domain: Domain) -> str | None:
    """Prove sides equal whose roots of squares are written by moduli."""
    letters = {letter for side in sides for letter in side.free_symbols}
    one, other = (write_roots(side, letters, domain) for side in sides)
    if (one, other) == tuple(sides):
        return None
    rest = prove_equal(take_signs(one, domain), take_signs(other, domain), domain)
    return f"{ROOT}, {rest}" if rest else None


def _prove_by_cases(sides: Sequence[sp.Expr], domain: Domain) -> str | None:
    """Prove sides equal for each sign of what stands in moduli."""
    poles = list_poles(sides)
    # SymPy raises it where a condition compares what may be complex.
    with suppress(TypeError):
        one, other = (write_pieces(side, poles) for side in sides)
        return None if (one, other) == tuple(sides) else prove_equal(one, other, domain)
    return None
