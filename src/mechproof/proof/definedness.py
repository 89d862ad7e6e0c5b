"""Where an expression has a value: what of it is not shown on a domain."""

from __future__ import annotations

import sympy as sp

from mechproof.proof.domain import Domain
from mechproof.proof.signs import find_sign
from mechproof.proof.sums import canonicalise
from mechproof.record import list_needs, list_partial


def list_unshown(expression: sp.Basic, domain: Domain) -> list[str]:
    """List what roots, logarithms and so on need to have values, as far as it is not shown."""
    found: dict[str, None] = {}
    for node in list_partial(domain.resolve(expression)):
        for needed, strict in list_needs(node):
            if not _is_shown(needed, strict, domain):
                found[f"{needed} {'>' if strict else '>='} 0"] = None
    return list(found)


def _is_shown(number: sp.Expr, strict: bool, domain: Domain) -> bool:
    sign = find_sign(number, domain)
    if sign is None:
        return not strict and number.has(sp.Sum) and _adds_squares(number, domain)
    return sign.direction >= 0 and (sign.strict or not strict)


def _adds_squares(number: sp.Expr, domain: Domain) -> bool:
    """Tell whether terms and the terms of sums are squares, which may all be zero."""
    terms = canonicalise(number, domain)
    squares = {
        s: sp.Dummy("squares", nonnegative=True)
        for s in terms.atoms(sp.Sum)
        if s.function.is_nonnegative
    }
    return bool(terms.xreplace(squares).is_nonnegative)
