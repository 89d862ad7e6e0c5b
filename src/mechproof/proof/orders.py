"""Orders of growth, and numbers rewritten so that their order can be read (Hardy 1910).

A factor is replaced by an asymptotically equal one: their quotient tends to 1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.statement_domains.domain import Domain

# Returns the limit of an expression, None where it is not shown.
Find = Callable[[sp.Expr], sp.Expr | None]
_HALF_PI = sp.pi / 2
# The limits at minus and plus infinity of functions that are continuous everywhere.
ENDS: Mapping[type[sp.Basic], tuple[sp.Expr, sp.Expr]] = {
    sp.atan: (-_HALF_PI, _HALF_PI),
    sp.exp: (sp.S.Zero, sp.oo),
    sp.tanh: (-sp.S.One, sp.S.One),
    sp.erf: (-sp.S.One, sp.S.One),
    sp.Si: (-_HALF_PI, _HALF_PI),
    sp.asinh: (-sp.oo, sp.oo),
    sp.sinh: (-sp.oo, sp.oo),
    sp.cosh: (sp.oo, sp.oo),
    sp.Abs: (sp.oo, sp.oo),
}
# Forms of inverse functions that show how they behave as their argument tends to the number.
_SEEN: Mapping[tuple[type[sp.Basic], sp.Expr], Callable[[sp.Expr], sp.Expr]] = {
    (sp.atan, sp.oo): lambda u: sp.pi / 2 - sp.atan(1 / u),
    (sp.atan, -sp.oo): lambda u: -sp.pi / 2 - sp.atan(1 / u),
    (sp.asinh, sp.oo): lambda u: sp.log(u + sp.sqrt(u**2 + 1)),
    (sp.asinh, -sp.oo): lambda u: -sp.log(sp.sqrt(u**2 + 1) - u),
    (sp.acosh, sp.oo): lambda u: sp.log(u + sp.sqrt(u**2 - 1)),
    (sp.acos, sp.S.One): lambda u: 2 * sp.asin(sp.sqrt((1 - u) / 2)),
    (sp.acos, -sp.S.One): lambda u: sp.pi - 2 * sp.asin(sp.sqrt((1 + u) / 2)),
    (sp.asin, sp.S.One): lambda u: sp.pi / 2 - 2 * sp.asin(sp.sqrt((1 - u) / 2)),
    (sp.asin, -sp.S.One): lambda u: 2 * sp.asin(sp.sqrt((1 + u) / 2)) - sp.pi / 2,
}


@dataclass(frozen=True)
class Order:
    """factor*exp(rate*y)*y**power*(ln y)**logs times 1 + o(1); None is a bounded factor."""

    rate: sp.Expr
    power: sp.Expr
    logs: sp.Expr
    factor: sp.Expr | None

    def times(self, other: Order) -> Order:
        """Return the order of a product."""
        rate, power, logs = (a + b for a, b in zip(self.size, other.size, strict=True))
        # Bounded times convergent is bounded, but need not converge.
        if self.factor is None or other.factor is None:
            return Order(rate, power, logs, None)
        return Order(rate, power, logs, self.factor * other.factor)

    @property
    def size(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """Return the three exponents, in the order in which they count."""
        return self.rate, self.power, self.logs


def rewrite_sum(node: sp.Add, y: sp.Symbol) -> Iterator[sp.Expr]:
    """Yield other forms of a sum."""
    forms = (
        join_logarithms,
        lambda node: sp.collect(sp.expand(node), y),
        _multiply_by_conjugate,
        lambda node: _divide_by_power(node, y),
        sp.together,
        sp.expand,
    )
    written = (form(node) for form in forms)
    yield from (one for one in written if one is not None and one != node)


def join_logarithms(node: sp.Expr) -> sp.Expr | None:
    """Write c*(ln u - ln v) + r as c*ln(u/v) + r; None with fewer than two logarithms."""
    terms = [t.as_coeff_Mul() for t in sp.Add.make_args(node)]
    logarithms = [(f, t.args[0]) for f, t in terms if isinstance(t, sp.log)]
    if len(logarithms) < 2:
        return None
    scale = min(abs(factor) for factor, _ in logarithms)
    whole = sp.Mul(*(u ** (f / scale) for f, u in logarithms))
    rest = sp.Add(*(f * t for f, t in terms if not isinstance(t, sp.log)))
    return scale * sp.log(sp.cancel(sp.together(whole))) + rest


def _multiply_by_conjugate(node: sp.Add) -> sp.Expr | None:
    if len(node.args) != 2 or not any(p.exp == sp.S.Half for p in node.atoms(sp.Pow)):
        return None
    one, other = node.args
    return sp.expand(one**2 - other**2) / (one - other)


def _divide_by_power(node: sp.Add, y: sp.Symbol) -> sp.Expr | None:
    """Write a root of a sum plus c*y**p as y**p times a sum whose terms tend to numbers."""
    if len(node.args) != 2:
        return None
    other, root = sorted(node.args, key=lambda term: term.has(sp.Add))
    scale, power = root.as_coeff_Mul()
    number, exponent = other.as_coeff_exponent(y)
    if not isinstance(power, sp.Pow) or not isinstance(power.base, sp.Add) or number.has(y):
        return None
    inner = sp.expand(power.base / y ** (exponent / power.exp))
    return y**exponent * (scale * inner**power.exp + number)


def write_inverses(node: sp.Expr, find: Find) -> sp.Expr:
    """Write inverse functions so that their behaviour in the limit shows; `find` finds limits."""
    kinds = tuple({kind for kind, _ in _SEEN})
    return node.replace(
        lambda part: isinstance(part, kinds),
        lambda part: _SEEN.get((type(part), find(part.args[0])), part.func)(part.args[0]),
    )


# Functions f with f(0) = 1: the leading term of f(u) - 1 for small u.
LIKE_ONE: Mapping[type[sp.Basic], Callable[[sp.Expr], sp.Expr]] = {
    sp.exp: lambda u: u,
    sp.cosh: lambda u: u**2 / 2,
    sp.cos: lambda u: -(u**2) / 2,
}
# Functions f with f(u)/u -> 1 as u tends to zero.
LIKE_ARGUMENT = (sp.sin, sp.tan, sp.asin, sp.atan, sp.sinh, sp.tanh, sp.asinh, sp.atanh)


def write_like(factor: sp.Expr, y: sp.Symbol, find: Find, domain: Domain) -> sp.Expr:
    """Replace ln(1 + u), sin u and the like, where u tends to 0, by the asymptotically equal u."""
    factor = (join_logarithms(factor) if isinstance(factor, sp.Add) else None) or factor
    if isinstance(factor, sp.log):
        small = sp.cancel(factor.args[0] - 1)
    elif isinstance(factor, sp.Add):
        return _write_difference(factor, y, find, domain)
    elif isinstance(factor, LIKE_ARGUMENT):
        (small,) = factor.args
    else:
        return factor
    return small if find(small) == 0 else factor


def _write_difference(sum_: sp.Add, y: sp.Symbol, find: Find, domain: Domain) -> sp.Expr:
    """Replace a sum whose limit cancels by its leading remainder, as for e^u - 1 or 1 - cos u.

    Roots of expressions that tend to a number are treated likewise. The largest remainder counts.
    """
    number, rest = sum_.as_independent(y, as_Add=True)
    parts = [_part(term, y, find, domain) for term in sp.Add.make_args(rest)]
    known = [part for part in parts if part is not None]
    is_known = len(known) == len(parts) and all(small != 0 for _, small in known)
    if not is_known or not decide_equal(-number, sum(n for n, _ in known), domain):
        return sum_
    for _, largest in known:
        ratios = [find(sp.cancel(small / largest)) for _, small in known]
        limits = [ratio for ratio in ratios if ratio is not None and ratio.is_finite]
        if len(limits) == len(known) and is_nonzero(scale := sp.Add(*limits), domain):
            return scale * largest
    return sum_


def _part(
    term: sp.Expr, y: sp.Symbol, find: Find, domain: Domain
) -> tuple[sp.Expr, sp.Expr] | None:
    """Return the limit of a term and the leading form of its remainder, or None."""
    scale, moving = term.as_independent(y, as_Add=False)
    if type(moving) in LIKE_ONE:
        (u,) = moving.args
        return (scale, scale * LIKE_ONE[type(moving)](u)) if find(u) == 0 else None
    if isinstance(moving, sp.Pow) and not moving.base.has(y) and is_positive(moving.base, domain):
        u = moving.exp * sp.log(moving.base)
        return (scale, scale * u) if find(u) == 0 else None
    if not isinstance(moving, sp.Pow) or moving.exp.has(y):
        return None
    base = find(moving.base)
    if base is None or not base.is_finite or not is_positive(base, domain):
        return None
    value = scale * base**moving.exp
    return value, value * moving.exp * sp.cancel(moving.base / base - 1)
