"""Calculations beside numbers, and beside one another: between what those lie that are rounded.

Of decimals those are exact that the block says to be sizes. What is exactly what an exact
calculation before it gives is exact, too.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.numbers.calculated_sizes import find_span
from mechproof.document.roles import Sign
from mechproof.latex.measures import is_number
from mechproof.latex.reader import Print
from mechproof.latex.tree import Calculated, Chain, Node

_SLOW = (sp.Integral, sp.Sum, sp.Product, sp.Limit)
Span = tuple[float, float] | None


def add_calculations(
    read: Print, chain: Chain, signs: Sequence[Sign], exact: Collection[sp.Expr]
) -> list[Sign]:
    """Return the signs of a chain, those beside calculations with their spans and formulas."""
    spans = [*_find_spans(read, chain, signs, exact)]
    beside = zip(signs, [None, *signs[:-1]], pairwise(chain.members), pairwise(spans), strict=True)
    return [_add_calculation(*one) for one in beside]


def _find_spans(
    read: Print, chain: Chain, signs: Sequence[Sign], exact: Collection[sp.Expr]
) -> Iterator[Span]:
    last: Span = None
    # A sign that defines a letter has no sides, the one behind it has.
    left = [*(sign.sides[0] for sign in signs), None]
    right = [None, *(sign.sides[1] for sign in signs)]
    sides = [one if other is None else other for one, other in zip(left, right, strict=True)]
    for node, side, other in zip(chain.members, sides, [None, *sides[:-1]], strict=True):
        is_same = _is_calculated(side) and _is_calculated(other)
        is_same = is_same and balls.evaluate(side - other, {}).contains(0)
        if not (is_same and last is None):
            last = find_span(read, node, exact) if _is_calculated(side) else None
        yield last


def _is_calculated(side: Any) -> bool:
    """Return whether a side is a number that is worked out at once."""
    if not isinstance(side, sp.Expr) or side.is_Matrix or side.free_symbols or side.has(*_SLOW):
        return False
    with suppress(NotImplementedError):
        return bool(balls.evaluate(side, {}).is_finite())
    return False


def _add_calculation(
    sign: Sign, before: Sign | None, nodes: tuple[Node, ...], spans: tuple[Span, Span]
) -> Sign:
    """Return a sign beside a calculation, with the formula before it, and the span."""
    if not sign.number and all(map(_is_calculated, sign.sides)):
        units = {node.unit if isinstance(node, Calculated) else "" for node in nodes}
        span = _subtract(sign.sides, spans)
        return replace(sign, span=span, is_calculated=True) if len(units) == 1 else sign
    if not (sign.number and isinstance(sign.value, sp.Expr)) or sign.value.free_symbols:
        return sign
    place = int(sign.sides[0] is not sign.value)
    if is_number(nodes[place]) and not isinstance(nodes[place], Calculated):
        return sign
    first = before and (before.letter if before.sides[0] is None else before.sides[0])
    has_letters = isinstance(first, sp.Expr) and first.free_symbols
    formula = first if has_letters else None
    return replace(sign, formula=formula, span=spans[place], is_calculated=True)


def _subtract(sides: tuple[sp.Expr, sp.Expr], spans: tuple[Span, Span]) -> Span:
    values = [float(sp.N(side)) if side.is_real else 0.0 for side in sides]
    (low, high), (least, most) = (
        span or (value, value) for span, value in zip(spans, values, strict=True)
    )
    return low - most, high - least
