"""Approximations: the order of the difference of two sides where a letter is small.

The print does not say how close the sides are meant to be, so it is neither proved nor refuted. But
the remainder of a series has an order, which limits show.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.limits import settle_limits
from mechproof.proof.witness_text import clip
from mechproof.statement_domains.domain import Domain

_OPEN = "an approximation: it does not say how close the two sides are meant to be"
# Work limit: orders beyond that of the last printed term.
_FARTHEST = 4
_MOST_TERMS = 8


def describe_order(left: Any, right: Any, domain: Domain) -> str:
    """Say with which term the difference of two sides begins where a letter is small."""
    left, right = domain.resolve(left), domain.resolve(right)
    if not (isinstance(left, sp.Expr) and isinstance(right, sp.Expr)):
        return _OPEN
    found = [
        (letter, degree, order, factor)
        for letter in sorted(left.free_symbols, key=str)
        if letter.is_Symbol and (degree := _find_degree(left, right, letter)) is not None
        for order, factor in _find_order(left - right, letter, degree, domain)
    ]
    beyond = [one for one in found if one[2] > one[1]]
    within = [one for one in found if right.has(one[0])]
    for letter, degree, order, factor in (*beyond, *within):
        first = f"for small {letter}, left - right begins with {factor * letter**order}"
        said = "after all printed terms" if order > degree else "so a printed term differs"
        return clip(f"{_OPEN}; {first}, {said}")
    return _OPEN


def _find_degree(left: sp.Expr, right: sp.Expr, letter: sp.Symbol) -> int | None:
    """Return the degree of the right side in a letter, None if it cannot begin a series."""
    if not right.is_polynomial(letter):
        return None
    degree = int(sp.degree(right, letter)) if right.has(letter) else 0
    is_shorter = not left.is_polynomial(letter) or sp.degree(left, letter) > degree
    return degree if is_shorter and degree <= _MOST_TERMS else None


def _find_order(
    difference: sp.Expr, letter: sp.Symbol, degree: int, domain: Domain
) -> Iterator[tuple[int, sp.Expr]]:
    """Yield the order and the factor of the first term of a difference, if they are shown."""
    is_one_sided = domain.set_of(letter).is_subset(sp.Interval(0, sp.oo))
    for order in range(degree + _FARTHEST + 1):
        limit = sp.Limit(difference / letter**order, letter, 0, "+" if is_one_sided else "+-")
        factor = settle_limits(limit, domain)
        if factor.has(sp.Limit) or not factor.is_finite:
            return
        if not decide_equal(factor, sp.S.Zero, domain):
            yield order, factor
            return
