"""The arc integral of the bivariate normal mass: a log-concave decay on one Gauss panel."""

from __future__ import annotations

from functools import cache

import numpy as np

from mechproof.conformity_windows import Array

DROP = 34.0  # nats; by log-concavity a part exp(-34) = 2e-15 of the integral is cut off
BLOCK = 512  # corners at a time: nodes stay in the cache

# Lengths of panels in log(tan(x/2)), from below the shortest whose integral does not underflow to
# beyond the longest, `DROP`; Gauss nodes that integrate panels up to a length to rounding.
LENGTHS = 0.02 * 1.12 ** np.arange(68)
NODE_COUNTS = ((1.0, 22), (2.6, 26), (3.5, 30), (5.0, 36), (8.0, 44), (np.inf, 80))


@cache
def _panel(size: int) -> tuple[Array, Array, Array]:
    """Of the panel LENGTHS[size] in log(u): exponents of p and q, (1, u**2), weights times u."""
    length = LENGTHS[size]
    count = next(count for longest, count in NODE_COUNTS if length <= longest)
    nodes, weights = np.polynomial.legendre.leggauss(count)
    x = 0.5 * length * (nodes - 1)
    exponents = -np.expm1([-2 * x, 2 * x])
    return exponents, np.stack([np.ones(count), np.exp(2 * x)]), 0.5 * length * weights * np.exp(x)


def integrate_arc(p: Array, q: Array, one: Array, square: Array) -> Array:
    """1/(2 pi) times the integral over log(u) < 0 of the arc's integrand, 1 at u = 1.

    exp(p (1 - u**-2) + q (1 - u**2)) u (one + square) / (one + square u**2); it is cut where the
    exponential has fallen by `DROP`.
    """
    with np.errstate(divide="ignore", over="ignore"):
        ahead = q - p + DROP
        fall = (ahead + np.sqrt(ahead * ahead + 4 * p * DROP)) / (2 * p)
    sizes = np.searchsorted(LENGTHS, np.minimum(0.5 * np.log1p(fall), DROP))
    exponent_factors, denominator_factors = np.stack([p, q], axis=1), np.stack([one, square], 1)
    result = np.empty_like(p)
    for size in np.unique(sizes):
        exponents, powers, weights = _panel(size)
        rows = np.flatnonzero(sizes == size)
        for start in range(0, rows.size, BLOCK):
            row = rows[start : start + BLOCK]
            values = exponent_factors[row] @ exponents
            np.exp(values, out=values)
            values /= denominator_factors[row] @ powers
            result[row] = values @ weights
    return result * (one + square) / (2 * np.pi)
