"""Rung: logarithms and powers with the signs they need, in one form.

A power of a positive base is an exponential, the logarithm of a product of positive factors the sum
of theirs. Where a sign is not shown nothing is rewritten, so that no branch is taken for another.
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.coordinates import HYPERBOLIC, write_by_sines
from mechproof.proof.half_angles import is_shown_there
from mechproof.proof.signs import is_positive
from mechproof.record import Slack
from mechproof.record.parts import has_parts
from mechproof.statement_domains.domain import Domain

RUNG = "logarithms and powers"
_JUMPING = (
    *(sp.sign, sp.floor, sp.ceiling, sp.Heaviside, sp.Mod, sp.atan2),
    *(sp.KroneckerDelta, sp.Piecewise),
)


def decide_by_logarithms(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right once their logarithms and powers have one form."""
    left, right = domain.resolve(left), domain.resolve(right)
    one, other = (write_by_logarithms(side, domain) for side in (left, right))
    if (one, other) == (left, right):
        return None
    return RUNG if decide_equal(one, other, domain) else None


def split_powers(expression: sp.Expr) -> sp.Expr:
    """Write b**(k*n + m + a), n a whole number, by b**n and b**a, wherever b is not zero.

    Where it is zero both sides of an identity go on as they are near it: b is zero on no interval,
    and nothing jumps there.
    """
    if has_parts(expression, *_JUMPING):
        return expression
    names: dict[tuple[sp.Expr, sp.Expr], sp.Symbol] = {}
    return expression.replace(
        lambda node: isinstance(node, sp.Pow) and not node.exp.is_number and is_analytic(node.base),
        lambda node: _split_power(node.base, node.exp, names),
    )


def is_analytic(expression: sp.Expr) -> bool:
    """Tell whether an expression, unless it is zero itself, is zero on no interval."""
    roots = (power for power in expression.atoms(sp.Pow) if not power.exp.is_integer)
    return not has_parts(expression, *_JUMPING, sp.Abs, sp.Max, sp.Min) and not any(
        root.base.free_symbols for root in roots
    )


def _split_power(
    base: sp.Expr, exponent: sp.Expr, names: dict[tuple[sp.Expr, sp.Expr], sp.Symbol]
) -> sp.Expr:
    result, kept = sp.S.One, sp.S.Zero
    for term in sp.Add.make_args(sp.expand(exponent)):
        times, rest = term.as_coeff_Mul(rational=True)
        if not (times.is_Integer and rest.is_integer):
            kept += term
            continue
        for factor, power in _list_factors(base):
            if rest == 1:
                result *= factor ** (power * times)
            elif factor == -1:
                result *= names.setdefault((factor, rest), sp.Dummy("sign")) ** (times % 2)
            else:
                name = names.setdefault((factor, rest), sp.Dummy("power", real=True))
                result *= name ** (power * times)
    return result * sp.Pow(base, kept)


def _list_factors(base: sp.Expr) -> list[tuple[sp.Expr, int]]:
    """List factors with whole powers, numbers by their primes."""
    found: list[tuple[sp.Expr, int]] = []
    for factor in sp.Mul.make_args(base):
        if factor.is_Rational:
            primes = sp.factorrat(factor).items()
            found += [(sp.Integer(prime), int(power)) for prime, power in primes]
        elif isinstance(factor, sp.Pow) and factor.exp.is_Integer:
            found.append((factor.base, int(factor.exp)))
        else:
            found.append((factor, 1))
    return found


def write_by_logarithms(node: sp.Expr, domain: Domain) -> sp.Expr:
    """Write powers of positive bases as exponentials, logarithms of products as sums."""
    if not node.args or not node.has(sp.log, sp.Pow, sp.exp):
        return node
    node = node.func(*(write_by_logarithms(argument, domain) for argument in node.args))
    if isinstance(node, sp.log):
        logarithm = _take_logarithm(node.args[0], domain)
        written = node if logarithm is None else logarithm
        return written.replace(sp.log, lambda argument: _take_sizes(sp.log(argument)))
    if isinstance(node, sp.exp):
        return _write_exponential(node.args[0])
    if not isinstance(node, sp.Pow) or node.exp.is_Rational:
        return node
    logarithm = _take_logarithm(_write_base(node.base), domain)
    return node if logarithm is None else _write_exponential(node.exp * logarithm)


def _write_base(base: sp.Expr) -> sp.Expr:
    """Write hyperbolic functions by exponentials, as cosh x + sinh x is one, tangents by sines."""
    return sp.expand(base.rewrite(sp.exp)) if base.has(*HYPERBOLIC) else write_by_sines(base)


def _take_logarithm(argument: sp.Expr, domain: Domain) -> sp.Expr | None:
    """Return the logarithm of a product by those of its factors, None if not all are positive."""
    factors = _list_powers(argument)
    if not all(_is_positive(base, domain) for base, _ in factors):
        return None
    return sp.Add(*(exponent * sp.log(base) for base, exponent in factors))


def _is_positive(base: sp.Expr, domain: Domain) -> bool:
    return is_positive(base, domain) or is_shown_there(Slack(base, True), domain)


def _take_sizes(logarithm: sp.Expr) -> sp.Expr:
    """Write the logarithm of a product, which is positive where it has one, by sizes of factors."""
    if not isinstance(logarithm, sp.log):
        return logarithm
    sizes = [
        (part, exponent * power)
        for base, exponent in _list_powers(logarithm.args[0])
        for part, power in _list_powers(base)
    ]
    if len([base for base, _ in sizes if not base.is_number]) < 2:
        return logarithm
    return sp.Add(*(exponent * sp.log(sp.Abs(base)) for base, exponent in sizes))


def _list_powers(product: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    return [factor.as_base_exp() for factor in sp.Mul.make_args(sp.factor(product))]


def _write_exponential(exponent: sp.Expr) -> sp.Expr:
    """Write the exponential of a sum as a product, whole multiples of logarithms as powers."""
    if any(power.exp.is_negative for power in exponent.atoms(sp.Pow)):
        exponent = sp.cancel(exponent)
    return sp.Mul(*(sp.exp(term) for term in sp.Add.make_args(sp.expand(exponent))))
