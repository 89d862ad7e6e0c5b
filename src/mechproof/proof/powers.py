"""Rung: logarithms and powers with the signs they need, in one form.

A power of a positive base is an exponential, the logarithm of a product of positive factors the sum
of theirs. Where a sign is not shown nothing is rewritten, so that no branch is taken for another.
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.domain import Domain
from mechproof.proof.signs import is_positive

RUNG = "logarithms and powers"


def decide_by_logarithms(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right once their logarithms and powers have one form."""
    left, right = domain.resolve(left), domain.resolve(right)
    one, other = _write(left, domain), _write(right, domain)
    if (one, other) == (left, right):
        return None
    return RUNG if decide_equal(one, other, domain) else None


def _write(node: sp.Expr, domain: Domain) -> sp.Expr:
    if not node.args or not node.has(sp.log, sp.Pow, sp.exp):
        return node
    node = node.func(*(_write(argument, domain) for argument in node.args))
    if isinstance(node, sp.log):
        return _write_logarithm(node.args[0], domain)
    if isinstance(node, sp.exp):
        return _write_exponential(node.args[0])
    if not isinstance(node, sp.Pow) or node.exp.is_Rational:
        return node
    is_known = isinstance(node.base, sp.exp) or is_positive(node.base, domain)
    logarithm = _write_logarithm(node.base, domain) if is_known else None
    return node if logarithm is None else _write_exponential(node.exp * logarithm)


def _write_logarithm(argument: sp.Expr, domain: Domain) -> sp.Expr:
    """Write ln of a product by those of its factors, as far as they are positive."""
    if isinstance(argument, sp.exp):
        return argument.args[0]
    factors = [factor.as_base_exp() for factor in sp.Mul.make_args(sp.factor(argument))]
    if not all(is_positive(base, domain) for base, _ in factors):
        return sp.log(argument)
    return sp.Add(*(exponent * sp.log(base) for base, exponent in factors))


def _write_exponential(exponent: sp.Expr) -> sp.Expr:
    """Write the exponential of a sum as a product, whole multiples of logarithms as powers."""
    return sp.Mul(*(sp.exp(term) for term in sp.Add.make_args(sp.expand(exponent))))
