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
            spans = [(c, arb(reach)) for c, reach in zip((0.0, end), reaches, strict=False)]
            powers = range(1, 2 * plan.terms, 2)
        else:
            pairs = pairwise(plan.edges)
            spans = [(low + (high - low) / 2, (arb(high) - low) / 2) for low, high in pairs]
            powers = range(plan.terms)
        pieces = [_interpolate(exact, centre, reach, powers) for centre, reach in spans]
    return Pieces(plan.edges[1:-1], tuple(pieces), plan.odd, plan.mirrored)


def _interpolate(exact: Exact, centre: float, reach: Ball, powers: range) -> Piece:
    """Interpolate by powers about a centre at Chebyshev nodes, by odd ones at the positive nodes.

    The largest error is then within a small factor of that of the best polynomial (Trefethen 2013,
    chapter 15), and nothing has to be exchanged; the enclosure bounds what it really is.
    """
    count = len(powers)
    nodes = [(arb.pi() * (2 * i + 1) / (2 * count * powers.step)).cos() for i in range(count)]
    rows = [[x**power for power in powers] for x in nodes]
    found = _solve(rows, [exact(centre + reach * x) for x in nodes])
    scaled = (c / reach**power for power, c in zip(powers, found, strict=True))
    return Piece(centre, tuple(map(_round, scaled)))


def _solve(rows: list[list[Ball]], values: list[Ball]) -> list[Ball]:
    solution = arb_mat(rows).solve(arb_mat([[value] for value in values]))
    return [solution[i, 0] for i in range(len(values))]


def _round(number: Ball) -> float:
    """Return the double next to a number."""
    if number.contains(0):
        return 0.0
    with mp.workprec(BITS):
        return DOUBLE.round(mp.mpf(number.mid().str(BITS // 4, radius=False)))
