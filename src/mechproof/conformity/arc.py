"""The arc integral of the bivariate normal mass: a log-concave decay on one Gauss panel."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from mechproof.laws.windows import Array

DROP = 32.0  # nats; by log-concavity a part exp(-32) = 1.3e-14 of the integral is cut off
BLOCK = 512  # corners at a time: nodes stay in the cache

# Panel lengths in log(1/u), from below the shortest whose integral does not underflow to beyond the
# longest, `DROP`; a decay by `DROP` over a panel is one by two thirds of it over the one before.
# Counts of Gauss nodes that, up to a length, integrate every decay filling a panel to 1e-13.
GROWTH, STEP = 1.25, 0.2
SHORT = 0.02 * GROWTH ** np.arange(17)
LENGTHS = np.concatenate([SHORT, np.arange(SHORT[-1] + STEP, DROP + STEP, STEP)])
GROWTHS = np.expm1(2 * LENGTHS)
NODE_COUNTS = ((1.25, 16), (2.0, 14), (3.0, 16), (4.0, 19), (5.0, 22), (7.0, 36), (np.inf, 80))
LONG = 7.0  # beyond, the weight u alone decays over most of the panel
PARTS, ORDER = 16, 40  # of the panels on which the weights of a Gauss rule are integrated


@cache
def make_panel(size: int) -> tuple[Array, Array, Array]:
    """Return exponents of p and q, (1, u**2), weights times u on LENGTHS[size] in log(u)."""
    length = LENGTHS[size]
    count = next(count for longest, count in NODE_COUNTS if length <= longest)
    y, weights = _find_rule(length, count) if length <= LONG else _scale_rule(length, count)
    exponents = -np.expm1([2 * y, -2 * y])
    return exponents, np.stack([np.ones(count), np.exp(-2 * y)]), weights * np.exp(-y)


def _scale_rule(length: float, count: int) -> tuple[Array, Array]:
    nodes, weights = _find_legendre(count)
    return 0.5 * length * (1 + nodes), 0.5 * length * weights


@cache
def _find_legendre(count: int) -> tuple[Array, Array]:
    return np.polynomial.legendre.leggauss(count)


def _find_rule(length: float, count: int) -> tuple[Array, Array]:
    """Return Gauss nodes for smooth functions times a typical decay on (0, length).

    The decay is halfway between those that fill the panel: with p = q and with q = 0. The weights
    are divided by it.
    """
    nodes, weights = _scale_rule(length / PARTS, ORDER)
    y = (np.arange(PARTS)[:, None] * length / PARTS + nodes).ravel()
    start = np.tile(weights, PARTS) * np.exp(-_fall_typically(y, length))
    found, masses = _find_gauss(y, start, count)
    return found, masses * np.exp(_fall_typically(found, length))


def _fall_typically(y: Array, length: float) -> Array:
    quick, slow = np.sinh(y) / np.sinh(length), np.sinh(2 * y) / np.sinh(2 * length)
    fall: Array = 0.5 * DROP * (quick**2 + slow)
    return fall


def _find_gauss(x: Array, masses: Array, count: int) -> tuple[Array, Array]:
    """Return nodes and weights of the Gauss rule for point masses, by their recurrence."""
    before, current = np.zeros_like(x), np.full_like(x, 1 / np.sqrt(np.sum(masses)))
    middle, beside = np.zeros(count), np.zeros(count)
    for k in range(count):
        middle[k] = np.sum(masses * x * current**2)
        rest = (x - middle[k]) * current - (beside[k - 1] * before if k else 0)
        beside[k] = np.sqrt(np.sum(masses * rest**2))
        before, current = current, rest / beside[k]
    jacobi = np.diag(middle) + np.diag(beside[:-1], 1) + np.diag(beside[:-1], -1)
    found, vectors = np.linalg.eigh(jacobi)
    return found, np.sum(masses) * vectors[0] ** 2


def choose_size(p: Any, q: Any) -> Any:
    """Choose for every integrand the shortest panel on which it falls by `DROP`."""
    ahead = q - p + DROP
    growth = (ahead + np.sqrt(ahead * ahead + 4 * DROP * p)) / (2 * p)
    return np.minimum(np.searchsorted(GROWTHS, growth), len(GROWTHS) - 1)


def integrate_arc(p: Array, q: Array, one: Array, square: Array) -> Array:
    """Return 1/(2 pi) times the integral over log(u) < 0 of the arc's integrand, 1 at u = 1.

    exp(p (1 - u**-2) + q (1 - u**2)) u (one + square) / (one + square u**2); it is cut where the
    exponential has fallen by `DROP`.
    """
    sizes = choose_size(p, q)
    order = np.argsort(sizes, kind="stable")
    exponents, powers = np.stack([p, q], axis=1)[order], np.stack([one, square], axis=1)[order]
    values, start = np.empty_like(p), 0
    for size, end in enumerate(np.cumsum(np.bincount(sizes)).tolist()):
        for row in range(start, end, BLOCK):
            rows = slice(row, min(row + BLOCK, end))
            values[rows] = _apply_panel(exponents[rows], powers[rows], *make_panel(size))
        start = end
    result = np.empty_like(p)
    result[order] = values
    return result * (one + square) / (2 * np.pi)


def _apply_panel(
    factors: Array, weights_of_powers: Array, exponents: Array, powers: Array, weights: Array
) -> Array:
    values = factors @ exponents
    np.exp(values, out=values)
    values /= weights_of_powers @ powers
    summed: Array = values @ weights
    return summed
