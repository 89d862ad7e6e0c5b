"""Spreading: errors as shares of the terms of a sum, of which each term answers for its own.

Errors a1, a2, ... of which some are at most shares of one term and others of another add up, over
the sum of the terms, to the largest total that a term has, whatever the terms are beside each
other. So where terms vanish together, no quotient of theirs is needed. It is a backward error
(Higham 2002, chapter 1): every rounding is a change of one term.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from mechproof.arithmetic.intervals import EPS, Array, Ends
from mechproof.roundoff.rounded_steps import take_least

# An error is put to a term where it is no larger a share of it than so many times that of the sum.
HARDLY_MORE = (1.25, 2.0, 4.0, np.inf)


def spread(errors: Sequence[Sequence[Ends]], terms: int) -> Ends:
    """Bound a sum of errors, each told as shares of what is at most the sum, its terms last."""
    of_sum = [take_least(*shares) for shares in errors]
    totals = [sum(of_sum, np.float64(0.0))]
    if terms > 1:
        # Some are the same in all boxes.
        shape = np.broadcast_shapes(*(np.shape(s) for shares in errors for s in shares[-terms:]))
        of_terms = [
            np.array([np.broadcast_to(share, shape) for share in shares[-terms:]])
            for shares in errors
        ]
        totals += [_share_out(of_sum, of_terms, factor) for factor in HARDLY_MORE]
    return take_least(*totals)


def _share_out(of_sum: Sequence[Ends], of_terms: Sequence[Array], factor: float) -> Ends:
    """Put each error to the terms that have least to answer for, so that they have as much."""
    loads = np.zeros_like(of_terms[0])
    rest: Ends = np.float64(0.0)
    for whole, shares in zip(of_sum, of_terms, strict=True):
        least = shares.min(axis=0)
        # What is a share of no term stays with the whole, of which it may have no bound.
        is_put = (whole > 0) & np.isfinite(least) & (least <= factor * whole)
        rest = rest + np.where(is_put, 0.0, whole)
        levels = np.where(np.isfinite(shares), _fill(loads, shares), 0.0)
        loads = np.where(is_put, np.maximum(loads, levels), loads)
    return rest + loads.max(axis=0)


def _fill(loads: Array, shares: Array) -> Array:
    """Return the level to which an error fills some terms, of each of which it is such a share."""
    order = np.argsort(loads, axis=0)
    with np.errstate(divide="ignore"):
        sizes = 1 / np.take_along_axis(shares, order, axis=0)
    # The lowest terms take all of it: how many are filled is where the level is lowest.
    before = np.cumsum(np.take_along_axis(loads, order, axis=0) * sizes, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = (1 + before) / np.cumsum(sizes, axis=0) * (1 + 8 * EPS * len(loads))
    level: Array = np.fmin.reduce(found, axis=0)
    return level
