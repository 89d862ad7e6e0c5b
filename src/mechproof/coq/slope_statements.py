"""Statements of derivatives, which Coq computes again.

A row may compare derivatives with the same formula on both sides, as SymPy has differentiated both.
Then it remains to be proved that the formula is the derivative.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from mechproof.record import Differentiated
from mechproof.record.parts import find_free, find_roots, list_parts
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare

# The functions that Coq can differentiate; a tangent is written out.
_DIFFERENTIATED = (sp.Add, sp.Mul, sp.sin, sp.cos, sp.tan, sp.atan, sp.exp, sp.log)


def states_slope(conclusion: sp.Basic) -> bool:
    """Return whether a conclusion states the derivative of a function."""
    return isinstance(conclusion, sp.Eq) and isinstance(conclusion.lhs, sp.Derivative)


def differentiate_alike(
    relations: Sequence[sp.Basic], differentiated: Differentiated | None, domain: Domain
) -> Iterator[sp.Basic]:
    """Yield the relations; one with equal sides is replaced by a statement of the derivative."""
    if differentiated is None:
        yield from relations
        return
    whole = prepare(domain.resolve(differentiated.expression))
    for relation, letter in zip(relations, differentiated.by, strict=True):
        if _can_be_stated(relation, whole, letter, domain):
            derivative = sp.Derivative(whole, letter, evaluate=False)
            yield sp.Eq(derivative, relation.rhs, evaluate=False)
        else:
            yield relation


def _can_be_stated(relation: sp.Basic, whole: sp.Basic, letter: sp.Symbol, domain: Domain) -> bool:
    """Return whether the sides are equal and the letter is free in a differentiable expression."""
    is_free = letter in find_free(whole) and domain.resolve(letter) == letter
    if relation.lhs != relation.rhs or not is_free:
        return False
    return all(map(_is_smooth, list_parts(whole))) and not _has_nested_roots(whole, letter)


def _has_nested_roots(whole: sp.Basic, letter: sp.Symbol) -> bool:
    """Return whether a letter is under nested roots, which no tactic compares in time."""
    return any(
        letter in find_free(inner) for root in find_roots(whole) for inner in find_roots(root.base)
    )


def _is_smooth(part: sp.Basic) -> bool:
    if isinstance(part, sp.Pow):
        return bool(part.exp.is_Rational and part.exp.q <= 2)
    return isinstance(part, _DIFFERENTIATED) or part.is_Symbol or part.is_number
