"""Fits: in, a plan and a function in balls; out, polynomials with doubles for coefficients.

Coefficients are rounded one by one; Brisebarre and Chevillard (2007) look for the best ones among
doubles. The enclosure says what that costs.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from flint import arb

from mechproof.arithmetic.approximation import BITS, interpolate
from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import working
from mechproof.programs.elementary.formats import DOUBLE, take_middle
from mechproof.tailoring.design import Plan
from mechproof.tailoring.model import Piece, Pieces

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
        pieces = [_fit_piece(exact, centre, reach, powers) for centre, reach in spans]
    return Pieces(plan.edges[1:-1], tuple(pieces), plan.odd, plan.mirrored)


def _fit_piece(exact: Exact, centre: float, reach: Ball, powers: range) -> Piece:
    """Fit a polynomial about a centre."""
    found = interpolate(lambda x: exact(centre + x), arb(0), reach, powers)
    rounded = (0.0 if c.contains(0) else DOUBLE.round(take_middle(c)) for c in found)
    return Piece(centre, tuple(rounded))
