"""Where an expression has a value: what of it is not shown on a domain."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.domain import Domain
from mechproof.proof.signs import find_sign
from mechproof.proof.sums import canonicalise
from mechproof.record import Need, list_needs, list_partial


def list_unshown(expression: sp.Basic, domain: Domain) -> list[Need]:
    """List what roots, logarithms and so on need to have values, as far as it is not shown."""
    parts = list_partial(domain.resolve(expression))
    needs = dict.fromkeys(need for node in parts for need in list_needs(node))
    return [need for need in needs if not _is_shown(*need, domain)]


def tell(need: Need) -> str:
    """Write a need as a relation."""
    number, strict = need
    return f"{number} {'>' if strict else '>='} 0"


def need_the_same(sides: Sequence[sp.Basic], needs: Sequence[list[Need]], domain: Domain) -> bool:
    """Say whether all sides have values at the same points: what they need is proved equal.

    Of sums, integrals and cases, whose parts are not looked into, that is not known.
    """
    parts = (node for side in sides for node in list_partial(domain.resolve(side)))
    if not all(map(list_needs, parts)):
        return False
    first, *others = map(_drop_implied, needs)
    return all(_covers(o, first, domain) and _covers(first, o, domain) for o in others)


def _drop_implied(needs: list[Need]) -> list[Need]:
    return [(number, strict) for number, strict in needs if strict or (number, True) not in needs]


def _covers(needs: list[Need], others: list[Need], domain: Domain) -> bool:
    """Say whether each of the others is one of the needs."""
    return all(any(_is_one(need, other, domain) for need in needs) for other in others)


def _is_one(need: Need, other: Need, domain: Domain) -> bool:
    (number, strict), (against, is_strict) = need, other
    if strict is not is_strict:
        return False
    return number == against or decide_equal(number, against, domain) is not None


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
