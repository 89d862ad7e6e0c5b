"""Known Fourier series: sums of sines and cosines of multiples of an angle, divided by powers.

Summed are all multiples m, or the odd ones. Signs that alternate are those of the angle and pi, or
pi/2: (-1)**m*sin(m*u) is sin(m*(u + pi)).
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
    for factor, wave, angle in _read(term):
        if (known := SERIES.get(wave)) and _is_between(angle, known, domain):
            return factor * known.value.subs(_U, angle)
    return None


def _read(term: sp.Expr) -> Iterator[tuple[sp.Expr, _Wave, sp.Expr]]:
    """Yield a factor, the wave that it multiplies, and its angle, if there is one in a term."""
    waves = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.sin | sp.cos) and f.has(_J)]
    if len(waves) != 1:
        return
    (angle,), rest = waves[0].args, term / waves[0]
    step = sp.diff(angle, _J)
    part = sp.cancel(angle.subs(_J, 0) / step)
    if step.has(_J) or part not in (1, sp.S.Half):
        return
    is_odd = part == sp.S.Half
    m, u = _J / part + 1, step * part
    for power in (1, 2, 3):
        factor = sp.powsimp(sp.cancel(sp.expand_power_exp(rest) * m**power))
        if not factor.has(_J):
            yield factor, _Wave(waves[0].func, is_odd, power), u
        elif not (other := sp.powsimp(sp.expand(factor * (-1) ** _J))).has(_J):
            yield _turn(other, _Wave(waves[0].func, is_odd, power), u)


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
