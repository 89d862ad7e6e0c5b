"""Rungs: sums of sines and cosines whose angles rise by equal steps, 2*pi/n for n planets.

With d the step, the sum of cos(c + k*d) from p to q is sin(c + (q + 1/2)*d) - sin(c + (p - 1/2)*d)
divided by 2*sin(d/2), as each term is such a difference, if d/2 is no multiple of pi. A product of
n sines with the step pi/n is the sine of n times the first angle, divided by 2**(n - 1). With
binomial coefficients the sum of cos(c + k*d) from 0 to n is (2*cos(d/2))**n*cos(c + n*d/2), the
real part of exp(i*c)*(1 + exp(i*d))**n.

Infinite sums: Fourier series of all, or of all odd, multiples m of an angle, divided by powers of
m. Alternating signs shift the angle by pi, or pi/2: (-1)**m*sin(m*u) is sin(m*(u + pi)). With
powers r**m they are parts of series in r*exp(i*u): the geometric one, which is Poisson's kernel,
and that of a logarithm (Abramowitz, Stegun, 1964, chapter 27.8).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

import sympy as sp
from sympy.simplify.fu import TR8

from mechproof.proof.algebra import decide_equal
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.cases import Prove, Sides, put_in
from mechproof.proof.definedness import has_values
from mechproof.proof.endless_sums import read_endless
from mechproof.proof.signs import is_nonnegative, is_positive
from mechproof.statement_domains.domain import Domain

RUNG = "angles that rise by the same step"
BINOMIALS = "binomial sum of waves"
# Work limits: first numbers that are checked one by one, and operations of a term.
_MOST_ALONE = 4
_LARGEST = 40


def decide_by_steps(left: sp.Expr, right: sp.Expr, domain: Domain, prove: Prove) -> str | None:
    """Return the rungs if left = right is proved with the values of such sums and products.

    The first numbers, for which a step may be a whole turn, are checked one by one.
    """
    sides = (domain.resolve(left), domain.resolve(right))
    sums = {total for side in sides for total in side.atoms(sp.Sum, sp.Product)}
    counts = {n for total in sums for n in _list_counts(total)}
    if len(counts) != 1:
        return None
    (n,) = counts
    for first in range(1, _MOST_ALONE + 1):
        later = replace(domain, where=(*domain.where, n >= first)) if first > 1 else domain
        values = {total: _find_value(total, n, later) for total in sums}
        if None not in values.values():
            alone = ({n: sp.Integer(number)} for number in range(1, first))
            if not all(_holds_at(one, sides, domain, prove) for one in alone):
                return None
            rest = prove(*(side.xreplace(values) for side in sides), later)
            return f"{RUNG}, {rest}" if rest else None
    return None


def decide_by_binomials(left: sp.Expr, right: sp.Expr, domain: Domain, prove: Prove) -> str | None:
    """Return the rungs if left = right is proved with the values of binomial sums of waves."""
    sides = (domain.resolve(left), domain.resolve(right))
    sums = {total for side in sides for total in side.atoms(sp.Sum)}
    values = {total: value for total in sums if (value := _add_binomials(total)) is not None}
    if not values:
        return None
    rest = prove(*(side.xreplace(values) for side in sides), domain)
    return f"{BINOMIALS}, {rest}" if rest else None


def _add_binomials(total: sp.Sum) -> sp.Expr | None:
    """Return a sum from 0 to n of binomial coefficients times a sine or cosine."""
    (k, first, n), *others = total.limits
    if others or first != 0 or not (n.is_integer and n.is_nonnegative):
        return None
    if total.function.count_ops() > _LARGEST:
        return None
    weight = sp.factorial(n) / (sp.factorial(k) * sp.factorial(n - k))
    factor, wave = (total.function / weight).as_independent(k, as_Add=False)
    turned = sp.powsimp(sp.expand(wave * (-1) ** k))
    wave, turn = (turned, sp.pi) if isinstance(turned, sp.sin | sp.cos) else (wave, 0)
    if not isinstance(wave, sp.sin | sp.cos):
        return None
    (angle,), step = wave.args, sp.diff(wave.args[0], k)
    if step.has(k):
        return None
    half = (step + turn) / 2
    return factor * (2 * sp.cos(half)) ** n * wave.func(angle.subs(k, 0) + n * half)


def _list_counts(total: sp.Sum | sp.Product) -> set[sp.Symbol]:
    """Return the whole numbers that occur both in the limits and in the waves' angles."""
    ends = {s for limit in total.limits for end in limit[1:] for s in end.free_symbols}
    in_waves = {s for wave in total.function.atoms(sp.sin, sp.cos) for s in wave.free_symbols}
    return {n for n in ends & in_waves if n.is_integer and n.is_positive}


