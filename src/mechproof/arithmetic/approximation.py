"""Approximation: in, a function in balls; out, the quotient of polynomials that meets it at nodes.

What it is off by is a Taylor polynomial about the middle of an interval, with its last term over
the whole of it.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, arb_mat, arb_series

from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import list_terms
from mechproof.arithmetic.series_rules import Series

# Of numbers near each other, in powers up to a hundred: what is lost is far less.
BITS = 600


def interpolate(
    function: Callable[[Ball], Ball],
    centre: Ball,
    reach: Ball,
    powers: range,
    below: range = range(0),
) -> list[Ball]:
    """Return coefficients of powers, then of those in a denominator beside a 1.

    The nodes are Chebyshev's of the interval, of odd powers the positive ones. The largest error
    is then within a small factor of that of the best quotient (Trefethen 2013, chapter 15), which
    the exchange of Remez (1934) would find. The working precision is to be `BITS`.
    """
    count = len(powers) + len(below)
    angles = (arb.pi() * (2 * i + 1) / (2 * count * powers.step) for i in range(count))
    nodes = [centre + reach * angle.cos() for angle in angles]
    values = [function(node) for node in nodes]
    rows = [
        [z**power for power in powers] + [-value * z**power for power in below]
        for z, value in zip(nodes, values, strict=True)
    ]
    solution = arb_mat(rows).solve(arb_mat([[value] for value in values]))
    return [solution[i, 0] for i in range(count)]


def expand_about(middle: Ball, reach: Ball) -> tuple[Series, Series]:
    """Return the variable as series in shares of a reach: about a middle, and over all within."""
    return arb_series([middle, reach]), arb_series([arb(middle, reach.upper()), reach])


def bound_terms(near: Series, far: Series) -> list[Ball]:
    """Bound the terms of what was computed of both: the last holds over the interval."""
    return [*map(abs, list_terms(near)[:-1]), abs(list_terms(far)[-1])]
