"""Sums of errors: laws scaled by an influence, and exact shares for the sum of errors."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

import numpy as np

from mechproof.conformity import Shares, shares
from mechproof.conformity.risks import Limits
from mechproof.laws import Law, Normal, TruncatedNormal, Uniform
from mechproof.laws.kinds import list_parameters, move
from mechproof.laws.windows import Array

# Absolute tolerance of the adaptive quadrature over errors that are not normal.
ABSOLUTE = 1e-8


def scale_law(law: Law, factor: float) -> Law:
    """Return the law of `factor` times the value, `factor` not 0."""
    if isinstance(law, Normal):
        return Normal(law.mean * factor, law.std * abs(factor))
    ends = (law.lower, law.upper) if factor > 0 else (law.upper, law.lower)
    low, high = (end * factor for end in ends)
    if isinstance(law, Uniform):
        return Uniform(low, high)
    return TruncatedNormal(law.mean * factor, law.std * abs(factor), low, high)


def exact_shares(
    true: Law, errors: Sequence[Law], tolerance: Limits, acceptance: Limits | None = None
) -> Shares:
    """Return the shares for a measurement error that is the sum of independent errors.

    Normal errors are added in closed form. One law is kept whole (the sum of the normal ones, or
    else the widest); an adaptive quadrature averages the shares over the values of the others.

    Accuracy held by the tests: that of `conformity.shares` for normal errors or a single one,
    otherwise an absolute 1e-8, if no error is centred further than a million of its widths from 0.
    Raises ArithmeticError if the quadrature does not converge.
    """
    normal = add_normals([law for law in errors if isinstance(law, Normal)])
    others = sorted((e for e in errors if not isinstance(e, Normal)), key=_width)
    whole: Law = normal
    if others and not np.any(normal.std):
        whole = move(others.pop(), normal.mean)
    if not others:
        return shares(true, whole, tolerance, acceptance)
    return _average(true, whole, others, tolerance, acceptance)


def add_normals(laws: Sequence[Normal]) -> Normal:
    """Return the law of the sum of independent normal values."""
    mean = sum((np.asarray(law.mean) for law in laws), np.zeros(()))
    return Normal(mean, reduce(np.hypot, (law.std for law in laws), np.zeros(())))


def _width(law: Law) -> float:
    knots = law.knots()
    return float(np.max(knots[..., -1] - knots[..., 0]))


def _average(
    true: Law, whole: Law, others: Sequence[Law], tolerance: Limits, acceptance: Limits | None
) -> Shares:
    """Integrate the shares given the values of `others` over the unit cube of their supports."""
    from scipy.integrate import cubature

    supports = [(law.knots()[..., 0], law.knots()[..., -1]) for law in others]
    inputs = [p for law in (true, whole, *others) for p in list_parameters(law)]
    limits = [*tolerance, *(acceptance or ())]
    axes = len(np.broadcast_shapes(*(np.shape(p) for p in (*inputs, *limits))))

    def average_at(points: Array) -> Array:
        shift, weight = np.zeros(()), np.ones(())
        for law, (low, high), u in zip(others, supports, points.T, strict=True):
            value = low + (high - low) * u.reshape(-1, *(1,) * axes)
            shift, weight = shift + value, weight * (high - low) * law.pdf(value)
        four = shares(true, move(whole, shift), tolerance, acceptance)
        values: Array = weight[..., None] * np.stack(list(vars(four).values()), axis=-1)
        return values

    cube = np.zeros(len(others)), np.ones(len(others))
    found = cubature(average_at, *cube, rtol=0.0, atol=ABSOLUTE)
    if found.status != "converged":
        raise ArithmeticError(f"the shares of {others!r} did not converge to {ABSOLUTE}")
    return Shares(*(share[()] for share in np.moveaxis(found.estimate, -1, 0)))