def _holds_at(
    point: Mapping[sp.Basic, sp.Expr], sides: Sides, domain: Domain, prove: Prove
) -> bool:
    """Return whether the sides are equal for one number, or the domain excludes it."""
    *parts, fixed = put_in(sides, domain, point)
    return sp.false in fixed.where or bool(prove(*map(write_out, parts), fixed))


def _find_value(total: sp.Sum | sp.Product, n: sp.Symbol, domain: Domain) -> sp.Expr | None:
    (k, first, last), *others = total.limits
    if others or total.function.count_ops() > _LARGEST:
        return None
    if not is_nonnegative(last - first + 1, domain):
        return None
    if isinstance(total, sp.Product):
        return _multiply(total, n)
    term = sp.expand(TR8(sp.expand(total.function)))
    if decide_equal(term, total.function, domain) is None:
        return None
    ends = (first - sp.S.Half, last + sp.S.Half)
    parts = [_add_up(part, k, ends, n, domain) for part in sp.Add.make_args(term)]
    return None if None in parts else sp.Add(*parts)


def _add_up(
    term: sp.Expr, k: sp.Symbol, ends: tuple[sp.Expr, sp.Expr], n: sp.Symbol, domain: Domain
) -> sp.Expr | None:
    """Return the sum of a term between half-integers, or None if it is not a wave."""
    low, high = ends
    factor, wave = term.as_independent(k)
    if wave == 1:
        return factor * (high - low)
    if not isinstance(wave, sp.sin | sp.cos):
        return None
    (angle,) = wave.args
    step = sp.diff(angle, k)
    if step.has(k) or not _is_within_turn(step, domain):
        return None
    grown = sp.sin if isinstance(wave, sp.cos) else lambda u: -sp.cos(u)
    at_ends = (grown(_split(angle.subs(k, end), n)) for end in (high, low))
    return factor * sp.Add(next(at_ends), -next(at_ends)) / (2 * sp.sin(step / 2))


def _multiply(product: sp.Product, n: sp.Symbol) -> sp.Expr | None:
    """Return a product of n sines or cosines, or of the n - 1 without the zero angle; else None."""
    k, first, last = product.limits[0]
    factor, wave = product.function.as_independent(k, as_Add=False)
    if not isinstance(wave, sp.sin | sp.cos):
        return None
    angle = wave.args[0] + (sp.pi / 2 if isinstance(wave, sp.cos) else 0)
    start, step = angle.subs(k, first), sp.diff(angle, k)
    count = sp.expand(last - first + 1)
    if sp.expand(step - sp.pi / n) != 0:
        return None
    if count == n:
        return factor**n * sp.sin(sp.expand(n * start)) / 2 ** (n - 1)
    if count == n - 1 and sp.expand(start - step) == 0:
        return factor**count * n / 2 ** (n - 1)
    return None


def _is_within_turn(step: sp.Expr, domain: Domain) -> bool:
    """Return whether a step is shown to be nonzero and less than a whole turn either way."""
    part = sp.cancel(step / (2 * sp.pi))
    return any(is_positive(p, domain) and is_positive(1 - p, domain) for p in (part, -part))


def _split(angle: sp.Expr, n: sp.Symbol) -> sp.Expr:
    """Write an angle with its whole turns split off, as in pi - pi/(2*n + 1)."""
    return sp.expand(sp.apart(sp.together(angle), n)) if angle.is_rational_function(n) else angle


FOURIER = "Fourier series"
_U = sp.Dummy("u", real=True)
_J = sp.Dummy("j", integer=True, nonnegative=True)


class _Wave(NamedTuple):
    """A sine or cosine of multiples m*u, all or odd ones, divided by a power of m."""

    kind: type[sp.Basic]
    is_odd: bool
    power: int


class _Value(NamedTuple):
    """The value of a series for angles from zero to `end`, both excluded if `is_open`."""

    value: sp.Expr
    end: sp.Expr
    is_open: bool


SERIES: Mapping[_Wave, _Value] = {
    _Wave(sp.sin, False, 1): _Value((sp.pi - _U) / 2, 2 * sp.pi, True),
    _Wave(sp.cos, False, 1): _Value(-sp.log(2 * sp.sin(_U / 2)), 2 * sp.pi, True),
    _Wave(sp.cos, False, 2): _Value(sp.pi**2 / 6 - sp.pi * _U / 2 + _U**2 / 4, 2 * sp.pi, False),
    _Wave(sp.sin, False, 3): _Value(
        sp.pi**2 * _U / 6 - sp.pi * _U**2 / 4 + _U**3 / 12, 2 * sp.pi, False
    ),
    _Wave(sp.sin, True, 1): _Value(sp.pi / 4, sp.pi, True),
    _Wave(sp.cos, True, 2): _Value(sp.pi**2 / 8 - sp.pi * _U / 4, sp.pi, False),
    _Wave(sp.sin, True, 3): _Value(sp.pi * _U * (sp.pi - _U) / 8, sp.pi, False),
}

