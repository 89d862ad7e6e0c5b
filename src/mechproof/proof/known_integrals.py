"""Table of definite integrals that have known values but no elementary antiderivative.

A row applies if the integrand is proved equal to its own, with letters for which it converges
(Gradshteyn, Ryzhik, Table of Integrals, Series, and Products, 2007, chapters 3 and 4).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.integral_kinds import unwind
from mechproof.proof.signs import is_nonnegative, is_positive
from mechproof.record import Slack
from mechproof.statement_domains.domain import Domain

RUNG = "known integral"
X = sp.Dummy("x", real=True)
_A, _B, _C = (sp.Wild(name, exclude=(X, 0)) for name in "abc")
_ANY = sp.Wild("a", exclude=(X,))
# With whole exponents the integrals are elementary, and found without this table; 1 is allowed
# beside another exponent, X**a/(1 + X).
_FRACTIONS = [lambda number: not number.is_integer]
_P, _Q = (sp.Wild(name, exclude=(X, 0), properties=_FRACTIONS) for name in "pq")
_M = sp.Wild("m", exclude=(X, 0), properties=[lambda number: number == 1 or not number.is_Integer])
_N = sp.Wild("n", properties=[lambda number: number.is_Integer and number.is_positive])
_COUNT = sp.Wild("n", properties=[lambda number: number.is_integer and number.is_nonnegative])
_PI, _OO, _HALF = sp.pi, sp.oo, sp.S.Half
_Limits = tuple[sp.Expr, sp.Expr]


@dataclass(frozen=True)
class KnownIntegral:
    """An integrand in X with letters, its limits, its value, and the signs it requires."""

    integrand: sp.Expr
    limits: _Limits
    value: sp.Expr
    positive: tuple[sp.Expr, ...] = ()
    nonnegative: tuple[sp.Expr, ...] = ()


def _endless(
    integrand: sp.Expr, value: sp.Expr, *positive: sp.Expr, nonnegative: tuple[sp.Expr, ...] = ()
) -> KnownIntegral:
    """Return the table row of an integral from zero to infinity."""
    return KnownIntegral(integrand, (sp.S.Zero, _OO), value, positive, nonnegative)


def _frullani(at: sp.Expr, jump: sp.Expr) -> KnownIntegral:
    """Return the row of (f(a*x) - f(b*x))/x, with f(X) as `at` and f(infinity) - f(0) as `jump`."""
    one, other = at.subs(X, _A * X), at.subs(X, _B * X)
    return _endless((one - other) / X, jump * sp.log(_A / _B), _A, _B)


def _turn(
    integrand: sp.Expr, value: sp.Expr, *positive: sp.Expr
) -> tuple[KnownIntegral, KnownIntegral]:
    """Return the rows over a half turn, with this value, and a turn of an integrand in cosines."""
    half = KnownIntegral(integrand, (sp.S.Zero, _PI), value, positive)
    return half, replace(half, limits=(sp.S.Zero, 2 * _PI), value=2 * value)


_LENGTH = sp.sqrt(_A**2 - _B**2)
_CIRCLE = 1 - 2 * _A * sp.cos(X) + _A**2
_ROOT = sp.sqrt(_PI / _A) / 2
_ZETA = sp.factorial(_N) * sp.zeta(_N + 1) / _A ** (_N + 1)
KNOWN = (
    # Logarithms of sines (4.224).
    KnownIntegral(sp.log(sp.sin(X)), (0, _PI / 2), -_PI / 2 * sp.log(2)),
    KnownIntegral(sp.log(sp.cos(X)), (0, _PI / 2), -_PI / 2 * sp.log(2)),
    KnownIntegral(sp.log(sp.sin(X)), (0, _PI), -_PI * sp.log(2)),
    KnownIntegral(sp.log(sp.tan(X)), (0, _PI / 2), sp.S.Zero),
    KnownIntegral(sp.log(1 + sp.tan(X)), (0, _PI / 4), _PI / 8 * sp.log(2)),
    KnownIntegral(sp.log(1 + sp.cos(X)), (0, _PI), -_PI * sp.log(2)),
    KnownIntegral(sp.log(1 - sp.cos(X)), (0, _PI), -_PI * sp.log(2)),
    KnownIntegral(X * sp.log(sp.sin(X)), (0, _PI), -(_PI**2) / 2 * sp.log(2)),
    # Of fractions (4.231, 4.291).
    KnownIntegral(sp.log(1 + X) / (1 + X**2), (0, 1), _PI / 8 * sp.log(2)),
    KnownIntegral(sp.log(X) / (1 + X), (0, 1), -(_PI**2) / 12),
    KnownIntegral(sp.log(X) / (1 - X), (0, 1), -(_PI**2) / 6),
    KnownIntegral(sp.log(X) / (1 - X**2), (0, 1), -(_PI**2) / 8),
    KnownIntegral(sp.atan(X) / (1 + X), (0, 1), _PI / 8 * sp.log(2)),
    KnownIntegral(sp.log(1 + X) / X, (0, 1), _PI**2 / 12),
    KnownIntegral(sp.log(X) * sp.log(1 - X), (0, 1), 2 - _PI**2 / 6),
    KnownIntegral(sp.log(1 - X) / X, (0, 1), -(_PI**2) / 6),
    _endless(sp.log(X) / (_A**2 + X**2), _PI * sp.log(_A) / (2 * _A), _A),
    KnownIntegral(
        (X**_A - X**_B) / sp.log(X), (0, 1), sp.log((_A + 1) / (_B + 1)), (_A + 1, _B + 1)
    ),
    KnownIntegral((X**_A - 1) / sp.log(X), (0, 1), sp.log(_A + 1), (_A + 1,)),
    # Over a half turn or a whole one (3.613, 3.661, 4.224).
    *_turn(sp.log(_CIRCLE), sp.S.Zero, 1 - _A**2),
    *_turn(sp.log(_CIRCLE), 2 * _PI * sp.log(_A), _A - 1),
    *_turn(
        sp.log(_A + _B * sp.cos(X)),
        _PI * sp.log((_A + _LENGTH) / 2),
        *(_A, _A**2 - _B**2),
    ),
    *_turn(sp.cos(_COUNT * X) / _CIRCLE, _PI * _A**_COUNT / (1 - _A**2), 1 - _A**2),
    KnownIntegral(
        1 / (_A + _B * sp.cos(X) + _C * sp.sin(X)),
        (0, 2 * _PI),
        2 * _PI / sp.sqrt(_A**2 - _B**2 - _C**2),
        (_A, _A**2 - _B**2 - _C**2),
    ),
    *_turn(
        sp.cos(_COUNT * X) / (_A + _B * sp.cos(X)),
        _PI / _LENGTH * ((_LENGTH - _A) / _B) ** _COUNT,
        *(_A, _A**2 - _B**2),
    ),
    # Fresnel (3.691).
    _endless(sp.sin(_A * X**2), _ROOT / sp.sqrt(2), _A),
    _endless(sp.cos(_A * X**2), _ROOT / sp.sqrt(2), _A),
    # Frullani (3.434, 3.784, 4.536).
    _frullani(sp.exp(-X), -sp.S.One),
    _frullani(sp.cos(X), -sp.S.One),
    _frullani(sp.atan(X), _PI / 2),
    # Laplace (3.723), and similar integrals (3.896, 3.325, 3.941).
    _endless(
        sp.cos(_A * X) / (_B**2 + X**2), _PI * sp.exp(-_A * _B) / (2 * _B), _B, nonnegative=(_A,)
    ),
    _endless(X * sp.sin(_A * X) / (_B**2 + X**2), _PI * sp.exp(-_A * _B) / 2, _A, _B),
    _endless(
        sp.sin(_A * X) / (X * (_B**2 + X**2)), _PI * (1 - sp.exp(-_A * _B)) / (2 * _B**2), _A, _B
    ),
    _endless(sp.exp(-_A * X**2) * sp.cos(_B * X), _ROOT * sp.exp(-(_B**2) / (4 * _A)), _A),
    _endless(sp.exp(-_A * X**2 - _B / X**2), _ROOT * sp.exp(-2 * sp.sqrt(_A * _B)), _A, _B),
    _endless(sp.exp(-_B * X) * sp.sin(_A * X) / X, sp.atan(_A / _B), _B),
    # Powers and exponentials (3.241, 3.411).
    _endless(X**_P * sp.exp(-_A * X), sp.gamma(_P + 1) / _A ** (_P + 1), _P + 1, _A),
    KnownIntegral(
        X**_P * (1 - X) ** _Q,
        (0, 1),
        sp.gamma(_P + 1) * sp.gamma(_Q + 1) / sp.gamma(_P + _Q + 2),
        (_P + 1, _Q + 1),
    ),
    KnownIntegral(
        sp.tan(X) ** _P, (0, _PI / 2), _PI / (2 * sp.cos(_PI * _P / 2)), (1 - _P, 1 + _P)
    ),
    _endless(
        X**_ANY / (1 + X**_M), _PI / _M / sp.sin(_PI * (_ANY + 1) / _M), 1 + _ANY, _M - 1 - _ANY
    ),
    _endless(X**_N / (sp.exp(_A * X) - 1), _ZETA, _A),
    _endless(X**_N / (sp.exp(_A * X) + 1), (1 - 2**-_N) * _ZETA, _A),
    _endless(X**_N / sp.sinh(_A * X), (2 - 2**-_N) * _ZETA, _A),
    _endless(X**_N * sp.exp(X) / (sp.exp(X) - 1) ** 2, sp.factorial(_N) * sp.zeta(_N), _N - 1),
)


def list_needed(node: sp.Basic) -> Iterator[Slack]:
    """Yield the conditions of the first row that an integral matches."""
    if not isinstance(node, sp.Integral) or (read := _read(node)) is None:
        return
    _, integrand, limits = read
    for row in _list_rows(integrand, limits):
        found = _match(row, integrand)
        if found is not None:
            needs = [*(Slack(n, True) for n in row.positive)]
            needs += [Slack(n, False) for n in row.nonnegative]
            yield from (need._replace(value=need.value.xreplace(found)) for need in needs)
            return


def _read(integral: sp.Integral) -> tuple[sp.Expr, sp.Expr, list[sp.Expr]] | None:
    """Return a factor, the integrand in X and the limits; an even one is taken on half the line."""
    (variable, *limits), *others = integral.limits
    if others or len(limits) != 2:
        return None
    factor, integrand = integral.function.as_independent(variable, as_Add=False)
    integrand = integrand.xreplace({variable: X})
    if limits == [-_OO, _OO] and integrand.subs(X, -X) == integrand:
        factor, limits = 2 * factor, [sp.S.Zero, _OO]
    return factor, integrand, limits


def find_known(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value of an integral of the table, or None for others."""
    if (read := _read(integral)) is None:
        return None
    factor, integrand, limits = read
    length = limits[1] - limits[0]
    inner = integrand.args[0] if integrand.func == sp.log else X
    scale, argument = inner.as_independent(X, as_Add=False)
    if scale not in (0, 1) and length.is_finite and is_positive(scale, domain):
        # ln(2*sin x) is ln 2 and ln(sin x).
        found = find_known(sp.Integral(sp.log(argument), (X, *limits)), domain)
        return None if found is None else factor * (length * sp.log(scale) + found)
    values = (_find_by(row, integrand, domain) for row in _list_rows(integrand, limits))
    value = next((value for value in values if value is not None), None)
    if value is None and length.is_finite and (turned := unwind(integral)) != integral:
        return find_known(turned, domain)
    if value is None and all(limit.is_finite for limit in limits) and length.free_symbols:
        value = _find_between_letters(integrand, limits, domain)
    return None if value is None else factor * value


