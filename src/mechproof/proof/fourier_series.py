"""Known Fourier series: sums of sines and cosines of multiples of an angle, divided by powers.

Summed are all multiples m, or the odd ones. Signs that alternate are those of the angle and pi, or
pi/2: (-1)**m*sin(m*u) is sin(m*(u + pi)). With powers r**m they are parts of series of r*exp(i*u):
the geometric one, which is Poisson's kernel, and that of a logarithm (Abramowitz, Stegun, 1964,
chapter 27.8).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple

import sympy as sp

from mechproof.proof.definedness import has_values
from mechproof.proof.endless_sums import put_values, read_endless
from mechproof.proof.signs import is_nonnegative, is_positive
from mechproof.statement_domains.domain import Domain

RUNG = "Fourier series"
_U = sp.Dummy("u", real=True)
_J = sp.Dummy("j", integer=True, nonnegative=True)


class _Wave(NamedTuple):
    """A sine or cosine of multiples m*u, all or odd ones, divided by a power of m."""

    kind: type[sp.Basic]
    is_odd: bool
    power: int


class _Value(NamedTuple):
    """What such a series is between an angle of zero and an end, also there or not."""

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
# With r**m, for r**2 < 1; divided by a power of m, from m = 1 on.
POWERS: Mapping[_Wave, sp.Expr] = {
    _Wave(sp.cos, False, 0): (_R * sp.cos(_U) - _R**2) / _CIRCLE,
    _Wave(sp.sin, False, 0): _R * sp.sin(_U) / _CIRCLE,
    _Wave(sp.cos, False, 1): -sp.log(_CIRCLE) / 2,
    _Wave(sp.sin, False, 1): sp.atan(_R * sp.sin(_U) / (1 - _R * sp.cos(_U))),
}


def settle_waves(expression: Any, domain: Domain) -> Any:
    """Put the values of known Fourier series in the places of sums without end."""
    return put_values(expression, partial(_find_value, domain))


def _find_value(domain: Domain, total: sp.Sum) -> sp.Expr | None:
    if isinstance(total, sp.Product) or (read := read_endless(total)) is None:
        return None
    term, k, first = read
    term = term.subs(k, first + _J)
    if not has_values(term, domain.with_set(_J, sp.S.Naturals0)):
        return None
    if any(wave.args[0].subs(_J, 0) == 0 for wave in _list_waves(term)):
        rest = _find_value(domain, sp.Sum(total.function, (k, first + 1, sp.oo)))
        return None if rest is None else term.subs(_J, 0) + rest
    for factor, wave, angle in _read(term):
        if (known := SERIES.get(wave)) and _is_between(angle, known, domain):
            return factor * known.value.subs(_U, angle)
    return next(_find_by_powers(term, domain), None)


def _find_by_powers(term: sp.Expr, domain: Domain) -> Iterator[sp.Expr]:
    """Yield the value of waves that are multiplied by powers r**m."""
    for rest, wave, angle in _read_rest(term):
        for power in (0, 1):
            factor = rest * (_J + 1) ** power
            ratio = sp.powsimp(sp.cancel(sp.expand_power_exp(factor.subs(_J, _J + 1) / factor)))
            value = POWERS.get(wave._replace(power=power))
            if value is not None and not ratio.has(_J) and is_positive(1 - ratio**2, domain):
                yield factor.subs(_J, 0) / ratio * value.subs({_U: angle, _R: ratio})


def _list_waves(term: sp.Expr) -> list[sp.Expr]:
    """List the factors of a term that are waves, and move from term to term."""
    return [f for f in sp.Mul.make_args(term) if isinstance(f, sp.sin | sp.cos) and f.has(_J)]


def _read_rest(term: sp.Expr) -> Iterator[tuple[sp.Expr, _Wave, sp.Expr]]:
    """Yield what a wave is multiplied by, the wave and its angle, if there is one in a term."""
    waves = _list_waves(term)
    if len(waves) != 1:
        return
    (angle,), rest = waves[0].args, term / waves[0]
    step = sp.diff(angle, _J)
    part = sp.cancel(angle.subs(_J, 0) / step)
    if not step.has(_J) and part in (1, sp.S.Half):
        yield rest, _Wave(waves[0].func, part == sp.S.Half, 0), step * part


def _read(term: sp.Expr) -> Iterator[tuple[sp.Expr, _Wave, sp.Expr]]:
    """Yield a factor, the wave that it multiplies, divided by a power, and its angle."""
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
    """Write terms whose signs alternate, beginning with a plus, by a shifted angle."""
    if not wave.is_odd:
        return -factor, wave, angle + sp.pi
    is_sine = wave.kind is sp.sin
    other = wave._replace(kind=sp.cos if is_sine else sp.sin)
    return -factor if is_sine else factor, other, angle + sp.pi / 2


def _is_between(angle: sp.Expr, known: _Value, domain: Domain) -> bool:
    is_above = is_positive if known.is_open else is_nonnegative
    return is_above(angle, domain) and is_above(known.end - angle, domain)
