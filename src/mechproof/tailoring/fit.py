"""Fits: in, a plan and a function in balls; out, polynomials with doubles for coefficients.

Interpolation at Chebyshev nodes, as for the elementary functions: within a small factor of the
best approximation of its degree.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import mpmath as mp
from flint import arb, arb_mat

from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import working
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.tailoring.design import Plan
from mechproof.tailoring.model import Piece, Pieces

# Of numbers near each other, in powers up to a hundred: what is lost is far less.
BITS = 600
Exact = Callable[[Ball], Ball]


def fit(plan: Plan, exact: Exact) -> Pieces:
    """Fit every piece of a plan."""
    with working(1, BITS):
        if plan.odd:
            end = plan.edges[-1]
            reaches = [plan.edges[1], end - plan.edges[1]][: plan.count]
            pieces = [
                _fit_odd(exact, centre, reach, plan.terms)
                for centre, reach in zip((0.0, end), reaches, strict=False)
            ]
        else:
            pieces = [
                _fit_whole(exact, low, high, plan.terms) for low, high in pairwise(plan.edges)
            ]
    return Pieces(plan.edges[1:-1], tuple(pieces), plan.odd, plan.mirrored)


def _fit_odd(exact: Exact, centre: float, reach: float, terms: int) -> Piece:
    """Interpolate by odd powers about a centre."""
    nodes = [_node(2 * i + 1, 4 * terms) for i in range(terms)]
    rows = [[x ** (2 * j + 1) for j in range(terms)] for x in nodes]
    found = _solve(rows, [exact(centre + reach * x) for x in nodes])
    return Piece(centre, tuple(_round(c / arb(reach) ** (2 * j + 1)) for j, c in enumerate(found)))


def _fit_whole(exact: Exact, low: float, high: float, terms: int) -> Piece:
    """Interpolate by all powers about the middle."""
    centre = low + (high - low) / 2
    reach = (arb(high) - low) / 2
    nodes = [_node(2 * i + 1, 2 * terms) for i in range(terms)]
    rows = [[x**j for j in range(terms)] for x in nodes]
    found = _solve(rows, [exact(centre + reach * x) for x in nodes])
    return Piece(centre, tuple(_round(c / reach**j) for j, c in enumerate(found)))


def _node(above: int, below: int) -> Ball:
    return (arb.pi() * above / below).cos()


def _solve(rows: list[list[Ball]], values: list[Ball]) -> list[Ball]:
    solution = arb_mat(rows).solve(arb_mat([[value] for value in values]))
    return [solution[i, 0] for i in range(len(values))]


def _round(number: Ball) -> float:
    """Return the double next to a number."""
    if number.contains(0):
        return 0.0
    with mp.workprec(BITS):
        return DOUBLE.round(mp.mpf(number.mid().str(BITS // 4, radius=False)))