def _find_between_letters(
    integrand: sp.Expr, limits: list[sp.Expr], domain: Domain
) -> sp.Expr | None:
    """Return the value by a variable from 0 to 1 in which roots of polynomials become powers."""
    lower, upper = limits
    if not (upper.is_Symbol and is_positive(upper - lower, domain)) or lower.has(upper):
        return None
    gap = sp.Dummy("gap", positive=True)
    moved = integrand.subs({X: lower + gap * X, upper: lower + gap}, simultaneous=True)
    bases = [power.base for power in moved.atoms(sp.Pow)]
    if not all(b.is_polynomial(X) and sp.denom(sp.together(b)).is_number for b in bases):
        return None
    powers = moved.replace(sp.Pow, _split_power)
    factor, rest = powers.as_independent(X, as_Add=False)
    within = {**domain.within, gap: sp.Interval.open(0, sp.oo), X: sp.Interval.open(0, 1)}
    inside = Domain(within, (), {})
    if not rest.free_symbols <= {X} or decide_equal(moved, powers, inside) is None:
        return None
    value = find_known(sp.Integral(rest, (X, 0, 1)), domain)
    return None if value is None else (gap * factor * value).xreplace({gap: upper - lower})


def _split_power(base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
    """Write a power by those of its base's factors, with signs that are positive at X = 1/2."""
    number, factors = sp.factor_list(base)
    signs = {factor: -1 if factor.subs(X, _HALF).is_negative else 1 for factor, _ in factors}
    number *= sp.Mul(*(signs[factor] ** power for factor, power in factors))
    powers = ((signs[factor] * factor) ** (power * exponent) for factor, power in factors)
    return sp.Mul(number**exponent, *powers)


def _list_rows(integrand: sp.Expr, limits: list[sp.Expr]) -> Iterator[KnownIntegral]:
    kinds = _list_kinds(integrand)
    for row in KNOWN:
        if [*row.limits] == limits and _list_kinds(row.integrand) == kinds:
            yield row


def _match(row: KnownIntegral, integrand: sp.Expr) -> dict[sp.Wild, sp.Expr] | None:
    """Return the letters of a row that a match proposes, or None."""
    found = integrand.match(row.integrand)
    # For a squared letter the match finds either of two signs; this takes the positive one.
    return found and {wild: sp.powdenest(value, force=True) for wild, value in found.items()}


def _find_by(row: KnownIntegral, integrand: sp.Expr, domain: Domain) -> sp.Expr | None:
    """Return the value that a row gives, or None; letters that a match proposes are checked."""
    found = _match(row, integrand)
    if found is None:
        return None
    positive, nonnegative = (
        [number.xreplace(found) for number in some] for some in (row.positive, row.nonnegative)
    )
    inside = domain.with_set(X, sp.Interval.open(*row.limits))
    is_met = (
        all(is_positive(number, domain) for number in positive)
        and all(is_nonnegative(number, domain) for number in nonnegative)
        and decide_equal(integrand, row.integrand.xreplace(found), inside) is not None
    )
    return row.value.xreplace(found).doit() if is_met else None


def _list_kinds(expression: sp.Expr) -> set[type[sp.Basic]]:
    return {node.func for node in expression.atoms(sp.Function)}
