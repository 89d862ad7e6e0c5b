"""Integrals of what is given by pieces: cut where a condition, a modulus or a floor changes."""

from __future__ import annotations

from itertools import pairwise

import sympy as sp
from sympy.core.relational import Relational

from mechproof.proof.cases import IN_PIECES, assume, write_pieces
from mechproof.proof.coordinates import parametrise
from mechproof.proof.half_angles import find_sign_there
from mechproof.proof.improper import list_zeros_between
from mechproof.proof.polynomial_signs import StrictSign
from mechproof.proof.signs import is_positive
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

_BY_PIECES = (*IN_PIECES, sp.Piecewise, sp.floor)
# Work limit: steps of a floor between the limits.
_MOST_STEPS = 64


def has_pieces(integrand: sp.Expr, variable: sp.Symbol) -> bool:
    """Tell whether an integrand is given by pieces in the variable."""
    return any(node.has(variable) for node in integrand.atoms(*_BY_PIECES))


def cut_at_seams(integral: sp.Integral, domain: Domain) -> list[sp.Integral]:
    """Cut an integral where one condition or floor changes; nothing where that is not shown."""
    integrand, (variable, lower, upper) = integral.args
    written = _write(integrand, variable)
    if (floor := _find_floor(written, variable)) is not None:
        return _cut_at_steps(written, floor, integral.limits[0])
    condition = _find_condition(written, variable)
    if condition is None:
        return []
    inner = condition.gts - condition.lts
    cuts = [lower, *_list_zeros(inner, variable, lower, upper, domain), upper]
    parts = []
    for start, end in pairwise(cuts):
        sign = _find_sign_between(inner, variable, start, end, domain)
        if sign is None:
            return []
        part = assume(written, condition, holds=sign.direction > 0)
        parts.append(sp.Integral(part, (variable, start, end)))
    return [] if any(part.has(sp.nan) for part in parts) else parts


def integrate_polynomials(integral: sp.Integral) -> sp.Expr | None:
    """Return the value by pieces that are polynomials on both sides of one place.

    What is zero there on both sides and has the integrand as its derivative is continuous, so that
    the limits may lie in any order. None for another integrand.
    """
    integrand, (variable, lower, upper) = integral.args
    written = _write(integrand, variable)
    condition = _find_condition(written, variable)
    if condition is None or lower.is_infinite or upper.is_infinite:
        return None
    inner = condition.gts - condition.lts
    slope = sp.diff(inner, variable)
    pieces = [assume(written, condition, holds=holds) for holds in (True, False)]
    is_plain = all(piece.is_polynomial(variable) and not piece.has(sp.nan) for piece in pieces)
    if not is_plain or slope == 0 or not slope.is_number:
        return None
    place = sp.expand(variable - inner / slope)
    grown = [sp.Poly(piece, variable).integrate().as_expr() for piece in pieces]
    above, below = (whole - whole.subs(variable, place) for whole in grown)
    value = sp.Piecewise((above, condition), (below, True))
    return value.subs(variable, upper) - value.subs(variable, lower)


def _write(integrand: sp.Expr, variable: sp.Symbol) -> sp.Expr:
    """Write moduli, signs, largest and smallest numbers that have the variable by pieces.

    What a sign is of is zero at single places, where the integrand does not count.
    """
    nodes = [node for node in integrand.atoms(*IN_PIECES) if node.has(variable)]
    numbers = {node.args[0] for node in nodes if isinstance(node, sp.sign)}
    single = {n for n in numbers if n.is_polynomial(variable) and n.free_symbols == {variable}}
    return integrand.xreplace({node: write_pieces(node, single) for node in nodes})


def _find_floor(integrand: sp.Expr, variable: sp.Symbol) -> sp.Expr | None:
    floors = (node for node in integrand.atoms(sp.floor) if node.has(variable))
    return min(floors, key=sp.default_sort_key, default=None)


def _cut_at_steps(written: sp.Expr, floor: sp.Expr, limits: sp.Tuple) -> list[sp.Integral]:
    """Cut at the steps of a floor of what is linear, between numbers."""
    variable, lower, upper = limits
    inner, slope = floor.args[0], sp.diff(floor.args[0], variable)
    ends = sorted((inner.subs(variable, end) for end in (lower, upper)), key=sp.default_sort_key)
    if slope == 0 or not all(number.is_Rational for number in (slope, *ends)):
        return []
    low, high = sorted(ends)
    if high - low > _MOST_STEPS:
        return []
    wholes = range(int(sp.floor(low)) + 1, int(sp.ceiling(high)))
    steps = [sp.cancel(variable + (whole - inner) / slope) for whole in wholes]
    parts = []
    for start, end in pairwise([lower, *sorted(steps), upper]):
        value = sp.floor(inner.subs(variable, (start + end) / 2))
        parts.append(sp.Integral(written.xreplace({floor: value}), (variable, start, end)))
    return parts


def _find_condition(written: sp.Expr, variable: sp.Symbol) -> Relational | None:
    """Return a condition of the variable that holds no pieces itself, None for none."""
    pieces = written.atoms(sp.Piecewise)
    found = {c for piece in pieces for _, cond in piece.args for c in cond.atoms(Relational)}
    plain = (c for c in found if c.has(variable) and not c.has(sp.Piecewise) and find_slack(c))
    return min(plain, key=sp.default_sort_key, default=None)


def _list_zeros(
    inner: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr, domain: Domain
) -> list[sp.Expr]:
    """List zeros between the limits, of what is linear also a letter that is shown to lie there."""
    slope = sp.diff(inner, variable)
    place, run = parametrise(variable, lower, upper)
    moved = sp.expand(inner.subs(variable, place))
    if moved.free_symbols == {variable}:
        zeros = list_zeros_between(moved, variable, run.start, run.end)
        return [place.subs(variable, zero) for zero in zeros]
    if slope == 0 or slope.has(variable):
        return []
    zero = sp.cancel(variable - inner / slope)
    gaps = (gap for gap in (zero - lower, upper - zero) if gap.is_infinite is not True)
    return [zero] if all(is_positive(gap, domain) for gap in gaps) else []


def _find_sign_between(
    inner: sp.Expr, variable: sp.Symbol, start: sp.Expr, end: sp.Expr, domain: Domain
) -> StrictSign | None:
    place, run = parametrise(variable, start, end)
    moved = sp.expand(inner.subs(variable, place))
    return find_sign_there(moved, domain.with_set(variable, run.interior))
