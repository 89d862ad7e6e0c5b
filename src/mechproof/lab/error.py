"""Errors of a result against the truth: ulps, bits, wrong branches, NaN and infinity.

Bits are a logarithm of the error, as in Herbie (Panchekha et al. 2015), which counts the doubles
between; here ulps of the truth are counted, for most doubles lie near zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mechproof.lab.oracle import Truth
from mechproof.lab.ways import Array
from mechproof.measured import SetErrors

# A lost value loses every bit of a double.
ALL_BITS = 64.0
EPS = float(np.finfo(float).eps)
# The errors of a summary where no point is decided.
NOTHING = (np.nan, np.nan, np.nan, np.nan, np.nan)


@dataclass(frozen=True)
class Errors:
    """Errors point by point, shape (points,).

    absolute: |result - exact|, the norm of it for a vector, the largest entry of a matrix.
    ulp: in units in the last place of the exact value (of the vector's norm, of the matrix's
    largest entry). scaled: in eps times the scale of the accuracy bound; without one, as ulp.
    Undecided points are NaN in all three; where the result is NaN or infinite and the truth is
    not, all three are infinite.
    """

    absolute: Array
    ulp: Array
    scaled: Array
    result: Array

    @property
    def bits(self) -> Array:
        """Return log2(1 + ulps), at most 64: a lost value loses all bits."""
        bits: Array = np.minimum(np.log2(1 + self.ulp), ALL_BITS)
        return bits


def find_errors(result: Any, truth: Truth) -> Errors:
    """Compare a result with the truth.

    Raises ValueError if their shapes differ.
    """
    result = np.asarray(result)
    if result.shape != truth.high.shape:
        raise ValueError(f"result: shape {result.shape}, the truth has {truth.high.shape}")
    with np.errstate(all="ignore"):
        # The first difference is exact where the result is within a factor 2 of the truth
        # (Sterbenz 1974), so that no error of a few ulps is blurred.
        gap = (result.astype(np.float64) - truth.high) - truth.low
        absolute, size = _measure_size(gap), _measure_size(truth.high)
        # At most one subnormal spacing is lost to the range of doubles, not to the formula.
        visible = np.where(absolute <= np.finfo(float).smallest_subnormal, 0.0, absolute)
        ulp = visible / np.spacing(size)
        scaled = ulp if truth.scale is None else _scale(visible, truth.scale)
    lost = ~np.isfinite(_measure_size(result.astype(np.float64)))
    lost_all = (np.where(lost, np.inf, e) for e in (absolute, ulp, scaled))
    absolute, ulp, scaled = (np.where(truth.decided, e, np.nan) for e in lost_all)
    return Errors(absolute, ulp, scaled, result)


def _scale(visible: Array, scale: Array) -> Array:
    """Return errors in eps of the scale; one whose scale is undecided must not pass: infinite."""
    scaled = np.where(visible == 0, 0.0, visible / (EPS * scale))
    return np.where((visible > 0) & np.isnan(scale), np.inf, scaled)


def _measure_size(values: Array) -> Array:
    """Return |x|, the norm of a vector, the largest entry of a matrix; one number per point."""
    if values.ndim == 1:
        return np.abs(values)
    if values.ndim == 2:
        largest = np.max(np.abs(values), axis=1, initial=0)
        scale = np.where(largest > 0, largest, 1.0)
        size: Array = largest * np.sqrt(np.sum((values / scale[:, None]) ** 2, axis=1))
        return size
    matrix: Array = np.max(np.abs(values), axis=(1, 2))
    return matrix


def count_wrong_branches(errors: Errors, period: float | None) -> int:
    """Count finite results that are nearer to another branch than to the right one."""
    if period is None:
        return 0
    finite = np.isfinite(errors.absolute)
    return int(np.sum(np.abs(errors.absolute[finite]) > period / 2))


def summarise(
    errors: Errors, truth: Truth, period: float | None = None, name: str = "", way: str = ""
) -> SetErrors:
    """Count the errors of one way on one point set, and find the largest, wherever they are."""
    decided = truth.decided
    if not decided.any():
        return SetErrors(name, way, len(decided), truth.undecided, 0, 0, 0, *NOTHING)
    flat = errors.result.reshape(len(decided), -1)[decided]
    return SetErrors(
        set=name,
        way=way,
        points=len(decided),
        undecided=truth.undecided,
        nan=int(np.isnan(flat).any(axis=1).sum()),
        infinite=int(np.isinf(flat).any(axis=1).sum()),
        wrong_branch=count_wrong_branches(errors, period),
        worst_ulp=float(np.max(errors.ulp[decided])),
        mean_ulp=float(np.mean(errors.ulp[decided])),
        mean_bits=float(np.mean(errors.bits[decided])),
        worst_absolute=float(np.max(errors.absolute[decided])),
        worst_scaled=float(np.max(errors.scaled[decided])),
    )