_R = sp.Dummy("r", real=True)
_CIRCLE = 1 - 2 * _R * sp.cos(_U) + _R**2
# Sums of waves of m*u times r**m, r**2 < 1; with the power 1, divided by m; from m = 1 on.
POWERS: Mapping[_Wave, sp.Expr] = {
    _Wave(sp.cos, False, 0): (_R * sp.cos(_U) - _R**2) / _CIRCLE,
    _Wave(sp.sin, False, 0): _R * sp.sin(_U) / _CIRCLE,
    _Wave(sp.cos, False, 1): -sp.log(_CIRCLE) / 2,
    _Wave(sp.sin, False, 1): sp.atan(_R * sp.sin(_U) / (1 - _R * sp.cos(_U))),
}


def find_waves(total: sp.Sum | sp.Product, domain: Domain) -> sp.Expr | None:
    """Return the value of an infinite sum that is a known Fourier series, or None."""
    if isinstance(total, sp.Product) or (read := read_endless(total)) is None:
        return None
    term, k, first = read
    term = term.subs(k, first + _J)
    if not has_values(term, domain.with_set(_J, sp.S.Naturals0)):
        return None
    if any(wave.args[0].subs(_J, 0) == 0 for wave in _list_waves(term)):
        rest = find_waves(sp.Sum(total.function, (k, first + 1, sp.oo)), domain)
        return None if rest is None else term.subs(_J, 0) + rest
    for factor, wave, angle in _read(term):
        if (known := SERIES.get(wave)) and (
            u := _find_angle(wave, angle, known, domain)
        ) is not None:
            return factor * known.value.subs(_U, u)
    return next(_find_by_powers(term, domain), None)


def _find_by_powers(term: sp.Expr, domain: Domain) -> Iterator[sp.Expr]:
    """Yield the sum of waves that are multiplied by powers r**m."""
    for rest, wave, angle in _read_rest(term):
        for power in (0, 1):
            factor = rest * (_J + 1) ** power
            ratio = sp.powsimp(sp.cancel(sp.expand_power_exp(factor.subs(_J, _J + 1) / factor)))
            value = POWERS.get(wave._replace(power=power))
            if value is not None and not ratio.has(_J) and is_positive(1 - ratio**2, domain):
                yield factor.subs(_J, 0) / ratio * value.subs({_U: angle, _R: ratio})


def _list_waves(term: sp.Expr) -> list[sp.Expr]:
    """List the factors of a term that are waves whose angle changes from term to term."""
    return [f for f in sp.Mul.make_args(term) if isinstance(f, sp.sin | sp.cos) and f.has(_J)]


def _read_rest(term: sp.Expr) -> Iterator[tuple[sp.Expr, _Wave, sp.Expr]]:
    """Yield a wave's cofactor, the wave and its angle, if a term has exactly one wave."""
    waves = _list_waves(term)
    if len(waves) != 1:
        return
    (angle,), rest = waves[0].args, term / waves[0]
    step = sp.diff(angle, _J)
    part = sp.cancel(angle.subs(_J, 0) / step)
    if not step.has(_J) and part in (1, sp.S.Half):
        yield rest, _Wave(waves[0].func, part == sp.S.Half, 0), step * part


def _read(term: sp.Expr) -> Iterator[tuple[sp.Expr, _Wave, sp.Expr]]:
    """Yield a constant factor, the wave divided by a power of m, and its angle."""
    for rest, wave, angle in _read_rest(term):
        m = 2 * _J + 1 if wave.is_odd else _J + 1
        for power in (1, 2, 3):
            divided = wave._replace(power=power)
            factor = sp.powsimp(sp.cancel(sp.expand_power_exp(rest) * m**power))
            if not factor.has(_J):
                yield factor, divided, angle
            elif not (other := sp.powsimp(sp.expand(factor * (-1) ** _J))).has(_J):
                yield _turn(other, divided, angle)


def _turn(factor: sp.Expr, wave: _Wave, angle: sp.Expr) -> tuple[sp.Expr, _Wave, sp.Expr]:
    """Write terms of alternating sign, the first one positive, by a shifted angle."""
    if not wave.is_odd:
        return -factor, wave, angle + sp.pi
    is_sine = wave.kind is sp.sin
    other = wave._replace(kind=sp.cos if is_sine else sp.sin)
    return -factor if is_sine else factor, other, angle + sp.pi / 2


def _find_angle(wave: _Wave, angle: sp.Expr, known: _Value, domain: Domain) -> sp.Expr | None:
    """Return the angle, or for a cosine its modulus, if shown to lie in the range; else None."""
    is_above = is_positive if known.is_open else is_nonnegative
    if not is_above(known.end - angle, domain):
        return None
    if is_above(angle, domain):
        return angle
    is_even = wave.kind is sp.cos and not known.is_open
    return sp.Abs(angle) if is_even and is_above(known.end + angle, domain) else None
