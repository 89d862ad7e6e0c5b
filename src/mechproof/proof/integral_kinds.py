"""Kinds of integrals that are treated before others: improper ones and iterated ones.

Integrals of functions given by pieces are cut where a condition, a modulus or a floor changes.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise

import sympy as sp
from sympy.core.relational import Relational

from mechproof.proof.cases import IN_PIECES, assume, write_pieces
from mechproof.proof.coordinates import parametrise, write_by_sines
from mechproof.proof.growth import find_limit
from mechproof.proof.half_angles import find_sign_there, is_shown_there
from mechproof.proof.polynomial_signs import StrictSign
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.record import Slack
from mechproof.record.parts import CIRCULAR, TURNING
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

_MOST_ZEROS = 12


# A row's rungs ask this repeatedly for the same integrals.
@lru_cache(maxsize=256)
def is_improper(integral: sp.Integral) -> bool:
    """Return whether a limit is infinite, or the integrand has no value there or between them."""
    (variable, *limits), *others = integral.limits
    if others or len(limits) != 2:
        return False
    # A tangent may be infinite where the integrand itself is not: 1/(1 + tan(x)).
    parts = (*sp.Mul.make_args(integral.function), *integral.function.atoms(sp.tan, sp.cot))
    there = (part.subs(variable, limit) for limit in limits for part in parts)
    return (
        any(limit.is_infinite for limit in limits)
        or any(value.has(sp.oo, -sp.oo, sp.zoo, sp.nan) for value in there)
        or bool(list_poles(integral.function, variable, *limits))
    )


def may_reach_zero(integral: sp.Integral, domain: Domain) -> bool:
    """Return whether the base of a power with a non-integer exponent may vanish between limits.

    A ball of such a power involves a root, or a logarithm, of a number that may be negative.
    """
    variable, *limits = integral.limits[0]
    bases = {p.base for p in integral.function.atoms(sp.Pow) if not p.exp.is_integer}
    if len(limits) != 2 or not any(base.has(variable) for base in bases):
        return False
    place, run = parametrise(variable, *limits)
    inside = domain.with_set(variable, run)
    numbers = (base.subs(variable, place) for base in bases if base.has(variable))
    return not all(is_shown_there(Slack(number, True), inside) for number in numbers)


def is_iterated(integral: sp.Integral) -> bool:
    """Return whether an integral has several variables or an integral in its integrand."""
    return len(integral.limits) > 1 or integral.function.has(sp.Integral)


def list_poles(
    integrand: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr
) -> list[sp.Expr]:
    """List the places between the limits where a divisor is zero or a logarithm infinite.

    Between limits with letters, places are found at which the parameter of the path is a number.
    """
    place, ends = variable, (lower, upper)
    if not (lower.is_number and upper.is_number):
        place, run = parametrise(variable, lower, upper)
        integrand, ends = integrand.subs(variable, place), (run.start, run.end)
    divisor = sp.fraction(sp.together(write_by_sines(integrand)))[1]
    below = sp.Mul.make_args(divisor if place == variable else sp.factor_terms(divisor))
    bases = [factor.as_base_exp()[0] for factor in below]
    bases += [logarithm.args[0] for logarithm in integrand.atoms(sp.log)]
    bases = [base.args[0] if isinstance(base, sp.Abs) else base for base in bases]
    poles = {zero for base in bases for zero in list_zeros_between(base, variable, *ends)}
    return [place.subs(variable, pole) for pole in sorted(poles, key=sp.N)]


def changes_sign_at_pole(integral: sp.Integral, place: sp.Expr, domain: Domain) -> bool:
    """Return whether an integrand is at least like 1/x at a pole, with unlike signs around it."""
    integrand, (variable, *_) = integral.args
    sides = [find_residue(integrand, variable, place, side, domain) for side in (1, -1)]
    if None in sides:
        return False
    signs = [sp.sign(side) for side in sides]
    return is_positive(signs[0] * signs[1], domain)


def find_residue(
    integrand: sp.Expr, variable: sp.Symbol, place: sp.Expr, side: int, domain: Domain
) -> sp.Expr | None:
    """Return c if the integrand is like c/(x - place) from a side, or like c/x far out.

    The result is infinite for faster growth, and None where nothing is shown or c could only be 0.
    """
    distance = variable if place.is_infinite else variable - place
    limit = find_limit(write_by_sines(integrand) * distance, variable, place, side, domain)
    is_met = limit is not None and (limit.is_infinite or is_nonzero(limit, domain))
    return limit if is_met else None


def list_zeros_between(
    inner: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr
) -> list[sp.Expr]:
    """List the zeros between the limits of a polynomial or of a*sin(u) + b*cos(u), u linear.

    A missed zero does no harm, as no sign is then shown next to it.
    """
    if not (lower.is_number and upper.is_number):
        return []
    inside = sp.Interval.open(lower, upper)
    found: list[sp.Expr] = []
    if inner.is_polynomial(variable) and inner.free_symbols == {variable}:
        found = list(dict.fromkeys(sp.Poly(inner, variable).real_roots()))
    elif lower.is_finite and upper.is_finite:
        found = list(_list_zeros_of_wave(inner, variable))
    return sorted((z for z in found if inside.contains(z) == sp.true), key=sp.N)


def _list_zeros_of_wave(inner: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    angle, *others = {wave.args[0] for wave in inner.atoms(sp.sin, sp.cos)} or {sp.S.Zero}
    slope, waves = sp.diff(angle, variable), (sp.sin(angle), sp.cos(angle))
    along, across = (sp.expand(inner).coeff(wave) for wave in waves)
    is_wave = sp.expand(inner - along * waves[0] - across * waves[1]) == 0
    if others or not (is_wave and along.is_number and across.is_number):
        return
    if slope != 0 and (slope.is_Rational or (slope / sp.pi).is_Rational):
        start = angle.subs(variable, 0) + sp.atan2(across, along)
        yield from ((sp.pi * k - start) / slope for k in range(-_MOST_ZEROS, _MOST_ZEROS))


def unwind(integral: sp.Integral) -> sp.Integral:
    """Return an integral over whole periods with n*x as x, a*cos x + b*sin x as one cosine."""
    integrand, (x, lower, upper) = integral.args
    angles = {wave.args[0] for wave in integrand.atoms(*TURNING) if wave.has(x)}
    u = sp.Dummy("u", real=True)
    inner = integrand.xreplace(dict.fromkeys(angles, u))
    # What contains u outside of waves, as exp(2*x)*cos(2*x) does, is not periodic.
    is_periodic = not inner.xreplace({wave(u): sp.Dummy() for wave in CIRCULAR}).has(u)
    turns = (upper - lower) / (2 * sp.pi)
    is_even = inner.subs(u, u + sp.pi) == inner
    is_whole = (2 * turns if is_even else turns).is_Integer and turns > 0
    if len(angles) != 1 or inner.has(x) or not (is_periodic and is_whole):
        return integral
    (angle,) = angles
    times = sp.diff(angle, x)
    if not (times.is_integer and times.is_positive):
        return integral
    for wave in (node.as_independent(u)[1] for node in inner.atoms(sp.Add)):
        along, across = (wave.coeff(one) for one in (sp.cos(u), sp.sin(u)))
        turned = inner.subs(wave, sp.sqrt(along**2 + across**2) * sp.cos(u))
        is_wave = wave == along * sp.cos(u) + across * sp.sin(u) and across != 0
        is_alone = not (along.has(u) or across.has(u) or inner.subs(wave, sp.Dummy()).has(u))
        if turns.is_Integer and is_wave and is_alone:
            inner = turned
    return sp.Integral(inner.xreplace({u: x}), (x, lower, upper))


_BY_PIECES = (*IN_PIECES, sp.Piecewise, sp.floor)
# Work limit: steps of a floor function between the limits.
_MOST_STEPS = 64


def has_pieces(integrand: sp.Expr, variable: sp.Symbol) -> bool:
    """Return whether an integrand is given by pieces in the variable."""
    return any(node.has(variable) for node in integrand.atoms(*_BY_PIECES))


def cut_at_seams(integral: sp.Integral, domain: Domain) -> list[sp.Integral]:
    """Cut an integral where one condition or floor changes; return [] if that is not shown."""
    integrand, (variable, lower, upper) = integral.args
    written = _write(integrand, variable)
    if (floor := _find_floor(written, variable)) is not None:
        return _cut_at_steps(written, floor, integral.limits[0])
    condition = _find_condition(written, variable)
    if condition is None:
        return []
    inner = condition.gts - condition.lts
    cuts = [lower, *_list_seams(inner, variable, lower, upper, domain), upper]
    parts = []
    for start, end in pairwise(cuts):
        sign = _find_sign_between(inner, variable, start, end, domain)
        if sign is None:
            return []
        part = assume(written, condition, holds=sign.direction > 0)
        parts.append(sp.Integral(part, (variable, start, end)))
    return [] if any(part.has(sp.nan) for part in parts) else parts


def integrate_polynomials(integral: sp.Integral) -> sp.Expr | None:
    """Return the value if the pieces are polynomials on both sides of one place, else None.

    The antiderivatives on both sides are zero at that place, so they join continuously and the
    limits may lie in any order.
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
    """Write moduli, signs, maxima and minima that contain the variable by pieces.

    The argument of a sign is zero only at single places, where the integrand does not count.
    """
    nodes = [node for node in integrand.atoms(*IN_PIECES) if node.has(variable)]
    numbers = {node.args[0] for node in nodes if isinstance(node, sp.sign)}
    single = {n for n in numbers if n.is_polynomial(variable) and n.free_symbols == {variable}}
    return integrand.xreplace({node: write_pieces(node, single) for node in nodes})


def _find_floor(integrand: sp.Expr, variable: sp.Symbol) -> sp.Expr | None:
    floors = (node for node in integrand.atoms(sp.floor) if node.has(variable))
    return min(floors, key=sp.default_sort_key, default=None)


def _cut_at_steps(written: sp.Expr, floor: sp.Expr, limits: sp.Tuple) -> list[sp.Integral]:
    """Cut an integral between numbers at the steps of a floor of a linear expression."""
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
    """Return a condition on the variable that contains no pieces itself, or None."""
    pieces = written.atoms(sp.Piecewise)
    found = {c for piece in pieces for _, cond in piece.args for c in cond.atoms(Relational)}
    plain = (c for c in found if c.has(variable) and not c.has(sp.Piecewise) and find_slack(c))
    return min(plain, key=sp.default_sort_key, default=None)


def _list_seams(
    inner: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr, domain: Domain
) -> list[sp.Expr]:
    """List a seam's places between the limits; with letters, only of a linear `inner`."""
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
