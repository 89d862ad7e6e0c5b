"""An angle's derivatives by time, of samples or of a function."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import require

Floats = NDArray[np.float64]

DEGREE = 5
# Polynomials through values at 13 Chebyshev points of windows of these half widths (s).
POINTS = 13
WIDTHS = tuple(2.0**power for power in range(5, -21, -1))
FOUND = 1e-6
# Times whose windows are kept at once.
BLOCK = 4096
EPS = float(np.finfo(float).eps)


def interpolate(phi1: ArrayLike, t: Floats) -> Floats:
    """Return samples and their first three derivatives, by a spline of the fifth degree."""
    from scipy.interpolate import make_interp_spline

    angles = check_array("phi1", phi1)
    require(t.ndim == 1 and t.size > DEGREE, "t", t, f"must be {DEGREE + 1} or more in a row")
    require(angles.shape == t.shape, "phi1", angles, f"must be as many as the times, {t.size}")
    require(np.isfinite(angles).all(), "phi1", angles, "must be finite")
    require((np.diff(t) > 0).all() and np.isfinite(t).all(), "t", t, "must be finite and rise")
    spline = make_interp_spline(t, angles, k=DEGREE)
    return np.array([angles, *(spline(t, order) for order in (1, 2, 3))])


def differentiate(phi1: Callable[[Floats], ArrayLike], t: Floats) -> Floats:
    """Return values of a function and its first three derivatives, NaN where there are none."""
    values = _call(phi1, t)
    flat = t.ravel()
    blocks = [flat[start : start + BLOCK] for start in range(0, flat.size, BLOCK)]
    found = [_search(phi1, block) for block in blocks]
    derivatives, errors = (
        np.concatenate([pair[part] for pair in found], axis=1) if found else np.empty((3, 0))
        for part in (0, 1)
    )
    size = np.abs(derivatives, where=np.isfinite(derivatives), out=np.zeros_like(derivatives))
    allowed = FOUND * np.maximum(size.max(axis=1, keepdims=True, initial=0.0), 1.0)
    derivatives[~(errors <= allowed)] = np.nan
    return np.concatenate([values[None], derivatives.reshape(3, *t.shape)])


def _call(phi1: Callable[[Floats], ArrayLike], t: Floats) -> Floats:
    with np.errstate(invalid="ignore", divide="ignore"):
        values = check_array("phi1(t)", phi1(t))
    require(values.shape == t.shape, "phi1(t)", values, f"must have the shape {t.shape} of t")
    return values


def _search(phi1: Callable[[Floats], ArrayLike], t: Floats) -> tuple[Floats, Floats]:
    """Return derivatives of the three orders and the least estimate of their errors.

    What is not seen of a function is as large as the last two coefficients of its polynomial, and
    so are their derivatives, by as many powers of the degree; besides there are roundings.
    """
    nodes, last, weights = _weights()
    best, least = np.full((3, t.size), np.nan), np.full((3, t.size), np.inf)
    orders = np.arange(1, 4)[:, None]
    rounded = EPS * np.abs(weights).sum(axis=1, keepdims=True)
    for width in WIDTHS:
        values = _call(phi1, t[:, None] + width * nodes).T
        unseen = np.abs(last @ values).sum(axis=0) * float(POINTS - 1) ** orders
        error = (unseen + rounded * np.abs(values).max(axis=0)) / width**orders
        better = error < least
        best = np.where(better, (weights @ values) / width**orders, best)
        least = np.where(better, error, least)
    return best, least


@cache
def _weights() -> tuple[Floats, Floats, Floats]:
    """Return nodes, and the weights of values there in the last coefficients and derivatives."""
    nodes = chebyshev.chebpts1(POINTS)
    coefficients = np.linalg.inv(chebyshev.chebvander(nodes, POINTS - 1))
    at_zero = [
        [chebyshev.chebval(0.0, chebyshev.chebder(row, order)) for row in np.eye(POINTS)]
        for order in (1, 2, 3)
    ]
    found = nodes, coefficients[-2:], np.array(at_zero) @ coefficients
    nodes, last, weights = (np.asarray(part, np.float64) for part in found)
    return nodes, last, weights
