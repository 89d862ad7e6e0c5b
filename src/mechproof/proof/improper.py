"""Kinds of integrals that are worked out before others: improper ones, and those of integrals."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from mechproof.proof.coordinates import parametrise, write_by_sines
from mechproof.proof.growth import find_limit
from mechproof.proof.half_angles import is_shown_there
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.record import Slack
from mechproof.statement_domains.domain import Domain

_MOST_ZEROS = 12


def is_improper(integral: sp.Integral) -> bool:
    """Tell whether a limit is infinite, or the integrand has no value there or between them."""
    (variable, *limits), *others = integral.limits
    if others or len(limits) != 2:
        return False
    factors = sp.Mul.make_args(integral.function)
    there = (factor.subs(variable, limit) for limit in limits for factor in factors)
    return (
        any(limit.is_infinite for limit in limits)
        or any(value.has(sp.oo, -sp.oo, sp.zoo, sp.nan) for value in there)
        or bool(list_poles(integral.function, variable, *limits))
    )


def may_reach_zero(integral: sp.Integral, domain: Domain) -> bool:
    """Tell whether a base, whose exponent is no whole number, may vanish between the limits.

    What is computed of such a power has a root, or the logarithm, of what may be below zero.
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
    """Tell whether an integral is one of integrals."""
    return len(integral.limits) > 1 or integral.function.has(sp.Integral)


def list_poles(
    integrand: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr
) -> list[sp.Expr]:
    """List places between the limits at which it is divided by zero, or a logarithm is infinite.

    Between limits with letters they are found where the variable is written by a number.
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
    """Tell whether an integrand is infinite like 1/x or more so, its signs unlike about a pole."""
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

    It is infinite for what grows faster; None where nothing is shown, or there is no such c but 0.
    """
    distance = variable if place.is_infinite else variable - place
    limit = find_limit(write_by_sines(integrand) * distance, variable, place, side, domain)
    is_met = limit is not None and (limit.is_infinite or is_nonzero(limit, domain))
    return limit if is_met else None


def list_zeros_between(
    inner: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr
) -> list[sp.Expr]:
    """List zeros between the limits of a polynomial, or of a*sin(u) + b*cos(u), u a multiple.

    Where one is missed, no sign is shown beside it.
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
